"""Lays a story out on paper: scale, walls, the ends of the paths, and paths side by side."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import Name
from restitution.shapes import Circle
from restitution.solving.story.forward import Story
from restitution.staging.flights import Given, Layout, Move, events, given_places, solve, unknowns
from restitution.staging.geometry import floats, length, still, unit
from restitution.staging.plan import Leg, Plan, Round, Stop, Straight
from restitution.staging.walls import DrawnWall, crossing, trim
from restitution.vector import Vector

#: What the paths and walls may fill, leaving room for words beside them.
_WIDTH, _HEIGHT = 66.0, 50.0
# Readable lengths of the pieces of a path before the first event, between events, after the last.
_APPROACH, _FLIGHT, _EXIT = 22.0, 28.0, 18.0
_SHORTEST = 8.0
_LARGEST = 1.5  # times these, where there is room
# A sphere whose size is told or matters, where the scale is free.
_RADIUS = 2.6
# How far a wall goes on beyond the place where it is struck.
_BEYOND = 9.0
# Between groups that have nothing to do with one another, names and axes included.
_APART = 20.0
# Paths along one line are drawn so far apart: two of them, or more with words between.
_LANE, _WIDE_LANE = 2.2, 4.4
_CLOSE = 1e-6


def lay_out(story: Story, since: int = 0) -> Plan | None:
    """A story told in numbers on paper; None for one that needs no plan, or has none.

    A plan is made of a story with an impact on a wall, or with places that are known. What has
    nothing to do with the events after ``since``, in a story without places, is left out.
    """
    try:
        moves, given = events(story), given_places(story)
    except (RestitutionError, ArithmeticError):
        return None
    if not moves or all(still(v) for m in moves for v in (*m.before.values(), *m.after.values())):
        return None
    try:
        if given.placed:
            return _to_scale(story, moves, given)
        given = replace(given, origins={}, points={})
        groups = connected(moves)
        walled = [g for g in groups if any(move.wall is not None for move in g)]
        recent = [g for g in groups if any(move.number > since for move in g)] or groups
        shown = [g for g in walled if g in recent]
        width = (_WIDTH + _APART) / max(len(shown), 1) - _APART
        plans = [_freely(story, group, given, width) for group in shown]
    except np.linalg.LinAlgError:
        return None
    plans_ = [plan for plan in plans if plan is not None]
    return _side_by_side(plans_) if plans_ else None


def connected(moves: Sequence[Move]) -> list[list[Move]]:
    """The events in groups without a sphere in common."""
    groups: list[list[Move]] = []
    for move in moves:
        own = [g for g in groups if any(set(m.bodies) & set(move.bodies) for m in g)]
        groups = [g for g in groups if g not in own]
        groups.append(sorted([*(m for g in own for m in g), move], key=lambda m: m.number))
    return groups


def _side_by_side(plans: Sequence[Plan]) -> Plan:
    """Plans that have nothing to do with one another, from left to right, as one."""
    whole = plans[0]
    for plan in plans[1:]:
        _, _, right, _ = box(_drawn(whole))
        left, _, _, _ = box(_drawn(plan))
        moved = _moved(plan, Vector(right - left + _APART, 0.0))
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


def _freely(story: Story, moves: Sequence[Move], given: Given, width: float) -> Plan | None:
    """A plan where the statement gives directions only: the clearest of several."""
    sized = given.radius is not None or any(move.kind == "spheres" for move in moves)
    radius = _RADIUS if sized else 0.0
    layout = unknowns(story, moves, {}, {}, radius)
    flights = len(layout.lengths)
    shares = (1.0, 0.7, 1.4) if flights <= 3 else (1.0,)
    best: tuple[float, Plan, tuple[float, ...]] | None = None
    for factors in itertools.product(shares, repeat=flights):
        x = solve(layout, [_FLIGHT * factor for factor in factors], _SHORTEST)
        if x is None:
            continue
        plan, cost = _on_paper(story, moves, given, layout, x, 1.0, radius, 1.0)
        cost += 2 * sum(abs(math.log(factor)) for factor in factors)
        if best is None or cost < best[0]:
            best = cost, plan, factors
    if best is None:
        return None
    _, plan, factors = best
    size = 1.0
    for _ in range(4):
        size = min(size / _fill(plan, width), _LARGEST)
        x = solve(layout, [_FLIGHT * factor * size for factor in factors], _SHORTEST * size)
        if x is None:
            break
        plan, _ = _on_paper(story, moves, given, layout, x, 1.0, radius, size)
        if 0.97 < _fill(plan, width) < 1.03:
            break
    return _in_lanes(plan)


def _fill(plan: Plan, width: float = _WIDTH) -> float:
    """The share of the room on paper that a plan fills; more than 1 for one that is too large."""
    left, bottom, right, top = box(_drawn(plan))
    return max((right - left) / width, (top - bottom) / _HEIGHT, 1e-3)


def _to_scale(story: Story, moves: Sequence[Move], given: Given) -> Plan | None:
    """A plan where places are known."""
    radius = given.radius or 0.0
    layout = unknowns(story, moves, given.starts, given.origins, radius)
    known = [*given.starts.values(), *given.points.values(), *given.origins.values()]
    known += [end for ends in given.segments.values() for end in ends]
    known += [c + d * r for c, r in given.circles.values() for d in (Vector(1, 1), Vector(-1, -1))]
    left, bottom, right, top = box(known)
    extent = max(right - left, top - bottom) or 1.0
    targets = [0.6 * extent] * len(layout.lengths)
    x = solve(layout, targets, 0.02 * extent)
    if x is None:
        return None
    places = [floats(p @ x + c) for p, c in layout.where.values()]
    if given.starts or any(move.place is not None for move in moves):
        known = [p for p in known if p not in given.origins.values()] or known
    known += places
    scale = 1.0
    for _ in range(4):
        # The ends of the paths have a length on paper: what they add depends on the scale.
        left, bottom, right, top = box(known)
        across, up = max(right - left, 1e-9), max(top - bottom, 1e-9)
        scale = min(_WIDTH / across, _HEIGHT / up) if scale == 1.0 else scale
        plan, _ = _on_paper(story, moves, given, layout, x, scale, radius, 1.0)
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


def box(points: Iterable[Vector]) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of some points."""
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _on_paper(
    story: Story,
    moves: Sequence[Move],
    given: Given,
    layout: Layout,
    x: Any,
    scale: float,
    radius: float,
    shrunk: float,
) -> tuple[Plan, float]:
    """The plan for these unknowns, and how far it is from a clear one."""
    where = {key: floats(p @ x + c) * scale for key, (p, c) in layout.where.items()}
    radius *= scale
    stops = [stop_of(move, where, radius) for move in moves]
    legs = _flights(moves, given, where, scale)
    lines = wall_lines(story, moves, given, stops, scale)
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
    crossed, successive = raise_walls(lines, moves, given, stops, legs, points.values(), shrunk)
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
        cost += 10 * max(0.0, 9 * shrunk - length(a.contact - b.contact))
    return plan, cost


def raise_walls(
    lines: list[DrawnWall],
    moves: Sequence[Move],
    given: Given,
    stops: Sequence[Stop],
    legs: Sequence[Leg],
    points: Iterable[Vector],
    shrunk: float,
) -> tuple[int, set[frozenset[str]]]:
    """Gives walls their ends, by the paths along them and the corners between them.

    Returns how many paths cross a wall all the same, and which walls are struck in succession.
    """
    if given.placed:
        _stretch(lines, [*(p for leg in legs for p in (leg.start, leg.end)), *points])
    else:
        _under(lines, stops, legs, 20 * shrunk)
    struck = [(m.wall, m.bodies[0]) for m in moves if m.wall]
    successive = {
        frozenset((a, b)) for (a, p), (b, q) in itertools.pairwise(struck) if a != b and p == q
    }
    reach = 60.0 if given.placed else 44.0 * shrunk + 8
    return trim(lines, legs, reach, successive), successive


def stop_of(move: Move, where: Mapping[tuple[str, int], Vector], radius: float) -> Stop:
    """An event at the places of its bodies."""
    centres = {name: where[name, move.number] for name in move.bodies}
    contact = centres[move.bodies[0]]
    if move.normal is not None:
        contact = contact + move.normal * radius
    return Stop(move.number, move.kind, centres, contact, move.wall, move.normal)


def _flights(
    moves: Sequence[Move],
    given: Given,
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
            if at is not None and length(here - at) > _CLOSE:
                legs.append(Leg(body, since, "flight", at, here))
            at, since = here, move.number
    return legs


def wall_lines(
    story: Story, moves: Sequence[Move], given: Given, stops: Sequence[Stop], scale: float
) -> list[DrawnWall]:
    """The straight walls that are struck or have a place, still without their ends."""
    lines = []
    for name, wall in story.walls.items():
        own = [stop for stop in stops if stop.wall == name]
        if isinstance(wall.shape, Circle) or not (own or name in given.origins):
            continue
        if own:
            assert own[0].normal is not None
            near = -own[0].normal
            along = near.turned_left()
            if name in given.segments or wall.along is not None:
                direction = floats(story.wall_direction(Name(name)))
                along = -along if along.dot(direction) < 0 else along
        else:
            along = unit(floats(story.wall_direction(Name(name))))
            near = along.turned_left()
            middle = given.origins[name] * scale
            side = sum((s.contact - middle).dot(near) for s in stops)
            near = -near if side < 0 else near
        origin = given.origins[name] * scale if name in given.origins else own[0].contact
        line = DrawnWall(name, origin, along, near, [], 0.0, 0.0, name in given.origins)
        line.hits = [line.along_it(stop.contact) for stop in own]
        if name in given.segments:
            line.fixed = True
            line.high = line.along_it(given.segments[name][1] * scale)
        else:
            line.low = min(line.hits, default=0.0) - _BEYOND
            line.high = max(line.hits, default=0.0) + _BEYOND
        lines.append(line)
    return lines


def _stretch(lines: Iterable[DrawnWall], points: Sequence[Vector]) -> None:
    """Walls that go on for ever are drawn along all that there is to see."""
    for line in lines:
        if not line.fixed:
            shadows = [line.along_it(p) for p in points]
            line.low = min(line.low, min(shadows) - 3)
            line.high = max(line.high, max(shadows) + 3)


def _under(
    lines: Iterable[DrawnWall], stops: Iterable[Stop], legs: Sequence[Leg], most: float
) -> None:
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
                    if length(end - stop.centres[leg.body]) < 1e-6:
                        s = hit + max(-most, min(most, line.along_it(other) - hit))
                        line.low, line.high = min(line.low, s), max(line.high, s)


def _struck_from_inside(name: str, stops: Iterable[Stop], given: Given) -> bool:
    centre, radius = given.circles[name]
    struck = next((stop for stop in stops if stop.wall == name), None)
    if struck is not None and struck.normal is not None:
        contact_inside = next(iter(struck.centres.values()))
        return struck.normal.dot(contact_inside - centre) > 0 or not given.starts
    return all(length(p - centre) <= radius for p in given.starts.values())


def _loose_ends(
    story: Story,
    moves: Sequence[Move],
    given: Given,
    where: Mapping[tuple[str, int], Vector],
    lines: Sequence[DrawnWall],
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
        first = own[0].before[body] if own else floats(story.velocity(body, 0))
        if body not in given.starts and not still(first):
            end = where[body, own[0].number]
            course, skip = -unit(first), own[0].wall
            most = _approach(end, course, _APPROACH * shrunk + radius, where, radius)
            far = free_way(end, course, most, lines, skip)
            lacking += max(0.0, 0.6 * _APPROACH * shrunk - far)
            legs.append(Leg(body, 0, "approach", end + course * far, end))
        last = own[-1].after[body] if own else first
        if not still(last) and not (own and ends_at_wall(own[-1], given, where, body, scale)):
            start = where[body, own[-1].number] if own else given.starts[body] * scale
            course, skip = unit(last), own[-1].wall if own else None
            onward = _onward(start, course, lines, skip) if given.placed else None
            far = (
                onward
                if onward is not None
                else free_way(start, course, _EXIT * shrunk + radius, lines, skip)
            )
            for centre, rim in given.circles.values():
                chord = _inside_circle(start - centre * scale, course, rim * scale)
                far = far if chord is None else min(far, 0.6 * chord)
            lacking += max(0.0, 0.6 * _EXIT * shrunk - far)
            since = own[-1].number if own else 0
            legs.append(Leg(body, since, "exit", start, start + course * far))
    return legs, lacking


def _approach(
    end: Vector,
    course: Vector,
    usual: float,
    where: Mapping[tuple[str, int], Vector],
    radius: float,
) -> float:
    """How long the path of a sphere is before its first event: it starts where none other is."""
    others = [at for at in where.values() if length(at - end) > 1e-6]
    for share in (1.0, 1.3, 0.75, 1.6, 0.55):
        start = end + course * (share * usual)
        if all(length(start - at) > 2.6 * radius for at in others):
            return share * usual
    return usual


def ends_at_wall(
    move: Move,
    given: Given,
    where: Mapping[tuple[str, int], Vector],
    body: str,
    scale: float,
) -> bool:
    """Whether a story ends as a sphere comes to a wall, and what it does there is not told."""
    if move.kind != "arrival":
        return False
    at, course = where[body, move.number], move.after[body]
    return move.wall is not None or any(
        abs(length(at - c * scale) - r * scale) < 1e-6 * r * scale
        and course.dot(at - c * scale) > 0
        for c, r in given.circles.values()
    )


def free_way(
    start: Vector, course: Vector, length: float, lines: Iterable[DrawnWall], skip: str | None
) -> float:
    """A length that stops short of other walls, unless they are too near for that."""
    for line in lines:
        if line.name == skip:
            continue
        met = crossing(start, start + course, line)
        if met is None or met[0] <= _CLOSE:
            continue
        if line.fixed and not line.low <= met[1] <= line.high:
            continue
        nearest = min((abs(met[1] - h) for h in line.hits), default=0.0)
        if line.placed or nearest < _BEYOND + 3 or met[0] - 3 >= _SHORTEST:
            length = min(length, max(met[0] - 3, 0.6 * met[0]))
    return length


def _onward(
    start: Vector, course: Vector, lines: Iterable[DrawnWall], skip: str | None
) -> float | None:
    """How far to a wall that is not struck in the story, or a little past its end."""
    best = None
    for line in lines:
        if line.name == skip or line.hits:
            continue
        met = crossing(start, start + course, line)
        if met is None or not 1 < met[0] < 80:
            continue
        on_it = not line.fixed or line.low < met[1] < line.high
        length = met[0] if on_it else met[0] + 8
        best = length if best is None else min(best, length)
    return best


def _inside_circle(out: Vector, course: Vector, radius: float) -> float | None:
    """How far it is to the rim from inside or on it; None from outside or when leaving."""
    if length(out) > radius * (1 + 1e-9):
        return None
    half = out.dot(course)
    chord = -half + math.sqrt(max(half * half + radius * radius - out.dot(out), 0.0))
    return chord if chord > 1e-6 * radius else None


# --- paths along one line -------------------------------------------------------------------------


def _in_lanes(plan: Plan) -> Plan:
    """Draws pieces that lie upon one another side by side."""
    courses = [leg.direction for leg in plan.legs]
    plan = replace(plan, in_line=all(abs(courses[0].cross(course)) < 1e-6 for course in courses))
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
    course = one.direction
    aligned = abs(course.cross(other.direction)) < 1e-3
    return bool(aligned and abs(course.cross(other.start - one.start)) < 0.3)


def _overlap(one: Leg, other: Leg) -> bool:
    if not _one_line(one, other):
        return False
    course = one.direction
    a = sorted((0.0, (one.end - one.start).dot(course)))
    b = sorted(((other.start - one.start).dot(course), (other.end - one.start).dot(course)))
    return bool(min(a[1], b[1]) - max(a[0], b[0]) > 1.0)
