"""Which of two equations in two letters is solved first: the one for the letter that is wanted."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Move, Relation, equality
from restitution.expression.tree import Letter
from restitution.oracle import Oracle


def with_wanted_letters(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no letter is worked out for the other of its equations alone."""
    for line in derivation.lines:
        if line.move.id == "combine" and line.move.eliminated is not None:
            derivation = _shortened(derivation, line, oracle) or derivation
    return derivation


def _shortened(derivation: Derivation, line: Line, oracle: Oracle) -> Derivation | None:
    """The working without a letter that one line puts in; None where it is needed."""
    users = [other for other in derivation.lines if line.number in other.premises]
    fixed = derivation.held
    letter = _letter_of(line)
    if len(users) != 1 or line.number in fixed or letter is None:
        return None
    (user,) = users
    others = set(user.premises) - {line.number}
    if user.move.id != "put" or len(others) != 1 or not others <= set(line.premises):
        return None
    if user.number in fixed - {end.line for end in derivation.items}:
        return None
    if _letter_of(user) != line.move.eliminated or len(line.premises) != len(set(line.premises)):
        return None
    assert isinstance(user.relation, Relation)
    last = user.relation.only[-1]
    relation = equality(user.relation.only[0].left, last.right)
    move = Move("combine", eliminated=letter)
    direct = replace(user, move=move, premises=line.premises, relation=relation)
    lines = tuple(
        direct if other.number == user.number else other
        for other in derivation.lines
        if other.number != line.number
    )
    whole = replace(derivation, lines=lines)
    read = reader_of(whole, oracle)
    return whole if read.accepts(read.lines[user.number]) else None


def _letter_of(line: Line) -> str | None:
    """The letter of which a line gives the value, in one solution."""
    match line.relation:
        case Relation((((Link(Letter(name), "="), *_)),)):
            return name
    return None


__all__ = ["with_wanted_letters"]
