"""The plan of a story on paper: against the story told in numbers, and by eye's rules."""

from __future__ import annotations

import itertools
import math
from functools import lru_cache
from pathlib import Path

from statements import FILES, law, solved

from restitution.drawing.ink import ink, overlap, touched
from restitution.drawing.labels import place
from restitution.drawing.path import path_scene
from restitution.drawing.scene import Arrow, Disc, Dot, RoundWall, Scene, StraightWall
from restitution.render.text import to_text
from restitution.solving.story.forward import Story
from restitution.staging.plan import Leg, Plan, Stop, Straight
from restitution.staging.planning import lay_out
from restitution.staging.values import motion
from restitution.vector import Vector

PLANS = [
    path
    for path in FILES
    if any(word in path.read_text() for word in ("\nwall ", "at (", "\npoint "))
]


@lru_cache(maxsize=8)
def drawn(path: Path) -> list[tuple[Story, Plan, Scene]]:
    """The pictures of a statement, with the stories that they tell."""
    solution = solved(path)
    found = []
    for part in solution.parts.values():
        for branch in part.branches[:2]:
            scene = path_scene(solution, part, branch)
            if scene is None:
                continue
            story = motion(solution, part, branch).story
            plan = lay_out(story, len(story.happenings) - len(part.part.events))
            assert plan is not None
            found.append((story, plan, scene))
    return found


def size(v: Vector) -> float:
    return math.hypot(v.x, v.y)


def floats(v: Vector) -> Vector:
    return Vector(float(v.x), float(v.y))


def angle(a: Vector, b: Vector) -> float:
    return abs(math.atan2(float(a.cross(b)), float(a.dot(b))))


def by_body(plan: Plan) -> dict[str, list[Leg]]:
    found: dict[str, list[Leg]] = {}
    for leg in plan.legs:
        found.setdefault(leg.body, []).append(leg)
    return found


def wall_of(plan: Plan, stop: Stop) -> Straight | None:
    """The straight wall of an impact: the nearest, as groups side by side have each its own."""
    own = [wall for wall in plan.walls if wall.name == stop.wall]
    return min(own, key=lambda w: size((w.start + w.end) / 2 - stop.contact), default=None)


@law(PLANS)
def pieces_join_and_go_where_the_velocities_say(path: Path) -> None:
    for story, plan, _ in drawn(path):
        for body, legs in by_body(plan).items():
            assert [leg.after for leg in legs] == sorted({leg.after for leg in legs})
            for one, other in itertools.pairwise(legs):
                assert size(one.end - other.start) < 1e-6
            for leg in legs:
                velocity = floats(story.velocity(body, leg.after))
                assert size(leg.end - leg.start) > 1.0
                assert angle(velocity, leg.end - leg.start) < 1e-6


@law(PLANS)
def impacts_are_where_paths_meet_walls(path: Path) -> None:
    for _, plan, _ in drawn(path):
        for stop in plan.stops:
            wall = wall_of(plan, stop)
            for body, centre in stop.centres.items():
                own = [leg for leg in plan.legs if leg.body == body]
                ends = [p for leg in own for p in (leg.start, leg.end)]
                assert not own or any(size(centre - p) < 1e-6 for p in ends)
            if wall is not None:
                along = (wall.end - wall.start) / size(wall.end - wall.start)
                assert abs((stop.contact - wall.start).dot(wall.far)) < 1e-6
                assert (stop.contact - wall.start).dot(along) > -1e-6
                assert (stop.contact - wall.end).dot(along) < 1e-6
                (centre,) = stop.centres.values()
                assert abs(size(stop.contact - centre) - plan.radius) < 1e-6
            elif stop.wall is not None:
                circle = next(each for each in plan.rounds if each.name == stop.wall)
                off = size(stop.contact - circle.centre) - circle.radius
                assert abs(off) < 1e-6


@law(PLANS)
def paths_stay_on_the_near_side(path: Path) -> None:
    for _, plan, _ in drawn(path):
        for stop in plan.stops:
            wall = wall_of(plan, stop)
            if wall is None:
                continue
            for leg in plan.legs:
                for here, there in ((leg.start, leg.end), (leg.end, leg.start)):
                    if leg.body in stop.centres and size(here - stop.centres[leg.body]) < 1e-6:
                        assert (there - here).dot(wall.far) < 1e-6


@law(PLANS)
def no_path_crosses_a_wall(path: Path) -> None:
    for _, plan, _ in drawn(path):
        for wall, leg in itertools.product(plan.walls, plan.legs):
            way, other = leg.end - leg.start, wall.end - wall.start
            turn = way.cross(other)
            if abs(turn) < 1e-9:
                continue
            s = (wall.start - leg.start).cross(other) / turn
            t = (wall.start - leg.start).cross(way) / turn
            assert not (1e-3 < s < 1 - 1e-3 and 0 < t < 1), (wall.name, leg)


@law(PLANS)
def spheres_touch_along_the_line_of_centres(path: Path) -> None:
    for story, plan, _ in drawn(path):
        for stop in plan.stops:
            if stop.kind != "spheres":
                continue
            first, second = stop.centres.values()
            assert abs(size(second - first) - 2 * plan.radius) < 1e-6
            if plan.radius:
                line = floats(story.happenings[stop.number - 1].oriented())
                assert angle(second - first, line) < 1e-6


@law(PLANS)
def places_that_are_known_are_true_to_scale(path: Path) -> None:
    for story, plan, _ in drawn(path):
        if plan.scale is None:
            continue
        for stop, body in ((s, b) for s in plan.stops for b in s.centres):
            known = [p for n, p, _ in story.tracks[body].places if n == stop.number]
            if story.spheres[body].position is None or not known or known[0] is None:
                continue
            assert size(floats(known[0]) * plan.scale - stop.centres[body]) < 1e-5


@law(PLANS)
def spheres_that_meet_again_do_so_at_one_time(path: Path) -> None:
    for story, plan, _ in drawn(path):
        if plan.scale is not None:
            continue
        together = [stop for stop in plan.stops if stop.kind == "spheres"]
        for one, other in itertools.combinations(together, 2):
            if set(one.centres) != set(other.centres):
                continue
            times = []
            for body in one.centres:
                time = 0.0
                for leg in plan.legs:
                    if leg.body == body and one.number <= leg.after < other.number:
                        speed = size(floats(story.velocity(body, leg.after)))
                        time += size(leg.end - leg.start) / speed
                if all(
                    size(floats(story.velocity(body, n))) > 0
                    for n in range(one.number, other.number)
                ):
                    times.append(time)
            assert not times or max(times) - min(times) < 1e-6 * max(times)


def points(scene: Scene) -> list[Vector]:
    found: list[Vector] = []
    for shape in scene.shapes:
        match shape:
            case Disc() | Dot() | RoundWall():
                r = Vector(shape.radius, shape.radius)
                found += [shape.centre - r, shape.centre + r]
            case Arrow() | StraightWall():
                found += [shape.start, shape.end]
            case _:
                pass
    return found


@law(PLANS)
def pictures_fit_their_frame_and_say_what_they_show(path: Path) -> None:
    for story, plan, scene in drawn(path):
        left, bottom, right, top = scene.box
        for point in points(scene):
            assert left <= point.x <= right and bottom <= point.y <= top
        assert right - left < 100 and top - bottom < 90
        numbers = [int(to_text(label.content)) for label in scene.labels if label.ringed]
        assert numbers == sorted(stop.number for stop in plan.stops)
        assert len(set(numbers)) == len(numbers) <= len(story.happenings)
        for stop in plan.stops:
            assert f"{stop.number}: {next(iter(stop.centres))} " in scene.description
        heads = [shape for shape in scene.shapes if isinstance(shape, Arrow)]
        paths = [shape for shape in heads if shape.role == "path"]
        assert len(paths) == len(plan.legs)
        for leg, arrow in zip(plan.legs, paths, strict=True):
            assert angle(leg.end - leg.start, arrow.end - arrow.start) < 1e-6


@law(PLANS)
def labels_stand_free(path: Path) -> None:
    for _, _, scene in drawn(path):
        placed = place(scene)
        pieces = [piece for shape in scene.shapes for piece in ink(shape)]
        for one, other in itertools.combinations(placed.labels, 2):
            assert not overlap(one.box, other.box)
        for each in placed.labels:
            assert each.label.fixed or not touched(each.box, pieces, 0.0)
            assert placed.box[0] <= each.box[0] and each.box[2] <= placed.box[2]
            assert placed.box[1] <= each.box[1] and each.box[3] <= placed.box[3]
        assert placed.box[2] - placed.box[0] < 100
