"""Answers as people see them: exact, with decimals where these say more."""

from __future__ import annotations

from fractions import Fraction as Ratio
from functools import lru_cache
from typing import Any

import sympy
from sympy import Expr, Mul, Rational, S

from restitution import exact
from restitution.render.layout.algebra import (
    DIRECT,
    decimal_number,
    from_sympy,
    plain_number,
    vector,
)
from restitution.render.layout.builders import bracketed, negative, product, split_sign
from restitution.render.layout.nodes import (
    Brackets,
    Coordinates,
    Degrees,
    Fraction,
    Layout,
    Percent,
    Phrase,
    Relation,
)
from restitution.render.layout.ranges import from_set
from restitution.render.layout.sides import as_layout, equation

_ROUNDED = 3
# A decimal of so many figures is not rounded.
_EXACT = 4
_TEN = 10
# No decimal of four figures has more places.
_PLACES = 12


def display(
    value: Any, *, angle: bool = False, percentage: bool = False, decimals: bool = False
) -> Layout:
    """An answer: its exact form and, where that says more, its value to 3 significant figures.

    A decimal that ends with the fourth figure is given as it is (``441/20 = 22.05``).

    ``√103 u/16 = 0.634u``, ``arctan(3/4) = 36.9°``, ``60°``, ``3/7 = 0.429``, ``7u/11``. An angle
    is given in radians and shown in degrees. A fraction of letters is a decimal too where those
    of the data are (``decimals``).
    """
    sides = _display_sides(value, angle, percentage, decimals)
    return sides[0] if len(sides) == 1 else equation(*sides)


def display_named(name: Any, value: Any, *, angle: bool = False) -> Relation:
    """The same with the name of what has the value in front: ``α = arctan(3/4) = 36.9°``."""
    return equation(name, *_display_sides(value, angle, percentage=False))


def display_vector(x: Any, y: Any, *, decimals: bool = False) -> Layout:
    """A vector answer: exact and, where a component needs it, to 3 significant figures.

    A vector of short fractions (``(5/3)i − j``) is exact alone, unless it is one of decimals, or
    those of the data are (``decimals``).
    """
    pair = [sympy.sympify(value, strict=True) for value in (x, y)]
    if not decimals and all(map(_is_short, pair)) and not all(map(_is_decimal, pair)):
        return vector(*pair)
    return _display_pair(x, y, vector, decimals)


def display_point(x: Any, y: Any) -> Layout:
    """The coordinates of a point: exact and, where one needs it, to 3 significant figures."""
    return _display_pair(x, y, lambda a, b: Coordinates((as_layout(a), as_layout(b))))


def display_set(values: Any, name: Any, *, angle: bool = False) -> Layout:
    """A range: exact and, where an end needs it, with ends to 3 significant figures."""
    layout = from_set(values, name, degrees=angle)
    ends = _ends(values)
    if not any(_rounded(end, angle) for end in ends):
        return layout
    if any(end.free_symbols for end in ends):
        return layout
    return Phrase((layout, Brackets(_set_decimals(values, as_layout(name), angle))))


def _display_sides(
    value: Any, angle: bool, percentage: bool, decimals: bool = False
) -> list[Layout]:
    value = sympy.sympify(value, strict=True)
    if percentage:
        return _display_percentage(value)
    rounded = _rounded(value, angle, decimals, _exact_figures(value))
    if rounded is None:
        return [from_sympy(value, degrees=angle)]
    if _is_long(value):
        return [rounded]
    return [from_sympy(value, degrees=angle), rounded]


# What costs more stands as a decimal alone where there are ratios of several angles in it, such as
# 40° and 70°, or a sum with roots of sums of roots.
_NESTED = 14


def _is_long(value: Expr) -> bool:
    """Whether nobody would print the exact form of a value that has a decimal one."""
    most = 28 if value.has(*DIRECT) else 40
    if value.has(sympy.CRootOf) or exact.cost(value) > most:
        return True
    if exact.cost(value) <= _NESTED:
        return False
    return len(exact.plain_angles_in(value)) > 1 or any(
        exact.is_nested(term)
        for node in sympy.preorder_traversal(value)
        if isinstance(node, sympy.Add)
        for term in node.args
    )


def _display_percentage(value: Expr) -> list[Layout]:
    hundred = exact.tidy(100 * value)
    if value.free_symbols:
        return [Percent(bracketed(from_sympy(hundred)))]
    rounded = Percent(decimal_number(hundred))
    if isinstance(hundred, Rational) and 1000 % hundred.q == 0 and _figures(hundred) <= _EXACT:
        size = Percent(plain_number(Ratio(int(abs(hundred.p)), int(hundred.q))))
        return [negative(size) if hundred.p < 0 else size]
    return [from_sympy(value), rounded]


def _figures(value: Rational) -> int:
    """How many significant figures a decimal has that ends; more than any if it does not."""
    scaled = abs(value) * 10**_PLACES
    return len(str(int(scaled)).strip("0")) if scaled.q == 1 else _PLACES


def _is_short(value: Expr) -> bool:
    """Whether a component is a whole number, or a fraction below which stands one digit."""
    return isinstance(value, Rational) and value.q < _TEN


def _is_decimal(value: Rational) -> bool:
    """Whether a number is a decimal of three figures, or of fewer."""
    return _figures(value) <= _ROUNDED


def _exact_figures(value: Expr) -> int:
    """To how many figures a number, or what stands before letters, is given: four if exact."""
    number, _ = _number_and_letters(value)
    is_exact = isinstance(number, Rational) and _figures(number) == _EXACT
    return _EXACT if is_exact else _ROUNDED


@lru_cache(maxsize=1024)
def _rounded(
    value: Expr, angle: bool, decimals: bool = False, figures: int = _ROUNDED
) -> Layout | None:
    """The value to 3 significant figures, or None where the exact form says enough.

    It does for a fraction of letters, unless the data have ``decimals``.
    """
    if angle:
        in_degrees = value * 180 / sympy.pi
        if value.free_symbols or exact.decimal(value) is None:
            return None
        if isinstance(in_degrees, Rational) and 1000 % in_degrees.q == 0:
            return None
        size = decimal_number(in_degrees)
        sign, inner = split_sign(size)
        return negative(Degrees(inner)) if sign == "-" else Degrees(inner)
    coefficient, rest = _number_and_letters(value)
    if coefficient is None or exact.decimal(coefficient) is None:
        return None
    if isinstance(coefficient, Rational) and (
        _simple(coefficient) or (rest is not S.One and not decimals)
    ):
        return None
    return _times_letters(decimal_number(coefficient, figures), rest)


def _times_letters(number: Layout, rest: Expr) -> Layout:
    """A decimal number, with its sign, times a product of letters."""
    if rest is S.One:
        return number
    layout = from_sympy(rest)
    sign, size = split_sign(number)
    term: Layout
    if isinstance(layout, Fraction):
        term = Fraction(product(size, layout.above), layout.below)
    else:
        term = product(size, layout)
    return negative(term) if sign == "-" else term


def _number_and_letters(value: Expr) -> tuple[Expr | None, Expr]:
    """A number times one product of letters, or None."""
    if not value.free_symbols:
        return value, S.One
    number, rest = value.as_independent(*value.free_symbols, as_Add=False)
    for factor in Mul.make_args(rest):
        base, exponent = factor.as_base_exp()
        if not base.is_Symbol or not exponent.is_Integer:
            return None, rest
    return number, rest


def _simple(value: Rational) -> bool:
    """Whole numbers, halves and quarters, and proper fractions down to sixths."""
    return value.q in (1, 2, 4) or (value.q <= 6 and abs(value.p) < value.q)


def _display_pair(x: Any, y: Any, build: Any, decimals: bool = False) -> Layout:
    first, second = sympy.sympify(x, strict=True), sympy.sympify(y, strict=True)
    whole: Layout = build(first, second)
    rounded = [_rounded(value, False, decimals) for value in (first, second)]
    ready = all(
        layout is not None or _number_and_letters(value)[0] is not None
        for layout, value in zip(rounded, (first, second), strict=True)
    )
    if not ready or all(layout is None for layout in rounded):
        return whole
    long = any(_is_long(value) for value in (first, second))
    parts = [
        layout if layout is not None else _with_three_figures(value)
        for layout, value in zip(rounded, (first, second), strict=True)
    ]
    return build(*parts) if long else equation(whole, build(*parts))


def _with_three_figures(value: Expr) -> Layout:
    """A component beside one that is rounded: it has three figures too, unless it is 0 or *a*."""
    number, rest = _number_and_letters(value)
    if number is None or value == 0 or (abs(number) == 1 and rest != 1):
        return from_sympy(value)
    return _times_letters(decimal_number(number), rest)


def _ends(values: Any) -> list[Expr]:
    if isinstance(values, sympy.Interval):
        return [x for x in (values.start, values.end) if x.is_finite is not False]
    if isinstance(values, sympy.FiniteSet):
        return list(values.args)
    if isinstance(values, sympy.Union):
        return [end for part in values.args for end in _ends(part)]
    return []


def _set_decimals(values: Any, subject: Layout, angle: bool) -> Layout:
    """The same statement with rounded ends."""
    layout = from_set(values, subject, degrees=angle)
    table: dict[Layout, Layout] = {}
    for end in _ends(values):
        rounded = _rounded(end, angle)
        if rounded is not None:
            table[from_sympy(end, degrees=angle)] = rounded
    return _replaced(layout, table)


def _replaced(layout: Layout, table: dict[Layout, Layout]) -> Layout:
    if isinstance(layout, Relation):
        return Relation(
            tuple(table.get(operand, operand) for operand in layout.operands), layout.signs
        )
    if isinstance(layout, Phrase):
        return Phrase(tuple(_replaced(item, table) for item in layout.items), layout.separator)
    return layout
