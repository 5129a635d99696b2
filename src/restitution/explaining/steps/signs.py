"""Whether a factor may be zero, and what sign it has, under what a line cites."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from collections.abc import Set as AbstractSet
from dataclasses import field
from math import prod
from typing import Literal

from sympy import Rational, pi
from sympy.polys.rings import PolyElement

from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.generators import AngleKey, Key
from restitution.explaining.lines.quotients import (
    Quotient,
    factors_of,
    is_without,
    product,
    without_common,
)
from restitution.oracle import Oracle, Relation, joined, letters_of
from restitution.oracle.roles import REAL
from restitution.records import dataclass

Sign = Literal[1, -1, 0]
"""Positive, negative, or different from zero."""


@dataclass
class Signs:
    """The signs of polynomials of a world; ``oracle`` knows what is cited, and is made late."""

    world: World
    oracle: Callable[[], Oracle]
    _printed: set[PolyElement] | None = field(default=None)
    _noted: int = 0

    def of(self, x: Quotient, sure: bool = True) -> Sign | None:
        """The sign of a quotient; None where it may be zero, or that is open.

        Unless ``sure`` is set, it is enough that the quotient is not zero.
        """
        total: Sign = 1
        for side in (x.above, x.below):
            sign = self._of_polynomial(side, sure)
            if sign is None:
                return None
            total = _times(total, sign)
        return total

    def _of_polynomial(self, polynomial: PolyElement, sure: bool) -> Sign | None:
        if not polynomial:
            return None
        number, factors = factors_of(polynomial)
        total: Sign = 1 if number > 0 else -1
        for factor, times in factors:
            sign = self._factor(factor, sure)
            if sign is None:
                return None
            if times % 2:
                total = _times(total, sign)
        return total

    def _factor(self, factor: PolyElement, sure: bool) -> Sign | None:
        plain = self._plain(factor)
        if plain is not None:
            return plain
        if not sure and self._is_printed(factor):
            return 0
        by_oracle = self._by_oracle(factor, sure)
        if by_oracle is None and self._is_printed(factor):
            return self._weakly(factor)
        return by_oracle

    def _weakly(self, factor: PolyElement) -> Sign:
        """The sign of what is not zero, where it is known to be at least, or at most, zero."""
        oracle = self.oracle()
        value = self.world.expression(Quotient(factor, factor.ring.one), oracle.roles)
        if oracle.proves(Relation(value, ">=")):
            return 1
        return -1 if oracle.proves(Relation(-value, ">=")) else 0

    def _plain(self, factor: PolyElement) -> Sign | None:
        """The sign as the signs of the terms tell it."""
        keys = self.world.keys(factor)
        weights = {n: self._of_key(key) for n, key in keys.items()}
        total: set[int] = set()
        certain = False
        for powers, value in factor.items():
            sign, sure = (1 if value > 0 else -1), True
            for n, power in enumerate(powers):
                if not power:
                    continue
                weight = weights[n]
                if weight is None:
                    if power % 2:
                        return None
                    sure = False
                elif weight == "0+":
                    sure = False
            total.add(sign)
            certain = certain or sure
        if len(total) == 1 and certain:
            return 1 if total == {1} else -1
        return None

    def _of_key(self, key: Key) -> Literal["+", "0+"] | None:
        match key:
            case ("letter", name):
                role = self.oracle().roles.get(name, REAL)
                if role.low is None or not role.low.is_nonnegative:
                    return None
                return "0+" if role.low == 0 and role.closed[0] else "+"
            case ("root" | "size", inside):
                return "+" if inside.is_ground or self._plain(inside) == 1 else "0+"
            case ("cos" | "sin", turn):
                return self._of_turn(turn)
            case ("degree",):
                return "+"
        return None

    def _of_turn(self, turn: AngleKey) -> Literal["+"] | None:
        terms, degrees = turn
        if terms and terms[0] == ():
            return "+"  # a plain angle, below 45°
        if len(terms) != 1 or degrees:
            return None
        ((atom, count),) = terms
        role = self.oracle().roles.get(getattr(atom, "name", ""), REAL)
        if role.low is None or role.high is None or role.kind != "angle":
            return None
        factor = Rational(count.numerator, count.denominator)
        inside = role.low * factor >= 0 and role.high * factor <= pi / 2
        return "+" if inside and not any(role.closed) else None

    def _is_printed(self, factor: PolyElement) -> bool:
        if self._printed is None or self._noted != len(self.world.denominators):
            self._printed, self._noted = set(), len(self.world.denominators)
            for denominator in self.world.denominators:
                for own, _ in factors_of(denominator)[1] if denominator else []:
                    self._printed |= {own, -own}
        return factor in self._printed

    def _by_oracle(self, factor: PolyElement, sure: bool) -> Sign | None:
        oracle = self.oracle()
        if self._takes_any_value(factor, oracle):
            return None
        value = self.world.expression(Quotient(factor, factor.ring.one), oracle.roles)
        if not sure:
            return 0 if oracle.proves(Relation(value, "!=")) else None
        if oracle.proves(Relation(value, ">")):
            return 1
        if oracle.proves(Relation(-value, ">")):
            return -1
        return 0 if oracle.proves(Relation(value, "!=")) else None

    def _takes_any_value(self, factor: PolyElement, oracle: Oracle) -> bool:
        """Whether a factor is linear in what may be any number, and of which nothing is cited."""
        keys = self.world.keys(factor)
        own = symbol_names(*(self.world.symbol(key, oracle.roles) for key in keys.values()))
        cited = letters_of(joined(oracle.about(own).facts))
        for n, key in keys.items():
            if key[0] not in ("letter", "quantity", "x", "y") or self._of_key(key) is not None:
                continue
            role = oracle.roles.get(key[1], REAL) if key[0] == "letter" else REAL
            name = str(self.world.symbol(key, oracle.roles))
            free = role.low is None and role.high is None and name not in cited
            if free and max(m[n] for m in factor) == 1:
                return True
        return False


def _times(a: Sign, b: Sign) -> Sign:
    return 0 if not a or not b else 1 if a == b else -1


def ratio(world: World, line: Quotient, expected: Quotient) -> Quotient | None:
    """k, where ``line = k expected`` and k is made of no more than the two must have.

    None where either of them is zero. k is in lowest form, roots aside.
    """
    if line.vanishes or expected.vanishes or _strangers(world, line, expected):
        return None
    by_root = _ratio_of_leads(world, line, expected) or _ratio_with_a_divisor(world, line, expected)
    if by_root is not None:
        return by_root
    lowest = [Quotient(*without_common(x.above, x.below)) for x in (line, expected)]
    if world.squares and lowest != [line, expected]:
        return ratio(world, *lowest)
    above, below = without_common(line.above, expected.above)
    if not is_without(below, expected.above):  # they have no factor in common that could vanish
        return _ratio_with_a_root(world, line, expected) or _squared(world, line, expected)
    under, over = without_common(line.below, expected.below)
    return Quotient(*without_common(above * over, below * under))


def _squared(world: World, line: Quotient, expected: Quotient) -> Quotient | None:
    """K where a line is a = b with a root in it, both sides squared: a + b, without its factors."""
    one = expected.above.ring.one
    for root, key in world.keys(expected.above).items():
        if key[0] != "root" or key[1].is_ground:
            continue
        other = expected.above.ring.from_dict(
            {m: -v if m[root] % 2 else v for m, v in expected.above.items()}
        )
        whole = world.reduced(Quotient(expected.above * other, one))
        product = whole.above * line.below
        above, below = without_common(line.above * whole.below, product)
        if is_without(below, product):
            return Quotient(above * other * expected.below, below)
    return None


def _strangers(world: World, line: Quotient, expected: Quotient) -> bool:
    """Whether one of two has a quantity that the other has not: the quick way out."""
    ours, theirs = (set(world.keys(x.above)) for x in (line, expected))
    names = world.keys_by_number()
    return any(
        names[n][0] in ("quantity", "x", "y") and not all(m[n] for m in x.above)
        for x, own in ((line, ours - theirs), (expected, theirs - ours))
        for n in own
    )


def _ratio_of_leads(world: World, line: Quotient, expected: Quotient) -> Quotient | None:
    """K as the ratio of two terms, where there are roots: their common factors are not seen."""
    if not world.squares:
        return None
    a, b = line.above, expected.above
    roots = set(world.squares)
    # Of a sum that is a factor of one of them alone, such as 1 + k, every term leads.
    apart = set(world.keys(a)) ^ set(world.keys(b))
    # The square of a sine is one of its cosine: neither of them leads alone.
    names = world.keys_by_number()
    angles = {names[n][1] for n in roots if names[n][0] == "sin"}
    cosines = {n for n, (kind, *own) in names.items() if kind == "cos" and own[0] in angles}
    choices: tuple[set[int], ...] = (set(), apart, cosines, apart | cosines)
    for silent in dict.fromkeys(frozenset(roots | own) for own in choices):
        lead_a, lead_b = _lead(a, silent), _lead(b, silent)
        whole = silent != roots and (lead_a, lead_b) == (a, b)
        if whole and (silent - roots - apart or not _have_common(a, b)):
            continue  # any two are each other times the ratio of all their terms
        if world.reduced(Quotient(product(a, lead_b) - product(b, lead_a), a.ring.one)).vanishes:
            above, below = without_common(lead_a * expected.below, lead_b * line.below)
            return Quotient(above, below)
    return None


def _have_common(a: PolyElement, b: PolyElement) -> bool:
    return is_without(without_common(a, b)[1], b)


def _ratio_with_a_divisor(world: World, line: Quotient, expected: Quotient) -> Quotient | None:
    """K where one of two is the other times what is printed below a line and has roots in it."""
    roots = set(world.squares)
    divisors = (
        divisor
        for divisor in dict.fromkeys(world.denominators)
        if len(divisor) > 1 and not roots.isdisjoint(world.keys(divisor))
    )
    return _ratio_with(world, line, expected, divisors) if roots else None


def _ratio_with_a_root(world: World, line: Quotient, expected: Quotient) -> Quotient | None:
    """K where one of two is the other times roots that stand in it: their squares are no roots."""
    keys = world.keys(line.above, expected.above)
    roots = [n for n, key in keys.items() if key[0] == "root" and not key[1].is_ground]
    sets = (roots, *([n] for n in roots if len(roots) > 1)) if roots else ()
    gens = line.above.ring.gens
    products = (prod((gens[n] for n in own), start=line.above.ring.one) for own in sets)
    return _ratio_with(world, line, expected, products)


def _ratio_with(
    world: World, line: Quotient, expected: Quotient, factors: Iterable[PolyElement]
) -> Quotient | None:
    """K where one of two is the other times one of some factors."""
    one = line.above.ring.one
    for factor in factors:
        for a, b in ((factor, one), (one, factor)):
            sides = [
                world.reduced(Quotient(product(quotient.above, times), one))
                for quotient, times in ((line, a), (expected, b))
            ]
            k = None if any(side.vanishes for side in sides) else _ratio_of_leads(world, *sides)
            if k is not None:
                above, below = k.above * b * expected.below, k.below * a * line.below
                return Quotient(*without_common(above, below))
    return None


def _lead(polynomial: PolyElement, silent: AbstractSet[int]) -> PolyElement:
    """The terms with the leading powers of all generators but some."""
    key = max(tuple(0 if n in silent else p for n, p in enumerate(m)) for m in polynomial)
    terms = {
        m: value
        for m, value in polynomial.items()
        if tuple(0 if n in silent else p for n, p in enumerate(m)) == key
    }
    return polynomial.ring.from_dict(terms)
