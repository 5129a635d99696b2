"""That a body comes to a straight wall: its component towards it before the impact.

Which way that is, the statement tells: by places, by an earlier impact with the same wall, or by
whom the body has just met on the normal of the wall, who would be there first on the other side.
"""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.data.arrangement import Arrangement
from restitution.explaining.data.one_line import side_along
from restitution.explaining.lines.derivation import FLIPPED, Link, Sign
from restitution.explaining.lines.quotients import NotComparableError
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
    side = side or _side_off_a_sphere(given, step.first, number, normal)
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


def _side_off_a_sphere(
    given: Arrangement, body: str, number: int, normal: Expression
) -> int | None:
    """1 where a normal leads away from whom a body has just met in a direct impact on it."""
    last = given.problem.events[number - 2] if number > 1 else None
    if not isinstance(last, Impact) or last.second in given.walls or last.along is None:
        return None
    if body not in (last.first, last.second) or not is_direct(given, number, normal):
        return None
    ahead = side_along(given, last, normal)
    return ahead if ahead is None or body == last.second else -ahead


def is_direct(given: Arrangement, number: int, normal: Expression) -> bool:
    """Whether all goes on along the normal of a wall in front of an event."""
    world = given.world()

    def is_along(tree: object) -> bool:
        try:
            axis = world.direction(normal)
            own = world.direction(tree) if isinstance(tree, Expression) else None
        except NotComparableError:
            return False
        if axis is None or own is None:
            return False
        return bool(world.reduced(own.x * axis.y - own.y * axis.x).vanishes)

    for sphere in given.problem.spheres:
        if not is_rest(sphere.velocity) and not is_along(sphere.velocity):
            return False
    for event, step in enumerate(given.problem.events[: number - 1], 1):
        if not isinstance(step, Impact):
            return False
        wall = step.second in given.walls
        if not is_along(given.into_the_wall(step, event) if wall else _line_of(given, step)):
            return False
    return True


def _line_of(given: Arrangement, step: Impact) -> Expression | None:
    """The line of centres of two spheres: as told, or as told when they met before."""
    pair = {step.first, step.second}
    earlier = given.problem.events[: given.problem.events.index(step) + 1]
    impacts = (other for other in reversed(earlier) if isinstance(other, Impact))
    same = (other for other in impacts if {other.first, other.second} == pair)
    return next((e.along for e in same if (e.along, e.offset) != (None, None)), None)
