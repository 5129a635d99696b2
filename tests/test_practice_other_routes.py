"""Right workings by routes and in words of the student's own, none of whose lines may be false."""

from __future__ import annotations

import pytest
from marked import solution_of, verdicts

import restitution

APART = (
    "sphere A, B: mass m\nsphere A: velocity 3i + 4j\nsphere B: velocity -i + j\n"
    "A hits B: along i + j, e = 0\nfind distance(A, B, at 3), velocity(A)\n"
)
CHAIN = (
    "sphere A, B, C: mass m\nsphere A: velocity u i\nsphere B, C: at rest\n"
    "A hits B: along 60°, e = 1/2\nfind speed(B)\nB hits C: along 30°, e = 1/2\n"
    "find velocity(B), speed(C)\n"
)
BACK = (
    "wall W: along j\nsphere A: mass 4m, velocity u i\nsphere B: mass m, at rest\n"
    "A hits B: along i, e = 3/4\nB hits W: e = f\nfind velocity(A), velocity(B)\n"
)
OFFSET = (
    "sphere A: mass m, velocity -2u i, radius a\nsphere B: mass m, velocity u i, radius a\n"
    "A hits B: offset sqrt(3) a, e = 2/3\nfind speed(A), speed(B), line_of_centres\n"
)
SLANTED = "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W: e = 1/2\nfind velocity(P)"


def earned(statement: str, *lines: str) -> tuple[int, int]:
    """The marks that lines earn, and those that there are."""
    marks = restitution.mark(solution_of(statement), list(lines)).marks
    return marks.earned, marks.of


@pytest.mark.parametrize(
    "line",
    [
        "distance after 3 secs = 3√(¼+¼) = 2.12",
        "distance apart after 3 s = 2.12",
        "distance 3 seconds later = 2.12",
        "dist at t = 3: 2.12",
    ],
)
def test_the_time_of_a_distance_is_no_value_of_it(line: str) -> None:
    assert verdicts(APART, line) == ["true"]


def test_the_size_of_a_relative_velocity_is_a_speed() -> None:
    assert verdicts(APART, "relative velocity = (-0.5, 0.5), speed = 0.7071") == ["true"]


@pytest.mark.parametrize(
    "line",
    [
        "perp: A: 1/√2, B: √2",
        "perp: A 1/√2, B √2",
        "perp A: 1/√2, B: √2",
        "perp components: A = 1/√2, B = √2",
        "along after: A: 7/(2√2), B: 7/(2√2)",
    ],
)
def test_a_way_before_several_bodies_is_that_of_each(line: str) -> None:
    assert verdicts(APART, line) == ["true"]


def test_a_way_before_several_bodies_shows_a_mistake() -> None:
    assert verdicts(APART, "perp after: A: 1/√2, B: 1/√2") == ["false"]


def test_a_letter_that_was_a_number_becomes_a_vector() -> None:
    assert verdicts(CHAIN, "vB = 3u/8", "vB = (-3u/128, 15√3u/128)") == ["true"] * 2
    assert verdicts(CHAIN, "vB = 3u/8", "vB = (-3u/128, 15√3u/64)")[0] == "true"


def test_an_approach_along_a_direction_of_the_students_own() -> None:
    lines = ("n = -½i - √3/2 j", "rel speed of approach along n = 3u cos 60 = 1.5u")
    assert verdicts(OFFSET, *lines) == ["true"] * 2


@pytest.mark.parametrize("axis", ["y velocity", "y-velocity", "y speed", "j velocity"])
def test_a_velocity_may_be_of_an_axis(axis: str) -> None:
    assert verdicts(SLANTED, f"{axis} after = 0.5×4 = 2") == ["true"]
    assert verdicts(SLANTED, f"{axis} after = 4") == ["false"]
    assert verdicts(SLANTED, "0.5 x speed of approach = 2") == ["true"]


@pytest.mark.parametrize(
    "rebound",
    [
        "velocity of B after wall = 7fu/5 away from wall",
        "B rebounds with 1.4fu to the left",
        "after wall B: -7fu/5",
        "after wall B has speed 7fu/5",
    ],
)
def test_along_one_line_a_speed_answers_for_a_velocity(rebound: str) -> None:
    laws = ("4u = 4x + y", "y - x = ¾u", "x = 13u/20", "y = 7u/5")
    got, total = earned(BACK, *laws, rebound)
    assert got == total
    assert earned(BACK, *laws)[0] < total
