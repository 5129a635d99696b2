"""Factors of polynomials: those that SymPy finds, and no draw that never ends."""

from __future__ import annotations

import random

from sympy.core import random as draws
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement, PolyRing

from restitution.exact.irreducible import factor_list

RING = PolyRing(["x", "y", "z", "w"], QQ)


def _product(rng: random.Random) -> PolyElement:
    product = RING.one * QQ(rng.choice([1, -2, 3, -5]), rng.choice([1, 2, 7]))
    for _ in range(rng.randint(1, 3)):
        factor = RING.zero
        for _ in range(rng.randint(1, 4)):
            powers = tuple(rng.choice([0, 0, 0, 1, 1, 2]) for _ in range(4))
            factor[powers] = QQ(rng.choice([-4, -3, -1, 1, 2]), rng.choice([1, 1, 3]))
        product *= factor ** rng.choice([1, 1, 1, 2])
    return product


def test_the_factors_are_those_of_sympy() -> None:
    rng = random.Random(3)
    for _ in range(150):
        a = _product(rng)
        number, factors = factor_list(a)
        other, others = a.factor_list()
        assert number == other
        assert sorted(map(str, factors)) == sorted(map(str, others))


def test_no_draw_is_unlucky() -> None:
    """With these draws an image of the polynomial splits, and SymPy lifts its factors for hours."""
    ring = PolyRing([f"x{n}" for n in range(11)], QQ)
    x, y, *letters = ring.gens
    a = sum((k * x ** (8 - n) * y**n for n, k in enumerate(letters)), -x) - 3
    draws.seed(241)
    assert factor_list(a) == (1, [(a, 1)])


def test_draws_of_others_go_on_where_they_were() -> None:
    x, y, *_ = RING.gens
    draws.seed(7)
    expected = [draws.rng.random() for _ in range(4)]
    draws.seed(7)
    drawn = []
    for _ in range(4):
        assert len(factor_list((x**2 * y**2 + 3) * (x**2 - 5 * y**2 + 1))[1]) == 2
        drawn.append(draws.rng.random())
    assert drawn == expected
