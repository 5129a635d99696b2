"""Polynomials in one letter whose coefficients are numbers of a field: factors and norms."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy.polys.domains import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

from restitution.errors import UnsupportedError
from restitution.solving.algebra.polynomials import (
    WORD,
    Element,
    Field,
    afford,
    bits,
    by_powers,
    embedded,
    factoring,
    field_coefficients,
    from_powers,
    split,
    without_denominators,
)


def split_over_numbers(x: sp.Expr, symbol: sp.Symbol) -> list[sp.Expr]:
    """The irreducible factors of a polynomial in one letter over the field of its coefficients.

    They are found by its norm, the product of all its conjugates (Trager). Where the field has
    divisors of zero (a root that could be taken), the polynomial comes back whole.
    """
    field = Field([x], [symbol])
    whole = field_coefficients(field, x, symbol)
    if not any(m for part in whole for m in part if any(m)):
        return [
            field.expression(value) for value in split(without_denominators(from_powers(whole)))
        ]
    simple = _without_squares(field, whole)
    if simple is None:
        return [x]
    surds = sum((field.ring.gens[r.index] for r in field.relations), field.ring.zero)
    for shift in range(4):
        moved = _moved(field, simple, surds * shift)
        norm = field.free_of_roots(from_powers(moved))
        lone = _alone(norm)
        afford(factoring(lone) * 4)
        if not lone.is_squarefree:
            continue
        factors_ = []
        for factor in split(lone):
            common = _gcd(field, moved, by_powers(embedded(field.ring, factor, [0])))
            if common is None:
                return [x]
            if len(common) > 1:
                factors_.append(_moved(field, common, surds * -shift))
        factors_.sort(key=lambda parts: (len(parts), [_coordinates(part) for part in parts]))
        return [field.expression(from_powers(parts)) for parts in factors_]
    return [x]


def _coordinates(a: Element) -> list[Any]:
    """A number of a field by its coordinates, those of the highest surds first."""
    return sorted(a.items(), reverse=True)


def norm(x: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """A multiple of a polynomial in one letter with rational coefficients."""
    field = Field([x], [symbol])
    whole = from_powers(field_coefficients(field, x, symbol))
    multiple = field.free_of_roots(whole)
    if any(power for m in multiple for power in m[1:]):
        raise UnsupportedError("an equation whose coefficients are no roots of rational numbers")
    return field.expression(without_denominators(multiple))


def isolating(x: sp.Expr, symbol: sp.Symbol) -> float:
    """An estimate of the operations of finding the real roots of a polynomial over ℚ."""
    field = Field([x], [symbol])
    whole = from_powers(field_coefficients(field, x, symbol))
    top = max(m[0] for m in whole)
    return float(10 * top**3 * (1 + bits(whole) / WORD))


def _alone(a: Element) -> Element:
    """A polynomial in the first letter only, in a ring of its own."""
    if any(power for m in a for power in m[1:]):
        raise UnsupportedError("an equation whose coefficients are no roots of rational numbers")
    ring = PolyRing(["x0"], QQ, lex)
    return ring.from_dict({(m[0],): c for m, c in a.items()})


def _moved(field: Field, a: Sequence[Element], by: Element) -> list[Element]:
    """The coefficients of p(x + by), by Horner's rule."""
    if by == 0:
        return list(a)
    total: list[Element] = []
    for value in a:
        shifted = [*total, field.ring.zero]
        for n, part in enumerate(total):
            shifted[n + 1] = shifted[n + 1] + field.times(part, by)
        shifted[-1] = shifted[-1] + value
        total = shifted
    return total


def _remainder(field: Field, a: Sequence[Element], b: Sequence[Element]) -> list[Element] | None:
    """The remainder of a division by a polynomial whose leading coefficient is 1."""
    left = list(a)
    while len(left) >= len(b):
        top = left[0]
        left = [
            part - field.times(top, b[n]) if n < len(b) else part for n, part in enumerate(left)
        ][1:]
        while left and left[0] == 0:
            left.pop(0)
    return left


def _monic(field: Field, a: Sequence[Element]) -> list[Element] | None:
    inverse = field.inverse(a[0])
    if inverse is None:
        return None
    return [field.ring.one, *[field.times(part, inverse) for part in a[1:]]]


def _gcd(field: Field, a: Sequence[Element], b: Sequence[Element]) -> list[Element] | None:
    """The common divisor, with leading coefficient 1; None where numbers cannot be divided."""
    one, other = list(a), list(b)
    while other:
        monic = _monic(field, other)
        if monic is None:
            return None
        one, other = monic, _remainder(field, one, monic) or []
    return _monic(field, one)


def _without_squares(field: Field, a: Sequence[Element]) -> list[Element] | None:
    top = len(a) - 1
    slope = [part.mul_ground(QQ(top - n)) for n, part in enumerate(a[:-1])]
    common = _gcd(field, a, slope) if slope else None
    if common is None or len(common) == 1:
        return None if slope and common is None else list(a)
    return _quotient(field, a, common)


def _quotient(field: Field, a: Sequence[Element], b: Sequence[Element]) -> list[Element]:
    left, quotient = list(a), []
    while len(left) >= len(b):
        top = left[0]
        quotient.append(top)
        left = [
            part - field.times(top, b[n]) if n < len(b) else part for n, part in enumerate(left)
        ][1:]
    return quotient
