"""A rational expression as a product of irreducible factors, as SymPy's ``factor`` gives it.

SymPy brings an expression over one denominator as a tree and expands what it finds, and it expands
and factors again what stands as a factor already. Here each sum is a polynomial once: what its
terms have in common is taken out as factors that are known, and only what is left is factored.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache
from math import gcd, lcm
from typing import Any

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, Symbol
from sympy.polys.domains import ZZ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from restitution.exact.irreducible import factor_list

# A number, and the powers of irreducible polynomials; those below the line are negative.
_Product = tuple[Fraction, dict[PolyElement, int]]
# An expanded power of more terms is left to SymPy, which keeps it as it is where it can.
_MOST_TERMS = 2000


class _OtherError(Exception):
    """An expression is not made of letters and rational numbers alone, or too large."""


def in_factors(value: Expr) -> Expr:
    """The same as ``sympy.factor(value)``: over one denominator, and both sides in factors."""
    if value.is_Atom:
        return value
    try:
        return _in_factors(value)
    except _OtherError:
        return sympy.factor(value)


@lru_cache(maxsize=4096)
def _in_factors(value: Expr) -> Expr:
    letters = value.free_symbols
    if not letters:
        raise _OtherError
    ring = _ring(frozenset(letters))
    number, powers = _product(value, dict(zip(ring.symbols, ring.gens, strict=True)), ring)
    factors = Mul(*[Pow(_expression(factor), power) for factor, power in powers.items()])
    coefficient = Rational(number.numerator, number.denominator)
    if coefficient == 1:
        return factors
    if coefficient == -1:
        return -factors
    if isinstance(factors, Add):
        return Mul(coefficient, factors, evaluate=False)
    return coefficient * factors


@lru_cache(maxsize=8192)
def _expression(factor: PolyElement) -> Expr:
    return factor.as_expr()


@lru_cache(maxsize=512)
def _ring(letters: frozenset[Symbol]) -> PolyRing:
    """The polynomials in some letters, in SymPy's order: it tells which term leads.

    Letters of one name stay in an order that is always the same.
    """
    names = {str(letter): Symbol(str(letter)) for letter in letters}
    places = {str(x): n for n, x in enumerate(sympy.Poly(Add(*names.values())).gens)}
    order = sorted(letters, key=lambda x: (places[str(x)], sympy.default_sort_key(x)))
    return PolyRing(order, ZZ, lex)


def _product(value: Expr, letters: dict[Symbol, PolyElement], ring: PolyRing) -> _Product:
    if isinstance(value, Symbol):
        return Fraction(1), {letters[value]: 1}
    if isinstance(value, Rational):
        return Fraction(int(value.p), int(value.q)), {}
    if isinstance(value, Mul):
        return _times(_product(factor, letters, ring) for factor in value.args)
    if isinstance(value, Pow) and isinstance(value.exp, Integer):
        number, powers = _product(value.base, letters, ring)
        times = int(value.exp)
        if times < 0 and not number:
            raise _OtherError
        return number**times, {factor: power * times for factor, power in powers.items()}
    if isinstance(value, Add):
        return _sum([_product(term, letters, ring) for term in value.args], ring)
    raise _OtherError


def _times(products: Iterable[_Product]) -> _Product:
    number, powers = Fraction(1), dict[PolyElement, int]()
    for other, more in products:
        number *= other
        for factor, power in more.items():
            powers[factor] = powers.get(factor, 0) + power
    return number, {factor: power for factor, power in powers.items() if power}


def _sum(terms: list[_Product], ring: PolyRing) -> _Product:
    """A sum of products: what all have in common in front, the rest over one line and factored."""
    terms = [term for term in terms if term[0]]
    if not terms:
        return Fraction(0), {}
    below = lcm(*(number.denominator for number, _ in terms))
    whole = gcd(*(number.numerator * (below // number.denominator) for number, _ in terms))
    common = {
        factor: least
        for factor in {factor for _, powers in terms for factor in powers}
        if (least := min(powers.get(factor, 0) for _, powers in terms))
    }
    total = ring.zero
    for number, powers in terms:
        part = ring.ground_new(int(number * below) // whole)
        for factor in powers.keys() | common.keys():
            part = _grown(part, factor, powers.get(factor, 0) - common.get(factor, 0))
        total = total + part
    if not total:
        return Fraction(0), {}
    number, factors = _factors(total)
    own = Fraction(int(number)) * Fraction(whole, below), dict(factors)
    return _times([own, (Fraction(1), common)])


def _grown(part: PolyElement, factor: PolyElement, times: int) -> PolyElement:
    for _ in range(times):
        if len(part) * len(factor) > _MOST_TERMS:
            raise _OtherError
        part = part * factor
    return part


@lru_cache(maxsize=4096)
def _factors(polynomial: PolyElement) -> tuple[Any, list[tuple[PolyElement, int]]]:
    return factor_list(polynomial)


__all__ = ["in_factors"]
