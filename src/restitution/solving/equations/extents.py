"""Between which bounds an angle lies that is compared, so that a sine may tell which is larger."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
)
from restitution.solving.story.forward import Story
from restitution.solving.story.unknowns import Letters

Extent = tuple[Fraction, Fraction]
"""The least and the greatest value of an angle, in degrees."""

_NOTHING = (Fraction(0), Fraction(0))
_RIGHT_ANGLE = (Fraction(0), Fraction(90))
_HALF_TURN = (Fraction(0), Fraction(180))


def within_a_half_turn(story: Story, left: Expression, right: Expression, now: int) -> bool:
    """Whether two angles certainly differ by 180° at most."""
    gap = _difference(_extent(story, left, now), _extent(story, right, now))
    return gap is not None and gap[0] >= -180 and gap[1] <= 180


def _extent(story: Story, tree: Expression, now: int) -> Extent | None:
    """The bounds of an angle; None where they are not known."""
    match tree:
        case Degrees(degrees):
            return degrees, degrees
        case Number(number) if number == 0:
            return _NOTHING
        case Letter(name) if name in story.lets:
            let, then = story.lets[name]
            return _extent(story, let.expression, then)
        case Letter(name):
            return _of_letter(story, name)
        case Quantity("angle", sides) if any(_is_line(story, side) for side in sides):
            return _RIGHT_ANGLE
        case Quantity(kind) if kind in UNSIGNED_ANGLES:
            return _HALF_TURN
        case Quantity("direction", (Name(body), *_)) if body in story.spheres:
            sign = story.sign(story.evaluator(now).value(tree).y)
            return (Fraction(-180 if sign in (-1, None) else 0), Fraction(0 if sign == -1 else 180))
        case Negate(operand):
            return _difference(_NOTHING, _extent(story, operand, now))
        case Binary("-", left, right):
            return _difference(_extent(story, left, now), _extent(story, right, now))
        case Binary("+", left, right):
            turned = _difference(_NOTHING, _extent(story, right, now))
            return _difference(_extent(story, left, now), turned)
        case Binary("*", Number(factor), angle) | Binary("*", angle, Number(factor)):
            return _scaled(_extent(story, angle, now), factor)
        case Binary("/", angle, Number(divisor)) if divisor:
            return _scaled(_extent(story, angle, now), 1 / divisor)
    return None


def _is_line(story: Story, tree: Expression) -> bool:
    """Whether an angle to it is one of at most 90°: a wall, or a line of centres."""
    match tree:
        case Name(name):
            return name in story.walls
        case Quantity("line_of_centres"):
            return True
    return False


def _scaled(own: Extent | None, factor: Fraction) -> Extent | None:
    if own is None:
        return None
    ends = (own[0] * factor, own[1] * factor)
    return min(ends), max(ends)


def _of_letter(story: Story, name: str) -> Extent | None:
    """The range of a letter for an angle."""
    if not isinstance(story.unknowns, Letters):
        return None
    role = story.unknowns.roles.get(name)
    if role is None or role.kind != "angle" or role.low is None or role.high is None:
        return None
    low, high = sp.deg(role.low), sp.deg(role.high)
    if not (low.is_Rational and high.is_Rational):
        return None
    return Fraction(int(low.p), int(low.q)), Fraction(int(high.p), int(high.q))


def _difference(one: Extent | None, other: Extent | None) -> Extent | None:
    return None if one is None or other is None else (one[0] - other[1], one[1] - other[0])
