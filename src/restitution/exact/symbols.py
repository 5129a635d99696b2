"""The letters of an expression, which SymPy collects anew each time."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp


@lru_cache(maxsize=8192)
def symbols_in(value: sp.Basic) -> frozenset[sp.Symbol]:
    """The symbols in an expression, worked out once."""
    return frozenset(value.free_symbols)


__all__ = ["symbols_in"]
