"""Why a line of centres that is worked out has its sense: the impulse is away from the other."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Derivation, Event, Fact, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Binary, Expression, Polar, Quantity, Unit, letters, walk
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.measured import vector_worth
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.towards_walls import normal_towards


def sense_of_a_change(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """What is said before a line of centres in the sense opposite to a change of velocity.

    A body is pushed away from the other one, or from the wall; None of any other line.
    """
    own, above = _direction(line), _change(derivation, line)
    if own is None or above is None:
        return None
    event = naming.events.get(_event(derivation, line))
    before = _direction(above)
    if event is None or before is None or not above.move.bodies:
        return None
    (body,) = above.move.bodies
    one, other = vector_worth(own), vector_worth(before)
    if one is None or other is None or sp.expand(one.cross(other)) != 0:
        return None
    if _is_shortened(derivation, line, one):
        return None  # the shorter vector has the sentence
    towards = sp.expand(one.dot(other)).is_negative
    pushed, from_ = event.bodies if body == event.bodies[0] else event.bodies[::-1]
    if towards != (body == event.bodies[0]):
        return None
    if not event.wall and not _is_multiple(one, other) and _is_in_a_letter(derivation, before):
        sides = _approaching(derivation, event, one)
        if sides is not None:
            return _approach(derivation, naming, event, sides, own)
    if event.wall:
        into = normal_towards(derivation, event, one, naming.layout, turned=True)
        if into is not None:
            return into
    opposite = "sense.opposite-wall" if event.wall else "sense.opposite"
    name = opposite if towards else "sense.away"
    return say(name, body=pushed, other=from_)


def _is_shortened(derivation: Derivation, line: Line, own: Vector) -> bool:
    """Whether the next line has the same direction by a vector that is a number times this one."""
    for other in derivation.lines:
        if other.move.id != "rearrange" or other.premises != (line.number,):
            continue
        direction = _direction(other)
        shorter = None if direction is None else vector_worth(direction)
        if shorter is None or shorter == own or not _is_multiple(shorter, own):
            continue
        return bool(sp.expand(shorter.dot(own)).is_positive)
    return False


def _is_multiple(one: Vector, other: Vector) -> bool:
    """Whether a vector is a number times another, so that no letter decides which sense it has."""
    return bool(sp.cancel(one.dot(other) / other.dot(other)).is_number)


def _is_in_a_letter(derivation: Derivation, impulse: Expression) -> bool:
    """Whether a change or an impulse has a letter that is not of the data, so an open sign."""
    data = {name for fact in derivation.facts if fact.kind == "data" for name in _letters(fact)}
    return not letters(impulse) <= data


def _approaching(
    derivation: Derivation, event: Event, line: Vector
) -> tuple[Expression, Expression] | None:
    """The velocities of two spheres of the data that approach along a line in its sense."""
    facts = [derivation.fact(f"velocity {body}") for body in event.bodies]
    sides = [fact.relation.only[-1].right for fact in facts if fact is not None]
    if len(sides) != 2 or event.number != 1:
        return None
    one, other = sides
    vectors = vector_worth(one), vector_worth(other)
    if vectors[0] is None or vectors[1] is None:
        return None
    closing = sp.expand((vectors[0] - vectors[1]).dot(line))
    return (one, other) if closing.is_positive else None


def _approach(
    derivation: Derivation,
    naming: Naming,
    event: Event,
    sides: tuple[Expression, Expression],
    line: Expression,
) -> Sentence:
    """That two spheres approach along a line, and why."""
    slots = {"one": event.bodies[0], "other": event.bodies[1], "vector": naming.side(line)}
    reason = _closing(derivation, naming, sides, line)
    if reason is None:
        return say("sense.approach", **slots)
    return say("sense.approach-as", reason=reason, **slots)


def _closing(
    derivation: Derivation, naming: Naming, sides: tuple[Expression, Expression], line: Expression
) -> lay.Layout | None:
    """``(4𝐢 − (−2𝐢 + 3𝐣)) · (𝐢 − 𝐣) = 9 > 0``: that spheres approach along a line.

    None where a letter of the working, of which the sign is open, is in the line.
    """
    first, second, along = map(vector_worth, (*sides, line))
    if first is None or second is None or along is None or letters(line) & set(derivation.meanings):
        return None
    # A velocity by its speed and an angle has no scalar product until it is resolved.
    one, other = (
        tree_of(worth) if any(isinstance(node, Polar) for node in walk(side)) else side
        for side, worth in zip(sides, (first, second), strict=True)
    )
    value = tree_of(sp.factor((first - second).dot(along)))
    relative = one if (second.x, second.y) == (0, 0) else Binary("-", one, other)
    product = Quantity("dot", (relative, line))
    return naming.relation(Relation(((Link(product, "=", value), Link(value, ">", ZERO)),)))


def _letters(fact: Fact) -> frozenset[str]:
    return frozenset(name for tree in trees_of(fact.relation) for name in letters(tree))


def direction_by_its_sense(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """A line of centres in its sense, from one body to the other; None of any other line."""
    own = _direction(line)
    event = _event_of_the_data(derivation, naming, line)
    if own is not None and sense_of_a_change(derivation, naming, line) is not None:
        event = naming.events[_event(derivation, line)]
    elif sense_of_a_given_line(derivation, naming, line) is None:
        return None
    if own is None or event is None:
        return None
    vector = naming.side(own)
    if event.wall:
        return say("sense.of-normal", wall=event.bodies[1], vector=vector)
    return say("sense.of-line", one=event.bodies[0], two=event.bodies[1], vector=vector)


def sense_of_a_normal(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """What is said before the normal to a wall whose direction the data give; None of another."""
    event = _event_of_the_data(derivation, naming, line)
    if event is None or not event.wall:
        return None
    wall = derivation.fact(f"wall {event.bodies[1]}")
    return None if wall is None else say("derived.since", facts=(fact_in_words(naming, wall),))


def sense_of_a_given_line(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """What is said before a line of centres that the data give, in its sense; None of another."""
    event, own = _event_of_the_data(derivation, naming, line), _direction(line)
    along = None if own is None else vector_worth(own)
    if event is None or event.wall or own is None or along is None:
        return None
    sides = _approaching(derivation, event, along)
    return None if sides is None else _approach(derivation, naming, event, sides, own)


def _event_of_the_data(derivation: Derivation, naming: Naming, line: Line) -> Event | None:
    """The impact whose line of centres a line has from the data; None of any other line."""
    (ref,) = line.premises if len(line.premises) == 1 else (None,)
    fact = derivation.fact(ref)
    if line.move.id not in ("fact", "rearrange") or fact is None or _direction(line) is None:
        return None
    return naming.events.get(int(fact.id.rpartition(" ")[2])) if fact.kind == "geometry" else None


def _direction(line: Line) -> Expression | None:
    """The vector to which a line says that a line of centres is parallel."""
    match line.relation:
        case Relation(((Link(Quantity("line_of_centres"), "parallel to", vector),),)):
            return vector
        case Relation(((Link(Quantity("line_of_centres"), "=", Unit() as unit),),)):
            return unit
    return None


def _event(derivation: Derivation, line: Line) -> int:
    """The impact whose change of velocity gives a direction; 0 of any other line."""
    above = _change(derivation, line)
    return 0 if above is None else above.move.event or 0


def _change(derivation: Derivation, line: Line) -> Line | None:
    """The line of the change, or of the impulse, of which a direction is made."""
    while line.move.id == "rearrange" and len(line.premises) == 1:
        (ref,) = line.premises
        above = derivation.line(ref)
        if above is None:
            return None
        if above.move.record in ("along-the-change", "across-the-impulse"):
            return above
        line = above
    return None


__all__ = [
    "direction_by_its_sense",
    "sense_of_a_change",
    "sense_of_a_given_line",
    "sense_of_a_normal",
]
