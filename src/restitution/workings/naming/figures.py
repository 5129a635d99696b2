"""Values of whole degrees and decimals to four figures, once they are on paper.

Exactly ``v = (61/76) cos 35° − (319/190) sin 25°`` is long, and stands once, with ``≈ −0.05208``
behind it; where it comes again, its figures are printed. Sums with roots of sums of roots have
figures everywhere but where the root of an equation is told. What the lines say stays exact.
"""

from __future__ import annotations

from fractions import Fraction
from functools import partial

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import significant
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Unit,
    has_quantity,
    is_binary,
    is_function,
    letters,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import product, swept, tree_of
from restitution.workings.naming.measured import rounded, worth

# Of a value on the way, so that three are right in the end.
FIGURES_BETWEEN = 4
_FIGURES_OF_COSINES = range(FIGURES_BETWEEN, 9)
_FIGURES_BEFORE_A_ROUNDING = range(FIGURES_BETWEEN, 7)
_RATIOS = frozenset({"sin", "cos", "tan"})
# Values beyond these would need a power of ten.
_LONG_PRODUCT = 3  # of so many ratios
_LONG_SUM = 2
_LEAST, _GREATEST = Fraction(1, 1000), 10000


def of_plain_angles(tree: Expression) -> bool:
    """Whether a number has ratios of angles such as 37°, of which only a calculator knows."""
    return has_plain_angles(tree) and not letters(tree)


def has_plain_angles(tree: Expression) -> bool:
    """Whether ratios of such angles stand in a value."""
    return bool(_ratios_of_numbers(tree))


def has_sums_of_nested_roots(tree: Expression) -> bool:
    """Whether a value in it is a sum with roots of sums of roots, or the root of such a sum."""
    return any(map(is_of_nested_roots, walk(tree)))


def is_of_nested_roots(tree: Expression) -> bool:
    """Whether a value as it comes out is a sum with roots of sums of roots, or the root of one.

    A sum of products of such values is still to be worked out.
    """
    match tree:
        case Binary("*", Number(), Binary("/")):
            return False
        case Binary("/", above, Number()) | Binary("*", Number(), above) | Negate(above):
            return is_of_nested_roots(above)
        case Binary("+" | "-"):
            return _is_sum_of_roots(tree) and any(map(_is_nested_root, walk(tree)))
        case Apply("sqrt", inside):
            return is_of_nested_roots(inside)
    return False


def _is_sum_of_roots(tree: Expression) -> bool:
    match tree:
        case Binary("+" | "-", left, right):
            return _is_sum_of_roots(left) and _is_sum_of_roots(right)
    return _is_term(tree)


def _is_term(tree: Expression) -> bool:
    """Whether a number is a product of roots and rational numbers."""
    match tree:
        case Number():
            return True
        case Apply("sqrt", inside):
            return not any(map(_is_open, walk(inside)))
        case Negate(inside):
            return _is_term(inside)
        case Binary("*" | "/", left, right):
            return _is_term(left) and _is_term(right)
    return False


def _is_open(tree: Expression) -> bool:
    """Whether a node is a letter or a quantity, or a power that is still to be worked out."""
    return is_binary(tree, "^") or isinstance(tree, Letter | Quantity)


def _is_nested_root(tree: Expression) -> bool:
    return is_function(tree, "sqrt") and any(
        is_function(node, "sqrt") for node in walk(tree.argument)
    )


def _ratios_of_numbers(tree: Expression) -> list[Apply]:
    return [
        node
        for node in walk(tree)
        if isinstance(node, Apply) and node.function in _RATIOS and not letters(node)
    ]


def in_letters_with_figures(tree: Expression) -> Expression | None:
    """A multiple of letters by a number that only a calculator knows, as 0.1351u.

    None of another value, and of one that is short: ½u cos 20°.
    """
    most = _LONG_SUM if any(map(_is_long, walk(tree))) else _LONG_PRODUCT
    if any(map(_is_sum_with_a_root, walk(tree))):
        most = 1  # (2 − √3)u sin 50°
    if len(_ratios_of_numbers(tree)) < most or has_quantity(tree):
        return None
    try:
        value = sp.factor(worth(tree))
    except (RestitutionError, sp.SympifyError):
        return None
    if not isinstance(value, sp.Expr):
        return None  # a vector
    number, rest = value.as_independent(*value.free_symbols, as_Add=False)
    if (
        not letters(tree)
        or not number.is_real
        or not all(
            factor.is_Symbol or (factor.is_Pow and factor.base.is_Symbol and factor.exp.is_Integer)
            for factor in sp.Mul.make_args(rest)
        )
    ):
        return None
    size = _fraction(number, FIGURES_BETWEEN)
    if size is None:
        return None
    whole = product(Number(abs(size)), tree_of(rest))
    return Negate(whole) if size < 0 else whole


def _is_sum_with_a_root(tree: Expression) -> bool:
    """Whether an expression is a sum of rational numbers and roots of such."""
    roots = any(is_function(node, "sqrt") for node in walk(tree))
    return is_binary(tree, "+", "-") and roots and _is_sum_of_roots(tree)


class Figures:
    """The sums of ratios of plain angles that are on paper, with their figures."""

    def __init__(self) -> None:
        self._known: dict[Expression, Expression] = {}

    def note(self, tree: Expression) -> None:
        """Notes that the figures of a value stand behind it now."""
        own = unsigned(tree)
        number = _in_figures(own) if _is_long(own) else in_letters_with_figures(own)
        if number is not None:
            self._known[own] = number

    def stands_for(self, tree: Expression, put: Expression) -> None:
        """Notes that a value stands on paper as an expression of figures, and not exactly."""
        if isinstance(tree, Negate):
            tree, put = tree.operand, swept(Negate(put))
        self._known.setdefault(tree, put)

    def instead_of(self, tree: Expression) -> Expression:
        """The figures of a value that is on paper with them; any other as it is."""
        if isinstance(tree, Negate):
            put = self.instead_of(tree.operand)
            return tree if put == tree.operand else swept(Negate(put))
        own = _in_figures(tree) if is_of_nested_roots(tree) else None
        return self._known.get(tree, own or tree)

    def cosine(self, tree: Expression) -> Expression:
        """The figures of a cosine that is not written exactly; they stand for it from then.

        There are as many of them as the angle to three figures needs.
        """
        own = unsigned(tree)
        number = next(
            filter(partial(_same_angle, own), (_in_figures(own, n) for n in _FIGURES_OF_COSINES)),
            None,
        )
        if number is None:
            return tree
        self._known[own] = number
        return tree if own is tree and number == own else exchanged(tree, {own: number})

    def put(self, tree: Expression, outcome: bool = False) -> Expression:
        """A side of a line with figures for the values in it that are on paper.

        An ``outcome`` with roots of sums of roots is one number.
        """
        own = unsigned(tree)
        if own in self._known:
            return tree
        for figures in _FIGURES_BEFORE_A_ROUNDING:
            nested = _nested_in_figures(tree, figures, outcome and has_sums_of_nested_roots(tree))
            put = rebuilt(exchanged(tree, nested | self._known), self._arctangent)
            if put == tree:
                return tree
            if not (nested and _is_quotient_of_numbers(put)):
                put = swept(rebuilt(swept(put), _sign_outside))
            # Figures that lead to others in the end would make the line false.
            if not _differ(tree, put):
                return put
            if not nested:
                return tree
        return tree

    def _arctangent(self, tree: Expression) -> Expression:
        """An arctangent of the other sign of what is on paper: in 180° − β, with β known."""
        match tree:
            case Apply("arctan", inside) if of_plain_angles(inside):
                for known, put in self._known.items():
                    if of_plain_angles(known) and _in_figures(known) == _in_figures(Negate(inside)):
                        return Apply("arctan", swept(Negate(put)))
        return tree

    def vector(self, tree: Expression) -> Expression:
        """A vector of which each long component has its figures alone; they are known from then."""
        for node in walk(tree):
            match node:
                case Binary("*", size, Unit()):
                    self.note(size)
        return self.put(tree)


def _is_quotient_of_numbers(tree: Expression) -> bool:
    match tree:
        case Binary("/", above, below):
            return isinstance(unsigned(above), Number) and isinstance(unsigned(below), Number)
    return False


def _nested_in_figures(tree: Expression, figures: int, whole: bool) -> dict[Expression, Expression]:
    """The sums with roots of sums of roots in a tree, each with its figures."""
    parts = [node for node in walk(tree) if is_of_nested_roots(node)]
    parts += [
        node.argument
        for node in walk(tree)
        if is_function(node, "arctan") and has_sums_of_nested_roots(node)
    ]
    if whole and not has_quantity(tree):
        parts.append(tree)
    values = {part: _in_figures(part, figures) for part in parts if not letters(part)}
    return {node: number for node, number in values.items() if number is not None}


def _sign_outside(tree: Expression) -> Expression:
    """An arctangent without a sign inside: 180° − arctan 1.374."""
    match tree:
        case Apply("arctan", Negate(inside)):
            return Negate(Apply("arctan", inside))
    return tree


def _is_long(tree: Expression) -> bool:
    """Whether a value is a sum with ratios of plain angles in it, or has the root of one.

    So is one with roots of sums of roots.
    """
    if is_of_nested_roots(tree):
        return True
    match tree:
        case Binary("+" | "-"):
            return of_plain_angles(tree)
        case Binary("/", above, Number()) | Binary("*", Number(), above):
            return _is_long(above)
        case Binary("*", left, right) if of_plain_angles(tree):
            return _is_long(left) or _is_long(right)
    return not letters(tree) and any(
        is_function(node, "sqrt") and of_plain_angles(node.argument) for node in walk(tree)
    )


def _same_angle(cosine: Expression, figures: Expression | None) -> bool:
    return figures is not None and not _differ(Apply("arccos", cosine), Apply("arccos", figures))


def _differ(exact: Expression, put: Expression) -> bool:
    """Whether a value has other figures in an answer if figures are put in on the way."""
    one, other = rounded(exact), rounded(put)
    return one is not None and other is not None and one != other


def _in_figures(tree: Expression, figures: int = FIGURES_BETWEEN) -> Expression | None:
    """A number to so many figures, as a decimal; None of one that is very small or large."""
    try:
        number = _fraction(worth(tree), figures)
    except (RestitutionError, sp.SympifyError):
        return None
    if number is None:
        return None
    return Negate(Number(-number)) if number < 0 else Number(number)


def _fraction(value: sp.Expr, figures: int) -> Fraction | None:
    """A number to so many figures; None of one that is very small or large."""
    try:
        number = Fraction(significant(value, figures))
    except ValueError:
        return None
    return number if _LEAST <= abs(number) < _GREATEST else None
