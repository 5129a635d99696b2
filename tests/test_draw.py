"""Pictures of impacts: their geometry, measured on the scenes, against the mechanics."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Sequence

import pytest
import strategies
from hypothesis import given
from laws_of_pictures import NEAR, Shown, angle_between, check, length, scenes, shown
from strategies import Tale
from test_properties import Told, can_happen, examples

import restitution as r
from restitution.drawing import figure
from restitution.drawing import scenes as pictures
from restitution.drawing.ink import ink, parted
from restitution.drawing.labels import place
from restitution.drawing.scene import (
    Arc,
    Arrow,
    Line,
    RightAngle,
    Scene,
    StraightWall,
)
from restitution.drawing.velocities import TINY
from restitution.examples import text
from restitution.render.text import to_text
from restitution.solving import Solution
from restitution.staging.values import motion
from restitution.vector import Vector


def solved(text: str) -> Solution:
    return r.solve(r.parse(text))


# --- generated problems, against the principles ---------------------------------------------------


def drawn_as_told(told: Told, made: Sequence[Scene]) -> None:
    """Arrows as long as the speeds, in the directions of the velocities, before and after."""
    assert len(made) == len(told.tale.blows)
    for number, (scene, normal) in enumerate(zip(made, told.normals), 1):
        check(scene)
        panels = dict(zip((number - 1, number), shown(scene)))
        names = list(panels[number].discs)
        expected = {
            (name, stage): tuple(map(float, told.velocity(name, stage)))
            for name in names
            for stage in panels
        }
        fastest = max(map(length, expected.values()))
        drawn = {key: panels[key[1]].velocity(key[0]) for key in expected}
        scale = max(map(length, drawn.values())) / fastest
        for key, v in expected.items():
            if 1e-9 * fastest < length(v) < TINY / scale:
                assert angle_between(drawn[key], v) < NEAR
                assert length(drawn[key]) == pytest.approx(TINY)
                continue
            assert drawn[key] == pytest.approx(
                (v[0] * scale, v[1] * scale), abs=1e-6 + 1e-7 * scale
            )
        at_rest = [key for key, v in expected.items() if length(v) < 1e-9 * fastest]
        for stage, panel in panels.items():
            resting = sum(1 for _, s in at_rest if s == stage)
            assert panel.labels().count("at rest") == resting
        if len(names) == 2:
            blow = told.tale.blows[number - 1]
            discs = panels[number].discs
            centres = discs[blow.second].centre - discs[blow.first].centre
            assert angle_between(centres, tuple(map(float, normal))) < 1e-6


@examples(60)
@given(strategies.tales())
def test_arrows_are_in_proportion_to_speeds(tale: Tale) -> None:
    told = can_happen(tale)
    drawn_as_told(told, scenes(solved(told.tale.statement("find energy"))))


@examples(30)
@given(strategies.tales(letters=True))
def test_arrows_are_in_proportion_to_multiples_of_a_letter(tale: Tale) -> None:
    told = can_happen(tale)
    made = scenes(
        solved(
            told.tale.statement("find velocity(A)" if "A" in told.tale.masses else "find energy")
        )
    )
    drawn_as_told(told, made)
    for scene in made:  # u only sets the scale
        assert scene.note is None or "Drawn for" not in to_text(scene.note)


# --- what is written ------------------------------------------------------------------------------


WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
let beta = angle(velocity(P), W)
find impulse, deflection(P)
"""


def test_a_wall_in_letters() -> None:
    (scene,) = scenes(solved(WALL))
    before, after = shown(scene)
    assert sorted(before.labels()) == sorted(["P", "m", "u", "α", "u cos α", "u sin α"])
    assert sorted(after.labels()) == sorted(["P", "m", "β", "u cos α", "eu sin α", "δ"])
    assert to_text(scene.note) == "Drawn for α = 40° and e = ½."
    (dotted,) = after.of(Line, "onward")
    arrow = before.velocity("P")
    assert angle_between(dotted.end - dotted.start, arrow) < NEAR
    (alpha,) = before.of(Arc, "angle")
    assert (alpha.end - alpha.start) % math.tau == pytest.approx(math.radians(40))


CORNER = """
wall AB: along i
wall BC: along 120°
sphere P: mass 2m, velocity u at 30° to AB
P hits AB: e = 2/3
part a
find speed(P), deflection(P)
part b
P hits BC: e = 1/2
find angle(velocity(P, 1), BC), speed(P)
"""


def test_letters_are_those_of_the_working() -> None:
    solution = solved(CORNER)
    working = r.explain(solution)
    assert "Let θ be the angle between 𝐯₁ and BC." in str(working)
    first, second = (each for each in pictures(solution, letters=working.letters) if each.event)
    assert sorted(shown(first)[1].labels()) == sorted(["P", "2m", "AB", "u/3", "√3 u/2", "δ"])
    assert r.draw(solution).scenes[1:] == (first, second)
    before, after = map(Shown.labels, shown(second))
    assert "θ" in before and "β" not in before
    assert {"11u/24", "√3 u/12"} <= set(after)


def test_a_wall_changes_a_component_that_has_no_letter() -> None:
    question = """
    wall W: along j
    sphere S: velocity 12i + 5j
    S hits W: e = 1/3
    find speed(S)
    """
    (scene,) = scenes(solved(question))
    assert sorted(shown(scene)[1].labels()) == ["4", "5", "S"]
    assert to_text(scene.note) == "Speeds are in m s⁻¹."


def test_a_blow_after_an_impact_with_a_wall_has_its_components_by_value() -> None:
    question = """
    wall W: along i
    sphere P: mass 2, velocity 3i - 4j
    P hits W: e = 1/2
    P receives -8i - 12j
    find velocity(P)
    """
    blow = scenes(solved(question))[-1]
    assert blow.event == 2
    assert {"3", "2"} <= set(shown(blow)[0].labels())


def test_what_is_not_given_and_has_no_letter_is_in_no_label() -> None:
    question = """
    sphere A: velocity i, mass 1
    sphere B: at rest, mass 1
    A hits B: e = 1, offset 1
    find velocity(B)
    """
    (scene,) = scenes(solved(question))
    written = {to_text(label.content) for label in scene.labels}
    assert written <= {"A", "B", "1", "𝐢", "𝐣", "at rest", "v", "w"}


def test_pictures_of_impacts_alike_say_which_they_are() -> None:
    question = """
    wall C: circle centre (0, 0) radius 5
    wall V: along j
    sphere P: mass 1, velocity 4i + 2j, at (-3, 0)
    P hits C: e = 1/2
    P hits C: e = 1/2
    find speed(P)
    """
    titles = [scene.title for scene in scenes(solved(question)) if scene.event is not None]
    assert titles == [
        *("Before and after: P hits C for the first time",),
        *("Before and after: P hits C for the second time",),
    ]
    walls = "wall V: along j\nwall W: along i\nsphere P: velocity 4i - 2j\nP hits V\nP hits W\n"
    titles = [scene.title for scene in scenes(solved(walls + "find speed(P)"))]
    assert not any(" time" in title for title in titles)


def test_all_masses_of_a_picture_stand_within_their_circles_or_none_does() -> None:
    question = """
    sphere A: mass {}, velocity 5i + 2j
    sphere B: mass {}, at rest
    A hits B: along i, e = 3/4
    find speed(A)
    """
    (scene,) = scenes(solved(question.format("0.2", "1/2")))
    for panel in shown(scene):
        within = [x for x in scene.labels if to_text(x.content) in ("0.2", "½")]
        assert len(within) == 4 and all(label.fixed for label in within)
        assert {"0.2", "½"} <= set(panel.labels())
    (scene,) = scenes(solved(question.format("1 + 2k + 3k^2", "1")))
    for panel in shown(scene):
        assert sum(text.startswith("mass ") for text in panel.labels()) == 2


SMALL = """
sphere A: mass 2m, velocity u i, radius r
sphere B: mass m, velocity -3u i, radius r
A hits B: offset 1.2 r, e = 1/4
find speed(A)
"""


def test_marks_of_right_angles_are_smaller_than_their_triangles() -> None:
    (scene,) = scenes(solved(SMALL))
    parts = [s for s in scene.shapes if isinstance(s, Arrow) and s.role == "component"]
    marks = [s for s in scene.shapes if isinstance(s, RightAngle)]
    assert len(marks) == len(parts) / 2 >= 2
    for mark in marks:
        sides = [
            length(part.end - part.start)
            for part in parts
            if min(length(part.start - mark.corner), length(part.end - mark.corner)) < NEAR
        ]
        assert len(sides) == 2 and mark.size < min(sides) / 3


def test_a_component_under_its_velocity_has_an_arrow_beside_it() -> None:
    (scene,) = scenes(solved(SMALL))
    _, after = shown(scene)
    velocity, disc = after.velocity("B"), after.discs["B"]
    (w,) = (x for x in scene.labels if to_text(x.content) == "w")
    senses = after.of(Arrow, "sense")
    assert min(length(w.at - (s.start + s.end) / 2) for s in senses) < NEAR
    assert any(angle_between(s.end - s.start, velocity) < 0.2 for s in senses)
    assert length(w.at - disc.centre) > disc.radius + length(velocity)


def test_the_description_says_the_picture() -> None:
    (scene,) = scenes(solved(WALL))
    assert scene.description == (
        "P touches the wall W, which is horizontal. "
        "Before: P moves at u at 40° to W, towards it and to the right. "
        "After: P moves at 0.831u at 22.8° to W, away from it and to the right. "
        "The impulse on P is perpendicular to W. "
        "Drawn for α = 40° and e = ½."
    )


def test_a_component_that_turns_out_negative_has_its_sense_beside_it() -> None:
    question = """
    sphere A: mass 2, velocity 3i - 4j
    sphere B: mass 3, velocity 2i + 3j
    A hits B: along j, e = 3/7
    find velocity(A), deflection(A), deflection(B)
    """
    (scene,) = scenes(solved(question))
    _, after = shown(scene)
    (sense,) = after.of(Arrow, "sense")  # w = −1
    assert (sense.end - sense.start).y > 0
    assert {"v", "w", "3", "2", "δ_A", "δ_B"} <= set(after.labels())
    assert len(scene_axes(scene)) == 2


def scene_axes(scene: Scene) -> list[Arrow]:
    return [s for s in scene.shapes if isinstance(s, Arrow) and s.role == "axis"]


def test_axes_only_where_they_are_spoken_of() -> None:
    question = "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
    (scene,) = scenes(solved(question + "A hits B: along i\nfind speed(A)"))
    assert not scene_axes(scene)
    (scene,) = scenes(solved(question + "A hits B: along 60°\nfind speed(A)"))
    assert len(scene_axes(scene)) == 2


def test_what_is_given_after_the_impact_is_labelled_by_its_value() -> None:
    question = """
    sphere A: velocity 3i - 4j
    sphere B: mass 3, velocity 2i + 3j
    A hits B: along j
    given velocity(A) = 3i + 2j, velocity(B) = 2i - j
    find mass(A), e
    """
    (scene,) = scenes(solved(question))
    _, after = shown(scene)
    assert sorted(after.labels()) == ["1", "2", "2", "3", "3", "A", "B"]
    assert not after.of(Arrow, "sense")


def test_given_components_are_labelled_by_their_letters() -> None:
    question = """
    sphere A: mass 2
    sphere B: mass 1, velocity -2i + q j
    A hits B: along i, e = 1/2
    given velocity(A, 0) = p i + 3j, velocity(A) = 2i + 3j, speed(B) = 10
    find p, q
    """
    (scene,) = scenes(solved(question))
    before, after = shown(scene)
    assert {"2", "3", "p", "q"} <= set(before.labels())
    assert {"2", "3", "q", "10"} <= set(after.labels())


def test_one_of_several_solutions_is_named() -> None:
    question = """
    sphere A: mass m, velocity u at 45°
    sphere B: mass 2m, at rest
    A hits B: along i
    given angle(velocity(A), line_of_centres) = arctan(4)
    find e
    """
    solution = solved(question)
    assert len(solution["e"].answers) == 2
    (scene,) = scenes(solution)
    assert to_text(scene.note) == "Drawn for e = ⅞."


def test_an_impulse_from_outside() -> None:
    question = "sphere P: mass 2, velocity 3i\nP receives 2i - 8j\nfind velocity(P)"
    (scene,) = scenes(solved(question))
    before, after = shown(scene)
    assert after.velocity("P")[0] == pytest.approx(before.velocity("P")[0] * 4 / 3)
    assert -after.velocity("P")[1] == pytest.approx(after.velocity("P")[0])
    (impulse,) = after.of(Arrow, "impulse")
    assert angle_between(impulse.end - impulse.start, (2, -8)) < NEAR


def test_long_names_stand_in_their_spheres_and_long_labels_are_left_out() -> None:
    question = """
    sphere Ball1: mass 2, velocity sqrt(g h/(2 + k) + u^2/(1 + k) + k g h + 2 u k + u^2 k^2 + g k) i
    sphere B: mass 7/2, at rest
    Ball1 hits B: along i
    find energy_lost
    """
    (scene,) = scenes(solved(question))
    before, _ = shown(scene)
    assert sorted(before.labels()) == ["2", "7/2", "B", "Ball1", "at rest"]
    (name,) = [x for x in place(scene).labels if to_text(x.label.content) == "Ball1"][:1]
    disc = before.discs["Ball1"]
    corners = [(x, y) for x in name.box[::2] for y in name.box[1::2]]
    assert all(length((x - disc.centre.x, y - disc.centre.y)) < disc.radius for x, y in corners)


def test_an_arrow_too_short_to_be_seen_is_longer_than_to_scale_and_the_note_says_so() -> None:
    question = """
    sphere A: mass 1, velocity 100i + 50j
    sphere B: mass 100, velocity 0.3j
    A hits B: along i, e = 1
    find velocity(A)
    """
    (scene,) = scenes(solved(question))
    check(scene)
    before, after = shown(scene)
    assert length(before.velocity("B")) == pytest.approx(TINY)
    assert length(after.velocity("B")) > TINY
    assert to_text(scene.note) == (
        "The shortest arrows are longer than to scale. Speeds are in m s⁻¹."
    )


# --- values ---------------------------------------------------------------------------------------


def test_pleasant_values_satisfy_what_is_given() -> None:
    question = """
    sphere A: mass m, velocity u at alpha
    sphere B: mass k m, at rest
    A hits B: along i
    given along(velocity(A), i) < 0, k > 3, e < 2/3
    find range of k
    """
    solution = solved(question)
    part = solution.parts[None]
    told = motion(solution, part, part.branches[0])
    letters = {chosen.name: chosen.value for chosen, _ in told.free}
    assert letters["k"] > 3 and letters["e"] < 2 / 3
    assert letters["e"] * letters["k"] > 1  # for A comes back
    again = motion(solution, part, part.branches[0])
    assert [chosen for chosen, _ in again.free] == [chosen for chosen, _ in told.free]
    assert part.branches[0].objection({**told.numbers, "k": told.numbers["k"] / 100}) is not None


def test_values_show_nothing_that_is_so_by_chance() -> None:
    # With the first choice for e and k, ½ and 2, the first sphere would be brought to rest.
    question = """
    sphere A: mass m, velocity u i
    sphere B: mass k m, at rest
    A hits B: along i
    find speed(B)
    """
    (scene,) = scenes(solved(question))
    _, after = shown(scene)
    assert length(after.velocity("A")) > 1


# --- the front door -------------------------------------------------------------------------------


def test_each_event_is_drawn_once_and_a_part_by_its_own_values() -> None:
    question = """
    wall W: along i
    sphere P: velocity u at alpha to W
    P hits W: e = f
    part a
    find speed(P)
    part b
    given alpha = 60°
    find speed(P)
    """
    solution = solved(question)
    (first,) = scenes(solution)
    (second,) = scenes(solution, "b")
    assert (first.part, first.event) == ("a", 1)
    assert (second.part, second.event) == ("b", 1)
    assert to_text(first.note) == "Drawn for α = 40° and f = ½."
    assert to_text(second.note) == "Drawn for f = ½."
    with pytest.raises(KeyError, match="no part 'c'"):
        scenes(solution, "c")


def test_a_contradiction_cannot_be_drawn() -> None:
    question = "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W\ngiven speed(P) = 6\nfind e"
    with pytest.raises(r.RestitutionError):
        r.draw(solved(question.replace("6", "6, e = 1/2")))


def test_drawings_show_themselves() -> None:
    drawings = r.draw(solved(WALL))
    assert len(drawings.svgs) == 1
    ((kind, shown_as),) = drawings._repr_mimebundle_().items()
    if kind == "image/png":
        assert shown_as.startswith(b"\x89PNG")
    else:
        assert kind == "image/svg+xml" and shown_as.startswith("<svg")


def test_the_figure_of_a_question_says_nothing_of_its_answers() -> None:
    scene = figure(solved(WALL))
    assert scene is not None
    assert [panel.name for panel in scene.panels] == ["Before"]
    assert "After" not in scene.description and "e =" not in scene.description
    (before,) = shown(scene)
    assert not before.of(Arrow, "impulse")


def test_the_figure_shows_no_letter_at_the_value_that_is_found() -> None:
    scene = figure(solved(text("component-of-either-sign")))  # p is found to be 4
    assert scene is not None and scene.note is not None
    assert to_text(scene.note) == "Not to scale."
    assert "45" not in scene.description and "4 m s" not in scene.description
    (before,) = shown(scene)
    assert not before.of(Arrow, "component")
    assert "p𝐢 − 4𝐣" in before.labels()


def test_the_figure_does_not_show_a_direction_that_is_sought() -> None:
    assert figure(solved(text("unknown-wall"))) is None


def test_a_picture_to_scale_does_not_say_that_it_is_not() -> None:
    scene = figure(solved(text("angle-on-either-side")))  # e is found, and shapes what is after
    assert scene is not None and scene.note is None


def test_an_impossible_impact_is_not_drawn_as_if_it_happened() -> None:
    impossible = """
        wall W: along i
        sphere P: mass 1, velocity 5i - 3j
        P hits W: e = e
        given speed(P) = 10
        find e
    """
    (scene,) = pictures(solved(impossible))
    assert [panel.name for panel in scene.panels] == ["Before"]
    assert scene.note is not None and "not possible" in to_text(scene.note)
    assert "not possible" in scene.description and "After" not in scene.description


def test_the_supplement_of_an_angle_less_than_half_a_turn_is_the_angle() -> None:
    scene = figure(
        solved(
            """
            wall W: along i
            sphere P: mass 1, velocity u at (pi - beta) to W
            P hits W: e = 1/2
            find speed(P)
            """
        )
    )
    assert scene is not None
    assert "β" in shown(scene)[0].labels()


def test_a_component_too_short_to_be_seen_has_no_label() -> None:
    steep = "wall W: along i\nsphere P: mass 1, velocity u at 89.9° to W\nP hits W: e = 1/2\n"
    (scene,) = scenes(solved(steep + "find speed(P)"))
    for each in shown(scene):
        assert not any("cos" in label for label in each.labels())


def test_an_arrow_longer_than_to_scale_has_its_components_too() -> None:
    (scene,) = scenes(
        solved(
            """
            sphere A: mass 1, velocity 60i + 80j
            sphere B: mass 500, velocity -2i - 3j
            A hits B: along i, e = 1/2
            find velocity(A), velocity(B)
            """
        )
    )
    before, after = shown(scene)
    assert {"2", "3"} <= set(before.labels()) and {"w", "3"} <= set(after.labels())


@pytest.mark.parametrize(
    ("wall", "velocity"),
    [("25°", "7 at 50°"), ("155°", "8 at 40°"), ("theta", "u at 60°")],
    ids=["acute", "obtuse", "letter"],
)
def test_the_angle_of_a_wall_is_before_it_and_not_among_its_hatching(
    wall: str, velocity: str
) -> None:
    tale = f"wall W: along {wall}\nsphere P: velocity {velocity} to W\nP hits W: e = 1/2\n"
    before, _ = shown(scenes(solved(tale + "find speed(P)"))[0])
    (drawn,) = before.of(StraightWall)
    (arc,) = (
        a
        for a in before.of(Arc)
        if min(length(a.centre - drawn.start), length(a.centre - drawn.end)) < NEAR
    )
    (line,) = (x for x in before.of(Line, "across") if length(x.start - arc.centre) < NEAR)
    assert (line.end - line.start).dot(drawn.far) < 0


@pytest.mark.parametrize(
    ("tale", "angle"),
    [
        (text("find-e-at-a-wall"), "30°"),
        ("wall W: along 40°\nsphere P: velocity u at 70° to W\nP hits W: e = 1/2\n", "70°"),
        ("wall W: along j\nsphere P: velocity 3 at 12° to W\nP hits W: e = 1\n", "12°"),
    ],
    ids=["level", "slanting", "upright"],
)
def test_no_component_is_between_an_angle_and_its_arc(tale: str, angle: str) -> None:
    (scene,) = scenes(solved(tale + "find speed(P)"))
    (label,) = (x for x in place(scene).labels if to_text(x.label.content) == angle)
    left, bottom, right, top = label.box
    middle = Vector((left + right) / 2, (bottom + top) / 2)
    parts = (
        s for s in scene.shapes if isinstance(s, Arrow) and s.role in ("component", "velocity")
    )
    assert not any(parted(middle, label.label.at, piece) for part in parts for piece in ink(part))


def test_a_long_name_stands_beside_its_sphere() -> None:
    tale = "wall W: along i\nsphere Theveryheavyball: velocity u at 40° to W\n"
    tale += "Theveryheavyball hits W: e = 1/2\nfind speed(Theveryheavyball)"
    (scene,) = scenes(solved(tale))
    named = [each for each in scene.labels if to_text(each.content) == "Theveryheavyball"]
    assert len(named) == 2 and all(each.size > 2.5 and not each.fixed for each in named)


def test_a_picture_is_light_to_import() -> None:
    code = "import sys, restitution.drawing; print(*sys.modules)"
    made = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not {"sympy", "ziamath", "numpy"} & set(made.stdout.split())
