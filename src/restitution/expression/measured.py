"""Values with units inside an expression: where each stands, and what is measured there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from restitution.expression.dimensions import NONE, TIME, Dimension
from restitution.expression.quantities import dimension_of_any
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Degrees,
    Expression,
    Letter,
    Measured,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    is_binary,
    is_vector,
    walk,
)
from restitution.records import dataclass

_OF_ANGLES = frozenset(("sin", "cos", "tan", "cot", "sec", "cosec"))


@dataclass(frozen=True)
class Slot:
    """Where a value stands: its dimension, None where nothing tells it, and what has the value.

    ``angle`` is a place for an angle; ``mixed`` one beside terms without a unit.
    """

    dimension: Dimension | None = None
    what: str = ""
    angle: bool = False
    mixed: bool = False


NOWHERE = Slot()
ANGLE = Slot(NONE, "an angle", angle=True)

Decide = Callable[[Measured, Slot], Expression]


def has_unit(tree: Any) -> bool:
    """Whether a unit stands anywhere in an expression."""
    return any(isinstance(node, Measured) for node in walk(tree))


def without_units(
    tree: Any, slot: Slot, decide: Decide, of_letters: Mapping[str, Dimension]
) -> Expression:
    """An expression in which ``decide`` has put something else for every value with a unit."""
    if not has_unit(tree):
        result: Expression = tree
        return result

    def inside(part: Any, where: Slot) -> Expression:
        return without_units(part, where, decide, of_letters)

    if isinstance(tree, Measured):
        return decide(replace(tree, operand=inside(tree.operand, NOWHERE)), slot)
    match tree:
        case Negate(operand):
            return replace(tree, operand=inside(operand, slot))
        case Binary("+" | "-", left, right):
            whole: Any = right
            if isinstance(whole, Measured) and is_vector(whole.operand) and not has_unit(left):
                # ``3i + 4j m/s``: the unit is that of the whole vector.
                total = replace(tree, right=whole.operand)
                return decide(replace(whole, operand=total, place=tree.place), slot)
            if slot.dimension is None:
                beside: tuple[Any, ...] = (left, right)
                parts = (factor for factor in beside if not isinstance(factor, Measured))
                slot = replace(slot, dimension=dimension_of_any(parts, of_letters))
            if not (has_unit(left) and has_unit(right)):
                slot = replace(slot, mixed=True)
            return replace(tree, left=inside(left, slot), right=inside(right, slot))
        case Binary(op, left, right):
            first = slot if op in "*/" and (_is_number(right) or is_vector(right)) else NOWHERE
            second = slot if op == "*" and _is_number(left) else NOWHERE
            return replace(tree, left=inside(left, first), right=inside(right, second))
        case Pair(x, y):
            return replace(tree, x=inside(x, slot), y=inside(y, slot))
        case Polar():
            return _polar(tree, slot, inside)
        case Apply(function, argument):
            where = ANGLE if function in _OF_ANGLES else slot if function == "abs" else NOWHERE
            return replace(tree, argument=inside(argument, where))
        case Quantity(_, arguments, stage):
            if isinstance(stage, AtTime):
                stage = AtTime(inside(stage.time, Slot(TIME, "a time")))
            return replace(
                tree,
                arguments=tuple(inside(argument, NOWHERE) for argument in arguments),
                stage=stage,
            )
    raise AssertionError(f"nothing with a unit stands in {tree!r}")


def _polar(tree: Polar, slot: Slot, inside: Callable[[Any, Slot], Expression]) -> Expression:
    size, angle, origin = tree.size, tree.angle, tree.origin
    behind: Any = angle
    if (
        isinstance(behind, Measured)
        and behind.unit != "rad"
        and not has_unit(size)
        and (len(behind.unit) > 1 or any(isinstance(x, Degrees) for x in walk(behind.operand)))
    ):
        # ``5 at 30° m/s``: the unit is that of the size. In ``5 at 3m``, m is a letter.
        size = replace(behind, operand=size, place=tree.place)  # type: ignore[assignment]
        angle = behind.operand
    return replace(
        tree,
        size=inside(size, slot),
        angle=inside(angle, ANGLE),
        origin=None if origin is None else inside(origin, NOWHERE),
    )


def _is_number(tree: Any) -> bool:
    """Whether an expression is a number without a unit."""
    others = Letter | Name | Quantity | Unit | Pair | Polar | Measured
    return not any(isinstance(node, others) for node in walk(tree))


def scaled(tree: Expression, factor: Fraction) -> Expression:
    """An expression times a number: a number where it is one, else as like itself as can be."""
    if factor == 1:
        return tree
    match tree:
        case Number(value):
            return _number(value * factor, tree)
        case Binary("/", Number(above), Number(below)) if below != 0:
            return _number(above / below * factor, tree)
        case Negate(operand):
            return replace(tree, operand=scaled(operand, factor))
        case Binary("+" | "-", left, right):
            return replace(tree, left=scaled(left, factor), right=scaled(right, factor))
        case Binary("*" | "/", left, _) if not isinstance(left, Unit):
            return replace(tree, left=scaled(left, factor))
        case Pair(x, y):
            return replace(tree, x=scaled(x, factor), y=scaled(y, factor))
        case Polar(size):
            return replace(tree, size=scaled(size, factor))
    return Binary("*", _number(factor, tree), tree, place=tree.place)


def _number(value: Fraction, at: Expression) -> Expression:
    """A number as it would be typed: a decimal where that is exact, else a quotient."""
    rest = value.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    if rest == 1:
        return Number(value, place=at.place)
    above, below = (
        Number(Fraction(part), place=at.place) for part in (value.numerator, value.denominator)
    )
    return Binary("/", above, below, place=at.place)


def product_with(operand: Expression, factors: Expression) -> Expression:
    """A product that begins with ``operand``: what ``5 m/s`` is if m and s are letters."""
    if is_binary(factors, "*", "/"):
        return replace(factors, left=product_with(operand, factors.left), place=operand.place)
    return Binary("*", operand, factors, place=operand.place)
