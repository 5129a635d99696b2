"""A value in letters that is put in where it changes a sum: as it is put in, then worked out.

Where *M = mu/v* goes into *mM(1 − e²)(u + v)²/(2(m + M))*, a reader sees *m(mu/v)(…)* first.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Move, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    has_quantity,
    has_root,
    is_binary,
    letters,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.desk import chain
from restitution.planning.writing.lines_in_two import number_above, with_two_for


def with_values_out(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which such lines have the values as they are put in for a first side.

    A ratio of an angle that has a sum of roots stands above as a ratio: *tan 75° = 2 × ¾/(1 − e)*.
    """
    derivation = _with_ratios(derivation, oracle)
    for number in [line.number for line in derivation.lines if line.move.id == "put"]:
        line = derivation.line(number)
        own = None if line is None else _written_out(derivation, line)
        if own is None:
            continue
        lines = tuple(own if other.number == number else other for other in derivation.lines)
        whole = replace(derivation, lines=lines)
        if reader_of(whole, oracle).accepts(own):
            derivation = whole
    return derivation


def _with_ratios(derivation: Derivation, oracle: Oracle) -> Derivation:
    shown = {end.item for end in derivation.items if end.shown}
    for line in derivation.lines:
        own = _with_a_ratio(derivation, line) if line.move.id == "put" else None
        if own is None or line.item in shown:
            continue
        above = replace(line, number=number_above(derivation), relation=own)
        below = replace(line, move=Move("rearrange"), premises=(above.number,))
        whole = with_two_for(derivation, line, (above, below), oracle)
        if whole is not None:
            return _with_ratios(whole, oracle)
    return derivation


def _with_a_ratio(derivation: Derivation, line: Line) -> Relation | None:
    """What a line says of the tangent of an angle in degrees, for which it has a sum of roots."""
    match line.relation:
        case Relation(((Link(Binary("+" | "-") as number, "="),),)) if has_root(number):
            pass
        case _:
            return None
    values = _values(derivation, line)
    for ref in line.premises:
        cited = derivation.cited(ref)
        match None if cited is None else cited.relation:
            case Relation(((Link(Apply(name, Letter() as angle), "="), *_) as links,)):
                degrees = values.get(angle)
                if isinstance(degrees, Degrees) and not letters(number):
                    put = exchanged(links[-1].right, values)
                    return chain(Apply(name, degrees), (put, None))
    return None


def _values(derivation: Derivation, line: Line) -> dict[Expression, Expression]:
    """The values of letters, and of ratios of angles, that a line cites."""
    values: dict[Expression, Expression] = {}
    for ref in line.premises:
        cited = derivation.cited(ref)
        match None if cited is None else cited.relation:
            case Relation(((Link(Letter() | Apply(argument=Letter()) as left, "="), *_) as links,)):
                if not has_quantity(links[-1].right):
                    values[left] = links[-1].right
    return values


def _written_out(derivation: Derivation, line: Line) -> Line | None:
    """The line with its values as they are put in; None where it is plain without that."""
    match line.move.record, line.relation:
        case None, Relation(((Link(left, "=", right),),)):
            pass
        case _:
            return None
    base: Expression | None = None
    values: dict[Expression, Expression] = {}
    for ref in line.premises:
        cited = derivation.cited(ref)
        match None if cited is None else cited.relation:
            case Relation(((Link(subject, "="), *_) as links,)):
                value = links[-1].right
            case _:
                continue
        if subject == left and base is None:
            base = value
        elif isinstance(subject, Letter) and not has_quantity(value):
            values[subject] = value
    if base is None or not any(_changes_a_sum(base, own, values[own]) for own in values):
        return None
    put = exchanged(base, values)
    if put in (base, right):
        return None
    return replace(line, relation=chain(left, (put, None), (right, "rearrange")))


def _changes_a_sum(base: Expression, letter: Expression, value: Expression) -> bool:
    """Whether a quotient of letters, or a sum, goes into a sum, and stands there more than once."""
    long = isinstance(value, Binary) and len(letters(value)) > 1
    if not long or Counter(walk(base))[letter] < 2:
        return False
    return any(letter in set(walk(own)) for own in walk(base) if is_binary(own, "+", "-"))


__all__ = ["with_values_out"]
