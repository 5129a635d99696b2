"""Values as a working gives them: with their units, rounded where a reader wants a decimal."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, replace
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import significant, tidy
from restitution.explaining.lines.derivation import Meaning
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.dimensions import NONE, Dimension
from restitution.expression.evaluate import in_letters
from restitution.expression.quantities import dimension_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Negate,
    Number,
    Unit,
    has_quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.language.measuring import dimensions_of_letters
from restitution.problem import Problem
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.wording.letters import named_letters
from restitution.wording.units import style_of
from restitution.work import remembered

_FIGURES = 3
# Of a value on the way, so that three are right in the end.
FIGURES_BETWEEN = 4
# A decimal of so many figures is exact, and not rounded to three.
_EXACT_FIGURES = 4
# Values beyond these would need a power of ten.
_LEAST, _GREATEST = Fraction(1, 1000), 10000


class Measures:
    """The units of one statement, and of the letters that its working introduces."""

    def __init__(self, problem: Problem, meanings: Mapping[str, Meaning]) -> None:
        self._style = style_of(problem)
        #: Whether the statement has decimals: then quantities with units are decimals too.
        self.decimals = any(
            isinstance(node, Number) and node.value.denominator > 1
            for tree in _quantities(problem)
            for node in walk(tree)
        )
        known: dict[str, Dimension] = dict(dimensions_of_letters(problem))
        self._of_statement = frozenset(known) - named_letters(problem)
        for name, meaning in meanings.items():
            dimension = dimension_of(meaning.quantity, known)
            if dimension is not None:
                known[name] = dimension
        self._letters = known

    def unit(self, tree: Expression) -> str:
        """The unit of a quantity, with blanks that hold; nothing where letters give the scale."""
        if self._is_of_the_question(tree):
            return ""
        dimension = dimension_of(tree, self._letters)
        return self._style.unit(dimension).lstrip()

    def _is_of_the_question(self, tree: Expression) -> bool:
        """Whether a tree has letters of the statement only.

        Where numbers fix the scale, the words have the unit behind the letter (a speed of
        u m s⁻¹), so that the letter is a number.
        """
        names = letters(tree)
        return bool(names) and names <= self._of_statement and not has_quantity(tree)

    def has_units_of_its_own(self, value: Expression) -> bool:
        """Whether letters in a value stand for what has a unit: then none stands behind it."""
        return any(self._letters.get(name, NONE) != NONE for name in letters(value))

    def with_decimals(self, tree: Expression) -> Expression:
        """A tree with the decimals of a statement that has such, as coefficients of its letters."""
        if not self.decimals or self.has_units_of_its_own(tree):
            return tree
        return in_decimals(tree)

    def is_in_decimals(self, subject: Expression) -> bool:
        """Whether the values of a side are decimals: it has a unit, or is (2t − 0.72)²."""
        if not self.decimals:
            return False
        return bool(self.unit(subject)) or _is_power_with_a_decimal(subject)


def _is_power_with_a_decimal(tree: Expression) -> bool:
    """Whether a side is a power with a decimal with an end in its base."""
    return is_binary(tree, "^") and any(as_decimal(node) != node for node in walk(tree))


def _quantities(problem: Problem) -> Iterator[Expression]:
    """The masses, velocities and places of a statement."""
    for sphere in problem.spheres:
        for value in (sphere.mass, sphere.velocity, sphere.position, sphere.radius):
            if isinstance(value, Expression):
                yield value


def as_decimal(tree: Expression) -> Expression:
    """A fraction that is a decimal with an end as that decimal, also as a component."""
    match tree:
        case Negate(operand):
            return Negate(as_decimal(operand))
        case Binary("/", Number(above), Number(below)) if _ends(above / below):
            return Number(above / below)
        case Binary("*", Binary("/", Number(above), Number(below)) as size, rest) if (
            above / below != Fraction(1, 2) and not isinstance(rest, Number)
        ):
            return Binary("*", as_decimal(size), rest)
        case Binary("*", size, Unit() as unit):
            return Binary("*", as_decimal(size), unit)
        case Binary("+" | "-" as op, left, right) if _of_units(left) and _of_units(right):
            return Binary(op, as_decimal(left), as_decimal(right))
    return tree


def terms_as_decimals(tree: Expression) -> Expression:
    """A sum of numbers whose fractions all are decimals with an end, with these in its terms.

    Those below a power are decimals too: ``1.25 − 0.4625``, ``0.5² + 3²``. A factor, such as a
    coefficient of restitution or the half of ½mv², stays as it is.
    """
    root = tree.argument if is_function(tree, "sqrt") else tree
    nodes = walk(root)
    if has_quantity(root) or letters(root) or any(isinstance(e, Apply | Unit) for e in nodes):
        return tree
    for node in nodes:
        match node:
            case Binary("/", Number(above), Number(below)) if not _ends(above / below):
                return tree
    return rebuilt(tree, _term_as_decimal)


def _term_as_decimal(tree: Expression) -> Expression:
    match tree:
        case Binary("+" | "-" as op, left, right):
            return Binary(op, as_decimal(left), as_decimal(right))
        case Binary("^", base, power):
            return Binary("^", as_decimal(base), power)
    return tree


def in_decimals(tree: Expression) -> Expression:
    """A tree in which coefficients of letters that are decimals with an end are these: 6.2e.

    A half and a quotient with a root in it stay as they are.
    """
    match tree:
        case Binary("/", above, Number(below)):
            size, rest = _coefficient(above)
            if rest is not None and size not in (0, 1) and _ends(size / below):
                return Binary("*", Number(size / below), rest)
        case Binary("/", Binary("*", Number(size), one), Binary("*", Number(below), other)):
            ratios = all(is_function(tree, "sin", "cos", "tan") for tree in (one, other))
            if ratios and size != below and _ends(size / below):
                return Binary("/", Binary("*", Number(size / below), one), other)
        case Binary("*", Binary("/", Number(above), Number(below)), rest):
            if above != 1 and _ends(above / below) and _is_rational(rest):
                return Binary("*", Number(above / below), rest)
        case Binary("^"):
            return replace(tree, left=in_decimals(tree.left))
    match tree:
        case Binary("+" | "-" | "*" | "/", left, right):
            return replace(tree, left=in_decimals(left), right=in_decimals(right))
        case Negate(operand):
            return replace(tree, operand=in_decimals(operand))
    return tree


def _coefficient(tree: Expression) -> tuple[Fraction, Expression | None]:
    """The number in front of a product of letters, and the product; None where it is not plain."""
    match tree:
        case Binary("*", Number(size), rest) if _is_rational(rest):
            return size, rest
        case Binary("*", left, right) if _is_rational(right):
            size, first = _coefficient(left)
            return size, None if first is None else replace(tree, left=first)
    return Fraction(1), None


def _is_rational(tree: Expression) -> bool:
    """Whether a tree has letters, and no root and no ratio of a number."""
    return bool(letters(tree)) and not any(
        isinstance(node, Apply) and not letters(node) for node in walk(tree)
    )


def _of_units(tree: Expression) -> bool:
    match tree:
        case Negate(operand):
            return _of_units(operand)
        case Binary("*", _, Unit()) | Unit():
            return True
        case Binary("+" | "-", left, right):
            return _of_units(left) and _of_units(right)
    return False


def _ends(value: Fraction) -> bool:
    return bool(10**6 % value.denominator == 0)


def worth(tree: Expression) -> sp.Expr:
    """The value of a tree of letters that are positive."""
    value = in_letters(tree, positive=True)
    return sp.sympify(value, strict=True)


def scalar_worth(tree: Expression) -> sp.Expr | None:
    """The value of a tree of letters that are positive; None of a vector, and of what has none."""
    try:
        value = worth(tree)
    except (RestitutionError, sp.SympifyError):
        return None
    return value if isinstance(value, sp.Expr) else None


def vector_worth(tree: Expression) -> Vector | None:
    """The value of a vector in letters that are positive; None where a line cannot say it."""
    try:
        value = in_letters(tree, positive=True)
        return Vector(*(tidy(component) for component in value))
    except (RestitutionError, TypeError):
        return None


def are_parallel(one: Expression, other: Expression) -> bool:
    """Whether two vectors are parallel, in either sense; False of what a line cannot say."""
    first, second = vector_worth(one), vector_worth(other)
    return first is not None and second is not None and tidy(first.cross(second)) == 0


def are_perpendicular(one: Expression, other: Expression) -> bool:
    """Whether two vectors are at right angles; False of what a line cannot say."""
    first, second = vector_worth(one), vector_worth(other)
    return first is not None and second is not None and tidy(first.dot(second)) == 0


def with_unit(value: lay.Layout, unit: str) -> lay.Layout:
    """A value with its unit; a sum in brackets."""
    if not unit:
        return value
    several = isinstance(value, lay.Sum) and len(value.terms) > 1
    return lay.Phrase((lay.Brackets(value) if several else value, lay.Words(unit)), "\u00a0")


def with_its_unit(value: lay.Layout, unit: str) -> lay.Layout:
    """A value with its unit where it is a number; in letters as it is."""
    return with_unit(value, unit) if is_plain(value) else value


def is_plain(value: lay.Layout) -> bool:
    """Whether a value is a number, or a vector of numbers: nothing is left to be worked out."""
    match value:
        case lay.Number():
            return True
        case lay.Bold(name, ""):
            return name in ("i", "j")
        case lay.Root(inside):
            return is_plain(inside)
        case lay.Brackets(inside):
            return is_plain(inside) and not _has_bold(inside)
        case lay.Function(_, lay.Degrees(angle)):
            return is_plain(angle)
        case lay.Fraction(above, below):
            return is_plain(above) and is_plain(below) and not _has_bold(above)
        case lay.Product(factors, ""):
            return all(map(is_plain, factors)) and not any(map(_has_bold, factors[:-1]))
        case lay.Sum(terms):
            parts = [layout for _, layout in terms]
            axes = [axis for axis in map(_axis, parts) if axis is not None]
            vector = len(parts) == 1 or len(set(axes)) == len(parts)
            return all(map(is_plain, parts)) and (vector or _is_surd(parts))
    return False


def _has_bold(layout: lay.Layout) -> bool:
    """Whether there is a vector in a number of any form."""
    match layout:
        case lay.Bold():
            return True
        case lay.Brackets(inside):
            return _has_bold(inside)
        case lay.Fraction(above, _):
            return _has_bold(above)
        case lay.Product(factors):
            return any(map(_has_bold, factors))
        case lay.Sum(terms):
            return any(_has_bold(layout) for _, layout in terms)
    return False


def _is_surd(parts: Sequence[lay.Layout]) -> bool:
    """Whether no two terms can be added: one of them at most is no multiple of a root."""
    roots = {str(root) for part in parts for root in _roots(part)}
    return sum(not [*_roots(part)] for part in parts) <= 1 and len(roots) >= len(parts) - 1


def _roots(layout: lay.Layout) -> Iterator[lay.Layout]:
    """The roots and the sines, cosines and tangents in a number."""
    match layout:
        case lay.Root() | lay.Function():
            yield layout
        case lay.Fraction(above, below):
            yield from (*_roots(above), *_roots(below))
        case lay.Product(factors):
            for factor in factors:
                yield from _roots(factor)


def _axis(term: lay.Layout) -> lay.Bold | None:
    """The vector of which a term is a multiple; None of a number."""
    last = term.factors[-1] if isinstance(term, lay.Product) else term
    return last if isinstance(last, lay.Bold) else None


@remembered(1024)
def number_carried(value: sp.Expr, figures: int) -> Fraction | None:
    """A number to so many figures; None of one that would need a power of ten."""
    try:
        number = Fraction(significant(value, figures))
    except ValueError:
        return None
    return number if _LEAST <= abs(number) < _GREATEST else None


def rounded(tree: Expression) -> lay.Layout | None:
    """A value to three figures; None where its exact form says enough, or is no number.

    A vector has three figures in every component, or none.
    """
    if has_quantity(tree):
        return None
    try:
        value: Any = in_letters(tree, positive=True)
    except RestitutionError:
        return None
    if isinstance(value, Vector):
        return _rounded_vector(value.x, value.y)
    if not isinstance(value, sp.Expr):
        return None
    if _terminates(value):
        return None
    return _rounded(value, is_measure_of_angle(tree))


def to_figures(tree: Expression, figures: int) -> lay.Layout | None:
    """A number to so many figures; None for what is none."""
    try:
        value = worth(tree)
    except (RestitutionError, sp.SympifyError):
        return None
    return lay.decimal_number(value, figures) if value.is_real else None


def is_rounded_to(figures: lay.Layout | None, value: lay.Layout) -> bool:
    """Whether a number in figures has such a value to three, as 3.195, and not 3.1947, has 3.20."""
    if not isinstance(figures, lay.Number) or not isinstance(value, lay.Number):
        return True
    return lay.decimal_number(sp.Rational(figures.digits), _FIGURES) == value


def multiple_in_figures(tree: Expression, figures: int) -> lay.Layout | None:
    """A number, or a multiple of letters by one, to so many figures: 0.6343u; None of a sum."""
    value = worth(tree)
    number, rest = value.as_independent(*value.free_symbols, as_Add=False)
    if not number.is_real or rest.is_Add or number.has(sp.pi, sp.asin, sp.acos, sp.atan):
        return None  # no angle in radians
    size = lay.decimal_number(number, figures)
    return size if rest == 1 else lay.product(size, lay.from_sympy(rest))


def to_three_figures(tree: Expression) -> lay.Layout | None:
    """A rounded number with the zeros at its end: 76.0°; None for what is no such number."""
    match tree:
        case Negate(operand):
            inside = to_three_figures(operand)
            return None if inside is None else lay.negative(inside)
        case Degrees(value):
            return lay.Degrees(lay.Number(_with_zeros(value)))
        case Number(value):
            return lay.Number(_with_zeros(value))
    return None


def _with_zeros(value: Fraction) -> str:
    digits = str(float(value)) if value.denominator > 1 else str(value)
    whole, _, part = digits.partition(".")
    kept = len(f"{whole}{part}".lstrip("0"))
    missing = _FIGURES - kept
    return f"{whole}.{part}{'0' * missing}" if value and missing > 0 else digits


@remembered(1024)
def as_answer(
    tree: Expression, place: bool = False, decimals: bool = False
) -> tuple[tuple[lay.Layout, str], ...]:
    """What is added to a value that was asked: its decimal, as answers have it, with its sign.

    Of a ``place`` there are the coordinates too. Nothing is added to what is plain, or no value, to
    a vector of short fractions, and to a fraction of letters only where it is long, or the data
    have ``decimals``.
    """
    if has_quantity(tree):
        return ()
    try:
        value: Any = in_letters(tree, positive=True)
    except RestitutionError:
        return ()
    if isinstance(value, Vector):
        x, y = (sp.sympify(component, strict=True) for component in (value.x, value.y))
        shown = lay.display_point(x, y) if place else lay.display_vector(x, y, decimals=decimals)
        exact = all(_is_decimal(component, _FIGURES) for component in (x, y))
    elif isinstance(value, sp.Expr):
        decimals = decimals or _is_long_multiple(value)
        shown = lay.display(value, angle=is_measure_of_angle(tree), decimals=decimals)
        exact, place = _is_decimal(value), False
    else:
        return ()
    sides = shown.operands if isinstance(shown, lay.Relation) else (shown,)
    if len(sides) == 1 and (
        _is_rounded_alone(value, shown, tree)
        or (
            isinstance(value, Vector)
            and not place
            and shown != lay.vector(*map(lay.from_sympy, value))
        )
    ):
        sides = (shown, shown)  # the exact form is too long for an answer
    added = tuple((_without_zeros(side), "=") if exact else (side, "≈") for side in sides[1:])
    return ((sides[0], "="), *added) if place else added


def _is_long_multiple(value: sp.Expr) -> bool:
    """Whether letters have a fraction before them of which nobody sees how large it is."""
    number, rest = value.as_coeff_Mul()
    if not rest.free_symbols or not isinstance(number, sp.Rational) or number.is_Integer:
        return False
    return len(f"{abs(number.p)}{number.q}") >= _LONG


_LONG = 8
"""So many digits has a long fraction, above and below."""


def _without_zeros(layout: Any) -> Any:
    """An exact decimal as it is: 0.65 and no 0.650, which would be rounded."""
    if isinstance(layout, tuple):
        return tuple(_without_zeros(value) for value in layout)
    if isinstance(layout, lay.Number):
        digits = layout.digits
        return lay.Number(digits.rstrip("0").rstrip(".")) if "." in digits else layout
    if isinstance(layout, lay.Product):
        factors = _without_zeros(layout.factors)
        is_one = factors[:-1] == (lay.Number("1"),) and isinstance(factors[-1], lay.Bold)
        return factors[-1] if is_one else replace(layout, factors=factors)
    if isinstance(layout, lay.Layout):
        changed = {e.name: _without_zeros(getattr(layout, e.name)) for e in fields(layout)}
        return replace(layout, **changed)
    return layout


def _is_decimal(value: sp.Expr, figures: int = _EXACT_FIGURES) -> bool:
    """Whether a number, or what stands before letters, is a decimal of so many figures."""
    number, rest = value.as_coeff_Mul()
    factors = sp.Mul.make_args(rest) if rest != 1 else ()
    if not isinstance(number, sp.Rational) or any(not factor.free_symbols for factor in factors):
        return False
    while number and abs(number) < 10 ** (figures - 1):
        number *= 10
    return bool(number.q == 1 and abs(number) < 10**figures) or not number


def percentage(tree: Expression) -> tuple[lay.Layout, str] | None:
    """A number as a percentage, with the sign before it: ≈ where it is rounded."""
    if has_quantity(tree):
        return None
    try:
        value: Any = in_letters(tree, positive=True)
    except RestitutionError:
        return None
    shown = lay.display(value, percentage=True)
    sign = "=" if _is_decimal(100 * value) else "≈"
    return (shown.operands[-1] if isinstance(shown, lay.Relation) else shown), sign


def _rounded(value: sp.Expr, angle: bool) -> lay.Layout | None:
    shown = lay.display(value, angle=angle)
    if isinstance(shown, lay.Relation):
        return shown.operands[-1]
    # Of a long number nothing but the decimal is shown.
    return shown if value.is_number and shown != lay.from_sympy(value, degrees=angle) else None


def _is_rounded_alone(value: Any, shown: lay.Layout, tree: Expression) -> bool:
    """Whether only the decimal of a number is shown, which has an exact form.

    So it may be of a number before letters: 2.15u.
    """
    if not isinstance(value, sp.Expr) or value.is_Rational:
        return False
    number, rest = value.as_independent(*value.free_symbols, as_Add=False)
    if rest.atoms(sp.Add, sp.Function) or not number.atoms(sp.Function, sp.Pow):
        return False
    return shown != lay.from_sympy(value, degrees=is_measure_of_angle(tree))


def _rounded_vector(x: Any, y: Any) -> lay.Layout | None:
    parts = [sp.sympify(value, strict=True) for value in (x, y)]
    if any(part.free_symbols for part in parts):
        return None
    if all(_terminates(part) or _rounded(part, False) is None for part in parts):
        return None
    return lay.vector(*(_decimal(part) for part in parts))


def _decimal(value: sp.Expr) -> lay.Layout:
    return lay.Number("0") if value == 0 else lay.decimal_number(value, _FIGURES)


def _terminates(value: sp.Expr) -> bool:
    """Whether a number is a decimal with an end, that no rounding makes plainer."""
    return isinstance(value, sp.Rational) and 1000 % value.q == 0


def is_measure_of_angle(tree: Expression) -> bool:
    """Whether a value is an angle: degrees, an inverse function, or made of one."""
    match tree:
        case Degrees():
            return True
        case Apply(function, _):
            return function.startswith("arc")
        case Negate(operand):
            return is_measure_of_angle(operand)
        case Binary("+" | "-" | "*" | "/", left, right):
            return is_measure_of_angle(left) or is_measure_of_angle(right)
    return False


def is_long_quotient(tree: Expression) -> bool:
    """Whether a value is a quotient of whole numbers of which one has three digits or more."""
    match tree:
        case Binary("/", Number(above), Number(below)):
            return max(above, below) >= 100
    return False
