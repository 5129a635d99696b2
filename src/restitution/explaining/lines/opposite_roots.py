"""Two values that differ in their sign alone, and the equation of squares that has both."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Link, Relation, equality
from restitution.explaining.lines.trees import squared
from restitution.expression.tree import Negate


def root_but_for_sign(options: tuple[tuple[Link, ...], ...]) -> Link | None:
    """The positive one of two roots that differ in their sign alone."""
    if len(options) != 2 or any(len(option) != 1 or option[0].sign != "=" for option in options):
        return None
    (one,), (two,) = options
    if one.left != two.left:
        return None
    if two.right == Negate(one.right):
        return one
    return two if one.right == Negate(two.right) else None


def as_squares(relation: Relation) -> Relation | None:
    """``v = ±a`` as v² = a²; None of any other relation."""
    root = root_but_for_sign(relation.options)
    return None if root is None else equality(squared(root.right), squared(root.left))


__all__ = ["as_squares", "root_but_for_sign"]
