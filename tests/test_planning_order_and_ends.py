"""Lines in the order in which a teacher has them, values where they are put in, ends left out."""

from __future__ import annotations

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

RIGHT_ANGLE = """
sphere A: mass m, velocity u at alpha
sphere B: mass 4m, at rest
A hits B: along i
given deflection(A) = 90°
part a
show tan(alpha)^2 = (4*e - 1)/5
part b
given e = 1/2
find energy_lost/energy(0)
"""

CORNER = """
wall W1: along i
wall W2: along j
sphere S: mass 2, velocity 3 at 30° to W1
S hits W1: e = 0.8
S hits W2: e = 0.8
find energy_lost
show velocity(S) opposite to velocity(S, 0)
"""

CORNER_BY_A_TANGENT = """
wall W1: along i
wall W2: along j
sphere S: mass 0.16, velocity 3 at alpha to W1
S hits W1: e = 0.8
S hits W2: e = 0.8
given tan(alpha) = 3/4
find energy_lost
show velocity(S) parallel to velocity(S, 0)
"""

BOTH_LOSSES = """
wall W1: along i
wall W2: along j
sphere P: mass m, velocity u at theta to W1
P hits W1: e = 1/2
P hits W2: e = 1/3
given energy_lost(1) + energy_lost(2) = 5/6 * 1/2 m u^2
find theta
"""

NOT_ACUTE = """
sphere A: mass 1, velocity (2i + 6j)
sphere B: mass 2, velocity (8i + j)
A hits B: along theta
given velocity(A) = (5i + 5j)
find e
"""


def text_of(statement: str) -> str:
    explanation = explain(solve(parse(statement)), check=True)
    assert explanation.followed
    return " ".join(to_text(explanation).split())


def test_a_value_stands_before_the_lines_that_put_it_in() -> None:
    text = text_of(RIGHT_ANGLE)
    assert 0 < text.index("cos α = √30/6") < text.index("v = −√30 u/30")
    assert text.count("v = −√30 u/30") == 1


def test_the_square_of_a_tangent_is_worked_out() -> None:
    assert "tan²α = (4 × ½ − 1)/5 = ⅕" in text_of(RIGHT_ANGLE)


def test_no_item_goes_back_to_an_impact_that_is_left() -> None:
    text = text_of(CORNER)
    assert text.count("First impact: S hits W1") == 1
    assert text.index("component of 𝐯₁ along 𝐣 = 0.8 × 3 sin 30°") < text.index("Second impact")


def test_velocities_are_parallel_by_the_ratios_of_a_given_tangent() -> None:
    text = text_of(CORNER_BY_A_TANGENT)
    assert "𝐯₂ = −0.8𝐮" in text
    assert "not written out" not in text
    assert "= 0.165888 ≈ 0.166 J" in text


def test_no_fraction_stands_over_a_number() -> None:
    assert "(4/9)mu² cos²θ = 5mu²/12" in text_of(BOTH_LOSSES)


def test_a_component_is_not_called_nonzero_where_it_may_vanish() -> None:
    """2(3 cos θ − sin θ) vanishes for tan θ = 3."""
    text = text_of(NOT_ACUTE)
    assert "is not zero" not in text
    assert "impossible" in text


def test_an_end_that_a_fact_of_the_motion_leaves_out_is_approached() -> None:
    text = text_of(
        "sphere S: mass m, velocity 2u i + u j\nwall W: along j\nS hits W: e = e\n"
        "given deflection(S) > 90°\nfind minimum of speed(S) over e"
    )
    assert "speed of S → √5 u/2 ≈ 1.12u, as e → ¼, so there is no least value" in text
    lettered = text_of(
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i, e = e\n"
        "given velocity(A) opposite to i\nfind minimum of speed(B) over e"
    )
    assert "speed of B → u/k, as e → 1/k, so there is no least value" in lettered


TWO_KICKS = """
sphere P: mass 2, velocity 3i - j
wall W: along i
P receives 4i + 6j
find velocity(P)
P receives -5j
find speed(P), energy_lost(2), total_energy_lost
"""


def test_impulses_from_outside_are_counted_and_change_the_energy() -> None:
    text = text_of(TWO_KICKS)
    assert "Let 𝐯₁ be the velocity of P after the first impulse." in text
    assert "Let 𝐯₂ be the velocity of P after the second impulse." in text
    assert "kinetic energy lost due to the second impulse = ½ × 2(5² + 2²) − ½ × 2" in text
    assert "not written out" not in text
    alone = text_of(TWO_KICKS.partition("P receives -5j")[0].replace("velocity(P)", "energy_lost"))
    assert "after the impulse" in alone
    assert "Kinetic energy: kinetic energy lost = ½ × 2(3² + 1²) − ½ × 2(5² + 2²) = −19 J" in alone


def test_a_direction_that_leaves_no_component_says_which() -> None:
    walls = (
        "wall W1: along i\nwall W2: along 120°\nsphere P: velocity u at theta to W1\n"
        "P hits W1: e = 1/2\nP hits W2: e = 1/2\ngiven velocity(P) parallel to W2\nfind theta"
    )
    assert "so the component perpendicular to W2 is zero" in text_of(walls)
    spheres = (
        "sphere A: mass m, velocity 2u i + u j\nsphere B: mass 3m, velocity -u i + 2u j\n"
        "A hits B: along i, e = e\ngiven velocity(A) opposite to i\nfind e"
    )
    text = text_of(spheres)
    assert "so the component in the direction of 𝐣 is zero: u = 0" in text


def test_a_percentage_stands_behind_decimals() -> None:
    text = text_of(
        "sphere A: mass 3, velocity 5 at arctan(3/4)\nsphere B: mass 2, velocity 4 at 180°\n"
        "A hits B: along i, e = 0.4\nfind energy_lost/energy(0) as a percentage"
    )
    assert "= 32.256/53.5 ≈ 60.3%" in text


def test_an_equality_stands_behind_the_other_reasons() -> None:
    text = text_of(
        "sphere A: mass m, velocity u i\nsphere B, C: mass m, at rest\nA hits B: along i, e = e\n"
        "B hits C: along i, e = e\nA hits B: along i, e = e\nfind velocity(A), velocity(B)\n"
        "show A and B do not collide again"
    )
    assert "as e ≥ 0 and (1 − e)² ≥ 0, with equality when e = 1" in text


def test_a_gap_that_does_not_close_has_the_values_of_both_components() -> None:
    text = text_of(
        "sphere A: mass m, velocity u i\nsphere B: mass 4m, at rest\nwall W: along j\n"
        "A hits B: along i, e = 3/4\nB hits W: e = 2/5\nshow A and B do not collide again"
    )
    assert "v = −2u/5 < −7u/50 = component of 𝐯_B along 𝐢" in text


TWICE_AS_FAST = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = e
given speed(A)/speed(B) = 2
find {}
"""


def test_a_given_ratio_of_speeds_is_one_speed_by_the_other() -> None:
    text = text_of(TWICE_AS_FAST.format("tan(alpha) in terms of e"))
    assert "2²(½(1 + e)u cos α)² = (½(1 − e)u cos α)² + (u sin α)²" in text
    assert "√((½(1 + e)u cos α)²)" not in text


def test_a_range_of_an_angle_is_by_that_of_its_tangent() -> None:
    text = text_of(TWICE_AS_FAST.format("range of alpha"))
    assert "√3/2 ≤ tan α ≤ 2 arctan(√3/2) ≤ α ≤ arctan 2, as α is acute" in text
    assert "not written out" not in text


def test_a_speed_of_the_data_is_put_in_beside_its_ratio() -> None:
    text = text_of(
        "wall W: along i\nsphere P: mass m, velocity 5 at 60° to W\nP hits W: e = e\n"
        "given speed(P)/speed(P, 0) = 1/3 sqrt(3)\nfind e"
    )
    assert "(⅓√3)²(5²) = (5√3 e/2)² + (5/2)²" in text


def test_ratios_of_angles_that_make_a_right_angle_follow_exactly() -> None:
    text = text_of(
        "sphere A: mass 2m, velocity u at alpha\nsphere B: mass m, velocity u at beta from -i\n"
        "A hits B: along i, e = 1/2\ngiven alpha + beta = 90°\n"
        "find velocity(A) in terms of u, alpha"
    )
    assert "Since α + β = 90°: cos β = sin α" in text


def test_an_item_in_terms_of_letters_has_its_number_where_they_stand() -> None:
    text = text_of(
        "sphere A: mass m, velocity u i\nsphere B: mass m, at rest\nA hits B: along 30°, e = e\n"
        "find speed(B) in terms of e, u\nfind deflection(A)\ngiven e = 1/2\nfind energy_lost"
    )
    assert "(i) speed of B = √3(1 + e)u/4" in text
    assert text.count("(i) ") == 1
