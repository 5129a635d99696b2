"""What is left to a bound, where its sign is not seen: what it is at the ends of letters.

There it is a square, or the difference of a letter and a bound that is given of it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product as combinations

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import Expression, Letter, is_binary, walk
from restitution.oracle.roles import ACUTE
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.forms import factors, outer_terms, total, tree_of
from restitution.planning.writing.polynomials import derivative, expanded, polynomial_in
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles

_MOVES = (Move("sign"), Move("compare"))


def write_least(
    claims: Comparing, difference: int, known: tuple[Ref, ...], sign: Sign
) -> int | None:
    """The line that what is left is at least a square: (1 + k)² − 4ek ≥ (1 + k)² − 4k = (1 − k)².

    Or it is more than what a bound given of a letter makes positive, as k ≥ 1 does of
    1 + k − (1 + e) cos α > 1 + k − 2 = k − 1. It is a factor of what a line comes to. None where
    each factor shows its sign, or comes to neither.
    """
    scene = claims.scene
    right = scene.desk.last_link(difference).right
    sums = [e for e in walk(right) if is_binary(e, "+", "-") and e in _above(right)]
    open_ = [(tree, scene.scalar(tree)) for tree in sums]
    open_ = [(tree, x) for tree, x in open_ if not _is_evident(scene, x)]
    if len(open_) != 1 or proved_sign(scene.model.inside, open_[0][1]) != 1:
        return None
    ((tree, own),) = open_
    worst = dict(_worst_ends(scene, own))
    whole = sp.factor(expanded(own).subs(worst))
    if not worst or _is_evident(scene, whole.expand()):
        return None
    if not _is_of_squares(scene, whole) and not _is_of_given_bounds(scene, whole):
        return None
    first, last = _put(scene, tree, worst), tree_of(whole)
    orders: tuple[Sign, ...] = (">", ">=") if sign == ">" else (">=",)
    for order in orders:
        links = [Link(tree, order, first)]
        links += [Link(first, "=", last, "rearrange")] if first != last else []
        line = claims.judge.write(_MOVES, known, Relation((tuple(links),)))
        if line is not None:
            return line
    return None


def of_both_squares(scene: Scene, gap: sp.Expr) -> sp.Expr | None:
    """``(1 − f²) cos²α + (1 − e²) sin²α`` for ``1 − f² cos²α − e² sin²α``: both signs are seen.

    None where sin² + cos² = 1 does not make a sum so, and where the sum shows its sign as it is.
    """
    whole = sp.factor(gap)
    sums = [e for e in sp.Mul.make_args(sp.fraction(whole)[0]) if e.is_Add]
    open_ = [e for e in sums if not _is_evident(scene, e)]
    angles = {ratio.args[0] for own in open_ for ratio in own.atoms(sp.sin, sp.cos)}
    if len(open_) != 1 or len(angles) != 1:
        return None
    (own,), (angle,) = open_, angles
    sine, cosine = sp.Dummy("s"), sp.Dummy("c")
    put = {sp.sin(angle) ** 2: sine, sp.cos(angle) ** 2: cosine}
    x = expanded(own).subs(put)
    if x.has(sp.sin, sp.cos) or polynomial_in(x, sine, cosine).total_degree() != 1:
        return None
    rest = x.subs({sine: 0, cosine: 0})
    shares = [expanded(rest + x.coeff(e)) for e in (cosine, sine)]
    signs = {proved_sign(scene.model.inside, sp.factor(share)) for share in shares}
    if 0 in shares or signs not in ({1}, {-1}) or not all(_is_evident(scene, e) for e in shares):
        return None
    (sign,) = signs
    first, second = sign * shares[0] * sp.cos(angle) ** 2, sign * shares[1] * sp.sin(angle) ** 2
    return sp.Mul(sign * whole / own, first + second)


def is_of_a_given_gap(scene: Scene, gap: sp.Expr) -> bool:
    """Whether a difference has a factor of which an inequality between letters gives the sign."""
    factors_ = {own for own in sp.Mul.make_args(sp.factor(gap)) if own.is_Add}
    for fact in scene.facts.values():
        if fact.kind not in ("given", "range") or len(fact.relation.options) != 1:
            continue
        for link in fact.relation.only:
            sides = (link.left, link.right)
            if link.sign not in FLIPPED or not all(isinstance(e, Letter) for e in sides):
                continue
            apart = scene.scalar(link.left) - scene.scalar(link.right)
            if factors_ & {apart, -apart}:
                return True
    return False


def _above(tree: Expression) -> list[Expression]:
    """The factors above the line of a quotient, or of a product."""
    return factors(tree.left) if is_binary(tree, "/") else factors(tree)


def _put(scene: Scene, tree: Expression, worst: dict[sp.Expr, sp.Expr]) -> Expression:
    """A sum with the ends of letters put into those of its terms that have them."""
    terms: list[Expression] = []
    for term in outer_terms(tree):
        value = scene.scalar(term)
        there = expanded(value).subs(worst)
        terms.append(term if there == expanded(value) else tree_of(sp.factor(there)))
    return total(terms)


def _generators(scene: Scene, x: sp.Expr) -> Iterator[sp.Expr]:
    """The coefficients, sines and cosines, or squares of these, that are from 0 to 1."""
    known = roles(scene.problem)
    for symbol in sorted(x.free_symbols, key=str):
        role = known.get(symbol.name)
        if role is not None and (role.low, role.high) == (0, 1):
            yield symbol
    for ratio in sorted(x.atoms(sp.sin, sp.cos), key=str):
        if not x.subs(ratio**2, sp.Dummy()).has(ratio):
            yield ratio**2
        elif known.get(str(ratio.args[0])) == ACUTE:
            yield ratio


def _worst_ends(scene: Scene, x: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """At which end of each coefficient, or of a ratio or its square, an expression is least."""
    for generator in _generators(scene, x):
        inside = sp.Dummy("x", positive=True)
        slope = derivative(x.subs(generator, inside), inside).subs(inside, generator)
        sign = proved_sign(scene.model.inside, sp.factor(slope))
        if sign:
            yield generator, sp.Integer(0 if sign > 0 else 1)


def _is_evident(scene: Scene, x: sp.Expr) -> bool:
    """Whether a sum has terms of one sign alone, at each end of what lies between 0 and 1."""
    bounded = list(_generators(scene, x))
    signs: set[bool] = set()
    for ends in combinations((0, 1), repeat=len(bounded)):
        there = expanded(x.subs(dict(zip(bounded, ends, strict=True))))
        terms = sp.Add.make_args(there) if there != 0 else ()
        signs |= {bool(term.could_extract_minus_sign()) for term in terms}
    return len(signs) < 2


def _is_of_squares(scene: Scene, x: sp.Expr) -> bool:
    """Whether a product has squares, and factors that show their sign, alone."""
    above, below = sp.fraction(x)
    return all(
        factor.as_base_exp()[1] % 2 == 0 or not factor.is_Add or _is_evident(scene, factor)
        for factor in (*sp.Mul.make_args(above), *sp.Mul.make_args(below))
    )


def _is_of_given_bounds(scene: Scene, x: sp.Expr) -> bool:
    """Whether the factors of a product that show no sign are linear in a letter that is bounded."""
    own = [e for e in sp.Mul.make_args(x) if e.is_Add and not _is_evident(scene, e)]
    return bool(own) and all(
        len(e.free_symbols) == 1
        and all(scene.judge.ranges_given(s.name) and sp.degree(e, s) == 1 for s in e.free_symbols)
        for e in own
    )


__all__ = ["is_of_a_given_gap", "of_both_squares", "write_least"]
