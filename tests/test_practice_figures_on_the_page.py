"""What stands on a page: rounded figures beside each other, lists, products, what is done."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

import restitution

# By hand: u = 9 cos 35° = 7.37237, so 3u = 22.11711.
OBLIQUE = """
sphere A: mass 3, velocity 9 at 35°
sphere B: mass 2, at rest
A hits B: along i, e = 0.6
find speed(A), speed(B)
"""
# By hand: -12j comes to 4j, then to -2j.
GUTTER = """
wall W: along i, through (0, 0)
wall V: along i, through (0, 8)
sphere P: at (0, 6), velocity 5i - 12j
P hits W: e = 1/3
P hits V: e = 1/2
part a
find velocity(P, 1), velocity(P)
part b
find time(2)
"""
# By hand: along i + 2j A has 8/√5 before and -2/√5 after.
FOUND = """
sphere A: mass 2, velocity 4i + 2j
sphere B: mass 4, velocity -j/2
A hits B
given velocity(A) = 2i - 2j
part a
find velocity(B), line_of_centres
part b
find e
"""
BLOW = """
sphere A: mass 2, velocity i + 6j
sphere B: mass 5, velocity -2j
A hits B: along j
given impulse = 10
find velocity(A), velocity(B)
"""
WALL = """
wall W: along i
sphere P: mass 3, velocity 6i - 5j
P hits W: e = 2/5
find energy_lost
"""


@cache
def solved(statement: str) -> Any:
    return restitution.solve(restitution.parse(statement))


def lines_of(statement: str, part: str | None, *lines: str, **letters: str) -> list[dict[str, Any]]:
    marking = restitution.mark(solved(statement), "\n".join(lines), part=part, letters=letters)
    return marking.json()["lines"]


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("22.11 = 3p + 2q", "true"),  # cut off
        ("22.14 = 3p + 2q", "false"),
        ("3(7.372) = 3p + 2q => 22.116 = 3p + 2q", "true"),
        ("3(7.372) = 3p + 2q => 22.16 = 3p + 2q", "false"),
    ],
)
def test_a_sum_is_what_the_figures_beside_it_come_to(line: str, verdict: str) -> None:
    letters = {"p": "along(velocity(A), i)", "q": "along(velocity(B), i)"}
    assert lines_of(OBLIQUE, None, line, **letters)[0]["verdict"] == verdict


def test_what_is_done_to_an_equation_may_stand_behind_it() -> None:
    letters = {"p": "along(velocity(A), i)", "q": "along(velocity(B), i)"}
    lines = ("3(9cos35) + 0 = 3p + 2q  [×10]", "q - p = 0.6(9cos35) (÷3)")
    found = lines_of(OBLIQUE, None, *lines, **letters)
    assert [line["principle"] for line in found] == ["momentum", "restitution"]


def test_components_of_two_spheres_need_no_comma() -> None:
    found = lines_of(OBLIQUE, None, "A perp 5.16 B perp 0")
    assert (found[0]["verdict"], found[0]["principle"]) == ("true", "unchanged")


def test_a_way_in_metres_at_a_speed_is_a_time() -> None:
    lines = ("6m at 12m/s = 0.5s", "then 8m at 4m/s = 2s", "then 8m at 4m/s = 3s")
    found = lines_of(GUTTER, "b", *lines)
    assert [line["verdict"] for line in found] == ["true", "true", "false"]


def test_a_vector_behind_the_number_of_an_event_is_the_velocity_after_it() -> None:
    found = lines_of(GUTTER, "a", "first 5i + 4j", "second 5i - 4j")
    assert [line["verdict"] for line in found] == ["true", "false"]
    assert lines_of(GUTTER, "a", "2nd hit: 5i - 2j")[0]["verdict"] == "true"


def test_a_product_with_any_vector_along_the_line_is_a_component() -> None:
    product, across = (
        restitution.mark(solved(FOUND), line, part="b").marks
        for line in ("(4, 2).(1, 2) = 8", "(4, 2).(2, -1) = 6")
    )
    assert product.earned > across.earned


@pytest.mark.parametrize(
    ("line", "name"),
    [("10 = 2(v - 6)", "sign"), ("10 = 5(-2 - w)", "sign"), ("10 = 2(v + 6)", "impulse-sign")],
)
def test_an_impulse_of_the_other_sense_has_a_wrong_sign_alone(line: str, name: str) -> None:
    letters = {"v": "along(velocity(A), j)", "w": "along(velocity(B), j)"}
    assert lines_of(BLOW, None, line, **letters)[0]["mistake"]["id"] == name


def test_a_difference_of_squares_without_its_half_is_seen() -> None:
    found = lines_of(WALL, None, "loss = 3(25 - 4) = 63")
    assert found[0]["mistake"]["id"] == "energy-no-half"
