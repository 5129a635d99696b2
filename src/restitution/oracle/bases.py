"""Angles as multiples of a few, so that algebra knows what holds between them."""

from __future__ import annotations

import sympy as sp

MOST_MULTIPLE = 6
"""No angle is more than so many times another one, for this purpose."""


def bases_of(angles: set[sp.Rational]) -> list[sp.Rational]:
    """Few angles of which the others are multiples, but for right angles: 25° for 25°, 50°, 65°.

    All are given as multiples of π. So what holds between them is known to algebra.
    """
    bases: list[sp.Rational] = []
    left = set(angles)
    while left:
        best: tuple[tuple[int, int, int], sp.Rational, set[sp.Rational]] | None = None
        for base in sorted({x / n for x in left for n in (1, 2)}):
            counts = {x: n for x in left if (n := multiple_of(x, base)) is not None}
            order = (-len(counts), sum(map(abs, counts.values())), int(base.q))
            if best is None or order < best[0]:
                best = order, base, set(counts)
        assert best is not None
        bases.append(best[1])
        left -= best[2]
    return bases


def multiple_of(angle: sp.Rational, base: sp.Rational) -> int | None:
    """So many times a base, and some right angles, are an angle; all as multiples of π."""
    for size in range(1, MOST_MULTIPLE + 1):
        for n in (size, -size):
            if (2 * (angle - n * base)).is_Integer:
                return n
    return None
