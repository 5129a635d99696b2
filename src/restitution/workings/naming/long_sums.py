"""Sums in letters whose coefficients only a calculator knows, with figures: ``4.757 − 1.632e``."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

import sympy as sp

from restitution.expression.tree import (
    Expression,
    Negate,
    Number,
    Rounded,
    has_quantity,
    has_unit_vector,
    letters,
)
from restitution.planning.writing.forms import product, total, tree_of
from restitution.workings.naming.measured import number_carried, scalar_worth

# A sum of more terms is not read as figures either.
_MOST_TERMS = 4


@lru_cache(maxsize=1024)
def sum_in_figures(tree: Expression, figures: int) -> Expression | None:
    """A polynomial in letters with its coefficients to so many figures.

    The constant stands first in one of the first degree, and where the highest power would have
    a sign; else that does. None of what has one term or more than four, of a quotient by letters,
    and where a coefficient is very small or large.
    """
    if not letters(tree) or has_quantity(tree) or has_unit_vector(tree):
        return None
    value = scalar_worth(tree)
    if value is None or not value.free_symbols:
        return None
    symbols = sorted(value.free_symbols, key=str)
    try:
        polynomial = sp.Poly(value, *symbols)
    except sp.PolynomialError:
        return None
    terms = polynomial.terms()
    if not 1 < len(terms) <= _MOST_TERMS or polynomial.free_symbols_in_domain:
        return None
    if polynomial.total_degree() == 1:
        terms = sorted(terms, key=lambda term: any(term[0]))
    elif terms[0][1].is_negative and not terms[-1][1].is_negative:
        terms = terms[::-1]
    parts: list[Expression] = []
    for powers, coefficient in terms:
        size = number_carried(coefficient, figures)
        if size is None:
            return None
        rest = sp.Mul(*(symbol**power for symbol, power in zip(symbols, powers, strict=True)))
        own = _coefficient(coefficient, size, figures)
        if rest != 1:
            own = product(own, tree_of(rest))
        parts.append(Negate(own) if size < 0 else own)
    return total(parts)


def _coefficient(number: sp.Expr, size: Fraction, figures: int) -> Expression:
    """A coefficient without its sign: one that comes to an end earlier has no zeros behind it."""
    if number.is_Integer:
        return Number(abs(size))
    short = (
        n for n in range(1, figures) if number.is_Rational and number_carried(number, n) == size
    )
    return Rounded(abs(size), next(short, figures))
