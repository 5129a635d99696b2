"""Square roots, with square factors taken out: what is positive, and what size the rest has."""

from __future__ import annotations

import itertools
from dataclasses import field
from fractions import Fraction
from math import isqrt, prod
from typing import Any

import sympy as sp
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement

from restitution.explaining.lines.generators import Generators, Key, Value
from restitution.explaining.lines.quotients import (
    CONSTANT,
    NotComparableError,
    Plane,
    Quotient,
    factors_of,
    one,
    primes,
    product,
    quotient_ring,
    square_part,
)
from restitution.oracle.roles import REAL
from restitution.records import dataclass


@dataclass
class Roots(Generators):
    """Generators with the square roots of what they make.

    Letters that are cited as ``nonnegative``, and the sines and cosines of such angles up to 90°,
    are their own size, as are the differences that are ``ordered``: what is cited as greater
    without what is less.
    """

    nonnegative: frozenset[str] = frozenset()
    ordered: set[PolyElement] = field(default_factory=set)

    def root(self, x: Quotient) -> Quotient:
        """The square root of what is not negative, with square factors taken out."""
        x = self.reduced(x)
        if x.vanishes:
            return x
        return self._root(product(x.above, x.below)) / self._size_of(x.below)

    def _size_of(self, polynomial: PolyElement) -> Quotient:
        """The size of a polynomial, by those of its factors."""
        number, factors, sines = self._without_sines(*factors_of(polynomial))
        ratio = _fraction(number)
        total = CONSTANT(abs(ratio)) * sines**2
        for factor, times in factors:
            odd = self._positive(factor) if times % 2 else CONSTANT(1)
            total = total * odd * Quotient(factor, one()) ** (times - times % 2)
        return total

    def put_in_order(self, less: Value, greater: Value) -> None:
        """Takes up that one number is not less than another."""
        if isinstance(less, Plane) or isinstance(greater, Plane):
            return
        gap = greater - less
        number, factors = factors_of(gap.above) if gap.above else (0, [])
        if len(factors) == 1 and factors[0][1] == 1 and gap.below.is_ground:
            self.ordered.add(factors[0][0] if number > 0 else -factors[0][0])

    def _root(self, inside: PolyElement) -> Quotient:
        number, factors, outside = self._without_sines(*factors_of(inside))
        rest = one()
        for factor, times in factors:
            if times // 2:
                outside = outside * self._positive(factor) ** (times // 2)
            if times % 2 and self._is_plainly_positive(factor):
                plain = self._denested(factor)
                if plain is None:
                    plain = self._by_another(factor)
                outside = outside * (self._root_generator(factor) if plain is None else plain)
            elif times % 2:
                rest = rest * factor
        ratio = _fraction(number)
        if rest == 1:
            return outside * self._root_of_number(ratio)
        square, free = square_part(ratio.numerator * ratio.denominator)
        outside = outside * CONSTANT(Fraction(square, ratio.denominator))
        if free < 0:
            rest, free = -rest, -free
        plain = self._denested(rest * free)
        if plain is None:
            plain = self._by_another(rest * free)
        if plain is None:
            plain = self._root_of_number(Fraction(free)) * self._root_generator(rest)
        return outside * plain

    def _without_sines(
        self, number: Fraction, factors: list[tuple[PolyElement, int]]
    ) -> tuple[Fraction, list[tuple[PolyElement, int]], Quotient]:
        """The factors of a polynomial without squares of sines, 1 − cos² 40°, and these sines."""
        counts = dict(factors)
        outside = CONSTANT(1)
        for key, index in list(self._keys.items()):
            if key[0] != "sin" or index not in self.squares or not self._is_positive(key):
                continue
            sign, own = factors_of(self.squares[index])
            if all(counts.get(factor, 0) % 2 for factor, _ in own):
                for factor, times in own:
                    counts[factor] -= times
                number /= sign
                outside = outside * self.generator(key)
        return number, list(counts.items()), outside

    def _by_another(self, inside: PolyElement) -> Quotient | None:
        """√(a + b√c) by another such root, where their product has no root below its root."""
        if self._surd(inside) is None:
            return None
        for _, other in [key for key in self._keys if key[0] == "root"]:
            if other.is_ground or self._surd(other) is None:
                continue
            both = self.reduced(Quotient(product(inside, other), one()))
            if both.below != 1:
                continue
            number = _fraction(both.above.coeff(1)) if both.above.is_ground else None
            plain = self._denested(both.above) if number is None else self._root_of_number(number)
            if plain is not None:
                return plain / Quotient(other, one()) * self.generator(("root", other))
        return None

    def _denested(self, inside: PolyElement) -> Quotient | None:
        """√(a + b√c) as √((a + d)/2) ± √((a − d)/2), where d² = a² − b²c has a rational d."""
        parts = self._surd(inside)
        if parts is None:
            return self._root_of_two_terms(inside)
        a, b, c = parts
        gap = a * a - b * b * c
        if a <= 0 or gap < 0:
            return None
        above, below = isqrt(gap.numerator), isqrt(gap.denominator)
        if above**2 != gap.numerator or below**2 != gap.denominator:
            return None
        d = Fraction(above, below)
        first, second = (self._root_of_number(number) for number in ((a + d) / 2, (a - d) / 2))
        return first + second if b > 0 else first - second

    def _root_of_two_terms(self, inside: PolyElement) -> Quotient | None:
        """√(ax² + 2√(ab) xy + by²) as √a x + √b y, where all of this is positive."""
        if len(inside) != 3 or not self._is_plainly_positive(inside):
            return None
        ends = [
            (powers, _fraction(value))
            for powers, value in inside.terms()
            if not any(power % 2 for power in powers)
        ]
        if len(ends) != 2:
            return None
        root = CONSTANT(0)
        for powers, value in ends:
            term = quotient_ring().from_dict({tuple(power // 2 for power in powers): QQ(1)})
            root = root + self._root_of_number(value) * Quotient(term, one())
        difference = self.reduced(root * root - Quotient(inside, one()))
        return root if difference.vanishes else None

    def _surd(self, polynomial: PolyElement) -> tuple[Fraction, Fraction, Fraction] | None:
        """The a, b and c of a number a + b√c; None for anything else."""
        keys = self.keys(polynomial)
        terms = [(powers, _fraction(value)) for powers, value in polynomial.terms()]
        if len(terms) != 2 or any(
            key[0] != "root" or not key[1].is_ground for key in keys.values()
        ):
            return None
        (powers, b), (last, a) = terms if any(terms[0][0]) else reversed(terms)
        if any(last) or any(power > 1 for power in powers):
            return None
        radicands = [key[1].coeff(1) for number, key in keys.items() if powers[number]]
        return a, b, prod(map(_fraction, radicands), start=Fraction(1))

    def _root_of_number(self, ratio: Fraction) -> Quotient:
        square, free = square_part(ratio.numerator * ratio.denominator)
        total = CONSTANT(Fraction(square, ratio.denominator))
        if free < 0:
            raise NotComparableError("the root of a negative number")
        for prime in primes(free):
            total = total * self._root_generator(quotient_ring().ground_new(QQ(prime)))
        return total

    def higher_root(self, x: Quotient, power: int) -> Quotient:
        """The root of any degree of a positive number. Raises NotComparableError for other values.

        It is a square root as often as its degree is even, and of the rest by primes.
        """
        if not (x.above and x.above.is_ground and x.below.is_ground):
            raise NotComparableError("a root that is not a square root")
        ratio = _fraction(x.above.LC) / _fraction(x.below.LC)
        if ratio < 0:
            raise NotComparableError("the root of a negative number")
        halves = (power & -power).bit_length() - 1
        odd = power >> halves
        root = CONSTANT(Fraction(1, ratio.denominator))
        for prime, times in sp.factorint(ratio.numerator * ratio.denominator ** (odd - 1)).items():
            own = self.generator(("odd-root", odd, prime)) if odd > 1 else CONSTANT(prime)
            if odd > 1:
                self.odd_powers[self._keys["odd-root", odd, prime]] = odd, prime
            root = root * own**times
        root = self.reduced(root)
        for _ in range(halves):
            root = self.root(root)
        return root

    def _root_generator(self, inside: PolyElement) -> Quotient:
        own = self.generator(("root", inside))
        self.squares[self._keys["root", inside]] = inside
        return own

    def _positive(self, factor: PolyElement) -> Quotient:
        """The size of a factor: itself where it is made of positive generators."""
        if self._is_plainly_positive(factor):
            return Quotient(factor, one())
        for value in (factor, -factor):
            if value in self.ordered or self._is_positive_between_ends(value):
                return Quotient(value, one())
        surd = self._surd(factor)
        if surd is not None:
            a, b, c = surd
            leading = a if a * a > b * b * c else b  # the larger of the two has the sign
            return Quotient(factor if leading > 0 else -factor, one())
        own = self.generator(("size", factor))
        self.squares[self._keys["size", factor]] = factor**2
        return own

    def _is_plainly_positive(self, factor: PolyElement) -> bool:
        """Whether a factor is a sum of what is positive, or at least not negative."""
        return all(value > 0 for value in factor.values()) and all(
            self._is_positive(key) for key in self.keys(factor).values()
        )

    def _is_positive_between_ends(self, factor: PolyElement) -> bool:
        """Whether a factor is linear in letters from 0 to 1, and not negative at their ends."""
        bounded = [
            number
            for number, key in self.keys(factor).items()
            if key[0] == "letter"
            and key[1] in self.nonnegative
            and one() - self.generator(key).above in self.ordered
        ]
        if not bounded or any(powers[n] > 1 for powers in factor for n in bounded):
            return False
        for ends in itertools.product((0, 1), repeat=len(bounded)):
            there = quotient_ring().zero
            low = [number for number, end in zip(bounded, ends, strict=True) if not end]
            for powers, value in factor.items():
                if not any(powers[n] for n in low):
                    kept = tuple(0 if n in bounded else power for n, power in enumerate(powers))
                    there = there + quotient_ring().from_dict({kept: value})
            if not self._is_plainly_positive(there):
                return False
        return True

    def _is_positive(self, key: Key) -> bool:
        if key[0] == "letter":
            known = key[1] in self.nonnegative
            return known or self.roles.get(key[1], REAL).kind == "positive"
        if key[0] in ("cos", "sin"):
            terms, degrees = key[1]
            if terms and terms[0] == ():
                return True  # a number of degrees, below 45°
            atom, count = terms[0] if len(terms) == 1 and not degrees and terms[0] else ("", 2)
            return getattr(atom, "name", "") in self.nonnegative and 0 < count <= 1
        return key[0] in ("root", "odd-root", "size")


def _fraction(number: Any) -> Fraction:
    return Fraction(int(number.numerator), int(number.denominator))
