"""Where an expression can turn, and its limits there and at the ends."""

from __future__ import annotations

import random
from collections.abc import Mapping
from itertools import product

import sympy as sp

from restitution import exact
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.oracle.roles import Role
from restitution.solving.algebra.intervals import INFINITE
from restitution.solving.algebra.numbers import Sample, at, sign_at
from restitution.solving.ranges.zeros import zeros


def turning(expression: sp.Expr, symbol: sp.Symbol, roles: Mapping[str, Role]) -> list[sp.Expr]:
    """Where an expression can turn: its stationary points, and the kinks where a bar vanishes."""
    bars = sorted((bar for bar in expression.atoms(sp.Abs) if bar.has(symbol)), key=str)
    points: list[sp.Expr] = []
    for bar in bars:
        points += zeros(
            [sp.together(bar.args[0]).as_numer_denom()[0]], [symbol], roles, symbol.name
        )
    for signs in product((1, -1), repeat=len(bars)):
        put = {bar: sign * bar.args[0] for bar, sign in zip(bars, signs, strict=True)}
        slope = _derivative(expression.xreplace(put), symbol)
        points += zeros([slope], [symbol], roles, symbol.name)
    return list(dict.fromkeys(points))


def _derivative(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """The numerator of the derivative, which vanishes at stationary points."""
    core = expression
    if isinstance(core, sp.Pow) and core.exp == sp.S.Half:
        core = core.base
    return sp.together(sp.diff(core, symbol)).as_numer_denom()[0]


def limit(
    expression: sp.Expr, symbol: sp.Symbol, point: sp.Expr, below: bool = False
) -> sp.Expr | None:
    """The value of an expression at a point, or its limit there (from below if so asked)."""
    quick = _approached(exact.in_sines(expression), symbol, sp.sympify(point, strict=True), below)
    if quick is not None:
        return quick if quick in (sp.oo, -sp.oo) else exact.tidy(quick)
    try:
        side = "-" if below or point == sp.oo else "+"
        value = sp.limit(expression, symbol, point, side)
    except (NotImplementedError, ValueError, TypeError, RecursionError):
        return None
    if value.has(sp.nan, sp.zoo) or isinstance(value, sp.Limit):
        return None
    return value


def limits(
    expression: sp.Expr, symbol: sp.Symbol, point: sp.Expr, role: Role
) -> list[tuple[sp.Expr, dict[str, int]]]:
    """The limit at a point, or one for each side of a pole, with the side that it belongs to."""
    value = limit(expression, symbol, point, point == role.high)
    if value is None:
        return []
    if value not in (sp.oo, -sp.oo) or point in (sp.oo, -sp.oo, role.low, role.high):
        return [(value, {})]
    both = ((limit(expression, symbol, point, side < 0), side) for side in (1, -1))
    return [(each, {symbol.name: side}) for each, side in both if each is not None]


def _approached(x: sp.Expr, symbol: sp.Symbol, point: sp.Expr, below: bool) -> sp.Expr | None:
    """The limit where it can be had by putting in; None where it takes more."""
    if not x.has(symbol):
        return x
    if point in (sp.oo, -sp.oo):
        return None
    if x.is_Add or (x.is_Mul and x.args[0].is_number and not x.args[0].has(symbol)):
        parts = [_approached(argument, symbol, point, below) for argument in x.args]
        if all(part is not None and part.is_finite is not False for part in parts):
            return x.func(*parts)
    if isinstance(x, sp.atan):
        inner = _approached(x.args[0], symbol, point, below)
        if inner in (sp.oo, -sp.oo):
            return sp.pi / 2 if inner == sp.oo else -sp.pi / 2
        return None if inner is None else sp.atan(inner)
    top, bottom = sp.together(x).as_numer_denom()
    try:
        value, under = (each.xreplace({symbol: point}) for each in (top, bottom))
        value, under = sp.expand(value), sp.expand(under)
    except (ZeroDivisionError, TypeError):
        return None
    if any(each.has(sp.nan, sp.zoo, sp.oo) for each in (value, under)):
        return None
    if under != 0:
        return value / under
    if value == 0:
        return None
    step = sp.Rational(-1 if below else 1, 10**8)
    near = bottom.xreplace({symbol: point + step})
    rng = random.Random(47)
    names = sorted(s.name for s in (value * near).free_symbols)
    points = [{name: Enclosed.of(rng.uniform(0.1, 0.9)) for name in names} for _ in range(4)]
    sign = sign_at(value * near, points)
    return None if sign in (None, 0) else sign * sp.oo


def limit_at(value: sp.Expr, drawn: Sample) -> Enclosed | None:
    """A limit as a number at some values of the data; None where it has none."""
    if value in (sp.oo, -sp.oo):
        return Enclosed.of(INFINITE if value == sp.oo else -INFINITE)
    try:
        return at(value, drawn)
    except (UndefinedError, KeyError):
        return None
