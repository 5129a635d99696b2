"""Products of sums with fractions in them, each multiplied out in a line of its own.

In ``(a - 3) a + (2 (6a - 13)/3 + 3)/2 (6a - 13)/3 = 0`` the second product takes more than a look:
it is ``(72a^2 - 258a + 221)/18``, before the whole is a quadratic.
"""

from __future__ import annotations

import sympy as sp

from restitution.expression.tree import Binary, Expression, Letter, Negate, is_binary, walk
from restitution.planning.closing.polynomial_trees import polynomial_tree
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import outer_terms, total, tree_of
from restitution.planning.writing.polynomials import expanded, one_fraction, polynomial_in
from restitution.planning.writing.scene import Scene

_QUADRATIC = 2


def with_products_out(scene: Scene, line: int, *symbols: sp.Symbol) -> int:
    """The line with its products of sums multiplied out; the same one where none has to be.

    It is one where a quotient stands in a sum of a product, and the product is not the only term.
    """
    if len(symbols) != 1:
        return line
    link = scene.desk.last_link(line)
    sides = [list(outer_terms(side)) for side in (link.left, link.right)]
    name = symbols[0].name
    if sum(map(len, sides)) <= 1 or not any(
        _is_nested(term, name) for side in sides for term in side
    ):
        return line
    trees = [[_multiplied(scene, term, symbols[0]) for term in side] for side in sides]
    if any(tree is None for side in trees for tree in side):
        return line
    left, right = (total(tree for tree in side if tree is not None) for side in trees)
    if (left, right) == (link.left, link.right):
        return line
    return in_another_form(scene, line, chain(left, (right, None))) or line


def _multiplied(scene: Scene, term: Expression, symbol: sp.Symbol) -> Expression | None:
    """A term as a polynomial over a number; None of one that is none of up to degree 2."""
    value = expanded(scene_value(scene, term))
    if not value.has(symbol):
        return term
    if not value.is_polynomial(symbol):
        return None
    above, below = sp.fraction(one_fraction(value))
    polynomial = polynomial_in(above, symbol)
    if polynomial.degree() > _QUADRATIC or not all(e.is_Rational for e in polynomial.coeffs()):
        return None
    if polynomial.degree() < _QUADRATIC:
        return term
    negative = bool(polynomial.LC() < 0)
    tree = polynomial_tree(-polynomial if negative else polynomial, Letter(symbol.name))
    whole = tree if below == 1 else Binary("/", tree, tree_of(below))
    return Negate(whole) if negative else whole


def _is_nested(term: Expression, name: str) -> bool:
    """Whether a sum of a product holds a quotient of a sum with the unknown, and another does."""
    sums = [node for node in walk(term) if _is_sum(node, name)]
    quotients = [
        node
        for tree in sums
        for node in walk(tree)
        if is_binary(node, "/") and any(_is_sum(e, name) for e in walk(node))
    ]
    return bool(quotients) and any(
        is_binary(node, "*") and _has(node.left, name) and _has(node.right, name)
        for node in walk(term)
    )


def _is_sum(tree: Expression, name: str) -> bool:
    return is_binary(tree, "+", "-") and _has(tree, name)


def _has(tree: Expression, name: str) -> bool:
    return Letter(name) in walk(tree)


__all__ = ["with_products_out"]
