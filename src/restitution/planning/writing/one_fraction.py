"""Lines between a sum of quotients with different sums below and what that comes to.

First each term by itself, then one fraction with its numerator collected, then its factors: what
cancels is seen.
"""

from __future__ import annotations

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Relation
from restitution.expression.tree import Binary, Expression, has_quantity, is_binary
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import (
    alike,
    factors,
    negative,
    outer_terms,
    product,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import cancelled, expanded, factored
from restitution.planning.writing.scene import Scene

# Longer sums are no help to a reader.
_MOST_TERMS = 6


def over_one_line(scene: Scene, right: Expression, final: Expression) -> tuple[Expression, ...]:
    """The lines between a sum of quotients and its value; none where that is one step."""
    terms = list(outer_terms(right))
    if len(terms) == 1 or has_quantity(right):
        return ()
    try:
        lines = _lines([sp.sympify(scene.scalar(term), strict=True) for term in terms])
    except (RestitutionError, TypeError, ValueError, sp.PolynomialError):
        return ()
    kept: list[Expression] = []
    for tree in lines:
        if not any(alike(tree, each) for each in (right, final, *kept)):
            kept.append(tree)
    return tuple(kept)


def added_up(scene: Scene, subject: Expression, right: Expression, value: sp.Expr) -> Relation:
    """A sum and what it comes to, with the lines between."""
    final = tree_of(value)
    between = over_one_line(scene, right, final)
    return chain(subject, (right, None), *((tree, "rearrange") for tree in (*between, final)))


def _lines(terms: list[sp.Expr]) -> list[Expression]:
    values = [factored(cancelled(term)) for term in terms]
    parts = [sp.fraction(value) for value in values]
    below = factored(sp.lcm_list([expanded(bottom) for _, bottom in parts]))
    sums = _sums(below)
    if len({frozenset(_sums(bottom)) for _, bottom in parts}) == 1 or not sums:
        return []  # terms with the same sums below are added in one step
    above = [factored(cancelled(top * below / bottom)) for top, bottom in parts]
    common = factored(sp.gcd_list([expanded(value) for value in above]))
    rest = expanded(sum(cancelled(value / common) for value in above))
    inner = factored(rest)
    if inner.as_coeff_Mul()[0].is_negative:
        common, rest, inner = -common, -rest, -inner
    if len(_sums(inner)) < len(sp.Mul.make_args(inner)) or not _sums(inner) & sums:
        return []  # nothing cancels
    if not rest.is_Add or len(rest.args) > _MOST_TERMS:
        return []
    trees = total(map(_signed, values))
    inside = tree_of(rest, as_it_is=True), tree_of(inner)
    return [trees, *(_quotient(common, tree, below) for tree in inside)]


def _sums(value: sp.Expr) -> set[sp.Expr]:
    """The sums that are factors, whatever their power."""
    bases = (factor.as_base_exp()[0] for factor in sp.Mul.make_args(value))
    return {base for base in bases if base.is_Add and base.free_symbols}


def _signed(value: sp.Expr) -> Expression:
    if value.as_coeff_Mul()[0].is_negative:
        return negative(tree_of(-value))
    return tree_of(value)


def _quotient(common: sp.Expr, inner: Expression, below: sp.Expr) -> Expression:
    """One fraction, of which the sums above stand beside each other in brackets."""
    own = [*factors(tree_of(common)), *factors(inner)]
    sums = [tree for tree in own if is_binary(tree, "+", "-")]
    rest = [tree for tree in own if tree not in sums]
    return Binary("/", product(*sums, *rest), tree_of(below))


__all__ = ["added_up", "over_one_line"]
