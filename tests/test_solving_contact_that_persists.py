"""Spheres that stay in contact, as e was 0, and collide again when one of them is struck."""

from __future__ import annotations

import pytest

import restitution
from restitution.errors import ImpossibleError

START = """sphere A, B: mass 1
sphere A: at (0, 0), velocity 2i
sphere B: at (3, 0), at rest
wall W: along j, through (7, 0)
"""
LARGE = START.replace("mass 1", "mass 1, radius 1/2")
THIRD = "sphere C: mass 1, at (7, 0), at rest\n"
ROUND = START.replace("along j, through (7, 0)", "circle centre (0, 0) radius 7")


def _solved(text: str) -> str:
    return str(restitution.solve(restitution.parse(text)))


@pytest.mark.parametrize("start", [START, LARGE, ROUND], ids=["centres", "radii", "round wall"])
def test_a_range_has_the_coefficient_with_which_contact_persists(start: str) -> None:
    events = "A hits B: e = e1\nB hits W: e = 1/2\nA hits B: e = 1\n"
    assert _solved(f"{start}{events}find range of e1") == "range of e1 = 0 ≤ e₁ ≤ 1"


def test_a_third_sphere_that_is_struck_lets_those_in_contact_collide() -> None:
    text = f"""{START.partition("wall")[0]}{THIRD}A hits B: e = e1
B hits C: e = e2
A hits B: e = 1
find range of e1
"""
    assert _solved(text) == "range of e1 = 0 ≤ e₁ < (1 + e₂)/(3 − e₂)"


@pytest.mark.parametrize(
    ("start", "e", "expected"),
    [
        (LARGE, "0", "time(3) = 9/2\nvelocity(A) = 𝟎"),
        (START, "0", "time(3) = 11/2\nvelocity(A) = 𝟎"),
    ],
)
def test_two_impacts_have_one_time(start: str, e: str, expected: str) -> None:
    events = f"A hits B: e = {e}\nB hits W: e = 1\nA hits B: e = 0\n"
    assert _solved(f"{start}{events}find time(3), velocity(A)") == expected


def test_a_sphere_at_rest_at_a_wall_is_struck_there() -> None:
    events = "A hits B: e = 1/2\nB hits W: e = f\nA hits B: e = 0\n"
    assert _solved(f"{START}{events}find range of f") == "range of f = 0 ≤ f ≤ 1"


@pytest.mark.parametrize("start", [START, LARGE], ids=["centres", "radii"])
def test_no_sphere_strikes_a_wall_in_front_of_which_another_one_is(start: str) -> None:
    events = "A hits B: e = 0\nB hits W: e = 1\nA hits W: e = 1\n"
    (part,) = restitution.solve(
        restitution.parse(f"{start}{events}find velocity(A)")
    ).parts.values()
    error = part.items[0].error
    assert isinstance(error, ImpossibleError)
    assert error.message == "A strikes B first"
    events = "A hits B\nB hits W: e = 1\nA hits W: e = 1\n"
    assert "no value of e is possible" in _solved(f"{start}{events}find range of e")
