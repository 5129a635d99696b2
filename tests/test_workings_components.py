"""Components before an impact: each with its product, along unit vectors that have a name."""

from __future__ import annotations

from functools import cache

import pytest
from workings import printed_with

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

BY_ANGLES = """
sphere A: mass 2m, velocity 3u at 90°
sphere B: mass m, velocity u i
A hits B: along i - j, e = 1/2
find speed(A), velocity(A)
"""

ALONG_A_LETTER = """
sphere A: mass 3m, velocity 2u i
sphere B: mass m, at rest
A hits B: along theta
given sin(theta) = 5/13, e = 1/2
find angle(velocity(A), line_of_centres)
"""

FROM_THE_LINE = """
sphere A: mass m, velocity 3u at alpha from i + 2j
sphere B: mass 2m, at rest
A hits B: along i + 2j, e = 1/2
given sin(alpha) = 3/5
find speed(A)
"""

TWO_LETTERS = """
sphere A: mass 2m, velocity 2u at alpha
sphere B: mass m, at rest
A hits B: along theta, e = 1/2
find impulse
"""

ALONG_THE_LINE = """
sphere A: mass 2m, velocity 2u at 45°
sphere B: mass m, at rest
A hits B: along i + j, e = 1/2
find speed(B)
"""

TWO_SLANTS = """
sphere A: mass 2m, velocity u i
sphere B, C: mass m, at rest
A hits B: along 30°, e = 1/2
A hits C: along -30°, e = 1/2
find velocity(A)
"""

TWO_SLANTS_LEFT_AT_REST = """
sphere A, B, C: mass m
sphere A: velocity u i
sphere B, C: at rest
A hits B: along 30°, e = 1
A hits C: along -30°, e = 1/2
find velocity(A)
"""
TWO_VECTORS_LEFT_AT_REST = """
sphere A, B, C: mass m
sphere A: velocity u i
sphere B, C: at rest
A hits B: along 3i + 4j, e = 1
A hits C: along 12i - 5j, e = 1/2
find velocity(A)
"""


@cache
def working(text: str) -> str:
    """A printed working, every line of which the follower accepts, with single spaces."""
    solution = solve(parse(text))
    oracle = Oracle(roles(solution.problem))
    assert follow(plan(solution), oracle) == ()
    return " ".join(to_text(explain(solution), 80).split())


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (BY_ANGLES, ("𝐮_A · 𝐧 = −3u/√2 = −3√2 u/2", "𝐮_A · 𝐭 = 3u/√2 = 3√2 u/2")),
        (BY_ANGLES, ("𝐮_B · 𝐧 = u/√2 = √2 u/2", "m(√2 u/2)")),
        (
            ALONG_A_LETTER,
            (
                "𝐧 = cos θ 𝐢 + sin θ 𝐣 = (12𝐢 + 5𝐣)/13",
                "𝐭 = −sin θ 𝐢 + cos θ 𝐣 = (−5𝐢 + 12𝐣)/13",
                "𝐮_A · 𝐧 = 2u cos θ = 24u/13",
                "𝐮_A · 𝐭 = −2u sin θ = −10u/13",
            ),
        ),
        (FROM_THE_LINE, ("𝐮_A · 𝐧 = 3u cos α = 12u/5", "𝐮_A · 𝐭 = 3u sin α = 9u/5")),
        (TWO_LETTERS, ("𝐮_A · 𝐧 = 2u cos(α − θ)",)),
    ],
)
def test_a_component_stands_with_its_product(text: str, lines: tuple[str, ...]) -> None:
    for line in lines:
        assert line in working(text)


def test_who_moves_along_the_line_of_centres_is_not_resolved() -> None:
    assert "·" not in working(ALONG_THE_LINE)


def test_a_velocity_is_put_together_before_it_is_resolved_along_another_slant() -> None:
    text = working(TWO_SLANTS)
    assert text.index("𝐯_A1 = (√3 u/4)((√3/2)𝐢 + ½𝐣)") < text.index("𝐯_A1 · 𝐧₂ = (√3/2) × (5u/8)")


def test_a_velocity_along_one_slant_is_resolved_by_the_product_of_two_unit_vectors() -> None:
    text = working(TWO_VECTORS_LEFT_AT_REST)
    assert "as 𝐯_A1 = −(4u/5)𝐭₁" in text
    assert "𝐯_A1 · 𝐧₂ = (4u/5)((4 × 12 + 3 × 5)/65) = 252u/325" in text


def test_a_velocity_along_one_slant_is_resolved_by_the_angle_between_slants_at_angles() -> None:
    text = working(TWO_SLANTS_LEFT_AT_REST)
    assert "A moves perpendicular to the line of centres of its last impact, at 30° to" in text
    assert "𝐯_A1 · 𝐧₂ = (u/2) cos 30° = √3 u/4" in text
    assert "𝐯_A1 · 𝐭₂ = −(u/2) sin 30° = −u/4" in text


STRUCK = """
sphere A: mass 4, velocity 3i + 2j
sphere B: mass 2, at rest
wall W: along i + j
A hits B: along i, e = 1/2
B hits W
part a
find velocity(A, 1), velocity(B, 1)
part b
given speed(B, 2) = speed(A, 1)
find e
part c
given e = sqrt(14)/6
find angle(velocity(B), velocity(A))
"""


def test_the_normal_of_a_wall_points_towards_it_for_who_was_struck() -> None:
    text = " ".join(to_text(explain(solve(parse(STRUCK)), check=True), 100).split())
    assert "𝐧 = (𝐢 − 𝐣)/√2 be the unit vector perpendicular to W, towards it" in text
    assert "Components before the impact, as 𝐯_B1 = 3𝐢 from part (a): 𝐯_B1 · 𝐧 = 3(√2/2)" in text
    assert text.count("B was at rest") == 1
    assert "cos β = ((42 + √14)/8)/((5/2) × (5/2))" in text


def test_components_of_who_takes_no_part_in_an_impact_are_not_before_it() -> None:
    statement = """
sphere P: mass m, velocity u i
sphere Q: mass 2m, at rest
wall W: along j
P hits Q: along 30°, e = 3/4
Q hits W
given velocity(Q) perpendicular to velocity(P, 1)
find e
"""
    text = " ".join(to_text(explain(solve(parse(statement + "unknown e")), marks="none")).split())
    assert "Components of 𝐯_P: component of 𝐯_P along 𝐢" in text


def test_a_component_of_the_data_is_worked_out_where_its_value_hides_the_speed() -> None:
    """5u cos α = 4u has a line; u cos α = 4u/5 is seen, and at a wall the law has the sine."""
    text = """
sphere A: mass 3m, velocity {}u at alpha
sphere B: mass m, velocity 13u at beta from -i
A hits B: along i, e = 1/2
given cos(alpha) = 4/5, tan(beta) = 5/12
find velocity(A)
"""
    along = "component of 𝐮_A along 𝐢"
    both = (f"{along} = 5u cos α = 4u", "component of 𝐮_B along 𝐢 = −13u cos β = −12u")
    printed_with(text.format(5), both)
    assert along not in printed_with(text.format(""), ())
    wall = """
wall W: along i
sphere P: mass m, velocity 10u at beta to W
P hits W: e = 1/3
given cos(beta) = 3/5
find speed(P)
"""
    printed_with(wall, ("away from W = ⅓ × 10u sin β = 8u/3",))


def test_a_speed_of_approach_of_one_is_seen_at_a_wall() -> None:
    text = """
wall W: along i
sphere P: mass 2, velocity 4i {} j
P hits W: e = 1/2
find velocity(P)
"""
    printed_with(text.format("-"), ("component of 𝐯_P along 𝐣 = ½ × 1 = ½ m s⁻¹",))
    printed_with(text.format("+"), ("component of 𝐯_P along 𝐣 = −½ × 1 = −½ m s⁻¹",))


def test_a_component_with_a_speed_that_was_found_has_a_line_where_a_loss_takes_it() -> None:
    text = """
sphere A: mass 4m, velocity 5u at alpha
sphere B: mass m, velocity v at beta from -i
given sin(alpha) = 3/5, sin(beta) = 5/13
A hits B: along i, e = 1/2
given direction(A) = 90°
find v, energy_lost
"""
    along = "component of 𝐮_B along 𝐢 = −v cos β = −28u/3"
    printed_with(text, ("v = 91u/9", along, "½m((28u/3)² − (20u/3)²)"))


def test_a_sphere_resolved_at_a_line_of_centres_at_90_degrees_moves_at_its_angle_to_it() -> None:
    text = """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
sphere C: mass 3m, at rest
A hits B: along 30°, e = 1/3
B hits C: along 90°, e = 1/3
show velocity(B) perpendicular to velocity(C)
"""
    printed_with(
        text,
        (
            "moved off along the line of centres of that impact, at 60° to this one. Component",
            "component of 𝐯_B1 along 𝐣 = (√3 u/3) cos 60° = √3 u/6",
            "B moves perpendicular to the line of centres, and C, which was at rest, along it. So",
        ),
    )
