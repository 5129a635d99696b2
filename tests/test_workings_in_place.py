"""What is said where it is used: of senses, times, units and reasons, in printed workings."""

from __future__ import annotations

from functools import cache

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

TWO_WALLS = """
wall S: from (0, 0) to (6c, 0)
wall T: from (0, 0) to (0, 3c)
sphere Q: at (3c, c), velocity -h w i - w j
Q hits S: e = 1/2
Q hits T: e = 1/2
find range of h, time(2)
"""
TURNED = """
sphere P: mass 2m, velocity w i
sphere Q: mass 3m, at rest
P hits Q: along phi
given deflection(P) = 60°, speed(P) = w/3
find phi, e
"""
NEVER_MET = """
sphere P: mass 1, velocity 4i - 2j, at (1, 5)
sphere Q: mass 1, velocity i + 2j, at (7, -1)
P hits Q: along i, e = 1
find time(1)
"""
IN_EITHER_SENSE = """
wall K
sphere S: mass m, velocity 4u i + 3u j
S hits K: e = 1/3
given impulse(S) parallel to {}
find velocity(S)
"""
ENERGIES = """
sphere P: mass 3, velocity 4i
sphere Q: mass 1, at rest
P hits Q: along i, e = 1/3
find energy(P)/energy(P, 0), energy(Q)/energy(1)
"""
RADIUS = """
sphere A: mass m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset 3, e = 1
given direction(A) = -45°
find r
"""
AT_A_TIME = """
wall S: along i, through (0, 0)
wall T: along i, through (0, 4)
sphere Q: at (0, 2), velocity i - 2j
Q hits S: e = 1/2
Q hits T: e = 1/2
find time(1), time(2), velocity(Q), position(Q, at 3)
"""
HALF_WAY = """
wall S: along j, through (0, 0)
wall T: along j, through (c, 0)
sphere Q: at (b, 0), velocity -w i
Q hits S: e = e
Q hits T: e = e
given b = c/4, time(2) = 5c/(4w)
find e
"""
THREE_IN_TURN = """
wall S: along i
wall T: along 60°
sphere Q: velocity w at 30° to S
Q hits S: e = 1/2
Q hits T: e = 1/2
find speed(Q), speed(Q, 1)
"""
LOSSES = """
wall S: along i
wall T: along j
sphere Q: mass m, velocity w at beta to S
Q hits S
Q hits T
given 0 < e < 1
show energy_lost(2)/energy_lost(1) = 1/tan^2(beta)
"""


@cache
def printed(text: str) -> str:
    return " ".join(to_text(explain(solve(parse(text)), check=True), 100).split())


def test_of_an_impact_at_its_end_a_time_says_which_one_leaves_the_speed_as_it_is() -> None:
    words = printed(TWO_WALLS)
    assert "which the impact with S does not change: t₂ = 3c/(hw)" in words
    assert "no impact changes" not in words


def test_a_law_by_a_vector_that_is_no_unit_vector_says_so() -> None:
    words = printed(TURNED)
    assert "= (5w/6)𝐢 + (√3 w/6)𝐣 = (w/6)(5𝐢 + √3 𝐣)" in words
    assert "Newton's experimental law, by scalar products with 5𝐢 + √3 𝐣: 5(5w/9 − w/6)" in words


def test_the_tangent_of_a_line_of_centres_is_first_a_quotient() -> None:
    text = TURNED.replace("60°, speed(P) = w/3", "45°, speed(P) = w/2")
    assert "tan φ = 1/(2√2 − 1) = " in printed(text)


def test_spheres_that_do_not_meet_have_the_differences_of_their_coordinates() -> None:
    words = printed(NEVER_MET)
    assert "at time t their x-coordinates differ by 6 − 3t, which is 0 only at t = 2" in words
    assert "and their y-coordinates differ by 6 − 4t, which is 0 only at t = 3/2" in words


@pytest.mark.parametrize(
    ("vector", "said"),
    [
        ("2i + 3j", "As (4u𝐢 + 3u𝐣) · (2𝐢 + 3𝐣) = 17u > 0, 2𝐢 + 3𝐣 is towards K. Let 𝐧 = "),
        (
            "-2i - 3j",
            "(4u𝐢 + 3u𝐣) · (2𝐢 + 3𝐣) = 17u > 0, the opposite sense is towards K: the normal",
        ),
    ],
)
def test_a_normal_of_either_sense_is_towards_the_wall_for_a_reason(vector: str, said: str) -> None:
    words = printed(IN_EITHER_SENSE.format(vector))
    assert said in words
    assert words.count("towards K.") + words.count("towards K:") == 1


def test_energies_of_one_moment_say_it_alike() -> None:
    words = printed(ENERGIES)
    assert "kinetic energy of P after the impact" in words
    assert "kinetic energy of Q after the impact = " in words


def test_a_length_in_a_letter_has_its_unit_beside_numbers() -> None:
    assert "the centres are 2r m apart, and the centre of B is 3 m to the left" in printed(RADIUS)


def test_a_place_at_a_time_says_between_which_impacts_it_is() -> None:
    said = "As 1 < 3 < 5, Q is then between the first impact and the second impact: (iv)"
    assert said in printed(AT_A_TIME)
    assert "is then between" not in printed(AT_A_TIME.replace("at 3", "at 6"))


def test_a_length_that_is_put_in_is_said() -> None:
    assert "It is given that b = c/4. Time = distance ÷ speed" in printed(HALF_WAY)


def test_a_speed_after_an_earlier_impact_stands_at_that_impact() -> None:
    words = printed(THREE_IN_TURN)
    asked = [
        words.index(f"speed of Q after the {order} impact = ") for order in ("first", "second")
    ]
    assert asked[0] < words.index("Second impact: Q hits T") < asked[1]


def test_a_factor_that_is_cancelled_in_a_quotient_has_its_reason() -> None:
    assert "= 1/tan²β, as β is acute and 0 < e < 1 (as required)" in printed(LOSSES)


FURTHER = """
sphere P: mass k m, velocity 3u i
sphere Q: mass m, at rest
sphere R: mass m, at rest
P hits Q: along i, e = 1/2
Q hits R: along i, e = 1/4
given P and Q do not collide again
find range of k
"""


def test_an_inequality_between_fractions_is_multiplied_out_before_it_is_solved() -> None:
    words = printed(FURTHER)
    assert "as 1 + k > 0 k ≤ " in words


SPEED = """
sphere P: mass m, velocity w i
sphere Q: mass 2m, at rest
P hits Q: along i
given speed(P) = w/4
find e
"""


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (SPEED, "(1 − 2e)w/3 = ±w/4 DM1 4 − 8e = ±3 e = ⅞ = 0.875 or e = ⅛ = 0.125"),
        (
            SPEED.replace("2m", "k m").replace("along i", "along i, e = 1/2").replace("e\n", "k\n"),
            "(2 − k)w/(2(1 + k)) = ±w/4 DM1 1 + k = ±2(2 − k) k = 5 or k = 1",
        ),
    ],
)
def test_a_speed_of_one_component_is_that_with_either_sign(text: str, lines: str) -> None:
    assert lines in printed(text)


def test_of_a_speed_with_either_sign_a_later_speed_excludes_a_root() -> None:
    text = SPEED.replace("w/4", "w/6, speed(Q) > w/2")
    assert "(1 − 2e)w/3 = ±w/6 DM1 2 − 4e = ±1 e = ¾ or e = ¼" in printed(text)
