"""Sums in coefficients of restitution in which nothing is taken away but from 1."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.expression.tree import Binary, Expression
from restitution.planning.writing.forms import ONE, multiple, total, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles

Powers = tuple[int, ...]


def never_negative(scene: Scene, x: sp.Expr) -> Expression | None:
    """A sum as one of products that are seen not to be negative: 3 + e + 9e(1 − e).

    Of 3 + 10e − 9e² it is. None where nothing is taken away, where it is one difference from 1,
    where a letter is no coefficient of restitution, or where too much is taken away.
    """
    symbols = sorted(x.free_symbols, key=lambda symbol: symbol.name)
    known = roles(scene.problem)
    if not symbols or any(
        symbol.name not in known or known[symbol.name].kind != "restitution" for symbol in symbols
    ):
        return None
    poly = sp.Poly(expanded(x), *symbols)
    if not all(share.is_Rational for share in poly.coeffs()) or len(poly.terms()) < 3:
        return None
    left = {powers: share for powers, share in poly.terms() if share > 0}
    taken = [(powers, -share) for powers, share in poly.terms() if share < 0]
    if not taken:
        return None
    products: list[Expression] = []
    for powers, needed in taken:
        divisors = [other for other in left if _divides(other, powers)]
        for other in sorted(divisors, key=lambda own: (-sum(own), own)):
            share = min(left[other], needed)
            if share > 0:
                missing = tuple(a - b for a, b in zip(powers, other, strict=True))
                away = Binary("-", ONE, tree_of(_monomial(symbols, missing)))
                products.append(multiple(share * _monomial(symbols, other), away))
                left[other], needed = left[other] - share, needed - share
        if needed > 0:
            return None
    rest = sp.Add(*(share * _monomial(symbols, own) for own, share in left.items()))
    return total([*([tree_of(rest)] if rest != 0 else []), *products[::-1]])


def _divides(powers: Powers, others: Powers) -> bool:
    return powers != others and all(a <= b for a, b in zip(powers, others, strict=True))


def _monomial(symbols: Sequence[sp.Symbol], powers: Powers) -> sp.Expr:
    return sp.Mul(*(symbol**power for symbol, power in zip(symbols, powers, strict=True)))
