"""Bounds of the sine or the cosine of an angle of the motion: by those of the angle itself."""

from __future__ import annotations

from typing import Any, Protocol

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Relation, Sign, turned
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Quantity,
    has_quantity,
    letters,
)
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import tree_of

_INVERSES = {"sin": sp.asin, "cos": sp.acos}


class Writing(Comparing, Protocol):
    """Writes whole inequalities too."""

    def write(self, relation: Relation) -> int:
        """Writes the lines of an inequality that holds; the last says it."""


def write_by_its_angle(claims: Writing, relation: Relation) -> int | None:
    """A bound of the sine or the cosine of an angle, from one of the angle.

    ``sin δ ≤ ⅗`` comes of ``δ ≤ arctan ¾``, ``cos β ≥ cos α`` of ``β ≤ α``. None of another
    inequality, and where the angle has no such bound.
    """
    match relation.options:
        case ((Link(_, "<=" | ">=" | "<" | ">") as link,),):
            pass
        case _:
            return None
    if not _is_of_an_angle(claims, link.left):
        link = turned(link)
    bound = _bound(claims, link) if _is_of_an_angle(claims, link.left) else None
    if bound is None:
        return None
    mark = claims.worths.mark()
    try:
        line = claims.write(Relation(((bound,),)))
    except NotPlannedError:
        line = 0
    if line:
        known = claims.judge.known(letters(bound.right))
        pool = [line, *claims.scene.desk.line(line).premises, *known]
        last = claims.judge.write((Move("compare"),), pool, relation)
        if last is not None:
            return last
    claims.worths.back(mark)
    return None


def _is_of_an_angle(claims: Writing, side: Expression) -> bool:
    """Whether a side is the sine or the cosine of an angle of the motion."""
    match side:
        case Apply("sin" | "cos", Quantity(kind)):
            return kind in UNSIGNED_ANGLES
        case Apply("sin" | "cos", Letter(name)):
            return f"let {name}" in claims.scene.facts
    return False


def _bound(claims: Writing, link: Link) -> Link | None:
    """What a bound of a sine or a cosine says of its angle, where that is at most 90°."""
    assert isinstance(link.left, Apply)
    function, angle = link.left.function, link.left.argument
    sign: Sign = link.sign if function == "sin" else FLIPPED[link.sign]
    match link.right:
        case Apply(own, other) if own == function:
            return Link(angle, sign, other)
        case right if has_quantity(right):
            return None
    value = sp.sympify(claims.scene.scalar(link.right), strict=True)
    if value.is_number and not 0 <= value < 1:
        return None
    return Link(angle, sign, _angle(function, value))


def _angle(function: str, value: Any) -> Expression:
    """An acute angle by its sine or its cosine: in degrees, or as the one of its tangent."""
    if value.is_number:
        own = tree_of(tidy(_INVERSES[function](value)), angle=True)
        if isinstance(own, Degrees):
            return own
    above, below = sp.fraction(sp.together(value))
    other = sp.sqrt(sp.factor(below**2 - above**2))
    return Apply("arctan", tree_of(tidy(above / other if function == "sin" else other / above)))
