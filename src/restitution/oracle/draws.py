"""Points at which to look for a counter-example: usual ones, far ones, and those near the ends.

The sequence is the same for the same letters, everywhere. It refutes; it never proves.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp

from restitution.oracle.points import Ball, Value, ball, constant_interval, ends_of
from restitution.oracle.roles import REAL, Role
from restitution.records import dataclass

_NEAR = (Fraction(1, 10**3), Fraction(1, 10**9), Fraction(1, 10**15))
_USUAL = 16
_BLOCK = 16


@dataclass(frozen=True)
class Draw:
    """A value for each of some letters: exactly, and as a float with a bound of its error."""

    point: dict[str, Value]
    balls: dict[str, Ball]


def draws(
    names: Sequence[str], roles: Mapping[str, Role], count: int, first: int = 0
) -> Iterator[Draw]:
    """So many draws, with values that the letters' roles allow, from the ``first`` one on."""
    kinds = tuple(roles.get(name, REAL) for name in names)
    for n in range(first, first + count):
        row = _block(kinds, n // _BLOCK)[0][n % _BLOCK]
        point = {name: value for name, (value, _) in zip(names, row, strict=True)}
        yield Draw(point, {name: own for name, (_, own) in zip(names, row, strict=True)})


@lru_cache(maxsize=256)
def _block(
    kinds: tuple[Role, ...], number: int
) -> tuple[tuple[tuple[tuple[Value, Ball], ...], ...], Any]:
    """Some rows of values for letters of these roles, and how the generator goes on."""
    rng = random.Random(20)
    if number:
        rng.setstate(_block(kinds, number - 1)[1])
    ranges = [_ends(role) for role in kinds]
    rows = []
    for n in range(number * _BLOCK, (number + 1) * _BLOCK):
        kind = "usual" if n < _USUAL else ("near", "far", "usual")[n % 3]
        row = []
        for role, (low, high) in zip(kinds, ranges, strict=True):
            own = kind if kind == "usual" or rng.random() < 0.6 else "usual"
            value = _value(role, low, high, rng, own)
            row.append((value, ball(value)))
        rows.append(tuple(row))
    return tuple(rows), rng.getstate()


def _ends(role: Role) -> tuple[Value | None, Value | None]:
    return _end(role.low), _end(role.high)


def _end(x: sp.Expr | None) -> Value | None:
    if x is None:
        return None
    if x.is_Rational:
        return Fraction(int(x.p), int(x.q))
    low, high = ends_of(constant_interval(x, 30))
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
