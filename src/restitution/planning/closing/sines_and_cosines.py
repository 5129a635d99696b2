"""``a cos θ + b sin θ = c``: one of them alone on a side, and both sides squared."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Relation, turned
from restitution.planning.closing.ratios import functions_of
from restitution.planning.formulas.impacts import residual, scene_value
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import ONE, difference, multiple, square, tree_of
from restitution.planning.writing.polynomials import numerator, polynomial_in
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene

Step = tuple[tuple[Move, ...], Relation]
"""What a line says, and the moves of which one makes it."""

_MOVES = (Move("rearrange"), Move("identity", "pythagoras"))


def squared_ratio(scene: Scene, line: int, symbol: sp.Symbol) -> int | None:
    """The line in one ratio of an angle that both of them and a number made of degree one.

    ``cos α = √3(1 − sin α)`` becomes ``1 − sin²α = 3(1 − sin α)²``, where it is certain that both
    sides of that have one sign. None of another equation.
    """
    s, c = sp.sin(symbol), sp.cos(symbol)
    own = residual(scene, line)
    functions = functions_of(scene, own, symbol)
    if functions is None or not {s, c} <= functions <= {s, c, sp.tan(symbol)}:
        return None
    form = _of_degree_one(own, symbol)
    if form is None:
        return None
    known = background(scene, [symbol.name])
    mark = scene.desk.mark()
    sides = [side for side in _sides(scene, line) if not side.is_number]
    apart = [ratio for ratio in (c, s) if any((side / ratio).is_number for side in sides)]
    for alone, other in ((c, s), (s, c)) if apart != [s] else ((s, c), (c, s)):
        number: int | None = line
        steps = _steps(form, alone, other)
        # It may stand alone on a side already.
        for moves, relation in steps[2:] if alone in apart else steps:
            both = (relation, _turned(relation)) if alone in apart else (relation,)
            written = (scene.judge.write(moves, [number, *known], own) for own in both if number)
            number = next(filter(None, written), None)
        if number is not None:
            return number
        scene.desk.back(mark)
    return None


def _turned(relation: Relation) -> Relation:
    """An equation with its sides exchanged."""
    return Relation((tuple(map(turned, relation.only)),))


def _sides(scene: Scene, line: int) -> list[sp.Expr]:
    """What the sides of a line are worth."""
    link = scene.desk.last_link(line)
    return [sp.sympify(scene_value(scene, side), strict=True) for side in (link.left, link.right)]


def _of_degree_one(x: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """An equation as ``a cos θ + b sin θ − c``, with sin² + cos² = 1; None of another one."""
    s, c = sp.sin(symbol), sp.cos(symbol)
    above = numerator(sp.together(x.subs(sp.tan(symbol), s / c)))
    poly = polynomial_in(above, s, c)
    if poly.total_degree() == 2:
        # The squares of both make a number.
        both = poly.nth(2, 0)
        if both != poly.nth(0, 2) or poly.nth(1, 1) != 0:
            return None
        poly = polynomial_in(poly.as_expr() - both * (s**2 + c**2) + both, s, c)
    terms = poly.nth(0, 1), poly.nth(1, 0), poly.nth(0, 0)
    if poly.total_degree() != 1 or 0 in terms or not all(term.is_number for term in terms):
        return None
    return poly.as_expr()


def _steps(form: sp.Expr, alone: sp.Expr, other: sp.Expr) -> list[Step]:
    """One ratio on a side, both sides squared, and the square by that of the other one."""
    poly = sp.Poly(form, alone, other)
    form = form if poly.nth(1, 0).is_positive else -form
    slope, number = abs(poly.nth(1, 0)), -form.subs({alone: 0, other: 0})
    sense = 1 if number.is_positive else -1
    whole = chain(tree_of(tidy(sense * (form + number))), (tree_of(tidy(sense * number)), None))
    rest = tidy(sp.factor_terms(slope * alone - form))
    parted = chain(tree_of(tidy(slope * alone)), (tree_of(rest), None))
    coefficient, sums = rest.as_independent(*rest.free_symbols, as_Add=False)
    right = multiple(tidy(coefficient**2), square(tree_of(sums)))
    squared = chain(multiple(tidy(slope**2), square(tree_of(alone))), (right, None))
    by_other = difference(ONE, square(tree_of(other)))
    last = chain(multiple(tidy(slope**2), by_other), (right, None))
    return [(_MOVES, whole), (_MOVES[:1], parted), (_MOVES[:1], squared), (_MOVES[1:], last)]
