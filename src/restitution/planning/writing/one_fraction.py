"""Lines between a sum of quotients with different sums below and what that comes to.

First each term by itself, then one fraction with its numerator collected, then its factors: what
cancels is seen.
"""

from __future__ import annotations

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Relation
from restitution.expression.tree import Binary, Expression, has_quantity, is_binary, walk
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
        if not any(alike(tree, form) for form in (right, final, *kept)):
            kept.append(tree)
    return tuple(kept)


def added_up(scene: Scene, subject: Expression, right: Expression, value: sp.Expr) -> Relation:
    """A sum and what it comes to, with the lines between."""
    final = tree_of(value)
    between = over_one_line(scene, right, final)
    return chain(subject, (right, None), *((tree, "rearrange") for tree in (*between, final)))


def multiplied_through(scene: Scene, right: Expression, final: Expression) -> list[Expression]:
    """A quotient of sums of quotients, with both multiplied by the sum with roots below these.

    None where no root stands there: that is one step with what cancels in it.
    """
    if not is_binary(right, "/") or has_quantity(right):
        return []
    divisors = [
        sp.sympify(scene.scalar(node.right), strict=True)
        for node in walk(right)
        if is_binary(node, "/") and node != right
    ]
    sums = [value for value in divisors if value.is_Add and value.free_symbols]
    below = next(iter(sums), sp.Integer(1))
    if not _has_root(below) or any(expanded(e**2 - below**2) != 0 for e in sums):
        return []
    stand_in = sp.Dummy("below", positive=True)
    same = {value: stand_in if expanded(value - below) == 0 else -stand_in for value in sums}
    tops: list[sp.Expr] = []
    for side in (right.left, right.right):
        value = sp.sympify(scene.scalar(side), strict=True)
        top = expanded(
            expanded(value.xreplace({1 / e: 1 / own for e, own in same.items()})) * stand_in
        )
        tops.append(expanded(top.xreplace({stand_in: below})))
    if any(len(top.args) > _MOST_TERMS for top in tops):
        return []
    if all(_leading_sign(top) < 0 for top in tops):
        tops = [-top for top in tops]
    tree = Binary("/", *map(_collected, tops))
    return [] if any(alike(tree, own) for own in (right, final)) else [tree]


def _collected(value: sp.Expr) -> Expression:
    """A sum with what has the same letters put together: ``6 + 2sqrt(3) + (6 + 2sqrt(3)) e``."""
    shares: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(value):
        share, rest = term.as_independent(*value.free_symbols, as_Add=False)
        shares[rest] = shares.get(rest, sp.Integer(0)) + share
    terms: list[Expression] = []
    for rest in sorted(shares, key=lambda own: (sp.total_degree(own), str(own))):
        own = shares[rest]
        tree = product(tree_of(abs(own) if own.is_number else own), tree_of(rest))
        terms.append(negative(tree) if own.is_negative else tree)
    return total(terms)


def _has_root(value: sp.Expr) -> bool:
    return any(power.is_number and not power.exp.is_Integer for power in value.atoms(sp.Pow))


def _leading_sign(value: sp.Expr) -> int:
    """The sign of the term that stands first in a sum: that without a letter, or else any."""
    number, _ = value.as_independent(*value.free_symbols, as_Add=True)
    return -1 if number.is_negative else 1


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


__all__ = ["added_up", "multiplied_through", "over_one_line"]
