"""Bounds in degrees of acute angles of the data: by those of their tangents, sines or cosines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    letters,
)
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.writing.forms import square, tree_of

_RATIOS = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan}


def bound_by_a_ratio(claims: Comparing, relation: Relation, pool: Sequence[Ref]) -> int | None:
    """A bound in degrees by that of a ratio: of the one that is bounded already, or the tangent."""
    bound = _of_an_acute_angle(claims, relation)
    if bound is None:
        return None
    letter, sign, angle = bound
    ratio = _bounded_ratio(claims, letter, pool)
    most = tidy(_RATIOS[ratio.function](angle))
    if ratio.function == "cos":
        sign = FLIPPED[sign]
    mark = claims.worths.mark()
    line = next(_bounding(claims, ratio, sign, most), None)
    if line is None:
        of_ratio = Relation(((Link(ratio, sign, tree_of(most)),),))
        line = claims.judge.write((Move("compare"), Move("sign")), pool, of_ratio)
    if line is not None:
        known = claims.judge.known([letter.name])
        line = claims.judge.write((Move("compare"),), [line, *known], relation)
        if line is not None:
            return line
    claims.worths.back(mark)
    return None


def bound_that_stands(claims: Comparing, relation: Relation) -> int | None:
    """A bound in degrees, by a bound of the tangent in letters that stands."""
    bound = _of_an_acute_angle(claims, relation)
    if bound is None:
        return None
    letter, sign, angle = bound
    tangent, most = Apply("tan", letter), tidy(sp.tan(angle))
    for subject, end in ((tangent, most), (square(tangent), most**2)):
        for number, own in _bounds_of(claims, subject):
            if own.sign[0] != sign[0] or not letters(own.right):
                continue
            mark = claims.worths.mark()
            pool = [number, *claims.judge.known(letters(own.right))]
            near = Relation(((own, Link(own.right, sign, tree_of(end))),))
            first = claims.judge.write((Move("compare"),), pool, near)
            line = None if first is None else claims.compared([first], relation)
            if line is not None:
                return line
            claims.worths.back(mark)
    return None


def _of_an_acute_angle(
    claims: Comparing, relation: Relation
) -> tuple[Letter, Sign, sp.Expr] | None:
    """The letter of an acute angle that is bounded in degrees, the sign, and the bound."""
    match relation.options:
        case ((Link(Letter(name) as letter, sign, Degrees(value)),),) if 0 < value < 90:
            if claims.judge.bounds(name) == (f"acute: {name}",):
                return letter, sign, sp.rad(sp.Rational(value.numerator, value.denominator))
    return None


def _bounds_of(claims: Comparing, subject: Expression) -> Iterator[tuple[int, Link]]:
    """The lines in force that bound an expression, each with what it says."""
    for line in claims.scene.desk.lines:
        match line.relation:
            case Relation(((Link(left, sign) as own,),)) if left == subject and sign in FLIPPED:
                if claims.scene.desk.holds(line.number):
                    yield line.number, own


def _bounded_ratio(claims: Comparing, letter: Letter, pool: Sequence[Ref]) -> Apply:
    """The ratio of an angle that a premise bounds, or its square; else the tangent."""
    for ref in pool:
        own = claims.scene.desk.line(ref).relation if isinstance(ref, int) else None
        match own:
            case Relation(((Link(Apply() as ratio, sign, _),),)):
                pass
            case Relation(((Link(Binary("^", Apply() as ratio, power), sign, _),),)):
                if power != Number(Fraction(2)):
                    continue
            case _:
                continue
        if ratio.argument == letter and sign in FLIPPED and ratio.function in _RATIOS:
            return ratio
    return Apply("tan", letter)


def _bounding(claims: Comparing, subject: Expression, sign: Sign, most: sp.Expr) -> Iterator[int]:
    """The lines in force that bound an expression so by a number."""
    for line in claims.scene.desk.lines:
        if not isinstance(line.relation, Relation) or len(line.relation.options) != 1:
            continue
        link = line.relation.only[-1]
        if (link.left, link.sign) != (subject, sign) or not claims.scene.desk.holds(line.number):
            continue
        if claims.worths.value(link.right) == most:
            yield line.number
