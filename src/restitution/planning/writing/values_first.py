"""A value of a letter in the place where it is first put in.

Where *v = ⅕(1 − 4e)u cos α* stands and *e = ½* is given, a teacher says *v = −⅕u cos α* once, and
then uses it. A line may have put both in at once, before another one needed the value by itself.
"""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.expression.tree import Letter
from restitution.oracle import Oracle
from restitution.planning.writing.gathering import numbered_anew


def with_values_first(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which the lines that put a value in stand below the one that says it."""
    if derivation.cases:
        return derivation
    for value in derivation.lines:
        users = _users_above(derivation, value)
        if users:
            derivation = _with_value_first(derivation, value, users, oracle)
    return derivation


def _users_above(derivation: Derivation, value: Line) -> list[Line]:
    """The lines above a value that put in all of which it is made, in its part."""
    match value.relation:
        case Relation(((Link(Letter(), "="), *_),)) if value.move.id == "put":
            source, *data = value.premises
        case _:
            return []
    parts = derivation.asked
    return [
        line
        for line in derivation.lines
        if isinstance(source, int)
        and source < line.number < value.number
        and line.move.id == "put"
        and data
        and {source, *data} <= set(line.premises)
        and parts.get(line.item or "", "") == parts.get(value.item or "", "-")
    ]


def _with_value_first(
    derivation: Derivation, value: Line, users: list[Line], oracle: Oracle
) -> Derivation:
    """The working with a value above the first of its users, if all of them follow from it."""
    source, *data = value.premises
    above = {e.number for e in derivation.lines if e.number < users[0].number}
    if not all(ref in above for ref in value.premises if isinstance(ref, int)):
        return derivation
    kept = [line for line in derivation.lines if line is not value]
    at = kept.index(users[0])
    kept.insert(at, replace(value, item=users[0].item))
    for less in (set(data), set[object]()):
        lines = []
        for line in kept:
            if line in users:
                refs = tuple(
                    value.number if ref == source else ref
                    for ref in line.premises
                    if ref not in less
                )
                line = replace(line, premises=refs)
            lines.append(line)
        whole = numbered_anew(derivation, lines)
        read = reader_of(whole, oracle)
        own = [n for n, line in enumerate(kept, 1) if line in users]
        if all(read.accepts(read.lines[number]) for number in own):
            return whole
    return derivation
