"""How planned workings read: letters and their introductions, reasons, quotients, lines."""

from __future__ import annotations

import re
from functools import cache

import pytest
from laws_of_printing import PRINTED

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

VECTORS = """
sphere A: mass 2, velocity 7i + j
sphere B: mass 3, velocity 2i - 4j
A hits B: along 3i + 4j, e = 1/2
find velocity(A), velocity(B)
"""
SPEED = """
sphere A: mass m, velocity 2u i
sphere B: mass m, at rest
A hits B: along 60°, e = 1/3
find speed(A)
"""
WALLS = """
wall V: along j
wall W: along i
sphere P: velocity 3u i + 4u j
P hits V: e = 1/3
P hits W: e = 1/2
find velocity(P), deflection(P)
"""
SLANTING = """
wall W: along i + 2j
sphere P: mass 2, velocity 3i + j
P hits W: e = 1
find angle(velocity(P), W)
"""
THREE = """
sphere A: mass 2m, velocity u i
sphere B, C: mass m, at rest
A hits B: along i, e = 1/2
B hits C: along i, e = 1/2
find velocity(B), velocity(C)
"""
HALF = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/3
given angle(velocity(P), W) = alpha/2
find alpha
"""
TANGENT = """
wall W: along i
sphere P: mass 0.2, velocity 10 at arctan(4/3) from -j
P hits W: e = 0.5
find velocity(P), angle(velocity(P), W)
"""
ASIDE = """
sphere A, B: mass m, radius r
sphere A: velocity u i
sphere B: at rest
A hits B: offset 6r/5, e = 1/2
find speed(A)
"""
SHOWN = """
sphere A: mass 2m, velocity u (3i + j)
sphere B: mass 3m, velocity -u i
A hits B: along i + j, e = 1/2
show impulse(B) in the direction of i + j
find impulse
"""
OPPOSITE = """
sphere A: mass m, velocity 2u at alpha
sphere B: mass 2m, velocity u at alpha from -i
A hits B: along i
show velocity(A) parallel to velocity(B)
"""
UNKNOWN = """
wall W: along i + 3j
wall X: along 2i - j
sphere P: velocity a i + b j
P hits W: e = 1/2
P hits X: e = 1/3
given velocity(P) = 2i + 4j
find a, b
"""
SLANTED = """
wall V: along i
wall W: along 75°
sphere P: velocity u at 60° to V
P hits V: e = 2/5
P hits W: e = 1/2
find speed(P)
"""
COSINE = """
wall W: along j
sphere P: mass 0.15, velocity 40 at arccos(0.6)
P hits W: e = 1/2
find speed(P)
"""
START = """
point N: (7, 2)
wall W: along i, through (0, 0)
sphere P: at (0, h), velocity u at 45° to W
P hits W: e = 1/2
P reaches N
find h
"""
LATER = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 1, velocity -i
A hits B: along i, e = 1/2
given distance(A, B, at T) = 10
find T
"""
TWO_STORIES = """
part a
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/2
find speed(P)
part b
sphere A, B: mass m
sphere A: velocity v at 45°
sphere B: at rest
A hits B: along i, e = 1/2
find speed(A)
"""
UPRIGHT = """
sphere A, B: mass m
sphere A: velocity v at 45°
sphere B: at rest
A hits B: along i
find range of deflection(A)
"""
UPRIGHT_OF_MASSES = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass M, at rest
A hits B: along i
find tan(direction(A))
"""
UPRIGHT_AT_AN_END = """
sphere A: mass m, velocity u at 45°
sphere B: mass 4m, at rest
A hits B: along i
given e <= 1/4
show deflection(A) <= 45°
"""
NEVER_UPRIGHT = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
find tan(direction(A))
"""
ANY_ANGLE = """
wall AB: along i
wall BC: along j
sphere P: velocity u at alpha to AB
P hits AB: e = f
P hits BC: e = g
find tan(angle(velocity(P), BC))
"""
AT_REST = """
wall AB: along i
wall BC: along j
sphere P: velocity u at alpha to AB
P hits AB: e = f
P hits BC: e = f
given tan(alpha) = 3
find angle(velocity(P), BC)
"""
ONE_VALUE = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = 1
given energy(B) = 1/4 energy(0)
find alpha
find range of direction(B), range of direction(A)
"""
TWO_RATIOS = """
sphere A: mass m, velocity u at 45°
sphere B: mass m, velocity v at 135°
A hits B: along i, e = 1/2
given energy_lost = 1/4 energy(0)
find v/u
"""
EITHER_SIDE = """
wall W: along theta
sphere P: velocity u i
P hits W: e = 1/3
find direction(P)
"""
ASKED_THOUGH_GIVEN = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
given k = 3, tan(alpha) = 3/4
find k, tan(alpha), alpha, velocity(A)
"""
WHOLE_COMPONENT = """
wall W: along i
sphere P: mass 2, velocity v at theta to W
P hits W
given velocity(P) = 4i + 3j, impulse = 18
find v, theta, e
"""
WHOLE_COMPONENT_BELOW = """
point T: (12, 0)
wall W: along i, through (0, 6)
sphere P: velocity v at theta to W, at (0, 0)
P hits W: e = 1/2
P reaches T
given time(2) = 3
find v, time(1)
"""
UPRIGHT_WITH_A_TANGENT = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given tan(alpha) = 1/2, deflection(A) > 30°
find range of e
"""
UPRIGHT_WHEN_INELASTIC = """
sphere A, B: mass m
sphere A: velocity u at 60°
sphere B: velocity u at 120°
A hits B: along i
given angle(velocity(A), velocity(B)) = arctan(4/3)
find e
"""
LATER_THAN = """
wall W: along j, through (d, 0)
sphere A: mass m, at (0, 0), velocity u i
A hits W: e = e
find time(1), position(A, at T)
"""
AWAY = """
sphere A: mass m, velocity 2u i
sphere B: mass 2m, at rest
sphere C: mass m, at rest
A hits B: along i, e = 1/2
B hits C: along 60°, e = 1/2
find velocity(B), deflection(B)
"""
AGAIN = """
sphere A: mass m, velocity 4u i
sphere B: mass m, at rest
sphere C: mass m, at rest
A hits B: along i, e = 1/2
B hits C: along i, e = 1/2
find velocity(B), velocity(C)
show B and C do not collide again
"""
BOUNDED = """
sphere A: mass 2, velocity 3i
sphere B: mass 1, velocity -i + 2j
A hits B: along i
given 1/4 < e
given e < 1/2
find range of speed(B), range of energy_lost
"""
MEETING = """
wall W: along i, through (0, 0)
sphere P: at (0, 3), velocity 4i - 2j
P hits W: e = 1/2
find time(1)
"""
DEAD = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 0
find impulse, velocity(P)
"""

READINGS = [
    (SHOWN, "So the impulse on B is in the direction of 𝐢 + 𝐣, as required."),
    (SHOWN, "magnitude of the impulse = (9mu/2)√(1² + 1²) = 9√2 mu/2"),
    (OPPOSITE, "Comparing the two vectors: 𝐯_A = −2𝐯_B"),
    (UNKNOWN, "Let 𝐧₂ = (𝐢 + 2𝐣)/√5 be a unit vector perpendicular to X,"),
    (SLANTED, "component of 𝐯₁ towards W = (u/2) sin 75° − (√3 u/5) cos 75°"),
    (COSINE, "the component in the direction of 𝐣 stays 40 × 0.8 = 32 m s⁻¹."),
    (START, "x-coordinate of P at the impact = h((u cos 45°)/(u sin 45°)) = h"),
    (LATER, "T = √5 ≈ 2.24"),
    (TWO_STORIES, "v cos 45° = mw + mx"),
    (UPRIGHT, "which holds if e = 1 too, where δ = 45°"),
    (UPRIGHT_OF_MASSES, "= 90° if 2m = eM"),
    (UPRIGHT_AT_AN_END, "δ ≤ 45°, as 0° ≤ β ≤ 90° (as required)"),
    (ANY_ANGLE, ", for f ≠ 0"),
    (WHOLE_COMPONENT, " 3 = 6e "),
    (ASKED_THOUGH_GIVEN, "It is given that k = 3"),
    (ASKED_THOUGH_GIVEN, "α = arctan(3/4) ≈ 36.9°"),
    (ONE_VALUE, "angle from 𝐢 to 𝐯_B = 0°"),
    (WHOLE_COMPONENT_BELOW, "Substituting for v sin θ in (1):"),
    (AT_REST, "= ⅓, for f ≠ 0"),
    (UPRIGHT_WITH_A_TANGENT, "= (1 + e)/(3 − 2e) which holds if e = 1 too, where δ = 90° − α"),
    (UPRIGHT_WHEN_INELASTIC, "is arctan(4/3), of which the cosine is ⅗. By the scalar product:"),
    (LATER_THAN, "= (d + e(d − Tu))𝐢 for T ≥ d/u"),
    (AWAY, "tan δ = (√3 u/8)/(7u/8) = √3/7"),
    (AGAIN, "v₂ = 3u/4 < 9u/4 = w₂"),
    (BOUNDED, " m s⁻¹ < speed of B < "),
    (BOUNDED, " J < kinetic energy lost < "),
    (MEETING, "Time = distance ÷ speed parallel to the y-axis:"),
    (DEAD, "Newton's experimental law, as the coefficient of restitution is 0:"),
    (VECTORS, "Let 𝐮_A and 𝐮_B be the velocities of A and B before the impact."),
    (VECTORS, "Let 𝐯_A and 𝐯_B be the velocities of A and B after the impact."),
    (VECTORS, "Let 𝐧 = (3𝐢 + 4𝐣)/5 be the unit vector along the line of centres"),
    (VECTORS, "𝐮_A · 𝐧 = (3 × 7 + 4)/5 = 5 m s⁻¹"),
    (SPEED, "component of A to the left, looking from A to B, stays −2u sin 60° = −√3 u."),
    (WALLS, "Let 𝐯₁ be the velocity of P after the first impact."),
    (WALLS, "Let 𝐯₂ be the velocity of P after the second impact."),
    (SLANTING, "tan β = √5/√5 = 1"),
    (THREE, "Let v₁ and w₁ be the components of the velocities of A and B"),
    (THREE, "Let v₂ and w₂ be the components of the velocities of B and C"),
    (HALF, "Dividing by t, which is not zero as α is acute:"),
    (TANGENT, "An acute angle with tangent 4/3 has sine 0.8 and cosine 0.6."),
    (TANGENT, "tan β = ⅜ M1 β = arctan(3/8)"),
    (TANGENT.replace("arctan(4/3)", "arcsin 0.8"), "tan β = ⅜ = 0.375 M1 β = arctan 0.375"),
    (ASIDE, "the angle between the line of centres and that path has sine"),
]
STATEMENTS = list(dict.fromkeys(statement for statement, _ in READINGS))


@cache
def working(statement: str) -> tuple[Solution, Derivation]:
    solution = solve(parse(statement))
    return solution, plan(solution)


@cache
def text(statement: str) -> str:
    solution, _ = working(statement)
    return re.sub(r"\s+", " ", to_text(explain(solution)))


@pytest.mark.parametrize(("statement", "words"), READINGS, ids=[each for _, each in READINGS])
def test_a_working_says(statement: str, words: str) -> None:
    assert words in text(statement)


def test_a_direction_on_either_side_of_j_is_not_given_by_one_arctangent() -> None:
    # θ + arctan(⅓ tan θ) is obtuse beyond θ = 60° only.
    words = to_text(explain(solve(parse(EITHER_SIDE))), 80)
    assert "180° − arctan" not in words


def test_a_ratio_with_two_values_is_asked_of_each_case() -> None:
    words = text(TWO_RATIOS)
    assert "v/u = 3 − 2√2" in words
    assert "v/u = 3 + 2√2" in words


def test_an_angle_that_is_always_acute_is_not_said_to_be_90() -> None:
    assert "90° if" not in text(NEVER_UPRIGHT)


@pytest.mark.parametrize("statement", [WHOLE_COMPONENT, WHOLE_COMPONENT_BELOW])
def test_a_component_that_is_known_is_not_taken_apart(statement: str) -> None:
    assert "    sin θ = " not in text(statement)


def test_impacts_of_other_bodies_are_not_counted() -> None:
    assert "First impact" not in text(TWO_STORIES)
    assert "Second impact" not in text(TWO_STORIES)


@pytest.mark.parametrize("statement", STATEMENTS, ids=range(len(STATEMENTS)))
def test_workings_are_accepted_and_keep_the_laws(statement: str) -> None:
    solution, derivation = working(statement)
    assert not follow(derivation, Oracle(roles(solution.problem)))
    for law in ("vectors are introduced", "brackets stay on a line", "titles say something new"):
        assert not PRINTED[law](solution, derivation), law
