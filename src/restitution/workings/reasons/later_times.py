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
    if any(_is_worked_out(each, line) for each in derivation.lines):
        return None
    above = next((each for each in derivation.lines if _is_worked_out(line, each)), None)
    line = line if above is None else above
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
                if not isinstance(time, Letter):
                    return None
                since = Link(time, ">=", links[-1].right)
                return say("derived.from-then", time=naming.relation(Relation(((since,),))))
    return None


def _is_worked_out(line: Line, above: Line) -> bool:
    """Whether a line says in another form what one above it does."""
    return line.move.id == "rearrange" and line.premises[:1] == (above.number,)


__all__ = ["later_than"]
