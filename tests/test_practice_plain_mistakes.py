"""Lines that no law fits, right or altered, and what they show by themselves."""

from __future__ import annotations

import pytest

import restitution

OBLIQUE = """
sphere A: mass m, velocity 5 at alpha
sphere B: mass 2m, at rest
A hits B: along i
given speed(A) = 3, speed(B) = 5/2
find e, alpha
"""
EQUAL = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = 1/2
given energy_lost = 25% energy(0)
find alpha
"""
ELASTIC = """
sphere A: mass m, velocity u at 30°
sphere B: mass m, at rest
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
"""
WALL = """
wall W
sphere P: mass 2, velocity 3i - 5j
P hits W
given impulse(P) = -8i + 16j
find e, velocity(P)
"""
HALF = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
given direction(A) = 90°, deflection(A) = 60°
find alpha, energy_lost/energy(0)
"""
STOPPED = """
sphere A: mass m, velocity u at 45°
sphere B: mass 2m, at rest
A hits B: along i
given velocity(A) perpendicular to velocity(B)
find e
"""
V = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
FRACTION = "v + w = ucosα\nw - v = 0.5ucosα\nw = 0.75ucosα v = 0.25ucosα\n"


@pytest.mark.parametrize(
    ("statement", "working", "name"),
    [
        (OBLIQUE, "m(5) = m(3) + 2m(2.5)", "speed-for-component"),
        (EQUAL, FRACTION + "½mu²cos²α(1 - 5/8) = ¼ × ½mu²cos²α", "energy-fraction-of-line"),
        (ELASTIC, "mu√3/2 = mv + mw\nw - v = u√3/2", "restitution-omitted"),
        (WALL, "v = 3i - 5j - 8i + 16j", "mass-omitted"),
        (HALF, "α = 30\nKE after = ½(2m)(u/2)²", "energy-one-sphere"),
        (STOPPED, "mucos45 = 2mw\nw = eu", "speed-for-component"),
    ],
)
def test_the_first_false_line_has_its_name(statement: str, working: str, name: str) -> None:
    letters = V if "sphere B" in statement else {"v": "velocity(P)"}
    marking = restitution.mark(restitution.parse(statement), working, letters=letters)
    assert marking.mistakes == (name,)
