"""Values at a place, and beyond all places."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.explaining.definitions.common import ZERO
from restitution.explaining.lines.derivation import Link
from restitution.explaining.lines.trees import rebuilt
from restitution.explaining.moves.angles import in_radians
from restitution.explaining.moves.bases import base_of, ends_of, equal_in, last_side
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
)
from restitution.oracle import Relation as Claim


def at_place(step: Step, place: Link, then: Link) -> bool:
    """Whether an equation has a value where a letter has one, perhaps at an end of its range.

    The place may be told by the tangent of an angle.
    """
    base = base_of(step)
    equation = None if base is None or len(base.options) != 1 else ends_of(base.only)
    meant: dict[Expression, Expression] = {Letter(e.letter): e.quantity for e in step.lets}
    if equation is None or then.left not in (
        equation.left,
        rebuilt(equation.left, lambda tree: meant.get(tree, tree)),
    ):
        return False
    match place.left:
        case Letter(name):
            at = step.world.expression(step.world.scalar(place.right), step.roles)
        case Binary("/", Number(1), Letter(name)) if place.right == ZERO:
            at = sp.oo
        case Apply("tan", Letter(name)):
            tangent = step.world.expression(step.world.scalar(place.right), step.roles)
            at = sp.atan(tangent)
        case _:
            return False
    value, own = (
        step.world.expression(step.world.scalar(side), step.roles)
        for side in (equation.right, then.right)
    )
    value = value.xreplace(_by_their_tangents(step, value))
    letter = next((symbol for symbol in value.free_symbols if symbol.name == name), None)
    if letter is None:
        return False
    there = worth_at(value, letter, at)
    if there is None:
        return False
    return equal_in(step, there, own) or equal_in(step, there, own, _not_negative(step, there))


def _not_negative(step: Step, value: sp.Expr) -> tuple[Claim, ...]:
    """What is cited of letters of which an expression has the size."""
    symbols = {s for size in value.atoms(sp.Abs) for s in size.free_symbols}
    return tuple(Claim(s, ">=") for s in symbols if s.name in step.world.nonnegative)


def _by_their_tangents(step: Step, value: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """The angles of up to 90° in an expression of which the tangents are cited, by these."""
    tangents: dict[sp.Symbol, sp.Expr] = {}
    for symbol in value.free_symbols:
        role = step.setting.role(symbol.name)
        if role.kind != "angle" or role.low != 0 or role.high != sp.pi / 2:
            continue
        for link in step.links:
            if link.sign == "=" and link.left == Apply("tan", Letter(symbol.name)):
                tangents[symbol] = sp.atan(in_radians(step, last_side(step, link)))
    return tangents


def worth_at(value: sp.Expr, letter: sp.Symbol, at: Any) -> sp.Expr | None:
    """What an expression is worth where a letter has a value, or beyond all values of it.

    None where it has no value there.
    """
    if at is sp.oo:
        small = sp.Dummy("t", positive=True)
        own = _by_the_inverse(value, letter, small)
        if own is None:
            return None
        value, letter, at = own, small, sp.Integer(0)
    if at == sp.pi / 2:
        value = _towards_a_right_angle(value, letter)
    there = value.subs(letter, at)
    return None if there.is_finite is False or there.has(sp.nan) else there


def _by_the_inverse(value: sp.Expr, letter: sp.Symbol, small: sp.Symbol) -> sp.Expr | None:
    """An expression by 1/k, for a letter k that has no limit; None where roots of k are left.

    Of a quotient such as √(k − 1)/√k the roots are joined.
    """
    inverse = value.subs(letter, 1 / small)
    if value.is_rational_function(letter):
        return sp.cancel(sp.together(inverse), small)

    def parted(power: sp.Expr) -> sp.Expr:
        above, below = sp.fraction(sp.together(power.args[0]))
        return sp.expand_power_base(above ** power.args[1] / below ** power.args[1])

    roots = [e for e in inverse.atoms(sp.Pow) if e.exp.is_Rational and not e.exp.is_Integer]
    if any(not root.base.is_rational_function(small) for root in roots):
        return None
    own = sp.powsimp(inverse.xreplace({root: parted(root) for root in roots}))
    left = {e.base for e in own.atoms(sp.Pow) if small in e.free_symbols and not e.exp.is_Integer}
    if any(base.subs(small, 0).is_zero for base in left):
        return None
    return own


def _towards_a_right_angle(value: sp.Expr, letter: sp.Symbol) -> sp.Expr:
    """An expression in which arctan(k tan x) is 90°, as it is where x is, for a positive k."""
    cotangent = sp.cos(letter) / sp.sin(letter)
    return value.replace(
        lambda x: isinstance(x, sp.atan) and sp.cancel(x.args[0] * cotangent).is_positive,
        lambda _: sp.pi / 2,
    )
