"""Equations and relations between whatever has a layout."""

from __future__ import annotations

from typing import Any

from restitution.expression import tree as trees
from restitution.render.layout.algebra import from_sympy
from restitution.render.layout.nodes import SIGNS, Layout, Relation, Words
from restitution.render.layout.statements import from_tree


def equation(*sides: Any) -> Relation:
    """Sides with ``=`` between them; each a layout, a SymPy expression or a number."""
    return Relation(tuple(as_layout(side) for side in sides), ("=",) * (len(sides) - 1))


def relation(first: Any, *rest: Any) -> Relation:
    """A chain such as ``relation(0, "<", e, "<=", 1)``."""
    signs = tuple(SIGNS.get(sign, sign) for sign in rest[0::2])
    return Relation(tuple(as_layout(side) for side in (first, *rest[1::2])), signs)


def as_layout(value: Any) -> Layout:
    """A layout as it is; a tree as written; anything else by way of SymPy; text as words."""
    if isinstance(value, Layout):
        return value
    if isinstance(value, str):
        return Words(value)
    if isinstance(value, trees.Expression):
        return from_tree(value)
    return from_sympy(value)
