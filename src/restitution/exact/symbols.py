"""The letters of an expression and its length, which SymPy works out anew each time."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import sympy as sp


@lru_cache(maxsize=8192)
def symbols_in(value: sp.Basic) -> frozenset[sp.Symbol]:
    """The symbols in an expression, worked out once."""
    return frozenset(value.free_symbols)


@lru_cache(maxsize=8192)
def atoms_in(value: sp.Basic, *kinds: type) -> frozenset[Any]:
    """The parts of an expression that are of some kinds, worked out once."""
    return frozenset(value.atoms(*kinds))


def symbol_names(*values: sp.Basic) -> frozenset[str]:
    """The names of the symbols in expressions."""
    return frozenset([symbol.name for value in values for symbol in symbols_in(value)])


def expression_of(value: Any) -> sp.Expr:
    """A number as an expression; one that is there already is not asked again.

    Raises SympifyError for what is no number of Python or SymPy.
    """
    return value if isinstance(value, sp.Expr) else sp.sympify(value, strict=True)


def substituted(value: sp.Expr, values: Mapping[sp.Basic, sp.Basic]) -> sp.Expr:
    """An expression with values for some of its parts, in the form that this gives."""
    return _substituted(value, frozenset(values.items()))


@lru_cache(maxsize=4096)
def _substituted(value: sp.Expr, values: frozenset[tuple[sp.Basic, sp.Basic]]) -> sp.Expr:
    return value.xreplace(dict(values))


def multiple_of_a_symbol(value: sp.Expr) -> tuple[sp.Expr, sp.Symbol | None] | None:
    """The number and the symbol of a multiple of one symbol; a number has no symbol.

    None of every other expression.
    """
    number, rest = value.as_independent(*value.free_symbols, as_Add=False)
    if not (rest == 1 or rest.is_Symbol):
        return None
    return number, None if rest == 1 else rest


@lru_cache(maxsize=4096)
def operations_in(value: sp.Basic) -> int:
    """How many operations there are in an expression, counted once."""
    return int(sp.count_ops(value))


__all__ = [
    "atoms_in",
    "multiple_of_a_symbol",
    "operations_in",
    "substituted",
    "symbol_names",
    "symbols_in",
]
