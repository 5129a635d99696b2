"""Angles between directions that are told by angles: velocities along lines of centres, axes."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from restitution.explaining.definitions.senses import oriented
from restitution.explaining.lines.derivation import Link
from restitution.explaining.lines.quotients import Plane, Quotient
from restitution.explaining.lines.trees import exchanged
from restitution.explaining.moves.angles import in_radians
from restitution.explaining.moves.laws import stands
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
    walk,
)
from restitution.oracle import Oracle
from restitution.oracle import Relation as Claim


def is_angle_of_lines(step: Step, line: Link) -> bool:
    """Whether an angle is the difference of two directions that are told by their angles.

    A velocity has the direction of its line of centres where it is seen to point along that. A wall
    points both ways, as the next line of centres does, and makes an acute angle.
    """
    match line:
        case Link(Quantity("angle", (one, other)), "=", right):
            pass
        case _:
            return False
    for moving, fixed in ((one, other), (other, one)):
        match moving:
            case Quantity("velocity", (Name() as body,), int(stage)):
                direction = Quantity("direction", (body,), stage)
            case _:
                continue
        event = step.setting.event(stage)
        for turn, both_ways in _turns(step, fixed):
            if not _is_within(step, right, both_ways=both_ways):
                continue
            for sign in ("+", "-"):
                if stands(step, Link(direction, "=", Binary(sign, turn, right)), event):
                    return True
    return False


def is_angle_of_a_multiple(step: Step, line: Link) -> bool:
    """Whether two vectors are in one direction, or opposite, as one is a multiple of the other."""
    match line:
        case Link(Quantity("angle", (one, other)), "=", Degrees(size)) if size in (0, 180):
            pass
        case _:
            return False
    for link in step.links:
        if link.sign != "=" or link.left not in (one, other):
            continue
        vector = other if link.left == one else one
        factor = step.world.value(exchanged(link.right, {vector: Unit("i")}))
        if vector in set(walk(link.right)) and isinstance(factor, Plane) and factor.y.vanishes:
            return oriented(step, factor.x) == (1 if size == 0 else -1)
    return False


def is_tangent_of_a_line(step: Step, line: Link) -> bool:
    """Whether a tangent is the slope of a vector to which a line at that angle from **i** is."""
    match line:
        case Link(Apply("tan", Letter() as angle), "=", right):
            pass
        case _:
            return False
    ties = [link for link in step.links if link.sign == "parallel to"]
    for one in ties:
        for other in ties:
            if one.right != angle or other.left != one.left or other.right == angle:
                continue
            along = step.world.value(other.right)
            if not isinstance(along, Plane) or along.x.vanishes:
                continue
            value = step.world.value(right)
            if isinstance(value, Quotient):
                return step.world.reduced(value * along.x - along.y).vanishes
    return False


def _turns(step: Step, tree: Expression) -> Iterator[tuple[Expression, bool]]:
    """The angles from **i** at which a direction is, and whether it points both ways."""
    match tree:
        case Unit(axis):
            yield Degrees(Fraction(90 if axis == "j" else 0)), False
        case Name():
            for link in step.links:
                if link.left == Quantity("direction", (tree,)):
                    for turn in _angles(link.right):
                        yield turn, True
                        yield Binary("+", turn, STRAIGHT_ANGLE), True
        case Quantity("line_of_centres"):
            for link in step.links:
                if link.left == tree:
                    for turn in _angles(link.right):
                        yield turn, True
                        yield Binary("+", turn, STRAIGHT_ANGLE), True
        case Quantity("velocity", (Name() as body,), int(stage)):
            direction = Quantity("direction", (body,), stage)
            for link in step.links:
                if link.left == tree and link.sign == "=":
                    for turn in _angles_of_a_vector(step, link.right):
                        yield turn, False
                if link.left == Quantity("line_of_centres", (), stage):
                    for turn in _angles(link.right):
                        own = Link(direction, "=", turn)
                        if stands(step, own, step.setting.event(stage)):
                            yield turn, False


def _angles(tree: Expression) -> Iterator[Expression]:
    """The angle from **i** of a direction that an angle, or an axis, tells."""
    match tree:
        case Unit(axis):
            yield Degrees(Fraction(90 if axis == "j" else 0))
        case Degrees() | Letter() | Negate(Degrees() | Letter()):
            yield tree


def _angles_of_a_vector(step: Step, tree: Expression) -> Iterator[Expression]:
    """The angle from **i** of a vector along **i** or **j**."""
    value = step.world.value(tree)
    if isinstance(value, Plane):
        for own, other, turn in ((value.x, value.y, 0), (value.y, value.x, 90)):
            sign = step.signs.of(own, sure=True) if other.vanishes else None
            if sign:
                yield Degrees(Fraction(turn if sign > 0 else turn + 180))


def _is_within(step: Step, angle: Expression, *, both_ways: bool) -> bool:
    """Whether what is said to be an angle between two directions is one."""
    value = in_radians(step, angle)
    oracle = Oracle(step.setting.roles)
    most = sp.pi / 2 if both_ways else sp.pi
    return oracle.proves(Claim(value, ">=")) and oracle.proves(Claim(most - value, ">="))


__all__ = ["is_angle_of_lines", "is_tangent_of_a_line"]
