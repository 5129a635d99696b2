"""Values to four figures, once they are on paper: of whole degrees, and of roots of sums.

Exactly ``v = (61/76) cos 35° − (319/190) sin 25°`` is long, and stands once, with ``≈ −0.05208``
behind it; where it comes again, its figures are printed. Sums with roots of sums of roots have
figures everywhere but where the root of an equation is told. Beside angles such as 37° there is a
calculator: what is only worked out is a number at once. What the lines say stays exact.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Negate,
    Number,
    Rounded,
    Unit,
    children,
    functions_in,
    has_quantity,
    has_root,
    has_unit_vector,
    is_binary,
    is_function,
    letters,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import swept
from restitution.workings.naming.figure_multiples import (
    is_one_term,
    multiple_of,
    number_and_letters,
)
from restitution.workings.naming.long_sums import sum_in_figures
from restitution.workings.naming.measured import (
    FIGURES_BETWEEN,
    is_measure_of_angle,
    number_carried,
    rounded,
    scalar_worth,
    worth,
)
from restitution.workings.naming.plain_angles import (
    has_ratio_of_a_sum,
    of_plain_angles,
    ratios_of_numbers,
)
from restitution.workings.naming.roots_of_roots import (
    is_long_number,
    is_of_nested_roots,
    is_short_sum_of_a_root,
)
from restitution.workings.naming.sizes import digits_of, size_of, with_sign
from restitution.workings.naming.sums_in_degrees import (
    FIGURES_BEFORE_A_ROUNDING,
    FIGURES_OF_ANSWERS,
    RATIOS,
    angles_in_figures,
    degrees_of,
    is_sum_with_inverse,
)

_FIGURES_OF_COSINES = range(FIGURES_BETWEEN, 9)
# Numbers from here on are none that somebody writes before a ratio.
_LONG = 1000
# A fraction of numbers below this is short.
_SHORT = 10
# A fraction of so many parts is a decimal with an end.
_DECIMALS = 1000
_LONG_PRODUCT = 3  # of so many ratios
_LONG_SUM = 2


class Figures:
    """The sums of ratios of plain angles that are on paper, with their figures."""

    def __init__(
        self,
        with_calculator: bool = False,
        decimals: bool = False,
        finer: Mapping[str, int] | None = None,
        long_numbers: bool = False,
        short_sums: bool = False,
    ) -> None:
        self.with_calculator = with_calculator
        # How many figures the values of these sizes have, where four lead to others in the end.
        self._finer = dict(finer or {})
        #: The same as it comes out while lines are written.
        self.wanted: dict[str, int] = dict(self._finer)
        self._decimals = decimals
        self._long_numbers = long_numbers
        # Whether a short sum with a root stays exact, though there is a calculator: 3 + 2√3.
        self._short_sums = short_sums
        self._known: dict[Expression, Expression] = {}
        # Whether there are sums of roots in values.
        self._sums: dict[Expression, bool] = {}
        # The same by the size of a value: of ratios of plain angles there are many forms.
        self._by_size: dict[str, Expression] = {}
        # Those of which nothing but the figures is on paper.
        self._alone: set[Expression] = set()

    def count(self, tree: Expression) -> int:
        """How many figures a value has on the way: four, or what it takes to lead to others."""
        own = self._finer.get(digits_of(tree)) if self._finer else None
        return own or FIGURES_BETWEEN

    def one_more(self, tree: Expression) -> int:
        """One figure more than that, which the value is to have from where it stands first."""
        more = self.count(tree) + 1
        self.wanted[digits_of(tree)] = more
        return more

    def _figures_of(self, tree: Expression, figures: int = FIGURES_BETWEEN) -> Expression | None:
        return figures_of(tree, max(figures, self.count(tree)))

    def is_of_roots(self, tree: Expression) -> bool:
        """Whether a value as it comes out is a sum of roots that is carried in figures.

        It is one with roots of sums of roots, or the root of one; with a calculator every sum of
        different roots. A sum of products of such values is still to be worked out. Among decimals
        it is a long fraction, and a multiple of the root of a long number, too.
        """
        if self._long_numbers and is_long_number(tree):
            return True
        if not has_root(tree) or (self._short_sums and is_short_sum_of_a_root(tree)):
            return False
        return is_of_nested_roots(tree, self.with_calculator)

    def has_sums_of_roots(self, tree: Expression) -> bool:
        """Whether a value in it is a sum of roots that is carried in figures."""
        if not (has_root(tree) or self._long_numbers):
            return False
        if tree not in self._sums:
            self._sums[tree] = any(map(self.is_of_roots, walk(tree)))
        return self._sums[tree]

    def in_letters(self, tree: Expression) -> Expression | None:
        """A multiple of letters by a number that only a calculator knows, as 0.1351u.

        None of another value, and of one that is short: ½u cos 20°.
        """
        ratios, several = len(ratios_of_numbers(tree)), False
        if ratios:
            is_long = any(map(self._is_long, walk(tree)))
            few, many = (1, _LONG_SUM) if self.with_calculator else (_LONG_SUM, _LONG_PRODUCT)
            several = ratios >= (few if is_long else many)
        several = several or (self.with_calculator and self.has_sums_of_roots(tree))
        parts = number_and_letters(tree) if several else None
        return None if parts is None else multiple_of(*parts)

    def sum_in_letters(self, tree: Expression) -> Expression | None:
        """A sum in letters with coefficients that only a calculator knows: 4.757 − 1.632e.

        None of another value, and of one with a single ratio. It stands for the sum from then.
        """
        several = len({*ratios_of_numbers(tree)}) >= _LONG_SUM and self.with_calculator
        put = sum_in_figures(tree, FIGURES_BETWEEN) if several else None
        if put is not None:
            self.stands_for(tree, put)
        return put

    def is_carried(self, tree: Expression) -> bool:
        """Whether a working goes on with the figures of a value, and not with the value."""
        return self._is_long(tree) or (
            self.with_calculator
            and (
                self._is_number_of_several(tree)
                or self._is_awkward(tree)
                or has_ratio_of_a_sum(tree)
            )
        )

    def note(self, tree: Expression) -> None:
        """Notes that the figures of a value stand behind it now."""
        own = unsigned(tree)
        number = self._figures_of(own) if self.is_carried(own) else self.in_letters(own)
        if number is not None:
            self._known[own] = number
            self._by_size.update(_by_its_size(own, number))

    def stands_for(self, tree: Expression, put: Expression) -> None:
        """Notes that a value stands on paper as an expression of figures, and not exactly."""
        if isinstance(tree, Negate):
            tree, put = tree.operand, swept(Negate(put))
        if self._known.setdefault(tree, put) is put:
            self._alone.add(tree)
        for size, own in _by_its_size(tree, put).items():
            self._by_size.setdefault(size, own)

    def instead_of(self, tree: Expression) -> Expression:
        """The figures of a value that is on paper with them; any other as it is."""
        if isinstance(tree, Negate):
            put = self.instead_of(tree.operand)
            return tree if put == tree.operand else swept(Negate(put))
        own = self._figures_of(tree) if self.is_of_roots(tree) else self._multiple_of_roots(tree)
        if self.with_calculator and tree not in self._known and self._is_of_several(tree):
            own = self._of_size(tree) or own
        return self._known.get(tree, own or tree)

    def _multiple_of_roots(self, tree: Expression) -> Expression | None:
        """The figures of a multiple of letters by a sum of roots: 0.9659u, with a calculator."""
        if not self.with_calculator or not letters(tree) or has_quantity(tree):
            return None
        return self.in_letters(tree) if self.has_sums_of_roots(tree) else None

    def _with_multiples(self, tree: Expression) -> Expression:
        """A tree with figures for the multiples of letters by sums of roots, each as a whole."""
        on_paper = any(node in self._known for node in walk(tree) if node != tree)
        own = self._multiple_of_roots(tree) if is_one_term(tree) and not on_paper else None
        if own is not None:
            return own
        parts = {child: self._with_multiples(child) for child in children(tree)}
        return exchanged(tree, {child: put for child, put in parts.items() if put != child})

    def again(self, tree: Expression, outcome: bool = False, behind: bool = False) -> Expression:
        """A side with its figures, where it is on paper itself; else as `put` has it."""
        known = self.instead_of(tree)
        return self.put(tree, outcome, behind) if known == tree else known

    def cosine(self, tree: Expression) -> Expression:
        """The figures of a cosine that is not written exactly; they stand for it from then.

        There are as many of them as the angle to three figures needs.
        """
        own = unsigned(tree)
        number = next(
            filter(partial(_same_angle, own), (figures_of(own, n) for n in _FIGURES_OF_COSINES)),
            None,
        )
        if number is None:
            return tree
        self._known[own] = number
        self._by_size.update(_by_its_size(own, number))
        return tree if own is tree and number == own else exchanged(tree, {own: number})

    def tangent(self, tree: Expression) -> Expression | None:
        """The figures of a tangent, as many of them as the angle to three figures needs.

        None where letters are left in it.
        """
        value = None if has_quantity(tree) else scalar_worth(tree)
        if value is None or value.free_symbols:
            return None
        numbers = (figures_of(tree, n) for n in _FIGURES_OF_COSINES)
        return next(filter(partial(_same_angle, tree, inverse="arctan"), numbers), None)

    def outcome(self, tree: Expression) -> Expression:
        """A number, or a multiple of letters by one, in figures; any other value as it is.

        An angle has its degrees.
        """
        if is_sum_with_inverse(tree):
            return angles_in_figures(tree)
        if of_plain_angles(tree):
            return self._figures_of(tree) or tree
        parts = number_and_letters(tree)
        if parts is None or parts[0].is_Rational:
            return tree
        return multiple_of(*parts) or tree

    def put(self, tree: Expression, outcome: bool = False, behind: bool = False) -> Expression:
        """A side of a line with figures for the values in it that are on paper.

        An ``outcome`` with roots of sums of roots is one number. So is with a calculator one with
        sums, and any number ``behind`` another side.
        """
        if self._is_plain(tree):
            return tree
        own = unsigned(tree)
        if own in self._known and not (self.with_calculator and own in self._alone):
            return self._multiple_of_roots(tree) or tree
        if self.with_calculator and is_sum_with_inverse(tree):
            return angles_in_figures(tree)
        if self.with_calculator and not outcome:
            tree = _by_degrees(tree)
        if self.with_calculator and not has_quantity(tree) and self.has_sums_of_roots(tree):
            tree = self._with_multiples(tree)
        for figures in FIGURES_BEFORE_A_ROUNDING:
            nested = self._roots_in_figures(tree, figures, outcome, behind)
            more = self._more_figures(tree, figures)
            known = nested.get(tree) or exchanged(
                self._by_value(exchanged(tree, more)), nested | self._known
            )
            put = rebuilt(known, self._arctangent)
            if put == tree or (self.with_calculator and isinstance(unsigned(put), Number)):
                return put
            put = rebuilt(put, _square_of_root)
            if not (nested and _is_quotient_of_numbers(put)):
                put = swept(rebuilt(swept(put), _sign_outside))
            # Figures that lead to others in the end would make the line false.
            if not _differ(tree, put):
                self.wanted.update({digits_of(node): figures for node in more})
                return put
            if not nested and not self.with_calculator:
                return tree
        return tree

    def _is_plain(self, tree: Expression) -> bool:
        """Whether nothing in a tree has figures: it has no functions, and what has figures has."""
        plain = not (functions_in(tree) or self._long_numbers)
        return plain and all(map(functions_in, self._known))

    def rounded_alike(self, tree: Expression) -> Expression | None:
        """A long number with as many figures as it takes to round it; None of a short one."""
        if not self.is_carried(tree) or letters(tree):
            return None
        answer = figures_of(tree, FIGURES_OF_ANSWERS)
        numbers = (figures_of(tree, n) for n in FIGURES_BEFORE_A_ROUNDING)
        return next(
            (own for own in numbers if own and figures_of(own, FIGURES_OF_ANSWERS) == answer), None
        )

    def within(self, tree: Expression) -> Expression:
        """Among long numbers an expression with figures for each value in it; else the tree."""
        if not self._long_numbers:
            return tree
        parts = {
            node: own
            for node in walk(tree)
            if not (node == tree or letters(node))
            # A sum stands in figures where it is on paper with them.
            and (node in self._known or not is_binary(node, "+", "-"))
            and (own := self.instead_of(node)) != node
        }
        put = exchanged(tree, parts)
        return tree if parts and _differ(tree, put) else put

    def _more_figures(self, tree: Expression, figures: int) -> dict[Expression, Expression]:
        """The values in a tree that are on paper, with more figures than they have there."""
        if figures == FIGURES_BETWEEN or not self.with_calculator:
            return {}
        numbers = {
            node: figures_of(node, figures)
            for node in walk(tree)
            if isinstance(unsigned(self.instead_of(node)), Rounded) and not letters(node)
        }
        return {node: number for node, number in numbers.items() if number is not None}

    def _roots_in_figures(
        self, tree: Expression, figures: int, outcome: bool, behind: bool
    ) -> dict[Expression, Expression]:
        """The sums of roots in a tree that are carried, each with its figures."""
        if not (self.with_calculator or self._long_numbers or has_root(tree)):
            return {}
        is_carried = self.is_of_roots
        if outcome and self.with_calculator and not is_measure_of_angle(tree):
            awkward = self._is_awkward(tree)
            is_long = any(map(self._is_long, walk(tree)))
            whole = behind or awkward or is_long
            if whole and letters(tree):
                multiple = self.in_letters(tree)
                if multiple is not None:
                    return {tree: multiple}
            worked = awkward or is_long or self._is_number_of_several(tree)
            worked = worked or (behind and _has_long_numbers(tree))
            if whole and worked and not has_unit_vector(tree):
                number = self._figures_of(tree, figures)
                return {} if number is None else {tree: number}
            is_carried = self._is_long  # every sum of numbers is worked out
        parts = [node for node in walk(tree) if is_carried(node)]
        if self.with_calculator:
            parts += filter(_is_over_a_root, walk(tree))
            # A quotient by itself, as of a tangent, stands with the figures above and below.
            parts += (e for e in walk(tree) if e != unsigned(tree) and _is_over_a_sum(e))
        parts += [
            node.argument
            for node in walk(tree)
            if is_function(node, "arctan") and self.has_sums_of_roots(node)
        ]
        if outcome and self.has_sums_of_roots(tree) and not has_quantity(tree):
            parts.append(tree)
        values = {part: self._figures_of(part, figures) for part in parts if not letters(part)}
        if self.with_calculator:
            values |= {part: self.in_letters(part) for part in parts if letters(part)}
        return {node: number for node, number in values.items() if number is not None}

    def has_known(self, tree: Expression) -> bool:
        """Whether a value in a tree is on paper with figures."""
        return any(node in self._known for node in walk(tree)) or self._by_value(tree) != tree

    def _by_value(self, tree: Expression) -> Expression:
        """A tree with figures for the values in it that are on paper in another form."""
        if not self._by_size or (RATIOS.isdisjoint(functions_in(tree)) and not has_root(tree)):
            return tree
        parts = {node: self._of_size(node) for node in walk(tree) if self._is_of_several(node)}
        return exchanged(tree, {node: put for node, put in parts.items() if put is not None})

    def _of_size(self, tree: Expression) -> Expression | None:
        size = size_of(tree) if self._by_size else None
        put = None if size is None else self._by_size.get(size.figures)
        return None if size is None or put is None else with_sign(put, size.is_positive)

    def _arctangent(self, tree: Expression) -> Expression:
        """An arctangent of the other sign of what is on paper: in 180° − β, with β known."""
        match tree:
            case Apply("arctan", inside) if of_plain_angles(inside):
                for known, put in self._known.items():
                    if of_plain_angles(known) and figures_of(known) == figures_of(Negate(inside)):
                        return Apply("arctan", swept(Negate(put)))
        return tree

    def _is_long(self, tree: Expression) -> bool:
        """Whether a value is a sum with ratios of plain angles in it, or a sum of roots."""
        return self.is_of_roots(tree) or _is_long(tree)

    def _is_awkward(self, tree: Expression) -> bool:
        """Whether a number has a fraction beside a ratio that nobody would carry: (112/45) cos 52°.

        Among decimals nobody has a multiple of a ratio below a line.
        """
        if not of_plain_angles(tree):
            return False
        quotients = [node for node in walk(tree) if is_binary(node, "/")]
        return any(_is_long_fraction(node) for node in quotients) or (
            self._decimals and any(_is_multiple_of_a_ratio(node.right) for node in quotients)
        )

    def _is_number_of_several(self, tree: Expression) -> bool:
        """Whether a number has several ratios, or one beside a sum of roots."""
        return not letters(tree) and self._is_of_several(tree)

    def _is_of_several(self, tree: Expression) -> bool:
        """Whether a value has several ratios of plain angles, or one beside a sum of roots."""
        if _has_several_ratios(tree) or (self.with_calculator and _is_long(tree)):
            return True
        one = bool(ratios_of_numbers(tree)) and not has_quantity(tree)
        return one and self.with_calculator and self.has_sums_of_roots(tree)

    def vector(self, tree: Expression) -> Expression:
        """A vector of which each long component has its figures alone; they are known from then."""
        self.note_components(tree)
        return self.put(tree)

    def note_components(self, tree: Expression) -> None:
        """Notes that the figures of the components of a vector stand on paper now."""
        for node in walk(tree):
            match node:
                case Binary("*", size, Unit()):
                    self.note(size)


def _by_degrees(tree: Expression) -> Expression:
    """A ratio of a sum of angles, or a multiple of one, with its figures: 4.983 sin 52.24°."""
    match tree:
        case Negate(operand):
            return Negate(_by_degrees(operand))
        case Apply(name, angle) if name in RATIOS and is_sum_with_inverse(angle):
            return Apply(name, degrees_of(angle) or angle)
        case Binary("*", size, Apply(name, angle)) if name in RATIOS and is_sum_with_inverse(angle):
            number = (figures_of(size) if _is_long(size) else None) or size
            return Binary("*", number, Apply(name, degrees_of(angle) or angle))
    return tree


def _is_quotient_of_numbers(tree: Expression) -> bool:
    match tree:
        case Binary("/", above, below):
            return isinstance(unsigned(above), Number) and isinstance(unsigned(below), Number)
    return False


def _square_of_root(tree: Expression) -> Expression:
    """What stands under a root of figures, where its square is taken."""
    match tree:
        case Binary("^", Apply("sqrt", Binary("+") as inside), Number(2)):
            return inside
    return tree


def _sign_outside(tree: Expression) -> Expression:
    """An arctangent without a sign inside: 180° − arctan 1.374."""
    match tree:
        case Apply("arctan", Negate(inside)):
            return Negate(Apply("arctan", inside))
    return tree


def _is_long(tree: Expression) -> bool:
    """Whether a value is a sum with ratios of plain angles in it, or has the root of one."""
    match tree:
        case Binary("+" | "-"):
            return of_plain_angles(tree)
        case Binary("/", above, Number()) | Binary("*", Number(), above):
            return _is_long(above)
        case Binary("*", left, right) if of_plain_angles(tree):
            return _is_long(left) or _is_long(right)
    return not letters(tree) and _has_root_of_ratios(tree)


def _has_root_of_ratios(tree: Expression) -> bool:
    return any(map(_is_root_of_ratios, walk(tree)))


def _is_root_of_ratios(tree: Expression) -> bool:
    return is_function(tree, "sqrt") and of_plain_angles(tree.argument)


def _is_over_a_root(tree: Expression) -> bool:
    """Whether a value is a sine or cosine by a tangent with roots, or a multiple of one."""
    match tree:
        case Binary("/", above, below):
            return _has_root_of_ratios(above) and _is_root_of_ratios(below)
    return False


def _is_over_a_sum(tree: Expression) -> bool:
    """Whether a number is a quotient by a sum with ratios: of what an equation has given."""
    return is_binary(tree, "/") and _is_long(tree.right) and not letters(tree)


def _has_long_numbers(tree: Expression) -> bool:
    """Whether a number of ratios has a factor that nobody would write."""
    return of_plain_angles(tree) and any(
        isinstance(node, Number) and max(node.value.numerator, node.value.denominator) >= _LONG
        for node in walk(tree)
    )


def _is_long_fraction(tree: Binary) -> bool:
    """Whether a quotient is a fraction with a number that is not short, and no short decimal."""
    match tree:
        case Binary("/", Number(above), Number(below)):
            places = _DECIMALS % (above / below).denominator
            return max(above, below) >= (_SHORT if places else _LONG)
    return False


def _is_multiple_of_a_ratio(tree: Expression) -> bool:
    """Whether a tree is a number times a ratio: 2.4 sin 38°."""
    return is_binary(tree, "*") and isinstance(tree.left, Number) and of_plain_angles(tree)


def _has_several_ratios(tree: Expression) -> bool:
    return len(ratios_of_numbers(tree)) >= _LONG_SUM and not has_quantity(tree)


def _by_its_size(tree: Expression, put: Expression) -> dict[str, Expression]:
    """What stands on paper for a value of that size, where it has one."""
    size = size_of(tree)
    return {} if size is None else {size.figures: with_sign(put, size.is_positive)}


def _same_angle(ratio: Expression, figures: Expression | None, inverse: str = "arccos") -> bool:
    """Whether the figures of a ratio lead to its angle."""
    return figures is not None and not _differ(Apply(inverse, ratio), Apply(inverse, figures))


def _differ(exact: Expression, put: Expression) -> bool:
    """Whether a value has other figures in an answer if figures are put in on the way."""
    one, other = rounded(exact), rounded(put)
    if one is None or other is None or one == other:
        return False
    value = scalar_worth(put)
    if not is_binary(put, "/", "-", "+") or value is None or value.free_symbols:
        return True
    # What is a decimal with an end has its fourth figure still.
    return is_measure_of_angle(put) or (
        figures_of(exact, FIGURES_OF_ANSWERS) != figures_of(put, FIGURES_OF_ANSWERS)
    )


def figures_of(tree: Expression, figures: int = FIGURES_BETWEEN) -> Expression | None:
    """A number to so many figures, as a decimal; None of one that is very small or large."""
    try:
        number = number_carried(worth(tree), figures)
    except (RestitutionError, sp.SympifyError):
        return None
    if number is None:
        return None
    size = Rounded(abs(number), figures)
    return Negate(size) if number < 0 else size
