"""Workings that take the plainer of two courses, each on a statement of its own."""

from __future__ import annotations

import re
from functools import cache

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

FASTER = """
sphere A: mass 2, velocity 3i + j
sphere B: mass 1, velocity -i
A hits B: along i, e = 1/2
show along(velocity(B), i) > along(velocity(A), i)
"""
FASTER_FROM_BEHIND = """
sphere A: mass m, velocity u i
sphere B: mass k m, velocity i
A hits B: along i, e = 1/3
given u > 0
show along(velocity(A), i) < along(velocity(B), i)
"""
SLOWER_THAN_BEFORE = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
show speed(A) < u
"""
SEVENTY_FIVE = """
wall W: along i
sphere P: mass m, velocity u at 75° to W
P hits W
given angle(velocity(P), W) = 45°
"""
FIFTEEN_TO_THE_LINE = """
sphere A: mass m, velocity u at 45°
sphere B: mass m, at rest
A hits B: along 30°, e = 1/2
find speed(A)
"""
BY_THE_CHANGE = """
sphere A: mass 2, velocity 4i + 2j
sphere B: mass 3, velocity -i + j
A hits B
given velocity(A) = i + j
find velocity(B), e
"""
BEFORE_A_NEARER_WALL = """
wall W: along i
sphere P: mass 3, velocity 5 at 22.5° to W
P hits W: e = e
find deflection(P), energy_lost in terms of e
given energy_lost < 2
find range of e
"""
SUM_OF_SQUARES = """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i, e = 1/3
show speed(A)^2 + 3speed(B)^2 < u^2
"""
ACROSS_AT_A_WALL = """
wall W: along phi
sphere Q: mass 3m, velocity 2v j
Q hits W
given direction(Q) = 0°
find tan(phi) in terms of e
find speed(Q), impulse in terms of m, v, e
"""
BY_E_AS_ABOVE = """
wall W: along i
sphere Q: mass m, velocity 2u at theta to W
Q hits W
given speed(Q) = u/2
part a
show tan^2(theta) = 15/(1 - 16e^2)
part b
find impulse in terms of m, u, e
"""
NOT_BY_ALPHA = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at alpha from -i
A hits B: along i
given energy_lost = 1/5 energy(0)
part a
find cos(alpha) in terms of e
part b
find speed(A) in terms of u
"""
SQUARES_WITH_A_ROOT = """
wall W: along i
sphere Q: mass m, velocity u at theta to W
Q hits W: e = 1/2
given deflection(Q) = 45°
find theta, speed(Q)
"""
BY_CALCULATOR = """
sphere A: mass 3m, velocity 2u at 20°
sphere B: mass m, velocity u at 50° from -i
A hits B: along i, e = 0.4
find speed(B), direction(B)
"""
OFF_FROM_REST = """
sphere P: mass m, velocity 2u i
sphere Q: mass 3m, at rest
P hits Q: along phi, e = 2/3
given angle(velocity(Q), i) = 60°
find phi
find speed(P)
"""
NO_GREATEST = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
find maximum of impulse over k
"""
END_OF_A_BOUND = """
sphere A: mass 3m, velocity u i
sphere B: mass m, velocity -v i
A hits B: along i
given along(velocity(A), i) < 0
show v > u
"""
TO_A_WALL = """
wall W: along 3i + 4j
wall X: along i + j
sphere P: mass 1, velocity 7i + j
P hits W: e = 1/3
find speed(P), angle(velocity(P), X)
"""
ACROSS = """
sphere A: mass 2m, velocity 3u i
sphere B: mass m, velocity u j
A hits B: along i, e = 1/2
find deflection(B)
"""
ONE_ANGLE = """
sphere A: mass m, velocity u at alpha
sphere B: mass M, at rest
A hits B: along i
find tan(direction(A)), tan(deflection(A))
"""
SENT_BACK = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, velocity u at beta from -i
given sin(alpha) = 3/5, tan(beta) = 4/3
A hits B: along i, e = 1/2
find deflection(B)
"""
# cos²α = e sin²α and (1 − e²) sin²α = 1/4, so e = 3/4.
TURNED_AND_SLOWED = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given energy_lost = 1/4 energy(0), deflection(P) = 90°
find alpha
"""
# With B coming the other way v and w are −4(1 + 4e)u/15 and 4(2e − 1)u/15.
EQUAL_SPEEDS = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, velocity u at alpha from -i
A hits B: along i
given tan(alpha) = 3/4, speed(A) = speed(B)
find e
"""
TURNED_DOWN = """
sphere A: mass 1, velocity 2i
sphere B: mass 3, at rest
A hits B
given deflection(A) = 90°, speed(A) = 1, direction(A) < 0
find line_of_centres
"""
OPEN_LINE = """
sphere A: mass 3, velocity 2i + 4j
sphere B: mass 2, velocity -3i - j
A hits B: e = 1/2
given velocity(B) parallel to j
find line_of_centres
"""
ALL_OF_E = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at alpha from -i
A hits B: along i
given 1/2 <= e <= 3/4, alpha = 60°
find range of energy_lost
"""
ON_TO_A_WALL = """
sphere A: mass m, velocity 2u at -60°
sphere B: mass m, at rest
wall W: along i
A hits B: along -60°, e = 1/2
B hits W: e = 2/3
find velocity(B)
"""
DOWN_AN_AXIS = """
wall W: along i + j
sphere P: mass 1, velocity 3i
P hits W: e = 1
find direction(P)
"""
VECTORS_AND_ENERGY = """
sphere A: mass 4m, velocity u i - 3u j
sphere B: mass m, velocity 5u i + 2u j
B hits A
given velocity(B) = -3u i - 2u j
find line_of_centres, velocity(A), energy_lost
"""
TIED_BY_COSINES = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: velocity u at 180° + beta
A hits B: along i, e = 1/2
given cos(alpha) = 3 cos(beta)
part a
show velocity(A) perpendicular to i
part b
given energy = 11/12 m u^2
find alpha
"""
ALWAYS_AGAIN = """
wall W: along j
sphere A: mass 3m, velocity u i
sphere B: mass 2m, at rest
A hits B: along i
B hits W: e = f
given A and B collide again
find range of f in terms of e
"""
EITHER_WAY_ON = """
sphere A: mass k m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
find tan(deflection(A))
"""
BY_WHAT_IS_SHOWN = """
sphere P, Q: mass m
sphere P: velocity u at alpha
sphere Q: at rest
P hits Q: along i
part a
show tan(deflection(P)) = (1 + e) tan(alpha)/(1 - e + 2 tan^2(alpha))
part b
given e = 1/3, alpha = 45°
find tan(deflection(P))
"""
FROM_THE_ANSWER = """
sphere A: mass m, velocity u at 30°
sphere B: mass M, at rest
A hits B: along i
part a
given velocity(A) perpendicular to velocity(A, 0)
show e = (4m + M)/(3M)
part b
given velocity(A) perpendicular to velocity(A, 0)
show M >= 2m
"""
TWO_RATIOS_GIVEN = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, velocity 2u at 180° - beta
A hits B: along i
given cos(alpha) = 3/5, cos(beta) = 5/13
given velocity(B) perpendicular to i
find e
"""
THEN_THE_IMPULSE = """
sphere A: mass 3m, velocity 2u i + 5u j
sphere B: mass m, velocity -4u i + u j
A hits B: along i
part a
given along(velocity(A), i) < 0
find range of e
part b
find energy_lost(A), impulse
"""
SENT_BACK_IN_LETTERS = """
sphere A: mass m, velocity 2u at 30°
sphere B: mass 2m, velocity u at 150°
A hits B: along i
find angle(velocity(A), i)
"""

# Statement, and words of its working, worked out by hand.
SAYS = [
    (FASTER, "w − v = ½(3 + 1) = 2 M1 A1 w > v (as required)"),
    (FASTER_FROM_BEHIND, "Newton's experimental law: w − v = (u − 1)/3"),
    # u² − (2 − e)²u² cos²α/9 − u² sin²α = (1 + e)(5 − e)u² cos²α/9
    (SLOWER_THAN_BEFORE, "u² − (speed of A)² = (1/9)(1 + e)(5 − e)u² cos²α"),
    (SLOWER_THAN_BEFORE, "speed of A < u, as α is acute and 0 ≤ e ≤ 1 (as required)"),
    (SEVENTY_FIVE + "find e", "= (eu sin 75°)/(u cos 75°) = e tan 75° DM1 e = 1/tan 75° ≈ 0.268"),
    (SEVENTY_FIVE + "show e = 2 - sqrt(3)", "e = 1/tan 75° = 2 − √3 (as required)"),
    (FIFTEEN_TO_THE_LINE, "= √((¼u cos 15°)² + (u sin 15°)²) ≈ 0.354u"),
    (BY_THE_CHANGE, "is parallel to (𝐢 + 𝐣) − (4𝐢 + 2𝐣) = −3𝐢 − 𝐣 M1"),
    (BEFORE_A_NEARER_WALL, "= 22.5° + β = 22.5° + arctan(e tan 22.5°) M1"),
    (BEFORE_A_NEARER_WALL, "= (75/2)(1 − e²) sin² 22.5° J"),
    (SUM_OF_SQUARES, "as sin²α < 1 for acute α"),
    (NO_GREATEST, "as k/(1 + k) = 1 − 1/(1 + k) < 1 and α is acute"),
    # v > (3 − e)u/(1 + e), which is u for e = 1
    (END_OF_A_BOUND, "as (3 − e)u/(1 + e) decreases with increasing e and 0 ≤ e ≤ 1"),
    (TO_A_WALL, "cos β = (5/3 + 5)/((5√10/3)√(1² + 1²)) = 2√5/5"),
    # 2 × 3 = 2v + w and w − v = 3/2: w = 3
    (ACROSS, "B came in the direction of 𝐣"),
    (ACROSS, "tan δ = 3u/u = 3 M1 δ = arctan 3"),
    (SENT_BACK, "= 135° − arctan(4/3)"),
    (ONE_ANGLE, "δ = θ − α"),
    (ONE_ANGLE, "tan δ = (tan θ − tan α)/(1 + tan θ tan α)"),
    (TURNED_AND_SLOWED, "e = ¾ Substituting in (2): cos²α = ¾ sin²α tan²α = 4/3"),
    (EQUAL_SPEEDS, "v + u cos α = ±2v v = −⅓u cos α or v = u cos α"),
    (TURNED_DOWN, "as the angle from 𝐢 to 𝐯_A is negative"),
    (OPEN_LINE, "(s − 2(5 − s)/3)(s + 1) = ½(3(2 + 3) + (4 + 1)(s + 1))"),
    (ON_TO_A_WALL, "along the line of centres, at 60° to W"),
    (BY_E_AS_ABOVE, "tan θ = √(15/(1 − 16e²)), as θ is acute"),
    (NOT_BY_ALPHA, "speed of A = √("),
    (
        SQUARES_WITH_A_ROOT,
        "cos²θ = 1/(1 + ((√17 − 3)/2)²) = 1/(1 + (13 − 3√17)/2) = 2/(15 − 3√17)",
    ),
    (BY_CALCULATOR, "speed of B ≈ √((2.005u)² + (u sin 50°)²) ≈ 2.15u"),
    (BY_CALCULATOR, "tan θ ≈ −(u sin 50°)/(2.005u) ≈ −0.3820 M1 θ ≈ −arctan 0.3820, as w > 0"),
    (OFF_FROM_REST, "angle between 𝐯_Q and 𝐢 = φ It is given that"),
    (ACROSS_AT_A_WALL, "change of momentum of Q: impulse on Q = 3m("),
    (VECTORS_AND_ENERGY, "(−3u𝐢 − 2u𝐣) − (5u𝐢 + 2u𝐣) = −8u𝐢 − 4u𝐣"),
    (VECTORS_AND_ENERGY, "m(5u𝐢 + 2u𝐣) + 4m(u𝐢 − 3u𝐣) = m(−3u𝐢 − 2u𝐣) + 4m𝐯_A"),
    (VECTORS_AND_ENERGY, "Kinetic energy: (iii) kinetic energy lost"),
    (TIED_BY_COSINES, "As sin² + cos² = 1: 12 cos α cos β = 1"),
    (ALWAYS_AGAIN, "This always holds, as 0 ≤ e ≤ 1 and f ≥ 0, so every value of f"),
    (EITHER_WAY_ON, "= 3 tan α/(2k − 1 + 2(1 + k) tan²α)"),
    (BY_WHAT_IS_SHOWN, "tan δ = ((1 + ⅓) tan 45°)/(1 − ⅓ + 2 tan² 45°) = ½"),
    (FROM_THE_ANSWER, "(4m + M)/(3M) ≤ 1, as e ≤ 1 M1 M ≥ 2m, as M > 0"),
    (TWO_RATIOS_GIVEN, "It is given that cos β = 5/13: component of 𝐮_B along 𝐢 = −2u cos β"),
    (TWO_RATIOS_GIVEN, "It is given that cos α = ⅗. Conservation of momentum"),
    (THEN_THE_IMPULSE, "kinetic energy lost by A = "),
    (THEN_THE_IMPULSE, "change of momentum of A along the line of centres"),
    (SENT_BACK_IN_LETTERS, "β = 180° − arctan(√3/(3e))"),
    (DOWN_AN_AXIS, "P moves in the direction of 𝐣: angle from 𝐢 to 𝐯_P = 90°"),
]
SAYS_NOT = [
    (VECTORS_AND_ENERGY, "components that change"),
    (TIED_BY_COSINES, "√(1 − 9 cos²β)"),
    (EITHER_WAY_ON, "vector product"),
    (OFF_FROM_REST, "tan 60°"),
    (BY_CALCULATOR, "√(400 sin² 50°"),
    (NOT_BY_ALPHA, "cos²α − 1"),
    (SQUARES_WITH_A_ROOT, "component of 𝐯_Q parallel to W ="),
    (ACROSS_AT_A_WALL, "𝐧"),
    (TURNED_AND_SLOWED, "sin⁴α"),
    (SENT_BACK, "β = arctan(4/3)"),
    (ALL_OF_E, "as α = 60°"),
    (ONE_ANGLE, "β"),
    (FASTER, "Conservation of momentum"),
    (FASTER_FROM_BEHIND, "Eliminating"),
    (SLOWER_THAN_BEFORE, "tends to"),
    (SUM_OF_SQUARES, "tends to"),
    (NO_GREATEST, "tends to"),
]


@cache
def in_a_row(statement: str) -> str:
    return re.sub(r"\s+", " ", to_text(explain(solve(parse(statement)))))


@pytest.mark.parametrize(("statement", "words"), SAYS, ids=[each for _, each in SAYS])
def test_a_working_says(statement: str, words: str) -> None:
    assert words in in_a_row(statement)


@pytest.mark.parametrize(("statement", "words"), SAYS_NOT, ids=[each for _, each in SAYS_NOT])
def test_a_working_does_not_say(statement: str, words: str) -> None:
    assert words not in in_a_row(statement)


DECIMALS_OF_A_TABLE = """
wall W1: along i, through (0, 0)
wall W2: along i, through (0, 2)
sphere P: mass 0.1, velocity 3i - 4j
P hits W1: e = 1/4
P hits W2: e = 1/2
find total_energy_lost
"""
DECIMALS_OF_A_RANGE = """
wall W: along i
sphere P: mass 0.2, velocity 5 at alpha to W
P hits W
given sin(alpha) = 4/5
part a
find impulse
part b
find range of impulse
"""


def test_terms_and_squares_are_decimals_beside_decimals() -> None:
    text = in_a_row(DECIMALS_OF_A_TABLE)
    assert "½ × 0.1(0.5² + 3²) = 0.4625 J" in text
    assert "1.25 − 0.4625" in text


def test_a_range_and_its_reason_have_the_decimals_of_their_line() -> None:
    text = in_a_row(DECIMALS_OF_A_RANGE)
    assert "0.8 N s ≤ magnitude of the impulse ≤ 1.6 N s" in text
    assert "as 0.8(1 + e) increases with e" in text


def test_a_ratio_whose_number_a_line_puts_in_is_not_told_below_it() -> None:
    above, below = in_a_row(DECIMALS_OF_A_RANGE).split("e(5 × ⅘)")
    assert above.count("It is given that sin α") == 1
    assert "It is given that sin α" not in below


def test_a_second_case_does_not_say_again_what_the_first_one_does() -> None:
    text = in_a_row(
        "sphere A: mass 2\nsphere B: mass 3, velocity -i + 2j\nA hits B: along i, e = 1/2\n"
        "given velocity(B) = 2i + 2j, speed(A) = sqrt(2)/2\nfind velocity(A, 0)"
    )
    first, second = text.split("If b = ")[1:]
    assert "The velocity, from its components" in first
    assert second.startswith("−½: 𝐮_A = ")


def test_the_formula_for_the_tangent_by_that_of_its_half_is_named() -> None:
    text = in_a_row(
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/4\n"
        "given angle(velocity(P), W) = 1/2 alpha\nfind alpha\n"
    )
    assert "By the formula tan α = 2t/(1 − t²): t = ¼ × (2t/(1 − t²))" in text
    assert "half angle" not in text


def test_a_velocity_along_an_axis_has_one_component() -> None:
    text = in_a_row(
        "wall W: along theta\nsphere P: velocity 2i\nP hits W: e = 1/2\n"
        "given velocity(P) parallel to j\nfind theta, speed(P)\n"
    )
    assert "The velocity of P has one component only: speed of P = √2" in text
    assert "from its components" not in text


def test_a_least_value_is_reached_where_the_plain_square_is_zero() -> None:
    text = in_a_row(
        "wall W: along j, through (0, 0)\nsphere A: mass m, at (d, 0), velocity -u i\n"
        "sphere B: mass m, at (4d, d), velocity -u i\nA hits W: e = 1/2\n"
        "find distance(A, B, at time(1) + T)\n"
        "find minimum of distance(A, B, at time(1) + T) over T\n"
    )
    assert "= √((3d − Tu − Tu/2)² + d²) = √((3d − 3Tu/2)² + d²)" in text
    assert "when 3d − 3Tu/2 = 0, so T = 2d/u" in text


def test_a_speed_along_an_axis_shows_the_value_that_is_put_in() -> None:
    text = (
        "wall W: along 2i - j\nsphere P: mass m, velocity 5u i + 5u j\nP hits W\npart a\n"
        "find velocity(P)\npart b\ngiven velocity(P) parallel to j\nfind e, speed(P)"
    )
    assert "speed of P = (1 + 6 × ⅔)u = 5u" in in_a_row(text)


def test_spheres_without_a_radius_are_particles_where_they_are_apart() -> None:
    text = (
        "sphere A: mass 1, velocity 4i + j\nsphere B: mass 2, velocity -2i + 2j\n"
        "A hits B: along i, e = 1/2\nfind distance(A, B, at 3)"
    )
    says = "The spheres are taken as particles, so they are together at the impact. Distance apart"
    assert says in in_a_row(text)


def test_a_velocity_of_the_data_by_components_has_its_words() -> None:
    text = (
        "wall AB: along i\nwall BC: along j\nsphere P: mass m, velocity u at alpha to AB\n"
        "P hits AB: e = e\nP hits BC: e = e\nshow velocity(P) opposite to velocity(P, 0)"
    )
    words = "The velocity of P at the start, by its components: 𝐮 = u cos α 𝐢 − u sin α 𝐣"
    assert words in in_a_row(text)


def test_a_time_that_is_on_paper_is_an_answer_below_a_coefficient_by_it() -> None:
    text = (
        "wall W: along i, through (0, 0)\npoint Q: (3, 1)\n"
        "sphere P: at (0, 1.5), velocity 4 at 50° to W\nP hits W\nP reaches Q\n"
        "find e, time(2)"
    )
    shown = in_a_row(text)
    assert "t₂ = 3/(4 cos 50°) ≈ 1.1668 ≈ 1.17 s" in shown
    assert "not written out" not in shown


@pytest.mark.parametrize(
    ("impulse", "lines"),
    [
        ("-6i + 3j", ("(a − 3)𝐢 + (b + 3/2)𝐣", "b = 2a − 13/3", "(2a − 13/3 + 3/2)(2a − 13/3)")),
        ("-4i + 3j", ("(a − 2)𝐢 + (b + 3/2)𝐣", "+ (b + 3/2)b = 0")),
    ],
)
def test_a_sum_that_is_put_in_has_no_denominator_of_its_number(
    impulse: str, lines: tuple[str, ...]
) -> None:
    words = in_a_row(
        "sphere A: mass 2, velocity a i + b j\nsphere B: mass 3, velocity -i + 2j\n"
        f"A hits B\ngiven impulse(A) = {impulse}, e = 1/2\n"
        "given velocity(A) perpendicular to velocity(A, 0)\nfind a, b"
    )
    for line in lines:
        assert line in words


def test_what_an_answer_has_in_decimals_is_a_decimal_from_then() -> None:
    """And what has just been said is not said again beside its sign."""
    words = in_a_row(
        "sphere P: mass 1, velocity 8i + j\nwall W: along 3i + 4j\nP hits W: e = 1/4\n"
        "part a\nfind velocity(P)\npart b\nwall X: along i + j\nP hits X: e = 1/3\n"
        "find velocity(P)\npart c\nshow P hits W again"
    )
    assert "= (2.2𝐢 + 5.35𝐣) m s⁻¹" in words
    assert "𝐯₁ · 𝐧₂ = (−2.2 + 5.35)/√2" in words
    assert "𝐯₂ = (2.2𝐢 + 5.35𝐣) − " in words
    assert "(4 × 4.3 − 3 × 3.25)/5 = 1.49 m s⁻¹" in words
    assert "𝐯₂ · 𝐧₁ > 0" in words


def test_a_number_among_decimals_is_used_as_it_was_printed() -> None:
    words = in_a_row(
        "sphere A: mass 3, velocity 2i\nsphere B: mass 2, velocity -1.5i + 3j\n"
        "A hits B: along 4i - 3j, e = 1/2\nfind velocity(A), velocity(B)"
    )
    assert "𝐮_A · 𝐧 = (4 × 2)/5 = 1.6 m s⁻¹" in words
    assert "3 × 1.6 + 2(−3) = 3v + 2w" in words
    assert "8/5" not in words


@pytest.mark.parametrize(
    ("speeds", "e", "impulse", "values"),
    [
        (("3u", "u"), "1/2", "2m(3u − u) = 4mu", "with w = 5u/2 and k = 8/5 from part (a)"),
        (("5u", "2u"), "1/3", "2m(5u − 2u) = 6mu", "with w = 11u/3 and k = 18/11 from part (a)"),
    ],
)
def test_an_impulse_comes_of_the_sphere_of_which_all_is_given(
    speeds: tuple[str, str], e: str, impulse: str, values: str
) -> None:
    """Where values are named that were found, each is said, and not one of two."""
    words = in_a_row(
        f"sphere A: mass 2m, velocity {speeds[0]} i\nsphere B: mass k m, at rest\n"
        f"A hits B: along i, e = {e}\ngiven velocity(A) = {speeds[1]} i\n"
        "part a\nfind k\npart b\nfind impulse\npart c\nfind energy_lost"
    )
    assert f"magnitude of the impulse = {impulse}" in words
    assert values in words


@pytest.mark.parametrize(
    ("given", "lines"),
    [
        (
            "impulse = 9, energy_lost = 6",
            "6 = 24(1 − e²)(3/(4(1 + e)))² = 27(1 − e)/(2(1 + e)) 4 + 4e = 9 − 9e e = 5/13",
        ),
        ("impulse = 15, energy_lost = 45/4", "= 75(1 − e)/(2(1 + e))"),
    ],
)
def test_a_factor_above_and_below_is_cancelled_before_there_is_a_second_root(
    given: str, lines: str
) -> None:
    words = in_a_row(
        "wall W: along j\nsphere S: mass 3, velocity 4 at beta to W\nS hits W\n"
        f"given {given}\nfind e, beta"
    )
    assert lines in words
    assert "e = −1" not in words


@pytest.mark.parametrize(
    ("masses", "given", "lines"),
    [
        (
            ("3m", "2m"),
            "energy(A) = 2 energy(B)",
            ["mu²(49 cos²α + 225 sin²α)/150", "225 sin²α = 143 cos²α", "tan²α = 143/225"],
        ),
        # Beside an energy before the impact there is a number, and the sine alone is plainer.
        (("3m", "2m"), "energy_lost(A) = 1/2 energy(A)", ["mu²(49 + 176 sin²α)/150"]),
    ],
)
def test_energies_that_are_compared_keep_both_squares(
    masses: tuple[str, str], given: str, lines: list[str]
) -> None:
    words = in_a_row(
        f"sphere A: mass {masses[0]}, velocity u at alpha\nsphere B: mass {masses[1]}, at rest\n"
        f"A hits B: along i, e = 1/3\ngiven {given}\nfind alpha"
    )
    for line in lines:
        assert line in words


def test_a_loss_that_an_earlier_part_shows_goes_into_a_ratio() -> None:
    words = in_a_row(
        "sphere P: mass 2m, velocity u at beta\nsphere Q: mass m, at rest\n"
        "P hits Q: along i, e = 1/2\npart a\nshow energy_lost(P) = 3/4 m u^2 cos(beta)^2\n"
        "part b\nfind energy(Q)/energy_lost(P)"
    )
    ratio = "(kinetic energy of Q after the impact)/(kinetic energy lost by P)"
    assert f"{ratio} = ½mu² cos²β/(¾mu² cos²β) = ⅔" in words


def test_a_quotient_of_quotients_is_one_fraction_before_both_sides_multiply_out() -> None:
    words = in_a_row(
        "wall C: circle centre (0, 0) radius a\npoint S: (-a, 0)\n"
        "sphere P: at (-a, 0), velocity u at alpha\nP hits C: e = f\nP hits C: e = f\n"
        "P reaches S\nfind tan(alpha)^2"
    )
    one = "(1 + f) tan α/(f − tan²α) = f²/tan α (1 + f) tan²α = f³ − f² tan²α"
    assert one in words
    assert "= 90° if" not in words  # with f = 0 it would not leave the wall


TURNED_APART = """
sphere A, B: mass m
sphere A: velocity 2u i
sphere B: velocity -2u j
A hits B: along i + j
let theta = angle(velocity(A), velocity(B))
"""


def test_the_root_of_a_square_in_the_quadratic_formula_is_worked_out() -> None:
    words = in_a_row(f"{TURNED_APART}given tan(theta) = sqrt(3), theta < 90°\nfind e")
    assert "e = (−1 + 2)/√3 or e = (−1 − 2)/√3" in words


def test_factors_with_roots_stand_side_by_side_in_brackets() -> None:
    words = in_a_row(f"{TURNED_APART}given theta = 60°\nfind e")
    assert "(−√2 eu(√2 eu) + √2 u(√2 u))/((√2 eu)² + (√2 u)²)" in words


def test_components_in_proportion_are_equal_quotients() -> None:
    words = in_a_row(
        "wall X: along i\nwall Y: along j\nsphere P: mass m, velocity 3u i - 5u j\n"
        "P hits X: e = e\nP hits Y: e = f\ngiven velocity(P) parallel to velocity(P, 0)\n"
        "find f in terms of e"
    )
    assert "so their components are in proportion: 3fu/(3u) = 5eu/(5u)" in words


def test_the_square_of_a_sine_comes_of_the_tangent_by_an_identity() -> None:
    words = in_a_row(
        "wall V: along i\nsphere S: mass m, velocity u at beta to V\nS hits V\n"
        "given deflection(S) = 90°\nshow energy_lost/energy(0) = 1 - e"
    )
    assert "sin²β = 1/(1 + e), as 1/sin²β = 1 + 1/tan²β" in words
    words = in_a_row(
        "wall V: along j\nsphere S: mass 2m, velocity w at phi\nS hits V\n"
        "given deflection(S) = 90°\nshow tan(phi)^2 = e\nfind energy_lost in terms of m, w, e\n"
        "find speed(S)/w in terms of e"
    )
    assert "cos²φ = 1/(1 + e), as sin²φ + cos²φ = 1" in words


def test_a_speed_along_one_line_has_no_root() -> None:
    words = in_a_row(
        "sphere P: mass m, velocity u i\nsphere Q: mass 5m, at rest\n"
        "P hits Q: along i\nfind speed(P)/speed(Q)"
    )
    assert "speed of P = |(1 − 5e)u/6| = u|1 − 5e|/6" in words
