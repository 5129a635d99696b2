"""Which sign a polynomial can have throughout a box of values: one look at a few points of it.

What has both signs there has no sign that its coefficients could show, and need not be asked.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import prod
from typing import TypeAlias

from sympy.polys.rings import PolyElement

Bounds: TypeAlias = tuple[Fraction | None, Fraction | None, bool, bool]
"""Between which numbers a generator lies, and whether it may be these."""

POINTS = 5
FEWEST_TERMS = 8
"""Of fewer terms the coefficients are quicker asked."""
# A sum of floats that is less than this part of its terms may have either sign.
_CLOSE = 1e-9


def possible_senses(
    polynomial: PolyElement,
    names: Sequence[str],
    senses: Mapping[str, str],
    between: Mapping[str, Bounds],
) -> tuple[int, ...]:
    """The signs, 1 and -1, that a polynomial may have at all values of its generators.

    ``names`` are those of the generators in their order; one that is not ``real`` by its sense is
    not negative.
    """
    if len(polynomial) < FEWEST_TERMS:
        return 1, -1
    rng = random.Random(17)
    left = {1, -1}
    for _ in range(POINTS):
        point = [_value(senses[name], between.get(name), rng) for name in names]
        try:
            terms = [
                float(c) * prod(x**n for x, n in zip(point, powers, strict=True) if n)
                for powers, c in polynomial.terms()
            ]
        except OverflowError:
            continue
        total = sum(terms)
        if abs(total) > _CLOSE * sum(map(abs, terms)):
            left.discard(-1 if total > 0 else 1)
        if not left:
            break
    return tuple(sorted(left, reverse=True))


def _value(sense: str, bounds: Bounds | None, rng: random.Random) -> float:
    """A value that a generator may have, not at an end."""
    share = rng.uniform(0.02, 0.98)
    low, high = (None, None) if bounds is None else bounds[:2]
    if low is not None and high is not None:
        return float(low) + share * float(high - low)
    spread = share / (1 - share)
    if low is not None:
        return float(low) + spread
    if high is not None:
        return float(high) - spread
    return spread if sense != "real" else spread * rng.choice((1, -1))


__all__ = ["possible_senses"]
