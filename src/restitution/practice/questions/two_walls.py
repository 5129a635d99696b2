"""Questions on impacts one after the other: with two walls, with a wall and a sphere."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import isqrt

from restitution.practice.questions.dice import Dice, Recipe
from restitution.practice.questions.nice import (
    COEFFICIENTS,
    Pair,
    acute,
    coefficient,
    lines_of,
    mass,
    masses_of,
    pair,
    ratio,
    sphere,
    times,
    unlike_numbers,
    vector,
)


def _unlike(d: Dice) -> tuple[Fraction, Fraction]:
    """Two coefficients that differ."""
    one = d.of(COEFFICIENTS)
    return one, d.of([number for number in COEFFICIENTS if number != one])


def _simple(d: Dice) -> tuple[Fraction, Fraction]:
    """Two coefficients that differ, of small denominators."""
    one, other = d.shuffled([e for e in COEFFICIENTS if e.denominator <= 4])[:2]
    return one, other


# --- at right angles ----------------------------------------------------------------------------

_SQUARE = ("wall OX: along i", "wall OY: along j")


def _square_1(d: Dice) -> str:
    a, b = unlike_numbers(d, range(2, 13), range(2, 13))
    e = coefficient(d, a, b)
    return lines_of(
        *_SQUARE,
        f"sphere P: velocity {vector(-a, -b)}",
        f"P hits OX: e = {ratio(e)}",
        "part a",
        "find velocity(P)",
        "part b",
        f"P hits OY: e = {ratio(e)}",
        "find velocity(P), speed(P)",
    )


def _square_2(d: Dice) -> str:
    angle = acute(d, 13)
    e, f = _unlike(d)
    speed = angle.hypotenuse * d.between(1, 2)
    asked = d.of(("find speed(P)", "find angle(velocity(P), OX)"))
    return lines_of(
        *_SQUARE,
        f"sphere P: velocity {speed} at alpha from -i",
        f"given {d.of(angle.fact)}",
        f"P hits OX: e = {ratio(e)}",
        "part a",
        "find speed(P), angle(velocity(P), OX)",
        "part b",
        f"P hits OY: e = {ratio(f)}",
        asked,
    )


def _square_3(d: Dice) -> str:
    angle = acute(d, 5)
    e, f = _simple(d)
    return lines_of(
        *_SQUARE,
        f"sphere P: mass {d.of(('m', '2m'))}, velocity u at alpha from -i",
        f"given {d.of(angle.fact)}",
        f"P hits OX: e = {ratio(e)}",
        f"P hits OY: e = {ratio(f)}",
        "part a",
        "find speed(P, 1), speed(P)",
        "part b",
        d.of(("find total_energy_lost", "find total_energy_lost/energy(0)")),
        "part c",
        "find angle(velocity(P), OY)",
    )


def _square_3_with_numbers(d: Dice) -> str:
    a, b = unlike_numbers(d, range(2, 10), range(2, 10))
    e, f = _unlike(d)
    return lines_of(
        *_SQUARE,
        f"sphere P: mass {mass(d)}, velocity {vector(-a, -b)}",
        f"P hits OX: e = {ratio(e)}",
        f"P hits OY: e = {ratio(f)}",
        "part a",
        "find velocity(P)",
        "part b",
        "find total_energy_lost, angle(velocity(P), OX)",
    )


def _square_4(d: Dice) -> str:
    e, other = _unlike(d)
    angle = acute(d, 5)
    return lines_of(
        *_SQUARE,
        "sphere P: mass m, velocity u at alpha from -i",
        "P hits OX",
        "P hits OY",
        "given e > 0",
        "part a",
        "show velocity(P) opposite to velocity(P, 0)",
        "part b",
        f"given total_energy_lost = {1 - e * e} energy(0)",
        "find e, speed(P)",
        "part c",
        f"given {angle.fact[0]}, e = {ratio(other)}",
        "find impulse(2), speed(P, 1)",
    )


def _square_4_two(d: Dice) -> str:
    a, b = unlike_numbers(d, range(2, 10), range(2, 10))
    e, f = coefficient(d, b), coefficient(d, a)
    return lines_of(
        *_SQUARE,
        f"sphere P: mass {mass(d)}, velocity {vector(-a, -b)}",
        "P hits OX: e = e1",
        "P hits OY: e = e2",
        f"given velocity(P) = {vector(f * a, e * b)}",
        "part a",
        "find e1, e2",
        "part b",
        "find total_energy_lost, deflection(P, 2)",
    )


# --- at 60° and 120° ----------------------------------------------------------------------------

_SECOND = {60: 120, 120: 60}  # the direction of BC, from that of AB, by the angle between them


def _corner(
    d: Dice,
    angle: int,
    speed: str,
    coefficients: tuple[Fraction, Fraction],
    asked: tuple[str, str],
    weight: str = "",
) -> str:
    """An impact with AB, then one with BC, and what is asked after each."""
    e, f = coefficients
    start = d.of((30, 60))
    return lines_of(
        "wall AB: along i",
        f"wall BC: along {_SECOND[angle]}°",
        sphere("P", f"velocity {speed} at {start}° to AB", weight),
        f"P hits AB: e = {ratio(e)}",
        "part a",
        asked[0],
        "part b",
        f"P hits BC: e = {ratio(f)}",
        asked[1],
    )


def _corner_1(angle: int) -> Recipe:
    def recipe(d: Dice) -> str:
        e = d.of(COEFFICIENTS)
        speed = f"{2 * d.between(2, 8)}"
        return _corner(d, angle, speed, (e, e), ("find speed(P)", "find speed(P)"))

    return recipe


def _corner_2(angle: int) -> Recipe:
    def recipe(d: Dice) -> str:
        coefficients = _unlike(d)
        speed = d.of(("u", f"{2 * d.between(2, 8)}"))
        asked = "find speed(P), angle(velocity(P), AB)", "find speed(P)"
        return _corner(d, angle, speed, coefficients, asked)

    return recipe


def _corner_3(angle: int) -> Recipe:
    def recipe(d: Dice) -> str:
        coefficients = _simple(d)
        weight = d.of(("m", "2m"))
        first = d.of(("find speed(P), impulse", "find speed(P), deflection(P)"))
        second = d.of(
            (
                "find angle(velocity(P, 1), BC), speed(P)",
                "find speed(P), total_energy_lost/energy(0)",
            )
        )
        return _corner(d, angle, "u", coefficients, (first, second), weight)

    return recipe


def _corner_4(angle: int) -> Recipe:
    def recipe(d: Dice) -> str:
        e, f = _simple(d)
        start = d.of((30, 60))
        square = Fraction(1, 4) + Fraction(3, 4) * e * e
        if start == 30:
            square = Fraction(3, 4) + e * e / 4
        return lines_of(
            "wall AB: along i",
            f"wall BC: along {_SECOND[angle]}°",
            f"sphere P: mass m, velocity u at {start}° to AB",
            "P hits AB",
            f"given speed(P) = {_root(square)} u",
            "part a",
            "find e",
            "part b",
            f"P hits BC: e = {ratio(f)}",
            d.of(("find speed(P), impulse", "find speed(P), deflection(P)")),
        )

    return recipe


def _root(square: Fraction) -> str:
    """The square root of a fraction as text."""
    over, under = isqrt(square.numerator), isqrt(square.denominator)
    if under * under != square.denominator:
        return f"sqrt({square})"
    if over * over == square.numerator:
        return f"{Fraction(over, under)}"
    return f"sqrt({square.numerator})/{under}"


# --- parallel -----------------------------------------------------------------------------------

_PARALLEL = ("wall L: along i", "wall M: along i")


def _parallel_1(d: Dice) -> str:
    a, b = unlike_numbers(d, range(1, 7), range(4, 13))
    e = coefficient(d, b, Fraction(b, 2))
    return lines_of(
        *_PARALLEL,
        f"sphere P: velocity {vector(a * d.sign(), -b)}",
        f"P hits L: e = {ratio(e)}",
        "part a",
        "find velocity(P)",
        "part b",
        f"P hits M: e = {ratio(e)}",
        "find velocity(P), speed(P)",
    )


def _parallel_2(d: Dice) -> str:
    angle = acute(d, 13)
    e, f = _unlike(d)
    speed = angle.hypotenuse * d.between(1, 2)
    return lines_of(
        *_PARALLEL,
        f"sphere P: velocity {speed} at alpha to L",
        f"given {d.of(angle.fact)}",
        f"P hits L: e = {ratio(e)}",
        "part a",
        "find speed(P)",
        "part b",
        f"P hits M: e = {ratio(f)}",
        "find speed(P), angle(velocity(P), M)",
    )


def _parallel_3(d: Dice) -> str:
    angle = acute(d, 5)
    e, f = _simple(d)
    weight = d.of(("m", "2m"))
    asked = d.of(("find impulse(1), impulse(2)", "find total_energy_lost"))
    return lines_of(
        *_PARALLEL,
        f"sphere P: mass {weight}, velocity u at alpha to L",
        f"given {d.of(angle.fact)}",
        f"P hits L: e = {ratio(e)}",
        f"P hits M: e = {ratio(f)}",
        "part a",
        "find speed(P, 1), speed(P)",
        "part b",
        asked,
    )


def _parallel_3_in_time(d: Dice) -> str:
    a, b = unlike_numbers(d, range(1, 6), range(2, 9))
    e = coefficient(d, b)
    width = b + d.between(1, 4)
    return lines_of(
        "wall L: along i, through (0, 0)",
        f"wall M: along i, through (0, {width})",
        f"sphere P: at (0, {b}), velocity {vector(a, -b)}",
        f"P hits L: e = {ratio(e)}",
        "part a",
        "find velocity(P), position(P)",
        "part b",
        f"P hits M: e = {ratio(e)}",
        "find velocity(P), time(2), position(P, 2)",
    )


def _parallel_4(d: Dice) -> str:
    angle = acute(d, 5)
    e = d.of([e for e in COEFFICIENTS if e.numerator == 1 or e.denominator == 3])
    return lines_of(
        *_PARALLEL,
        "sphere P: velocity u at alpha to L",
        "P hits L",
        "P hits M",
        "part a",
        "show tan(angle(velocity(P), M)) = e^2 tan(alpha)",
        "part b",
        f"given {angle.fact[0]}, tan(angle(velocity(P), M)) = {e * e * angle.tangent}",
        "find e, speed(P, 1), speed(P)",
    )


# --- a wall and a sphere ------------------------------------------------------------------------


def _cushion(d: Dice) -> tuple[Pair, Fraction, Fraction, Fraction]:
    """A collision after a wall parallel to its line: the across component before the wall too."""
    while True:
        c = pair(d, at_rest=True, denominators=4)
        e = d.of(COEFFICIENTS)
        into = abs(c.s1) / e
        if into.denominator == 1 and into <= 12 and into != c.p1:
            return c, e, into, abs(c.s1)


def _cushion_1(d: Dice) -> str:
    c, e, into, _ = _cushion(d)
    m1, m2 = masses_of(c)
    return lines_of(
        "wall W: along i",
        f"sphere A: mass {m1}, velocity {vector(c.p1, -into)}",
        f"sphere B: mass {m2}, at rest",
        f"A hits W: e = {ratio(e)}",
        "part a",
        "find velocity(A)",
        "part b",
        f"A hits B: along i, e = {ratio(c.e)}",
        "find velocity(A), velocity(B)",
    )


def _cushion_2(d: Dice) -> str:
    c, e, into, _ = _cushion(d)
    m1, m2 = masses_of(c)
    return lines_of(
        "wall W: along i",
        f"sphere A: mass {m1}, velocity {vector(c.p1, -into)}",
        f"sphere B: mass {m2}, at rest",
        f"A hits W: e = {ratio(e)}",
        "part a",
        "find speed(A), impulse",
        "part b",
        f"A hits B: along i, e = {ratio(c.e)}",
        "find speed(A), speed(B)",
        "part c",
        d.of(("find total_energy_lost", "find deflection(A)")),
    )


def _then_wall(d: Dice) -> str:
    """The collision first, then B, or A, against a wall."""
    c = pair(d, denominators=3)
    while c.q2 <= 0:
        c = pair(d, denominators=3)
    m1, m2 = masses_of(c)
    f = d.of([number for number in COEFFICIENTS if number != c.e])
    return lines_of(
        f"sphere A: mass {m1}, velocity {vector(c.p1, c.s1)}",
        f"sphere B: mass {m2}, velocity {vector(c.p2, c.s2)}",
        "wall W: along j",
        f"A hits B: along i, e = {ratio(c.e)}",
        "part a",
        "find velocity(A), velocity(B)",
        "part b",
        f"B hits W: e = {ratio(f)}",
        "find velocity(B), deflection(B)",
        "part c",
        "find total_energy_lost",
    )


def _then_wall_4(d: Dice) -> str:
    c = pair(d, at_rest=True, denominators=3)
    f = d.of([number for number in COEFFICIENTS if number != c.e])
    scale = 1 if c.m1.denominator == c.m2.denominator == 1 else 10
    m1, m2 = times(c.m1 * scale, "m"), times(c.m2 * scale, "m")
    return lines_of(
        f"sphere A: mass {m1}, velocity {vector(c.p1, c.s1, 'u')}",
        f"sphere B: mass {m2}, at rest",
        "wall W: along j",
        f"A hits B: along i, e = {ratio(c.e)}",
        "part a",
        "find velocity(A), velocity(B)",
        "part b",
        "B hits W: e = f",
        f"given impulse(2) = {times(c.m2 * scale * (1 + f) * c.q2, 'm u')}",
        "find f, velocity(B), deflection(B)",
    )


RECIPES: Mapping[tuple[str, int], tuple[Recipe, ...]] = {
    ("walls-at-90", 1): (_square_1,),
    ("walls-at-90", 2): (_square_2,),
    ("walls-at-90", 3): (_square_3, _square_3_with_numbers),
    ("walls-at-90", 4): (_square_4, _square_4_two),
    **{
        (f"walls-at-{angle}", level): (recipe(angle),)
        for angle in (60, 120)
        for level, recipe in enumerate((_corner_1, _corner_2, _corner_3, _corner_4), 1)
    },
    ("walls-parallel", 1): (_parallel_1,),
    ("walls-parallel", 2): (_parallel_2,),
    ("walls-parallel", 3): (_parallel_3, _parallel_3_in_time),
    ("walls-parallel", 4): (_parallel_4,),
    ("wall-then-sphere", 1): (_cushion_1,),
    ("wall-then-sphere", 2): (_cushion_2,),
    ("wall-then-sphere", 3): (_then_wall,),
    ("wall-then-sphere", 4): (_then_wall_4,),
}
