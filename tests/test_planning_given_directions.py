"""A velocity after a wall of which the direction is given is a letter times that, and resolved."""

from __future__ import annotations

import re

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

UNKNOWN_ANGLE = """
wall W: along theta
sphere P: mass 2, velocity 6i
P hits W: e = 1/4
given velocity(P) in the direction of j
find theta, velocity(P), energy_lost
"""

KNOWN_WALL = """
wall W: along 3i + 4j
sphere P: mass m, velocity u i
P hits W
find velocity(P), energy_lost
given velocity(P) perpendicular to i
find e
"""

SLANTING = """
wall W: along 3i + 4j
sphere P: mass 2, velocity 10i + 5j
P hits W
given velocity(P) parallel to i + 2j
find e
"""


def text_of(statement: str) -> str:
    problem = parse(statement)
    solution = solve(problem)
    assert follow(plan(solution), Oracle(roles(problem))) == ()
    return to_text(explain(solution), 80)


def test_both_laws_of_the_resolved_velocity_are_divided() -> None:
    text = text_of(UNKNOWN_ANGLE)
    for line in (
        "It is given that 𝐯_P is in the direction of 𝐣:\n      𝐯_P = V𝐣",
        "V sin θ = 6 cos θ",
        "Dividing (2) by (3):\n      tan θ = 4/tan θ",
    ):
        assert line in text


def test_a_wall_that_is_known_tells_the_speed_by_what_stays() -> None:
    text = text_of(KNOWN_WALL)
    assert "4V/5 = 3u/5" in text
    assert "V = 3u/4" in text
    assert "16e" not in text


@pytest.mark.parametrize(
    ("statement", "loss"),
    [(UNKNOWN_ANGLE, "½ × 2 × 6² − ½ × 2 × 3²"), (KNOWN_WALL, "½mu² − ½m(3u/4)²")],
)
def test_the_energy_is_of_the_speeds_that_are_read_off(statement: str, loss: str) -> None:
    text = " ".join(text_of(statement).split())
    assert re.search(rf"Kinetic energy: (\(iii?\) )?kinetic energy lost = {re.escape(loss)}", text)


def test_a_velocity_of_a_slanting_direction_is_a_multiple_of_its_vector() -> None:
    text = text_of(SLANTING)
    lead = "It is given that 𝐯_P is parallel to 𝐢 + 2𝐣, so for some number k:"
    assert f"{lead}\n    𝐯_P = k(𝐢 + 2𝐣)" in text
    assert "Let k" not in text


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (
            """
wall W: along 2i - j
sphere P: velocity i + 6j
P hits W
given velocity(P) in the direction of -i - j
find e, speed(P)
""",
            (
                "Scalar product with 2𝐢 − 𝐣, parallel to W, before the impact:",
                "𝐮_P · (2𝐢 − 𝐣) = 2 − 6 = −4",
                "𝐯_P = k(−𝐢 − 𝐣)",
                "𝐯_P · (2𝐢 − 𝐣) = −2k + k = −k",
                "−k = −4",
                "k = 4\n",
                "12 = 13e",
            ),
        ),
        (
            """
wall V: along i - 3j
sphere Q: mass 3, velocity 5i + j
Q hits V
given velocity(Q) parallel to i
find speed(Q)
""",
            ("𝐯_Q · (𝐢 − 3𝐣) = s", "does not change:\n    s = 2 m s⁻¹"),
        ),
        (
            """
wall W: along 2i + 3j
sphere P: mass m, velocity 6u i + u j
P hits W
given velocity(P) parallel to 3i + 2j
find speed(P)
""",
            ("𝐯_P = k(3𝐢 + 2𝐣)", "12k = 15u", "k = 5u/4"),
        ),
    ],
)
def test_what_stays_is_a_scalar_product_with_the_vector_of_the_wall(
    statement: str, lines: tuple[str, ...]
) -> None:
    text = text_of(statement)
    for line in lines:
        assert line in text, text
    assert "unit vector" not in text


def test_a_direction_told_by_a_slanting_angle_is_no_vector_with_roots() -> None:
    text = text_of(SLANTING.replace("velocity(P) parallel to i + 2j", "direction(P) = arctan(2)"))
    assert "2 = (8 + 3e)/(6 − 4e)" in text


def test_a_body_that_was_struck_along_an_axis_is_turned_at_right_angles_by_a_wall() -> None:
    text = text_of(
        "sphere A, B: mass m\nsphere A: velocity u at 60°\nsphere B: at rest\nwall W: along theta\n"
        "A hits B: along i, e = 1/2\nB hits W: e = 1/3\ngiven deflection(B) = 90°\nfind theta\n"
    )
    assert "3 cos²θ = sin²θ" in text
    assert "θ = 60°" in text


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            (
                "wall W: along i + 3j\nsphere P: mass 3, velocity 2i + lambda j\n"
                "P hits W: e = 1/2\n"
                "given velocity(P) parallel to j\nfind lambda\n"
            ),
            ("the component in the direction of 𝐢 is zero", "3(λ − 6)/20 + (2 + 3λ)/10 = 0"),
        ),
        (
            (
                "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 1, velocity p i - j\n"
                "A hits B: along i + j, e = 1/2\ngiven velocity(A) parallel to 3i + j\nfind p\n"
            ),
            ("the component in the direction of −𝐢 + 3𝐣 is zero: v − √2 = 0",),
        ),
    ],
)
def test_a_component_across_a_given_direction_by_those_that_slant(
    text: str, lines: tuple[str, ...]
) -> None:
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation, 120).split())
    assert explanation.followed
    assert not [line for line in lines if line not in shown], shown
