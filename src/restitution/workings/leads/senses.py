"""Why a line of centres that is worked out has its sense: the impulse is away from the other."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Derivation, Event, Fact, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Binary, Expression, Quantity, letters
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.measured import vector_worth
from restitution.workings.naming.quantities import Naming


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
    towards = sp.expand(one.dot(other)).is_negative
    pushed, from_ = event.bodies if body == event.bodies[0] else event.bodies[::-1]
    if towards != (body == event.bodies[0]):
        return None
    sides = None
    if not event.wall and not _is_multiple(one, other):
        sides = _approaching(derivation, event, before, one)
    if sides is not None:
        slots = {"one": event.bodies[0], "other": event.bodies[1], "vector": naming.side(own)}
        reason = _closing(derivation, naming, sides, own)
        if reason is None:
            return say("sense.approach", **slots)
        return say("sense.approach-as", reason=reason, **slots)
    opposite = "sense.opposite-wall" if event.wall else "sense.opposite"
    name = opposite if towards else "sense.away"
    return say(name, body=pushed, other=from_)


def _is_multiple(one: Vector, other: Vector) -> bool:
    """Whether a vector is a number times another, so that no letter decides which sense it has."""
    return bool(sp.cancel(one.dot(other) / other.dot(other)).is_number)


def _approaching(
    derivation: Derivation, event: Event, impulse: Expression, line: Vector
) -> tuple[Expression, Expression] | None:
    """The velocities of two spheres that approach along a line, where an impulse has a new letter.

    Its sign is not known then, and the velocities of the data tell the sense.
    """
    facts = [derivation.fact(" ".join(("velocity", body))) for body in event.bodies]
    sides = [fact.relation.only[-1].right for fact in facts if fact is not None]
    names = {name for fact in derivation.facts if fact.kind == "data" for name in _letters(fact)}
    if len(sides) != 2 or event.number != 1 or letters(impulse) <= names:
        return None
    one, other = sides
    vectors = vector_worth(one), vector_worth(other)
    if vectors[0] is None or vectors[1] is None:
        return None
    closing = sp.expand((vectors[0] - vectors[1]).dot(line))
    return (one, other) if closing.is_positive else None


def _closing(
    derivation: Derivation, naming: Naming, sides: tuple[Expression, Expression], line: Expression
) -> lay.Layout | None:
    """``(4𝐢 − (−2𝐢 + 3𝐣)) · (𝐢 − 𝐣) = 9 > 0``: that spheres approach along a line.

    None where a letter of the working, of which the sign is open, is in the line.
    """
    one, other = sides
    first, second, along = map(vector_worth, (one, other, line))
    if first is None or second is None or along is None or letters(line) & set(derivation.meanings):
        return None
    value = tree_of(sp.factor((first - second).dot(along)))
    relative = one if (second.x, second.y) == (0, 0) else Binary("-", one, other)
    product = Quantity("dot", (relative, line))
    return naming.relation(Relation(((Link(product, "=", value), Link(value, ">", ZERO)),)))


def _letters(fact: Fact) -> frozenset[str]:
    return frozenset(name for tree in trees_of(fact.relation) for name in letters(tree))


def direction_by_its_sense(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """A line of centres in its sense, from one body to the other; None of any other line."""
    own = _direction(line)
    if own is None or sense_of_a_change(derivation, naming, line) is None:
        return None
    event = naming.events[_event(derivation, line)]
    vector = naming.side(own)
    if event.wall:
        return say("sense.of-normal", wall=event.bodies[1], vector=vector)
    return say("sense.of-line", one=event.bodies[0], two=event.bodies[1], vector=vector)


def sense_of_a_normal(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """What is said before the normal to a wall whose direction the data give; None of another."""
    (ref,) = line.premises if len(line.premises) == 1 else (None,)
    fact = derivation.fact(ref)
    if line.move.id != "rearrange" or fact is None or _direction(line) is None:
        return None
    event = naming.events.get(int(fact.id.rpartition(" ")[2])) if fact.kind == "geometry" else None
    if event is None or not event.wall:
        return None
    wall = derivation.fact(" ".join(("wall", event.bodies[1])))
    return None if wall is None else say("derived.since", facts=(fact_in_words(naming, wall),))


def _direction(line: Line) -> Expression | None:
    """The vector to which a line says that a line of centres is parallel."""
    match line.relation:
        case Relation(((Link(Quantity("line_of_centres"), "parallel to", vector),),)):
            return vector
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


__all__ = ["direction_by_its_sense", "sense_of_a_change", "sense_of_a_normal"]
