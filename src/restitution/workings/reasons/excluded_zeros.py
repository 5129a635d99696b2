"""Letters that are not zero, as an inequality of which they are factors would not hold there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from restitution.explaining.lines.derivation import Relation
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression, Letter, has_quantity, is_binary, walk
from restitution.oracle.roles import REAL, Role
from restitution.planning.writing.forms import factors


def is_divided_by(letter: Letter, relation: Relation) -> bool:
    """Whether a letter is a factor of what is divided by in a relation."""
    sides = (side for links in relation.options for e in links for side in (e.left, e.right))
    below = (node.right for side in sides for node in walk(side) if is_binary(node, "/"))
    return any(letter in factors(tree) for tree in below)


def excludes_zero(
    letter: Letter, inequalities: Iterable[Relation], roles: Mapping[str, Role]
) -> bool:
    """Whether one of some strict inequalities is seen not to hold where a letter is zero."""
    return any(
        _fails_at_zero(letter.name, own.only[0].left, own.only[0].sign, own.only[0].right, roles)
        for own in inequalities
        if len(own.options) == 1 and len(own.only) == 1
    )


def _fails_at_zero(
    name: str, left: Expression, sign: str, right: Expression, roles: Mapping[str, Role]
) -> bool:
    if sign not in (">", "<") or has_quantity(left) or has_quantity(right):
        return False
    a, b = (evaluate(side, lambda n: roles.get(n, REAL).symbol(n)) for side in (left, right))
    gap = sp.sympify(a - b if sign == ">" else b - a, strict=True)
    own = next((symbol for symbol in gap.free_symbols if symbol.name == name), None)
    return own is not None and sp.expand(gap.subs(own, 0)).is_nonpositive is True
