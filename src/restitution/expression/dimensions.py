"""Dimensions: what a value is measured in, by its powers of mass, length and time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TypeAlias

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    has_quantity,
    letters,
)

Dimension: TypeAlias = tuple[int, int, int]

NONE: Dimension = (0, 0, 0)
MASS: Dimension = (1, 0, 0)
LENGTH: Dimension = (0, 1, 0)
TIME: Dimension = (0, 0, 1)
SPEED: Dimension = (0, 1, -1)
IMPULSE: Dimension = (1, 1, -1)
ENERGY: Dimension = (1, 2, -2)

_OF_QUANTITY: Mapping[str, Dimension] = {
    "velocity": SPEED,
    "speed": SPEED,
    "impulse": IMPULSE,
    "momentum": IMPULSE,
    "energy": ENERGY,
    "energy_lost": ENERGY,
    "total_energy_lost": ENERGY,
    "mass": MASS,
    "position": LENGTH,
    "distance": LENGTH,
    "time": TIME,
}

_NOTHING: Mapping[str, Dimension] = {}


def dimension_of(
    tree: Expression, of_letters: Mapping[str, Dimension] = _NOTHING
) -> Dimension | None:
    """The dimension of an expression of quantities; None where its quantities do not tell it.

    ``of_letters`` are the dimensions of the letters for which they are known.
    """
    match tree:
        case Quantity(kind, arguments):
            if kind in ("along", "across"):
                return dimension_of(arguments[0], of_letters)
            if kind == "dot":
                first, second = (dimension_of(each, of_letters) for each in arguments)
                return times(first, second, 1)
            return _OF_QUANTITY.get(kind, NONE)
        case Letter(name) if name in of_letters:
            return of_letters[name]
        case Apply("abs", argument):
            return dimension_of(argument, of_letters)
        case Apply("sqrt", _):
            return None
        case Negate(operand):
            return dimension_of(operand, of_letters)
        case Binary("+" | "-", left, right):
            return dimension_of_any((left, right), of_letters)
        case Binary("*" | "/" as op, left, right):
            first, second = dimension_of(left, of_letters), dimension_of(right, of_letters)
            return times(first, second, 1 if op == "*" else -1)
        case Binary("^", base, Number(exponent)) if exponent.denominator == 1:
            found = dimension_of(base, of_letters)
            if found is None:
                return None
            a, b, c = found
            power = int(exponent)
            return (a * power, b * power, c * power)
    return None if letters(tree) else NONE


def dimension_of_any(
    operands: Iterable[Expression], of_letters: Mapping[str, Dimension] = _NOTHING
) -> Dimension | None:
    """The dimension of the first operand whose quantities, or known letters, tell it."""
    for each in operands:
        if has_quantity(each) or letters(each) & of_letters.keys():
            found = dimension_of(each, of_letters)
            if found is not None:
                return found
    return None


def times(left: Dimension | None, right: Dimension | None, power: int) -> Dimension | None:
    """The dimension of a product (power 1) or of a quotient (-1)."""
    if left is None or right is None:
        return None
    a, b = left, right
    return (a[0] + power * b[0], a[1] + power * b[1], a[2] + power * b[2])
