"""Places and distances: what a line has is neither worked out nor said once more."""

from __future__ import annotations

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

CORRIDOR = """
wall N: along i, through (0, h)
wall S: along i, through (0, 0)
sphere P: at (0, h), velocity -3v i - 4v j
unknown k
P hits S: e = k
P hits N: e = k
"""
THREE = """
sphere A: mass m, velocity 3u i, at (0, 0)
sphere B: mass 2m, at rest, at (d, 0)
wall W: along j, through (4d, 0)
A hits B: e = 3/4
part a
find velocity(A), velocity(B)
part b
B hits W: e = 1/2
find time(2) - time(1)
part c
A hits B
find position(A, 3)
"""
STRUCK = """
wall W: along 3i + 4j
sphere P: mass 2, velocity 7i - 4j
unknown k
P hits W: e = 1/2
P receives k (3i + 4j)
"""


def printed(text: str) -> str:
    """What is printed of a working of which the follower accepts each line."""
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    assert not explanation.warnings
    return " ".join(to_text(explanation, 100).split())


def test_a_distance_that_is_a_coordinate_is_put_in_without_a_line() -> None:
    text = printed(CORRIDOR + "given distance((0, h), position(P, 2)) = 5h/2\nfind k")
    assert "distance between (0, h) and P at the second impact is 5h/2. These positions" in text
    assert "differ in their x-coordinates alone: 3(1 + k)h/(4k) = 5h/2" in text
    assert "distance between (0, h) and P at the second impact =" not in text


def test_a_distance_that_is_asked_is_no_method_where_it_is_a_coordinate() -> None:
    text = printed(
        CORRIDOR.replace("unknown k\n", "") + "find distance((0, h), P) in terms of k, h"
    )
    assert "M1 The positions differ in their x-coordinates alone: distance between" in text
    assert "at the second impact = 3(1 + k)h/(4k) A1" in text


def test_a_distance_of_two_that_move_is_a_method() -> None:
    text = printed(
        "wall W: along j, through (0, 0)\n"
        "sphere A: mass m, at (d, 0), velocity -u i\n"
        "sphere B: mass m, at (4d, d), velocity -u i\n"
        "A hits W: e = 1/2\n"
        "find distance(A, B, at 3d/u)"
    )
    assert "Distance, from the coordinates" in text
    assert "start = d M1 A1" in text


def test_a_distance_at_another_time_is_called_that() -> None:
    text = printed(
        CORRIDOR
        + "P hits S: e = k\n"
        + "given distance((0, 0), position(P, 3)) = 4 distance((0, 0), position(P, 1))\nfind k"
    )
    assert "P at the third impact is 4 times that at the first impact" in text


def test_a_place_of_rest_has_no_line_to_be_cited() -> None:
    text = printed(THREE)
    assert "position of B at the first impact" not in text
    assert "At the first impact A and B are both at (d, 0)." in text


def test_the_energy_of_one_sphere_has_one_name() -> None:
    text = printed(
        "sphere S: mass 3, velocity 4i + 5j\nwall V: along j\nS hits V: e = e\n"
        "given energy(S) = 4 energy(0)/5\npart a\nfind e\npart b\nfind energy_lost(S)"
    )
    assert "kinetic energy of S before the impact" in text
    assert "kinetic energy before the impact" not in text


def test_a_product_that_is_zero_has_its_roots_at_once() -> None:
    text = printed(STRUCK + "given total_energy_lost = 0\nfind k")
    below = text.partition("energy lost is 0:")[2]
    assert "= (16 + 5k)(12 − 5k)/4 A1 k = 12/5 or k = −16/5 DM1" in below


def test_a_product_that_is_not_zero_is_no_step_to_its_roots() -> None:
    text = printed(STRUCK + "given total_energy_lost = 24\nfind k")
    below = text.partition("energy lost is 24 J:")[2]
    assert "24 = 65 − (25k² + 20k + 68)/4 = 48 − 5k − 25k²/4 A1 25k² + 20k − 96 = 0" in below
    assert "(5k − 8)(5k + 12) = 0" in below


APART = """
sphere A: mass 1, velocity 6i + 2j, at (0, 0)
sphere B: mass 2, at rest, at (0, 0)
wall W: along j, through (8, 0)
A hits B: along i, e = 3/4
B hits W: e = 1/2
"""


def test_a_distance_at_the_time_of_an_event_is_by_the_places_there() -> None:
    text = printed(APART + "find distance(A, B, at time(2))")
    assert "position of A at the second impact = (16/7)(−𝐢 + 2𝐣)" in text
    assert "at time t₂ = √((8 + 16/7)² + (32/7)²)" in text
    assert "𝐯_B" not in text  # B is at the wall, whatever it does then


def test_a_place_after_an_event_rests_on_what_it_needs() -> None:
    statement = parse(APART + "find distance(A, B, at time(2) + 1)")
    assert explain(solve(statement), check=True).followed


def test_what_is_at_rest_goes_no_distance() -> None:
    text = printed("""
sphere P: mass m, velocity 3v i, at (0, 0)
sphere Q: mass 3m, at rest, at (2d, 0)
wall W: along j, through (5d, 0)
P hits Q: along i, e = 1/3
Q hits W: e = 1/4
find position(P, 2), distance(position(P, 2), (5d, 0))
""")
    assert "P is at rest, so it stays where it is: position of P at the second impact" in text
    assert "distance between P and (5d, 0) at the second impact = 5d − 2d = 3d" in text
    assert "speed × time" not in text


def test_a_place_is_the_velocity_times_a_time_in_letters() -> None:
    statement = """
wall W: along j, through (d, 0)
sphere A: mass m, at (0, 0), velocity u i
A hits W: e = e
find time(1), position(A, at T)
"""
    text = " ".join(to_text(explain(solve(parse(statement)))).split())
    assert "d𝐢 − eu(T − d/u)𝐢" in text
