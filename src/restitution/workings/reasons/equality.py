"""Where a bound comes from: a square that is zero somewhere, a divisor that is more than 1."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Derivation, Line, Link, Relation, Sign
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Apply, Binary, Expression, Letter, Number, letters
from restitution.oracle import Role
from restitution.planning.writing.forms import tree_of


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


def divisor_left_out(above: Relation, line: Relation, roles: Mapping[str, Role]) -> Link | None:
    """That what divides the bound of a square is more than 1, where that of its root has it not.

    None of other bounds.
    """
    match above.options, line.options:
        case (
            ((Link(Binary("^", base), _, Binary("/", top, below)),),),
            ((Link(ratio, "<" | "<=", Apply("sqrt", root)),),),
        ) if base == ratio and top == root:
            kinds = {roles[n].kind if n in roles else "" for n in letters(below)}
        case _:
            return None
    if not kinds or not kinds <= {"positive", "restitution"}:
        return None
    rest = sp.expand(in_letters(below, positive=True) - 1)
    sign: Sign = ">" if kinds == {"positive"} else ">="
    return Link(below, sign, Number(Fraction(1))) if rest.is_positive else None


def equal_tangents(derivation: Derivation, line: Line) -> Relation | None:
    """That the tangents of two angles are equal, by which a line says that the angles are."""
    match line.relation:
        case Relation(((Link(Letter() as one, "=", Letter() as other),),)):
            pass
        case _:
            return None
    cited = derivation.lines_in(line.premises)
    for own in cited:
        match own.relation if own.move.id == "inverse" else None:
            case Relation(((Link(Letter(), "=", Apply("arctan")),),)):
                pass
            case _:
                return None
    equal = Link(Apply("tan", one), "=", Apply("tan", other))
    return Relation(((equal,),)) if cited else None


__all__ = ["divisor_left_out", "equal_tangents", "place_of_zero"]
