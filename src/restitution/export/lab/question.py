"""The statement of a question about one impact of the Lab.

An impact, ``line`` leading from the first body into the second::

    {"spheres": [{"name", "mass", "velocity"}], "wall": name or null, "line", "e"}
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from restitution import law
from restitution.errors import ImpossibleError, StatementError
from restitution.export.lab.reading import a_list, a_name, a_number, a_pair, an_object
from restitution.language import parse, to_statement
from restitution.records import dataclass
from restitution.vector import Vector

_LEAST_MASS = 1e-6

# Directions that people like to reckon with: whole numbers, no larger than this.
_WHOLE = 12
# Within so many radians of one of them a line of centres is taken to be along it, the tidier the
# better, while by its answers the impact is still recognized: velocities differ by no more than
# this share of the greatest.
_NEAR = (math.radians(1.5), math.radians(0.5), 0.0)
_ALIKE = 0.01
# Places after the point, at most: what is smaller is nothing.
_PLACES = 12


@dataclass(frozen=True)
class _Hit:
    """One impact in rounded, exact numbers; for a wall the second sphere is missing."""

    names: tuple[str, ...]
    masses: tuple[Fraction, ...]
    velocities: tuple[Vector, ...]
    wall: str | None
    line: Vector
    e: Fraction


def question(data: object) -> str:
    """The statement of a question about one impact, its numbers rounded to be reckoned with.

    Raises StatementError where ``told`` is no impact, and ImpossibleError where its bodies do not
    approach one another.
    """
    impact = an_object(data, "an impact")
    true = _rounded(impact, _PLACES, None)
    for figures, near in (*((3, number) for number in _NEAR), (3, None), (6, None), (12, None)):
        hit = _rounded(impact, figures, near)
        if _approach(hit) > 0 and _alike(hit, true):
            return to_statement(parse("\n".join(_lines(hit))))
    raise ImpossibleError("the bodies of this impact hardly approach one another")


def _alike(hit: _Hit, true: _Hit) -> bool:
    """Whether the velocities after both impacts are the same, but for what rounding does."""
    after = dict(zip(true.names, _after(true)))
    fastest = max(math.hypot(*velocity) for velocity in true.velocities)
    return all(
        math.hypot(*(velocity - after[name])) <= _ALIKE * fastest
        for name, velocity in zip(hit.names, _after(hit))
    )


def _rounded(impact: Mapping[str, Any], figures: int, near: float | None) -> _Hit:
    """An impact rounded to so many figures, its line of centres to a tidy one ``near`` to it."""
    spheres = [
        an_object(sphere, "a sphere") for sphere in a_list(impact.get("spheres"), "spheres", 2)
    ]
    wall = impact.get("wall")
    if wall is not None:
        wall = a_name({"name": wall}, "a wall")
    names = tuple(a_name(sphere, "a sphere") for sphere in spheres)
    if len(names) != (1 if wall else 2) or len({*names, wall}) < 2:
        raise StatementError("an impact is that of two spheres, or of one and a wall")
    masses = [a_number(s.get("mass"), f"the mass of {n}") for n, s in zip(names, spheres)]
    for name, mass in zip(names, masses):
        if mass < _LEAST_MASS:
            raise ImpossibleError(f"the mass of {name} is {mass:g}: a mass is positive")
    pairs = [a_pair(s.get("velocity"), f"the velocity of {n}") for n, s in zip(names, spheres)]
    # What is rounded is rounded by the fastest: to the last digit that counts beside it.
    largest = max(abs(x) for pair in pairs for x in pair)
    velocities = [Vector(*(_near(x, largest, figures) for x in pair)) for pair in pairs]
    x, y = a_pair(impact.get("line"), "the line of centres")
    if x == y == 0:
        raise StatementError("the line of centres has a direction")
    e = a_number(impact.get("e"), "e")
    if not 0 <= e <= 1:
        raise ImpossibleError(f"e is {e:g}: a coefficient of restitution lies in [0, 1]")
    size = math.hypot(x, y)
    if near is None:
        line = Vector(*(_near(c / size, 1.0, figures) for c in (x, y)))
    else:
        line = _tidy(x, y, near)
    weighed = tuple(simple(mass) for mass in masses)
    if wall is None and velocities[0].dot(line) <= 0:
        # The second catches up with the first: it is the one that hits.
        names, weighed, velocities, line = names[::-1], weighed[::-1], velocities[::-1], -line
    return _Hit(names, weighed, tuple(velocities), wall, line, simple(e, 0.1))


def _near(x: float, largest: float, figures: int) -> Fraction:
    """A number, to as many figures as the largest beside it is given."""
    if largest == 0:
        return Fraction(0)
    digits = min(figures - 1 - math.floor(math.log10(largest)), _PLACES)
    return round(Fraction(x) * Fraction(10) ** digits) / Fraction(10) ** digits


def simple(x: float, least: float = 0.0) -> Fraction:
    """A number to 3 figures, or a fraction such as 2/3 that is meant by more.

    One that is less than ``least`` has as many places as that.
    """
    short = _near(x, max(abs(x), least), 3)
    if abs(float(short) - x) > 1e-9 * abs(x):
        fraction = Fraction(x).limit_denominator(12)
        if fraction and abs(float(fraction) - x) < 1e-6 * abs(x):
            return fraction
    return short


def _tidy(x: float, y: float, within: float) -> Vector:
    """A vector of small whole numbers nearly along another one, if there is one; else the best."""
    turn = math.atan2(y, x)

    def off(v: tuple[int, int]) -> float:
        return abs(math.remainder(math.atan2(v[1], v[0]) - turn, math.tau))

    # Those with a whole length come first, then the shorter ones.
    near = [v for v in _whole_vectors() if off(v) < within]
    if near:
        best = min(near, key=lambda v: (not math.hypot(*v).is_integer(), math.hypot(*v), off(v)))
    else:
        best = min(_whole_vectors(), key=off)
    return Vector(Fraction(best[0]), Fraction(best[1]))


def _whole_vectors() -> Iterator[tuple[int, int]]:
    sizes = range(-_WHOLE, _WHOLE + 1)
    return ((p, q) for p in sizes for q in sizes if math.gcd(p, q) == 1)


def _approach(hit: _Hit) -> Fraction:
    """How fast the bodies approach along the line of centres, but for its length."""
    other = hit.velocities[1] if hit.wall is None else Vector(Fraction(0), Fraction(0))
    fast: Fraction = (hit.velocities[0] - other).dot(hit.line)
    return fast


def _lines(hit: _Hit) -> Iterator[str]:
    first = hit.names[0]
    second = hit.wall or hit.names[1]
    yield f"title {first} hits {second}"
    for name, mass, velocity in zip(hit.names, hit.masses, hit.velocities):
        moves = f"velocity {_vector(velocity)}" if velocity != _REST else "at rest"
        yield f"sphere {name}: mass {written(mass)}, {moves}"
    if hit.wall:
        yield f"wall {hit.wall}: along {_vector(_positive(hit.line.turned_left()))}"
        yield f"{first} hits {second}: e = {written(hit.e)}"
    else:
        yield f"{first} hits {second}: along {_vector(_positive(hit.line))}, e = {written(hit.e)}"
    yield "find " + ", ".join(_asked(hit))


def _asked(hit: _Hit) -> Iterator[str]:
    after = _after(hit)
    yield from (f"velocity({name})" for name in hit.names)
    yield "impulse"
    for name, u, v in zip(hit.names, hit.velocities, after):
        if _REST not in (u, v):  # else there is no direction, before or after
            yield f"deflection({name})"
    yield "energy_lost"


def _after(hit: _Hit) -> tuple[Vector, ...]:
    """The velocities just after, by the law."""
    weights = [1 / mass for mass in hit.masses] + [Fraction(0)]
    both = [*hit.velocities, _REST]
    impulse = law.impulse(both[0], both[1], weights[0], weights[1], hit.line, hit.e)
    velocities = law.after_impulse(both[0], both[1], weights[0], weights[1], impulse)
    return tuple(velocities[: len(hit.names)])


_REST = Vector(Fraction(0), Fraction(0))


def _positive(v: Vector) -> Vector:
    """A direction, in the one of its senses that is written with fewer signs."""
    return -v if v.x < 0 or (v.x == 0 and v.y < 0) else v


def written(x: Fraction) -> str:
    """A number as people write it: a decimal if it ends soon, else a fraction."""
    rest = x.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    if rest > 1:
        return f"{x.numerator}/{x.denominator}"
    places = 0
    while (x * 10**places).denominator > 1:
        places += 1
    return f"{float(x):.{places}f}"


def _vector(v: Vector) -> str:
    """A vector in components, as people write it."""
    text = ""
    for x, unit in ((v.x, "i"), (v.y, "j")):
        if x == 0:
            continue
        size = "" if abs(x) == 1 else written(abs(x))
        sign = ("-" if x < 0 else "") if not text else (" - " if x < 0 else " + ")
        text += f"{sign}{size}{unit}"
    return text
