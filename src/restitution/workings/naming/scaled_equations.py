"""Equations between decimals as they were before their numbers were made whole.

``42025 = 13689(1 − cos²θ) + 67600 cos²θ`` is 2500 times what a calculator shows of the line above.
"""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Rounded,
    has_quantity,
    is_binary,
    is_function,
    walk,
)
from restitution.planning.writing.forms import product
from restitution.workings.naming.measured import scalar_worth

_LONG = 1000
_FIGURES = 4
_LONGEST = 5
_DIGITS, _CLOSE = 40, 25
_POINTS = (sp.Rational(7, 10), sp.Rational(11, 13))
_MOVES = ("identity", "rearrange", "put")


def in_decimals_as_above(
    derivation: Derivation, line: Line, links: tuple[Link, ...]
) -> tuple[Link, ...]:
    """An equation of long numbers with those that it has by the line above; any other as it is.

    Where these are no decimals with an end they are figures.
    """
    if line.move.id not in _MOVES or len(links) != 1 or links[0].sign != "=":
        return links
    (own,) = links
    if _is_value(own) or has_quantity(own.left) or has_quantity(own.right):
        return links
    if not any(map(_has_long_numbers, (own.left, own.right))):
        return links
    for above in derivation.lines_in(line.premises):
        if not isinstance(above.relation, Relation) or len(above.relation.options) > 1:
            continue
        before = above.relation.only
        factor = _factor(Link(before[0].left, "=", before[-1].right), own)
        if factor is not None:
            sides = [_scaled(side, factor) for side in (own.left, own.right)]
            rounded = any(isinstance(node, Rounded) for side in sides for node in walk(side))
            return (Link(sides[0], "≈" if rounded else "=", sides[1], own.by),)
    return links


def _is_value(link: Link) -> bool:
    """Whether an equation says what a letter, a ratio, or the square of one is."""
    base = link.left.left if is_binary(link.left, "^") else link.left
    return isinstance(base, Letter | Quantity | Apply)


def _has_long_numbers(side: Expression) -> bool:
    """Whether a whole number of four figures stands on a side, and below no root."""
    nodes = set(walk(side))
    nodes -= {inner for node in nodes if is_function(node, "sqrt") for inner in walk(node)}
    return any(
        isinstance(node, Number) and node.value.denominator == 1 and abs(node.value) >= _LONG
        for node in nodes
    )


def _residual(link: Link) -> sp.Expr | None:
    """The left side less the right one; None where a side has no value by itself."""
    left, right = scalar_worth(link.left), scalar_worth(link.right)
    return None if left is None or right is None else left - right


def _factor(above: Link, own: Link) -> Fraction | None:
    """What makes of an equation the one above it: a number; None where that is none."""
    before, after = _residual(above), _residual(own)
    if before is None or after is None:
        return None
    symbols = sorted(before.free_symbols | after.free_symbols, key=str)
    ratios = []
    for point in _POINTS:
        put = {symbol: point / (n + 1) for n, symbol in enumerate(symbols)}
        below = after.subs(put).evalf(_DIGITS)
        if below == 0:
            return None
        ratios.append((before.subs(put) / below).evalf(_DIGITS))
    first, second = ratios
    if not first.is_Float or abs(first - second) > sp.Float(10) ** -_CLOSE:
        return None
    value = sp.nsimplify(first, rational=True, tolerance=sp.Float(10) ** -_CLOSE)
    return Fraction(int(value.p), int(value.q)) if value.q < _LONG**2 and value.p > 0 else None


def _scaled(side: Expression, factor: Fraction) -> Expression:
    """A side times a number, which goes to the number in front of each term."""
    match side:
        case Number(value):
            return _as_decimal(value * factor)
        case Negate(operand):
            return Negate(_scaled(operand, factor))
        case Binary("+" | "-" as op, left, right):
            return Binary(op, _scaled(left, factor), _scaled(right, factor))
        case Binary("*", left, right):
            return product(_scaled(left, factor), right)
        case Binary("/", above, below):
            return Binary("/", _scaled(above, factor), below)
    return product(_as_decimal(factor), side)


def _as_decimal(value: Fraction) -> Expression:
    """A number as a decimal of a few figures, or in figures."""
    if value < 0:
        return Negate(_as_decimal(-value))
    digits = sp.Rational(value.numerator, value.denominator)
    exact = Fraction(str(sp.N(digits, _LONGEST)))
    if exact == value:
        return Number(value)
    return Rounded(Fraction(str(sp.N(digits, _FIGURES))), _FIGURES)


__all__ = ["in_decimals_as_above"]
