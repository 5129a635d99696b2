"""Signs of numbers times powers of positive letters."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution.exact.symbols import symbols_in
from restitution.oracle.points import (
    Program,
)
from restitution.oracle.roles import REAL, Role


def scaled_sign(x: sp.Expr, roles: Mapping[str, Role]) -> int | None:
    """The sign of a number times powers of positive letters, if digits show it; else None."""
    if not _is_scaled(x, roles):
        return None
    number = x.xreplace({symbol: sp.Integer(1) for symbol in x.free_symbols})
    if number.has(sp.nan, sp.zoo, sp.oo):
        return None
    return Program.of([number]).signs({})[0]


def _is_scaled(x: sp.Expr, roles: Mapping[str, Role]) -> bool:
    letters_ = symbols_in(x)
    if not all(s.is_positive and roles.get(s.name, REAL).low == 0 for s in letters_):
        return False
    return _powers(x) is not None


def _powers(x: sp.Expr) -> dict[sp.Symbol, sp.Expr] | None:
    """The powers of letters to which an expression is proportional; None where it is not."""
    if not symbols_in(x):
        return {}
    if x.is_Symbol:
        return {x: sp.Integer(1)}
    if x.is_Add:
        first, *others = (_powers(argument) for argument in x.args)
        return first if all(other == first for other in others) else None
    if x.is_Mul:
        total: dict[sp.Symbol, sp.Expr] = {}
        for argument in x.args:
            own = _powers(argument)
            if own is None:
                return None
            for symbol, power in own.items():
                total[symbol] = total.get(symbol, sp.Integer(0)) + power
        return {symbol: power for symbol, power in total.items() if power}
    if x.is_Pow and x.exp.is_Rational:
        inside = _powers(x.base)
        return None if inside is None else {s: power * x.exp for s, power in inside.items()}
    if isinstance(x, sp.Abs):
        return _powers(x.args[0])
    inner = [_powers(argument) for argument in x.args]
    return {} if inner and all(factor == {} for factor in inner) else None
