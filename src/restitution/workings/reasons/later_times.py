"""When a line holds that tells a place at a time: from which time on, or between which impacts."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
    AtTime,
    Expression,
    Letter,
    Name,
    Quantity,
    has_quantity,
    letters,
    walk,
)
from restitution.workings.naming.measured import worth
from restitution.workings.naming.quantities import Naming


def later_than(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """That a time for which a letter stands is none before the event of a line; None of another.

    What is in motion from the start of the clock is so at any time.
    """
    stated = line
    line = _worked_out_of(derivation, stated) or stated
    if not isinstance(line.relation, Relation) or not line.move.event:
        return None
    times = {
        node.stage.time
        for link in line.relation.options[0]
        for side in (link.left, link.right)
        for node in walk(side)
        if isinstance(node, Quantity) and isinstance(node.stage, AtTime)
    }
    event = Quantity("time", (), line.move.event)
    cited = [own for ref in line.premises if isinstance(ref, int) and (own := derivation.line(ref))]
    for premise in cited:
        match premise.relation:
            case Relation((links,)) if links[0].left == event and len(times) == 1:
                (time,) = times
                if not isinstance(time, Letter) or _is_worked_out(derivation, stated):
                    return None
                since = Link(time, ">=", links[-1].right)
                return say("derived.from-then", time=naming.relation(Relation(((since,),))))
    return None


def between_impacts(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """Between which impacts a body is at a time that is a number, where lines say when they are.

    None of a line that tells no place at such a time, and where the next impact has no time.
    """
    match line.relation:
        case Relation(
            ((Link(Quantity("position", (Name(body),), AtTime(instant)), "="), *_), *_)
        ) if line.move.record == "straight-line" and line.move.event:
            early = line.move.event
        case _:
            return None
    late = min(
        (e.number for e in naming.impacts if body in e.bodies and e.number > early), default=0
    )
    events = [naming.events[number] for number in (early, late) if number]
    if len(events) < 2 or any(event.kind != "impact" for event in events):
        return None
    times = [_when(derivation, event.number, line.number) for event in events]
    first, last = times
    if first is None or last is None or letters(instant) or has_quantity(instant):
        return None
    if not worth(first) < worth(instant) < worth(last):
        return None
    order = Relation(((Link(first, "<", instant), Link(instant, "<", last)),))
    one, other = map(naming.called, events)
    when = naming.relation(order)
    return say("flight.between-impacts", times=when, body=body, one=one, other=other)


def _when(derivation: Derivation, event: int, before: int) -> Expression | None:
    """The number that a line above another one says of the time of an event."""
    for line in derivation.lines[: before - 1]:
        match line.relation:
            case Relation((links,)) if links[0].left == Quantity("time", (), event):
                value = links[-1].right
                if links[-1].sign == "=" and not letters(value) and not has_quantity(value):
                    return value
    return None


def _worked_out_of(derivation: Derivation, line: Line) -> Line | None:
    """The line above one that this says in another form; None where it is no such one."""
    first = line.premises[0] if line.premises else None
    if line.move.id != "rearrange" or not isinstance(first, int):
        return None
    return derivation.line(first)


def _is_worked_out(derivation: Derivation, line: Line) -> bool:
    """Whether a line stands once more, in another form."""
    above = filter(None, (_worked_out_of(derivation, line) for line in derivation.lines))
    return any(other.number == line.number for other in above)


__all__ = ["between_impacts", "later_than"]
