"""Velocities that stand as vectors with **i** and **j**, so that their scalar product is plain."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from restitution.exact import tidy
from restitution.expression.tree import Name, Polar, Quantity
from restitution.planning.formulas.turns import Moving
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def stand_as_vectors(scene: Scene, pair: Iterable[Moving]) -> bool:
    """Whether two velocities stand as slanting vectors, and the cosine between them is plain.

    They are given with **i** and **j**, or a line has put them together. Of one along **i** or
    **j** an angle is read off by a tangent.
    """
    vectors = [_standing(scene, *each) for each in pair]
    a, b = vectors
    if a is None or b is None or not all((*a, *b)):
        return False
    dot = tidy(sp.expand(a.dot(b)))
    squares = tidy(sp.expand(a.dot(a))) * tidy(sp.expand(b.dot(b)))
    return bool(dot) and bool(tidy(dot**2 / squares).is_Rational)


def _standing(scene: Scene, body: str, stage: int) -> Vector | None:
    """A velocity that is a vector of the data, or of a line; None of another."""
    last = scene.last_event(body, stage)
    velocity = Quantity("velocity", (Name(body),), last)
    if not last:
        fact = scene.facts.get(f"velocity {body}")
        if fact is None or isinstance(fact.relation.only[0].right, Polar):
            return None
        value = scene.initial(body).value
    elif (known := scene.desk.known(velocity)) is not None:
        value = known.value
    else:
        given = [equation for equation in scene.given if equation.link.left == velocity]
        if len(given) != 1 or given[0].link.sign != "=":
            return None
        value = scene.value(given[0].link.right)
    return scene.put(value)[0] if isinstance(value, Vector) else None


__all__ = ["stand_as_vectors"]
