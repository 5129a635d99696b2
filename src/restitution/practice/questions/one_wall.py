"""Questions on one impact with a wall, by topic and level."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isqrt

from restitution.practice.questions.dice import Dice, Recipe
from restitution.practice.questions.nice import (
    COEFFICIENTS,
    LINES,
    Acute,
    acute,
    coefficient,
    lines_of,
    mass,
    number,
    ratio,
    sphere,
    times,
    vector,
)

# Components along the wall and into it, and away from it afterwards: both speeds are whole.
_WHOLE_SPEEDS = (
    (15, 20, 8),
    (8, 15, 6),
    (40, 30, 9),
    (16, 30, 12),
    (24, 45, 18),
    (12, 9, 5),
    (24, 18, 10),
    (20, 21, 15),
    (21, 28, 20),
    (15, 36, 20),
)


def _sphere(d: Dice) -> str:
    return d.of(("P", "P", "Q", "S", "A"))


def _whole_speeds(d: Dice) -> tuple[int, int, int, int, int]:
    """Components along the wall, into it and away from it; the speeds before and after."""
    along, into, away = d.of(_WHOLE_SPEEDS)
    return along, into, away, isqrt(along**2 + into**2), isqrt(along**2 + away**2)


def _components(d: Dice) -> tuple[int, int]:
    """Components along the wall and into it that differ."""
    while True:
        a, b = d.between(1, 9), d.between(2, 12)
        if a != b:
            return a, b


def _towards(d: Dice) -> tuple[str, str, int, int, int]:
    """A wall along i or j, a velocity towards it, and its components and the sign into it."""
    a, b = _components(d)
    a, into = a * d.sign(), d.sign()
    if d.below(2):
        return "i", vector(a, into * b), a, b, into
    return "j", vector(into * b, a), a, b, into


def _after(axis: str, a: int, rebound: Fraction, into: int) -> str:
    """The velocity after, from the component along the wall and the speed of rebound."""
    return vector(a, -into * rebound) if axis == "i" else vector(-into * rebound, a)


def _resolved(line: tuple[int, int], along: Fraction | int, across: Fraction | int) -> str:
    """A velocity by its components along a slanting line and across it, in units of its vector."""
    x, y = line
    return vector(along * x - across * y, along * y + across * x)


def _slanting_velocities(d: Dice) -> tuple[str, str, str]:
    """A slanting line, and a velocity before and after the impact with a wall along it."""
    line = d.of(LINES)
    along, into = d.between(1, 4), d.between(2, 6) * d.sign()
    e = coefficient(d, into)
    return vector(*line), _resolved(line, along, into), _resolved(line, along, -e * into)


def _impact(
    s: str,
    wall: str,
    motion: str,
    e: Fraction,
    asked: Sequence[str],
    *,
    facts: Sequence[str] = (),
    weight: str = "",
) -> str:
    """The statement of one impact of a sphere, with what is asked of ``P`` asked of it."""
    return lines_of(
        f"wall W: along {wall}",
        sphere(s, motion, weight),
        *facts,
        f"{s} hits W: e = {ratio(e)}",
        *(quantity.replace("(P", f"({s}") for quantity in asked),
    )


def _by_vectors(d: Dice, *asked: str, weight: str = "") -> str:
    """A velocity by components, a wall along an axis, and what is asked."""
    s = _sphere(d)
    axis, velocity, _, b, _ = _towards(d)
    return _impact(s, axis, f"velocity {velocity}", coefficient(d, b), asked, weight=weight)


def _speed_and_angle(d: Dice) -> tuple[str, list[str], Acute | None, int]:
    """A speed and an angle to the wall: the property, facts, the angle, and the speed."""
    if d.below(4):
        angle = acute(d, 17)
        speed = angle.hypotenuse * d.between(1, 3 if angle.hypotenuse < 13 else 1)
        fact = d.of(angle.fact)
        return f"velocity {speed} at alpha to W", [f"given {fact}"], angle, speed
    speed = 2 * d.between(2, 9)
    return f"velocity {speed} at {d.of((30, 60))}° to W", [], None, speed


def _by_angle(d: Dice, *asked: str, weight: str = "") -> str:
    """A speed at an angle to the wall, and what is asked."""
    s = _sphere(d)
    velocity, facts, angle, speed = _speed_and_angle(d)
    into = speed * angle.across // angle.hypotenuse if angle else speed // 2
    return _impact(s, "i", velocity, coefficient(d, into), asked, facts=facts, weight=weight)


def _slanting(d: Dice, *asked: str, weight: str = "") -> str:
    """A wall that is not along i or j, a velocity by components, and what is asked."""
    s = _sphere(d)
    line = d.of(LINES)
    along, into = d.between(1, 3), d.between(1, 3) * d.sign()
    motion = f"velocity {_resolved(line, along, into)}"
    return _impact(s, vector(*line), motion, coefficient(d, into), asked, weight=weight)


def _in_letters(d: Dice, *asked: str, weight: str = "") -> str:
    """A speed u at an angle with a given tangent, and what is asked."""
    s = _sphere(d)
    angle = acute(d, 13)
    facts = [f"given {d.of(angle.fact)}"]
    e = coefficient(d, angle.tangent)
    return _impact(s, "i", "velocity u at alpha to W", e, asked, facts=facts, weight=weight)


# --- forward ------------------------------------------------------------------------------------


def _forward_4(d: Dice) -> str:
    s = _sphere(d)
    angle = acute(d, 13)
    e = coefficient(d, angle.tangent)
    return lines_of(
        "wall W: along i",
        f"sphere {s}: velocity u at alpha to W",
        f"{s} hits W",
        "part a",
        f"show speed({s})^2 = u^2 (cos^2(alpha) + e^2 sin^2(alpha))",
        "part b",
        f"given {angle.fact[0]}, e = {ratio(e)}",
        f"find speed({s}), angle(velocity({s}), W)",
    )


def _before(d: Dice) -> str:
    s = _sphere(d)
    axis, _, a, b, into = _towards(d)
    e = coefficient(d, b)
    return lines_of(
        f"wall W: along {axis}",
        f"sphere {s}: velocity p i + q j",
        f"{s} hits W: e = {ratio(e)}",
        f"given velocity({s}) = {_after(axis, a, e * b, into)}",
        "part a",
        f"find velocity({s}, 0)",
        "part b",
        f"find deflection({s})",
    )


# --- the coefficient ----------------------------------------------------------------------------


def _coefficient_1(d: Dice) -> str:
    s = _sphere(d)
    axis, velocity, a, b, into = _towards(d)
    e = coefficient(d, b)
    second = d.of((f"find deflection({s})", f"find speed({s}, 0), speed({s})", ""))
    return lines_of(
        f"wall W: along {axis}",
        f"sphere {s}: velocity {velocity}",
        f"{s} hits W",
        f"given velocity({s}) = {_after(axis, a, e * b, into)}",
        "part a" if second else "",
        "find e",
        "part b" if second else "",
        second,
    )


def _coefficient_2(d: Dice) -> str:
    s = _sphere(d)
    a, b, _, u, v = _whole_speeds(d)
    return lines_of(
        "wall W: along i",
        f"sphere {s}: velocity {u} at alpha to W",
        f"given {d.of((f'tan(alpha) = {Fraction(b, a)}', f'sin(alpha) = {Fraction(b, u)}'))}",
        f"{s} hits W",
        f"given speed({s}) = {v}",
        "part a",
        "find e",
        "part b",
        d.of((f"find angle(velocity({s}), W)", f"find deflection({s})")),
    )


def _coefficient_2_by_angles(d: Dice) -> str:
    s = _sphere(d)
    angle = acute(d, 17)
    e = coefficient(d, angle.tangent)
    return lines_of(
        "wall W: along i",
        f"sphere {s}: velocity {angle.hypotenuse} at alpha to W",
        f"given {angle.fact[0]}",
        f"{s} hits W",
        f"let beta = angle(velocity({s}), W)",
        f"given tan(beta) = {e * angle.tangent}",
        "part a",
        "find e",
        "part b",
        f"find speed({s})",
    )


def _coefficient_3(d: Dice) -> str:
    s = _sphere(d)
    line, before, after = _slanting_velocities(d)
    return lines_of(
        f"wall W: along {line}",
        f"sphere {s}: velocity {before}",
        f"{s} hits W",
        f"given velocity({s}) = {after}",
        "part a",
        "find e",
        "part b",
        f"find deflection({s})",
    )


def _coefficient_4(d: Dice) -> str:
    s = _sphere(d)
    _, before, after = _slanting_velocities(d)
    return lines_of(
        "wall W",
        f"sphere {s}: mass {mass(d)}, velocity {before}",
        f"{s} hits W",
        f"given velocity({s}) = {after}",
        "part a",
        f"find impulse({s})",
        "part b",
        "find direction(W), e",
    )


def _coefficient_4_in_letters(d: Dice) -> str:
    s = _sphere(d)
    a, b, _, u, v = _whole_speeds(d)
    return lines_of(
        "wall W: along i",
        f"sphere {s}: mass m, velocity u at alpha to W",
        f"given tan(alpha) = {Fraction(b, a)}",
        f"{s} hits W",
        f"given speed({s}) = {times(Fraction(v, u), 'u')}",
        "part a",
        "find e",
        "part b",
        f"find deflection({s}), impulse",
    )


# --- angles -------------------------------------------------------------------------------------


def _angle_2(d: Dice) -> str:
    s = _sphere(d)
    _, b, c, u, v = _whole_speeds(d)
    return lines_of(
        "wall W: along i",
        f"sphere {s}: velocity {u} at alpha to W",
        f"{s} hits W: e = {Fraction(c, b)}",
        f"given speed({s}) = {v}",
        "part a",
        "find alpha",
        "part b",
        f"find angle(velocity({s}), W)",
    )


def _angle_3(d: Dice) -> str:
    s = _sphere(d)
    angle = acute(d, 17)
    e = coefficient(d, angle.tangent)
    speed = d.between(3, 12)
    return lines_of(
        "wall W: along i",
        f"sphere {s}: velocity {speed} at alpha to W",
        f"{s} hits W: e = {ratio(e)}",
        f"let beta = angle(velocity({s}), W)",
        f"given tan(beta) = {e * angle.tangent}",
        "part a",
        "find alpha",
        "part b",
        d.of((f"find speed({s})", f"find speed({s}), deflection({s})")),
    )


def _angle_4(d: Dice) -> str:
    s = _sphere(d)
    e = d.of(("1/4", "1/3", "4/9", "9/16", "1/2", "2/3", "3/4", "16/25"))
    asked = d.of((f"find speed({s})", f"find speed({s}), impulse", f"find energy_lost, speed({s})"))
    return lines_of(
        "wall W: along i",
        f"sphere {s}: mass {d.of(('m', '2m', '3m'))}, velocity u at alpha to W",
        f"{s} hits W: e = {e}",
        f"given deflection({s}) = 90°",
        "part a",
        "find alpha",
        "part b",
        asked,
    )


# --- deflection ---------------------------------------------------------------------------------


def _deflection_3(d: Dice) -> str:
    s = _sphere(d)
    angle = d.of([Acute(4, 3, 5), Acute(12, 5, 13), Acute(15, 8, 17)])
    speed = angle.hypotenuse * d.between(1, 2)
    return lines_of(
        "wall W: along i",
        f"sphere {s}: mass {mass(d)}, velocity {speed} at alpha to W",
        f"given {d.of(angle.fact)}",
        f"{s} hits W",
        f"given deflection({s}) = 90°",
        "part a",
        "find e",
        "part b",
        d.of((f"find speed({s})", "find impulse", "find energy_lost")),
    )


def _deflection_3_at_60(d: Dice) -> str:
    s = _sphere(d)
    before, e = d.of(((60, "1/3"), (60, "1/2"), (45, "1/2"), (45, "1/3"), (30, "1/2"), (60, "3/4")))
    return lines_of(
        "wall W: along i",
        f"sphere {s}: velocity u at {before}° to W",
        f"{s} hits W: e = {e}",
        "part a",
        f"find speed({s})",
        "part b",
        f"find deflection({s})",
    )


def _deflection_4(d: Dice) -> str:
    s = _sphere(d)
    angle = acute(d, 13)
    e = coefficient(d, angle.tangent)
    return lines_of(
        "wall W: along i",
        f"sphere {s}: velocity u at alpha to W",
        f"{s} hits W",
        "part a",
        f"show tan(deflection({s})) = (1 + e) tan(alpha)/(1 - e tan^2(alpha))",
        "part b",
        f"given {angle.fact[0]}, e = {ratio(e)}",
        f"find deflection({s}), speed({s})",
    )


# --- impulse ------------------------------------------------------------------------------------


def _impulse_3(d: Dice) -> str:
    s = _sphere(d)
    axis, velocity, _, b, _ = _towards(d)
    e = coefficient(d, b)
    weight = d.of(("2", "3", "4", "0.5", "0.4"))
    return lines_of(
        f"wall W: along {axis}",
        f"sphere {s}: mass {weight}, velocity {velocity}",
        f"{s} hits W",
        f"given impulse = {number(Fraction(weight) * (1 + e) * b)}",
        "part a",
        "find e",
        "part b",
        d.of((f"find velocity({s}), deflection({s})", f"find velocity({s}), energy_lost")),
    )


def _impulse_4(d: Dice) -> str:
    s = _sphere(d)
    angle = acute(d, 13)
    e = coefficient(d, angle.tangent)
    weight = d.of(("m", "2m", "3m"))
    size = (1 + e) * Fraction(angle.across, angle.hypotenuse) * (int(weight[:-1] or 1))
    return lines_of(
        "wall W: along i",
        f"sphere {s}: mass {weight}, velocity u at alpha to W",
        f"given {d.of(angle.fact)}",
        f"{s} hits W",
        f"given impulse = {times(size, 'm u')}",
        "part a",
        "find e",
        "part b",
        d.of((f"find speed({s}), deflection({s})", f"find energy_lost, angle(velocity({s}), W)")),
    )


# --- energy -------------------------------------------------------------------------------------


def _energy_3(d: Dice) -> str:
    s = _sphere(d)
    axis, velocity, _, b, _ = _towards(d)
    e = coefficient(d, b)
    weight = d.of(("2", "4", "6", "1", "0.5"))
    lost = Fraction(weight) / 2 * b * b * (1 - e * e)
    return lines_of(
        f"wall W: along {axis}",
        f"sphere {s}: mass {weight}, velocity {velocity}",
        f"{s} hits W",
        f"given energy_lost = {number(lost)}",
        "part a",
        "find e",
        "part b",
        d.of((f"find velocity({s})", f"find speed({s}), deflection({s})", "find impulse")),
    )


def _energy_4(d: Dice) -> str:
    s = _sphere(d)
    square = d.of(tuple(map(Fraction, ("9/25", "16/25", "1/4", "1/2", "3/4"))))  # of the sine
    e = d.of(COEFFICIENTS)
    weight, speed = d.of((("m", "u"), ("2m", "u"), ("3m", "u"), (mass(d), f"{d.between(4, 15)}")))
    return lines_of(
        "wall W: along i",
        f"sphere {s}: mass {weight}, velocity {speed} at alpha to W",
        f"{s} hits W: e = {ratio(e)}",
        f"given energy_lost = {(1 - e * e) * square} energy(0)",
        "part a",
        "find alpha",
        "part b",
        d.of((f"find speed({s}), impulse", f"find deflection({s}), impulse")),
    )


_SPLIT = ("part a", "find velocity(P)", "part b")
_ASIDE = ("part a", "find speed(P)", "part b")

RECIPES: Mapping[tuple[str, int], tuple[Recipe, ...]] = {
    ("wall-forward", 1): (
        lambda d: _by_vectors(d, "find velocity(P), speed(P)"),
        lambda d: _by_vectors(d, *_SPLIT, "find angle(velocity(P), W)"),
    ),
    ("wall-forward", 2): (
        lambda d: _by_angle(d, "find speed(P), angle(velocity(P), W)"),
        lambda d: _by_angle(d, *_ASIDE, "find angle(velocity(P), W)"),
    ),
    ("wall-forward", 3): (
        lambda d: _slanting(d, *_SPLIT, "find speed(P)"),
        lambda d: _in_letters(d, *_ASIDE, "find angle(velocity(P), W)"),
    ),
    ("wall-forward", 4): (_forward_4, _before),
    ("wall-coefficient", 1): (_coefficient_1,),
    ("wall-coefficient", 2): (_coefficient_2, _coefficient_2_by_angles),
    ("wall-coefficient", 3): (_coefficient_3, _deflection_3),
    ("wall-coefficient", 4): (_coefficient_4, _coefficient_4_in_letters),
    ("wall-angle", 1): (
        lambda d: _by_vectors(d, "find angle(velocity(P, 0), W), angle(velocity(P), W)"),
        lambda d: _by_angle(d, "find angle(velocity(P), W)"),
    ),
    ("wall-angle", 2): (_angle_2,),
    ("wall-angle", 3): (_angle_3,),
    ("wall-angle", 4): (_angle_4,),
    ("wall-deflection", 1): (
        lambda d: _by_vectors(d, *_SPLIT, "find deflection(P)"),
        lambda d: _by_vectors(d, "find deflection(P)"),
    ),
    ("wall-deflection", 2): (
        lambda d: _by_angle(d, "find deflection(P)"),
        lambda d: _by_angle(d, *_ASIDE, "find deflection(P)"),
    ),
    ("wall-deflection", 3): (
        _deflection_3,
        _deflection_3_at_60,
        lambda d: _slanting(d, *_SPLIT, "find deflection(P)"),
    ),
    ("wall-deflection", 4): (_deflection_4,),
    ("wall-impulse", 1): (
        lambda d: _by_vectors(d, *_SPLIT, "find impulse", weight=mass(d)),
        lambda d: _by_vectors(d, "find impulse", weight=mass(d)),
    ),
    ("wall-impulse", 2): (
        lambda d: _by_angle(d, "find impulse, speed(P)", weight=mass(d)),
        lambda d: _slanting(d, *_SPLIT, "find impulse(P)", weight=mass(d)),
    ),
    ("wall-impulse", 3): (
        _impulse_3,
        lambda d: _in_letters(d, "part a", "find impulse", "part b", "find speed(P)", weight="m"),
    ),
    ("wall-impulse", 4): (_impulse_4,),
    ("wall-energy", 1): (
        lambda d: _by_vectors(d, *_SPLIT, "find energy_lost", weight=mass(d)),
        lambda d: _by_vectors(d, "find energy_lost", weight=mass(d)),
    ),
    ("wall-energy", 2): (
        lambda d: _by_angle(d, *_ASIDE, "find energy_lost", weight=mass(d)),
        lambda d: _by_angle(d, "find energy_lost/energy(0) as a percentage", weight=mass(d)),
    ),
    ("wall-energy", 3): (
        _energy_3,
        lambda d: _in_letters(
            d, *_ASIDE, "find energy_lost, energy_lost/energy(0)", weight=d.of(("m", "2m"))
        ),
    ),
    ("wall-energy", 4): (_energy_4,),
}
