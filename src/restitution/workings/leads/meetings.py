"""When bodies meet again, in words: which gap has to close, or which way one has to move."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from restitution.explaining.data.meeting_again import returning
from restitution.explaining.lines.derivation import Derivation, Fact, Line, Link, Relation, equality
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
    is_quantity,
    walk,
)
from restitution.problem import Meets, Show
from restitution.render.layout import Layout
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.quantities import Naming

# That a wall is hit, or is not, as an inequality and as a comparison.
_MEETINGS = {
    ("condition", "towards"): "condition.towards",
    ("condition", "away"): "condition.away",
    ("letter", "towards"): "condition.towards-if",
    ("letter", "away"): "condition.away-if",
    ("meeting", "towards"): "meeting.towards",
    ("meeting", "away"): "meeting.away",
}
# The same where it is known who is behind.
_BEHIND: dict[SentenceId, SentenceId] = {
    "collide-again.if": "collide-again.if-behind",
    "collide-again.unless": "collide-again.unless-behind",
    "meeting.collide": "meeting.collide-behind",
    "meeting.apart": "meeting.apart-behind",
}
# That spheres meet by way of a wall, or do not: as a comparison, and as an inequality.
_RETURNS: dict[tuple[bool, bool], SentenceId] = {
    (True, False): "return.collide-when",
    (True, True): "return.collide-if",
    (False, False): "return.apart-when",
    (False, True): "return.apart-if",
}


def condition_of(
    relation: Meets, naming: Naming, *, inequality: bool, written: Layout | None = None
) -> Sentence | None:
    """When bodies meet; None of two spheres that have not met before.

    With ``inequality`` what it says of components comes next: of a wall, what is ``told`` of the
    letter for one.
    """
    one, other = relation.first.name, relation.second.name
    if naming.bodies.get(other) == "wall":
        again = say("again") if relation.again else ""
        sense = "towards" if relation.happens else "away"
        topic = "condition" if inequality else "meeting"
        if inequality and written is not None:
            return say(_MEETINGS["letter", sense], body=one, wall=other, again=again, told=written)
        return say(_MEETINGS[topic, sense], body=one, wall=other, again=again)
    met = [event for event in naming.events.values() if set(event.bodies) == {one, other}]
    if not met:
        return None
    name: SentenceId
    if inequality:
        name = "collide-again.if" if relation.happens else "collide-again.unless"
    else:
        name = "meeting.collide" if relation.happens else "meeting.apart"
    order = _in_order(naming, met[-1].number)
    if order is not None:
        behind, ahead, axis = order
        slots = {"behind": behind, "ahead": ahead, "axis": naming.layout(axis)}
        return say(_BEHIND[name], **slots)
    return say(name, one=one, other=other)


def _in_order(naming: Naming, number: int) -> tuple[str, str, Unit] | None:
    """Who is behind and who ahead in the direction of **i** or **j** when two spheres have met.

    None where no fact tells along **i** or **j** who came to whom in that impact.
    """
    fact = naming.derivation.fact(f"approach {number}")
    match None if fact is None else fact.relation.only[0]:
        case Link(
            Quantity("along", (Quantity("velocity", (Name(one),)), Unit() as axis)),
            ">" | "<" as sign,
            Quantity("along", (Quantity("velocity", (Name(other),)), _)),
        ):
            return (one, other, axis) if sign == ">" else (other, one, axis)
    return None


def passing_of(relation: Meets, fact: Fact, naming: Naming) -> Sentence | None:
    """When a path comes to a wall with ends; None of a fact that does not tell of a path."""
    link = fact.relation.options[0][0]
    match link.right if len(fact.relation.options) == 1 else link.left:
        case Binary(
            "+",
            _,
            Binary(
                "*",
                Binary("-", level, _),
                Binary("/", Quantity("along", (_, Unit(beside))), Quantity("along", (_, across))),
            ),
        ) if isinstance(across, Unit):
            pass
        case _:
            return None
    coordinate = {"i": "x", "j": "y"}
    line = naming.relation(equality(Letter(coordinate[across.axis]), level))
    name = "condition.between" if relation.happens else "condition.beyond"
    body, wall = relation.first.name, relation.second.name
    return say(name, body=body, wall=wall, line=line, axis=coordinate[beside])


def returning_of(
    relation: Meets, fact: Fact, naming: Naming, *, inequality: bool = True
) -> Sentence | None:
    """When spheres meet as one comes back from a wall; None of a fact that tells of none."""
    link = fact.relation.options[0][0]
    stages = [
        node.stage
        for node in walk(link.left)
        if is_quantity(node, "velocity") and isinstance(node.stage, int)
    ]
    if not isinstance(link.left, Binary) or not stages:
        return None
    back = returning(naming.problem, relation, max(stages))
    if back is None:
        return None
    one, other = relation.first.name, relation.second.name
    name = _RETURNS[relation.happens, inequality]
    return say(name, one=one, other=other, body=back.returning, wall=back.wall)


def closing_of(relation: Meets, naming: Naming) -> Sentence | None:
    """That the gap between spheres closes, or does not, where it was claimed otherwise."""
    pair = {relation.first.name, relation.second.name}
    met = [event for event in naming.events.values() if set(event.bodies) == pair]
    if not met or "wall" in {naming.bodies.get(member) for member in pair}:
        return None
    one, other = met[-1].bodies
    name = "claim.gap-does-not-close" if relation.happens else "claim.gap-closes"
    return say(name, one=one, other=other)


def meetings(derivation: Derivation, ends: Ends, naming: Naming) -> Iterator[tuple[int, Sentence]]:
    """The lines in which what is to be shown of a meeting begins, and when it happens."""
    for end in derivation.items:
        asked = ends.item(end.item)
        line = derivation.line(end.line)
        if line is None or not isinstance(asked, Show) or not isinstance(asked.relation, Meets):
            continue
        yield from _meeting(derivation, asked.relation, line, ends.events_before(end.item), naming)
    for note in derivation.notes:
        asked = ends.item(note.item)
        line = derivation.line(max(note.lines, default=0))
        if line is None or not isinstance(asked, Show) or not isinstance(asked.relation, Meets):
            continue
        if note.kind == "refuted" and not note.instance and line.item == note.item:
            true = replace(asked.relation, happens=not asked.relation.happens)
            yield from _meeting(derivation, true, line, ends.events_before(note.item), naming)


def _meeting(
    derivation: Derivation, relation: Meets, last: Line, events: int, naming: Naming
) -> Iterator[tuple[int, Sentence]]:
    """The line in which a meeting begins to be shown, and when it happens."""
    first = _first(derivation, last)
    match last.relation:
        case Relation(((*_, Link(Binary("+", _, back), sign, _)),)):
            own = returning(naming.problem, relation, events)
            if own is None:
                return
            speed = _speed(derivation, first)
            side = Negate(back) if (sign[0] == "<") == relation.happens else back
            slots = {
                "one": relation.first.name,
                "other": relation.second.name,
                "body": own.returning,
                "wall": own.wall,
                "speed": naming.layout(side if speed is None else speed[1]),
            }
            towards = len(last.relation.options[0]) > 1
            met: SentenceId = "return.collide" if towards else "return.collide-back"
            name: SentenceId = met if relation.happens else "return.apart"
            yield (first if speed is None else speed[0]).number, say(name, **slots)
            return
    sentence = condition_of(relation, naming, inequality=False)
    if sentence is not None:
        yield first.number, sentence


def _speed(derivation: Derivation, gap: Line) -> tuple[Line, Expression] | None:
    """The line on which that of a gap rests that says with which speed a sphere comes back."""
    for ref in gap.premises:
        own = derivation.line(ref)
        if own is None or own.item != gap.item:
            continue
        match own.relation:
            case Relation(((Link(Binary("*") | Negate(Binary("*")) as speed, "=", _), *_),)):
                return own, speed
    return None


def _first(derivation: Derivation, line: Line) -> Line:
    """The line of a difference or sum on which a comparison rests; without one the comparison."""
    for ref in line.premises:
        own = derivation.line(ref)
        if own is None or own.item != line.item:
            continue
        match own.relation:
            case Relation(((Link(Binary("-" | "+"), "=", _), *_),)):
                return own
    return line


__all__ = ["closing_of", "condition_of", "meetings", "passing_of", "returning_of"]
