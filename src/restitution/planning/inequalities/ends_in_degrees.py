"""Ends of ranges in ratios of degrees, which have many forms: the one to which the lines come."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.explaining.lines.derivation import FLIPPED, Link, Relation, turned
from restitution.expression.tree import (
    Apply,
    Expression,
    has_quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.planning.inequalities.claims import Claims
from restitution.planning.writing.desk import UNPLANNED

_RATIOS = (sp.sin, sp.cos, sp.tan)
_DIGITS = 60
_CLOSE = sp.Float("1e-50", _DIGITS)


def with_ends_of_lines(claims: Claims, asked: Expression, relation: Relation) -> Relation | None:
    """A range with its ends as the conditions of the part have them, where these are others.

    ``tan 20°/tan 50°`` and ``(2 cos 20° − 1)/(2 cos 20° + 1)`` are one number, which no identity
    of one angle shows. None where no end is such a number, or the lines have no other form.
    """
    if len(relation.options) != 1:
        return None
    ends = [end for link in relation.only for end in (link.left, link.right) if end != asked]
    if not any(map(_is_irrational, ends)):
        return None
    mark = claims.worths.mark()
    forms: list[Link] = []
    try:
        lines = claims.conditions.lines(asked)
    except UNPLANNED:
        claims.worths.back(mark)
        claims.conditions.clear()
        return None
    for line in lines:
        own = claims.scene.desk.relation(line)
        if len(own.options) == 1:
            bounds = (link for link in own.only if link.sign in FLIPPED)
            forms += (link if link.left == asked else turned(link) for link in bounds)
    links = tuple(_with_ends(claims, asked, link, forms) for link in relation.only)
    return None if links == relation.only else Relation((links,))


def _with_ends(claims: Claims, asked: Expression, link: Link, forms: list[Link]) -> Link:
    """One end of a range in the form of a line that bounds the same in the same sense."""
    own = link if link.left == asked else turned(link)
    if not _is_irrational(own.right):
        return link
    value = claims.worths.value(own.right)
    for form in forms:
        if form.left != asked or form.sign != own.sign or form.right == own.right:
            continue
        other = claims.worths.value(form.right)
        if not value.has(*_RATIOS) and not _has_ratio_of_a_sum(form.right):
            continue
        if other.is_number and abs(sp.N(other, _DIGITS) - sp.N(value, _DIGITS)) < _CLOSE:
            put = replace(own, right=form.right)
            return put if own == link else turned(put)
    return link


def _is_irrational(end: Expression) -> bool:
    """Whether an end is a number with roots, or with ratios of degrees."""
    known = not letters(end) and not has_quantity(end)
    return known and any(isinstance(node, Apply) for node in walk(end))


def _has_ratio_of_a_sum(end: Expression) -> bool:
    """Whether a number has the ratio of a sum of angles: tan(70° − arctan(4/3))."""
    return any(
        is_function(node, "tan") and is_binary(node.argument, "+", "-") for node in walk(end)
    )


__all__ = ["with_ends_of_lines"]
