"""A condition with its values put in as they stand: a quotient, or a sum of two components."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import Binary, Quantity, is_zero
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import ZERO, swept, tree_of


def write_quotient(worths: Worths, link: Link, pool: Sequence[Ref], first: Relation) -> int | None:
    """A bound of the ratio of two quantities: both stand in it before it is simplified."""
    match link.left:
        case Binary("/", Quantity() as above, Quantity() as below):
            known = [worths.scene.desk.known(quantity) for quantity in (above, below)]
        case _:
            return None
    sides = [tree_of(worths.scene.put(source.value)[0]) for source in known if source is not None]
    if len(sides) < 2:
        return None
    (own,) = first.only
    whole = Link(swept(Binary("/", *sides)), own.sign, own.right)
    return _simplified(worths, pool, whole, first)


def write_sum(
    worths: Worths, link: Link, pool: Sequence[Ref], first: Relation, gap: sp.Expr
) -> int | None:
    """The sign of a sum of two components: both stand in it before it is simplified."""
    match link:
        case Link(Binary("+", left, right), _, zero) if is_zero(zero):
            terms = [tree_of(worths.of_side(term)) for term in (left, right)]
        case _:
            return None
    whole = Link(swept(Binary("+", *terms)), link.sign, ZERO)
    return _simplified(worths, pool, whole, first, worths.known_in(gap))


def _simplified(
    worths: Worths, pool: Sequence[Ref], whole: Link, first: Relation, known: Sequence[Ref] = ()
) -> int | None:
    mark = worths.mark()
    line = worths.judge.write((Move("put"),), pool, Relation(((whole,),)))
    if line is None or whole == first.only[0]:
        return line
    after = worths.judge.write((Move("rearrange"),), [line, *known], first)
    if after is None:
        worths.back(mark)
    return after
