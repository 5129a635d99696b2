"""Quotients of sums with quotients in them, each as one fraction before both sides multiply out.

``(tan α + (tan α)/e)/(1 − (tan²α)/e)`` is ``(1 + e) tan α/(e − tan²α)``.
"""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.expression.tree import Expression, is_binary, letters, walk
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import cancelled, factored
from restitution.planning.writing.scene import Scene

# One quotient inside a side is multiplied away in the head.
_SEVERAL = 2


def with_plain_quotients(scene: Scene, line: int) -> int:
    """The line with each such side as one fraction; the same line where there is none."""
    link = scene.desk.last_link(line)
    if not any(map(_is_of_quotients, (link.left, link.right))):
        return line
    left, right = (
        _as_one(scene, side) if _is_of_quotients(side) else side for side in (link.left, link.right)
    )
    return in_another_form(scene, line, chain(left, (right, None))) or line


def _is_of_quotients(tree: Expression) -> bool:
    """Whether a side is a quotient in which several quotients by letters stand."""
    if not is_binary(tree, "/"):
        return False
    quotients = [e for side in (tree.left, tree.right) for e in walk(side) if is_binary(e, "/")]
    return sum(bool(letters(e.right)) for e in quotients) >= _SEVERAL


def _as_one(scene: Scene, tree: Expression) -> Expression:
    value = sp.sympify(scene_value(scene, tree), strict=True)
    return tree_of(tidy(factored(cancelled(value))))


__all__ = ["with_plain_quotients"]
