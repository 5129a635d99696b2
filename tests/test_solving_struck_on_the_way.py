"""What is in the way of a sphere that reaches a point, and from which side one strikes a wall."""

from __future__ import annotations

import pytest

import restitution

TO_A_POINT = """sphere A, B: mass 1
sphere A: at (0, 0), velocity 2i
sphere B: {}
A reaches (5, 0)
"""


def _solved(text: str) -> str:
    return str(restitution.solve(restitution.parse(text)))


@pytest.mark.parametrize(
    ("other", "asked", "expected"),
    [
        ("at (3, 0), at rest", "time(1)", "time(1) = no answer: A strikes B first"),
        ("at (5, 0), at rest", "time(1)", "time(1) = 5/2"),
        ("at (7, 0), at rest", "time(1)", "time(1) = 5/2"),
        ("at (3, b), at rest, radius 1", "range of b", "range of b = b ≤ −2 or b ≥ 2"),
        ("at (3, -6), velocity v j", "range of v", "range of v = v > 0, v ≠ 4"),
    ],
)
def test_no_sphere_is_struck_before_a_point_is_reached(
    other: str, asked: str, expected: str
) -> None:
    assert _solved(f"{TO_A_POINT.format(other)}find {asked}") == expected


def test_a_sphere_that_comes_back_is_not_struck_before_a_point() -> None:
    text = """sphere A, B: mass 1
sphere A: at (0, 0), velocity 2i
sphere B: at (3, 0), at rest
wall W: along j, through (7, 0)
A hits B
B hits W: e = 1
A reaches (6, 0)
find range of e
"""
    # A is there after 3/(1 − e), B after 5/(1 + e).
    assert _solved(text) == "range of e = 0 ≤ e ≤ ¼"


@pytest.mark.parametrize(
    ("wall", "expected"),
    [
        ("along j, through (4, 0)", "time(1) = no answer: A strikes W first"),
        ("along j, through (5, 0)", "time(1) = 5/2"),
        ("from (4, 1) to (4, 3)", "time(1) = 5/2"),
    ],
)
def test_no_wall_is_struck_before_a_point_is_reached(wall: str, expected: str) -> None:
    text = "sphere A: mass 1, at (0, 0), velocity 2i\n"
    assert _solved(f"{text}wall W: {wall}\nA reaches (5, 0)\nfind time(1)") == expected


SIZED = """wall W: along j, through (10, 0)
sphere P: mass 1, at (a, 0), velocity {} i + j, radius 1
P hits W: e = 1/2
"""


def test_a_wall_may_be_struck_on_either_side() -> None:
    text = _solved(SIZED.format("p") + "find time(1)\nshow time(1) > 0")
    first, second = text.splitlines()[0].removeprefix("time(1) = ").split("  or  ")
    assert first == "(9 − a)/p, for p > 0 and p(9 − a) > 0"
    assert second == "(11 − a)/p, for −p > 0 and p(11 − a) > 0"
    assert text.endswith("time(1) > 0: shown")


@pytest.mark.parametrize(("speed", "expected"), [("2", "a < 9"), ("-2", "a > 11")])
def test_the_way_of_a_sphere_tells_on_which_side_of_a_wall_it_is(speed: str, expected: str) -> None:
    solution = restitution.solve(restitution.parse(SIZED.format(speed) + "find range of a"))
    assert str(solution) == f"range of a = {expected}"
    assert not solution.warnings


def test_a_wall_beside_the_way_is_not_struck_by_what_is_beyond_it() -> None:
    text = """wall W: along j, through (10, 0)
wall V: along i, through (0, 5)
sphere P: mass 1, at (0, b), velocity 2i + j, radius 1
P hits W: e = 1/2
find range of b
"""
    # Between 4 and 6 it would overlap V; it rises by 9/2 on its way.
    assert _solved(text) == "range of b = b < −½ or b ≥ 6"
