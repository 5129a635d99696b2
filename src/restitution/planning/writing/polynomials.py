"""Multiplying out, factors, one fraction: pure functions of SymPy of which results are kept.

Several rooms ask the same of an expression while one line is planned, and again while another way
to it is tried. A bounded number of results is kept.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import sympy as sp

from restitution.exact.products import in_factors
from restitution.work import remembered


@remembered(4096)
def expanded(x: Any) -> sp.Expr:
    """An expression multiplied out."""
    return sp.expand(x)


@remembered(2048)
def factored(x: Any) -> sp.Expr:
    """An expression as a product of factors with whole coefficients."""
    return in_factors(sp.sympify(x, strict=True))


@remembered(2048)
def factor_powers(x: sp.Expr) -> tuple[tuple[sp.Expr, int], ...]:
    """The factors of a polynomial that have letters, each with its power; none of zero."""
    if expanded(x) == 0:
        return ()
    return tuple(sp.factor_list(x)[1])


def is_factored_quadratic(value: sp.Expr, unknown: Collection[sp.Symbol]) -> bool:
    """Whether an expression is a product of sums with the one unknown, and no x² − c."""
    if len(unknown) != 1:
        return False
    (letter,) = unknown
    if not value.is_polynomial(letter):
        return False
    above = numerator(value)  # below the line other letters may stand
    sums = [power for base, power in factor_powers(above) if base.is_Add and base.has(letter)]
    return sum(sums) > 1 and bool(expanded(value).coeff(letter, 1))


@remembered(1024)
def polynomial_in(x: sp.Expr, *letters: sp.Basic) -> sp.Poly:
    """An expression as a polynomial in some letters. Raises PolynomialError where it is none."""
    return sp.Poly(x, *letters)


@remembered(1024)
def derivative(x: sp.Expr, symbol: sp.Basic) -> sp.Expr:
    """The derivative of an expression."""
    return sp.diff(x, symbol)


@remembered(2048)
def one_fraction(x: Any) -> sp.Expr:
    """A sum as one fraction, in which nothing is cancelled."""
    return sp.together(x)


@remembered(2048)
def cancelled(x: Any) -> sp.Expr:
    """A quotient in lowest terms."""
    return sp.cancel(x)


@remembered(2048)
def numerator(x: sp.Expr) -> sp.Expr:
    """What stands above in a quotient in lowest terms, multiplied out."""
    above, below = sp.fraction(one_fraction(x))
    if below.free_symbols:
        above = sp.fraction(cancelled(above / below))[0]
    return expanded(above)


# What stands in the place of a sum: of a letter that is new each time nothing would be kept.
IN_PLACE = sp.Dummy("sum", real=True)


@remembered(512)
def coefficients_in_place(gap: sp.Expr) -> tuple[sp.Expr, ...] | None:
    """The coefficients of an equation to zero in `IN_PLACE`, from the constant on.

    None where it is no polynomial in that.
    """
    above = sp.expand(sp.fraction(sp.together(gap))[0])
    if not above.is_polynomial(IN_PLACE):
        return None
    degree = int(max(sp.degree(above, IN_PLACE), 0))
    return tuple(above.coeff(IN_PLACE, n) for n in range(degree + 1))


@remembered(512)
def polynomial_without(symbol: sp.Symbol, other: sp.Symbol, one: sp.Expr, two: sp.Expr) -> sp.Poly:
    """Of two expressions that are linear in another unknown what is left without it."""
    slopes = [sp.diff(value, other) for value in (one, two)]
    return sp.Poly(expanded(one * slopes[1] - two * slopes[0]), symbol)
