"""Algebra of which the results are kept: a working does the same steps again and again."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp


@lru_cache(maxsize=1024)
def factored(x: sp.Expr) -> sp.Expr:
    """An expression in factors."""
    return sp.factor(x)


@lru_cache(maxsize=1024)
def above(x: sp.Expr) -> sp.Expr:
    """What stands above the bar when an expression is one quotient."""
    return sp.fraction(sp.together(x))[0]


@lru_cache(maxsize=256)
def simplified(x: sp.Expr) -> sp.Expr:
    """An expression as SymPy finds it simplest."""
    return sp.simplify(x)
