"""A later part goes on from what an earlier one has: it is not worked out a second time."""

from __future__ import annotations

import re
from functools import cache

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

STRUCK = """
sphere A: mass 2m, velocity u at theta
sphere B: mass m, at rest
A hits B: along i, e = 1/2
"""
NUMBERS = """
sphere A: mass 4, velocity 5i + j
sphere B: mass 2, velocity -i + 4j
A hits B: along i
given energy_lost = 18
"""
BESIDE = """
sphere A: mass m, velocity 2u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset r, e = 1/2
"""


@cache
def worked(text: str) -> dict[str, str]:
    """What is printed of each part, of a working of which the follower accepts each line."""
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    printed = to_text(explanation, 100)
    assert "not written out" not in printed
    _, *parts = re.split(r"^\((\w)\)$", printed, flags=re.MULTILINE)
    return {
        label: " ".join(part.split()) for label, part in zip(parts[::2], parts[1::2], strict=True)
    }


def test_the_tangent_of_a_direction_is_that_of_the_angle_with_the_line_of_centres() -> None:
    parts = worked(
        STRUCK + "part a\nshow tan(direction(A)) = 2 tan(theta)\n"
        "part b\nshow tan(deflection(A)) = tan(theta)/(1 + 2tan^2(theta))\n"
    )
    assert "no component of 𝐯_A is negative, so the two angles are equal" in parts["b"]
    assert "u sin θ" not in parts["b"]
    assert "tan δ = (2 tan θ − tan θ)/(1 + 2 tan²θ)" in parts["b"]


def test_a_given_tangent_takes_the_form_that_was_shown() -> None:
    for delta in ("delta", "deflection(A)"):
        let = "let delta = deflection(A)\n" if delta == "delta" else ""
        parts = worked(
            STRUCK.replace("theta", "alpha")
            + f"{let}part a\nshow tan({delta}) = tan(alpha)/(1 + 2tan^2(alpha))\n"
            + f"part b\nfind maximum of {delta} over alpha\n"
            + f"part c\ngiven tan({delta}) = 1/3\nfind tan(alpha)\n"
        )
        assert "⅓ = tan α/(1 + 2 tan²α) M1" in parts["c"]
        assert "tan β" not in parts["c"]


def test_a_loss_that_is_given_is_not_worked_out() -> None:
    parts = worked(
        NUMBERS + "part a\nfind e\npart b\nfind total_energy_lost/energy(0) as a percentage\n"
        "part c\nfind energy\n"
    )
    assert "percentage lost = 18/69 = 6/23 ≈ 26.1% M1 A1" in parts["b"]
    assert "by the components" not in parts["b"]
    assert "= 69 − 18 = 51 J" in parts["c"]


def test_the_energy_of_the_only_sphere_is_what_is_left_of_it() -> None:
    parts = worked(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "part a\nshow energy_lost = 1/2 m u^2 (1 - e^2) sin^2(alpha)\n"
        "part b\ngiven alpha = 60°, e = 1/2\nfind energy_lost/energy(0), energy(P)\n"
    )
    assert "kinetic energy of P after the impact = ½mu² − 9mu²/32 = 7mu²/32" in parts["b"]


def test_the_angle_of_the_line_of_centres_with_the_path_comes_of_the_offset() -> None:
    parts = worked(
        BESIDE + "part a\nfind angle(line_of_centres, i)\npart b\nfind speed(B), direction(B)\n"
    )
    assert parts["a"].endswith("sin β = r/(2r) = ½ M1 A1 β = 30° A1")
    lead = "The line of centres makes an angle of 30° with the path of A: "
    assert lead + "unit vector along the line of centres = (√3/2)𝐢 + ½𝐣 Let" in parts["b"]


@pytest.mark.parametrize("delta", ["deflection(P)", "delta"])
def test_an_obtuse_angle_goes_by_the_sign_of_the_tangent_that_was_shown(delta: str) -> None:
    let = "let delta = deflection(P)\n" if delta == "delta" else ""
    parts = worked(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        f"{let}part a\nshow tan({delta}) = (1 + e)tan(alpha)/(1 - e tan^2(alpha))\n"
        f"part b\ngiven tan(alpha) = 2, {delta} > 90°\nfind range of e\n"
        f"part c\ngiven e = 1/3, {delta} < 90°\nfind range of alpha\n"
    )
    assert "tan δ = 2(1 + e)/(1 − 4e)" in parts["b"]
    assert "tan δ ≤ 0, as 90° < δ ≤ 180°" in parts["b"]
    assert "1 − 4e < 0, as e ≥ 0 e > ¼ ¼ < e ≤ 1" in parts["b"]
    assert "3 − tan²α > 0, as α is acute" in parts["c"]
    assert parts["c"].endswith("0 < tan α < √3, as α is acute 0° < α < 60° A1")
    assert "scalar product" not in parts["b"] + parts["c"]


AT_A_WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/2
part a
show energy_lost/energy(0) = 3/4 sin^2(alpha)
"""


@pytest.mark.parametrize("kept", ["energy_lost = 1/4", "energy(P) = 3/4", "energy = 3/4"])
def test_what_is_left_tells_the_share_that_is_lost_and_the_speed(kept: str) -> None:
    parts = worked(f"{AT_A_WALL}part b\ngiven {kept} energy(0)\nfind alpha, speed(P)\n")
    assert "¾ sin²α = ¼" in parts["b"]
    assert "cos α" not in parts["b"]
    assert parts["b"].endswith("speed of P = √3 u/2 ≈ 0.866u A1")
    bounded = kept.replace("=", "<=" if "lost" in kept else ">=")
    parts = worked(f"{AT_A_WALL}part b\ngiven {bounded} energy(0)\nfind range of alpha\n")
    assert "¾ sin²α ≤ ¼" in parts["b"]
    assert "cos α" not in parts["b"]


def test_what_is_left_of_two_spheres_tells_the_share_that_is_lost() -> None:
    parts = worked(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\n"
        "part a\nshow energy_lost/energy(0) = 3/8 cos^2(alpha)\n"
        "part b\ngiven energy = 3/4 energy(0)\nfind alpha\n"
        "part c\ngiven energy >= 7/8 energy(0)\nfind range of alpha\n"
    )
    lost = "kinetic energy lost = ¼ × total kinetic energy before the impact M1"
    assert f"{lost} Substituting for the fraction lost from part (a): ⅜ cos²α = ¼" in parts["b"]
    assert "⅜ cos²α ≤ ⅛" in parts["c"]


def test_a_speed_by_a_share_of_the_energy_is_no_way_to_the_coefficient() -> None:
    parts = worked(
        "wall W: along 3i + 4j\nsphere P: mass 2, velocity 5i\nP hits W\n"
        "part a\ngiven energy_lost = 1/5 energy(0)\nfind speed(P), e\n"
    )
    assert "5² − (speed of P)² = ⅕ × 5² M1 (speed of P)² = 20" in parts["a"]
    assert "4² − (4e)² = ⅕ × 5² DM1 A1" in parts["a"]


def test_a_given_speed_goes_by_the_square_that_was_shown() -> None:
    parts = worked(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1/2\n"
        "part a\nshow speed(P)^2 = u^2 (1 - 3/4 sin^2(alpha))\n"
        "part b\ngiven speed(P) = 3/4 u\nfind sin(alpha)\n"
        "part c\ngiven speed(P) < 2/3 u\nfind range of alpha\n"
    )
    assert "(3u/4)² = u²(1 − ¾ sin²α) M1 9 = 16 − 12 sin²α" in parts["b"]
    assert "u²(1 − ¾ sin²α) < 4u²/9" in parts["c"]


def test_a_velocity_before_a_slanting_wall_comes_of_its_components_and_keeps_them() -> None:
    parts = worked(
        "wall W: along 3i - 4j\nsphere P: mass 1\nP hits W: e = 1/4\ngiven velocity(P) = 5i\n"
        "part a\nfind velocity(P, 0)\npart b\nfind deflection(P), impulse\n"
    )
    assert "4 = −¼(𝐮_P · 𝐧) B1 𝐮_P · 𝐧 = −16 m s⁻¹" in parts["a"]
    assert "a𝐢" not in parts["a"]
    assert "tan β = 16/3" in parts["b"]
    assert "𝐮_P · 𝐧 =" not in parts["b"]


def test_a_component_that_vanishes_is_not_worked_out_from_a_coefficient() -> None:
    parts = worked(
        "sphere A: mass 2m, velocity u at 30°\nsphere B: mass m, velocity u at 150°\n"
        "A hits B: along i\npart a\nfind speed(A)\n"
        "part b\ngiven velocity(A) perpendicular to i\nfind e, impulse\n"
    )
    assert "√3(1 − 2e)u/6 = 0" in parts["b"]
    assert "v = 0" not in parts["b"]
    assert "2m(√3 u/2) = √3 mu" in parts["b"]


CORNER = """
wall AB: along i
wall BC: along 120°
sphere P: mass m, velocity u at 60° to AB
part a
P hits AB: e = 1/3
find {}
show velocity(P) perpendicular to direction(BC)
part b
P hits BC: e = 1/2
find speed(P)
"""


@pytest.mark.parametrize(
    ("asked", "shown"),
    [
        ("angle(velocity(P), AB)", "angle between 𝐯₁ and BC = 60° + 30° = 90° M1 So (ii)"),
        ("velocity(P)", "+ √3(√3 u/6) = 0 M1 A1ft So (ii)"),
    ],
)
def test_a_right_angle_that_was_shown_is_how_the_next_wall_is_struck(
    asked: str, shown: str
) -> None:
    parts = worked(CORNER.format(asked))
    assert f"{shown} 𝐯₁ is perpendicular to BC (as required) A1*" in parts["a"]
    assert "P strikes BC at right angles, so its component before the impact" in parts["b"]
    assert "60°" not in parts["b"] and "· 𝐭" not in parts["b"]


def test_values_go_into_the_square_and_the_energy_that_were_shown() -> None:
    parts = worked(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i\n"
        "part a\nshow speed(A)^2 = 1/4 u^2 ((1 - e)^2 cos^2(alpha) + 4sin^2(alpha))\n"
        "part b\ngiven e = 1/2, speed(A) = 1/2 u\nfind tan(alpha)\n"
    )
    assert "(½u)² = ¼u²((1 − ½)² cos²α + 4 sin²α) M1" in parts["b"]
    assert "v =" not in parts["b"]
    parts = worked(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "part a\nshow energy(P) = 1/2 m u^2 (cos^2(alpha) + e^2 sin^2(alpha))\n"
        "part b\ngiven alpha = 60°, energy(P) = 1/3 energy(P, 0)\nfind e\n"
    )
    assert "mu²(1 + 3e²)/8 = ⅓ × ½mu² M1" in parts["b"]
    assert "component" not in parts["b"]


def test_the_other_sphere_makes_the_angle_of_the_offset_with_the_line_of_centres_too() -> None:
    parts = worked(
        "sphere A: mass 2m, velocity 3u i, radius r\nsphere B: mass m, velocity -3u i, radius r\n"
        "A hits B: offset sqrt(3)r, e = 2/3\n"
        "part a\nfind angle(line_of_centres, i)\npart b\nfind deflection(B)\n"
    )
    assert "δ = 180° − 60° − φ" in parts["b"]


def test_each_case_of_an_earlier_part_tells_what_follows_from_it() -> None:
    parts = worked(
        "sphere A: mass 0.5, velocity 4 at 35°\nsphere B: mass M, at rest\n"
        "A hits B: along i, e = 0.6\ngiven angle(velocity(A), line_of_centres) = 70°\n"
        "part a\nfind M\npart b\nfind speed(B)"
    )
    own = parts["b"]
    assert own.count("If v ≈") == parts["a"].count("If v ≈") == 2
    assert "with w ≈ 2.801 m s⁻¹ from part (a): speed of B ≈ 2.80 m s⁻¹" in own
    assert "with w ≈ 1.131 m s⁻¹ from part (a): speed of B ≈ 1.13 m s⁻¹" in own


def test_cases_of_a_given_fact_stand_in_each_part_in_which_it_is_given() -> None:
    parts = worked(
        "sphere A: mass m, velocity i + 4j\nsphere B: mass 5m, velocity -5i + j\n"
        "A hits B: along j\npart a\ngiven angle(velocity(A), line_of_centres) = 45°\nfind e\n"
        "part b\ngiven angle(velocity(A), line_of_centres) = 45°\nfind speed(B)\n"
    )
    own = parts["b"]
    assert own.count("If v = −1:") == own.count("If v = 1:") == 1
    # What holds in both cases stands above them.
    assert own.index("stays −5 m s⁻¹") < own.index("If v = −1:")


def test_no_case_works_out_once_more_by_what_it_is_told() -> None:
    parts = worked(
        "sphere A: mass m, velocity 5u i + 3u j\nsphere B: mass k m, at rest\n"
        "A hits B: along i, e = 1/2\ngiven speed(A) = sqrt(10) u\npart a\nfind k\n"
        "part b\nfind velocity(B), velocity(A)\npart c\nfind energy_lost"
    )
    assert "If k = 4: Substituting for k in (4): w = 3u/2" in parts["b"]
    own = parts["c"]
    assert own.startswith("If k = 4: Kinetic energy lost, by the components that change,")
    assert "½m((5u)² − u²) − ½ × 4m(3u/2)² = 15mu²/2" in own


@pytest.mark.parametrize(
    ("statement", "line"),
    [
        (
            (
                "sphere A: mass m, velocity u at theta\nsphere B: mass m, at rest\n"
                "A hits B: along i, e = 1/2\ngiven tan(theta) = t\npart a\n"
                "show tan(deflection(A)) = 3t/(1 + 4t^2)"
            ),
            (
                "(4 tan θ − tan θ)/(1 + 4 tan²θ) = 3 tan θ/(1 + 4 tan²θ) Since tan θ = t: "
                "tan δ = 3t/(1 + 4t²) (as required)"
            ),
        ),
        (
            (
                "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/2\n"
                "given tan(alpha) = t\npart a\nshow tan(deflection(P)) = 3t/(2 - t^2)"
            ),
            "= 3 tan α/(2 − tan²α) Since tan α = t: tan δ = 3t/(2 − t²) (as required)",
        ),
    ],
    ids=["spheres", "wall"],
)
def test_a_letter_for_a_tangent_comes_after_the_tangent_of_a_turn(
    statement: str, line: str
) -> None:
    parts = worked(statement)
    assert line in parts["a"]
    assert "vector product" not in parts["a"]


def test_a_vector_that_is_given_is_compared_with_what_stands_in_letters() -> None:
    wall = worked(
        "wall W: along i\nsphere P: velocity 2u i - 3u j\nP hits W: e = e\npart a\n"
        "find velocity(P)\npart b\ngiven velocity(P) = 2u i + u j\nfind e"
    )
    assert "3eu = u M1 e = ⅓ A1ft" in wall["b"]
    spheres = worked(
        "sphere A: mass 2, velocity 5i\nsphere B: mass 3, velocity -2j\n"
        "A hits B: along i, e = e\npart a\nfind velocity(A), velocity(B)\npart b\n"
        "given velocity(B) = 2.8i - 2j\nfind e, energy_lost"
    )
    assert "It is given that 𝐯_B = (2.8𝐢 − 2𝐣) m s⁻¹. w = 2.8 m s⁻¹" in spheres["b"]
    assert "2(1 + e) = 2.8 M1" in spheres["b"]
    assert "12.6 J" in spheres["b"]


def test_the_square_of_a_coefficient_is_bounded_before_it() -> None:
    parts = worked(
        "wall W: along i\nsphere P: mass m, velocity u at 45° to W\nP hits W\npart a\n"
        "given energy_lost > 3/8 * 1/2 m u^2\nfind range of e"
    )
    assert "e² < ¼ 0 ≤ e < ½, as e cannot be negative" in parts["a"]


def test_vectors_that_cancel_are_compared_in_numbers() -> None:
    """The momenta before add up to nothing, but for rounding."""
    parts = worked(
        "sphere A: mass 2, velocity 6i + 3j\nsphere B: mass 1, at rest\n"
        "sphere C: mass 3, velocity -2i\nA hits B: along i, e = 1/2\n"
        "B hits C: along 3i + 4j, e = 1/4\npart a\nfind velocity(A), velocity(B, 1)\n"
        "part b\nfind velocity(B), velocity(C)"
    )
    assert "6𝐢 − 3 × 2𝐢 = 3.3𝐢 − 3.6𝐣 + 3𝐯_C" in parts["b"]


def test_a_greatest_deflection_goes_on_from_the_tangent_that_was_shown() -> None:
    parts = worked(
        STRUCK + "part a\nshow tan(deflection(A)) = tan(theta)/(1 + 2tan^2(theta))\n"
        "part b\nfind maximum of deflection(A) over theta\n"
    )
    assert "tan δ ≤ √2/4" in parts["b"]
    assert "greatest value of δ = arctan(√2/4) ≈ 19.5°" in parts["b"]


NUMBERED = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 1, at rest
A hits B: along i, e = 1/2
"""
TANGENTS = {
    "letters": (STRUCK, "tan(theta)/(1 + 2tan^2(theta))", "δ = arctan(tan θ/(1 + 2 tan²θ))"),
    "numbers": (NUMBERED, "12/41", "δ = arctan(12/41) M1 ≈ 16.3°"),
}


@pytest.mark.parametrize("name", TANGENTS)
def test_a_deflection_of_which_the_tangent_was_shown_comes_of_that(name: str) -> None:
    statement, tangent, last = TANGENTS[name]
    parts = worked(
        f"{statement}part a\nshow tan(deflection(A)) = {tangent}\npart b\nfind deflection(A)\n"
    )
    assert parts["b"].startswith(f"From (3): {last}")


def test_times_that_stand_are_added_from_one_event_to_another() -> None:
    parts = worked(
        "wall W: along i, through (0, 0)\nwall V: along i, through (0, d)\n"
        "sphere P: at (0, h), velocity u at -alpha\nP hits W: e = e\nP hits V: e = e\n"
        "P hits W: e = e\nP hits V: e = e\npart a\nfind time(3) - time(2)\n"
        "part b\nshow time(4) - time(2) = d(1 + e)/(e^3 u sin(alpha))\n"
    )
    assert "t₄ − t₂ = d/(e²u sin α) + d/(e³u sin α)" in parts["b"]
    assert "t₁" not in parts["b"]


@pytest.mark.parametrize("claim", ["<= u/4", "< 3u/8"])
def test_a_bound_comes_of_the_greatest_value_above(claim: str) -> None:
    parts = worked(
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nsphere C: mass 4m, at rest\n"
        "A hits B: along i\nB hits C: along i\npart a\nfind maximum of speed(C) over k\n"
        f"part b\ngiven e = 1/2\nshow speed(C) {claim}\n"
    )
    assert "Since e = ½, from (7): speed of C ≤ u/4" in parts["b"]
    assert "k" not in parts["b"]


LOST = {
    "wall": (
        """
wall W: along i
sphere P: mass m, velocity u at -alpha
P hits W: e = e
part a
find energy_lost(P)
part b
given e = 1/2, energy_lost(P) = 1/4 m u^2
find alpha
""",
        "Since e = ½, from (1): kinetic energy lost by P = ⅜mu² sin²α ⅜mu² sin²α = ¼mu²",
    ),
    "spheres": (
        """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = e
part a
find energy_lost(A)
part b
given e = 1/3, energy_lost(A) = 1/3 m u^2
find tan(alpha)
""",
        "Since e = ⅓, from (3): kinetic energy lost by A = (4/9)mu² cos²α",
    ),
}


@pytest.mark.parametrize("name", LOST)
def test_a_loss_of_one_sphere_is_put_into_what_was_found(name: str) -> None:
    statement, lines = LOST[name]
    parts = worked(statement)
    assert parts["b"].startswith(lines)
    assert "before the impact" not in parts["b"]


def test_a_relation_that_was_shown_ties_letters_where_the_same_is_given_again() -> None:
    parts = worked(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\n"
        "A hits B: along i, e = e\npart a\ngiven deflection(A) = 90°\n"
        "show tan^2(alpha) = (k e - 1)/(k + 1)\n"
        "part b\ngiven deflection(A) = 90°, alpha = 30°\nshow k >= 2\n"
    )
    assert parts["b"].startswith("Since α = 30°, from (3): ⅓ = (ke − 1)/(k + 1)")
    assert "k = 4/(3e − 1) k ≥ 2, as e ≤ 1" in parts["b"]
