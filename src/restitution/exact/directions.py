"""The exact cosine and sine of an angle made of inverse functions."""

from __future__ import annotations

import sympy
from sympy import Add, Expr, Integer, Mul, Rational, S

from restitution.exact.numbers import tidy_number
from restitution.exact.simplicity import HALF
from restitution.exact.surds import rationalised


def direction_of(value: Expr) -> tuple[Expr, Expr] | None:
    """The exact cosine and sine of an angle made of inverse functions, or None."""
    if isinstance(value, sympy.atan):
        x = value.args[0]
        size = sympy.sqrt(1 + x**2)
        return 1 / size, x / size
    if isinstance(value, sympy.acos):
        x = value.args[0]
        return x, sympy.sqrt(1 - x**2)
    if isinstance(value, sympy.asin):
        x = value.args[0]
        return sympy.sqrt(1 - x**2), x
    if (value / sympy.pi).is_Rational:
        return sympy.cos(value), sympy.sin(value)
    if isinstance(value, sympy.atan2):
        y, x = value.args
        size = sympy.sqrt(x**2 + y**2)
        return x / size, y / size
    if isinstance(value, Add):
        cosine, sine = S.One, S.Zero
        for term in value.args:
            part = direction_of(term)
            if part is None:
                return None
            cosine, sine = (
                sympy.expand(cosine * part[0] - sine * part[1]),
                sympy.expand(sine * part[0] + cosine * part[1]),
            )
        return cosine, sine
    if isinstance(value, Mul):
        number, rest = value.as_coeff_Mul()
        if not number.is_Integer or abs(number) > 12:
            if number.is_Rational and number.q == 2 and abs(number.p) < 12:
                return _half_direction(number, rest)
            return None
        part = direction_of(rest)
        if part is None:
            return None
        cosine, sine = S.One, S.Zero
        for _ in range(abs(int(number))):
            cosine, sine = (
                sympy.expand(cosine * part[0] - sine * part[1]),
                sympy.expand(sine * part[0] + cosine * part[1]),
            )
        return cosine, (sine if number > 0 else -sine)
    return None


def direction_in_surds(value: Expr) -> tuple[Expr, Expr] | None:
    """A vector in the direction of an angle, its components sums of surds; None where it has none.

    Its length is whatever comes out: a tangent t gives (1, t).
    """
    vector = vector_of(value)
    if vector is None:
        return None
    components = rationalised(vector[0]), rationalised(vector[1])
    return None if None in components else components


def vector_of(value: Expr) -> tuple[Expr, Expr] | None:
    """A vector of some length in the direction of an angle made of arctangents and parts of π."""
    if isinstance(value, Add):
        x, y = S.One, S.Zero
        for term in value.args:
            part = vector_of(term)
            if part is None:
                return None
            x, y = x * part[0] - y * part[1], y * part[0] + x * part[1]
        return x, y
    if isinstance(value, sympy.atan):
        return S.One, value.args[0]
    if isinstance(value, sympy.atan2):
        y, x = value.args
        return x, y
    if value.as_coeff_Mul()[0] is S.NegativeOne:
        part = vector_of(-value)
        return None if part is None else (part[0], -part[1])
    if (value / sympy.pi).is_Rational:
        return sympy.cos(value), sympy.sin(value)
    return None


def _half_direction(number: Rational, rest: Expr) -> tuple[Expr, Expr] | None:
    part = direction_of(Integer(number.p) * rest)
    if part is None:
        return None
    half = (number * rest).evalf(30)
    cosine = sympy.sqrt(tidy_number((1 + part[0]) / 2))
    sine = sympy.sqrt(tidy_number((1 - part[0]) / 2))
    # Of two numbers whose product has a known sign, the larger tells that of the smaller.
    across, up = (bool(f(half).evalf(30) < 0) for f in (sympy.cos, sympy.sin))
    if abs(sympy.cos(half).evalf(30)) < HALF:
        across = up != bool(part[1] < 0)
    elif abs(sympy.sin(half).evalf(30)) < HALF:
        up = across != bool(part[1] < 0)
    return -cosine if across else cosine, -sine if up else sine
