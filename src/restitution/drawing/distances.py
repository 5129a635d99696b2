"""Lengths that a statement gives, as dimension lines where there is room for them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from restitution.errors import RestitutionError
from restitution.exact.symbols import symbol_names
from restitution.expression.tree import Name
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.render.text import to_text
from restitution.shapes import Circle, Line, Segment
from restitution.solving.algebra.forms import plain
from restitution.solving.equations.solution import Branch
from restitution.solving.story.forward import Story
from restitution.staging.geometry import length, unit
from restitution.staging.plan import Plan, Straight
from restitution.vector import Vector

_MOST = 4
# In characters on one line: longer ones are no given lengths.
_SHORT = 6
_SHORTEST = 7.0
# From a wall, beyond its hatching and the numbers of impacts.
_OFF = 8.5
_BESIDE = Vector(0.0, 0.0)


@dataclass(frozen=True)
class Distance:
    """A dimension line, the lines that lead to it from what it measures, and its label."""

    start: Vector
    end: Vector
    label: Layout
    leads: tuple[tuple[Vector, Vector], ...] = ()


@dataclass(frozen=True)
class _Wanted:
    """A length between two places of the plan; ``off`` is how far beside them it is to be shown.

    Of those that say the same ``what``, one is enough.
    """

    start: Vector
    end: Vector
    size: Any
    what: str
    off: Vector = _BESIDE


def distances(plan: Plan, story: Story, branch: Branch) -> list[Distance]:
    """The given lengths that a plan has room for; none where no places are given.

    They are those of ``story``, which is exact.
    """
    if plan.scale is None:
        return []
    distances_: list[Distance] = []
    labelled: set[str] = set()
    for wanted in _wanted(plan, story):
        if len(distances_) == _MOST:
            break
        if wanted.what in labelled:
            continue
        start, end = wanted.start + wanted.off, wanted.end + wanted.off
        if length(end - start) < _SHORTEST or not _has_room(start, end, plan, distances_):
            continue
        layout = _layout(wanted.size, branch)
        if layout is None:
            continue
        if not plan.in_line and any(
            layout == distance.label and _alike(distance, start, end) for distance in distances_
        ):
            continue
        labelled.add(wanted.what)
        leads: tuple[tuple[Vector, Vector], ...] = ()
        if length(wanted.off) > 1e-9:
            beyond = unit(wanted.off)
            leads = tuple(
                (p + beyond * 2, p + wanted.off + beyond) for p in (wanted.start, wanted.end)
            )
        distances_.append(Distance(start, end, layout, leads))
    return distances_


def _layout(size: Any, branch: Branch) -> Layout | None:
    """A length as people write it, if it is short."""
    value = plain(size, [branch.sample])
    if any(name.startswith("_") for name in symbol_names(value)):
        return None
    layout = lay.from_sympy(value)
    if len(to_text(layout)) > _SHORT:
        return None
    return layout if symbol_names(value) else lay.Phrase((layout, lay.Words("m")))


def _alike(one: Distance, start: Vector, end: Vector) -> bool:
    """Whether two dimension lines are parallel and as long as each other: they say the same."""
    extent, other = one.end - one.start, end - start
    return (
        abs(unit(extent).cross(unit(other))) < 1e-6 and abs(length(extent) - length(other)) < 1e-6
    )


# --- what may be measured -------------------------------------------------------------------------


def _wanted(plan: Plan, story: Story) -> Iterator[_Wanted]:
    try:
        exact = _Exact.of(story)
    except (RestitutionError, ArithmeticError):
        return
    straight = [wall for wall in plan.walls if wall.name in exact.origins]
    objects = {name: at for name, at in plan.starts.items() if name in exact.places}
    objects |= {
        n: p for n, p in plan.points.items() if all(length(p - q) > 0.5 for q in objects.values())
    }
    if plan.in_line and plan.legs:
        yield from _in_line(plan, exact, objects, straight)
        return
    for wall in straight:
        if wall.fixed:
            yield _Wanted(
                wall.start, wall.end, exact.length_of(wall.name), wall.name, wall.far * _OFF
            )
    for one, other in itertools.combinations(straight, 2):
        if abs(one.far.cross(other.far)) < 1e-9:
            yield from _between(plan, exact, one, other)
    for (name, at), wall in itertools.product(objects.items(), straight):
        gap = (wall.start - at).dot(wall.far)
        foot = at + wall.far * gap
        along = unit(wall.end - wall.start)
        if -1 <= (foot - wall.start).dot(along) <= length(wall.end - wall.start) + 1:
            yield _Wanted(at, foot, exact.distance(name, wall.name), f"{name} {wall.name}")
    if len(straight) == 1:
        wall = straight[0]
        for (one_name, a), (other_name, b) in itertools.combinations(objects.items(), 2):
            feet = [p + wall.far * (wall.start - p).dot(wall.far) for p in (a, b)]
            size = exact.along(one_name, other_name, wall.name)
            yield _Wanted(feet[0], feet[1], size, f"{one_name} {other_name}", wall.far * _OFF)
    for circle in plan.rounds:
        centre, radius = exact.circles[circle.name]
        for name, at in objects.items():
            if circle.inside and 1 < length(at - circle.centre) < circle.radius - 1:
                size = exact.story.size(exact.places[name] - centre)
                yield _Wanted(circle.centre, at, size, name)
        for turn in (130, 220, 50, 310, 100, 250, 160, 20, 280, 70, 190, 340):
            radial = Vector(math.cos(math.radians(turn)), math.sin(math.radians(turn)))
            yield _Wanted(
                circle.centre, circle.centre + radial * circle.radius, radius, circle.name
            )


def _between(plan: Plan, exact: _Exact, one: Straight, other: Straight) -> Iterator[_Wanted]:
    """The distance between parallel walls, at several places."""
    size = exact.gap(one.name, other.name)
    along = unit(one.end - one.start)
    across = one.far * (other.start - one.start).dot(one.far)
    for share in (0.97, 0.03, 0.85, 0.15, 0.5):
        start = one.start + along * (share * length(one.end - one.start))
        yield _Wanted(start, start + across, size, f"{one.name} {other.name}")


def _in_line(
    plan: Plan, exact: _Exact, objects: Mapping[str, Vector], walls: Sequence[Straight]
) -> Iterator[_Wanted]:
    """Distances along the one line on which everything happens, from each body to the next."""
    axis = plan.legs[0].direction
    axis = -axis if axis.x < -1e-9 or (abs(axis.x) < 1e-9 and axis.y < 0) else axis
    base = plan.legs[0].start
    stations: list[tuple[float, str]] = [
        ((p - base).dot(axis), name) for name, p in objects.items()
    ]
    stations += [
        ((wall.start - base).dot(axis), wall.name)
        for wall in walls
        if abs(wall.far.cross(axis)) < 1e-6
    ]
    below = axis.turned_left() * -(max(abs(leg.lane) for leg in plan.legs) + 7.5)
    for (first, name), (second, beside) in itertools.pairwise(sorted(stations)):
        pair = (name, beside) if name in exact.places else (beside, name)
        if pair[0] not in exact.places:
            continue
        size = (
            exact.distance(*pair)
            if pair[1] in exact.origins
            else exact.story.size(exact.places[pair[0]] - exact.places[pair[1]])
        )
        yield _Wanted(base + axis * first, base + axis * second, size, f"{name} {beside}", below)


@dataclass(frozen=True)
class _Exact:
    """The places of a statement in exact numbers and letters."""

    story: Story
    places: Mapping[str, Vector]
    origins: Mapping[str, Vector]
    ends: Mapping[str, Vector]
    circles: Mapping[str, tuple[Vector, Any]]

    @classmethod
    def of(cls, story: Story) -> _Exact:
        places = {
            name: story.read_vector(sphere.position, "")
            for name, sphere in story.spheres.items()
            if sphere.position is not None
        }
        for name, point in story.points.items():
            places[name] = story.evaluator(0).vector(point.position)
        origins, ends, circles = {}, {}, {}
        for name in story.walls:
            match story.shape(name):
                case Circle(centre, radius):
                    circles[name] = centre, radius
                case Segment(start, end):
                    origins[name], ends[name] = start, end
                case Line(_, Vector() as through):
                    origins[name] = through
        return cls(story, places, origins, ends, circles)

    def direction(self, wall: str) -> Vector:
        return Vector(*self.story.wall_direction(Name(wall)))

    def length_of(self, wall: str) -> Any:
        return self.story.size(self.ends[wall] - self.origins[wall])

    def distance(self, place: str, wall: str) -> Any:
        along = self.direction(wall)
        gap = along.cross(self.places[place] - self.origins[wall])
        return self.story.field.abs(gap / self.story.size(along))

    def along(self, one: str, other: str, wall: str) -> Any:
        along = self.direction(wall)
        gap = along.dot(self.places[one] - self.places[other])
        return self.story.field.abs(gap / self.story.size(along))

    def gap(self, one: str, other: str) -> Any:
        along = self.direction(one)
        gap = along.cross(self.origins[one] - self.origins[other])
        return self.story.field.abs(gap / self.story.size(along))


# --- where there is room --------------------------------------------------------------------------


def _has_room(start: Vector, end: Vector, plan: Plan, others: Sequence[Distance]) -> bool:
    """Whether a dimension line crosses no path or wall and no other, nor lies along one."""
    lines = [(leg.start, leg.end) for leg in plan.legs]
    lines += [(wall.start, wall.end) for wall in plan.walls]
    lines += [(other.start, other.end) for other in others]
    if any(_touch(start, end, a, b) for a, b in lines):
        return False
    return not any(
        stop.kind == "spheres" and _beside(at, start, end) < max(plan.radius, 2.0)
        for stop in plan.stops
        for at in stop.centres.values()
    )


def _touch(a: Vector, b: Vector, c: Vector, d: Vector) -> bool:
    """Whether two segments cross within both, or lie close along each other."""
    segment, other = b - a, d - c
    turn = unit(segment).cross(unit(other))
    if abs(turn) < 0.12:
        first = sorted((0.0, length(segment)))
        second = sorted(((c - a).dot(unit(segment)), (d - a).dot(unit(segment))))
        common = min(first[1], second[1]) - max(first[0], second[0])
        near = min(_beside(p, c, d) for p in (a, b, (a + b) / 2))
        return common > 1.0 and min(near, _beside((c + d) / 2, a, b)) < 2.0
    cross = segment.cross(other)
    s, t = (c - a).cross(other) / cross, (c - a).cross(segment) / cross
    return bool(0.02 < s < 0.98 and -0.02 < t < 1.02)


def _beside(point: Vector, a: Vector, b: Vector) -> float:
    """The distance of a point from a segment."""
    segment = b - a
    share = (point - a).dot(segment) / (segment.dot(segment) or 1.0)
    return length(point - (a + segment * min(1.0, max(0.0, share))))
