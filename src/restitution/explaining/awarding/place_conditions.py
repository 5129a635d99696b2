"""Conditions of the marks of places, times and distances."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.awarding.work import Work, subject_of
from restitution.explaining.data.restated import axis_restated
from restitution.explaining.data.resting import body_that_rests
from restitution.explaining.lines.derivation import Line, Relation
from restitution.expression.tree import (
    AtTime,
    Binary,
    Expression,
    Quantity,
    has_quantity,
    is_quantity,
    letters,
    walk,
)

_TWO = 2


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
    return any(premise.move.record == "chord" for premise in work.above(line))


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
    above = (subject_of(premise) for premise in work.above(line) if premise.move == line.move)
    return any(
        isinstance(subject, Quantity)
        and subject.arguments == bodies
        and isinstance(subject.stage, AtTime)
        for subject in above
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
                _by_an_open_time(premise)
                and isinstance(own := subject_of(premise), Quantity)
                and own.arguments[-1] == axis
                for premise in before
            )
    return False


def _by_an_open_time(line: Line) -> bool:
    """Whether a time stands in a line that is not what it is about."""
    match line.relation:
        case Relation(((first, *_), *_)):
            nodes = walk(first.right)
            return any(is_quantity(node, "time") for node in nodes)
    return False


def put_together(work: Work, line: Line) -> bool:
    """A time since the start that lines of flights make, of which one has its method above."""
    if getattr(subject_of(line), "kind", None) != "time" or _ends_below(work, line):
        return False
    cited = list(work.cited(line))
    return any(_has_a_method(work, premise) for premise in cited) and all(
        getattr(node, "kind", "time") == "time"
        for premise in cited
        if isinstance(premise.relation, Relation)
        for node in walk(premise.relation.options[0][0].left)
        if isinstance(node, Quantity)
    )


def goes_on(work: Work, line: Line) -> bool:
    """A coordinate in letters of the statement, in which more is done before an item ends."""
    match subject_of(line):
        case Quantity("along", (Quantity("position"), axis)):
            pass
        case _:
            return False
    assert isinstance(line.relation, Relation)
    value = line.relation.options[0][-1].right
    if has_quantity(value) or letters(value) & work.new or line.number in work.ends:
        return False
    below = (e for e in work.derivation.lines if line.number in e.premises)
    return not _ends_below(work, line) and not any(_moves_along(later, axis) for later in below)


def _moves_along(line: Line, axis: Expression) -> bool:
    """Whether a line is of a later place in the same direction, of which this is the first half."""
    if line.move.record != "straight-line" or not isinstance(line.relation, Relation):
        return False
    return any(
        is_quantity(node, "along") and node.arguments[-1] == axis
        for node in walk(line.relation.options[0][0].left)
    )


def _ends_below(work: Work, line: Line) -> bool:
    """Whether the last line of an item takes a line as it stands."""
    below = (e for e in work.derivation.lines if line.number in e.premises)
    return any(later.number in work.ends for later in below)


def _has_a_method(work: Work, line: Line) -> bool:
    """Whether a line is a flight that has its method."""
    rule = work.rule(line)
    return line.move.record == "straight-line" and rule is not None and rule.points == "M"


def restated(work: Work, line: Line) -> bool:
    """A distance that is a coordinate, or a displacement in one direction, of a line above."""
    return axis_restated(work.derivation, line) is not None


def between_places(work: Work, line: Line) -> bool:
    """A line of centres by the places of the two centres, of which one is worked out above."""
    between = [
        {node for node in walk(fact.relation.only[0].right) if is_quantity(node, "position")}
        for fact in work.facts(line)
        if fact.id.startswith("axis ")
    ]
    return any(len(places) == _TWO for places in between) and any(
        is_quantity(subject_of(premise), "position") for premise in work.cited(line)
    )


def between_at_rest(work: Work, line: Line) -> bool:
    """A distance from where a body stays that is at rest, of which no other line tells a place."""
    return body_that_rests(work.derivation, line) is not None


__all__ = [
    "another_chord",
    "at_another_time",
    "between_at_rest",
    "between_places",
    "goes_on",
    "open_place",
    "put_together",
    "restated",
]
