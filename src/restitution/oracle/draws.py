"""Points at which to look for a counter-example: usual ones, far ones, and those near the ends.

The sequence is the same for the same letters, everywhere. It refutes; it never proves.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

import sympy as sp

from restitution.oracle.points import Program, Value, ends_of
from restitution.oracle.roles import REAL, Role

_NEAR = (Fraction(1, 10**3), Fraction(1, 10**9), Fraction(1, 10**15))
_USUAL = 16


def draws(
    names: Sequence[str], roles: Mapping[str, Role], count: int
) -> Iterator[dict[str, Value]]:
    """So many points, with a value for each letter that its role allows."""
    rng = random.Random(20)
    ranges = {name: _ends(roles.get(name, REAL)) for name in names}
    for n in range(count):
        point: dict[str, Value] = {}
        kind = "usual" if n < _USUAL else ("near", "far", "usual")[n % 3]
        for name in names:
            role, (low, high) = roles.get(name, REAL), ranges[name]
            own = kind if kind == "usual" or rng.random() < 0.6 else "usual"
            point[name] = _value(role, low, high, rng, own)
        yield point


def _ends(role: Role) -> tuple[Value | None, Value | None]:
    return _end(role.low), _end(role.high)


def _end(x: sp.Expr | None) -> Value | None:
    if x is None:
        return None
    if x.is_Rational:
        return Fraction(int(x.p), int(x.q))
    low, high = ends_of(Program.of([x]).enclosures({}, 30)[0])
    return float((low + high) / 2)


def _value(
    role: Role, low: Value | None, high: Value | None, rng: random.Random, kind: str
) -> Value:
    if low is not None and high is not None:
        return _between(role, low, high, rng, kind)
    if low is None and high is None:
        size = _positive(rng, kind)
        return size if rng.random() < 0.5 else -size
    end, sense = (low, 1) if low is not None else (high, -1)
    assert end is not None
    return Fraction(end) + sense * _positive(rng, kind)


def _positive(rng: random.Random, kind: str) -> Fraction:
    if kind == "usual":
        return Fraction(round(64 * math.exp(rng.gauss(0, 1))) + 1, 64)
    if kind == "far":
        return Fraction(10) ** rng.randint(-12, 12) * rng.randint(1, 9)
    return Fraction(10) ** rng.choice((-9, -6, -3, 3, 6, 9)) * rng.randint(1, 9)


def _between(role: Role, low: Value, high: Value, rng: random.Random, kind: str) -> Value:
    bottom, top = Fraction(low), Fraction(high)
    width = top - bottom
    if kind == "usual":
        return bottom + width * Fraction(rng.randint(1, 63), 64)
    upper = rng.random() < 0.5
    closed = role.closed[1] if upper else role.closed[0]
    # An end that is rational is reached exactly; π/2 is only come near to.
    exact = isinstance(high if upper else low, Fraction)
    if closed and exact and rng.random() < 0.5:
        return top if upper else bottom
    share = rng.choice(_NEAR) * width
    return top - share if upper else bottom + share
