"""Plainer values for a counter-example that people are to check by hand."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction

import sympy as sp

from restitution.oracle.points import Point, Value, constant_interval, ends_of
from restitution.oracle.roles import REAL, Role

_PLAIN_DEGREES = (45, 60, 30, 10, 80, 1, 89)
_DENOMINATORS = (1, 2, 4, 10, 100, 1000, 10**6)


def simpler(
    point: Point, roles: Mapping[str, Role], serves: Callable[[Point], bool]
) -> dict[str, Value]:
    """The point, letter by letter as plain as still serves: 2 for 1.97, 40° for 0.71 radians."""
    current = dict(point)
    for name in sorted(current):
        value = current[name]
        for candidate in _candidates(value, roles.get(name, REAL)):
            if candidate == value:
                break
            trial = {**current, name: candidate}
            if serves(trial):
                current = trial
                break
    return current


def _candidates(value: Value, role: Role) -> list[Value]:
    number = _number(value)
    if role.kind == "angle":
        degrees = number * 180 / math.pi
        steps = (15, 5, 1, Fraction(1, 10), Fraction(1, 1000), Fraction(1, 10**6))
        nearest = [Fraction(number) for number in _PLAIN_DEGREES]
        nearest += [round(degrees / float(step)) * Fraction(step) for step in steps]
        return [
            sp.Rational(number.numerator, number.denominator * 180) * sp.pi
            for number in dict.fromkeys(nearest)
        ]
    plain: list[Value] = [Fraction(1), Fraction(2), Fraction(1, 2), Fraction(0)]
    for power in range(1, 7):
        plain += [Fraction(10) ** power, Fraction(1, 10**power)]
    fraction = value if isinstance(value, Fraction) else Fraction(number)
    plain += [fraction.limit_denominator(n) for n in _DENOMINATORS]
    if number:
        # One significant figure: 0.00003 as well as 30000.
        ten = Fraction(10) ** math.floor(math.log10(abs(number)))
        plain += [round(fraction / ten) * ten, round(fraction * 10 / ten) * ten / 10]
    return list(dict.fromkeys(plain))


def _number(value: Value) -> float:
    if isinstance(value, sp.Expr):
        low, high = ends_of(constant_interval(value, 30))
        return float((low + high) / 2)
    return float(value)
