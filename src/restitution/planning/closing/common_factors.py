"""A sum such as 1 + e that every term of an equation to zero has as a factor."""

from __future__ import annotations

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move, equality
from restitution.expression.tree import Negate
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.writing.forms import ZERO, outer_terms, total, tree_of
from restitution.planning.writing.polynomials import cancelled, factored
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def sums_above(value: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """The sums that are factors of the upper part of a quotient, each with its power."""
    powers = (factor.as_base_exp() for factor in sp.Mul.make_args(value))
    return {base: power for base, power in powers if base.is_Add and power.is_Integer and power > 0}


def without_common_factor(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """The line of a sum that is zero, divided by what all its terms have in common.

    None unless that is a sum with the unknown, certain not to vanish, and more than one term is
    left with it.
    """
    trees = list(outer_terms(scene.desk.last_link(number).left))
    terms = [factored(scene_value(scene, tree)) for tree in trees]
    if len(terms) < 2 or not all(term.is_polynomial(symbol) for term in terms):
        return None
    shared = dict(sums_above(terms[0]))
    for term in terms[1:]:
        own = sums_above(term)
        shared = {base: min(power, own[base]) for base, power in shared.items() if base in own}
    sums = {
        base: power
        for base, power in shared.items()
        if symbol in base.free_symbols and proved_sign(scene.model.ground, base)
    }
    if not sums:
        return None
    common = sp.Mul(*(base**power for base, power in sums.items()))
    rest = [factored(term / common).as_coeff_Mul() for term in terms]
    numbers = [number_ for number_, _ in rest]
    common *= sp.Rational(sp.igcd(*(n.p for n in numbers)), sp.ilcm(*(n.q for n in numbers)))
    common *= sp.gcd_list([term for _, term in rest])
    left = [cancelled(term / common) for term in terms]
    if all(isinstance(tree, Negate) for tree in trees):
        left = [-value for value in left]
    if not any(symbol in value.free_symbols for value in left):
        return None
    relation = equality(total(tree_of(factored(value)) for value in left), ZERO)
    known = background(scene, symbol_names(sp.Mul(*sums)))
    refs = scene.judge.enough(Move("cancel"), (number,), relation, known)
    return None if refs is None else scene.desk.write(Move("cancel"), refs, relation)


__all__ = ["sums_above", "without_common_factor"]
