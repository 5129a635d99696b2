"""Equations with squares of a cosine and quotients in its tangent: by the tangent alone.

``cos² α − (p/q)² cos² α = k``, with the tangent in p and q, is divided by cos² α, and 1/cos² α is
1 + tan² α. Where that is a factor of all terms it goes: no equation of the fourth degree stands.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.explaining.lines.derivation import Link, Move, Relation, Sign, equality
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import Apply, Expression, Letter, walk
from restitution.planning.writing.forms import ZERO, total, tree_of
from restitution.planning.writing.polynomials import expanded, polynomial_in
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene

_T = sp.Symbol("t", positive=True)
_SQUARE = polynomial_in(1 + _T**2, _T)
# The degree of an equation that people solve.
_MOST = 2


def write_in_tangents(scene: Scene, line: int, symbol: sp.Symbol) -> tuple[int, sp.Expr] | None:
    """The quadratic in the tangent: its line, and its value. None of another equation."""
    link = scene.desk.last_link(line)
    tangent = Apply("tan", Letter(symbol.name))
    if not any(tangent in walk(side) for side in (link.left, link.right)):
        return None
    left, right = (_terms(scene.scalar(e), symbol) for e in (link.left, link.right))
    if left is None or right is None:
        return None
    powers: dict[sp.Expr, sp.Expr] = {}
    for term in (*left, *right):
        for base, power in sp.fraction(term)[1].as_powers_dict().items():
            powers[base] = max(power, powers.get(base, power))
    below = sp.Mul(*(base**power for base, power in powers.items() if base.has(_T)))
    left, right = ([value * below for value in side] for side in (left, right))
    gap = expanded(sp.Add(*left) - sp.Add(*right))
    if not below.has(_T) or not gap.is_polynomial(_T):
        return None
    quotient, remainder = sp.div(sp.Poly(gap, _T, extension=True), _SQUARE)
    if not remainder.is_zero or quotient.degree() != _MOST:
        return None
    steps = [(left, right)]
    factors = _difference_of_squares(left)
    if factors is not None and len(right) == 1:
        common = _SQUARE.as_expr()
        steps.append(([sp.Mul(*factors, common, evaluate=False)], right))
        steps.append(([sp.Mul(*factors, evaluate=False)], [right[0] / common]))
    mark, known = scene.desk.mark(), background(scene, {symbol.name})
    number: int | None = line
    for step in steps:
        relation = Relation(((Link(*_sides(step, symbol)),),))
        moves = (Move("identity", "pythagoras"),) if step is steps[0] else _STEPS
        number = number and scene.judge.write(moves, (number, *known), relation)
    value = quotient.monic().as_expr()
    value = expanded(value * sp.ilcm(1, *(sp.fraction(e)[1] for e in quotient.monic().coeffs())))
    last = equality(_in_tangent(value, symbol), ZERO)
    number = number and scene.judge.write(_STEPS, (number, *known), last)
    if number is None:
        scene.desk.back(mark)
        return None
    return number, value.subs(_T, sp.tan(symbol))


_STEPS = (Move("rearrange"), Move("cancel"))


def _terms(side: sp.Expr, symbol: sp.Symbol) -> list[sp.Expr] | None:
    """The terms of a side over cos², in the tangent; None where a term is no such quotient."""
    c = sp.Dummy("c", positive=True)
    put = {sp.sin(symbol): _T * c, sp.tan(symbol): _T, sp.cos(symbol): c}
    terms: list[sp.Expr] = []
    for term in sp.Add.make_args(side):
        own = term.xreplace(put)
        # The number stays in front of the sum.
        rest = own / c**2 if own.has(c) else sp.Mul(own, _SQUARE.as_expr(), evaluate=False)
        if rest.free_symbols - {_T}:
            return None
        terms.append(rest)
    return terms


def _difference_of_squares(terms: Sequence[sp.Expr]) -> tuple[sp.Expr, sp.Expr] | None:
    """p² − q² over 1 + t²: what is left of one factor, and the other; None of other terms."""
    if len(terms) != 2:
        return None
    (one, power), (other, second) = terms[0].as_base_exp(), (-terms[1]).as_base_exp()
    if power != second or power != _MOST or not (one * other).is_polynomial(_T):
        return None
    roots = one, other
    factors = [sp.Poly(expanded(roots[0] + k * roots[1]), _T, extension=True) for k in (-1, 1)]
    for one, other in (factors, factors[::-1]):
        whole, remainder = sp.div(other, _SQUARE)
        if remainder.is_zero and whole.degree() == 0:
            return whole.as_expr(), one.as_expr()
    return None


def _sides(
    step: tuple[Sequence[sp.Expr], Sequence[sp.Expr]], symbol: sp.Symbol
) -> tuple[Expression, Sign, Expression]:
    left, right = (total(_in_tangent(value, symbol) for value in side) for side in step)
    return left, "=", right


def _in_tangent(value: sp.Expr, symbol: sp.Symbol) -> Expression:
    """A value with the tangent in place of its letter."""
    tangent = Apply("tan", Letter(symbol.name))
    return rebuilt(tree_of(value, as_it_is=True), lambda e: tangent if e == Letter("t") else e)
