"""Questions that follow from a fact about the motion after a collision, and on ranges."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import gcd

from restitution.practice.questions.dice import Dice, Recipe
from restitution.practice.questions.nice import (
    COEFFICIENTS,
    Acute,
    acute,
    lines_of,
    pair,
    ratio,
    times,
    unlike_numbers,
    vector,
)


def _light_and_heavy(d: Dice) -> tuple[int, int]:
    return d.of([(a, b) for a in range(1, 5) for b in range(2, 7) if a < b])


def _unlike_masses(d: Dice, most: int = 5) -> tuple[int, int]:
    return unlike_numbers(d, range(1, most + 1), range(1, most + 1))


# --- at right angles ----------------------------------------------------------------------------


def _right_angle_1(d: Dice) -> str:
    """A moves off along the tangent, so B, which was at rest, at right angles to it: e = m/M."""
    m, big = _light_and_heavy(d)
    angle = acute(d, 13)
    speed = angle.hypotenuse * d.between(1, 2)
    return lines_of(
        f"sphere A: mass {m}, velocity {speed} at alpha",
        f"sphere B: mass {big}, at rest",
        f"given {d.of(angle.fact)}",
        "A hits B: along i",
        "given velocity(A) perpendicular to velocity(B)",
        "part a",
        "find e",
        "part b",
        "find speed(A), speed(B)",
    )


def _turned(d: Dice) -> tuple[int, int, Acute, Fraction]:
    """Masses, an angle and a coefficient with which A is turned through a right angle."""
    options = []
    for m1 in range(1, 6):
        for m2 in range(2, 10):
            for a, b in ((a, b) for a in range(1, 6) for b in range(1, 6)):
                e = (m1 + (m1 + m2) * Fraction(a * a, b * b)) / m2
                plain = gcd(m1, m2) == gcd(a, b) == 1 and a != b and e.denominator <= 12
                if plain and Fraction(1, 5) <= e <= Fraction(9, 10):
                    options.append((m1, m2, Acute(a, b, 0), e))
    return d.of(options)


def _right_angle_2(d: Dice) -> str:
    m1, m2, angle, _ = _turned(d)
    return lines_of(
        f"sphere A: mass {times(m1, 'm')}, velocity u at alpha",
        f"sphere B: mass {times(m2, 'm')}, at rest",
        f"given tan(alpha) = {angle.tangent}",
        "A hits B: along i",
        "given velocity(A) perpendicular to velocity(A, 0)",
        "part a",
        "find e",
        "part b",
        d.of(("find speed(A)", "find speed(A), speed(B)")),
    )


def _right_angle_3(d: Dice) -> str:
    m1, m2, _, e = _turned(d)
    return lines_of(
        f"sphere A: mass {times(m1, 'm')}, velocity u at alpha",
        f"sphere B: mass {times(m2, 'm')}, at rest",
        f"A hits B: along i, e = {ratio(e)}",
        "given deflection(A) = 90°",
        "part a",
        "find alpha",
        "part b",
        d.of(("find speed(A), speed(B)", "find speed(B), energy_lost/energy(0)")),
    )


def _right_angle_4(d: Dice) -> str:
    m1, m2, _, e = _turned(d)
    return lines_of(
        f"sphere A: mass {times(m1, 'm')}, velocity u at alpha",
        f"sphere B: mass {times(m2, 'm')}, at rest",
        "A hits B: along i",
        "given deflection(A) = 90°",
        "part a",
        "find tan(alpha) in terms of e",
        "part b",
        f"given e = {ratio(e)}",
        d.of(("find speed(A), speed(B)", "find speed(B), impulse")),
    )


# --- energy -------------------------------------------------------------------------------------


def _energy_1(d: Dice) -> str:
    c = pair(d, at_rest=True, denominators=3)
    lost = c.m1 * c.m2 / (c.m1 + c.m2) / 2 * (1 - c.e * c.e) * c.p1 * c.p1
    return lines_of(
        f"sphere A: mass {_mass(c.m1)}, velocity {vector(c.p1, c.s1)}",
        f"sphere B: mass {_mass(c.m2)}, at rest",
        "A hits B: along i",
        f"given energy_lost = {lost}",
        "part a",
        "find e",
        "part b",
        "find velocity(A), velocity(B)",
    )


def _energy_2(d: Dice) -> str:
    c = pair(d, denominators=3)
    lost = c.m1 * c.m2 / (c.m1 + c.m2) / 2 * (1 - c.e * c.e) * (c.p1 - c.p2) ** 2
    return lines_of(
        f"sphere A: mass {_mass(c.m1)}, velocity {vector(c.p1, c.s1)}",
        f"sphere B: mass {_mass(c.m2)}, velocity {vector(c.p2, c.s2)}",
        "A hits B: along i",
        f"given energy_lost = {lost}",
        "part a",
        "find e",
        "part b",
        d.of(("find velocity(A), velocity(B)", "find speed(A), speed(B)")),
    )


def _simple_share(d: Dice) -> tuple[int, int, Acute, Fraction, Fraction]:
    """Masses, an angle and a coefficient with which a simple share of the energy is lost."""
    angle = acute(d, 5)
    options = []
    for m1 in range(1, 6):
        for m2 in range(1, 6):
            for e in COEFFICIENTS:
                share = (1 - e * e) * Fraction(m2 * angle.along**2, (m1 + m2) * 25)
                if m1 != m2 and share.denominator <= 60 and e * m2 != m1:
                    options.append((m1, m2, angle, e, share))
    return d.of(options)


def _energy_3(d: Dice) -> str:
    m1, m2, angle, _, share = _simple_share(d)
    return lines_of(
        f"sphere A: mass {times(m1, 'm')}, velocity u at alpha",
        f"sphere B: mass {times(m2, 'm')}, at rest",
        f"given {d.of(angle.fact)}",
        "A hits B: along i",
        f"given energy_lost = {share} energy(0)",
        "part a",
        "find e",
        "part b",
        d.of(("find speed(B), speed(A)", "find speed(B), deflection(A)")),
    )


def _energy_4(d: Dice) -> str:
    m1, m2, _, e, share = _simple_share(d)
    return lines_of(
        f"sphere A: mass {times(m1, 'm')}, velocity u at alpha",
        f"sphere B: mass {times(m2, 'm')}, at rest",
        f"A hits B: along i, e = {ratio(e)}",
        f"given energy_lost = {share} energy(0)",
        "part a",
        "find alpha",
        "part b",
        d.of(("find speed(A), speed(B)", "find speed(B), deflection(A)")),
        "part c",
        "find impulse",
    )


def _mass(m: Fraction) -> str:
    return f"{float(m):g}"


# --- brought to rest, or to the tangent ---------------------------------------------------------


def _rest_1(d: Dice) -> str:
    """B is brought to rest."""
    while True:
        c = pair(d, both_across=False, denominators=3)
        # e that leaves B at rest
        gap = c.p1 - c.p2
        e = -(c.m1 * c.p1 + c.m2 * c.p2) / (c.m1 * gap)
        if 0 < e < 1 and e.denominator <= 12:
            break
    return lines_of(
        f"sphere A: mass {_mass(c.m1)}, velocity {vector(c.p1, c.s1)}",
        f"sphere B: mass {_mass(c.m2)}, velocity {vector(c.p2, 0)}",
        "A hits B: along i",
        "given B at rest",
        "part a",
        "find e",
        "part b",
        "find velocity(A)",
        "part c",
        d.of(("find impulse", "find energy_lost", "find deflection(A)")),
    )


def _rest_2(d: Dice) -> str:
    m, big = _light_and_heavy(d)
    angle = acute(d, 5)
    return lines_of(
        f"sphere A: mass {times(m, 'm')}, velocity u at alpha",
        f"sphere B: mass {times(big, 'm')}, at rest",
        f"given {d.of(angle.fact)}",
        "A hits B: along i",
        "given velocity(A) perpendicular to line_of_centres",
        "part a",
        "find e",
        "part b",
        "find speed(A), speed(B)",
        "part c",
        "find energy_lost/energy(0)",
    )


def _rest_3(d: Dice) -> str:
    while True:
        c = pair(d, denominators=4)
        gap = c.p1 - c.p2
        e = (c.m1 * c.p1 + c.m2 * c.p2) / (c.m2 * gap)
        if 0 < e < 1 and e.denominator <= 12:
            break
    return lines_of(
        f"sphere A: mass {_mass(c.m1)}, velocity {vector(c.p1, c.s1)}",
        f"sphere B: mass {_mass(c.m2)}, velocity {vector(c.p2, c.s2)}",
        "A hits B: along i",
        "given velocity(A) perpendicular to i",
        "part a",
        "find e",
        "part b",
        "find velocity(B)",
        "part c",
        d.of(("find energy_lost", "find impulse, deflection(B)")),
    )


def _rest_4(d: Dice) -> str:
    e = d.of([coefficient for coefficient in COEFFICIENTS if coefficient.numerator < 4])
    angle = acute(d, 5)
    return lines_of(
        "sphere A: mass m, velocity u at alpha",
        "sphere B: mass k m, at rest",
        f"given {d.of(angle.fact)}",
        f"A hits B: along i, e = {ratio(e)}",
        "given velocity(A) perpendicular to line_of_centres",
        "part a",
        "find k",
        "part b",
        "find speed(B), impulse",
        "part c",
        "find energy_lost/energy(0)",
    )


# --- ranges -------------------------------------------------------------------------------------


def _range_1(d: Dice) -> str:
    """The second speed after a wall, whatever the coefficient."""
    angle = acute(d, 13)
    speed = angle.hypotenuse * d.between(1, 2)
    e = d.of(COEFFICIENTS)
    return lines_of(
        "wall W: along i",
        f"sphere P: velocity {speed} at alpha to W",
        f"given {d.of(angle.fact)}",
        "P hits W",
        "part a",
        "find range of speed(P)",
        "part b",
        f"given e = {ratio(e)}",
        "find speed(P), angle(velocity(P), W)",
    )


def _range_2(d: Dice) -> str:
    """A is turned back by a heavier sphere at rest."""
    m1, m2 = _light_and_heavy(d)
    c = pair(d, at_rest=True)
    return lines_of(
        f"sphere A: mass {times(m1, 'm')}, velocity {vector(c.p1, c.s1, 'u')}",
        f"sphere B: mass {times(m2, 'm')}, at rest",
        "A hits B: along i",
        "part a",
        "find along(velocity(A), i), speed(B)",
        "part b",
        "given along(velocity(A), i) < 0",
        "find range of e",
    )


def _range_3(d: Dice) -> str:
    m1, m2 = _unlike_masses(d)
    c = pair(d, both_across=False, reach=4)
    e = d.of(COEFFICIENTS)
    return lines_of(
        f"sphere A: mass {times(m1, 'm')}, velocity {vector(abs(c.p1), c.s1, 'u')}",
        f"sphere B: mass {times(m2, 'm')}, velocity {vector(-d.between(1, 3), 0, 'u')}",
        "A hits B: along i",
        "part a",
        "find velocity(A), velocity(B)",
        "part b",
        "find range of speed(B)",
        "part c",
        f"given e = {ratio(e)}",
        "find energy_lost",
    )


def _range_4(d: Dice) -> str:
    """Both are turned back: between which values the mass lies."""
    c = pair(d, both_across=False, reach=4)
    e = d.of([coefficient for coefficient in COEFFICIENTS if coefficient.denominator < 6])
    p2 = -d.between(1, 3)
    return lines_of(
        f"sphere A: mass m, velocity {vector(c.p1, c.s1, 'u')}",
        f"sphere B: mass k m, velocity {vector(p2, 0, 'u')}",
        f"A hits B: along i, e = {ratio(e)}",
        "part a",
        "find velocity(A), velocity(B)",
        "part b",
        "given along(velocity(A), i) < 0, along(velocity(B), i) > 0",
        "find range of k",
    )


RECIPES: Mapping[tuple[str, int], tuple[Recipe, ...]] = {
    ("right-angles", 1): (_right_angle_1,),
    ("right-angles", 2): (_right_angle_2,),
    ("right-angles", 3): (_right_angle_3,),
    ("right-angles", 4): (_right_angle_4,),
    ("energy-given", 1): (_energy_1,),
    ("energy-given", 2): (_energy_2,),
    ("energy-given", 3): (_energy_3,),
    ("energy-given", 4): (_energy_4,),
    ("at-rest-afterwards", 1): (_rest_1,),
    ("at-rest-afterwards", 2): (_rest_2,),
    ("at-rest-afterwards", 3): (_rest_3,),
    ("at-rest-afterwards", 4): (_rest_4,),
    ("ranges", 1): (_range_1,),
    ("ranges", 2): (_range_2,),
    ("ranges", 3): (_range_3,),
    ("ranges", 4): (_range_4,),
}
