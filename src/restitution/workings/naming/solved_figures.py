"""Equations with figures: whether what they give is what the exact ones give."""

from __future__ import annotations

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import significant
from restitution.expression.tree import Expression, Letter, has_quantity
from restitution.workings.naming.measured import worth

_DIGITS = 20


def leads_elsewhere(left: Expression, right: Expression, letter: Letter, exact: Expression) -> bool:
    """Whether an equation with figures gives a letter other figures, three of them, than it has.

    Where both sides are nearly alike, little of the figures is left. It tells how a line is
    printed, and decides nothing.
    """
    if any(map(has_quantity, (left, right, exact))):
        return False
    try:
        residual, value = worth(left) - worth(right), worth(exact)
        there = {symbol: 1 for symbol in residual.free_symbols if symbol.name != letter.name}
        (symbol,) = residual.free_symbols - there.keys()
        own = sp.N(value.subs(dict.fromkeys(value.free_symbols, 1)), _DIGITS)
        residual = residual.subs(there)
        slope = residual.diff(symbol).subs(symbol, own)
        other = own - residual.subs(symbol, own) / slope
        return significant(own) != significant(other)
    except (RestitutionError, sp.SympifyError, ValueError, TypeError):
        return False
