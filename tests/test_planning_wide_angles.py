"""Angles beyond 90°: impulses and velocities whose direction is to be found."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

KICK = """
sphere P: mass 3, velocity 2i - j
P receives J at theta
given velocity(P) = -i - 5j, {0}
find J, theta
"""
WALL = """
wall W: along 3i + 4j
sphere P: velocity v at theta
P hits W: e = 1/2
given velocity(P) = -5j, {0}
find v, theta
"""


def working(text: str) -> Derivation:
    """The working of a statement, which the follower accepts."""
    problem = parse(text)
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    return derivation


def answers(derivation: Derivation) -> list[str]:
    """The answers as lines say them."""
    return [write_relation(each.answer) for each in derivation.items]


@pytest.mark.parametrize("told", ["180° < theta < 270°", "0 < theta < 360°"])
def test_a_blow_backwards(told: str) -> None:
    derivation = working(KICK.format(told))
    assert answers(derivation) == ["J = 15", "theta = 180° + arctan(4/3)"]
    (last,) = (each for each in derivation.lines if each.move.id == "inverse")
    # Within one turn two angles have one tangent: a component tells which it is.
    assert len(last.premises) == (3 if "360" in told else 2)


def test_a_direction_before_a_slanting_wall() -> None:
    derivation = working(WALL.format("-180° < theta < 180°"))
    assert answers(derivation) == ["v = 2sqrt(13)", "theta = 180° - arctan(1/18)"]
    said = [
        write_relation(e.relation) for e in derivation.lines if isinstance(e.relation, Relation)
    ]
    assert "v cos(theta) = -36/5" in said
    assert "v sin(theta) = 2/5" in said


def test_a_velocity_before_a_blow() -> None:
    derivation = working(
        """
        sphere P: mass m, velocity v at theta
        P receives m u j
        given velocity(P) = -u i + 3u j, 90° < theta < 180°
        find v, theta
        """
    )
    assert answers(derivation) == ["v = sqrt(5) u", "theta = 180° - arctan(2)"]


def test_a_blow_by_the_speed_and_direction_after_it() -> None:
    derivation = working(
        """
        sphere P: mass 1/2, velocity 4i
        P receives J at theta
        given speed(P) = 4, direction(P) = 120°, 0 < theta < 180°
        find theta
        """
    )
    assert answers(derivation) == ["theta = 150°"]


@pytest.mark.parametrize("wrong", ["theta = arctan(4/3)", "theta = 360° - arctan(4/3)"])
def test_the_other_angle_of_a_tangent_is_refused(wrong: str) -> None:
    problem = parse(KICK.format("0 < theta < 360°"))
    derivation = plan(solve(problem))
    names = {"P": "sphere"}
    lines = tuple(
        replace(each, relation=read_relation(wrong, names)) if each.move.id == "inverse" else each
        for each in derivation.lines
    )
    complaints = follow(replace(derivation, lines=lines), Oracle(roles(problem)))
    assert "does-not-follow" in {each.reason for each in complaints}


def test_a_tangent_alone_does_not_tell_an_angle_within_a_turn() -> None:
    problem = parse(KICK.format("0 < theta < 360°"))
    derivation = plan(solve(problem))
    lines = tuple(
        replace(each, premises=each.premises[:2]) if each.move.id == "inverse" else each
        for each in derivation.lines
    )
    complaints = follow(replace(derivation, lines=lines), Oracle(roles(problem)))
    assert "does-not-follow" in {each.reason for each in complaints}


TURNED_BY_A_BLOW = """
sphere P: mass m, velocity u i
P receives J at theta
given {0}, deflection(P) = 90°, speed(P) = u/2
find J, theta
"""


@pytest.mark.parametrize(
    ("range_", "velocity"),
    [("90° < theta < 180°", "u/2 j"), ("-180° < theta < -90°", "-u/2 j")],
)
def test_a_velocity_by_its_size_and_by_how_far_a_blow_turns_it(range_: str, velocity: str) -> None:
    text = TURNED_BY_A_BLOW.format(range_)
    derivation = working(text)
    names = {"P": "sphere"}
    turned = next(each for each in derivation.lines if each.move.record == "turned")
    assert isinstance(turned.relation, Relation)
    assert write_relation(turned.relation) == f"velocity(P, 1) = {velocity}"
    assert "J = sqrt(5) m u/2" in answers(derivation)
    assert not any(each.move.record == "speed" for each in derivation.lines)
    other = velocity.removeprefix("-") if velocity.startswith("-") else f"-{velocity}"
    false = replace(turned, relation=read_relation(f"velocity(P, 1) = {other}", names))
    open_ = replace(turned, premises=tuple(e for e in turned.premises if "theta" not in str(e)))
    open_ = replace(
        open_, premises=tuple(e for e in open_.premises if e not in ("given 1", "given 2"))
    )
    oracle = Oracle(roles(parse(text)))
    for each in (false, open_):
        lines = tuple(each if line is turned else line for line in derivation.lines)
        reasons = {(e.line, e.reason) for e in follow(replace(derivation, lines=lines), oracle)}
        assert (turned.number, "does-not-follow") in reasons


def test_a_deflection_that_may_be_obtuse_or_not_is_a_difference_of_angles() -> None:
    statement = (
        "sphere A: mass k m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\nfind deflection(A)\n"
    )
    assert not working(statement).notes
    text = to_text(explain(solve(parse(statement))), 80)
    assert "δ = β − α = 90° − arctan((2k − 1)/(2(1 + k) tan α)) − α" in text


TURNED = (
    "sphere A: mass m, velocity u at {angle}\nsphere B: mass {mass}, at rest\n"
    "A hits B: along i{e}\ngiven {given}\nshow {shown}"
)


EITHER_SIDE = (
    "sphere A: mass m, velocity u at 45°\nsphere B: mass 3m, at rest\nA hits B: along i\n"
    "part a\ngiven e <= 1/3\nshow deflection(A) <= 45°\n"
    "part b\ngiven e > 1/3\nshow deflection(A) > 45°"
)


def relations(derivation: Derivation) -> list[str]:
    """What the lines say, without the letters that they introduce."""
    lines = (line.relation for line in derivation.lines)
    return [write_relation(each) for each in lines if isinstance(each, Relation)]


def test_a_deflection_beside_a_right_angle_is_told_by_the_sense() -> None:
    told = relations(working(EITHER_SIDE))
    assert {"v >= 0", "beta <= 90°", "v < 0", "beta > 90°"} <= set(told)
    assert not any("tan(" in each for each in told)
    words = to_text(explain(solve(parse(EITHER_SIDE))))
    assert "𝐯_A has no negative component in the direction of 𝐢:" in words


def test_a_deflection_within_what_the_angle_to_a_line_may_be_needs_no_tangent() -> None:
    derivation = working(
        TURNED.format(
            angle="60°", mass="k m", e=", e = 1/2", given="k <= 2", shown="deflection(A) <= 30°"
        )
    )
    assert "tan-from-axis" not in [line.move.record for line in derivation.lines]
    last = derivation.line(derivation.items[0].line)
    assert last is not None
    assert "0° <= beta <= 90°" in last.premises


@pytest.mark.parametrize("wrong", ["beta < 90°", "beta >= 90°", "beta <= 60°"])
def test_a_component_that_may_be_zero_bounds_an_angle_by_a_right_angle_alone(wrong: str) -> None:
    derivation = working(EITHER_SIDE)
    (line,) = [
        each
        for each in derivation.lines
        if isinstance(each.relation, Relation) and write_relation(each.relation) == "beta <= 90°"
    ]
    changed = replace(line, relation=read_relation(wrong, {"A": "sphere", "B": "sphere"}))
    lines = tuple(changed if each is line else each for each in derivation.lines)
    known = roles(parse(EITHER_SIDE))
    complaints = follow(replace(derivation, lines=lines), Oracle(known))
    assert any(each.line == line.number for each in complaints)


def test_the_range_of_a_letter_is_by_its_square_that_grows_with_another() -> None:
    derivation = working(
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\ngiven speed(P) = v\n"
        "find range of v in terms of u, alpha"
    )
    told = relations(derivation)
    assert told[-2:] == ["u^2 cos^2(alpha) <= v^2 <= u^2", "u cos(alpha) <= v <= u"]


@pytest.mark.parametrize(
    ("velocity", "given", "bound", "line"),
    [
        ("4i + j", "given e > 1/9", "60°", "cot δ < √3/3, as e > 1/9"),
        ("4u i + u j", "", "45°", "cot δ < 1, as e ≥ 0"),
    ],
)
def test_an_acute_bound_of_an_angle_that_may_be_obtuse_is_shown_by_its_cotangent(
    velocity: str, given: str, bound: str, line: str
) -> None:
    text = f"""
sphere A: mass m, velocity {velocity}
sphere B: mass 9m, at rest
A hits B: along i, e = e
{given}
show deflection(A) > {bound}
"""
    rows = " ".join(to_text(explain(solve(parse(text)), check=True)).split())
    assert "= (13 − 72e)/(18(1 + e))" in rows
    assert f"{line} DM1 δ > {bound} as the cotangent decreases" in rows


TWICE_TURNED = """
wall OA: along i
wall OB: along 60°
sphere P: velocity u at -120°
P hits OA: e = 1/3
P hits OB: e = 1/2
"""


@pytest.mark.parametrize(
    ("asked", "degrees"),
    [
        ("deflection(P, 1) + deflection(P, 2)", 270),
        ("2 deflection(P, 2)", 360),
        ("3 deflection(P, 1)", 270),
        ("3/2 deflection(P, 2)", 270),
        ("2 deflection(P, 2) - deflection(P, 1)", 270),
    ],
)
def test_sums_and_multiples_of_angles_go_beyond_half_a_turn(asked: str, degrees: int) -> None:
    solution = solve(parse(f"{TWICE_TURNED}find {asked}"))
    (answer,) = solution.parts[None].items[0].answers
    assert answer.value == sp.rad(degrees)


def test_the_sum_of_two_deflections_is_followed() -> None:
    text = f"{TWICE_TURNED}find deflection(P, 1) + deflection(P, 2)"
    working(text)
    assert "= 90° + 180°\n" in to_text(explain(solve(parse(text))))


def test_what_degrees_come_to_is_exact() -> None:
    text = "wall W: along i\nsphere P: velocity -u j\nP hits W: e = 1/2\nfind 200° - deflection(P)"
    assert "= 20°" in to_text(explain(solve(parse(text))))


def test_the_figures_of_a_sum_of_angles_are_degrees() -> None:
    text = to_text(
        explain(
            solve(
                parse(
                    "wall W: along i\nsphere P: velocity -u j\nsphere Q: velocity u at 35° to W\n"
                    "P hits W: e = 1/2\nQ hits W: e = 1/2\nfind deflection(P) + deflection(Q)"
                )
            )
        )
    )
    assert "≈ 180° + 35° + 19.30°" in " ".join(text.split())
    assert "≈ 234°" in text
