"""Which of two opposite vectors is towards a wall, where what is given is only parallel to them."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from restitution.explaining.lines.derivation import Derivation, Event, Line
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import Expression, Polar, Quantity, walk
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.workings.naming.measured import vector_worth


def normal_towards(
    derivation: Derivation,
    event: Event,
    normal: Vector,
    layout: Callable[[Expression], lay.Layout],
    *,
    turned: bool = False,
) -> Sentence | None:
    """That a vector leads into a wall, by the velocity of the data with which a body comes.

    It is said where the impulse is given as parallel to something, so in either sense, of that
    vector, or with ``turned`` of the opposite one. None elsewhere, and where no such velocity
    stands in the data.
    """
    body, wall = event.bodies
    data = derivation.fact(f"velocity {body}")
    earlier = any(e.number < event.number and body in e.bodies for e in derivation.events)
    vectors = (_given(derivation, event, line) for line in derivation.lines)
    given = next((vector for vector in vectors if vector is not None), None)
    if data is None or earlier or given is None:
        return None
    velocity = data.relation.only[-1].right
    value, own = vector_worth(velocity), vector_worth(given)
    if value is None or own is None:
        return None
    product, sense = (sp.factor(vector.dot(normal)) for vector in (value, own))
    if not product.is_positive or not (sense.is_negative if turned else sense.is_positive):
        return None
    if any(isinstance(node, Polar) for node in walk(velocity)):
        velocity = tree_of(value)
    along = tree_of(normal)
    sides = (Quantity("dot", (velocity, along)), tree_of(product), ZERO)
    reason = lay.Relation(tuple(map(layout, sides)), ("=", ">"))
    if turned:
        return say("sense.turned-into", reason=reason, wall=wall)
    return say("sense.into", reason=reason, vector=layout(along), wall=wall)


def _given(derivation: Derivation, event: Event, line: Line) -> Expression | None:
    """The vector to which the impulse of an event is given as parallel, where a line uses it."""
    if (line.move.record, line.move.event) != ("across-the-impulse", event.number):
        return None
    given = (fact for fact in derivation.facts_in(line.premises) if fact.kind == "given")
    for link in (fact.relation.options[0][0] for fact in given):
        if link.sign == "parallel to":
            return link.right
    return None


__all__ = ["normal_towards"]
