"""A ratio that is given, put into the shortest side of the line above: ½ = 1/k, as tan α = 1.

Components with the sine and the cosine of that angle put in would be longer.
"""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Ref, Relation, citing
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Apply, Expression, Letter, letters, walk
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import swept


def with_ratios_put_in(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which given ratios go into the last side of the chain above them."""
    for number in [line.number for line in derivation.lines if line.move.id == "put"]:
        line = derivation.line(number)
        own = None if line is None else _shorter(derivation, line)
        if own is None:
            continue
        again = [e for e in derivation.lines if e.relation == own.relation]
        if any(e.premises != (number,) or e.number in derivation.held for e in again):
            continue
        numbers: dict[Ref, Ref] = {e.number: number for e in again}
        lines = tuple(
            own if e.number == number else replace(e, premises=citing(e.premises, numbers))
            for e in derivation.lines
            if e not in again
        )
        whole = replace(derivation, lines=lines)
        read = reader_of(whole, oracle)
        touched = [e for e in whole.lines if number in (e.number, *e.premises)]
        if all(map(read.accepts, touched)):
            derivation = whole
    return derivation


def _shorter(derivation: Derivation, line: Line) -> Line | None:
    """The line with the one ratio that it cites put in; None of another, and where it is so."""
    match line.premises, line.relation:
        case (int(above), str(ref)), Relation(((Link(left, "=", right),),)):
            pass
        case _:
            return None
    base, fact = derivation.line(above), derivation.fact(ref)
    given = None if fact is None else _given_ratio(fact.relation)
    match None if base is None else base.relation:
        case Relation((links,)) if given is not None and links[0].left == left and len(links) > 1:
            last = links[-1]
        case _:
            return None
    ratio, value = given
    put = swept(exchanged(last.right, {ratio: value}))
    is_plain = last.sign == "=" and not letters(ratio) & letters(put)
    if not is_plain or put == right or len(walk(put)) >= len(walk(right)):
        return None
    sides = (put, left) if isinstance(put, Letter) else (left, put)
    return replace(line, relation=chain(sides[0], (sides[1], None)))


def _given_ratio(relation: Relation) -> tuple[Expression, Expression] | None:
    """A sine, cosine or tangent of a letter, and its value; None of what says something else."""
    match relation.options:
        case ((Link(Apply("sin" | "cos" | "tan", Letter()) as ratio, "=", value),),):
            return None if letters(value) else (ratio, value)
    return None


__all__ = ["with_ratios_put_in"]
