"""Conditions of the marks of places, times and distances."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.awarding.work import Work, subject_of
from restitution.explaining.lines.derivation import Line, Link, Relation
from restitution.expression.tree import AtTime, Binary, Quantity, walk


def another_chord(work: Work, line: Line) -> bool:
    """A component on a chord, below another one in the part: the angles are equal once more.

    Or the time on a chord, as that on the one before.
    """
    if _is_as_before(line):
        return True
    match subject_of(line):
        case Quantity("along" | "across"):
            pass
        case _:
            return False
    return any(each.move.record == "chord" for each in work.above(line))


def _is_as_before(line: Line) -> bool:
    """Whether a line says that a time is another one."""
    assert isinstance(line.relation, Relation)
    match line.relation.options[0][0].right:
        case Quantity("time") | Binary("-", Quantity("time"), Quantity("time")):
            return True
    return False


def at_another_time(work: Work, line: Line) -> bool:
    """A distance since a contact, below one for another time: the relative speed is the same."""
    match subject_of(line):
        case Quantity("distance", bodies, AtTime()):
            pass
        case _:
            return False
    above = (subject_of(each) for each in work.above(line) if each.move == line.move)
    return any(
        isinstance(each, Quantity) and each.arguments == bodies and isinstance(each.stage, AtTime)
        for each in above
    )


def open_place(work: Work, line: Line) -> bool:
    """A place by a time that is not yet known, or a second coordinate by it."""
    match subject_of(line):
        case Quantity("position"):
            return _by_an_open_time(line)
        case Quantity("along", (Quantity("position"), axis)):
            before = [
                e for e in work.above(line) if e.move == replace(line.move, bodies=e.move.bodies)
            ]
            return _by_an_open_time(line) and any(
                _by_an_open_time(each)
                and isinstance(own := subject_of(each), Quantity)
                and own.arguments[-1] == axis
                for each in before
            )
    return False


def _by_an_open_time(line: Line) -> bool:
    """Whether a time stands in a line that is not what it is about."""
    match line.relation:
        case Relation(((first, *_), *_)):
            nodes = walk(first.right)
            return any(isinstance(node, Quantity) and node.kind == "time" for node in nodes)
    return False


def displaced(work: Work, line: Line) -> bool:
    """A distance that is a displacement of a line above, in one direction."""
    match line.relation:
        case Relation(((Link(_, "=", distance),),)):
            pass
        case _:
            return False
    for each in work.cited(line):
        match each.relation:
            case Relation(((Link(Binary("-", Quantity("along"), Quantity("along"))), *_),)) as own:
                if own.only[-1].right == distance:
                    return True
    return False


__all__ = ["another_chord", "at_another_time", "displaced", "open_place"]
