"""Questions on collisions of two spheres, by topic and level."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from restitution.practice.questions.dice import Dice, Recipe
from restitution.practice.questions.nice import (
    COEFFICIENTS,
    TRIPLES,
    Acute,
    Pair,
    Slanted,
    acute,
    lines_of,
    masses_of,
    number,
    pair,
    ratio,
    slanted,
    times,
    vector,
)


def _turned(d: Dice) -> bool:
    """Whether the line of centres is parallel to j."""
    return d.below(2) == 1


def _in_axes(p: Fraction, s: Fraction, turned: bool, letter: str = "") -> str:
    return vector(-s, p, letter) if turned else vector(p, s, letter)


def _axis(turned: bool) -> str:
    return "j" if turned else "i"


def _vectors(d: Dice, c: Pair, *asked: str, letter: str = "", e: str | None = None) -> str:
    """Both velocities by components, the line of centres along an axis, and what is asked."""
    turned = _turned(d)
    m1, m2 = masses_of(c, "m" if letter else "")
    second = f"velocity {_in_axes(c.p2, c.s2, turned, letter)}" if c.p2 or c.s2 else "at rest"
    restitution = ratio(c.e) if e is None else e
    return lines_of(
        f"sphere A: mass {m1}, velocity {_in_axes(c.p1, c.s1, turned, letter)}",
        f"sphere B: mass {m2}, {second}",
        f"A hits B: along {_axis(turned)}" + (f", e = {restitution}" if restitution else ""),
        *(quantity.replace("AFTER_A", _in_axes(c.q1, c.s1, turned, letter)) for quantity in asked),
    )


# --- one at rest --------------------------------------------------------------------------------


def _struck(
    d: Dice, m1: str, m2: str, speed: str, e: Fraction, angle: Acute, *asked: str, line: str = "i"
) -> str:
    fact = d.of(angle.fact)
    return lines_of(
        f"sphere A: mass {m1}, velocity {speed} at alpha from {line}",
        f"sphere B: mass {m2}, at rest",
        f"given {fact}",
        f"A hits B: along {line}, e = {ratio(e)}",
        *asked,
    )


def _simple_struck(d: Dice, angle: Acute, scale: int = 1) -> tuple[str, str, Fraction]:
    """Masses and a coefficient with which both components after are simple."""
    c = pair(d, at_rest=True)
    for _ in range(40):
        c = pair(d, at_rest=True)
        speed = Fraction(angle.along * scale)
        total = c.m1 + c.m2
        after = ((c.m1 - c.e * c.m2) * speed / total, (1 + c.e) * c.m1 * speed / total)
        if after[0] and all(component.denominator <= 5 for component in after):
            break
    return number(c.m1), number(c.m2), c.e


def _at_rest_2(d: Dice) -> str:
    angle = acute(d, 13)
    scale = d.between(1, 3 if angle.hypotenuse == 5 else 1)
    m1, m2, e = _simple_struck(d, angle, scale)
    speed = f"{angle.hypotenuse * scale}"
    return _struck(
        d,
        m1,
        m2,
        speed,
        e,
        angle,
        "part a",
        "find speed(A), speed(B)",
        "part b",
        d.of(("find deflection(A)", "find impulse", "find angle(velocity(A), line_of_centres)")),
    )


def _at_rest_3(d: Dice) -> str:
    asked = d.of(("find energy_lost", "find impulse", "find deflection(A)"))
    return _slanting(d, slanted(d, at_rest=True), asked)


def _slanting(d: Dice, c: Slanted, asked: str) -> str:
    """Velocities by components, the line of centres along a vector, and what is asked besides."""
    second = f"velocity {vector(*c.u2)}" if any(c.u2) else "at rest"
    return lines_of(
        f"sphere A: mass {number(c.m1)}, velocity {vector(*c.u1)}",
        f"sphere B: mass {number(c.m2)}, {second}",
        f"A hits B: along {vector(*c.line)}, e = {ratio(c.e)}",
        "part a",
        "find velocity(A), velocity(B)",
        "part b",
        asked,
    )


def _at_rest_3_in_letters(d: Dice) -> str:
    angle = acute(d, 5)
    m1, m2, e = _simple_struck(d, angle)
    one, other = (
        times(Fraction(mass) * (1 if "." not in m1 + m2 else 10), "m") for mass in (m1, m2)
    )
    return _struck(
        d,
        one,
        other,
        "u",
        e,
        angle,
        "part a",
        "find speed(A), speed(B)",
        "part b",
        d.of(
            (
                "find deflection(A), energy_lost",
                "find energy_lost/energy(0)",
                "find impulse, deflection(A)",
            )
        ),
    )


def _at_rest_4(d: Dice) -> str:
    angle = acute(d, 5)
    m1, m2, e = d.of(
        [
            (a, b, e)
            for a in range(1, 6)
            for b in range(1, 6)
            for e in COEFFICIENTS
            if a != b and ((1 - e * e) * Fraction(b, a + b) * angle.along**2 / 25).denominator <= 60
        ]
    )
    share = (1 - e * e) * Fraction(m2, m1 + m2) * Fraction(angle.along, angle.hypotenuse) ** 2
    return lines_of(
        f"sphere A: mass {times(m1, 'm')}, velocity u at alpha",
        f"sphere B: mass {times(m2, 'm')}, at rest",
        f"given {angle.fact[0]}",
        "A hits B: along i",
        f"given energy_lost = {share} energy(0)",
        "part a",
        "find e",
        "part b",
        d.of(("find speed(A), speed(B)", "find speed(B), deflection(A)")),
        "part c",
        "find impulse",
    )


# --- both moving, by speeds and angles ----------------------------------------------------------


def _moving(d: Dice, *asked: str, direct: bool = False, letters: bool = False) -> str:
    """Two speeds, at angles to the line of centres, towards each other or one after the other."""
    one = acute(d, 13)
    other = Acute(
        *d.of([triple for triple in TRIPLES[:4] if triple[0] * one.along != triple[1] * one.across])
    )
    scale, second = d.between(1, 2), d.between(1, 2)
    p1, p2 = Fraction(one.along * scale), -Fraction(other.along * second)
    if direct:
        p2 = -Fraction(d.between(1, 6))
    masses, e = _simple_moving(d, p1, p2)
    unit = "m" if letters else ""
    m1, m2 = (times(mass, unit) if unit else number(mass) for mass in masses)
    u = times(one.hypotenuse * scale, "u") if letters else f"{one.hypotenuse * scale}"
    w = times(other.hypotenuse * second, "u") if letters else f"{other.hypotenuse * second}"
    if direct:
        velocity = vector(p2, 0, "u" if letters else "")
    else:
        velocity = f"{w} at beta from -i"
    return lines_of(
        f"sphere A: mass {m1}, velocity {u} at alpha",
        f"sphere B: mass {m2}, velocity {velocity}",
        f"given {one.fact[0]}" + ("" if direct else f", tan(beta) = {other.across}/{other.along}"),
        f"A hits B: along i, e = {ratio(e)}",
        *asked,
    )


def _simple_moving(
    d: Dice, p1: Fraction, p2: Fraction
) -> tuple[tuple[Fraction, Fraction], Fraction]:
    """Masses and a coefficient with which the components after are simple and unlike."""
    options = []
    for m1 in range(1, 6):
        for m2 in range(1, 6):
            for e in COEFFICIENTS:
                total, gap = m1 + m2, e * (p1 - p2)
                q1 = (m1 * p1 + m2 * p2 - m2 * gap) / total
                q2 = q1 + gap
                simple = q1.denominator <= 4 and q2.denominator <= 4
                if m1 != m2 and simple and q1 and q2 and abs(q1) != abs(q2):
                    options.append(((Fraction(m1), Fraction(m2)), e))
    return d.of(options or [((Fraction(2), Fraction(3)), Fraction(1, 2))])


def _moving_4(d: Dice) -> str:
    """The coefficient from the speed of one sphere afterwards."""
    one = acute(d, 13)
    scale = d.between(1, 2)
    p1 = Fraction(one.along * scale)
    p2 = -Fraction(d.between(1, 6))
    (m1, m2), e = _simple_moving(d, p1, p2)
    q2 = (m1 * p1 + m2 * p2 + m1 * e * (p1 - p2)) / (m1 + m2)
    return lines_of(
        f"sphere A: mass {number(m1)}, velocity {one.hypotenuse * scale} at alpha",
        f"sphere B: mass {number(m2)}, velocity {vector(p2, 0)}",
        f"given {d.of(one.fact)}",
        "A hits B: along i",
        f"given velocity(B) = {vector(q2, 0)}" if q2 else "given B at rest",
        "part a",
        "find e",
        "part b",
        d.of(("find speed(A), deflection(A)", "find speed(A), impulse")),
        "part c",
        "find energy_lost",
    )


# --- vectors ------------------------------------------------------------------------------------


def _vectors_3(d: Dice) -> str:
    asked = d.of(("find energy_lost", "find impulse", "find deflection(A)"))
    return _slanting(d, slanted(d), asked)


def _vectors_4(d: Dice) -> str:
    c = pair(d, denominators=2)
    return _vectors(
        d,
        c,
        "given velocity(A) = AFTER_A",
        "part a",
        "find velocity(B), e",
        "part b",
        d.of(("find energy_lost", "find deflection(B)", "find impulse, energy_lost")),
        e="",
    )


def _vectors_4_mass(d: Dice) -> str:
    c = pair(d, denominators=2)
    turned = _turned(d)
    m1, _ = masses_of(c)
    return lines_of(
        f"sphere A: mass {m1}, velocity {_in_axes(c.p1, c.s1, turned)}",
        f"sphere B: mass M, velocity {_in_axes(c.p2, c.s2, turned)}",
        f"A hits B: along {_axis(turned)}, e = {ratio(c.e)}",
        f"given velocity(A) = {_in_axes(c.q1, c.s1, turned)}",
        "part a",
        "find velocity(B), M",
        "part b",
        d.of(("find impulse", "find energy_lost")),
    )


# --- letters ------------------------------------------------------------------------------------


def _letters_3(d: Dice) -> str:
    c = pair(d, both_across=False, reach=4)
    return _vectors(
        d,
        c,
        "part a",
        "find velocity(A), velocity(B)",
        "part b",
        f"given e = {ratio(c.e)}",
        d.of(("find energy_lost", "find impulse, deflection(A)")),
        letter="u",
        e="",
    )


def _letters_4(d: Dice) -> str:
    """Which mass the second sphere has."""
    c = pair(d, at_rest=True, denominators=4)
    k = c.m2 / c.m1
    turned = _turned(d)
    speed = (1 + c.e) * c.p1 / (1 + k)
    return lines_of(
        f"sphere A: mass m, velocity {_in_axes(c.p1, c.s1, turned, 'u')}",
        "sphere B: mass k m, at rest",
        f"A hits B: along {_axis(turned)}, e = {ratio(c.e)}",
        "part a",
        "find velocity(A), velocity(B)",
        "part b",
        f"given speed(B) = {times(speed, 'u')}",
        d.of(("find k, energy_lost/energy(0)", "find k, impulse, speed(A)")),
    )


_BOTH = "find velocity(A), velocity(B)"

RECIPES: Mapping[tuple[str, int], tuple[Recipe, ...]] = {
    ("sphere-at-rest", 1): (
        lambda d: _vectors(d, pair(d, at_rest=True), _BOTH),
        lambda d: _vectors(
            d, pair(d, at_rest=True), "part a", _BOTH, "part b", "find speed(A), deflection(A)"
        ),
    ),
    ("sphere-at-rest", 2): (_at_rest_2,),
    ("sphere-at-rest", 3): (_at_rest_3, _at_rest_3_in_letters),
    ("sphere-at-rest", 4): (_at_rest_4,),
    ("spheres-moving", 1): (
        lambda d: _moving(d, "part a", "find speed(A)", "part b", "find speed(B)", direct=True),
        lambda d: _moving(d, "find speed(A), speed(B)", direct=True),
    ),
    ("spheres-moving", 2): (
        lambda d: _moving(d, "find speed(A), speed(B)"),
        lambda d: _moving(d, "part a", "find speed(A), speed(B)", "part b", "find impulse"),
    ),
    ("spheres-moving", 3): (
        lambda d: _moving(
            d, "part a", "find speed(A), speed(B)", "part b", "find deflection(A), energy_lost"
        ),
        lambda d: _moving(
            d,
            "part a",
            "find speed(A), speed(B)",
            "part b",
            "find impulse, energy_lost",
            letters=True,
        ),
    ),
    ("spheres-moving", 4): (_moving_4,),
    ("spheres-vectors", 1): (
        lambda d: _vectors(d, pair(d, denominators=3), _BOTH),
        lambda d: _vectors(d, pair(d, denominators=3), "part a", _BOTH, "part b", "find speed(B)"),
    ),
    ("spheres-vectors", 2): (
        lambda d: _vectors(
            d, pair(d, denominators=5), "part a", _BOTH, "part b", "find impulse, energy_lost"
        ),
        lambda d: _vectors(
            d, pair(d, denominators=5), "part a", _BOTH, "part b", "find deflection(A)"
        ),
    ),
    ("spheres-vectors", 3): (_vectors_3,),
    ("spheres-vectors", 4): (_vectors_4, _vectors_4_mass),
    ("spheres-letters", 1): (
        lambda d: _vectors(d, pair(d, both_across=False), _BOTH, letter="u"),
        lambda d: _vectors(d, pair(d), _BOTH, letter="u"),
    ),
    ("spheres-letters", 2): (
        lambda d: _vectors(
            d, pair(d), "part a", _BOTH, "part b", "find impulse, energy_lost", letter="u"
        ),
        lambda d: _vectors(
            d,
            pair(d, both_across=False),
            "part a",
            _BOTH,
            "part b",
            "find energy_lost/energy(0), deflection(A)",
            letter="u",
        ),
    ),
    ("spheres-letters", 3): (_letters_3,),
    ("spheres-letters", 4): (_letters_4,),
}
