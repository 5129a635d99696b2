"""What stands in letters is used where a fact, a range or an item speaks of it again."""

from __future__ import annotations

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

LOSSES = """
wall W: along i
wall X: along j
sphere P: mass m, velocity u at alpha to W
P hits W
P hits X
given 0 < e < 1
part a
find energy_lost(1)/energy_lost(2)
part b
given 2 energy_lost(1) < energy_lost(2)
find range of alpha
"""

BOUND = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given along(velocity(A), i) < 0
part a
find range of e
part b
given e = 2/3
find range of k
"""

EQUAL = """
wall AB: along i
wall BC: along j
sphere P: mass m, velocity u at alpha to AB
P hits AB: e = e1
P hits BC: e = e2
find speed(P)
part b
given e1 = e2, speed(P) = 2/3 u
find e1
"""

NAMED = """
let t = tan(alpha)
sphere A: mass 3m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 3/5
let gamma = angle(velocity(A), velocity(B))
show tan(gamma) = 5/3 t
find gamma
"""

PRODUCT = """
sphere A: mass 1, velocity 3i + 4j
sphere B: mass 1, velocity -3i
A hits B: along 2i - j, e = 1/2
find velocity(A), dot(velocity(A), line_of_centres)
"""


def printed(statement: str) -> str:
    """The working, which the follower accepts, as text."""
    problem = parse(statement)
    solution = solve(problem)
    assert follow(plan(solution), Oracle(roles(problem))) == ()
    return " ".join(to_text(explain(solution)).split())


@pytest.mark.quick
def test_a_ratio_in_letters_bounds_its_quantities() -> None:
    text = printed(LOSSES)
    assert "kinetic energy lost at the second impact > 0, as α is acute" in text
    _, later = text.split("(b)")
    assert "tan²α < ½" in later
    assert "sin²α" not in later


@pytest.mark.quick
def test_a_bound_above_takes_the_value_of_a_later_part() -> None:
    _, later = printed(BOUND).split("(b)")
    assert "⅔ > 1/k M1 k > 3/2, as k > 0 A1" in later


def test_a_root_that_equal_letters_leave_is_taken_from_the_line_above() -> None:
    text = printed(EQUAL)
    assert "2u/3 = u√(e₁² cos²α + e₁² sin²α) = e₁u" in text


def test_a_tangent_that_was_shown_gives_its_angle() -> None:
    text = printed(NAMED)
    assert text.count("tan γ = u sin α/") == 1
    assert "(as required) A1* From (3): (ii) γ = arctan((5/3) tan α)" in text


def test_a_scalar_product_along_the_line_of_centres_is_the_component() -> None:
    text = printed(PRODUCT)
    assert "𝐯_A · 𝐧 = −4√5/5" in text


def test_a_half_is_that_of_an_energy_and_a_percentage_makes_no_decimals() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass 0.5, velocity 3i - 8j\nP hits W: e = 0.5\nfind energy_lost"
    )
    assert "½ × 0.5(8² − 4²)" in text
    text = printed(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\ngiven energy_lost = 25% energy(0)\nfind alpha"
    )
    assert "v = ¼u cos α" in text


def test_a_given_speed_with_its_sense_is_the_component() -> None:
    text = printed(
        "sphere A: mass 2m, velocity 3u i\nsphere B: mass m, velocity -4u i\nA hits B: along i\n"
        "given velocity(A) opposite to i, speed(A) = u\nfind e"
    )
    assert "u = −v, as A moves in the direction of −𝐢" in text
    assert "v²" not in text


def test_an_impulse_that_is_asked_as_a_vector_has_its_size_by_the_components() -> None:
    text = printed(
        "wall W: along i + 2j\nsphere P: mass 0.5, velocity 8i\nP hits W: e = 0.5\n"
        "find velocity(P), impulse, impulse(P)"
    )
    assert "impulse on P = 0.5((−1.6𝐢 + 4.8𝐣) − 8𝐢)" in text
    assert "= (−4.8𝐢 + 2.4𝐣) N s" in text
    assert "magnitude of the impulse = √(4.8² + 2.4²) = 12√5/5" in text


def test_a_place_is_not_taken_backwards_from_a_point_reached_later() -> None:
    text = printed(
        "point N: (4, 3)\nwall W: along i, through (0, -2)\n"
        "sphere A: mass 1, at (-3, 0), velocity 6i\nsphere B: mass 1, at (0, 0), at rest\n"
        "A hits B: along 4i + 3j, e = 1/2\nB reaches N\nfind time(2)\n"
        "A hits W: e = 1/2\nfind distance(A, B)"
    )
    assert "position of B at the second impact = (25/27)((72/25)𝐢 + (54/25)𝐣)" in text


def test_a_quotient_is_positive_before_its_letter_is_bounded() -> None:
    text = printed(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\n"
        "A hits B: along i, e = 1/3\ngiven velocity(A) perpendicular to velocity(A, 0)\n"
        "find range of k"
    )
    assert "(k − 3)/(3(1 + k)) > 0, as α is acute" in text


def test_a_velocity_at_an_angle_that_was_found_is_a_vector_first() -> None:
    text = printed(
        "sphere A: mass 1, at (8, 14), velocity 26 at alpha, radius 5\n"
        "sphere B: mass 1, at (40, 30), at rest\npoint N: (60, 45)\n"
        "A hits B: e = 1/2\nB reaches N\nfind alpha, velocity(B)"
    )
    assert "𝐮_A = (24𝐢 + 10𝐣) m s⁻¹" in text


def test_centres_have_equal_coordinates_across_their_line() -> None:
    text = printed(
        "sphere A: mass 1, radius 1/2, at (0, 0), velocity 2i\n"
        "sphere B: mass 2, radius 1/2, at (4, 8), velocity v at 270°\n"
        "A hits B: along j, e = 1/2\nfind v"
    )
    assert "B moves parallel to the y-axis: x-coordinate of B at the impact = 4 m" in text
    assert "Time = distance ÷ speed, for A: t = 4/2 = 2 s" in text
    assert (
        "At the impact the y-coordinate of B is greater than that of A by two radii, as B comes "
        "towards A in the direction of −𝐣:" in text
    )


def test_spheres_that_keep_level_are_apart_along_the_line() -> None:
    text = printed(
        "sphere A: mass 3m, velocity 2u i + u j\nsphere B: mass m, velocity -2u i + u j\n"
        "A hits B: along i, e = 1/2\nfind distance(A, B, at t)"
    )
    assert "Perpendicular to the line of centres A and B keep level" in text


def test_who_is_sent_straight_back_rebounds() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass m, velocity -u j\nP hits W\n"
        "given e > 0\nfind deflection(P)"
    )
    assert "P hits W at right angles and e > 0, so it is sent straight back" in text


def test_an_equation_of_the_fourth_degree_is_a_quadratic_in_the_tangent() -> None:
    text = printed(
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
        "A hits B: along i\ngiven deflection(A) = 30°, energy_lost = 1/4 energy(0)\nfind alpha, e"
    )
    assert "11 tan²α − 6√3 tan α + 1 = 0" in text
    assert "sin⁴" not in text
    assert "sin³" not in text


def test_quotients_over_different_letters_are_multiplied_out() -> None:
    text = printed(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\nA hits B: along i\n"
        "given direction(A) = beta\nfind e in terms of alpha, beta, k"
    )
    assert "tan β cos α − (1 + k) sin α = ek tan β cos α" in text


def test_a_letter_that_gives_no_value_at_0_is_not_0() -> None:
    text = printed(
        "wall OX: from (0, 0) to (6, 0)\nwall OY: from (0, 0) to (0, 2)\n"
        "sphere P: at (4, 3), velocity -v i - v j\nP hits OX: e = 1/2\nP hits OY: e = e2\n"
        "P reaches (6, y)\nfind y in terms of e2\nfind range of e2"
    )
    assert "e₂ > 0, as e₂ ≥ 0 and there is no y if e₂ = 0" in text
    assert "The path is in the direction of the velocity: x-coordinate of P" in text
    assert "= 4 − 3 = 1 m" in text


def test_the_sense_of_who_moves_across_the_line_of_centres_has_its_reason() -> None:
    text = printed(
        "sphere A, B: mass m\nsphere A: velocity u i\nsphere B: at rest\n"
        "A hits B: along phi, e = 1\nfind direction(A)"
    )
    assert "A moves perpendicular to the line of centres, where its component is −u sin φ" in text


def test_a_component_that_is_worked_out_to_be_0_stays_0() -> None:
    text = printed(
        "sphere A: mass 1/2, velocity 2i + 3j\nsphere B: mass 1, at rest\n"
        "A hits B: along 2i + 3j, e = 1/3\nfind velocity(A)"
    )
    assert "the component of A in the direction of 𝐭 stays 0" in text


def test_the_square_of_a_coefficient_bounds_a_speed_that_is_shown() -> None:
    text = printed(
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\nshow speed(P) <= u"
    )
    assert "speed of P ≤ u, as e² ≤ 1 (as required)" in text


def test_an_energy_of_letters_that_are_positive_needs_no_line_that_it_is() -> None:
    text = printed("""
wall W: along i
wall X: along j
sphere P: mass m, velocity u at theta to W
P hits W: e = e
P hits X: e = e
find energy(P)/energy(P, 0) in terms of e
given energy(P) < 1/2 energy(P, 0)
find range of e
""")
    assert "> 0" not in text
    assert "½e²mu² < mu²/4 DM1 e² < ½" in text


@pytest.mark.parametrize("asked", ["show tan(theta) = 3e/(2 + e)", "find tan(theta)"])
@pytest.mark.parametrize(
    ("quantity", "answer"), [("theta", "0° < θ ≤ 45°"), ("tan(theta)", "0 < tan θ ≤ 1")]
)
def test_an_angle_is_bounded_by_a_tangent_that_stands(
    asked: str, quantity: str, answer: str
) -> None:
    """tan θ is 3e/(2 + e): from 0, which no path has, to 1. The letter e is no value of θ."""
    text = printed(f"""
wall W: along i, through (0, 0)
point N: (3a, 2a)
sphere P: mass m, at (0, a), velocity u at theta from -j
P hits W
P reaches N
part a
{asked}
part b
unknown e
find range of {quantity}
""")
    _, later = text.split("(b)")
    assert "tan θ ≤ 1, as " in later
    assert answer in later
    assert "Newton" not in later


@pytest.mark.parametrize("shown", ["speed(B) = u/2", "B hits W again", "along(velocity(B), i) > 0"])
def test_laws_whose_unknowns_cancel_are_all_written(shown: str) -> None:
    """With e = ½ and masses 2m and m, B has after the third impact what A had after the first."""
    text = printed(f"""
wall W: along j
sphere A: mass 2m, velocity u i
sphere B: mass m, at rest
A hits B: along i, e = 1/2
B hits W: e = 1/3
A hits B: along i, e = 1/2
show {shown}
""")
    assert "component of 𝐯_B" in text and "= −u/3" in text
    assert "not written out" not in text


TIED = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given velocity(A) perpendicular to velocity(A, 0)
part a
show tan^2(alpha) = (k e - 1)/(1 + k)
part b
given k = 3
find range of {asked}
"""


@pytest.mark.parametrize(
    ("asked", "lines"),
    [
        ("alpha", ("tan²α ≤ ½, as e ≤ 1", "0° < α ≤ arctan(√2/2)")),
        ("e", ("3e − 1 > 0, as α is acute", "⅓ < e ≤ 1")),
    ],
)
def test_a_letter_that_is_given_since_is_put_into_what_ties_others(
    asked: str, lines: tuple[str, ...]
) -> None:
    text = to_text(explain(solve(parse(TIED.format(asked=asked))), check=True))
    assert "Since k = 3, from (3):" in text, text
    assert "tan²α = (3e − 1)/4" in text, text
    assert not [each for each in lines if each not in text], text
    assert "not written out" not in text, text


def test_where_nothing_is_asked_a_given_fact_is_no_trouble() -> None:
    statement = "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W\ngiven impulse = 10"
    text = to_text(explain(solve(parse(statement))))
    assert "nothing is asked" in text


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (
            """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given energy(P) = 2/5 energy(0)
find range of tan(alpha)
""",
            (
                "2(sin²α + cos²α) = 5e² sin²α + 5 cos²α",
                "(2 − 5e²) sin²α = 3 cos²α",
                "tan²α ≥ 3/2, as e² ≥ 0",
            ),
        ),
        (
            """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given speed(A) = 1/2 u
find range of alpha
""",
            (
                "sin²α + cos²α = 4 sin²α + (1 − e)² cos²α",
                "tan²α = (2 − e)e/3",
                "tan²α ≤ ⅓",
                "0° < α ≤ 30°",
            ),
        ),
    ],
)
def test_an_equation_of_squares_becomes_a_tangent_step_by_step(
    statement: str, lines: tuple[str, ...]
) -> None:
    text = to_text(explain(solve(parse(statement)), check=True))
    assert not [each for each in lines if each not in text], text


def test_a_deflection_is_the_difference_of_angles_that_stand() -> None:
    whole = printed(
        "sphere A: mass 2, velocity 3i + 4j\nsphere B: mass 3, at rest\n"
        "A hits B: along i, e = 1/2\npart a\n"
        "find angle(velocity(A), i), angle(velocity(A, 0), i)\npart b\nfind deflection(A)"
    )
    assert "With β and θ from part (a): δ = β − θ = arctan(40/3) − arctan(4/3)" in whole
    assert "cos δ" not in whole


def test_both_ends_of_a_claim_are_taken_at_ends_of_the_letter() -> None:
    text = printed(
        """
sphere A: mass m, velocity 2u at 60°
sphere B: mass 2m, velocity -v i
A hits B: along i
given B at rest
find v in terms of u, e
show u/2 <= v <= 2u
"""
    )
    growth = "(1 + e)u/(2 − e) increases with e, from u/2 if e = 0 to 2u if e = 1 (as required)"
    assert f"as 0 ≤ e ≤ 1 and {growth}" in " ".join(text.split())


def test_a_direction_from_a_slanting_wall_says_on_which_side_of_it_the_path_is() -> None:
    statement = (
        "wall W: along {w}\nsphere P: velocity 8 at {p}\nP hits W: e = 1/2\nfind direction(P)"
    )
    below = " ".join(printed(statement.format(w="30°", p="75°")).split())
    side = "P leaves it on the side from which it came, clockwise of W."
    assert f"W is at 30° to 𝐢, and {side}" in below
    assert "angle from 𝐢 to 𝐯_P = 30° − arctan(1/2)" in below
    above = " ".join(printed(statement.format(w="20°", p="-30°")).split())
    assert "the side from which it came, anticlockwise of W." in above


def test_the_unit_vector_of_a_side_that_is_taken_is_said_once() -> None:
    text = printed(
        "wall W\nsphere P: velocity 5i\nP hits W: e = 1/2\n"
        "given angle(i, W) = 30°\nfind velocity(P)"
    )
    assert " ".join(text.split()).lower().count("unit vector perpendicular to w") == 1


def test_a_right_angle_between_vectors_that_stand_is_by_these() -> None:
    text = " ".join(
        printed(
            "wall W: along i - j\nsphere P: mass 2, velocity 6i + 2j\nP hits W: e = 1/4\n"
            "part a\nfind velocity(P)\npart b\nfind deflection(P)"
        ).split()
    )
    assert "Scalar product, with 𝐯_P from part (a): 𝐮_P · 𝐯_P = 6 − 2 × 3 = 0" in text
    assert "angle of deflection of P = 90°" in text


def test_whether_a_slanting_wall_is_hit_again_is_told_by_the_velocity() -> None:
    """The other wall has another direction, so the velocity stands before its component there."""
    text = printed("""
sphere P: mass 1, velocity 8i + j
wall W: along 3i + 4j
wall X: along i + j
P hits W: e = 1/4
P hits X: e = 1/3
show P hits W again
""")
    assert "= ((43/10)𝐢 + (13/4)𝐣) m s⁻¹" in text
    assert "𝐯₂ · 𝐧₁ = (4 × (43/10) − 3 × (13/4))/5 = 149/100 m s⁻¹" in text
    assert "0/100" not in text
