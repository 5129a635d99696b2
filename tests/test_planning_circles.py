"""Circular walls: the radius at the impact, the chord to the next, and what a follower refuses."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

import pytest
from corruptions import corruptions
from workings import planned

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.problem import Problem
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

INSIDE = """
wall C: circle centre (0, 0) radius 5a
sphere P: mass m, at (0, 3a), velocity -2u i
P hits C: e = 1/2
find time(1), position(P), velocity(P)
P hits C: e = 1/4
find speed(P), time(2)
"""
OUTSIDE = """
wall C: circle centre (1, 2) radius 5
sphere P: at (-43/5, -29/5), velocity 3i + 4j
P hits C: e = 2/3
find time(1), speed(P)
"""


def printed(problem: Problem, derivation: Derivation) -> str:
    """The working as text."""
    return to_text(explanation_of(awarded(derivation), problem))


def lines(derivation: Derivation, record: str) -> list[str]:
    """What the lines of a record say."""
    return [
        write_relation(each.relation)
        for each in derivation.lines
        if each.move.record == record and isinstance(each.relation, Relation)
    ]


def said(derivation: Derivation) -> list[str]:
    """What all lines say."""
    own = (each.relation for each in derivation.lines)
    return [write_relation(each) for each in own if isinstance(each, Relation)]


def spoiled(problem: Problem, derivation: Derivation, line: Line, text: str) -> bool:
    """Whether a follower refuses a working in which one line says something else."""
    names = {"P": "sphere", "C": "wall"}
    other = replace(line, relation=read_relation(text, names))
    changed = tuple(other if each is line else each for each in derivation.lines)
    return follow(replace(derivation, lines=changed), Oracle(roles(problem))) != ()


def test_inside_by_the_radius_and_then_by_the_chord() -> None:
    problem, derivation = planned(INSIDE)
    assert lines(derivation, "chord") == [
        "along(velocity(P, 1), line_of_centres(2)) = 4u/5",
        "across(velocity(P, 1), line_of_centres(2)) = 6u/5",
        (
            "distance(position(P, 1), position(P, 2)) = 2(5a) (4u/5/(2sqrt(13) u/5)) = "
            "20sqrt(13) a/13 [rearrange]"
        ),
        "time(2) - time(1) = 20sqrt(13) a/13/(2sqrt(13) u/5) = 50a/(13u) [rearrange]",
    ]
    text = printed(problem, derivation)
    assert "t₁ = 2a/u, as t₁ > 0" in text
    assert "the radius to P is" not in text  # the unit vector says it


def test_outside_the_nearer_of_two_points_is_struck() -> None:
    problem, derivation = planned(OUTSIDE)
    text = printed(problem, derivation)
    assert "t = 8/5 s or 16/5 s" in text
    assert "as P is moving towards C then" in text


LEVEL = """
wall C: circle centre (1, 2) radius 5
sphere P: at ({x}, 5), velocity 3i
P hits C: e = 2/3
find {asked}
"""


def test_parallel_to_an_axis_the_place_is_where_that_line_meets_the_circle() -> None:
    problem, derivation = planned(LEVEL.format(x=-9, asked="position(P), time(1)"))
    text = printed(problem, derivation)
    assert "P moves parallel to the x-axis" in text
    assert "x = −3 m, as P reaches that point first" in text
    # One equation with two roots is enough: the time is the distance over the speed.
    assert sum(each.move.id == "roots" for each in derivation.lines) == 1
    assert "t = (9 − 3)/3 = 2 s" in text


def test_parallel_to_an_axis_from_inside_no_time_is_found_that_nobody_asks_for() -> None:
    problem, derivation = planned(LEVEL.format(x=1, asked="speed(P)"))
    assert "time(" not in " ".join(said(derivation))
    (kept,) = (each for each in derivation.lines if each.move.id == "reject")
    assert spoiled(problem, derivation, kept, "x = -3")
    # With the time it is the equation for that, which has one positive root.
    _, derivation = planned(LEVEL.format(x=1, asked="time(1), speed(P)"))
    assert "x = " not in " ".join(said(derivation))


def test_a_ball_with_a_radius_comes_less_far_inside_and_less_near_outside() -> None:
    inside = """
    wall C: circle centre (0, 0) radius 6
    sphere P: at (4, 0), velocity 3j, radius 1
    P hits C: e = 1/3
    find time(1), speed(P)
    """
    outside = """
    wall C: circle centre (0, 0) radius 4
    sphere P: at (-9, 3), velocity 2i, radius 1
    P hits C: e = 1/3
    find time(1), speed(P)
    """
    _, derivation = planned(inside)
    assert "time(1) = 1" in [write_relation(each.answer) for each in derivation.items]
    _, derivation = planned(outside)
    assert "time(1) = 5/2" in [write_relation(each.answer) for each in derivation.items]


def test_from_the_rim_the_first_path_is_a_chord_too() -> None:
    _, derivation = planned(
        """
        wall C: circle centre (0, 0) radius a
        sphere P: at (-a, 0), velocity u at 30°
        P hits C: e = 1/3
        find time(1), speed(P)
        """
    )
    assert lines(derivation, "chord")[1:3] == [
        "distance(position(P, 0), position(P, 1)) = 2a cos(30°) = sqrt(3) a [rearrange]",
        "time(1) = sqrt(3) a/u",
    ]


def test_from_the_rim_by_vectors_the_place_comes_before_the_components() -> None:
    problem, derivation = planned(
        """
        wall C: circle centre (1, 2) radius 5
        sphere P: at (-2, -2), velocity 7i + j
        P hits C: e = 1/4
        find position(P), velocity(P)
        """
    )
    assert lines(derivation, "chord") == []
    text = printed(problem, derivation)
    assert "(7t − 3)² + (t − 4)² = 5²" in text
    assert "t = 1 s, as t > 0" in text
    assert text.index("5𝐢 − 𝐣") < text.index("𝐧 = (4𝐢 − 3𝐣)/5") < text.index("𝐮_P · 𝐧 =")
    assert "the radius to P" not in text


def test_from_the_rim_a_speed_needs_no_place() -> None:
    _, derivation = planned(
        """
        wall C: circle centre (1, 2) radius 5
        sphere P: at (-2, -2), velocity 7i + j
        P hits C: e = 1/4
        find speed(P), angle(velocity(P), C)
        """
    )
    assert len(lines(derivation, "chord")) == 2
    assert "position(P, 1) = " not in " ".join(said(derivation))


def test_the_length_of_a_chord_is_by_the_angle_of_the_data() -> None:
    _, derivation = planned(
        """
        wall C: circle centre (0, 0) radius a
        sphere P: at (-a, 0), velocity u at alpha
        P hits C
        find time(1), speed(P)
        """
    )
    assert "distance(position(P, 0), position(P, 1)) = 2a cos(alpha)" in lines(derivation, "chord")


def test_both_radii_in_letters_are_added_up() -> None:
    problem, derivation = planned(
        """
        wall C: circle centre (0, 0) radius 2a
        sphere P: at (-4a, a), velocity u i, radius a/2
        P hits C: e = 1/2
        find speed(P)
        """
    )
    assert "at a distance 2a + a/2 = 5a/2 from" in " ".join(printed(problem, derivation).split())


def test_a_deflection_on_a_chord_is_by_angles_that_need_no_place() -> None:
    problem, derivation = planned(
        """
        wall C: circle centre (0, 0) radius a
        sphere P: at (-a, 0), velocity u at 30°
        P hits C: e = 1/3
        find deflection(P)
        """
    )
    assert "angle of deflection of P = 60° + 30° = 90°" in printed(problem, derivation)
    assert "position(P, 1)" not in " ".join(each for each in said(derivation) if "=" in each)


def test_an_angle_with_a_circle_is_with_the_tangent_where_the_velocity_begins() -> None:
    problem = parse(
        """
        wall C: circle centre (0, 0) radius 5
        sphere P: at (-3, 0), velocity 4j
        P hits C: e = 1/2
        P hits C: e = 1/2
        find tan(angle(velocity(P, 0), C)), tan(angle(velocity(P, 1), C)), deflection(P, 1)
        """
    )
    # At (−3, 4) the radius has the slope −4/3, and the path is along j.
    answers = [each.answers[0].value for each in solve(problem).parts[None].items]
    assert [str(each) for each in answers[:2]] == ["4/3", "2/3"]
    assert "The steps from here" not in to_text(explain(solve(problem)))


def test_the_way_back_to_a_point_of_the_wall_is_a_chord() -> None:
    problem, derivation = planned(
        """
        wall C: circle centre (0, 0) radius 2b
        sphere P: at (0, -2b), velocity w at alpha from j
        P hits C: e = 1
        P hits C: e = 1
        P reaches (0, -2b)
        find alpha, time(3)
        """
    )
    text = printed(problem, derivation)
    assert text.count("length of the chord =") == 1
    assert "length of the chord = 2 × 2b cos 30° = 2√3 b" in text
    assert "t₃ − t₂ = t₂ − t₁ = 2√3 b/w" in text
    # Nothing is lost, so the angles are equal without their tangents.
    assert "component of" not in text


def test_a_ball_that_comes_through_the_centre_goes_along_a_diameter() -> None:
    problem, derivation = planned(
        """
        wall C: circle centre (0, 0) radius 5
        sphere P: at (-3, -4), velocity 6i + 8j
        P hits C: e = 1/2
        P hits C: e = 1/2
        find time(2)
        """
    )
    text = printed(problem, derivation)
    assert "P moves through the centre:\n    length of the chord = 2 × 5 = 10 m" in text
    assert "t₂ − t₁ = 10/5 = 2 s" in text


@pytest.mark.parametrize(
    ("velocity", "time"),
    [("3i + 4j", "a/sqrt(3^2 + 4^2) = a/5 [rearrange]"), ("u i", "a/u"), ("u at alpha", "a/u")],
)
def test_from_the_centre_the_radius_over_the_speed_is_the_time(velocity: str, time: str) -> None:
    """No equation of the second degree is needed; with e in letters it comes back along 2a."""
    problem, derivation = planned(f"""
wall C: circle centre (2, 1) radius a
sphere P: mass m, at (2, 1), velocity {velocity}
P hits C: e = e
find time(1)
P hits C: e = e
find time(2)
""")
    assert not follow(derivation, Oracle(roles(problem)))
    assert f"time(1) = {time}" in said(derivation)
    assert not any(each.move.id == "roots" for each in derivation.lines)
    assert "P starts at the centre of C, so it moves along a radius" in printed(problem, derivation)


@pytest.mark.parametrize("seed", range(5))
def test_circles_of_any_numbers(seed: int) -> None:
    draw = random.Random(seed)
    a, _, c = draw.choice([(3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25)])
    x, y, speed = draw.randint(-4, 4), draw.randint(-4, 4), draw.randint(1, 6)
    e, f = (Fraction(draw.randint(1, 3), draw.randint(4, 5)) for _ in "ef")
    planned(
        f"""
        wall C: circle centre ({x}, {y}) radius {c}
        sphere P: mass 2, at ({x}, {y + a}), velocity {speed}i
        P hits C: e = {e}
        find time(1), position(P), impulse
        P hits C: e = {f}
        find time(2), speed(P)
        """
    )


def test_a_wrong_sign_or_radius_is_refused() -> None:
    problem, derivation = planned(INSIDE)
    for line in derivation.lines:
        if not isinstance(line.relation, Relation):
            continue
        text = write_relation(line.relation).partition(" [")[0]
        if line.move.record == "chord" and "distance" not in text:
            left, _, right = text.partition(" = ")
            assert spoiled(problem, derivation, line, f"{left} = -({right.partition(' = ')[0]})")
        elif line.move.record == "chord":
            other = text.partition(" = 20")[0].replace("2(5a)", "2(4a)")
            assert spoiled(problem, derivation, line, other)
        elif text.startswith("line_of_centres(1) parallel to"):
            assert spoiled(problem, derivation, line, "line_of_centres(1) parallel to 4i - 3j")
            assert spoiled(problem, derivation, line, "line_of_centres(1) parallel to -3i + 4j")
        elif line.move.id == "fact":
            assert spoiled(problem, derivation, line, text.replace("(5a)^2", "(6a)^2"))
        elif line.move.id == "reject":
            assert spoiled(problem, derivation, line, "time(1) = -2a/u")


def test_what_is_spoiled_by_machine_is_refused() -> None:
    problem, derivation = planned(
        """
        wall C: circle centre (0, 0) radius 5
        sphere P: at (0, 3), velocity 2i
        P hits C: e = 1/2
        P hits C: e = 1/2
        find speed(P)
        """
    )
    oracle = Oracle(roles(problem))
    # One in seven: each is followed whole.
    some = list(corruptions(derivation))[::7]
    accepted = [
        kind
        for kind, each in some
        if not kind.startswith("line left out") and follow(each, oracle) == ()
    ]
    assert accepted == []


ROUND = """
point A: (0, -a)
wall C: circle centre (0, 0) radius a
sphere P: at A, velocity u at theta from j
P hits C: e = 1/4
P hits C: e = 1/4
P reaches A
find tan(theta)
"""


def test_three_chords_that_close_make_a_right_angle() -> None:
    problem, derivation = planned(ROUND)
    assert lines(derivation, "round") == ["theta + phi = 90° - psi"]
    assert lines(derivation, "tan")[1:] == [
        "tan(phi) = u sin(theta)/(1/4 u cos(theta)) = 4tan(theta) [rearrange]",
        "tan(psi) = u sin(theta)/(1/16 u cos(theta)) = 16tan(theta) [rearrange]",
    ]
    text = printed(problem, derivation)
    assert "so the three angles have the sum 90°" in " ".join(text.split())
    (line,) = (each for each in derivation.lines if each.move.record == "round")
    for wrong in ("theta + phi = 180° - psi", "theta + phi = 90° + psi", "theta - phi = 90° - psi"):
        assert spoiled(problem, derivation, line, wrong)


def test_a_coefficient_by_which_three_chords_close() -> None:
    _, derivation = planned(
        """
        wall C: circle centre (1, 0) radius 2
        sphere P: at (-1, 0), velocity 3 at 30°
        P hits C
        P hits C
        P reaches (-1, 0)
        find e
        """
    )
    assert [write_relation(each.answer) for each in derivation.items] == ["e = 1"]


def test_what_starts_at_the_centre_is_once_along_a_radius() -> None:
    """The radius has no line of its own: it is where the sphere goes from the start."""
    problem, derivation = planned(
        "wall C: circle centre (2, 1) radius 5\nsphere P: mass 2, at (2, 1), velocity 3i + 4j\n"
        "P hits C: e = 1/2\nfind velocity(P), time(1), impulse"
    )
    assert not follow(derivation, Oracle(roles(problem)))
    words = printed(problem, derivation)
    assert words.count("radius,") + words.count("a radius.") == 1
    assert "the radius to P" not in words


def test_chords_that_end_elsewhere_make_no_right_angle() -> None:
    problem, derivation = planned(ROUND)
    (line,) = (each for each in derivation.lines if each.move.record == "round")
    fewer = replace(line, premises=tuple(e for e in line.premises if e != "contact 3"))
    changed = tuple(fewer if each is line else each for each in derivation.lines)
    assert follow(replace(derivation, lines=changed), Oracle(roles(problem))) != ()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            (
                "wall C: circle centre (1, 2) radius 10\nsphere P: at (1, 2), velocity 4i - 3j\n"
                "P hits C: e = 1/3\nfind position(P), velocity(P)"
            ),
            "P strikes C at right angles. Component before the impact:",
        ),
        (
            (
                "wall A: along i\nwall B: along 135°\nsphere P: velocity u at alpha to A\n"
                "P hits A: e = 1/2\ngiven velocity(P, 1) perpendicular to B\nfind tan(alpha)\n"
                "P hits B: e = 1/2\nfind velocity(P)"
            ),
            "P strikes B at right angles, so its component before the impact is its speed:",
        ),
    ],
)
def test_a_direct_impact_has_one_component(text: str, words: str) -> None:
    problem, derivation = planned(text)
    said = " ".join(printed(problem, derivation).split())
    assert words in said
    assert "𝐭" not in said
    assert "stays 0" not in said


def test_a_component_that_comes_out_as_zero_is_seen() -> None:
    problem, derivation = planned(
        "wall A: along i\nwall B: along 120°\nsphere P: velocity u at 45° to A\n"
        "P hits A: e = 1/sqrt(3)\nP hits B: e = 2/3\nfind velocity(P)"
    )
    assert "the component in the direction of 𝐭 stays 0" in " ".join(
        printed(problem, derivation).split()
    )


def test_a_chord_that_is_given_after_an_impact_of_unknown_coefficient_is_written() -> None:
    solution = solve(
        parse(
            "wall C: circle centre (0, 5) radius 13\nsphere P: at (-13, 5), velocity 3i + 4j\n"
            "P hits C\nP hits C\ngiven distance(position(P, 1), position(P, 2)) = 3\nfind e"
        )
    )
    assert "78e/√(16 + 9e²)" in str(explain(solution))


def test_the_component_of_who_comes_along_the_radius_is_the_size_of_its_velocity() -> None:
    problem, derivation = planned("""
wall C: circle centre (2, 1) radius 5
sphere P: mass 2, at (2, 1), velocity 3i + 4j
P hits C: e = 1/2
find impulse
""")
    assert not follow(derivation, Oracle(roles(problem)))
    assert "component of 𝐮_P towards C = √(3² + 4²) = 5 m s⁻¹" in printed(problem, derivation)


@pytest.mark.parametrize(("start", "first"), [("(0, 0)", "1"), ("(a, 0)", "1/2")])
def test_who_crosses_a_circle_along_a_diameter_is_sent_straight_back(
    start: str, first: str
) -> None:
    problem = parse(
        f"wall W: circle centre (0, 0) radius 2a\nsphere P: mass m, at {start}, velocity u i\n"
        f"P hits W: e = {first}\nP hits W: e = 1/3\nfind deflection(P), speed(P)\n"
    )
    derivation = plan(solve(problem))
    assert not follow(derivation, Oracle(roles(problem)))
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert "P hits W at right angles, so it is sent straight back: δ = 180°" in text
    assert "90°" not in text
