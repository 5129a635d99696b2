"""The motion of a statement: against the principles, the answers and plain geometry."""

from __future__ import annotations

import itertools
import math
import re
from functools import lru_cache
from pathlib import Path
from unittest import mock

import numpy as np
import pytest
import statements
from statements import FILES, law

from restitution.errors import RestitutionError, UnsupportedError
from restitution.export.player.data import is_hurried, of_motions
from restitution.expression import read_expression
from restitution.expression.tree import Name, Quantity
from restitution.motion.parts import PartMotion, motions
from restitution.motion.pieces import Motion, Track, WallCircle, WallLine
from restitution.problem import Value
from restitution.solving import Solution
from restitution.staging import flights
from restitution.vector import Vector


@lru_cache(maxsize=8)
def shown(path: Path) -> tuple[Solution | None, tuple[PartMotion, ...], RestitutionError | None]:
    """The motions of a statement, or why there are none."""
    try:
        solution = statements.solved(path)
    except RestitutionError as error:
        return None, (), error
    try:
        return solution, motions(solution), None
    except RestitutionError as error:
        return solution, (), error


def told(path: Path) -> tuple[PartMotion, ...]:
    return shown(path)[1]


def size(v: Vector) -> float:
    return math.hypot(v.x, v.y)


def extent(motion: Motion) -> float:
    places = [p for t in motion.tracks for x in t.pieces for p in (x.place, x.at(x.end))]
    for wall in motion.walls:
        if isinstance(wall, WallLine):
            places += wall.points
        else:
            places += [wall.centre + d * wall.radius for d in (Vector(1, 1), Vector(-1, -1))]
    xs, ys = zip(*places, strict=True)
    return math.hypot(max(xs) - min(xs), max(ys) - min(ys))


def track(motion: Motion, name: str) -> Track:
    return next(each for each in motion.tracks if each.name == name)


@law(FILES)
def there_is_a_motion_or_a_reason(path: Path) -> None:
    solution, found, error = shown(path)
    if found:
        return
    assert error is not None
    if solution is not None and any(part.branches for part in solution.parts.values()):
        assert isinstance(error, UnsupportedError)
        assert error.message.startswith("no motion can be shown: e would be ")


def pieces_join_and_fill_the_time(each: PartMotion) -> None:
    motion = each.motion
    far = extent(motion)
    assert motion.end > motion.start
    assert motion.tracks
    for one in motion.tracks:
        assert one.pieces[0].start == pytest.approx(motion.start, abs=1e-9)
        assert one.pieces[-1].end == pytest.approx(motion.end, abs=1e-9)
        for before, after in itertools.pairwise(one.pieces):
            assert before.end == after.start
            assert size(before.at(before.end) - after.place) < 1e-9 * far
        for piece in one.pieces:
            assert all(map(math.isfinite, (*piece.place, *piece.velocity)))


def velocities_change_as_the_events_say_and_only_then(each: PartMotion) -> None:
    motion = each.motion
    changes: dict[str, list[tuple[float, Vector, Vector]]] = {t.name: [] for t in motion.tracks}
    for hit in motion.impacts:
        for name, before, after in zip((hit.first, hit.second), hit.before, hit.after):
            if name in changes:
                changes[name].append((hit.time, before, after))
    for blow in motion.blows:
        changes[blow.body].append((blow.time, blow.before, blow.after))
    for one in motion.tracks:
        quick = max(size(p.velocity) for p in one.pieces) or 1.0
        span = motion.end - motion.start
        for before, after in itertools.pairwise(one.pieces):
            if size(before.velocity - after.velocity) < 1e-12 * quick:
                continue
            assert any(
                abs(time - after.start) < 1e-9 * span
                and size(u - before.velocity) < 1e-9 * quick
                and size(v - after.velocity) < 1e-9 * quick
                for time, u, v in changes[one.name]
            )


def impacts_keep_the_principles(each: PartMotion) -> None:
    for hit in each.motion.impacts:
        (u1, u2), (v1, v2), c = hit.before, hit.after, hit.line_of_centres
        quick = max(map(size, (u1, u2, v1, v2)))
        assert size(c) == pytest.approx(1)
        assert (u1 - u2).dot(c) > 0, "they approach"
        assert (v2 - v1).dot(c) == pytest.approx(hit.e * (u1 - u2).dot(c), abs=1e-9 * quick)
        assert v1.cross(c) == pytest.approx(u1.cross(c), abs=1e-9 * quick)
        assert v2.cross(c) == pytest.approx(u2.cross(c), abs=1e-9 * quick)
        spheres = [name for name in (hit.first, hit.second) if name in each.bodies]
        if len(spheres) == 2 and set(spheres) <= set(each.masses):
            m1, m2 = (each.masses[name] for name in spheres)
            change = (v1 - u1) * m1 + (v2 - u2) * m2
            assert size(change) < 1e-9 * quick * (m1 + m2)
            assert size(hit.impulse - (v2 - u2) * m2) < 1e-9 * quick * m2


def bodies_touch_at_their_impacts(each: PartMotion) -> None:
    motion = each.motion
    near = 1e-6 * extent(motion)
    for hit in motion.impacts:
        first = track(motion, hit.first)
        centre = first.at(hit.time)
        assert size(hit.place - centre - hit.line_of_centres * first.radius) < near
        walls = [wall for wall in motion.walls if wall.name == hit.second]
        if not walls:
            second = track(motion, hit.second)
            apart = second.at(hit.time) - centre
            reach = first.radius + second.radius
            assert size(apart - hit.line_of_centres * reach) < near
        elif isinstance(walls[0], WallCircle):
            gap = abs(size(hit.place - walls[0].centre) - walls[0].radius)
            assert gap < near
        else:
            a, b = walls[0].points
            assert to_segment(hit.place, a, b) < near
            assert abs((b - a).dot(hit.line_of_centres)) < 1e-9 * size(b - a)


def to_segment(p: Vector, a: Vector, b: Vector) -> float:
    way = b - a
    share = min(1.0, max(0.0, (p - a).dot(way) / way.dot(way)))
    return size(p - a - way * share)


def spheres_meet_no_other_sphere(each: PartMotion) -> None:
    motion = each.motion
    slack, span = 1e-6 * extent(motion), motion.end - motion.start
    for one, other in itertools.combinations(motion.tracks, 2):
        hits = [h.time for h in motion.impacts if {h.first, h.second} == {one.name, other.name}]
        for a, b in itertools.product(one.pieces, other.pieces):
            start, end = max(a.start, b.start), min(a.end, b.end)
            if end <= start:
                continue
            gap, way = a.at(start) - b.at(start), a.velocity - b.velocity
            nearest = start
            if way.dot(way):
                nearest = min(end, max(start, start - gap.dot(way) / way.dot(way)))
            least = size(gap + way * (nearest - start))
            if one.radius + other.radius > 0:
                assert least > one.radius + other.radius - slack
            elif least < slack / 10:
                assert any(abs(nearest - t) < 1e-5 * span for t in [*hits, motion.start])


def spheres_stay_on_one_side_of_walls(each: PartMotion) -> None:
    motion = each.motion
    slack = 1e-6 * extent(motion)
    for one, wall in itertools.product(motion.tracks, motion.walls):
        for piece in one.pieces:
            times = [piece.start + k / 40 * (piece.end - piece.start) for k in range(41)]
            places = [piece.at(t) for t in times]
            if isinstance(wall, WallCircle):
                offs = [size(p - wall.centre) - wall.radius for p in places]
                assert all(abs(x) > one.radius - slack for x in offs)
                assert min(offs) > -slack or max(offs) < slack
                continue
            a, b = wall.points
            assert all(to_segment(p, a, b) > one.radius - slack for p in places)
            beside = [p for p in places if 0 < (p - a).dot(b - a) < (b - a).dot(b - a)]
            sides = [(b - a).cross(p - a) / size(b - a) for p in beside]
            assert not sides or min(sides) > -slack or max(sides) < slack


CHECKS = (
    pieces_join_and_fill_the_time,
    velocities_change_as_the_events_say_and_only_then,
    impacts_keep_the_principles,
    bodies_touch_at_their_impacts,
    spheres_meet_no_other_sphere,
    spheres_stay_on_one_side_of_walls,
)


@law(FILES)
def every_motion_is_right(path: Path) -> None:
    for each in told(path):
        for check in CHECKS:
            check(each)


@law(FILES)
def answers_about_the_end_are_those_of_the_motion(path: Path) -> None:
    """Velocities, places and times that are asked, in numbers, are seen."""
    solution, found, _ = shown(path)
    for each in found:
        if solution is None or solution.parts[each.labels[-1]] is not each.part:
            continue
        numbers = dict(each.events)
        for item in each.part.items:
            answer = next((a for a in item.answers if a.solution == each.branch.number), None)
            if answer is None or answer.decimal is None or not isinstance(item.item, Value):
                continue
            asked = item.item.expression
            if not isinstance(asked, Quantity) or not asked.arguments:
                continue
            name = asked.arguments[0]
            if asked.kind == "velocity" and asked.stage is None and is_last(each, item):
                body = name.name if isinstance(name, Name) else ""
                if body in each.bodies:
                    last = track(each.motion, body).pieces[-1].velocity
                    assert tuple(last) == pytest.approx(answer.decimal, abs=1e-6)
            elif asked.kind == "time":
                number = next((n for n in numbers if item.text.strip() == f"time({n})"), None)
                if number is not None:
                    assert numbers[number].time == pytest.approx(answer.decimal, abs=1e-6)


@law(FILES)
def exact_texts_are_the_numbers_beside_them(path: Path) -> None:
    """What the player shows as exact, read again with the letters at their values."""
    for each in told(path):
        evaluator = each.numbers.story.evaluator(0)
        (motion,) = of_motions([each], None)["motions"]
        pairs = []
        assert not is_hurried({"motions": [motion]})
        for sphere in motion["spheres"]:
            for (*_, vx, vy), said in zip(sphere["pieces"], sphere["said"], strict=True):
                sizes = {"x": vx, "y": vy, "speed": math.hypot(vx, vy)}
                pairs += [(text, sizes[key]) for key, text in (said or {}).items()]
        for event in motion["events"]:
            if event["kind"] != "impact" or event["said"] is None:
                continue
            pairs.append((event["said"]["e"], event["e"]))
            line = Vector(*event["line"])
            for when in ("before", "after"):
                for name, said in event["said"][when].items():
                    v = Vector(*event[when][name])
                    pairs += [(said["along"], v.dot(line)), (said["across"], line.cross(v))]
        for text, number in pairs:
            if text is not None:
                readable = re.sub(r"\|([^|]*)\|", r"abs(\1)", text)
                again = float(evaluator.scalar(read_expression(readable)))
                assert again == pytest.approx(number, rel=1e-6, abs=1e-9), text


BLOWS = [path for path in FILES if " receives " in path.read_text(encoding="utf-8")]


@law(BLOWS)
def rounding_makes_no_pieces(path: Path) -> None:
    """Times and places come from a system of equations: its last bits differ by the machine."""

    def texts() -> list[list[object]]:
        data = of_motions(motions(solution), None)["motions"]
        velocities = [[each["said"] for each in motion["spheres"]] for motion in data]
        return [velocities, [[each["kind"] for each in motion["events"]] for motion in data]]

    def rounded(*arguments):
        x = exactly(*arguments)
        return None if x is None else x + rng.uniform(-1e-14, 1e-14, len(x)) * max(1, *abs(x))

    solution, every_motion, _ = shown(path)
    assert every_motion
    wanted, exactly = texts(), flights.solve
    with mock.patch.object(flights, "solve", rounded):
        for seed in range(6):
            rng = np.random.default_rng(seed)
            assert texts() == wanted


def is_last(each: PartMotion, item: object) -> bool:
    """Whether an item is asked after all events of its part."""
    items = [x for step in each.part.part.steps[-1:] for x in getattr(step, "items", ())]
    return any(x is item.item for x in items)  # type: ignore[attr-defined]
