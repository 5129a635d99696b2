"""Numbers of high precision for letters: to decide signs and zeros, and to verify.

Symbols are compared by their values at random admissible points: two different expressions of the
size met here do not agree there by chance. There are four hundred digits, so that even the root of
something that ought to vanish is seen to vanish.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

from restitution.expression.evaluate import Numeric
from restitution.oracle.roles import REAL, Role

DIGITS = 400
TINY = mpmath.mpf(10) ** -95
FIELD = Numeric(DIGITS)
_CTX = FIELD.context
ROUNDING = _CTX.mpf(10) ** (12 - DIGITS)

Sample = dict[str, Any]


class UndefinedError(ArithmeticError):
    """An expression has no real value at a point."""


def at(x: Any, values: Mapping[str, Any]) -> Any:
    """The value of a SymPy expression with letters put in, by name, as an mpmath number.

    Raises UndefinedError where it is not real, and KeyError for a letter without a value.
    """
    try:
        return _at(x if isinstance(x, sp.Basic) else sp.sympify(x, strict=True), values)
    except (ZeroDivisionError, OverflowError) as error:
        raise UndefinedError(str(error)) from error


def _at(x: sp.Basic, values: Mapping[str, Any]) -> Any:
    if x.is_Symbol:
        return values[x.name]
    if x.is_Integer:
        return _CTX.mpf(int(x))
    if x.is_Rational:
        return _CTX.mpf(x.p) / x.q
    if x.is_Add:
        return _CTX.fsum([_at(arg, values) for arg in x.args])
    if x.is_Mul:
        return _CTX.fprod([_at(arg, values) for arg in x.args])
    if x.is_Pow:
        base = _at(x.base, values)
        if x.exp.is_Integer:
            n = int(x.exp)
            if n < 0 and abs(base) < ROUNDING:
                raise UndefinedError("division by zero")
            return base**n
        if base < 0:
            if base > -ROUNDING:
                return _CTX.mpf(0)
            raise UndefinedError("root of a negative number")
        if x.exp == sp.S.Half:
            return _CTX.sqrt(base)
        exponent = _at(x.exp, values)
        if base == 0 and exponent < 0:
            raise UndefinedError("division by zero")
        return _CTX.power(base, exponent)
    function = _FUNCTIONS.get(type(x))
    if function is not None:
        return function(*[_at(arg, values) for arg in x.args])
    if x is sp.pi:
        return +_CTX.pi
    if x.is_Float:
        return _CTX.mpf(str(x))
    if x in (sp.oo, sp.zoo, sp.nan, -sp.oo):
        raise UndefinedError(str(x))
    if isinstance(x, sp.Piecewise):
        for value, condition in x.args:
            if _holds(condition, values):
                return _at(value, values)
        raise UndefinedError("no case holds")
    value = sp.N(x.xreplace(_floats(x, values)), DIGITS)
    if not value.is_real or not value.is_Float:
        raise UndefinedError(str(x))
    return _CTX.mpf(str(value))


def _holds(condition: Any, values: Mapping[str, Any]) -> bool:
    if condition in (True, sp.true):
        return True
    if condition in (False, sp.false):
        return False
    left, right = _at(condition.lhs, values), _at(condition.rhs, values)
    truths: dict[type, bool] = {
        sp.StrictLessThan: left < right,
        sp.LessThan: left <= right,
        sp.StrictGreaterThan: left > right,
        sp.GreaterThan: left >= right,
        sp.Equality: left == right,
    }
    return truths[type(condition)]


def _floats(x: sp.Basic, values: Mapping[str, Any]) -> dict[sp.Symbol, sp.Float]:
    return {s: sp.Float(str(values[s.name]), DIGITS) for s in x.free_symbols}


def _arc(name: str) -> Any:
    def function(x: Any) -> Any:
        if abs(x) > 1:
            if abs(x) > 1 + ROUNDING:
                raise UndefinedError(f"{name} beyond 1")
            x = _CTX.sign(x)
        return getattr(_CTX, name)(x)

    return function


_FUNCTIONS: dict[type, Any] = {
    sp.sin: _CTX.sin,
    sp.cos: _CTX.cos,
    sp.tan: _CTX.tan,
    sp.cot: _CTX.cot,
    sp.sec: _CTX.sec,
    sp.csc: _CTX.csc,
    sp.atan: _CTX.atan,
    sp.acot: _CTX.acot,
    sp.atan2: _CTX.atan2,
    sp.acos: _arc("acos"),
    sp.asin: _arc("asin"),
    sp.Abs: abs,
    sp.sign: _CTX.sign,
    sp.Max: max,
    sp.Min: min,
}


def number_of(value: Any) -> Any:
    """The value of a letter at a point as an mpmath number."""
    if isinstance(value, sp.Expr):
        return at(value, {})
    fraction = Fraction(value)
    return _CTX.mpf(fraction.numerator) / fraction.denominator


@lru_cache(maxsize=256)
def bound(x: sp.Expr | None) -> Any:
    """An end of a letter's range as a number; None where it has none."""
    return None if x is None else at(x, {})


def draw(role: Role, rng: random.Random, at_edge: bool = False) -> Any:
    """A random value that a letter may have; ``at_edge`` near an end of them, or extreme."""
    low, high = bound(role.low), bound(role.high)
    # Floats are random enough, and as numbers of few digits quick to calculate with.
    share = rng.randrange(1, 2**40) / 2**40
    if at_edge:
        share = share / 50 if rng.random() < 0.5 else 1 - share / 50
    if low is not None and high is not None:
        return low + share * (high - low)
    spread = math.exp(rng.choice((-4, 4)) if at_edge else 1.2 * rng.gauss(0, 1))
    if low is not None:
        return low + spread * (1 + share / 1024)
    if high is not None:
        return high - spread * (1 + share / 1024)
    return _CTX.mpf(rng.gauss(0, 1) * (1 + share / 1024))


def sample(
    names: Iterable[str], roles: Mapping[str, Role], rng: random.Random, at_edge: bool = False
) -> Sample:
    """Random admissible values for letters and hidden unknowns."""
    return {name: draw(roles.get(name, REAL), rng, at_edge) for name in names}


def sign_at(x: Any, samples: Iterable[Mapping[str, Any]]) -> int | None:
    """The sign of an expression if it is the same at all points where it has one, else None."""
    x = sp.sympify(x, strict=True)
    found: int | None = None
    for values in samples:
        try:
            value = at(x, values)
        except UndefinedError:
            continue
        sign = 0 if abs(value) < TINY else 1 if value > 0 else -1
        if found is None:
            found = sign
        elif found != sign:
            return None
        if x.is_number:
            break
    return found


def vanishes(x: sp.Expr, roles: Mapping[str, Role], seed: int = 1) -> bool:
    """Whether an expression is zero whatever its letters are."""
    if x.is_Number:
        return bool(x == 0)
    rng = random.Random(seed)
    names = sorted(symbol.name for symbol in x.free_symbols)
    agreed = 0
    for _ in range(12):
        values = sample(names, roles, rng)
        try:
            value = at(x, values)
        except UndefinedError:
            continue
        if abs(value) > TINY:
            return False
        agreed += 1
        if agreed == 2 or not names:
            return True
    return agreed > 0
