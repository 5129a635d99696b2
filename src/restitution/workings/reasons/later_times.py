"""From which time on a line holds that tells a place at a time after an event."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import AtTime, Letter, Quantity, walk
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
    for each in cited:
        match each.relation:
            case Relation((links,)) if links[0].left == event and len(times) == 1:
                (time,) = times
                if not isinstance(time, Letter) or _is_worked_out(derivation, stated):
                    return None
                since = Link(time, ">=", links[-1].right)
                return say("derived.from-then", time=naming.relation(Relation(((since,),))))
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


__all__ = ["later_than"]
