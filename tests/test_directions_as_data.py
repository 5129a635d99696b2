"""Directions that facts give to walls and lines of centres."""

from __future__ import annotations

import pytest

from restitution.errors import StatementError
from restitution.language import parse
from restitution.solving import solve
from restitution.solving.story.given_directions import with_given_directions
from restitution.workings import explain, to_text

WALL = (
    "wall W{along}\nsphere P: mass 2, velocity 4i - 2j\nP hits W: e = 1/2\n{given}find velocity(P)"
)
SPHERES = (
    "sphere A: mass 1, velocity 5i\nsphere B: mass 2, at rest\n"
    "A hits B: e = 1/2{along}\n{given}find velocity(B)"
)


def working(text: str) -> str:
    return to_text(explain(solve(parse(text))), 80)


@pytest.mark.parametrize(
    ("fact", "along"),
    [
        ("direction(W) = i", "i"),
        ("direction(W) parallel to i + 2j", "i + 2j"),
        ("i parallel to W", "i"),
        ("W parallel to 3i + 4j", "3i + 4j"),
        ("direction(W) = (3i + 4j)/5", "3i + 4j"),
        ("direction(W) = (i - j)/sqrt(2)", "i - j"),
        ("direction(W) = 45°", "45°"),
    ],
)
def test_a_wall_has_the_direction_of_a_fact(fact: str, along: str) -> None:
    by_fact = WALL.format(along="", given=f"given {fact}\n")
    assert working(by_fact) == working(WALL.format(along=f": along {along}", given=""))


@pytest.mark.parametrize("fact", ["line_of_centres", "line_of_centres(1)"])
def test_a_line_of_centres_has_the_direction_of_a_fact(fact: str) -> None:
    by_fact = SPHERES.format(along="", given=f"given {fact} parallel to 3i + 4j\n")
    assert working(by_fact) == working(SPHERES.format(along=", along 3i + 4j", given=""))


def test_a_line_of_centres_as_a_unit_vector_has_its_sense() -> None:
    shown = working(SPHERES.format(along="", given="given line_of_centres = (3i + 4j)/5\n"))
    assert "not written" not in shown
    assert "(0.9𝐢 + 1.2𝐣) m s⁻¹" in shown
    wrong = solve(parse(SPHERES.format(along="", given="given line_of_centres = -(3i + 4j)/5\n")))
    result = wrong["velocity(B)"]
    assert result.error is not None


def test_a_line_of_centres_is_a_unit_vector() -> None:
    text = SPHERES.format(along="", given="given line_of_centres = 3i + 4j\n")
    result = solve(parse(text))["velocity(B)"]
    assert isinstance(result.error, StatementError)
    assert "write 'line_of_centres parallel to 3i + 4j'" in str(result.error)


def test_a_direction_that_is_sought_stays_a_fact() -> None:
    text = WALL.format(along="", given="given W parallel to i + k j\n").replace(
        "find velocity(P)", "given velocity(P) = 4i + j\nfind k"
    )
    assert with_given_directions(parse(text)) == parse(text)


def test_a_fact_of_one_part_is_no_data_of_another() -> None:
    text = (
        "wall W\nsphere P: mass 2, velocity 4i - 2j\nP hits W: e = 1/2\n"
        "part a\ngiven W parallel to i\nfind velocity(P)\n"
        "part b\ngiven W parallel to i + j\nfind velocity(P)"
    )
    assert with_given_directions(parse(text)) == parse(text)
    solution = solve(parse(text))
    first, second = (str(each.exact) for _, each in solution.items())
    assert first != second
