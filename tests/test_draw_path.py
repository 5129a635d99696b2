"""The plan of a story on paper: checked against the story told in numbers, and by eye's rules."""

from __future__ import annotations

import itertools
import math
from functools import cache
from pathlib import Path

import pytest
from statements import FILES, each_of, solved

from restitution.draw import figure, scenes
from restitution.draw.ink import ink, overlap, touched
from restitution.draw.labels import place
from restitution.draw.path import path_scene
from restitution.draw.scene import Arrow, Disc, Dot, Label, RoundWall, Scene, StraightWall
from restitution.language import parse
from restitution.render.text import to_text
from restitution.solve import solve
from restitution.solve.story import Story
from restitution.staging.plan import Leg, Plan, Stop, Straight
from restitution.staging.planning import lay_out
from restitution.staging.values import motion
from restitution.vector import Vector

PLANS = [
    path
    for path in FILES
    if any(word in path.read_text() for word in ("\nwall ", "at (", "\npoint "))
]
every = each_of(PLANS)


@cache
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


@every
def test_pieces_join_and_go_where_the_velocities_say(path: Path) -> None:
    for story, plan, _ in drawn(path):
        for body, legs in by_body(plan).items():
            assert [leg.after for leg in legs] == sorted({leg.after for leg in legs})
            for one, other in itertools.pairwise(legs):
                assert size(one.end - other.start) < 1e-6
            for leg in legs:
                velocity = floats(story.velocity(body, leg.after))
                assert size(leg.end - leg.start) > 1.0
                assert angle(velocity, leg.end - leg.start) < 1e-6


@every
def test_impacts_are_where_paths_meet_walls(path: Path) -> None:
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


@every
def test_paths_stay_on_the_near_side(path: Path) -> None:
    for _, plan, _ in drawn(path):
        for stop in plan.stops:
            wall = wall_of(plan, stop)
            if wall is None:
                continue
            for leg in plan.legs:
                for here, there in ((leg.start, leg.end), (leg.end, leg.start)):
                    if leg.body in stop.centres and size(here - stop.centres[leg.body]) < 1e-6:
                        assert (there - here).dot(wall.far) < 1e-6


@every
def test_no_path_crosses_a_wall(path: Path) -> None:
    for _, plan, _ in drawn(path):
        for wall, leg in itertools.product(plan.walls, plan.legs):
            way, other = leg.end - leg.start, wall.end - wall.start
            turn = way.cross(other)
            if abs(turn) < 1e-9:
                continue
            s = (wall.start - leg.start).cross(other) / turn
            t = (wall.start - leg.start).cross(way) / turn
            assert not (1e-3 < s < 1 - 1e-3 and 0 < t < 1), (wall.name, leg)


@every
def test_spheres_touch_along_the_line_of_centres(path: Path) -> None:
    for story, plan, _ in drawn(path):
        for stop in plan.stops:
            if stop.kind != "spheres":
                continue
            first, second = stop.centres.values()
            assert abs(size(second - first) - 2 * plan.radius) < 1e-6
            if plan.radius:
                line = floats(story.happenings[stop.number - 1].oriented())
                assert angle(second - first, line) < 1e-6


@every
def test_places_that_are_known_are_true_to_scale(path: Path) -> None:
    for story, plan, _ in drawn(path):
        if plan.scale is None:
            continue
        for stop, body in ((s, b) for s in plan.stops for b in s.centres):
            known = [p for n, p, _ in story.tracks[body].places if n == stop.number]
            if story.spheres[body].position is None or not known or known[0] is None:
                continue
            assert size(floats(known[0]) * plan.scale - stop.centres[body]) < 1e-5


@every
def test_spheres_that_meet_again_do_so_at_one_time(path: Path) -> None:
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


@every
def test_pictures_fit_their_frame_and_say_what_they_show(path: Path) -> None:
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


def scene_of(text: str) -> tuple[Plan, Scene]:
    solution = solve(parse(text))
    part = list(solution.parts.values())[-1]
    branch = part.branches[0]
    scene = path_scene(solution, part, branch)
    plan = lay_out(motion(solution, part, branch).story)
    assert scene is not None and plan is not None
    return plan, scene


def label(scene: Scene, text: str) -> Label:
    return next(each for each in scene.labels if to_text(each.content) == text)


CORNER = """
wall AB: along i
wall BC: along 60°
sphere P: velocity u at 60° to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
find speed(P)
"""


def test_two_walls_meet_at_the_corner_that_they_share() -> None:
    plan, scene = scene_of(CORNER)
    ab, bc = plan.walls
    assert size(ab.end - bc.start) < 1e-9
    inner = angle(ab.start - ab.end, bc.end - bc.start)
    assert math.degrees(inner) == pytest.approx(120)
    for letter, at in (("A", ab.start), ("B", ab.end), ("C", bc.end)):
        assert size(label(scene, letter).at - at) < 1e-9
    # By hand: tan of the angle after AB is half of tan 60°, and 60° of the turn is left at BC.
    after = math.degrees(math.atan(math.sqrt(3) / 2))
    second = math.degrees(math.atan(math.tan(math.radians(60 - after)) / 2))
    texts = {to_text(each.content) for each in scene.labels}
    assert {"60°", f"{after:.1f}°", f"{60 - after:.1f}°", f"{second:.2f}°"} <= texts
    assert {"u", "√7 u/4", "0.634u"} <= texts


def test_a_plan_is_to_scale() -> None:
    plan, scene = scene_of(
        """
wall W: along i, through (0, 0)
point N: (5, 1)
sphere P: at (0, 3), velocity u at alpha to W
P hits W: e = 1/2
P reaches N
find alpha
"""
    )
    assert plan.scale is not None
    # By hand: 3 cot α + 2 cot α = 5, so that α is 45° and P strikes W 3 m along.
    first, second = plan.stops
    start = plan.starts["P"]
    assert (first.contact - start).x == pytest.approx(3 * plan.scale)
    assert (first.contact - start).y == pytest.approx(-3 * plan.scale)
    assert (second.contact - start).x == pytest.approx(5 * plan.scale)
    assert {to_text(each.content) for each in scene.labels} >= {"3 m", "1 m", "5 m", "N", "W", "α"}


def test_paths_along_one_line_are_side_by_side() -> None:
    plan, scene = scene_of(
        """
wall W: along j
sphere A: mass m, velocity u i
sphere B: mass 3m, at rest
A hits B: along i, e = 1/2
B hits W: e = 1/2
find speed(B)
"""
    )
    assert plan.side_by_side
    out, back = [leg for leg in plan.legs if leg.body == "B"]
    gap = (out.end + out.shift) - (back.start + back.shift)
    assert size(gap) > 1.5
    assert abs(gap.dot(out.direction)) < 1e-9
    assert "side by side" in scene.description


def test_an_impact_of_two_spheres_alone_has_no_plan() -> None:
    solution = solve(
        parse(
            "sphere A: mass 1, velocity 3i\nsphere B: mass 2, at rest\nA hits B: along i + j\n"
            "find velocity(B)"
        )
    )
    part = solution.parts[None]
    assert path_scene(solution, part, part.branches[0]) is None


def texts(scene: Scene) -> set[str]:
    return {to_text(label.content) for label in scene.labels}


def test_a_plan_comes_before_the_pictures_of_its_impacts() -> None:
    made = scenes(solve(parse(CORNER)))
    assert [scene.event for scene in made] == [None, 1, 2]
    assert made[0].title == "Path of P"


def test_one_impact_without_places_needs_no_plan_beside_its_picture() -> None:
    question = "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind velocity(P)"
    assert [scene.event for scene in scenes(solve(parse(question)))] == [1]


def test_the_figure_of_a_question_is_a_plan_without_its_answers() -> None:
    scene = figure(solve(parse(CORNER)))
    assert scene is not None
    assert texts(scene) == {"A", "B", "C", "P", "u", "60°", "120°"}
    assert "√" not in scene.description and scene.note is None
    assert len([s for s in scene.shapes if isinstance(s, Arrow) and s.role == "path"]) == 1


def test_a_length_that_is_sought_is_a_letter_in_the_figure() -> None:
    question = """
point N: (7, 2)
wall W: along i, through (0, 0)
sphere P: at (0, h), velocity u at 45° to W
P hits W: e = 1/2
P reaches N
find h
"""
    solution = solve(parse(question))
    scene = figure(solution)
    assert scene is not None
    assert texts(scene) == {"P", "N", "W", "u", "45°", "h", "2 m", "7 m"}
    # By hand: h + 2 × 2 = 7.
    assert "3 m" in texts(scenes(solution)[0])


@every
def test_labels_stand_free(path: Path) -> None:
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
