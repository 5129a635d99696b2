"""The order of bodies on a line to which they keep: spheres pass neither each other nor a wall.

Bodies in contact stand next to each other. Where they keep to one line their order never changes,
so each has one neighbour, at most, on each of its two sides. Where places are given they tell all
of this; where there are none, what met before does.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from restitution.errors import ImpossibleError
from restitution.expression.evaluate import Scalar
from restitution.expression.tree import line_and_column
from restitution.problem import Impact
from restitution.shapes import Circle, Line
from restitution.solving.algebra.neat import neat
from restitution.solving.story.conditions import Condition
from restitution.solving.story.happenings import Happening
from restitution.solving.story.state import State
from restitution.vector import Vector


def same_line(state: State, a: Vector, b: Vector) -> bool:
    """Whether two vectors lie along one line."""
    return _vanishes(state, a.cross(b))


def order_kept(
    state: State, number: int, step: Impact, c: Vector, approach: Vector
) -> Iterator[Condition]:
    """Bodies that meet for the first time do so on sides on which neither has met another one.

    ``c`` is along their line of centres, and ``approach`` their velocity of approach. Where bodies
    in between have met both, no condition is ever satisfied.
    """
    pair = step.first, step.second
    if pair in state.contact_lines:
        return
    ends = [name for name in pair if name in state.spheres]
    for name, sense in zip(ends, (-1, 1), strict=False):
        (other,) = set(pair) - {name}
        for event, neighbour in _contacts(state, name, c):
            names = (name, other, neighbour)
            if neighbour == other or not _keep_to(state, names, c, event, number):
                continue
            reason = f"{neighbour}, which {name} has met, would be between {name} and {other}"
            if _linked(state, neighbour, other, {name}, c, number):
                side = -state.field.number(Fraction(1))
            else:
                side = state.rational(approach.dot(_towards(event, neighbour)) * sense)
            if state.of_statement and side.is_negative:
                raise ImpossibleError(reason, *line_and_column(step.place))
            yield Condition(side, ">", reason, "approach")


def _contacts(state: State, name: str, c: Vector) -> Iterator[tuple[Happening, str]]:
    """The latest impact of a body with each other one along a line, with the name of the other."""
    seen: set[str] = set()
    for event in reversed(state.happenings):
        if name not in event.bodies or len(event.bodies) < 2:
            continue
        (other,) = set(event.bodies) - {name}
        wall = state.walls.get(other)
        if other in seen or (wall is not None and isinstance(wall.shape, Circle)):
            continue
        seen.add(other)
        if event.centres is None or event.unknown_line or event.altered:
            continue
        if same_line(state, event.centres, c):
            yield event, other


def _towards(event: Happening, body: str) -> Vector:
    """A vector to a body from the other one of an impact."""
    return event.oriented() if body == event.bodies[1] else -event.oriented()


def _keep_to(
    state: State, names: tuple[str, ...], c: Vector, event: Happening, number: int
) -> bool:
    """Whether bodies have not moved across a line, one relative to another, since an impact."""
    across: list[Scalar] = []
    for name in names:
        if name in state.spheres:
            stages = range(event.number - 1, number)
            across += [state.velocity(name, stage).cross(c) for stage in stages]
        elif not isinstance(state.walls[name].shape, Line):
            across.append(state.field.zero)
    return all(_vanishes(state, value - across[0]) for value in across[1:])


def _linked(state: State, start: str, end: str, passed: set[str], c: Vector, number: int) -> bool:
    """Whether spheres that met each other along a line lead from one to another body."""
    if start not in state.spheres:
        return False
    for event, other in _contacts(state, start, c):
        if other in passed or not _keep_to(state, (start, other), c, event, number):
            continue
        if other == end or _linked(state, other, end, {*passed, start}, c, number):
            return True
    return False


def _vanishes(state: State, value: Scalar) -> bool:
    return state.field.is_zero(neat(value) if state.field.exact else value)
