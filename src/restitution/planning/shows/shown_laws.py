"""What is to be shown and is a law of an impact: the law itself, in one line."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.derivation import Event, Link, Move, Relation
from restitution.expression.tree import has_quantity
from restitution.planning.writing.scene import Scene


def write_shown_law(scene: Scene, shown: Link) -> int | None:
    """The line that says a law as it is to be shown; None where that is no law.

    It rests on data alone: nothing has to be solved for it.
    """
    if shown.sign != "=" or not (has_quantity(shown.left) and has_quantity(shown.right)):
        return None
    relation = Relation(((shown,),))
    for event in scene.desk.events:
        if event.kind != "impact":
            continue
        pool = [
            fact.id
            for fact in scene.desk.facts
            if fact.id in (f"axis {event.number}", f"e {event.number}")
            or fact.id in (f"mass {body}" for body in event.bodies)
        ]
        for move in _laws(event):
            refs = scene.judge.needed(move, pool, relation)
            if refs is not None:
                return scene.desk.write(move, refs, relation)
    return None


def _laws(event: Event) -> Iterator[Move]:
    """The laws of an impact, as moves."""
    number, bodies = event.number, event.bodies
    own = bodies[:1] if event.wall else bodies
    yield from (Move("law", "unchanged", number, (body,)) for body in own)
    if event.wall:
        yield Move("law", "restitution-wall", number, own)
        return
    for record in ("restitution", "momentum", "momentum-vector", "opposite-impulses"):
        yield Move("law", record, number, bodies)
