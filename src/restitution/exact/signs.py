"""The sign of an expression where the signs of its terms show it."""

from __future__ import annotations

from collections.abc import Iterator

import sympy
from sympy import Add, Expr, Mul, Pow, Rational, Symbol


def sign_of(value: Expr) -> int | None:
    """The sign of an expression, where the signs of its terms show it; zero at an end is allowed.

    Letters are positive, or coefficients from 0 to 1, or acute angles under a sine.
    """
    if value.is_nonnegative or value.is_nonpositive:
        return 1 if value.is_nonnegative else -1
    put: dict[Expr, Expr] = {}
    for node in value.atoms(sympy.sin, sympy.cos, sympy.tan):
        argument = node.args[0]
        if not (argument.is_Symbol and argument.is_positive):
            return None
        put[node] = sympy.Dummy("f", positive=True)
    plain = value.xreplace(put)
    # A coefficient e as z/(1 + z), with z from 0 to infinity: 1 − e is then 1/(1 + z).
    ends: dict[Expr, Expr] = {}
    for letter in plain.free_symbols:
        if letter.is_positive:
            continue
        if not letter.is_nonnegative:
            return None
        z = sympy.Dummy("z", positive=True)
        ends[letter] = z / (1 + z)
    if not all(isinstance(x, Rational | Symbol | Add | Mul | Pow) for x in _nodes(plain)):
        return None
    sides = sympy.together(plain.xreplace(ends)).as_numer_denom()
    sign = 1
    for side in sides:
        terms = Add.make_args(sympy.expand(side))
        if all(term.is_nonnegative for term in terms):
            continue
        if not all(term.is_nonpositive for term in terms):
            return None
        sign = -sign
    return sign


def _nodes(value: Expr) -> Iterator[Expr]:
    return iter(sympy.preorder_traversal(value))
