"""Masses that a fact gives, and results to be shown in a letter that has been found."""

from __future__ import annotations

import pytest
from workings import printed_with

WALL = "wall W: along i\n"
# A statement, and what its working says, in this order.
CASES = {
    "a letter in a part, with degrees": (
        WALL
        + """sphere P: velocity 5 at 40° to W
P hits W: e = 1/2
part a
given mass(P) = m
find impulse
part b
given mass(P) = m, impulse = 9
find m
""",
        (
            "magnitude of the impulse = m((5/2) sin 40° + 5 sin 40°)",
            "9 = (15/2)m sin 40°",
            "m = 6/(5 sin 40°)",
        ),
    ),
    "a letter, with the energy": (
        WALL
        + """sphere P: velocity u at alpha to W
P hits W
given mass(P) = 2m
find impulse, energy_lost
""",
        (
            "2m(eu sin α + u sin α)",
            "Kinetic energy lost, by the component that changes:",
            "kinetic energy lost = ½ × 2m((u sin α)² − (eu sin α)²)",
        ),
    ),
    "a number for the letter of the data": (
        WALL
        + """sphere P: mass m, velocity 5i - 2j
P hits W: e = 1/2
given mass(P) = 3
find impulse
""",
        ("3(1 + 2) = 9 N s",),
    ),
    "a number for a multiple of a letter": (
        """sphere A: mass m, velocity 4i + j
sphere B: mass 3m, at rest
A hits B: along i, e = 1/2
given mass(B) = 6
find impulse
""",
        ("3m = 6", "m = 2", "= 9 N s"),
    ),
    "a letter of a second sphere": (
        """sphere A: mass 2, velocity 5i - 3j
sphere B: at rest
A hits B: along i, e = 1/3
given mass(B) = M, velocity(A) = i - 3j
find M
""",
        ("w = 8/3 m s⁻¹", "2 × 5 = 2 + 8M/3", "M = 3"),
    ),
    "shown in the letter that was found": (
        WALL
        + """sphere P: mass m, velocity u at alpha to W
P hits W
given speed(P) = 3/4 u, tan(alpha) = 4/3
find e
show tan(angle(velocity(P), W)) = e tan(alpha)
""",
        ("e = 9/16", "tan β = (4eu/5)/(3u/5) = 4e/3", "tan β = e tan α"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_given_of_masses_is_put_into_the_laws(name: str) -> None:
    statement, parts = CASES[name]
    text = printed_with(statement, parts)
    assert "the mass of P is" not in text
