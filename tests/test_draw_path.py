"""The plan of a story on paper: checked against the story told in numbers, and by eye's rules."""

from __future__ import annotations

import itertools
import math

import pytest
from laws_of_paths import angle, size

from restitution.drawing import figure, scenes
from restitution.drawing.path import path_scene
from restitution.drawing.scene import Arc, Arrow, Label, Scene
from restitution.language import parse
from restitution.render.text import to_text
from restitution.solving import solve
from restitution.staging.plan import Plan
from restitution.staging.planning import lay_out
from restitution.staging.values import motion


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


def test_the_plan_comes_first_where_a_later_part_has_the_second_impact() -> None:
    question = """
    wall AB: along i
    wall BC: along 60°
    sphere P: velocity u at 30° to AB
    P hits AB: e = 1/2
    part a
    find speed(P)
    part b
    P hits BC: e = 1/3
    find speed(P)
    """
    assert [scene.event for scene in scenes(solve(parse(question)))] == [None, 1, 2]


def test_arcs_at_a_corner_and_at_an_impact_near_it_do_not_meet() -> None:
    question = """
    wall AB: along i
    wall BC: along 60°
    sphere P: mass m, velocity u at 30° to AB
    P hits AB
    given speed(P) = 7/8 u
    P hits BC: e = 1/3
    find speed(P)
    """
    plan, *_ = scenes(solve(parse(question)))
    arcs = [shape for shape in plan.shapes if isinstance(shape, Arc)]
    assert len(arcs) > 3
    for one, other in itertools.combinations(arcs, 2):
        apart = math.hypot(*(one.centre - other.centre))
        assert apart < 1e-6 or apart > one.radius + other.radius
