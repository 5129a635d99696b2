"""That a body comes to a straight wall: its component towards it before the impact.

Which way that is, the statement tells: by places, by an earlier impact with the same wall, or by
whom the body has met on the normal of the wall, who would be there first on the other side.
"""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.data.arrangement import Arrangement
from restitution.explaining.data.one_line import side_along, side_by_neighbours
from restitution.explaining.lines.derivation import FLIPPED, Link, Sign
from restitution.expression.tree import (
    Expression,
    Name,
    Negate,
    Number,
    Quantity,
    Unit,
    is_rest,
)
from restitution.problem import Impact
from restitution.shapes import Circle


def coming_to_wall(given: Arrangement, step: Impact, number: int) -> Link | None:
    """That the component of a velocity before an event is positive towards a straight wall.

    It is only not zero where no side is told, and None where it is plain of itself. The velocity is
    without a stage.
    """
    wall = given.walls[step.second]
    normal = None if isinstance(wall.shape, Circle) else given.into_the_wall(step, number)
    if normal is None or given.is_towards(step, number):
        return None
    side = 1 if given.is_towards(step, number) is False else None
    side = side or given.side_of_wall(step.first, wall, normal)
    side = side or _side_of_an_earlier_impact(given, step, number, normal)
    side = side or side_by_neighbours(given, step, number, normal)
    sign: Sign = "!=" if side is None else ">" if side > 0 else "<"
    axis: Expression = Quantity("line_of_centres", (), number)
    if isinstance(normal, Unit):
        axis = normal
    elif isinstance(normal, Negate) and isinstance(normal.operand, Unit):
        axis, sign = normal.operand, FLIPPED.get(sign, sign)
    velocity = Quantity("velocity", (Name(step.first),), None)
    return Link(Quantity("along", (velocity, axis)), sign, Number(Fraction(0)))


def _side_of_an_earlier_impact(
    given: Arrangement, step: Impact, number: int, normal: Expression
) -> int | None:
    """1 where a body came to the same wall in the direction of a normal before, −1 against it.

    It is that body, or one that has met it: no sphere passes a straight wall.
    """
    together = {step.first}
    for earlier in reversed(given.events[: number - 1]):
        spheres = set() if earlier.wall else set(earlier.bodies)
        together |= spheres if spheres & together else set()
    for event, other in enumerate(given.problem.events[: number - 1], 1):
        if not isinstance(other, Impact) or other.second != step.second:
            continue
        if other.first in together:
            if given.is_towards(other, event) is not None:
                return 1 if given.into_the_wall(other, event) == normal else -1
            return _side_from_rest(given, other.first, event, normal)
    return None


def _side_from_rest(given: Arrangement, body: str, number: int, normal: Expression) -> int | None:
    """1 where a body was set going in the direction of a normal by the one impact before, or −1."""
    own = [n for n, event in enumerate(given.events[: number - 1], 1) if body in event.bodies]
    step = given.problem.events[own[0] - 1] if len(own) == 1 else None
    if not is_rest(given.sphere(body).velocity) or not isinstance(step, Impact):
        return None
    side = None if step.along is None else side_along(given, step, normal)
    return side if side is None or body == step.second else -side
