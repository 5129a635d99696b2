"""A ratio that is to be shown with an angle: its tangent is put in, or its squares are."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Relation
from restitution.expression.tree import Apply, Binary, Expression, Letter, Quantity
from restitution.planning.angles.expressions import formula_of_squares
from restitution.planning.closing.squared_ratios import KINDS, write_by_squares
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import product, square, total, tree_of
from restitution.planning.writing.polynomials import cancelled, expanded


def ratio_by_a_tangent(worths: Worths, link: Link, lines: Sequence[int]) -> int | None:
    """The line cos²α (1 + tan²β) of a ratio, from cos²α + e² sin²α and tan β = e tan α.

    ``lines`` are those of the two quantities and of the tangent. None of another ratio.
    """
    desk = worths.scene.desk
    tangents = [number for number in lines if _is_tangent(desk.last_link(number).left)]
    others = [number for number in lines if number not in tangents]
    if len(tangents) != 1 or not isinstance(link.left, Binary) or link.left.op != "/":
        return None
    (tangent,) = tangents
    own = desk.last_link(tangent)
    ratio = worths.value(own.right)
    angles = {sine.args[0] for sine in ratio.atoms(sp.sin, sp.cos, sp.tan)}
    if len(angles) != 1:
        return None
    (angle,) = angles
    ratio = ratio.subs(sp.tan(angle), sp.sin(angle) / sp.cos(angle))
    factor = cancelled(ratio * sp.cos(angle) / sp.sin(angle))
    mark = worths.mark()
    first = worths.valued(link.left, Move("divide"), others)
    if first is None or factor.has(sp.sin, sp.cos):
        worths.back(mark)
        return None
    t = sp.Dummy("t")
    value = worths.value(desk.last_link(first).right)
    inside = expanded(cancelled(value.subs(sp.sin(angle), t * sp.cos(angle)) / sp.cos(angle) ** 2))
    put = expanded(inside.subs(t, t / factor))
    if put.has(sp.cos(angle), sp.sin(angle)) or put.free_symbols != {t}:
        worths.back(mark)
        return None
    poly = sp.Poly(put, t)
    terms: list[Expression] = []
    for (power,), share in reversed(poly.terms()):
        tree = own.left if power == 1 else square(own.left)
        terms.append(product(tree_of(tidy(share)), *([tree] if power else [])))
    if poly.degree() != 2:
        worths.back(mark)
        return None
    right = product(square(tree_of(sp.cos(angle))), total(terms))
    relation = Relation(((Link(link.left, "=", right),),))
    known = worths.known_in(value)
    line = worths.judge.write((Move("put"),), [first, tangent, *known], relation)
    if line is None:
        worths.back(mark)
    return line


def _is_tangent(tree: Expression) -> bool:
    return isinstance(tree, Apply) and tree.function == "tan" and isinstance(tree.argument, Letter)


__all__ = ["ratio_by_a_tangent"]


def shown_by_squares(worths: Worths, link: Link, quantities: Sequence[Quantity]) -> int | None:
    """An energy, or a speed, by the squares of the ratios of an angle; None of another equation."""
    unknowns = worths.scene.model.unknowns.roles
    open_ = {
        unknowns[symbol.name].kind for symbol in worths.scene.model.final if symbol.name in unknowns
    }
    if "angle" not in open_ or any(quantity.kind not in KINDS for quantity in quantities):
        return None
    mark = worths.mark()
    for quantity in quantities:
        worths.determine_angle(quantity)
    line = write_by_squares(worths.scene, link.left, formula_of_squares, link.right)
    if line is None:
        worths.back(mark)
    return line
