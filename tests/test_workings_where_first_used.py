"""What a working takes for granted, and what it names, stands where that is first used."""

from __future__ import annotations

import pytest
from workings import printed_with

TOGETHER = """
sphere A: mass 2m, at (0, 0), velocity 2u i
sphere B: mass m, at (4a, 0), at rest
A hits B: along i, e = 1/2
"""
LEVEL = """
sphere A: mass 2m, at (0, 0), velocity 2u i + 3u j
sphere B: mass m, at (4a, 0), velocity 3u j
A hits B: along i, e = 1/2
"""
TOUCHING = """
sphere A: mass m, radius a, at (0, 0), velocity u i
sphere B: mass 2m, radius a, at (5a, 6a/5), at rest
A hits B: e = 1/3
"""
TURNED_BY_A_BLOW = """
sphere A: mass 2, velocity 4i + 2j
sphere B: mass 4, velocity -i
unknown e
A hits B: e = e
given velocity(A) = -2i - 2.5j
"""
PARTS = """
wall W: along 60°
sphere A: mass 2m, velocity 3u i + u j
sphere B: mass m, at rest
part a
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
part b
B hits W: e = 1/3
find speed(B)
part c
find energy_lost, impulse
part d
find impulse(1), energy_lost(1)
"""


@pytest.mark.parametrize("asked", ["distance(A, B, at 5a/u)", "time(1), distance(A, B, at 6a/u)"])
def test_spheres_are_particles_from_the_time_on_that_takes_them_so(asked: str) -> None:
    text = printed_with(
        f"{TOGETHER}find {asked}\n",
        ("taken as particles.", "t = 4a/(2u)", "A and B are together at the impact"),
    )
    assert text.count("particles") == 1


def test_spheres_are_particles_before_a_way_to_a_wall_that_takes_them_so() -> None:
    text = printed_with(
        "wall W: along i, through (0, 8)\nsphere A: mass 2, velocity 3i + 4j, at (-3, -4)\n"
        "sphere B: mass 2, at rest, at (0, 0)\nA hits B: along j, e = 1/2\nB reaches W\n"
        "find time(2) - time(1), position(A)\n",
        (
            "The spheres are taken as particles.",
            "t₂ − t₁ = (8 − 0)/3 = 8/3",
            "position of A when B reaches W",
        ),
    )
    assert text.count("particles") == 1


def test_level_spheres_are_particles_from_the_time_on() -> None:
    text = printed_with(
        f"{LEVEL}find time(1), distance(A, B, at 5a/u)\n",
        ("taken as particles.", "t = 4a/(2u)", "keep level, so distance apart = relative speed"),
    )
    assert text.count("particles") == 1


def test_spheres_that_are_in_one_place_are_particles_also_where_they_reach_others() -> None:
    wall = "wall W: along j, through (6a, 0)"
    printed_with(
        f"{wall}\n{TOGETHER}B hits W: e = 1/2\nfind time(2), position(A)\n",
        ("taken as particles.", "t₁ = 4a/(2u)", "position of A at the second impact = 4a𝐢"),
    )


def test_a_difference_of_places_stands_before_what_it_is_parallel_to() -> None:
    printed_with(
        f"{TOUCHING}find velocity(B)\n",
        (
            "the line of centres is parallel to (5a𝐢 + (6a/5)𝐣) − (17a/5)𝐢",
            "= (8a/5)𝐢 + (6a/5)𝐣 = (2a/5)(4𝐢 + 3𝐣)",
        ),
    )


def test_a_unit_vector_is_pointed_back_to_only_from_the_next_line() -> None:
    text = printed_with(
        f"{TURNED_BY_A_BLOW}find line_of_centres, velocity(B), e\n",
        ("unit vector along the line of centres", "𝐯_B =", "Let 𝐧 = (4𝐢 + 3𝐣)/5 be"),
    )
    assert "that unit vector" not in text


def test_a_part_without_a_heading_says_at_which_impact() -> None:
    text = printed_with(
        PARTS,
        (
            "(c)",
            "kinetic energy lost at the second impact =",
            "magnitude of the impulse at the second impact =",
            "(d)",
            "magnitude of the impulse at the first impact =",
            "kinetic energy lost at the first impact =",
        ),
    )
    assert "kinetic energy lost =" not in text


WALL_THEN_SPHERE = """
wall W: along i
sphere A: mass m, velocity u at 45° to W
sphere B: mass 2m, velocity u j
A hits W: e = 1/2
A hits B: along i, e = 1/4
find deflection(A, 1), deflection(A)
"""
NAMED_BY_THE_QUESTION = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/2
let theta = direction(P)
find tan(theta), deflection(P)
"""
CORNER = """
wall AB: along i
wall BC: along {way}
sphere P: velocity u at alpha to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
find angle(AB, BC)
"""


def test_an_angle_that_has_a_letter_gets_no_second_one() -> None:
    text = printed_with(
        WALL_THEN_SPHERE,
        (
            "Let β be the angle between 𝐯_A1 and W.",
            "W is parallel to the line of centres, so the angle between 𝐯_A1 and that line is β",
            "δ = θ − β",
        ),
    )
    assert "φ" not in text


def test_an_angle_that_the_question_names_gets_no_second_letter() -> None:
    text = printed_with(
        NAMED_BY_THE_QUESTION,
        (
            "tan θ = ½u sin α/(u cos α) = ½ tan α",
            "W is along 𝐢, so the angle between 𝐯_P and W is θ too.",
            "angle of deflection of P = α + θ",
        ),
    )
    assert "β" not in text


def test_the_angle_between_slanting_walls_is_acute() -> None:
    assert "acute angle between AB and BC" in printed_with(CORNER.format(way="120°"), ("β = 60°",))
    assert "acute" not in printed_with(CORNER.format(way="j"), ("β = 90°",))


def test_a_component_beside_one_that_is_rounded_has_three_figures() -> None:
    printed_with(
        "sphere A: mass 7, velocity 4i + j\nsphere B: mass 6, velocity -i\n"
        "A hits B: along i, e = 3/5\nfind velocity(A)\n",
        ("𝐯_A = (4/13)𝐢 + 𝐣 ≈ (0.308𝐢 + 1.00𝐣) m s⁻¹",),
    )


def test_a_vector_of_short_fractions_stands_as_it_is() -> None:
    printed_with(
        "sphere A: mass 2, velocity 4i + j\nsphere B: mass 1, velocity -i\n"
        "A hits B: along i, e = 3/5\nfind velocity(A)\n",
        ("𝐯_A = ((4/3)𝐢 + 𝐣) m s⁻¹",),
    )


@pytest.mark.parametrize(
    ("velocity", "line", "angle"),
    [("5i", "30°", "30°"), ("5i", "120°", "60°"), ("-5j", "150°", "60°"), ("4j", "60°", "30°")],
)
def test_an_angle_that_is_seen_is_not_worked_out(velocity: str, line: str, angle: str) -> None:
    text = printed_with(
        f"wall W: along {line}\nsphere P: velocity {velocity}\nP hits W: e = 1/2\n"
        "find deflection(P)\n",
        (f"{angle} to W", "Let β be the angle between 𝐯_P and W.", f"δ = {angle} + "),
    )
    assert text.count("tan β =") == 1


def test_no_angle_begins_at_nothing() -> None:
    text = printed_with(
        "sphere A: mass 2, velocity 4i\nsphere B: mass 3, at rest\n"
        "A hits B: along -30°, e = 1/2\nfind velocity(B)\n",
        ("A moves at 30° to the line of centres.",),
    )
    assert "0° + 30°" not in text


def test_a_velocity_of_degrees_beside_a_line_at_thirty_is_followed() -> None:
    """A formula would join 40° and 60° to 20°, in which no line is."""
    printed_with(
        "wall W: along i\nsphere A: mass m, velocity 5 at 40° to W\n"
        "sphere B: mass 2m, at rest\nA hits W: e = 1/2\n"
        "A hits B: along 30°, e = 1/3\nfind velocity(A)\n",
        ("𝐯_A2 ≈ 0.4578(", "≈ (0.658𝐢 − 0.224𝐣) m s⁻¹"),
    )


def test_a_given_part_of_a_speed_is_printed_as_in_its_line() -> None:
    text = printed_with(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "given tan(alpha) = 2, speed(P) = 3/5 u\nfind e\n",
        ("the speed of P is 3u/5",),
    )
    assert "⅗u" not in text


def test_a_number_before_a_letter_has_no_root_below_the_line() -> None:
    """One form of 1/√3, which the data have, would be (1/√3)u beside √3 u/6."""
    text = printed_with(
        "wall W: along i\nwall X: along j\nsphere P: mass m, velocity u at 60° to W\n"
        "P hits W: e = 1/sqrt(3)\nP hits X: e = 1/sqrt(3)\nfind speed(P)\n",
        ("speed of P = √((√3 u/6)² + (u/2)²) = √3 u/3",),
    )
    assert "= (1/√3)u ≈" not in text


def test_a_bound_that_is_a_multiple_is_said_in_words() -> None:
    printed_with(
        "wall W: along i\nwall X: along j\nsphere P: mass m, velocity u at alpha to W\n"
        "P hits W\nP hits X\ngiven 0 < e < 1\n"
        "given energy_lost(1) > 3 energy_lost(2)\nfind range of alpha\n",
        ("is more than 3 times the kinetic energy lost at the second impact",),
    )


def test_who_moves_along_a_line_needs_no_direction_of_its_speed() -> None:
    """The 2 of a distance d/2 stands below the line, beside the speed."""
    text = printed_with(
        "wall W: along j, through (0, 0)\nwall X: along j, through (d, 0)\n"
        "sphere P: at (d/2, 0), velocity -u i\nP hits W: e = e\nP hits X: e = e\n"
        "given time(2) = 3d/u\nfind e\n",
        ("Time = distance ÷ speed: t₁ = d/(2u)",),
    )
    assert "in that direction" not in text


def test_that_a_body_was_at_rest_is_said_once_of_its_speed_and_angle() -> None:
    text = printed_with(
        "sphere A: mass 3, velocity 4i\nsphere B: mass 5, at rest\nA hits B\n"
        "given deflection(A) = 60°, speed(A) = 2, direction(A) < 0\n"
        "find line_of_centres, speed(B), direction(B)\n",
        ("B was at rest, so it moves along the line of centres: (ii)",),
    )
    assert "B moves along the line of centres" not in text


def test_a_share_of_an_energy_is_said_again_in_a_later_part() -> None:
    text = printed_with(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "given tan(alpha) = 2, energy_lost/energy(0) = 3/5\npart a\nfind e\npart b\n"
        "find speed(P)\n",
        ("the fraction lost is ⅗. Dividing by half the mass: u² − (speed of P)² = 3u²/5",),
    )
    assert "Ratio of kinetic energies" not in text


def test_an_angle_that_is_put_in_beside_a_share_does_not_hide_it() -> None:
    text = printed_with(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\npart a\n"
        "given alpha = 60°, energy_lost = 1/4 energy(0)\nfind e\n",
        ("It is given that the kinetic energy lost is ¼ of the kinetic energy before the impact",),
    )
    assert "Ratio of kinetic energies" not in text


def test_two_multiples_of_one_root_have_one_form() -> None:
    printed_with(
        "sphere A: mass 3, velocity 4i\nsphere B: mass 5, at rest\nA hits B\n"
        "given deflection(A) = 60°, speed(A) = 2, direction(A) < 0\nfind line_of_centres, e\n",
        ("𝐯_A · 𝐧 = √3/2 − √3/2 = 0",),
    )


def test_a_component_along_a_line_of_centres_is_not_named_again() -> None:
    """What v stands for is said where it is introduced, also where it is what was asked."""
    text = printed_with(
        "sphere A: mass m, velocity 3u i\nsphere B: mass k m, velocity -u i\n"
        "A hits B: along i, e = 1/2\nfind along(velocity(A), i), along(velocity(B), i)\n",
        ("v = 3(1 − k)u/(1 + k)", "w = 3(1 − k)u/(1 + k) + 2u = (5 − k)u/(1 + k)"),
    )
    assert "the component of" not in text and "𝐯_A" not in text


def test_a_speed_of_zero_has_no_components() -> None:
    text = printed_with(
        "sphere A: mass m, velocity 3u i\nsphere B: mass 2m, at rest\n"
        "A hits B: along i, e = 1/2\nfind speed(A), speed(B)\n",
        ("v = 0 speed of A = 0 Substituting",),
    )
    assert "from its components" not in text


def test_who_moves_off_from_rest_has_no_component_that_stays() -> None:
    rested = "sphere A: mass 3m, velocity u at 45°\nsphere B: mass m, at rest\n"
    text = printed_with(
        rested + "A hits B: along i, e = 1/3\nfind speed(A), speed(B)\n",
        ("the component of A in the direction of 𝐣 stays", "B was at rest, so it moves along"),
    )
    assert "0 for B" not in text
    given = "A hits B: along i\ngiven energy(B) = 1/4 energy(A)\nfind e\n"
    printed_with(rested + given, ("for A and 0 for B.",))
