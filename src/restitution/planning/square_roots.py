"""Equations of squares: the root of both sides is taken, and nothing is multiplied out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Link, Move, Relation
from restitution.explaining.trees import rebuilt
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Number,
    letters,
    walk,
)
from restitution.planning.forms import TWO, product, square, swept, tree_of
from restitution.planning.impacts import residual, scene_value
from restitution.planning.premises import background
from restitution.planning.scene import Scene


def root_taken(scene: Scene, number: int, symbol: sp.Symbol) -> int:
    """The line with the root taken of both sides, as a line; the same line where there is none.

    It is taken where both sides are squares, or where the unknown stands in one square of a sum
    alone, and where it is certain which of the two roots it is.
    """
    for shape in _SHAPES:
        taken = shape(scene, number, symbol)
        if taken is not None:
            return taken
    return number


def _of_one_square(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """The unknown stands in the square of one sum: that is made the subject, and its root taken."""
    link = scene.desk.last_link(number)
    sums = {
        each.left
        for side in (link.left, link.right)
        for each in walk(side)
        if _is_square(each) and symbol.name in letters(each)
    }
    if len(sums) != 1:
        return None
    (base,) = sums
    whole = square(base)
    if not (isinstance(base, Binary) and base.op in ("+", "-")):
        return None
    x = sp.Dummy(real=True)
    sides = [rebuilt(each, _replace(whole, Letter("_square"))) for each in (link.left, link.right)]
    if any(symbol.name in letters(each) for each in sides):
        return None
    left, right = (scene_value(scene, each, {"_square": x}) for each in sides)
    gap = sp.expand(left - right)
    if not gap.is_polynomial(x) or sp.degree(gap, x) != 1:
        return None
    value = tidy(-gap.coeff(x, 0) / gap.coeff(x, 1))
    root = tidy(sp.sqrt(value))
    if scene.model.sign(scene_value(scene, base).xreplace(_found(scene))) < 0:
        root = -root
    if root.atoms(sp.Abs) or any(not each.exp.is_Integer for each in root.atoms(sp.Pow)):
        return None
    squared = Relation(((Link(whole, "=", tree_of(value)),),))
    own = number if scene.desk.relation(number) == squared else _write(scene, number, squared)
    if own is None:
        return None
    taken = _write(scene, own, Relation(((Link(base, "=", tree_of(root)),),)))
    if taken is None and own != number:
        scene.desk.lines.pop()
    return taken


def _found(scene: Scene) -> dict[Any, Any]:
    return dict(scene.model.final)


def _of_two_squares(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """Both sides are squares of products."""
    link = scene.desk.last_link(number)
    if symbol.name not in letters(link.left) | letters(link.right):
        return None
    left, right = (_root_of(each) for each in (link.left, link.right))
    if left is None or right is None:
        return None
    relation = Relation(((Link(left, "=", swept(right)),),))
    return _write(scene, number, relation)


def _root_of(tree: Expression) -> Expression | None:
    """The root of a product of squares, as a tree; None for any other."""
    match tree:
        case Binary("^", base, _) if _is_square(tree):
            return base
        case Binary("*" | "/" as op, left, right):
            roots = [_root_of(each) for each in (left, right)]
            if None in roots:
                return None
            if op == "*":
                return product(*roots)  # type: ignore[arg-type]
            return Binary(op, *roots)  # type: ignore[arg-type]
        case Number(value):
            root = sp.sqrt(sp.Rational(value.numerator, value.denominator))
            return tree_of(root) if root.is_Rational else None
    return None


def _is_square(tree: Expression) -> bool:
    return isinstance(tree, Binary) and tree.op == "^" and tree.right == TWO


def _replace(tree: Expression, other: Expression) -> Callable[[Expression], Expression]:
    return lambda each: other if each == tree else each


def _write(scene: Scene, number: int, relation: Relation) -> int | None:
    names = {each.name for each in residual(scene, number).free_symbols}
    for move in (Move("rearrange"), Move("cancel")):
        refs = scene.judge.enough(move, (number,), relation, background(scene, names))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    return None


_SHAPES = (_of_one_square, _of_two_squares)
