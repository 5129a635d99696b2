"""Directions that stand already, in the place of vectors that are worked out for them.

Where *v = Vj* stands, and the value of V, its speed and its direction follow from these: no vector
with that value is written between. Where the velocity of a sphere that was at rest stands, the line
of centres is along that, and no change of the other velocity is worked out.
"""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Link, Ref, Relation
from restitution.expression.tree import Name, Pair, Quantity, Unit, is_zero, letters, walk
from restitution.oracle import Oracle


def with_known_directions(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working without vectors that only put a value into one that stands."""
    for line in derivation.lines:
        match line.relation:
            case Relation(((Link(Quantity("velocity"), "="),),)) if line.move.id == "put":
                derivation = _without(derivation, line, oracle) or derivation
    return derivation


def with_lines_from_rest(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working with lines of centres along velocities that stand of spheres from rest."""
    for line in derivation.lines:
        if line.move.record == "along-the-change" and line.number not in derivation.held:
            derivation = _along_its_velocity(derivation, line, oracle) or derivation
    return derivation


def _along_its_velocity(derivation: Derivation, line: Line, oracle: Oracle) -> Derivation | None:
    """The working in which a line of centres is along the velocity of a sphere that was at rest.

    None where no such velocity stands above in numbers, or the line says so already.
    """
    event = line.move.event
    for above in derivation.lines:
        match above.relation:
            case Relation(((Link(Quantity("velocity", (Name(body),), stage), "=", right),),)) if (
                stage == event and above.number < line.number and not letters(right)
            ):
                pass
            case _:
                continue
        start = derivation.fact(f"velocity {body}")
        match None if start is None else start.relation.only[-1].right:
            case Pair(x, y) if is_zero(x) and is_zero(y) and body not in line.move.bodies:
                pass
            case _:
                continue
        assert start is not None
        last, idle = line, set[int]()
        while (after := _worked_out_in(derivation, last)) is not None:
            idle, last = {*idle, after.number}, after
        if idle & derivation.held:
            return None
        own = replace(
            last,
            number=line.number,
            move=replace(line.move, bodies=(body,)),
            premises=(start.id, above.number),
        )
        changed = {
            other.number: replace(other, premises=_cited_as(other.premises, last, line))
            for other in derivation.lines
            if last.number in other.premises and other.number not in idle
        } | {line.number: own}
        lines = (other for other in derivation.lines if other.number not in idle)
        whole = replace(
            derivation, lines=tuple(changed.get(other.number, other) for other in lines)
        )
        if all(map(reader_of(whole, oracle).accepts, changed.values())):
            return whole
    return None


def _cited_as(premises: tuple[Ref, ...], line: Line, other: Line) -> tuple[Ref, ...]:
    """Premises with one line in the place of another."""
    return tuple(other.number if ref == line.number else ref for ref in premises)


def _worked_out_in(derivation: Derivation, line: Line) -> Line | None:
    """The one line that rests on a line of centres, and only writes its direction otherwise."""
    users = [other for other in derivation.lines if line.number in other.premises]
    if len(users) == 1 and users[0].move.id == "rearrange" and line.number not in derivation.held:
        return users[0]
    return None


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


__all__ = ["with_known_directions", "with_lines_from_rest"]
