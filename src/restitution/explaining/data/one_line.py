"""Lines of centres that the data tell: the axis on which all lie, and the direction of a path."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from restitution.explaining.data.arrangement import Arrangement, difference, world_of
from restitution.explaining.data.paths_and_lines import in_degrees, turn_of_vector
from restitution.explaining.lines.quotients import NotComparableError, Plane
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Pair,
    Quantity,
    Unit,
    is_rest,
    is_zero,
)
from restitution.problem import Arrival, Impact, Kick, Problem, Sphere, Step


def axis_of_all(given: Arrangement) -> Unit | None:
    """**i** or **j**, where all spheres lie and move along it; None where they do not.

    Walls that are struck are at right angles to it, and nothing else sets a sphere going.
    """
    problem = given.problem
    places = [sphere.position for sphere in problem.spheres]
    pairs = [place for place in places if isinstance(place, Pair)]
    if not pairs or len(pairs) < len(places):
        return None
    if any(isinstance(step, Kick | Arrival) for step in problem.events):
        return None
    for axis in (Unit("i"), Unit("j")):
        level = [pair.y if axis == Unit("i") else pair.x for pair in pairs]
        if not all(is_zero(difference(tree, level[0])) for tree in level):
            continue
        moving = all(_moves_along(given, sphere, axis) for sphere in problem.spheres)
        if moving and all(_is_struck_straight(given, step, axis) for step in problem.events):
            return axis
    return None


def _moves_along(given: Arrangement, sphere: Sphere, axis: Unit) -> bool:
    """Whether a velocity at the start is told, and is along an axis."""
    if is_rest(sphere.velocity):
        return True
    if not isinstance(sphere.velocity, Expression):
        return False
    try:
        value = world_of(given.problem).value(sphere.velocity)
    except NotComparableError:
        return False
    return isinstance(value, Plane) and (value.y if axis == Unit("i") else value.x).vanishes


def _is_struck_straight(given: Arrangement, step: object, axis: Unit) -> bool:
    """Whether an impact is along an axis, as far as it is told."""
    if not isinstance(step, Impact) or step.offset is not None:
        return False
    wall = given.walls.get(step.second)
    if wall is None:
        return step.along in (None, axis, Negate(axis))
    return given.along_of(wall) == Unit("j" if axis == Unit("i") else "i")


def side_along(given: Arrangement, step: Impact, axis: Expression) -> int | None:
    """On which side along a line of centres the second sphere is of the first; None if it is open.

    It is told by their places at the start, or by how they approach where they have not met yet.
    Who met before stays in order, and on one line has others on the other side.
    """
    one, other = (given.sphere(name) for name in (step.first, step.second))
    places = [sphere.position for sphere in (one, other) if isinstance(sphere.position, Pair)]
    if len(places) == 1:
        return None
    if places:
        displacement = Pair(
            difference(places[1].x, places[0].x), difference(places[1].y, places[0].y)
        )
        side = given.sign(Quantity("dot", (displacement, axis)))
        if side is not None:
            return side
    before = given.problem.events.index(step)
    for met in given.problem.events[:before]:
        if not isinstance(met, Impact) or not {met.first, met.second} & {one.name, other.name}:
            continue
        if {met.first, met.second} != {one.name, other.name}:
            return side_by_neighbours(given, step, before + 1, axis)
        side = side_along(given, met, axis)
        return side if side is None or met.first == one.name else -side
    return given.approach(one, other, axis)


def side_by_neighbours(
    given: Arrangement, step: Impact, number: int, axis: Expression
) -> int | None:
    """On which side along an axis the second body of an event is of the first, by whom they met.

    Where all move along the axis, who meet stand next to each other, and go on to do so: a body has
    one neighbour on each side. None where it is open.
    """
    if not is_direct(given, number, axis):
        return None
    pair = {step.first, step.second}
    for event, met in enumerate(given.problem.events[: number - 1], 1):
        if not isinstance(met, Impact):
            continue
        those = {met.first, met.second}
        for body in (those & pair) - given.walls.keys():
            side = _side_of_second(given, met, event, axis)
            if side is not None:
                outwards = (body == met.first) == (body == step.first)
                return side if outwards == (those == pair) else -side
    return None


def _side_of_second(given: Arrangement, step: Impact, number: int, axis: Expression) -> int | None:
    """On which side along an axis the second body of an event is of the first; None if open."""
    if step.second not in given.walls:
        return side_along(given, step, axis)
    normal = given.into_the_wall(step, number)
    if normal is None or given.is_towards(step, number) is None:
        return side_by_neighbours(given, step, number, axis)
    return given.sign(Quantity("dot", (normal, axis)))


def is_direct(given: Arrangement, number: int, axis: Expression) -> bool:
    """Whether all goes on along an axis before an event: velocities, and what is struck."""
    world = given.world()

    def is_along(tree: object) -> bool:
        try:
            own = world.direction(axis)
            line = world.direction(tree) if isinstance(tree, Expression) else None
        except NotComparableError:
            return False
        if own is None or line is None:
            return False
        return bool(world.reduced(line.x * own.y - line.y * own.x).vanishes)

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


def with_lines_of_centres(given: Arrangement) -> Problem:
    """The problem in which each line of centres that the data tell has its own direction.

    Spheres that lie on one axis have that where none is given, and it leads from the first to the
    second: they stay in their order. One along a velocity of the data has its direction.
    """
    problem = given.problem
    steps = [step for step in problem.events if isinstance(step, Impact)]
    open_ = [step for step in steps if step.along is None and step.second not in given.walls]
    axis = axis_of_all(given) if open_ else None

    def with_its_line(step: Step, number: int) -> Step:
        if not isinstance(step, Impact):
            return step
        if isinstance(step.along, Quantity):
            return replace(step, along=_settled(given, step.along, number))
        if (square := _axis_at(step.along)) is not None:
            return replace(step, along=square)
        side = side_along(given, step, axis) if step in open_ and axis is not None else None
        if side is None or axis is None:
            return step
        return replace(step, along=axis if side > 0 else Negate(axis))

    number, parts = 0, []
    for part in problem.parts:
        own: list[Step] = []
        for step in part.steps:
            number += isinstance(step, Impact | Kick | Arrival)
            own.append(with_its_line(step, number))
        parts.append(replace(part, steps=tuple(own)))
    return replace(problem, parts=tuple(parts))


def _axis_at(angle: Expression | None) -> Expression | None:
    """**i** or **j**, or the opposite, of an angle that is a multiple of 90°; None of any other."""
    turn = None if angle is None else in_degrees(angle)
    if turn is None or turn % 90:
        return None
    axis = Unit("j" if turn % 180 else "i")
    return axis if turn % 360 in (0, 90) else Negate(axis)


def _settled(given: Arrangement, line: Quantity, number: int) -> Expression:
    """The direction of a line of centres along a velocity before an event.

    That of a velocity of the data is told by these: by its angle, or as a vector of whole numbers.
    """
    match line:
        case Quantity("velocity", (Name(body),), None | int() as stage):
            stage = given.latest([body], number - 1 if stage is None else stage)
        case _:
            return line
    own = given.sphere(body).velocity
    if stage or not isinstance(own, Expression):
        return replace(line, stage=stage)
    axis = given.axis_of(own)
    turn = turn_of_vector(own) if axis is None else axis
    return turn or _whole_vector(given, own) or own


def _whole_vector(given: Arrangement, velocity: Expression) -> Expression | None:
    """The vector of whole numbers of which a velocity is a multiple; None where there is none."""
    try:
        value = world_of(given.problem).value(velocity)
    except NotComparableError:
        return None
    if not isinstance(value, Plane) or value.x.vanishes or value.y.vanishes:
        return None
    ratio = value.x / value.y
    if not (ratio.above.is_ground and ratio.below.is_ground):
        return None
    number = ratio.above.LC / ratio.below.LC
    side = -1 if value.y.above.LC / value.y.below.LC < 0 else 1
    x, y = side * int(number.numerator), int(number.denominator)
    return Binary("+" if side > 0 else "-", _multiple(x, Unit("i")), _multiple(y, Unit("j")))


def _multiple(number: int, unit: Unit) -> Expression:
    """A whole number times a unit vector, as people type it."""
    if number < 0:
        return Negate(_multiple(-number, unit))
    return unit if number == 1 else Binary("*", Number(Fraction(number)), unit)


__all__ = ["axis_of_all", "with_lines_of_centres"]
