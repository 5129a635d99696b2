"""An unknown in one bracket, beside numbers with roots or angles: the bracket is made the subject.

Multiplied out, 117 = (96 + 50√3)(1 − e) would have two sums with roots in it.
"""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import Binary, Expression, Letter, letters, walk
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import IN_PLACE, coefficients_in_place, expanded
from restitution.planning.writing.scene import Scene


def bracket_alone(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """The line with the only bracket in which an unknown stands as its subject, as a line.

    None where it stands elsewhere, or beside plain numbers and letters alone.
    """
    link = scene.desk.last_link(number)
    brackets = [
        node
        for side in (link.left, link.right)
        for node in walk(side)
        if _is_bracket(node, symbol.name)
    ]
    if link.sign != "=" or len(brackets) != 1 or brackets[0] in (link.left, link.right):
        return None
    (bracket,) = brackets
    sides = [
        rebuilt(side, lambda tree: Letter("_sum") if tree == bracket else tree)
        for side in (link.left, link.right)
    ]
    if any(symbol.name in letters(side) for side in sides):
        return None
    left, right = (scene_value(scene, side, {"_sum": IN_PLACE}) for side in sides)
    parts = coefficients_in_place(left - right)
    if parts is None or len(parts) != 2:
        return None
    above, below = -parts[0], parts[1]
    if scene.model.sign(below) < 0:
        above, below = expanded(-above), expanded(-below)
    value = above / below
    if not value.is_number or value.is_Rational:
        return None
    tree = tree_of(value, as_it_is=not value.has(sp.sin, sp.cos))
    return in_another_form(scene, number, chain(bracket, (tree, None)))


def _is_bracket(tree: Expression, name: str) -> bool:
    """Whether a tree is a sum of a number and a multiple of a letter."""
    match tree:
        case Binary("+" | "-", left, right):
            return letters(tree) == {name} and not (letters(left) and letters(right))
    return False


__all__ = ["bracket_alone"]
