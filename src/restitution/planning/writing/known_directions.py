"""What a velocity along a known direction tells by the letter of its one component.

Where *v = Vj* stands, and the value of V, its speed and its direction follow from these: no vector
with that value is written between.
"""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Ref, Relation
from restitution.expression.tree import Quantity, Unit, letters, walk
from restitution.oracle import Oracle


def with_known_directions(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working without vectors that only put a value into one that stands."""
    for line in derivation.lines:
        match line.relation:
            case Relation(((Link(Quantity("velocity"), "="),),)) if line.move.id == "put":
                derivation = _without(derivation, line, oracle) or derivation
    return derivation


def _without(derivation: Derivation, line: Line, oracle: Oracle) -> Derivation | None:
    """The working in which what rests on a vector rests on its letter; None where it does not."""
    users = [other for other in derivation.lines if line.number in other.premises]
    if line.number in derivation.held or not users or not _is_of_one_letter(derivation, line):
        return None
    changed = {user.number: replace(user, premises=_instead(user.premises, line)) for user in users}
    lines = tuple(changed.get(line.number, line) for line in derivation.lines)
    whole = replace(derivation, lines=lines)
    read = reader_of(whole, oracle)
    if not all(map(read.accepts, changed.values())):
        return None
    for number, own in changed.items():
        for ref in line.premises:
            less = replace(own, premises=tuple(other for other in own.premises if other != ref))
            if read.accepts(less):
                changed[number] = own = less
    return replace(whole, lines=tuple(changed.get(line.number, line) for line in lines))


def _instead(premises: tuple[Ref, ...], line: Line) -> tuple[Ref, ...]:
    """Premises with those of a line in its place."""
    own = (line.premises if ref == line.number else (ref,) for ref in premises)
    return tuple(dict.fromkeys(ref for refs in own for ref in refs))


def _is_of_one_letter(derivation: Derivation, line: Line) -> bool:
    """Whether a vector is along an axis, and has its value from the letter of another line."""
    above = [derivation.line(ref) for ref in line.premises]
    relations = [None if line is None else line.relation for line in above]
    match relations, line.relation:
        case [Relation((open_,)), Relation((value,))], Relation(((own,),)):
            pass
        case _:
            return False
    if len({node for node in walk(open_[-1].right) if isinstance(node, Unit)}) != 1:
        return False
    return open_[-1].left == own.left and letters(value[-1].left) <= letters(open_[-1].right)


__all__ = ["with_known_directions"]
