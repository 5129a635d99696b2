"""Generators of polynomials: one for each letter, quantity, root, cosine and sine of lines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from fractions import Fraction
from itertools import chain, compress
from typing import Any, TypeAlias

from sympy.polys.rings import PolyElement

from restitution.explaining.lines.quotients import (
    MOST_GENERATORS,
    MOST_TERMS,
    NotComparableError,
    Plane,
    Quotient,
    lean,
    one,
    product,
    quotient_ring,
    total,
)
from restitution.expression.tree import Expression
from restitution.oracle.roles import Role
from restitution.records import dataclass

Value = Quotient | Plane

Atom: TypeAlias = Expression | tuple[str, PolyElement, PolyElement]
"""A part of an angle: a letter, an angle of the motion, or an inverse function by its value."""

AngleKey: TypeAlias = tuple[tuple[Any, ...], Fraction]
"""An angle by its parts with their multiples, and degrees; a plain angle has one empty part."""

Key: TypeAlias = tuple[Any, ...]
"""A generator: what it is ("letter", "quantity", "cos", "root", …), and of what."""


_NUMBERS = range(MOST_GENERATORS)


@dataclass
class Generators:
    """The generators in which some trees are compared, and the squares of some of them.

    ``roles`` says what a letter of the statement may be. While ``printed`` is set, what stands
    below a line is kept among the ``denominators``, which are not zero; what stands below the
    ``tangents`` of a line counts only where it stays.
    """

    roles: Mapping[str, Role]
    printed: bool = True
    squares: dict[int, PolyElement] = field(default_factory=dict)
    odd_powers: dict[int, tuple[int, int]] = field(default_factory=dict)
    """Of the roots of numbers that are no square roots: which power is which number."""
    denominators: list[PolyElement] = field(default_factory=list)
    tangents: list[PolyElement] = field(default_factory=list)
    _keys: dict[Key, int] = field(default_factory=dict)
    _below_roots: set[int] = field(default_factory=set)

    def generator(self, key: Key) -> Quotient:
        """The generator of a letter, a quantity, a root or a cosine."""
        if key not in self._keys:
            if len(self._keys) == MOST_GENERATORS:
                raise NotComparableError("lines of too many letters")
            if key[0] in ("root", "size"):
                self._below_roots.update(self.keys(key[1]))
            self._keys[key] = len(self._keys)
        return Quotient(quotient_ring().gens[self._keys[key]], one())

    def stands_below_roots(self, number: int) -> bool:
        """Whether a generator occurs in what another is the root, or the size, of."""
        return number in self._below_roots

    def keys_by_number(self) -> dict[int, Key]:
        """All generators, by number."""
        return dict(enumerate(self._keys))

    def keys(self, *polynomials: PolyElement) -> dict[int, Key]:
        """The generators that occur, by number."""
        every = list(self._keys)
        occurring = (
            compress(_NUMBERS, powers) for polynomial in polynomials for powers in polynomial
        )
        return {n: every[n] for n in dict.fromkeys(chain.from_iterable(occurring))}

    def note_tangents(self, line: Value) -> None:
        """Keep the cosines below the tangents of a line, as far as they do not cancel there."""
        parts = (line.x, line.y) if isinstance(line, Plane) else (line,)
        for cosine in self.tangents:
            if any(not part.below.is_ground and not part.below.rem(cosine) for part in parts):
                self.denominators.append(cosine)
        self.tangents.clear()

    def reduced(self, x: Quotient) -> Quotient:
        """The quotient with squares of roots (and of sines, where Pythagoras is named) put in."""
        if not self.squares and not self.odd_powers:
            return x
        return lean(self._reduced(x.above), self._reduced(x.below))

    def reduced_value(self, x: Value) -> Value:
        """A scalar or a vector with squares of roots put in."""
        if isinstance(x, Plane):
            return Plane(self.reduced(x.x), self.reduced(x.y))
        return self.reduced(x)

    def _reduced(self, polynomial: PolyElement) -> PolyElement:
        for number, (power, whole) in self.odd_powers.items():
            if any(powers[number] >= power for powers in polynomial):
                put_in = quotient_ring().zero
                for powers, value in polynomial.items():
                    times, left = divmod(powers[number], power)
                    rest = (*powers[:number], left, *powers[number + 1 :])
                    put_in = total(put_in, polynomial.new({rest: value * whole**times}))
                polynomial = put_in
        for number in sorted(self.squares, reverse=True):
            square = self.squares[number]
            while any(powers[number] > 1 for powers in polynomial):
                parts: dict[int, dict[tuple[int, ...], Any]] = {}
                for powers, value in polynomial.items():
                    half, odd = divmod(powers[number], 2)
                    rest = (*powers[:number], odd, *powers[number + 1 :])
                    parts.setdefault(half, {})[rest] = value
                put_in = quotient_ring().zero
                for half, terms in parts.items():
                    times = square**half if half else one()
                    put_in = total(put_in, product(polynomial.new(terms), times))
                polynomial = put_in
                if len(polynomial) > MOST_TERMS:
                    raise NotComparableError("a line of too many terms")
        return polynomial
