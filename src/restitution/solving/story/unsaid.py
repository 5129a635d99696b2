"""What a statement leaves out because it goes without saying, put in.

``u at alpha to W`` is from the left of W, unless the places say that the sphere is on its right.
Spheres that keep to their line of centres have the same one when they meet again. A direction that
a fact gives to a wall or to a line of centres belongs to these. A wall of which only angles to it
are told and asked may run along **i**.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.expression.evaluate import Evaluator, Symbolic
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Number,
    Polar,
    Unit,
)
from restitution.oracle import REAL, Oracle, compared
from restitution.problem import (
    Arrival,
    Event,
    Impact,
    Kick,
    Problem,
    Sphere,
    bodies_of,
)
from restitution.shapes import Line, Segment
from restitution.solving.story.given_directions import with_given_directions
from restitution.solving.story.letters import roles
from restitution.vector import Vector
from restitution.wording.scene import speaks_of_axes


def with_unsaid(problem: Problem) -> Problem:
    """The problem, with the sides of walls and the lines of centres that go without saying."""
    problem = _with_a_direction(with_given_directions(problem))
    spheres = tuple(_with_side(problem, sphere) for sphere in problem.spheres)
    lines = _lines_kept(problem)
    if spheres == problem.spheres and not lines:
        return problem
    parts = tuple(
        replace(part, steps=tuple(lines.get(id(step), step) for step in part.steps))
        for part in problem.parts
    )
    return replace(problem, spheres=spheres, parts=parts)


# --- a wall alone ---------------------------------------------------------------------------------


def _with_a_direction(problem: Problem) -> Problem:
    """The problem with its only wall along **i**, where all directions are told by that wall."""
    if len(problem.walls) != 1 or len(problem.spheres) != 1 or problem.points:
        return problem
    (wall,), (sphere,) = problem.walls, problem.spheres
    shape = wall.shape
    if not isinstance(shape, Line) or shape.along is not None or shape.is_placed:
        return problem
    match sphere.velocity:
        case Polar(wall=Name(name)) if name == wall.name and sphere.position is None:
            pass
        case _:
            return problem
    if speaks_of_axes(problem):
        return problem
    return replace(problem, walls=(replace(wall, along=Unit("i")),))


# --- sides ----------------------------------------------------------------------------------------


def _with_side(problem: Problem, sphere: Sphere) -> Sphere:
    """The sphere, with an angle from the direction of a wall on whose right it is."""
    match sphere.velocity:
        case Polar(size, angle, None, Name(name)) if sphere.position is not None:
            wall = next((wall for wall in problem.walls if wall.name == name), None)
        case _:
            return sphere
    shape = None if wall is None else wall.shape
    if not isinstance(shape, Line | Segment) or not shape.is_placed:
        return sphere
    try:
        along = _along(problem, shape)
        is_beyond = along is not None and _is_on_the_right(problem, sphere, shape, along)
    except RestitutionError:
        return sphere  # a place or a direction that follows from the motion
    if not is_beyond:
        return sphere
    return replace(sphere, velocity=Polar(size, angle, along, place=sphere.velocity.place))


def _along(problem: Problem, shape: Line | Segment) -> Expression | None:
    """The direction of a straight wall as a vector; None where it is not given."""
    if isinstance(shape, Segment):
        return Binary("-", shape.end, shape.start)
    if shape.along is None or isinstance(_evaluator(problem).value(shape.along), Vector):
        along: Expression | None = shape.along
        return along
    return Polar(Number(Fraction(1)), shape.along)


def _is_on_the_right(
    problem: Problem, sphere: Sphere, shape: Line | Segment, along: Expression
) -> bool:
    """Whether a sphere begins on the right of a wall, whatever the letters are."""
    evaluator = _evaluator(problem)
    side = evaluator.vector(along)
    gap = evaluator.vector(sphere.position) - evaluator.vector(shape.point)
    return Oracle(roles(problem)).proves(compared(side.x * gap.y, "<", side.y * gap.x))


# --- lines of centres -----------------------------------------------------------------------------


def _lines_kept(problem: Problem) -> dict[int, Impact]:
    """The impacts of spheres on the line of centres of their last one, with it, by identity."""
    lines: dict[int, Impact] = {}
    met: dict[frozenset[str], Expression] = {}
    events = problem.events
    for number, event in enumerate(events):
        if not isinstance(event, Impact) or event.second not in _names(problem):
            continue
        key = frozenset((event.first, event.second))
        if event.along is not None:
            met[key] = event.along
        elif event.offset is None and (
            along := _line_by_now(problem, key, met.get(key), events[:number], lines)
        ):
            lines[id(event)] = replace(event, along=along)
            met[key] = along
        else:
            met.pop(key, None)
    return lines


def _line_by_now(
    problem: Problem,
    key: frozenset[str],
    latest: Expression | None,
    events: Sequence[Event],
    lines: dict[int, Impact],
) -> Expression | None:
    """The line on which two spheres keep up to an event: that of their last one, or of places."""
    along = latest or _line_of_places(problem, key)
    before = [lines.get(id(event), event) for event in events]
    return along if along is not None and _is_kept(problem, key, along, before) else None


def _line_of_places(problem: Problem, key: frozenset[str]) -> Unit | None:
    """**i** or **j**, where both of two spheres begin on a line in that direction.

    None of spheres with radii, which say themselves where they touch.
    """
    bodies = [sphere for sphere in problem.spheres if sphere.name in key]
    if any(sphere.position is None or sphere.radius is not None for sphere in bodies):
        return None
    evaluator = _evaluator(problem)
    try:
        one, other = (evaluator.vector(sphere.position) for sphere in bodies)
    except RestitutionError:
        return None  # it follows from the motion
    gap = one - other
    if _is_zero(gap.y) != _is_zero(gap.x):
        return Unit("i" if _is_zero(gap.y) else "j")
    return None


def _names(problem: Problem) -> frozenset[str]:
    return frozenset(sphere.name for sphere in problem.spheres)


def _is_kept(
    problem: Problem, key: frozenset[str], along: Expression, events: Sequence[Event]
) -> bool:
    """Whether two spheres move, one relative to the other, along a line in some events.

    They do if they did so at the start and all that happened to them acts along that line.
    """
    bodies = [sphere for sphere in problem.spheres if sphere.name in key]
    if any(sphere.velocity is None for sphere in bodies):
        return False
    evaluator = _evaluator(problem)
    try:
        line = evaluator.direction(along)
        one, other = (evaluator.vector(sphere.velocity) for sphere in bodies)
        return _is_zero((one - other).cross(line)) and all(
            _acts_along(problem, event, line) for event in events if key & {*bodies_of(event)}
        )
    except RestitutionError:
        return False  # it follows from the motion


def _acts_along(problem: Problem, event: Event, line: Vector) -> bool:
    """Whether an event changes velocities along a line alone."""
    evaluator = _evaluator(problem)
    match event:
        case Arrival():
            return True
        case Kick():
            return _is_zero(evaluator.vector(event.impulse).cross(line))
        case Impact(second=name) if name in _names(problem):
            return event.along is not None and _is_zero(
                evaluator.direction(event.along).cross(line)
            )
        case Impact(second=name):
            wall = next(wall for wall in problem.walls if wall.name == name)
            shape = wall.shape
            along = _along(problem, shape) if isinstance(shape, Line | Segment) else None
            return along is not None and _is_zero(evaluator.vector(along).dot(line))


def _evaluator(problem: Problem) -> Evaluator:
    known = roles(problem)
    return Evaluator(Symbolic(), lambda name: known.get(name, REAL).symbol(name))


def _is_zero(x: object) -> bool:
    return bool(tidy(x) == 0)


__all__ = ["with_unsaid"]
