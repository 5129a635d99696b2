"""Sums in letters whose coefficients only a calculator knows, with figures: ``4.757 − 1.632e``."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

import sympy as sp

from restitution.expression.tree import (
    Binary,
    Expression,
    Negate,
    Number,
    Rounded,
    has_quantity,
    has_unit_vector,
    is_binary,
    letters,
    walk,
)
from restitution.planning.writing.forms import product, total, tree_of
from restitution.workings.naming.measured import number_carried, scalar_worth

# A sum of more terms is not read as figures either.
_MOST_TERMS = 4
# Ratios of coefficients: a fraction with a greater number below is none that is seen.
_DIGITS, _GREATEST_BELOW = 30, 60


@lru_cache(maxsize=1024)
def sum_in_figures(tree: Expression, figures: int) -> Expression | None:
    """A polynomial in letters with its coefficients to so many figures.

    The highest power stands first, or the constant in one of the first degree and where that
    is the positive one; no sum begins with a minus that has a term without. A number that all
    coefficients have stands before a bracket: 21.99(1 − e²). None of what has one term or more
    than four, of a quotient by letters, of what stands as a product or a square of sums, and
    where a coefficient is very small or large.
    """
    if not letters(tree) or has_quantity(tree) or has_unit_vector(tree):
        return None
    if any(map(_is_product_of_sums, walk(tree))):
        return None
    value = scalar_worth(tree)
    symbols = [] if value is None else sorted(value.free_symbols, key=str)
    if not symbols:
        return None
    try:
        polynomial = sp.Poly(value, *symbols)
    except sp.PolynomialError:
        return None
    if not 1 < len(polynomial.terms()) <= _MOST_TERMS or polynomial.free_symbols_in_domain:
        return None
    terms = [
        (sp.Mul(*(symbol**power for symbol, power in zip(symbols, powers, strict=True))), number)
        for powers, number in polynomial.terms()
    ]
    if polynomial.total_degree() == 1 or polynomial.LC().evalf(_DIGITS) < 0:
        terms.reverse()
    if terms[0][1].evalf(_DIGITS) < 0:
        terms.sort(key=lambda term: bool(term[1].evalf(_DIGITS) < 0))
    number = terms[0][1]
    shares = [_short_fraction(own / number) for _, own in terms]
    if all(share is not None for share in shares):
        inside = sp.Add(*(share * power for share, (power, _) in zip(shares, terms, strict=True)))
        return _term(number, inside, figures)
    parts = [_term(own, power, figures) for power, own in terms]
    return None if None in parts else total(part for part in parts if part is not None)


def _is_product_of_sums(tree: Expression) -> bool:
    """Whether two factors have letters, and one is a sum: (1 − e)(w + √3), (1 − e)²."""
    match tree:
        case Binary("*", left, right):
            return bool(letters(left) and letters(right)) and (_has_sum(left) or _has_sum(right))
        case Binary("^", base, _):
            return _has_sum(base)
    return False


def _has_sum(tree: Expression) -> bool:
    return any(is_binary(node, "+", "-") and letters(node) for node in walk(tree))


def _term(number: sp.Expr, rest: sp.Expr, figures: int) -> Expression | None:
    """The product of a number in figures and letters; None of a number that is very small."""
    size = number_carried(number, figures)
    if size is None:
        return None
    if number.is_Integer and rest != 1:
        return tree_of(number * rest)
    own = _coefficient(number, abs(size), figures)
    own = own if rest == 1 else product(own, tree_of(rest))
    return Negate(own) if size < 0 else own


def _coefficient(number: sp.Expr, size: Fraction, figures: int) -> Expression:
    """A coefficient without its sign: one that comes to an end earlier has no zeros behind it."""
    if number.is_Integer:
        return Number(size)
    shorter = range(1, figures if number.is_Rational else 1)
    short = (n for n in shorter if number_carried(abs(number), n) == size)
    return Rounded(size, next(short, figures))


def _short_fraction(number: sp.Expr) -> sp.Rational | None:
    """The short fraction that a ratio of two coefficients is; None of another.

    It tells how a line is printed, and decides nothing.
    """
    value = Fraction(str(number.evalf(_DIGITS)))
    near = value.limit_denominator(_GREATEST_BELOW)
    return sp.Rational(near) if abs(value - near) < Fraction(1, 10**20) else None
