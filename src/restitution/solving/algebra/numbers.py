"""Numbers of high precision for letters: to decide signs and zeros, and to verify.

Symbols are compared by their values at random admissible points: two different expressions of the
size met here do not agree there by chance. There are four hundred digits, and a bound of what was
rounded, so that a number is as good as any multiple of it: no unit is the wrong one.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp
from mpmath.libmp import to_float

from restitution.exact.symbols import symbol_names
from restitution.expression.enclosed import DIGITS, Enclosed, UndefinedError
from restitution.expression.evaluate import Numeric
from restitution.oracle.points import BeyondError, Program, ball
from restitution.oracle.roles import REAL, Role

FIELD = Numeric()

Sample = dict[str, Enclosed]

_OF_FLOATS = 40
_ROUNDED = 2.0**-50


def at(x: Any, values: Mapping[str, Enclosed]) -> Enclosed:
    """The value of a SymPy expression with letters put in, by name.

    Raises UndefinedError where it is not real, and KeyError for a letter without a value.
    """
    expression = x if isinstance(x, sp.Basic) else sp.sympify(x, strict=True)
    if expression.is_Symbol:
        return Enclosed.of(values[expression.name])
    try:
        program = Program.of((expression,))
    except BeyondError:
        return _otherwise(expression, values)
    (interval,) = program.enclosures(values, DIGITS)
    if interval is None:
        # The expression is not named: to print it takes longer than to work it out.
        raise UndefinedError("no real value")
    return Enclosed(interval)


def angle_at(x: sp.Expr, values: Mapping[str, Enclosed]) -> Enclosed:
    """The value of an angle that is made of directions of vectors, at their 180° as well.

    Raises what `at` raises, and UndefinedError for a zero vector.
    """
    put: dict[sp.Basic, sp.Symbol] = {}
    known = dict(values)
    for number, arc in enumerate(x.atoms(sp.atan2)):
        above, along = (at(argument, values) for argument in arc.args)
        if not above.sign and not along.sign:
            raise UndefinedError("the zero vector has no direction")
        put[arc] = sp.Symbol(f"direction {number}", real=True)
        known[put[arc].name] = Enclosed.atan2(above, along)
    return at(x.xreplace(put), known)


def sign_there(x: Any, values: Mapping[str, Enclosed]) -> int:
    """The sign of what `at` gives: 0 where it may be zero. Raises what that raises."""
    expression = x if isinstance(x, sp.Basic) else sp.sympify(x, strict=True)
    if not expression.is_Symbol:
        with suppress(BeyondError):
            (sign,) = Program.of((expression,)).sure_signs(values)
            if sign is not None:
                return sign
    return at(expression, values).sign


def sign_beyond(x: Any, values: Mapping[str, Enclosed], number: Enclosed) -> int:
    """The sign of what `at` gives less a number; 0 where it may be zero.

    Raises what that raises.
    """
    with suppress(BeyondError, ArithmeticError, ValueError):
        (near,) = Program.of((x,)).balls(values)
        if near is not None:
            middle, error = near
            other, spread = ball(number)
            gap = middle - other
            if abs(gap) > (error + spread + abs(gap) * _ROUNDED) * (1 + _ROUNDED):
                return 1 if gap > 0 else -1
    return (at(x, values) - number).sign


def float_at(x: Any, values: Mapping[str, Enclosed]) -> float:
    """The value of an expression as a float. Raises what `at` raises."""
    expression = x if isinstance(x, sp.Basic) else sp.sympify(x, strict=True)
    if not expression.is_Symbol:
        with suppress(BeyondError):
            (interval,) = Program.of((expression,)).enclosures(values, _OF_FLOATS)
            if interval is not None:
                low, high = (to_float(end) for end in interval)
                if low == high:
                    return float(low)
    return float(at(expression, values))


def _otherwise(x: sp.Basic, values: Mapping[str, Enclosed]) -> Enclosed:
    """The value of an unusual form, as SymPy works it out: a power with a letter as exponent."""
    if isinstance(x, sp.Piecewise):
        for value, condition in x.args:
            if _holds(condition, values):
                return at(value, values)
        raise UndefinedError("no case holds")
    if x.is_Add:
        return sum((at(argument, values) for argument in x.args), FIELD.zero)
    if x.is_Mul:
        return math.prod((at(argument, values) for argument in x.args), start=Enclosed.of(1))
    if x.is_Pow:
        return at(x.base, values) ** at(x.exp, values)
    value = sp.N(
        x.xreplace({s: sp.Float(str(values[s.name]), DIGITS) for s in x.free_symbols}), DIGITS
    )
    if not value.is_real or not value.is_Float:
        raise UndefinedError(str(x))
    return Enclosed.of(Fraction(str(value)))


def _holds(condition: Any, values: Mapping[str, Enclosed]) -> bool:
    if condition in (True, sp.true):
        return True
    if condition in (False, sp.false):
        return False
    left, right = at(condition.lhs, values), at(condition.rhs, values)
    truths: dict[type, bool] = {
        sp.StrictLessThan: left < right,
        sp.LessThan: left <= right,
        sp.StrictGreaterThan: left > right,
        sp.GreaterThan: left >= right,
        sp.Equality: not (left - right).sign,
    }
    return truths[type(condition)]


@lru_cache(maxsize=8192)
def plain_sign(x: sp.Expr) -> int | None:
    """The sign that is plain from what is assumed of the letters; None where it is not."""
    try:
        if x.is_positive or x.is_negative:
            return 1 if x.is_positive else -1
        return 0 if x.is_zero else None
    except KeyError:
        return None  # SymPy fails to join products of cosines such as cos 24° cos 48°


def number_of(value: Any) -> Enclosed:
    """The value of a letter at a point."""
    if isinstance(value, sp.Expr):
        return at(value, {})
    return Enclosed.of(value if isinstance(value, Enclosed) else Fraction(value))


@lru_cache(maxsize=256)
def bound(x: sp.Expr | None) -> Enclosed | None:
    """An end of a letter's range as a number; None where it has none."""
    return None if x is None else at(x, {})


def draw(role: Role, rng: random.Random, at_edge: bool = False) -> Enclosed:
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
    return Enclosed.of(rng.gauss(0, 1) * (1 + share / 1024))


def sample(
    names: Iterable[str], roles: Mapping[str, Role], rng: random.Random, at_edge: bool = False
) -> Sample:
    """Random admissible values for letters and hidden unknowns."""
    return {name: draw(roles.get(name, REAL), rng, at_edge) for name in names}


def sign_at(x: Any, samples: Iterable[Mapping[str, Enclosed]]) -> int | None:
    """The sign of an expression if it is the same at all points where it has one, else None.

    It is None, too, of one with a letter of which the points know nothing.
    """
    x = sp.sympify(x, strict=True)
    common: int | None = None
    for values in samples:
        try:
            sign = sign_there(x, values)
        except UndefinedError:
            continue
        except KeyError:
            return None
        if common is None:
            common = sign
        elif common != sign:
            return None
        if x.is_number:
            break
    return common


def vanishes(x: sp.Expr, roles: Mapping[str, Role], seed: int = 1) -> bool:
    """Whether an expression is zero whatever its letters are."""
    if x.is_Number:
        return bool(x == 0)
    rng = random.Random(seed)
    names = sorted(symbol_names(x))
    agreed = 0
    for _ in range(12):
        values = sample(names, roles, rng)
        try:
            if sign_there(x, values):
                return False
        except UndefinedError:
            continue
        agreed += 1
        if agreed == 2 or not names:
            return True
    return agreed > 0
