"""Angles of a path to walls: to the next one by that to the last one, and at a wall with e = 1."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Literal

import sympy as sp

from restitution.explaining.lines.derivation import Event, Link
from restitution.explaining.lines.trees import exchanged
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
)
from restitution.oracle import Oracle, compared

_ONE = Number(Fraction(1))


def next_walls(step: Step, event: Event | None) -> Iterator[Link]:
    """The angle of a path to a wall: as it was, where e = 1, or by that to the wall it comes from.

    On which side of the wall the body leaves it, and in which sense along it, the laws tell.
    """
    if event is None or not event.wall or step.move.bodies != event.bodies[:1]:
        return
    body, wall = map(Name, event.bodies)
    late, early = (Quantity("velocity", (body,), event.number - back) for back in (0, 1))
    angle = Quantity("angle", (late, wall))
    if step.keeps_speeds(event):
        yield Link(angle, "=", Quantity("angle", (early, wall)))
    turned, size = _turn_of(step, wall), _cited(step, angle)
    if turned is None or size is None:
        return
    senses = [step.sense_on_paper(late, Polar(_ONE, turned), n) for n in (0, 1)]
    if senses[0] is None or senses[1] is None:
        return
    for direction in from_a_wall(turned, angle, senses[0], senses[1]):
        if _is_up_to_a_straight_angle(step, direction, {angle: size}):
            yield Link(Quantity("direction", (body,), event.number), "=", direction)
    sense = senses[0] * senses[1]
    for other in _other_walls(step, wall):
        there = _turn_of(step, other)
        for difference in () if there is None else made_of(turned, there, angle, sense):
            if _is_up_to_a_right_angle(step, difference, {angle: size}):
                yield Link(Quantity("angle", (late, other)), "=", difference)


def _cited(step: Step, angle: Quantity) -> Expression | None:
    """What an angle is by a line that is cited, which may say it of its letter."""
    names = [angle, *(Letter(let.letter) for let in step.lets if let.quantity == angle)]
    for link in reversed(step.links):
        if link.left in names and link.sign == "=":
            return link.right
    return None


def _other_walls(step: Step, own: Name) -> Iterator[Name]:
    """The walls of which the direction is cited, but for one."""
    for link in step.links:
        match link.left:
            case Quantity("direction", (Name() as wall,), None) if wall != own:
                yield wall


def _turn_of(step: Step, wall: Name) -> Expression | None:
    """The angle from **i** at which a wall is, where that is cited: in degrees or as a letter."""
    for link in step.links:
        match link:
            case Link(Quantity("direction", (Name() as own,), None), "parallel to" | "=", right):
                pass
            case _:
                continue
        match right:
            case Unit(axis) if own == wall:
                return Degrees(Fraction(90 if axis == "j" else 0))
            case Degrees() | Letter() if own == wall:
                return right
    return None


def made_of(
    here: Expression, there: Expression, angle: Quantity, sense: int
) -> Iterator[Expression]:
    """What the angle to one wall may be by that to another: as a sum, or a difference.

    ``sense`` is 1 where the direction of the body is that of the first wall turned to the left by
    the angle, and −1 where it is turned to the right.
    """
    for first, second, sign in ((here, there, sense), (there, here, -sense)):
        for turns in (0, 1, -1):
            yield from _with(first, second, turns, angle, sign)


def from_a_wall(wall: Expression, angle: Quantity, onward: int, left: int) -> Iterator[Expression]:
    """The direction of a path, from **i**, that makes an angle with a wall in degrees.

    The path leads the same way along the wall as its direction or not, and to the left of that or
    to its right.
    """
    if not isinstance(wall, Degrees):
        return
    for turn in (0,) if onward == 1 else (180, -180):
        base = wall.value + turn
        if base > 0:
            yield Binary("+" if onward == left else "-", Degrees(base), angle)
        elif base < 0 and onward == left:
            yield Binary("-", angle, Degrees(-base))
        elif base < 0:
            yield Binary("-", Negate(Degrees(-base)), angle)


def _with(
    first: Expression, second: Expression, turns: int, angle: Quantity, sign: int
) -> Iterator[Expression]:
    """One direction less another one, or its rest of 180°, with an angle added or taken away."""
    op: Literal["+", "-"] = "+" if sign == 1 else "-"
    if isinstance(first, Degrees) and isinstance(second, Degrees):
        whole = first.value - second.value + 180 * turns
        if whole > 0:
            yield Binary(op, Degrees(whole), angle)
            if sign == 1:
                yield Binary("+", angle, Degrees(whole))
        elif sign == 1:
            yield Binary("-", angle, Degrees(-whole)) if whole else angle
        return
    if turns:
        return
    zero = Degrees(Fraction(0))
    if second == zero:
        yield Binary(op, first, angle)
    elif first == zero and sign == 1:
        yield Binary("-", angle, second)


def _is_up_to_a_right_angle(
    step: Step, tree: Expression, values: dict[Expression, Expression]
) -> bool:
    """Whether an angle is one that a path makes with a wall, with values for what is in it."""
    own = step.world.scalar(exchanged(tree, values))
    size = step.world.expression(own, step.setting.roles)
    oracle = Oracle(step.setting.roles, step.given_inequalities)
    ends = compared(size, ">=", 0), compared(sp.pi / 2 - size, ">=", 0)
    return all(map(oracle.proves, ends))


def _is_up_to_a_straight_angle(
    step: Step, tree: Expression, values: dict[Expression, Expression]
) -> bool:
    """Whether an angle is one of a direction, with values for what is in it."""
    size = step.world.expression(step.world.scalar(exchanged(tree, values)), step.setting.roles)
    oracle = Oracle(step.setting.roles, step.given_inequalities)
    ends = compared(size + sp.pi, ">", 0), compared(sp.pi - size, ">=", 0)
    return all(map(oracle.proves, ends))


__all__ = ["from_a_wall", "made_of", "next_walls"]
