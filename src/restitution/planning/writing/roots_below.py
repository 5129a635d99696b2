"""Quotients of numbers that keep their roots below, where without them the numbers are long."""

from __future__ import annotations

import sympy as sp

from restitution.expression.tree import (
    Binary,
    Expression,
    Number,
    is_function,
    letters,
    walk,
)
from restitution.planning.writing.forms import product, swept, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene

# Whole numbers from here on are longer than those of a quotient with roots below.
_LONG = 1000


def in_shorter_form(scene: Scene, quotient: Expression, final: Expression) -> Expression:
    """What a quotient comes to: with roots below, where without them whole numbers are long.

    ``2(103 + 10√3)/(3(361 − 20√3))`` is as exact as ``2(37783 + 5670√3)/387363``.
    """
    match quotient:
        case Binary("/", above, below) if _is_long(final):
            first, second = (sp.factor_terms(expanded(scene.scalar(e))) for e in (above, below))
        case _:
            return final
    (p, one), (q, other) = (
        value.as_independent(*value.free_symbols, as_Add=False) for value in (first, second)
    )
    if one != other:
        return final
    (p, first), (q, second) = (expanded(value).as_content_primitive() for value in (p, q))
    share = sp.Rational(p / q)
    shorter = Binary(
        "/",
        product(tree_of(sp.Integer(share.p)), tree_of(first)),
        product(tree_of(sp.Integer(share.q)), tree_of(second)),
    )
    return final if _is_long(shorter) else swept(shorter)


def _is_long(number: Expression) -> bool:
    """Whether a number with roots has whole numbers of four or more figures."""
    nodes = list(walk(number))
    roots = any(is_function(node, "sqrt") for node in nodes)
    values = (node.value for node in nodes if isinstance(node, Number))
    return roots and not letters(number) and any(abs(value) >= _LONG for value in values)


__all__ = ["in_shorter_form"]
