"""Signs of the top of a quotient, on which what is compared with it rests."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from restitution.explaining.lines.derivation import FLIPPED, Line, Link, Relation
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Number,
    is_binary,
    is_zero,
    letters,
    walk,
)
from restitution.planning.writing.forms import factors

_ZERO = Number(Fraction(0))


def top_of_a_bound(line: Line, cited: Iterable[Relation | None]) -> Relation | None:
    """That the top of a quotient is positive, where a bound of what is below it bounds the whole.

    Of tan δ = (1 + e)k/S and S ≥ a it is (1 + e)k > 0. None of any other line, and where the top
    has no sum: then a reader sees its sign.
    """
    match line.move.id, line.relation:
        case "compare", Relation(((Link(left, sign, Binary("/")),),)) if sign in FLIPPED:
            pass
        case _:
            return None
    relations = [
        relation for relation in cited if relation is not None and len(relation.options) == 1
    ]
    bounded = {relation.only[0].left for relation in relations if relation.only[-1].sign in FLIPPED}
    for relation in relations:
        match relation.only[-1]:
            case Link(_, "=", Binary("/", top, Letter() as below)) if relation.only[0].left == left:
                if below in bounded and _has_a_sum(top):
                    return Relation(((Link(top, ">", _ZERO),),))
    return None


def top_of_a_sign(line: Line, cited: Iterable[Relation | None]) -> Relation | None:
    """The sign of the top of a quotient above, of which a line keeps another inequality.

    (eM − m)/(M + m) > 0 makes eM − m > 0, and this with e ≤ 1 M > m. None of any other line.
    """
    relations = [relation for relation in cited if relation is not None]
    if line.move.id != "compare" or len(relations) != 1 or len(line.premises) == 1:
        return None
    match relations[0], line.relation:
        case Relation(((Link(Binary("/", top, below), ">" | "<" as sign, right),),)), Relation(
            ((Link(),),)
        ) if is_zero(right) and all(map(_is_positive, factors(below))):
            names = letters(top) - {name for link in line.relation.only for name in _names(link)}
            return Relation(((Link(top, sign, right),),)) if names else None
    return None


def _names(link: Link) -> frozenset[str]:
    return letters(link.left) | letters(link.right)


def _has_a_sum(tree: Expression) -> bool:
    return any(is_binary(node, "+", "-") for node in walk(tree))


def _is_positive(tree: Expression) -> bool:
    """Whether nothing is taken away in an expression of numbers and letters."""
    match tree:
        case Binary("+" | "*" | "/" | "^", left, right):
            return _is_positive(left) and _is_positive(right)
        case Number(value):
            return value > 0
    return isinstance(tree, Letter)


__all__ = ["top_of_a_bound", "top_of_a_sign"]
