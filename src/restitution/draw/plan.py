"""Where the bodies of a story lie on paper: the plan that a picture of paths is drawn from.

Between events a sphere moves along a straight line whose direction the solution knows. Where each
event happens is, all velocities being numbers, linear in the starting places, the times and the
places of the walls: what the statement says of places are equations, and what it leaves open is
chosen so that the pieces of the paths have readable lengths. So paths join, bodies that meet do so
at one time, and walls stand where they are struck, whether places are given or not.

Lengths and places are in millimetres on paper, x to the right and y up.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import Name
from restitution.problem import Arrival, Impact, Kick, Wall
from restitution.solve.story import Happening, Story
from restitution.vector import Vector

#: What the paths and walls may fill, leaving room for words beside them.
_WIDTH, _HEIGHT = 74.0, 52.0
# Readable lengths of the pieces of a path before the first event, between events, after the last.
_APPROACH, _FLIGHT, _EXIT = 22.0, 28.0, 18.0
_SHORTEST = 8.0
_LARGEST = 1.5  # times these, where there is room
# A sphere whose size is told or matters, where the scale is free.
_RADIUS = 2.6
# How far a wall goes on beyond the place where it is struck.
_BEYOND = 9.0
# Paths along one line are drawn so far apart: two of them, or more with words between.
_LANE, _WIDE_LANE = 2.2, 4.4
_CLOSE = 1e-6


@dataclass(frozen=True, slots=True)
class Leg:
    """A straight piece of the path of a centre: the one after event ``after`` (0 is the start).

    ``lane`` says how far it is drawn to the left of where it is, as other pieces lie there too.
    """

    body: str
    after: int
    kind: Literal["approach", "flight", "exit"]
    start: Vector
    end: Vector
    lane: float = 0.0

    @property
    def direction(self) -> Vector:
        """The unit vector along it."""
        return _unit(self.end - self.start)

    @property
    def shift(self) -> Vector:
        """How far it is drawn from where it is."""
        return self.direction.turned_left() * self.lane


@dataclass(frozen=True, slots=True)
class Stop:
    """An event and where it happens.

    ``normal`` is the unit vector from the first body to the second, or into the wall; ``contact``
    where they touch.
    """

    number: int
    kind: Literal["wall", "circle", "spheres", "kick", "arrival"]
    centres: Mapping[str, Vector]
    contact: Vector
    wall: str | None = None
    normal: Vector | None = None


@dataclass(frozen=True, slots=True)
class Straight:
    """A straight wall as drawn; ``corners`` are the walls that it meets at its start and end."""

    name: str
    start: Vector
    end: Vector
    far: Vector
    corners: tuple[str | None, str | None] = (None, None)
    fixed: bool = False


@dataclass(frozen=True, slots=True)
class Round:
    """A circular wall."""

    name: str
    centre: Vector
    radius: float
    inside: bool


@dataclass(frozen=True, slots=True)
class Plan:
    """A story on paper.

    ``scale`` is millimetres for a unit of length, or None where the statement gives no places.
    ``radius`` is that of the spheres, 0 where it is negligible.
    """

    legs: tuple[Leg, ...]
    stops: tuple[Stop, ...]
    starts: Mapping[str, Vector]
    walls: tuple[Straight, ...]
    rounds: tuple[Round, ...]
    points: Mapping[str, Vector]
    radius: float
    scale: float | None
    side_by_side: bool = False


# --- vectors in floats ----------------------------------------------------------------------------


def _floats(v: Any) -> Vector:
    return Vector(float(v[0]), float(v[1]))


def _size(v: Vector) -> float:
    return math.hypot(v.x, v.y)


def _unit(v: Vector) -> Vector:
    return v / (_size(v) or 1.0)


def _still(v: Vector) -> bool:
    return _size(v) < 1e-12


# --- the events in floats -------------------------------------------------------------------------


@dataclass(frozen=True)
class _Move:
    """An event: who takes part, how they move, and what it says of their places."""

    number: int
    kind: Literal["wall", "circle", "spheres", "kick", "arrival"]
    bodies: tuple[str, ...]
    before: Mapping[str, Vector]
    after: Mapping[str, Vector]
    wall: str | None = None
    normal: Vector | None = None
    place: Vector | None = None  # where the first body is, if that is known beforehand


def _moves(story: Story) -> list[_Move]:
    return [_move(story, each) for each in story.happenings]


def _move(story: Story, event: Happening) -> _Move:
    step = event.step
    names = tuple(name for name in event.bodies if name in story.spheres)
    before = {name: _floats(event.before[name]) for name in names}
    after = {name: _floats(event.after[name]) for name in names}
    if isinstance(step, Kick):
        return _Move(event.number, "kick", names, before, after)
    if isinstance(step, Arrival):
        target = step.target
        if not (isinstance(target, Name) and target.name in story.walls):
            place = _floats(story.evaluator(event.number - 1).vector(target))
            return _Move(event.number, "arrival", names, before, after, place=place)
        wall = story.walls[target.name]
        if wall.centre is not None:
            normal, place = _on_circle(story, event, wall, None)
        else:
            normal = _unit(_floats(story.wall_direction(target)).turned_left())
            normal, place = (-normal if normal.dot(before[names[0]]) < 0 else normal), None
        return _Move(event.number, "arrival", names, before, after, wall.name, normal, place)
    assert isinstance(step, Impact)
    normal = _unit(_floats(event.oriented()))
    if step.second not in story.walls:
        return _Move(event.number, "spheres", names, before, after, normal=normal)
    wall = story.walls[step.second]
    if wall.centre is None:
        return _Move(event.number, "wall", names, before, after, wall.name, normal)
    normal, place = _on_circle(story, event, wall, normal)
    return _Move(event.number, "circle", names, before, after, wall.name, normal, place)


def _on_circle(
    story: Story, event: Happening, wall: Wall, normal: Vector | None
) -> tuple[Vector, Vector]:
    """The normal into a circular wall, and where the centre of the sphere is."""
    name = event.bodies[0]
    centre, size = _floats(story.read_vector(wall.centre, "")), float(story.read(wall.radius, ""))
    known = story.tracks[name].places
    if known and known[-1][1] is not None:
        where = next((_floats(p) for n, p, _ in known if n == event.number and p is not None), None)
        if where is not None:
            out = _unit(where - centre)
            into = normal if normal is not None else _floats(event.before[name])
            return (out if out.dot(into) > 0 else -out), where
    assert normal is not None
    radius = story.radius(name)
    return normal, centre + normal * (size - (0.0 if radius is None else float(radius)))


# --- places as linear expressions -----------------------------------------------------------------


@dataclass
class _Layout:
    """The unknown places and times, what is known of them, and the pieces whose length is free.

    A row of ``rows`` times the unknowns is the entry of ``values``. ``where`` gives the place of a
    body at an event, and ``lengths`` how long each flight is, as coefficients and a constant.
    """

    count: int
    rows: list[Any] = field(default_factory=list)
    values: list[float] = field(default_factory=list)
    where: dict[tuple[str, int], tuple[Any, Any]] = field(default_factory=dict)
    lengths: list[tuple[Any, float]] = field(default_factory=list)
    order: list[tuple[Any, float]] = field(default_factory=list)

    def fix(self, coefficients: Any, value: float) -> None:
        self.rows.append(coefficients)
        self.values.append(value)


def _layout(
    story: Story,
    moves: Sequence[_Move],
    starts: Mapping[str, Vector],
    origins: Mapping[str, Vector],
    radius: float,
) -> _Layout:
    """What the story says of places; ``starts`` and ``origins`` are those given."""
    bodies = list(dict.fromkeys(name for move in moves for name in move.bodies))
    free_walls = list(
        dict.fromkeys(m.wall for m in moves if m.wall and m.place is None and m.wall not in origins)
    )
    count = 2 * len(bodies) + len(moves) + len(free_walls)
    made = _Layout(count)
    speed = max(_size(v) for m in moves for v in (*m.before.values(), *m.after.values()))
    normals: dict[str, Vector] = {}

    order = {move.number: k for k, move in enumerate(moves)}

    def time(number: int) -> Any:
        row = np.zeros(count)
        if number:
            row[2 * len(bodies) + order[number]] = 1 / speed
        return row

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
                if _still(velocity):
                    made.order.append((flight * speed, 0.0))
                else:
                    made.lengths.append((flight * _size(velocity), 0.0))
            made.where[body, move.number] = place, constant
            latest = move.number
    for move in moves:
        place, constant = made.where[move.bodies[0], move.number]
        if move.place is not None:
            for axis in (0, 1):
                made.fix(place[axis], move.place[axis] - constant[axis])
        elif move.kind == "spheres":
            assert move.normal is not None
            other, beside = made.where[move.bodies[1], move.number]
            for axis in (0, 1):
                apart = 2 * radius * move.normal[axis] + constant[axis] - beside[axis]
                made.fix(other[axis] - place[axis], apart)
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
            made.fix(row, value)
    return made


def _solve(made: _Layout, targets: Sequence[float], shortest: float) -> Any | None:
    """Unknowns for which the flights are near their targets; None if they cannot all be positive.

    Projects in turn on what the story says and on what is readable.
    """
    if made.rows:
        matrix, values = np.array(made.rows), np.array(made.values)
        left, sizes, right = np.linalg.svd(matrix)
        rank = int((sizes > 1e-9 * max(sizes[0], 1e-30)).sum())
        x0 = right[:rank].T @ ((left[:, :rank].T @ values) / sizes[:rank])
        if np.abs(matrix @ x0 - values).max(initial=0.0) > 1e-6 * (1 + np.abs(values).max()):
            return None
        free = right[rank:].T
    else:
        x0, free = np.zeros(made.count), np.eye(made.count)
    if not made.lengths and not made.order:
        return x0
    rows = np.array([row for row, _ in (*made.lengths, *made.order)])
    wanted = np.array([*targets, *([_SHORTEST] * len(made.order))])
    low = np.array([shortest] * len(made.lengths) + [0.0] * len(made.order))
    if not free.size or np.abs(rows @ free).max() < 1e-12:
        lengths = rows @ x0
        return x0 if (lengths[: len(made.lengths)] > 0).all() else None
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


# --- walls on paper -------------------------------------------------------------------------------


@dataclass
class _Line:
    """A straight wall while it is being drawn: places along it are counted from ``origin``."""

    name: str
    origin: Vector
    along: Vector
    near: Vector
    hits: list[float]
    low: float
    high: float
    placed: bool
    fixed: bool = False
    corners: dict[str, str] = field(default_factory=dict)

    def at(self, distance: float) -> Vector:
        return self.origin + self.along * distance

    def along_it(self, point: Vector) -> float:
        return float((point - self.origin).dot(self.along))

    def side(self, point: Vector) -> float:
        return float((point - self.origin).dot(self.near))


def _crossing(a: Vector, b: Vector, line: _Line) -> tuple[float, float] | None:
    """Where a segment meets the line of a wall: its share, and the place along the wall."""
    first, second = line.side(a), line.side(b)
    if abs(first - second) < 1e-9:
        return None
    share = first / (first - second)
    return share, line.along_it(a + (b - a) * share)


def _meeting_point(one: _Line, other: _Line) -> tuple[float, float] | None:
    """Where two lines meet, as places along each."""
    turn = one.along.cross(other.along)
    if abs(turn) < 0.05:
        return None
    way = other.origin - one.origin
    return way.cross(other.along) / turn, way.cross(one.along) / turn


def _share_a_letter(one: str, other: str) -> bool:
    return bool(set(_corner_letters(one)) & set(_corner_letters(other)))


def _corner_letters(name: str) -> tuple[str, ...]:
    """The A and B of a wall AB, whose ends they name; nothing for other names."""
    return tuple(name) if len(name) == 2 and name.isalpha() and name.isupper() else ()


def _trim(lines: list[_Line], legs: Sequence[Leg], reach: float, successive: set[Any]) -> int:
    """Lets walls end where they meet, and before a path that would cross them.

    Returns how many paths cross a wall all the same.
    """
    meetings: list[tuple[float, _Line, _Line, float, float]] = []
    for one, other in itertools.combinations(lines, 2):
        where = _meeting_point(one, other)
        wanted = (
            (one.placed and other.placed)
            or _share_a_letter(one.name, other.name)
            or frozenset((one.name, other.name)) in successive
        )
        if where is None or not wanted:
            continue
        gaps = [_gap(line, place) for line, place in zip((one, other), where, strict=True)]
        if None in gaps:
            continue
        if all(_clear(line, s, legs) for line, s in zip((one, other), where, strict=True)):
            meetings.append((max(gaps), one, other, *where))  # type: ignore[type-var]
    for gap, one, other, first, second in sorted(meetings, key=lambda each: each[0]):
        sides = [_side_of(line, s) for line, s in ((one, first), (other, second))]
        if gap > reach or sides[0] in one.corners or sides[1] in other.corners:
            continue
        for line, s, side, beside in (
            (one, first, sides[0], other),
            (other, second, sides[1], one),
        ):
            line.corners[side] = beside.name
            if not line.fixed:
                setattr(line, side, s)
    for line, other in itertools.permutations(lines, 2):
        where = _meeting_point(line, other)
        if where is None or line.fixed:
            continue
        s, t = where
        if other.low - _CLOSE < t < other.high + _CLOSE:
            for side, sign in (("high", 1), ("low", -1)):
                beyond = sign * (s - max((sign * h for h in line.hits), default=-math.inf) * sign)
                if side not in line.corners and beyond > 0 and sign * (getattr(line, side) - s) > 0:
                    setattr(line, side, s - sign * 1.5)
    bad = 0
    for line in lines:
        for leg in legs:
            met = _crossing(leg.start, leg.end, line)
            if met is None or not 0.001 < met[0] < 0.999:
                continue
            s = met[1]
            if line.fixed or not line.low - 2 < s < line.high + 2:
                bad += line.low < s < line.high
            elif line.hits and s > max(line.hits) + 3:
                line.high = s - 2
                line.corners.pop("high", None)
            elif line.hits and s < min(line.hits) - 3:
                line.low = s + 2
                line.corners.pop("low", None)
            else:
                bad += 1
    return bad


def _gap(line: _Line, s: float) -> float | None:
    """How far a corner is from where the wall is struck; None where it lies between."""
    if line.fixed:
        ends = min(abs(s - line.low), abs(s - line.high))
        return 0.0 if ends < 1e-3 else None
    if not line.hits:
        return 0.0
    if s > max(line.hits) + 1:
        return s - max(line.hits)
    if s < min(line.hits) - 1:
        return min(line.hits) - s
    return None


def _side_of(line: _Line, s: float) -> str:
    if line.fixed or not line.hits:
        return "high" if abs(s - line.high) < abs(s - line.low) else "low"
    return "high" if s > max(line.hits) else "low"


def _clear(line: _Line, s: float, legs: Iterable[Leg]) -> bool:
    """Whether no path crosses a wall between where it is struck and a corner."""
    if line.fixed or not line.hits:
        return True
    near = min(line.hits, key=lambda h: abs(h - s))
    for leg in legs:
        met = _crossing(leg.start, leg.end, line)
        if met is not None and 0.001 < met[0] < 0.999 and (met[1] - near) * (met[1] - s) < 0:
            return False
    return True


# --- putting it together --------------------------------------------------------------------------


@dataclass(frozen=True)
class _Given:
    """What a statement says of places, in its own units."""

    starts: Mapping[str, Vector]
    origins: Mapping[str, Vector]  # a point of every straight wall that has a place
    segments: Mapping[str, tuple[Vector, Vector]]
    circles: Mapping[str, tuple[Vector, float]]
    points: Mapping[str, Vector]
    radius: float | None

    @property
    def placed(self) -> bool:
        return bool(self.starts or self.origins or self.circles)


def _given(story: Story) -> _Given:
    starts, origins, segments, circles = {}, {}, {}, {}
    for name, sphere in story.spheres.items():
        if sphere.position is not None:
            starts[name] = _floats(story.read_vector(sphere.position, ""))
    for name, wall in story.walls.items():
        if wall.centre is not None:
            circles[name] = (
                _floats(story.read_vector(wall.centre, "")),
                float(story.read(wall.radius, "")),
            )
        elif wall.start is not None:
            ends = (
                _floats(story.read_vector(wall.start, "")),
                _floats(story.read_vector(wall.end, "")),
            )
            segments[name], origins[name] = ends, ends[0]
        elif wall.through is not None:
            origins[name] = _floats(story.read_vector(wall.through, ""))
    points = {
        name: _floats(story.evaluator(0).vector(point.position))
        for name, point in story.points.items()
    }
    radius = next((s.radius for s in story.spheres.values() if s.radius is not None), None)
    size = None if radius is None else float(story.read(radius, ""))
    return _Given(starts, origins, segments, circles, points, size)


def lay_out(story: Story, since: int = 0) -> Plan | None:
    """A story told in numbers on paper; None for one that needs no plan, or has none.

    A plan is made of a story with an impact on a wall, or with places that are known. What has
    nothing to do with the events after ``since``, in a story without places, is left out.
    """
    try:
        moves, given = _moves(story), _given(story)
    except (RestitutionError, ArithmeticError):
        return None
    if not moves or all(_still(v) for m in moves for v in (*m.before.values(), *m.after.values())):
        return None
    try:
        if given.placed:
            return _to_scale(story, moves, given)
        groups = _connected(moves)
        walled = [g for g in groups if any(move.wall is not None for move in g)]
        recent = [g for g in groups if any(move.number > since for move in g)] or groups
        shown = [g for g in walled if g in recent]
        plans = [_freely(story, group, given, _WIDTH / len(shown)) for group in shown]
    except np.linalg.LinAlgError:
        return None
    made = [plan for plan in plans if plan is not None]
    return _side_by_side(made) if made else None


def _connected(moves: Sequence[_Move]) -> list[list[_Move]]:
    """The events in groups without a sphere in common."""
    groups: list[list[_Move]] = []
    for move in moves:
        own = [g for g in groups if any(set(m.bodies) & set(move.bodies) for m in g)]
        groups = [g for g in groups if g not in own]
        groups.append(sorted([*(m for g in own for m in g), move], key=lambda m: m.number))
    return groups


def _side_by_side(plans: Sequence[Plan]) -> Plan:
    """Plans that have nothing to do with one another, from left to right, as one."""
    whole = plans[0]
    for plan in plans[1:]:
        _, _, right, _ = _box(_drawn(whole))
        left, _, _, _ = _box(_drawn(plan))
        moved = _moved(plan, Vector(right - left + 12.0, 0.0))
        whole = replace(
            whole,
            legs=(*whole.legs, *moved.legs),
            stops=(*whole.stops, *moved.stops),
            starts={**whole.starts, **moved.starts},
            walls=(*whole.walls, *moved.walls),
            side_by_side=whole.side_by_side or moved.side_by_side,
        )
    return whole


def _moved(plan: Plan, by: Vector) -> Plan:
    """A plan without places elsewhere on the paper."""
    return replace(
        plan,
        legs=tuple(replace(leg, start=leg.start + by, end=leg.end + by) for leg in plan.legs),
        stops=tuple(
            replace(
                stop,
                centres={name: at + by for name, at in stop.centres.items()},
                contact=stop.contact + by,
            )
            for stop in plan.stops
        ),
        starts={name: at + by for name, at in plan.starts.items()},
        walls=tuple(replace(w, start=w.start + by, end=w.end + by) for w in plan.walls),
    )


def _freely(story: Story, moves: Sequence[_Move], given: _Given, width: float) -> Plan | None:
    """A plan where the statement gives directions only: the clearest of several."""
    sized = given.radius is not None or any(move.kind == "spheres" for move in moves)
    radius = _RADIUS if sized else 0.0
    made = _layout(story, moves, {}, {}, radius)
    flights = len(made.lengths)
    shares = (1.0, 0.7, 1.4) if flights <= 3 else (1.0,)
    best: tuple[float, Plan, tuple[float, ...]] | None = None
    for factors in itertools.product(shares, repeat=flights):
        x = _solve(made, [_FLIGHT * factor for factor in factors], _SHORTEST)
        if x is None:
            continue
        plan, cost = _on_paper(story, moves, given, made, x, 1.0, radius, 1.0)
        cost += 2 * sum(abs(math.log(factor)) for factor in factors)
        if best is None or cost < best[0]:
            best = cost, plan, factors
    if best is None:
        return None
    _, plan, factors = best
    size = 1.0
    for _ in range(4):
        size = min(size / _fill(plan, width), _LARGEST)
        x = _solve(made, [_FLIGHT * factor * size for factor in factors], _SHORTEST * size)
        if x is None:
            break
        plan, _ = _on_paper(story, moves, given, made, x, 1.0, radius, size)
        if 0.97 < _fill(plan, width) < 1.03:
            break
    return _in_lanes(plan)


def _fill(plan: Plan, width: float = _WIDTH) -> float:
    """The share of the room on paper that a plan fills; more than 1 for one that is too large."""
    left, bottom, right, top = _box(_drawn(plan))
    return max((right - left) / width, (top - bottom) / _HEIGHT, 1e-3)


def _to_scale(story: Story, moves: Sequence[_Move], given: _Given) -> Plan | None:
    """A plan where places are known."""
    radius = given.radius or 0.0
    made = _layout(story, moves, given.starts, given.origins, radius)
    known = [*given.starts.values(), *given.points.values(), *given.origins.values()]
    known += [end for ends in given.segments.values() for end in ends]
    known += [c + d * r for c, r in given.circles.values() for d in (Vector(1, 1), Vector(-1, -1))]
    left, bottom, right, top = _box(known)
    extent = max(right - left, top - bottom) or 1.0
    targets = [0.6 * extent] * len(made.lengths)
    x = _solve(made, targets, 0.02 * extent)
    if x is None:
        return None
    places = [_floats(p @ x + c) for p, c in made.where.values()]
    if given.starts or any(move.place is not None for move in moves):
        known = [p for p in known if p not in given.origins.values()] or known
    known += places
    scale = 1.0
    for _ in range(4):
        # The ends of the paths have a length on paper: what they add depends on the scale.
        left, bottom, right, top = _box(known)
        across, up = max(right - left, 1e-9), max(top - bottom, 1e-9)
        scale = min(_WIDTH / across, _HEIGHT / up) if scale == 1.0 else scale
        plan, _ = _on_paper(story, moves, given, made, x, scale, radius, 1.0)
        over = _fill(plan)
        if 0.97 < over < 1.03:
            break
        scale /= over
    return _in_lanes(plan)


def _drawn(plan: Plan) -> Iterator[Vector]:
    for leg in plan.legs:
        yield from (leg.start, leg.end)
    for wall in plan.walls:
        yield from (wall.start, wall.end)
    for circle in plan.rounds:
        for d in (Vector(1, 1), Vector(-1, -1)):
            yield circle.centre + d * circle.radius
    yield from plan.starts.values()
    yield from plan.points.values()
    for stop in plan.stops:
        yield from stop.centres.values()


def _box(points: Iterable[Vector]) -> tuple[float, float, float, float]:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _on_paper(
    story: Story,
    moves: Sequence[_Move],
    given: _Given,
    made: _Layout,
    x: Any,
    scale: float,
    radius: float,
    shrunk: float,
) -> tuple[Plan, float]:
    """The plan for these unknowns, and how far it is from a clear one."""
    where = {key: _floats(p @ x + c) * scale for key, (p, c) in made.where.items()}
    radius *= scale
    stops = [_stop(move, where, radius) for move in moves]
    legs = _flights(moves, given, where, scale)
    lines = _lines(story, moves, given, stops, scale)
    ends, short = _loose_ends(story, moves, given, where, lines, shrunk, scale, radius)
    legs = sorted([*legs, *ends], key=lambda leg: leg.after)
    rounds = tuple(
        Round(name, c * scale, r * scale, _struck_from_inside(name, stops, given))
        for name, (c, r) in given.circles.items()
    )
    starts = {name: p * scale for name, p in given.starts.items()}
    for leg in legs:
        if leg.kind == "approach":
            starts[leg.body] = leg.start
    for (body, _), place in where.items():
        starts.setdefault(body, place)
    points = {name: p * scale for name, p in given.points.items()}
    if given.placed:
        _stretch(lines, [*(p for leg in legs for p in (leg.start, leg.end)), *points.values()])
    else:
        _under(lines, stops, legs, 20 * shrunk)
    struck = [(m.wall, m.bodies[0]) for m in moves if m.wall]
    successive = {
        frozenset((a, b)) for (a, p), (b, q) in itertools.pairwise(struck) if a != b and p == q
    }
    crossed = _trim(lines, legs, 60.0 if given.placed else 44.0 * shrunk + 8, successive)
    walls = tuple(
        Straight(
            line.name,
            line.at(line.low),
            line.at(line.high),
            -line.near,
            (line.corners.get("low"), line.corners.get("high")),
            line.fixed,
        )
        for line in lines
    )
    plan = Plan(
        tuple(legs),
        tuple(stops),
        starts,
        walls,
        rounds,
        points,
        radius,
        scale if given.placed else None,
    )
    cost = 1000.0 * crossed + 5 * short + 15 * max(0.0, _fill(plan) - 1)
    for pair in successive:
        one, other = (next((w for w in walls if w.name == name), None) for name in pair)
        if one is not None and other is not None and other.name not in one.corners:
            cost += 40 * (abs(one.far.cross(other.far)) > 0.05)
    for a, b in itertools.combinations(stops, 2):
        cost += 10 * max(0.0, 9 * shrunk - _size(a.contact - b.contact))
    return plan, cost


def _stop(move: _Move, where: Mapping[tuple[str, int], Vector], radius: float) -> Stop:
    centres = {name: where[name, move.number] for name in move.bodies}
    contact = centres[move.bodies[0]]
    if move.normal is not None:
        contact = contact + move.normal * radius
    return Stop(move.number, move.kind, centres, contact, move.wall, move.normal)


def _flights(
    moves: Sequence[_Move],
    given: _Given,
    where: Mapping[tuple[str, int], Vector],
    scale: float,
) -> list[Leg]:
    """The pieces of the paths between events, and from a given place to the first."""
    legs = []
    for body in dict.fromkeys(name for move in moves for name in move.bodies):
        at, since = (given.starts[body] * scale, 0) if body in given.starts else (None, 0)
        for move in moves:
            if body not in move.bodies:
                continue
            here = where[body, move.number]
            if at is not None and not _still(move.before[body]):
                legs.append(Leg(body, since, "flight", at, here))
            at, since = here, move.number
    return legs


def _lines(
    story: Story, moves: Sequence[_Move], given: _Given, stops: Sequence[Stop], scale: float
) -> list[_Line]:
    lines = []
    for name, wall in story.walls.items():
        own = [stop for stop in stops if stop.wall == name]
        if wall.centre is not None or not (own or name in given.origins):
            continue
        if own:
            assert own[0].normal is not None
            near = -own[0].normal
            along = near.turned_left()
            if name in given.segments or wall.along is not None:
                told = _floats(story.wall_direction(Name(name)))
                along = -along if along.dot(told) < 0 else along
        else:
            along = _unit(_floats(story.wall_direction(Name(name))))
            near = along.turned_left()
            middle = given.origins[name] * scale
            side = sum((s.contact - middle).dot(near) for s in stops)
            near = -near if side < 0 else near
        origin = given.origins[name] * scale if name in given.origins else own[0].contact
        line = _Line(name, origin, along, near, [], 0.0, 0.0, name in given.origins)
        line.hits = [line.along_it(stop.contact) for stop in own]
        if name in given.segments:
            line.fixed = True
            line.high = line.along_it(given.segments[name][1] * scale)
        else:
            line.low = min(line.hits, default=0.0) - _BEYOND
            line.high = max(line.hits, default=0.0) + _BEYOND
        lines.append(line)
    return lines


def _stretch(lines: Iterable[_Line], points: Sequence[Vector]) -> None:
    """Walls that go on for ever are drawn along all that there is to see."""
    for line in lines:
        if not line.fixed:
            shadows = [line.along_it(p) for p in points]
            line.low = min(line.low, min(shadows) - 3)
            line.high = max(line.high, max(shadows) + 3)


def _under(lines: Iterable[_Line], stops: Iterable[Stop], legs: Sequence[Leg], most: float) -> None:
    """Walls go on along a path that comes to them or leaves them at a small angle."""
    for line in lines:
        for stop in stops:
            if stop.wall != line.name:
                continue
            hit = line.along_it(stop.contact)
            for leg in legs:
                if leg.body not in stop.centres:
                    continue
                for end, other in ((leg.start, leg.end), (leg.end, leg.start)):
                    if _size(end - stop.centres[leg.body]) < 1e-6:
                        s = hit + max(-most, min(most, line.along_it(other) - hit))
                        line.low, line.high = min(line.low, s), max(line.high, s)


def _struck_from_inside(name: str, stops: Iterable[Stop], given: _Given) -> bool:
    centre, radius = given.circles[name]
    struck = next((stop for stop in stops if stop.wall == name), None)
    if struck is not None and struck.normal is not None:
        contact_inside = next(iter(struck.centres.values()))
        return struck.normal.dot(contact_inside - centre) > 0 or not given.starts
    return all(_size(p - centre) <= radius for p in given.starts.values())


def _loose_ends(
    story: Story,
    moves: Sequence[_Move],
    given: _Given,
    where: Mapping[tuple[str, int], Vector],
    lines: Sequence[_Line],
    shrunk: float,
    scale: float,
    radius: float,
) -> tuple[list[Leg], float]:
    """The pieces of the paths before the first and after the last event of each sphere.

    They stop before a wall that they would come to. With them comes what they lack in length.
    """
    legs, lacking = [], 0.0
    shrunk = max(shrunk, 0.5)
    bodies = dict.fromkeys([*(name for move in moves for name in move.bodies), *given.starts])
    for body in bodies:
        own = [move for move in moves if body in move.bodies]
        first = own[0].before[body] if own else _floats(story.velocity(body, 0))
        if body not in given.starts and not _still(first):
            end = where[body, own[0].number]
            way, skip = -_unit(first), own[0].wall
            length = _free_way(end, way, _APPROACH * shrunk + radius, lines, skip)
            lacking += max(0.0, 0.6 * _APPROACH * shrunk - length)
            legs.append(Leg(body, 0, "approach", end + way * length, end))
        last = own[-1].after[body] if own else first
        if not _still(last) and not (own and _ends_at_wall(own[-1], given, where, body, scale)):
            start = where[body, own[-1].number] if own else given.starts[body] * scale
            way, skip = _unit(last), own[-1].wall if own else None
            length = _onward(start, way, lines, skip) if given.placed else None
            if length is None:
                length = _free_way(start, way, _EXIT * shrunk + radius, lines, skip)
            for centre, rim in given.circles.values():
                chord = _inside_circle(start - centre * scale, way, rim * scale)
                length = length if chord is None else min(length, 0.6 * chord)
            lacking += max(0.0, 0.6 * _EXIT * shrunk - length)
            since = own[-1].number if own else 0
            legs.append(Leg(body, since, "exit", start, start + way * length))
    return legs, lacking


def _ends_at_wall(
    move: _Move,
    given: _Given,
    where: Mapping[tuple[str, int], Vector],
    body: str,
    scale: float,
) -> bool:
    """Whether a story ends as a sphere comes to a wall, and what it does there is not told."""
    if move.kind != "arrival":
        return False
    at, way = where[body, move.number], move.after[body]
    return move.wall is not None or any(
        abs(_size(at - c * scale) - r * scale) < 1e-6 * r * scale and way.dot(at - c * scale) > 0
        for c, r in given.circles.values()
    )


def _free_way(
    start: Vector, way: Vector, length: float, lines: Iterable[_Line], skip: str | None
) -> float:
    """A length that stops short of other walls, unless they are too near for that."""
    for line in lines:
        if line.name == skip:
            continue
        met = _crossing(start, start + way, line)
        if met is None or met[0] <= _CLOSE:
            continue
        if line.fixed and not line.low <= met[1] <= line.high:
            continue
        room = met[0] - 3
        if room >= _SHORTEST:
            length = min(length, room)
    return length


def _onward(start: Vector, way: Vector, lines: Iterable[_Line], skip: str | None) -> float | None:
    """How far to a wall that is not struck in the story, or a little past its end."""
    best = None
    for line in lines:
        if line.name == skip or line.hits:
            continue
        met = _crossing(start, start + way, line)
        if met is None or not 1 < met[0] < 55:
            continue
        on_it = not line.fixed or line.low < met[1] < line.high
        length = met[0] if on_it else met[0] + 8
        best = length if best is None else min(best, length)
    return best


def _inside_circle(out: Vector, way: Vector, radius: float) -> float | None:
    """How far it is to the rim from inside or on it; None from outside or when leaving."""
    if _size(out) > radius * (1 + 1e-9):
        return None
    half = out.dot(way)
    chord = -half + math.sqrt(max(half * half + radius * radius - out.dot(out), 0.0))
    return chord if chord > 1e-6 * radius else None


# --- paths along one line -------------------------------------------------------------------------


def _in_lanes(plan: Plan) -> Plan:
    """Draws pieces that lie upon one another side by side."""
    lanes: dict[int, int] = {}
    group: dict[int, int] = {}
    legs = plan.legs
    for i, leg in enumerate(legs):
        beside = [j for j in range(i) if _overlap(leg, legs[j])]
        near = {group[j] for j in range(i) if _one_line(leg, legs[j])}
        group[i] = min(near, default=i)
        taken = {lanes[j] for j in beside}
        lanes[i] = next(k for k in itertools.count() if k not in taken)
    if not any(lanes.values()):
        return plan
    most = {g: max(lanes[i] for i in lanes if group[i] == g) for g in set(group.values())}
    first = {g: legs[g].direction for g in most}
    moved = []
    for i, leg in enumerate(legs):
        count = most[group[i]]
        lane = (lanes[i] - count / 2) * (_LANE if count < 2 else _WIDE_LANE)
        same = leg.direction.dot(first[group[i]]) > 0
        moved.append(replace(leg, lane=(lane if same else -lane) or 0.0))
    return replace(plan, legs=tuple(moved), side_by_side=True)


def _one_line(one: Leg, other: Leg) -> bool:
    way = one.direction
    return abs(way.cross(other.direction)) < 1e-3 and abs(way.cross(other.start - one.start)) < 0.3


def _overlap(one: Leg, other: Leg) -> bool:
    if not _one_line(one, other):
        return False
    way = one.direction
    a = sorted((0.0, (one.end - one.start).dot(way)))
    b = sorted(((other.start - one.start).dot(way), (other.end - one.start).dot(way)))
    return bool(min(a[1], b[1]) - max(a[0], b[0]) > 1.0)
