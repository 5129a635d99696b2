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
    users = [each for each in derivation.lines if line.number in each.premises]
    if line.number in derivation.held or not users or not _is_of_one_letter(derivation, line):
        return None
    changed = {each.number: replace(each, premises=_instead(each.premises, line)) for each in users}
    lines = tuple(changed.get(each.number, each) for each in derivation.lines)
    whole = replace(derivation, lines=lines)
    read = reader_of(whole, oracle)
    if not all(map(read.accepts, changed.values())):
        return None
    for number, own in changed.items():
        for ref in line.premises:
            less = replace(own, premises=tuple(each for each in own.premises if each != ref))
            if read.accepts(less):
                changed[number] = own = less
    return replace(whole, lines=tuple(changed.get(each.number, each) for each in lines))


def _instead(premises: tuple[Ref, ...], line: Line) -> tuple[Ref, ...]:
    """Premises with those of a line in its place."""
    own = (line.premises if each == line.number else (each,) for each in premises)
    return tuple(dict.fromkeys(ref for refs in own for ref in refs))


def _is_of_one_letter(derivation: Derivation, line: Line) -> bool:
    """Whether a vector is along an axis, and has its value from the letter of another line."""
    above = [derivation.line(ref) if isinstance(ref, int) else None for ref in line.premises]
    relations = [None if each is None else each.relation for each in above]
    match relations, line.relation:
        case [Relation((open_,)), Relation((value,))], Relation(((own,),)):
            pass
        case _:
            return False
    if len({node for node in walk(open_[-1].right) if isinstance(node, Unit)}) != 1:
        return False
    return open_[-1].left == own.left and letters(value[-1].left) <= letters(open_[-1].right)


__all__ = ["with_known_directions"]
