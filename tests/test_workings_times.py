"""Times and distances of two bodies: by how fast they come together, or part."""

from __future__ import annotations

import pytest
from workings import printed_with

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

TO_A_WALL = """
sphere A: mass 3m, velocity 2u i, at (0, 0)
sphere B: mass m, at rest, at (0, 0)
wall W: along j, through (d, 0)
A hits B: along i, e = 1/2
B hits W: e = 1/2
"""
WITH_RADII = """
sphere A: mass 3, velocity 4i, radius 0.1, at (0, 0)
sphere B: mass 1, velocity -2i, radius 0.1, at (1.4, 0)
A hits B: along i, e = 2/3
"""


def printed(text: str) -> str:
    """What is printed of a working of which the follower accepts each line."""
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    assert not explanation.warnings
    return " ".join(to_text(explanation, 100).split())


def test_how_far_apart_two_are_comes_of_their_relative_speed() -> None:
    text = printed(TO_A_WALL + "find distance(A, B)")
    assert (
        "so they are together at the first impact. Distance apart = relative speed × time:" in text
    )
    assert "at the second impact = (4d/(9u))(9u/4 − 5u/4) = 4d/9 M1 A1" in text
    assert "position of A" not in text


def test_how_far_apart_two_are_comes_of_a_place_that_is_asked() -> None:
    text = printed(TO_A_WALL + "find position(A), distance(A, B)")
    assert "relative speed" not in text
    assert "distance between A and B at the second impact = d − 5d/9 = 4d/9" in text


def test_a_first_impact_at_the_start_has_its_time() -> None:
    text = printed(TO_A_WALL + "find time(2)")
    assert "A and B start at the same point, so they collide at once: t₁ = 0" in text


def test_two_with_radii_close_the_gap_between_them() -> None:
    text = printed(WITH_RADII + "find time(1)")
    assert "When A and B touch, their centres are 0.2 m apart." in text
    assert "Time = gap ÷ speed at which it closes: t = (1.4 − 2 × 0.1)/(4 + 2) = 0.2 s" in text
    assert "M1 A1" in text


def test_two_with_radii_close_the_gap_behind_a_wall() -> None:
    text = printed(
        "sphere A: mass 2m, velocity 3u i, radius r, at (0, 0)\n"
        "sphere B: mass m, velocity u i, radius r, at (8r, 0)\n"
        "wall W: along j, through (20r, 0)\n"
        "A hits B: along i, e = 1/2\nB hits W: e = 1/3\nB hits A: e = 1/2\nfind time(3)"
    )
    assert "t₃ − t₂ = (19r − 43r/3 − 2r)/(2u + u) = 8r/(9u)" in text


def test_who_keeps_a_coordinate_is_met_there() -> None:
    text = printed(
        "sphere A: mass 1, velocity 3i + j, at (-6, -2)\n"
        "sphere B: mass 2, velocity -2j, at (0, 4)\n"
        "A hits B: along i, e = 1/2\nfind time(1), position(A)"
    )
    assert "Time = distance ÷ speed parallel to the x-axis, for A: t = 6/3 = 2 s M1 A1" in text
    assert "y-coordinate of A at the impact = −2 + 2 = 0 M1 A meets B, which moves" in text


def test_who_come_along_both_axes_meet_where_these_cross() -> None:
    text = printed(
        "sphere A: mass m, velocity 2u i, at (-4d, 0), radius d/4\n"
        "sphere B: mass m, velocity u j, at (0, -1.75d), radius d/4\n"
        "A hits B: along i, e = 1/2\nfind time(1), position(A), position(B)"
    )
    assert "(i) t = (4d − d/2)/(2u) = 7d/(4u) M1 A1" in text
    assert "A moves parallel to the x-axis, and B parallel to the y-axis:" in text


def test_on_one_line_nobody_is_said_to_be_met() -> None:
    text = printed(
        "wall W: along j, through (8, 0)\nsphere A: mass 4, velocity 3i, at (0, 0)\n"
        "sphere B: mass 1, at rest, at (2, 0)\nA hits B: along i, e = 1/4\n"
        "B hits W: e = 1/2\nA hits B: e = 1/4\nfind position(A)"
    )
    assert "A meets B" not in text
    assert "velocity × time, for A: position of A at the third impact = " in text


def test_who_is_still_in_contact_collides_at_once() -> None:
    text = printed(
        "sphere A, B: mass 1, radius 1/2\n"
        "sphere A: at (0, 0), velocity 2i\n"
        "sphere B: at (3, 0), at rest\n"
        "wall W: along j, through (7, 0)\n"
        "A hits B: e = 0\nB hits W: e = 1\nA hits B: e = 0\n"
        "find time(3)"
    )
    assert "A and B are still in contact, so they collide at once:" in text


@pytest.mark.parametrize(
    ("one", "other", "place"),
    [("2i + j", "-2i + 3j", "(1, 2)"), ("u i", "u j", "(a, b)"), ("-u j", "2u j", "(0, 0)")],
)
def test_who_starts_at_one_point_collides_at_once(one: str, other: str, place: str) -> None:
    text = printed(
        f"sphere P: mass 3, velocity {one}, at {place}\n"
        f"sphere Q: mass 1, velocity {other}, at {place}\n"
        f"P hits Q: along {'j' if place == '(0, 0)' else 'i'}, e = 1/2\n"
        "find time(1), velocity(P)"
    )
    assert "P and Q start at the same point, so they collide at once: t = 0" in text
    assert "-coordinate of" not in text


def test_a_distance_is_seen_where_the_time_is_its_quotient_by_the_speed() -> None:
    text = """
wall V: along j, through (0, 0)
sphere P: at (5, 3), velocity -3i - 2j
P hits V: e = 1/2
find time(1)
"""
    printed_with(text, ("t = (5 − 0)/3 = 5/3 ≈ 1.67 s",))
