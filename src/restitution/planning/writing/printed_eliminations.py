"""A printed result that comes of both laws: what is put in stands above it.

From ``4mu = mv + kmw`` and ``w − v = 2u`` a result is not read off: ``4mu = mv + km(v + 2u)``.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Move,
    Relation,
    equality,
    numbers_in,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Binary, Expression, Letter, has_quantity
from restitution.oracle import Oracle
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.lines_in_two import number_above, with_two_for


def with_printed_eliminations(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which an unknown is put in above a printed result."""
    for line in reversed(derivation.lines):  # those above keep their numbers
        if line.move.id != "combine" or not _is_printed(derivation, line):
            continue
        put = _put_in(derivation, line)
        if put is None:
            continue
        laws, relation = put
        above = replace(line, number=number_above(derivation), premises=laws, relation=relation)
        rest = tuple(ref for ref in line.premises if ref not in laws)
        below = replace(line, move=Move("rearrange"), premises=(above.number, *rest))
        derivation = with_two_for(derivation, line, (above, below), oracle) or derivation
    return derivation


def _is_printed(derivation: Derivation, line: Line) -> bool:
    """Whether a line is a result that is to be shown, or a line below it says no more than that."""
    for end in derivation.items:
        last = derivation.line(end.line)
        if not end.shown or last is None:
            continue
        if last.number == line.number:
            return True
        if line.number in last.premises and _value(last) == _value(line) is not None:
            return True
    return False


def _value(line: Line) -> sp.Expr | None:
    """What a line ends with, in letters; None of what is no equation of one."""
    match line.relation:
        case Relation(((*_, Link(_, "=", right)),)) if not has_quantity(right):
            try:
                return sp.factor(in_letters(right, positive=True))
            except RestitutionError:
                return None
    return None


def _put_in(derivation: Derivation, line: Line) -> tuple[tuple[int, ...], Relation] | None:
    """Both laws, and momentum with the unknown that Newton's law says put in."""
    laws = [derivation.line(number) for number in numbers_in(line.premises)]
    named = {own.move.record: own for own in laws if own is not None}
    if len(laws) != 2 or named.keys() != {"momentum", "restitution"}:
        return None
    match named["momentum"].relation, named["restitution"].relation:
        case (
            Relation(((Link(left, "=", right),),)),
            Relation(((Link(Binary("-", Letter() as after, Letter() as before), "=", gap),),)),
        ):
            pass
        case _:
            return None
    rise = _worked_out(gap)
    if rise is None:
        return None
    worth: dict[Expression, Expression] = {}
    if line.move.eliminated == after.name:
        worth = {after: Binary("+", before, rise)}
    elif line.move.eliminated == before.name:
        worth = {before: Binary("-", after, rise)}
    else:
        return None
    sides = (exchanged(side, worth) for side in (left, right))
    return (named["momentum"].number, named["restitution"].number), equality(*sides)


def _worked_out(tree: Expression) -> Expression | None:
    """A product in letters, worked out."""
    try:
        return None if has_quantity(tree) else tree_of(in_letters(tree, positive=True))
    except RestitutionError:
        return None


__all__ = ["with_printed_eliminations"]
