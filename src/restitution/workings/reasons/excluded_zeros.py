"""Letters that are not zero, as an inequality of which they are factors would not hold there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from restitution.explaining.lines.derivation import Link, Relation
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression, Letter, has_quantity, is_binary, walk
from restitution.oracle.roles import REAL, Role
from restitution.planning.writing.forms import factors


def is_divided_by(divisor: Expression, sides: Iterable[Expression]) -> bool:
    """Whether a tree is a factor of what is divided by in one of some trees."""
    below = (node.right for side in sides for node in walk(side) if is_binary(node, "/"))
    return any(divisor in factors(tree) for tree in below)


def excludes_zero(
    letter: Letter, inequalities: Iterable[Relation], roles: Mapping[str, Role]
) -> bool:
    """Whether one of some strict inequalities is seen not to hold where a letter is zero."""
    return any(
        _fails_at_zero(letter.name, own.only[0], roles)
        for own in inequalities
        if len(own.options) == 1 and len(own.only) == 1
    )


def _fails_at_zero(name: str, link: Link, roles: Mapping[str, Role]) -> bool:
    sides = link.left, link.right
    if link.sign not in (">", "<") or any(map(has_quantity, sides)):
        return False
    a, b = (evaluate(side, lambda n: roles.get(n, REAL).symbol(n)) for side in sides)
    gap = sp.sympify(a - b if link.sign == ">" else b - a, strict=True)
    own = next((symbol for symbol in gap.free_symbols if symbol.name == name), None)
    return own is not None and sp.expand(gap.subs(own, 0)).is_nonpositive is True
