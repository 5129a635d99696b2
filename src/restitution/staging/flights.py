"""When and where the events of a story happen, in numbers: the pieces of all paths together.

Between events a sphere moves along a straight line whose direction the solution knows. Where each
event happens is, all velocities being numbers, linear in the starting places, the times and the
places of the walls: what the statement says of places are equations, and what it leaves open is
chosen so that the pieces of the paths have readable lengths. So paths join, bodies that meet do so
at one time, and walls stand where they are struck, whether places are given or not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Any, Literal

import numpy as np

from restitution.expression.tree import Name
from restitution.problem import Arrival, Impact, Kick
from restitution.records import dataclass
from restitution.shapes import Circle, Line, Segment
from restitution.solving.story.forward import Story
from restitution.solving.story.happenings import Happening
from restitution.staging.geometry import floats, length, still, unit
from restitution.vector import Vector

# --- the events in floats -------------------------------------------------------------------------


@dataclass(frozen=True)
class Move:
    """An event: who takes part, how they move, and what it says of their places."""

    number: int
    kind: Literal["wall", "circle", "spheres", "kick", "arrival"]
    bodies: tuple[str, ...]
    before: Mapping[str, Vector]
    after: Mapping[str, Vector]
    wall: str | None = None
    normal: Vector | None = None
    place: Vector | None = None  # where the first body is, if that is known beforehand


def events(story: Story) -> list[Move]:
    """The events of a story in floats."""
    return [_move(story, happening) for happening in story.happenings]


def _move(story: Story, event: Happening) -> Move:
    step = event.step
    names = tuple(name for name in event.bodies if name in story.spheres)
    before = {name: floats(event.before[name]) for name in names}
    after = {name: floats(event.after[name]) for name in names}
    if isinstance(step, Kick):
        return Move(event.number, "kick", names, before, after)
    if isinstance(step, Arrival):
        target = step.target
        if not (isinstance(target, Name) and target.name in story.walls):
            place = floats(story.evaluator(event.number - 1).vector(target))
            return Move(event.number, "arrival", names, before, after, place=place)
        wall = story.walls[target.name]
        if isinstance(wall.shape, Circle):
            into, at = _on_circle(story, event, wall.name, None)
            return Move(event.number, "arrival", names, before, after, wall.name, into, at)
        into = unit(floats(story.wall_direction(target)).turned_left())
        into = -into if into.dot(before[names[0]]) < 0 else into
        return Move(event.number, "arrival", names, before, after, wall.name, into)
    assert isinstance(step, Impact)
    normal = unit(floats(event.oriented()))
    if step.second not in story.walls:
        return Move(event.number, "spheres", names, before, after, normal=normal)
    wall = story.walls[step.second]
    if not isinstance(wall.shape, Circle):
        return Move(event.number, "wall", names, before, after, wall.name, normal)
    normal, place = _on_circle(story, event, wall.name, normal)
    return Move(event.number, "circle", names, before, after, wall.name, normal, place)


def _on_circle(
    story: Story, event: Happening, wall: str, normal: Vector | None
) -> tuple[Vector, Vector]:
    """The normal into a circular wall, and where the centre of the sphere is."""
    name = event.bodies[0]
    circle = story.circle(wall)
    centre, size = floats(circle.centre), float(circle.radius)
    known = story.tracks[name].places
    if known and known[-1][1] is not None:
        where = next((floats(p) for n, p, _ in known if n == event.number and p is not None), None)
        if where is not None:
            out = unit(where - centre)
            into = normal if normal is not None else floats(event.before[name])
            return (out if out.dot(into) > 0 else -out), where
    assert normal is not None
    radius = story.radius(name)
    return normal, centre + normal * (size - (0.0 if radius is None else float(radius)))


# --- places that are given ------------------------------------------------------------------------


@dataclass(frozen=True)
class Given:
    """What a statement says of places, in its own units."""

    starts: Mapping[str, Vector]
    origins: Mapping[str, Vector]  # a point of every straight wall that has a place
    segments: Mapping[str, tuple[Vector, Vector]]
    circles: Mapping[str, tuple[Vector, float]]
    points: Mapping[str, Vector]
    radius: float | None
    reached: bool  # whether a point that is given is one of them

    @property
    def placed(self) -> bool:
        """Whether a length follows from what is given: one place alone is nowhere."""
        places = set(self.origins.values())
        return bool(self.starts or self.segments or self.circles or self.reached or len(places) > 1)


def given_places(story: Story) -> Given:
    """The places that a statement gives."""
    starts, origins, segments, circles = {}, {}, {}, {}
    for name, sphere in story.spheres.items():
        if sphere.position is not None:
            starts[name] = floats(story.read_vector(sphere.position, ""))
    for name in story.walls:
        match story.shape(name):
            case Circle(centre, size):
                circles[name] = floats(centre), float(size)
            case Segment(start, end):
                segments[name] = floats(start), floats(end)
                origins[name] = segments[name][0]
            case Line(_, Vector() as through):
                origins[name] = floats(through)
    points = {
        name: floats(story.evaluator(0).vector(point.position))
        for name, point in story.points.items()
    }
    radius = next((s.radius for s in story.spheres.values() if s.radius is not None), None)
    size = None if radius is None else float(story.read(radius, ""))
    reached = any(
        isinstance(event.step, Arrival)
        and not (isinstance(event.step.target, Name) and event.step.target.name in story.walls)
        for event in story.happenings
    )
    return Given(starts, origins, segments, circles, points, size, reached)


# --- places as linear expressions -----------------------------------------------------------------


@dataclass
class Layout:
    """The unknown places and times, what is known of them, and the pieces whose length is free.

    A row of ``rows`` times the unknowns is the entry of ``values``. ``where`` gives the place of a
    body at an event, and ``lengths`` how long each flight is, as coefficients and a constant;
    ``times`` has when each event is, as coefficients.
    """

    count: int
    rows: list[Any] = field(default_factory=list)
    values: list[float] = field(default_factory=list)
    where: dict[tuple[str, int], tuple[Any, Any]] = field(default_factory=dict)
    times: dict[int, Any] = field(default_factory=dict)
    lengths: list[tuple[Any, float]] = field(default_factory=list)
    order: list[tuple[Any, float]] = field(default_factory=list)

    def fix(self, coefficients: Any, value: float) -> None:
        self.rows.append(coefficients)
        self.values.append(value)


def unknowns(
    story: Story,
    moves: Sequence[Move],
    starts: Mapping[str, Vector],
    origins: Mapping[str, Vector],
    radius: float,
) -> Layout:
    """What the story says of places; ``starts`` and ``origins`` are those given."""
    bodies = list(dict.fromkeys(name for move in moves for name in move.bodies))
    free_walls = list(
        dict.fromkeys(m.wall for m in moves if m.wall and m.place is None and m.wall not in origins)
    )
    count = 2 * len(bodies) + len(moves) + len(free_walls)
    layout = Layout(count)
    speed = max(length(v) for m in moves for v in (*m.before.values(), *m.after.values()))
    normals: dict[str, Vector] = {}

    order = {move.number: k for k, move in enumerate(moves)}

    def time(number: int) -> Any:
        row = np.zeros(count)
        if number:
            row[2 * len(bodies) + order[number]] = 1 / speed
        return row

    layout.times = {move.number: time(move.number) for move in moves}
    for index, body in enumerate(bodies):
        known = starts.get(body)
        latest, place, constant = 0, np.zeros((2, count)), np.zeros(2)
        if known is None:
            place[0, 2 * index] = place[1, 2 * index + 1] = 1
        else:
            constant = np.array([known.x, known.y])
        own = [move for move in moves if body in move.bodies]
        for move in own:
            velocity = move.before[body]
            if latest or known is not None:
                flight = time(move.number) - time(latest)
                place = place + np.outer([velocity.x, velocity.y], flight)
                if still(velocity):
                    layout.order.append((flight * speed, 0.0))
                else:
                    layout.lengths.append((flight * length(velocity), 0.0))
            layout.where[body, move.number] = place, constant
            latest = move.number
    for move in moves:
        place, constant = layout.where[move.bodies[0], move.number]
        if move.place is not None:
            for axis in (0, 1):
                layout.fix(place[axis], move.place[axis] - constant[axis])
        elif move.kind == "spheres":
            assert move.normal is not None
            other, beside = layout.where[move.bodies[1], move.number]
            for axis in (0, 1):
                apart = 2 * radius * move.normal[axis] + constant[axis] - beside[axis]
                layout.fix(other[axis] - place[axis], apart)
        elif move.wall is not None:
            assert move.normal is not None
            n = np.array(move.normal)
            row, value = n @ place, -radius - float(n @ constant)
            if move.wall in origins:
                value += move.normal.dot(origins[move.wall])
            else:
                normal = normals.setdefault(move.wall, move.normal)
                row = row.copy()
                row[2 * len(bodies) + len(moves) + free_walls.index(move.wall)] = -(
                    1.0 if normal.dot(move.normal) > 0 else -1.0
                )
            layout.fix(row, value)
    return layout


def solve(layout: Layout, targets: Sequence[float], shortest: float) -> Any | None:
    """Unknowns for which the flights are near their targets; None if one would go backwards.

    Projects in turn on what the story says and on what is readable.
    """
    if layout.rows:
        matrix, values = np.array(layout.rows), np.array(layout.values)
        left, sizes, right = np.linalg.svd(matrix)
        rank = int((sizes > 1e-9 * max(sizes[0], 1e-30)).sum())
        x0 = right[:rank].T @ ((left[:, :rank].T @ values) / sizes[:rank])
        if np.abs(matrix @ x0 - values).max(initial=0.0) > 1e-6 * (1 + np.abs(values).max()):
            return None
        free = right[rank:].T
    else:
        x0, free = np.zeros(layout.count), np.eye(layout.count)
    if not layout.lengths and not layout.order:
        return x0
    rows = np.array([row for row, _ in (*layout.lengths, *layout.order)])
    wanted = np.array([*targets, *([shortest] * len(layout.order))])
    low = np.array([shortest] * len(layout.lengths) + [0.0] * len(layout.order))
    if not free.size or np.abs(rows @ free).max() < 1e-12:
        lengths = rows @ x0
        return x0 if (lengths[: len(layout.lengths)] > -1e-9 * shortest).all() else None
    back = np.linalg.pinv(rows @ free, rcond=1e-9)
    for part in (1.0, 0.5, 0.2, 0.02):
        goal = wanted
        for _ in range(60):
            x = x0 + free @ (back @ (goal - rows @ x0))
            lengths = rows @ x
            if (lengths >= 0.98 * part * low - 1e-9).all():
                return x
            goal = np.maximum(lengths, part * low)
    return None
