"""Sentences about components, and what lines with them earn."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

import restitution

WALL = """
wall W: along i
sphere P: mass 2, velocity 12i - 5j
P hits W: e = 3/5
find velocity(P), speed(P)
"""
REST = """
sphere A: mass 2m, velocity 4u at 30°
sphere B: mass m, at rest
A hits B: along i, e = 1/5
part a
find speed(A), speed(B)
part b
find energy_lost
"""
BACK = """
sphere A: mass m, velocity 9u i + 3u j
sphere B: mass k m, at rest
A hits B: along i, e = 2/3
given velocity(A) in the direction of -i + j
find k
"""
LOST = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 3/4, energy_lost = 27/100 energy(0)
find e
"""
IMPULSE = """
wall W: along j
sphere P: mass 3, velocity 6i + 2j
P hits W: e = 1/2
find impulse, energy_lost
"""


@cache
def solved(text: str) -> restitution.Solution:
    return restitution.solve(restitution.parse(text))


def marking(text: str, *lines: str, part: str | None = None, **letters: str) -> dict[str, Any]:
    return restitution.mark(solved(text), lines, part=part, letters=letters).json()


def verdicts(found: dict[str, Any]) -> list[str]:
    return [line["verdict"] for line in found["lines"]]


def states(found: dict[str, Any]) -> list[tuple[str, str]]:
    return [(point["kind"], point["state"]) for point in found["marks"]["points"]]


@pytest.mark.parametrize("word", ["stays", "remains", "is unchanged at"])
def test_a_component_that_stays_is_one_after(word: str) -> None:
    found = marking(WALL, f"parallel {word} 12", f"perpendicular {word} 5")
    assert verdicts(found) == ["true", "false"]
    assert found["lines"][0]["principle"] == "unchanged"
    assert found["lines"][1]["principle"] == "restitution"


def test_a_sphere_has_components_along_and_across_the_line() -> None:
    right = "along line of centres A has 4u cos 30", "and across it 4u sin 30"
    wrong = "along line of centres A has 4u sin 30", "and across it 4u cos 30"
    assert verdicts(marking(REST, *right, part="a")) == ["true", "true"]
    found = marking(REST, *wrong, part="a")
    assert verdicts(found)[0] == "false"
    assert found["lines"][0]["mistake"]["id"] == "sine-cosine"


def test_a_sphere_that_goes_back_has_its_component_turned() -> None:
    assert verdicts(marking(BACK, "A goes back at 3u")) == ["true"]
    assert verdicts(marking(BACK, "A goes back at 4u")) != ["true"]


def test_energies_along_the_line_only_need_no_component_across() -> None:
    lines = "along the line only: KE before = 1/2 × 2m × 12u^2 = 12mu^2", "KE lost = 96mu^2/25"
    assert verdicts(marking(REST, *lines, part="b")) == ["true", "true"]
    whole = marking(REST, "KE before = 1/2 × 2m × 12u^2 = 12mu^2", part="b")
    assert verdicts(whole) == ["false"]


def test_an_impulse_along_an_axis_is_given_by_its_vector() -> None:
    found = marking(IMPULSE, "impulse = 3(-3i + 2j) - 3(6i + 2j) = -27i")
    assert states(found)[1:3] == [("M1", "earned"), ("A1", "earned")]


def test_an_energy_equation_is_earned_below_which_there_is_a_slip() -> None:
    lines = "perp after = 3eu/5", "9(1 - e^2) = 27/4", "e^2 = 3/4"
    found = marking(LOST, *lines)
    assert verdicts(found) == ["true", "true", "false"]
    assert states(found)[2:4] == [("DM1", "earned"), ("A1", "earned")]


def test_a_velocity_with_the_coefficient_in_it_has_the_component_that_stays() -> None:
    text = WALL.replace("e = 3/5", "").replace(": \nfind velocity(P), speed(P)", "")
    found = marking(text + "given speed(P) = 12.5\nfind e", "after: 12i + 5ej")
    assert ("B1", "earned") in states(found)


def test_a_law_upside_down_has_its_component_all_the_same() -> None:
    corner = """
wall AB: along i
wall BC: along j
sphere P: velocity 4 at 60° to AB
P hits AB: e = 1/2
P hits BC: e = 1/3
find speed(P)
"""
    found = marking(corner, "towards BC: 4 cos 60 = 2", "perp after = 3 × 2 = 6")
    assert found["lines"][-1]["mistake"]["id"] == "restitution-inverted"
