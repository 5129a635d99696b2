"""Decimals of what is exact, and the ends of items."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.explaining.definitions.common import ZERO
from restitution.explaining.lines.derivation import Link, Meaning, Relation
from restitution.explaining.moves.angles import in_radians, is_ratio_of
from restitution.explaining.moves.bases import base_of, condition, ends_of
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    unsigned,
    walk,
)
from restitution.oracle import Oracle, compared


def is_decimal(step: Step, relation: Relation) -> bool:
    """A decimal of what is exact: within half a unit of its last place."""
    base = base_of(step)
    if base is None or len(base.options) != 1:
        return False
    if len(relation.options) != 1 or len(relation.only) != 1:
        return False
    (link,) = relation.only
    exact = ends_of(base.only)
    if link.sign != "≈" or exact is None or link.left != exact.left:
        return False
    decimal, letters_ = _parted(link.right)
    printed = _decimal(decimal)
    value = in_radians(step, exact.right)
    if letters_ is not None:
        value = sp.expand(value / in_radians(step, letters_))
    if printed is None or value.free_symbols:
        return False
    number, unit = printed
    if isinstance(unsigned(link.right), Degrees):
        value = value * 180 / sp.pi
    gap = sp.Abs(value - sp.Rational(number.numerator, number.denominator))
    half = sp.Rational(unit.numerator, unit.denominator * 2)
    return Oracle({}).proves(compared(gap, "<=", half))


def _parted(tree: Expression) -> tuple[Expression, Expression | None]:
    """A decimal, and the letters that it is multiplied by, as in 0.634 u."""
    match tree:
        case Binary("*", left, right) if not any(isinstance(e, Number) for e in walk(right)):
            decimal, others = _parted(left)
            return decimal, right if others is None else Binary("*", others, right)
        case Binary("*", left, Binary("^", Letter(), _) as power):
            decimal, others = _parted(left)
            return decimal, power if others is None else Binary("*", others, power)
    return tree, None


def _decimal(tree: Expression) -> tuple[Fraction, Fraction] | None:
    """A decimal and the unit of its last place."""
    negative = isinstance(tree, Negate)
    own = unsigned(tree)
    if not isinstance(own, Number | Degrees):
        return None
    value, places = own.value, 0
    while (value * 10**places).denominator != 1:
        places += 1
        if places > 30:
            return None
    return (-value if negative else value), Fraction(1, 10**places)


def is_attained(
    step: Step,
    bound: Relation,
    where: Relation | Meaning,
    extent: Relation | Meaning | None = None,
) -> bool:
    """Whether a greatest or least value is reached, at a place that there is.

    Of one that is only approached, ``extent`` says the range of the letter, if facts narrow that.
    """
    case = None if isinstance(where, Meaning) else condition(where)
    if case is None or len(bound.options) != 1 or len(bound.only) != 1:
        return False
    (place, value), (end,) = case, bound.only
    if step.move.record == "approached":
        return end.sign in ("<", ">") and _is_approached(step, place, value, end, extent)
    least = step.move.record == "least"
    if end.sign != (">=" if least else "<="):
        return False
    if value != Link(end.left, "=", end.right) and not is_ratio_of(step, value, end):
        return False
    free = step.under(cited=(), known=())
    there = free.formula(Relation(((place,),)))
    return Oracle(step.setting.roles, (there,)).possible.answer == "proved"


def _is_approached(
    step: Step, place: Link, value: Link, end: Link, extent: Relation | Meaning | None
) -> bool:
    """Whether a value belongs to an end of the range of a letter that is not in the range."""
    if value != Link(end.left, "=", end.right) and not is_ratio_of(step, value, end):
        return False
    if extent is not None:
        return isinstance(extent, Relation) and _is_left_out(place, extent)
    match place.left:
        case Binary("/", Number(1), Letter(name)) if place.right == ZERO:
            return step.setting.role(name).high is None  # as it grows without limit
        case Letter(name):
            role = step.setting.role(name)
        case _:
            return False
    there = in_radians(step, place.right)
    ends = ((role.low, role.closed[0]), (role.high, role.closed[1]))
    return any(own is not None and not closed and own == there for own, closed in ends)


def _is_left_out(place: Link, extent: Relation) -> bool:
    """Whether a range of a letter goes up to a place, and does not have it."""
    sides = (place.left, place.right)
    return len(extent.options) == 1 and any(
        link.sign in ("<", ">") and sides in ((link.left, link.right), (link.right, link.left))
        for link in extent.only
    )
