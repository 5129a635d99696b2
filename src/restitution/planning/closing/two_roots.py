"""Equations with two roots in which an unknown stands, and a number besides: squared twice.

One root and the number stand on one side, so that nothing is negative; what is squared has one
root, which is alone on a side before both are squared once more.
"""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Relation, equality
from restitution.expression.tree import Apply, Expression, is_function, walk
from restitution.planning.formulas.impacts import residual, scene_value
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.forms import difference, multiple, total, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene

_TWO = sp.Integer(2)


def squared_apart(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """The line of the squares of an equation with two roots and more; None of another equation."""
    terms = _terms(scene, number, symbol)
    if terms is None:
        return None
    roots, rest = terms
    signs = [scene.model.sign(scene.model.in_data(share)) for _, share in roots]
    if 0 in signs or scene.model.sign(scene.model.in_data(rest)) == 0:
        return None
    (one, a), (other, b) = (
        (tree, share * sign) for (tree, share), sign in zip(roots, signs, strict=True)
    )
    rest = expanded(rest * signs[0])
    if signs[0] == signs[1]:
        near, far = (other, b, -1), (one, a)  # a√f = −rest − b√g
        rest = -rest
    elif scene.model.sign(scene.model.in_data(rest)) > 0:
        near, far = (one, a, 1), (other, b)  # a√f + rest = b√g
    else:
        near, far = (other, b, 1), (one, a)
        rest = -rest
    root, share, sign = near
    with_rest = _joined(multiple(tidy(share), root), tree_of(tidy(rest)), sign)
    apart = equality(multiple(tidy(far[1]), far[0]), with_rest)
    link = scene.desk.last_link(number)
    if {link.left, link.right} != {apart.only[0].left, with_rest}:
        line = in_another_form(scene, number, apart)
        if line is None:
            return None
        number = line
    squared = [
        expanded(share**2 * scene_value(scene, tree) ** 2) for tree, share in ((root, share), far)
    ]
    middle = multiple(tidy(expanded(_TWO * share * rest)), root)
    whole = total([_of_square(share, root, squared[0]), tree_of(tidy(rest**2))])
    whole = total([whole, middle]) if sign > 0 else difference(whole, middle)
    relation = equality(_of_square(far[1], far[0], squared[1]), whole)
    return _written(scene, number, relation)


def _terms(
    scene: Scene, number: int, symbol: sp.Symbol
) -> tuple[list[tuple[Expression, sp.Expr]], sp.Expr] | None:
    """Two roots with the unknown, each with its share, and what else there is of an equation."""
    link = scene.desk.last_link(number)
    if link.sign != "=":
        return None
    whole = expanded(residual(scene, number))
    roots = [p for p in whole.atoms(sp.Pow) if p.exp == sp.S.Half and p.has(symbol)]
    if len(roots) != _TWO:
        return None
    roots.sort(key=str)
    names = [sp.Dummy(positive=True) for _ in roots]
    bare = whole.xreplace(dict(zip(roots, names, strict=True)))
    if symbol in bare.free_symbols or not bare.is_polynomial(*names):
        return None
    poly = sp.Poly(bare, *names)
    if set(poly.monoms()) != {(1, 0), (0, 1), (0, 0)}:
        return None
    own: list[tuple[Expression, sp.Expr]] = []
    for root, share in zip(roots, (poly.nth(1, 0), poly.nth(0, 1)), strict=True):
        own.append(_as_it_stands(scene, number, root, share))
    return own, poly.nth(0, 0)


def _as_it_stands(
    scene: Scene, number: int, root: sp.Expr, share: sp.Expr
) -> tuple[Expression, sp.Expr]:
    """A root as the line has it, with the share that it has in that form."""
    link = scene.desk.last_link(number)
    for node in (*walk(link.left), *walk(link.right)):
        if is_function(node, "sqrt"):
            times = sp.cancel(scene_value(scene, node) / root)
            if times.is_rational_function() and not times.free_symbols & root.free_symbols:
                return node, tidy(share / times)
    return Apply("sqrt", tree_of(root.base)), share


def _of_square(share: sp.Expr, root: Expression, value: sp.Expr) -> Expression:
    """The square of a root, as a sum of squares; multiplied out where it has a share."""
    return tree_of(value) if share != 1 or not isinstance(root, Apply) else root.argument


def _joined(root: Expression, rest: Expression, sign: int) -> Expression:
    return total([root, rest]) if sign > 0 else difference(rest, root)


def _written(scene: Scene, number: int, relation: Relation) -> int | None:
    return scene.judge.write((Move("rearrange"),), (number,), relation)
