"""Quotients of polynomials over ℚ within bounds, vectors of them, and their factors."""

from __future__ import annotations

from fractions import Fraction
from functools import cache, lru_cache
from math import isqrt, lcm
from operator import add
from typing import Any

import sympy as sp
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement, PolyRing

from restitution.exact.irreducible import factor_list
from restitution.records import dataclass

MOST_GENERATORS = 48


MOST_TERMS = 4000


MOST_POWER = 16


_MOST_BITS = 4096


_MOST_FACTOR = 10_000

# Of fewer products of two terms, to pack them takes longer than it saves.
_MANY_PRODUCTS = 256

# A power, and the sum of two, keeps well below 2 to this.
_BITS = 24
_MASK = 2**_BITS - 1


class NotComparableError(Exception):
    """A tree that cannot be made a quotient of polynomials: of more than is worth comparing."""


@cache
def quotient_ring() -> PolyRing:
    """The ring over ℚ in all generators that a comparison may have."""
    return PolyRing([f"g{n}" for n in range(MOST_GENERATORS)], QQ)


@cache
def one() -> PolyElement:
    """The polynomial 1 in all generators, always the same: most quotients stand over it."""
    return quotient_ring().one


def _is_one(polynomial: PolyElement) -> bool:
    if polynomial is one():
        return True
    return len(polynomial) == 1 and polynomial.get(quotient_ring().zero_monom) == 1


def product(a: PolyElement, b: PolyElement) -> PolyElement:
    """The product of two polynomials in all generators.

    SymPy's own multiplies every term by 1, and adds every new one to 0: most polynomials that
    stand below are 1, and most others have one term.
    """
    if not b or _is_one(a):
        return b
    if not a or _is_one(b):
        return a
    if len(a) * len(b) >= _MANY_PRODUCTS:
        return _product_of_many(a, b)
    terms: dict[tuple[int, ...], Any] = {}
    for powers, factor in a.items():
        for others, value in b.items():
            key = tuple(map(add, powers, others))
            term = factor * value
            known = terms.get(key)
            terms[key] = term if known is None else known + term
    return _polynomial(terms)


def _product_of_many(a: PolyElement, b: PolyElement) -> PolyElement:
    """The product of two polynomials of many terms: powers packed in one integer, whole numbers.

    A fraction costs a greatest common divisor each time that it is multiplied or added.
    """
    used = [n for n, powers in enumerate(zip(*a, *b, strict=True)) if any(powers)]
    (ours, our_denominator), (theirs, their_denominator) = (_packed(side, used) for side in (a, b))
    packed: dict[int, int] = {}
    for powers, factor in ours:
        for others, value in theirs:
            key = powers + others
            packed[key] = packed.get(key, 0) + factor * value
    denominator = our_denominator * their_denominator
    terms = {}
    for key, value in packed.items():
        if value:
            monomial = [0] * MOST_GENERATORS
            for n in used:
                monomial[n] = key & _MASK
                key >>= _BITS
            terms[tuple(monomial)] = QQ(value, denominator)
    return one().new(terms)


def _packed(polynomial: PolyElement, used: list[int]) -> tuple[list[tuple[int, int]], int]:
    """The terms over one denominator, the powers of some generators in one integer each."""
    denominator = lcm(*(int(value.denominator) for value in polynomial.values()))
    terms = []
    for powers, value in polynomial.items():
        key = 0
        for n in reversed(used):
            key = key << _BITS | powers[n]
        terms.append((key, int(value.numerator) * (denominator // int(value.denominator))))
    return terms, denominator


def total(a: PolyElement, b: PolyElement) -> PolyElement:
    """The sum of two polynomials in all generators."""
    if not a or not b:
        return a or b
    terms = dict(a)
    for powers, value in b.items():
        known = terms.get(powers)
        terms[powers] = value if known is None else known + value
    return _polynomial(terms)


def _polynomial(terms: dict[tuple[int, ...], Any]) -> PolyElement:
    """A polynomial of terms of which some may be zero."""
    return one().new({powers: value for powers, value in terms.items() if value})


@dataclass(frozen=True)
class Quotient:
    """A polynomial over another one, which is not zero."""

    above: PolyElement
    below: PolyElement

    def __add__(self, other: Quotient) -> Quotient:
        if self.below is other.below or self.below == other.below:
            return lean(total(self.above, other.above), self.below)
        above = total(product(self.above, other.below), product(other.above, self.below))
        return lean(above, product(self.below, other.below))

    def __neg__(self) -> Quotient:
        return Quotient(-self.above, self.below)

    def __sub__(self, other: Quotient) -> Quotient:
        return self + -other

    def __mul__(self, other: Quotient) -> Quotient:
        return lean(product(self.above, other.above), product(self.below, other.below))

    def __truediv__(self, other: Quotient) -> Quotient:
        if not other.above:
            raise NotComparableError("a line divides by zero")
        return lean(product(self.above, other.below), product(self.below, other.above))

    def __pow__(self, power: int) -> Quotient:
        if abs(power) > MOST_POWER:
            raise NotComparableError(f"the power {power}")
        if power < 0:
            return CONSTANT(1) / self**-power
        if not power:
            return CONSTANT(1)  # SymPy has no zero to the power of zero
        if any(len(side) ** power > MOST_TERMS**2 for side in (self.above, self.below)):
            raise NotComparableError("a line of too many terms")
        return lean(self.above**power, self.below**power)

    @property
    def vanishes(self) -> bool:
        """Whether it is zero whatever the generators are."""
        return not self.above


@lru_cache(256)
def CONSTANT(value: Fraction | int) -> Quotient:
    """A number as a quotient."""
    value = Fraction(value)
    number = QQ(int(value.numerator), int(value.denominator))
    return Quotient(quotient_ring().ground_new(number), one())


def _has_long_numbers(polynomial: PolyElement) -> bool:
    for value in polynomial.values():
        if max(value.numerator.bit_length(), value.denominator.bit_length()) > _MOST_BITS:
            return True
    return False


def lean(above: PolyElement, below: PolyElement) -> Quotient:
    """The quotient without common powers of single generators, and a number below."""
    if len(above) > MOST_TERMS or len(below) > MOST_TERMS:
        raise NotComparableError("a line of too many terms")
    if _has_long_numbers(above) or (below is not one() and _has_long_numbers(below)):
        raise NotComparableError("a line of too long numbers")
    if not below:
        raise NotComparableError("a line divides by zero")
    if not above or below is one():
        return Quotient(above, one())
    if below.is_ground:
        number = below.LC
        return Quotient(above if number == 1 else above.quo_ground(number), one())
    common = tuple(map(min, zip(*above, *below, strict=True)))
    if any(common):
        above, below = (
            quotient_ring().from_dict(
                {
                    tuple(a - b for a, b in zip(powers, common, strict=True)): value
                    for powers, value in polynomial.items()
                }
            )
            for polynomial in (above, below)
        )
        if below.is_ground:
            return lean(above, below)
    return Quotient(above, below)


@dataclass(frozen=True)
class Plane:
    """A vector by its components in the directions of **i** and **j**."""

    x: Quotient
    y: Quotient


def square_part(number: int) -> tuple[int, int]:
    """The whole numbers a, b of number = a² b, with b free of squares."""
    sign, number = (-1, -number) if number < 0 else (1, number)
    root = isqrt(number)
    if root * root == number:
        return root, sign
    square, free = 1, 1
    for prime, times in primes(number).items():
        square *= prime ** (times // 2)
        free *= prime ** (times % 2)
    return square, sign * free


def primes(number: int) -> dict[int, int]:
    """The factors of a number and their powers; what has no small factor stays as it is."""
    factors: dict[int, int] = sp.factorint(number, limit=_MOST_FACTOR, use_rho=False, use_pm1=False)
    powers: dict[int, int] = {}
    for factor, times in factors.items():
        root = isqrt(factor)
        if root * root == factor and factor > 1:
            powers[root] = powers.get(root, 0) + 2 * times
        else:
            powers[factor] = powers.get(factor, 0) + times
    return powers


def small(*polynomials: PolyElement) -> tuple[tuple[int, ...], tuple[PolyElement, ...]]:
    """Polynomials in a ring of their own generators only, and which of all these are."""
    used = sorted(
        {n for polynomial in polynomials for m in polynomial for n, power in enumerate(m) if power}
    )
    ring = _small_ring(max(len(used), 1))
    return tuple(used), tuple(
        ring.from_dict(
            {tuple(m[n] for n in used) or (0,): value for m, value in polynomial.items()},
        )
        for polynomial in polynomials
    )


@cache
def _small_ring(count: int) -> PolyRing:
    return PolyRing([f"g{n}" for n in range(count)], QQ)


def large(used: tuple[int, ...], polynomial: PolyElement) -> PolyElement:
    """A polynomial of a small ring among all generators again."""
    result = {}
    for powers, value in polynomial.items():
        monomial = [0] * MOST_GENERATORS
        for n, power in zip(used, powers, strict=False):
            monomial[n] = power
        result[tuple(monomial)] = value
    return quotient_ring().from_dict(result)


def factors_of(polynomial: PolyElement) -> tuple[Fraction, list[tuple[PolyElement, int]]]:
    """A number and irreducible factors with their powers."""
    used, (own,) = small(polynomial)
    if not used:
        return polynomial.LC, []
    number, factors = _factor_list(own)
    return number, [(large(used, factor), times) for factor, times in factors]


def without_common(a: PolyElement, b: PolyElement) -> tuple[PolyElement, PolyElement]:
    """Two polynomials divided by what they have in common."""
    used, (own_a, own_b) = small(a, b)
    if not used or not own_a or not own_b:
        return a, b
    rest_a, rest_b = _coprime(own_a, own_b)
    return large(used, rest_a), large(used, rest_b)


def is_without(rest: PolyElement, whole: PolyElement) -> bool:
    """Whether what is left of a polynomial is less than all of it, a number as factor aside."""
    return bool(rest.leading_expv() != whole.leading_expv())


# The lines of a working are tried one after another, of the same quantities.
@lru_cache(4096)
def _factor_list(polynomial: PolyElement) -> tuple[Fraction, list[tuple[PolyElement, int]]]:
    return factor_list(polynomial)


@lru_cache(4096)
def _coprime(a: PolyElement, b: PolyElement) -> tuple[PolyElement, PolyElement]:
    _, rest_a, rest_b = a.cofactors(b)
    return rest_a, rest_b
