"""Between what a letter is: by a line that says it, or by the given conditions, solved for it."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Relation, Sign, turned
from restitution.expression.tree import Binary, Expression, Letter, Number
from restitution.planning.inequalities.claims import Claims
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import tree_of
from restitution.solving.story.letters import roles

_End = tuple[sp.Expr, bool]


def ranges_of(claims: Claims, letter: str) -> Iterator[int]:
    """The lines that say between what a letter is; without one, that by the given conditions."""
    standing = claims.ranges_of(letter)
    yield from standing
    if not standing:
        mark = claims.worths.mark()
        line = _by_conditions(claims, letter)
        if line is None:
            claims.worths.back(mark)
            claims.conditions.clear()
        else:
            yield line


def _by_conditions(claims: Claims, letter: str) -> int | None:
    """The range of a letter that the given conditions leave; None where they leave it alone."""
    role = roles(claims.scene.problem)[letter]
    if role.low is None or role.high is None or role.kind == "angle":
        return None
    low, high = zip((role.low, role.high), role.closed, strict=True)
    narrowed = False
    for number in claims.conditions.lines(Letter(letter)):
        relation = claims.scene.desk.relation(number)
        if len(relation.options) != 1:
            return None
        for link in relation.only:
            bound = _bound(claims, link, letter)
            if bound is None:
                continue
            sign, end = bound
            narrowed = True
            if sign[0] == ">" and claims.scene.model.sign(end - low[0]) > 0:
                low = end, len(sign) == 2
            if sign[0] == "<" and claims.scene.model.sign(high[0] - end) > 0:
                high = end, len(sign) == 2
    if not narrowed:
        return None
    signs: list[Sign] = ["<=" if closed else "<" for _, closed in (low, high)]
    own = Letter(letter)
    links = (Link(tree_of(low[0]), signs[0], own), Link(own, signs[1], tree_of(high[0])))
    try:
        return claims.write(Relation((links,)))
    except NotPlannedError:
        return None


def _bound(claims: Claims, link: Link, letter: str) -> tuple[Sign, sp.Expr] | None:
    """The sign and the end of a bound of a letter, or of its square; None of anything else."""
    for bound in (link, turned(link)):
        if bound.sign not in ("<", "<=", ">", ">="):
            return None
        value = sp.sympify(claims.scene.scalar(bound.right), strict=True)
        if letter in symbol_names(value):
            continue
        if bound.left == Letter(letter):
            return bound.sign, value
        if _is_square(bound.left, letter):
            return bound.sign, tidy(sp.sqrt(value))
    return None


def _is_square(tree: Expression, letter: str) -> bool:
    match tree:
        case Binary("^", Letter(name), Number(power)):
            return name == letter and power == 2
    return False


__all__ = ["ranges_of"]
