"""Factors of polynomials: those that SymPy finds, and no draw that never ends."""

from __future__ import annotations

import random

import sympy
from sympy.core import random as draws
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement, PolyRing

from restitution.exact.irreducible import factor_list
from restitution.exact.products import in_factors

LETTERS = [*sympy.symbols("u v", positive=True), sympy.Symbol("e", nonnegative=True)]
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
        assert factor_list(a) == a.factor_list()


def test_a_square_of_a_letter_splits_where_its_discriminant_is_a_square() -> None:
    x, y, z, w = RING.gens
    for a, factors in (
        (x**2 * y**2 - 2 * z**2 * w**2, [(x**2 * y**2 - 2 * z**2 * w**2, 1)]),
        (x**2 * y**2 - 4 * z**2, [(x * y - 2 * z, 1), (x * y + 2 * z, 1)]),
        ((x**2 + y**2) * (y**2 + 1) * 3, [(y**2 + 1, 1), (x**2 + y**2, 1)]),
        ((x * y**2 + z) ** 2, [(x * y**2 + z, 2)]),
        (x**2 * y**2, [(y, 2), (x, 2)]),
    ):
        assert factor_list(a)[1] == factors


def _rational(rng: random.Random, depth: int) -> sympy.Expr:
    if depth == 0:
        return rng.choice([*LETTERS, sympy.S(2), sympy.S(-3), sympy.Rational(3, 4)])
    left, right = _rational(rng, depth - 1), _rational(rng, depth - 1)
    kind = rng.randrange(6)
    if kind < 2:
        return left + right
    if kind < 4:
        return left * right
    return left**2 if kind == 4 or right == 0 else left / right


def test_expressions_are_factored_as_by_sympy() -> None:
    rng = random.Random(8)
    for _ in range(80):
        value = _rational(rng, rng.choice([2, 3, 3, 4]))
        if not value.has(sympy.zoo, sympy.nan):
            assert in_factors(value) == sympy.factor(value), value


def test_what_is_no_quotient_of_polynomials_is_left_to_sympy() -> None:
    u, v, e = LETTERS
    for value in (
        sympy.sqrt(3) * u + 3 * v,
        (u**2 - v**2) * sympy.Abs(u + v),
        sympy.sqrt(u**2 * v + u**2),
        sympy.sqrt(12) / 4,
        u ** (1 + e),
        sympy.zoo * u,
    ):
        assert in_factors(value) == sympy.factor(value)


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
