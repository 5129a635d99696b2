"""Where a bound is reached that comes of a square: where what is squared is zero."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import FLIPPED, Derivation, Link
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Expression, Letter, letters
from restitution.oracle import Role
from restitution.planning.forms import tree_of


def place_of_zero(
    base: Expression, roles: Mapping[str, Role], derivation: Derivation
) -> Link | None:
    """The value of the one letter for which a sum is zero; None where the letter has it not.

    A letter of which an inequality is given is left aside: that may exclude the value.
    """
    names = letters(base)
    if len(names) != 1:
        return None
    (name,) = names
    role = roles.get(name)
    if role is None or role.kind not in ("positive", "restitution"):
        return None
    bounded = any(
        link.sign in FLIPPED and name in letters(link.left) | letters(link.right)
        for fact in derivation.facts
        if fact.kind in ("given", "range")
        for links in fact.relation.options
        for link in links
    )
    whole = in_letters(base)
    symbol = next(iter(whole.free_symbols))
    if bounded or not whole.is_polynomial(symbol) or sp.degree(whole, symbol) != 1:
        return None
    poly = sp.Poly(whole, symbol)
    value = tidy(-poly.nth(0) / poly.nth(1))
    inside = value.is_positive if role.high is None else 0 <= value <= role.high
    return Link(Letter(name), "=", tree_of(value)) if inside else None


__all__ = ["place_of_zero"]
