"""Velocities that stand as vectors with **i** and **j**, so that their scalar product is plain."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Relation
from restitution.expression.tree import COMPONENTS, Name, Polar, Quantity
from restitution.planning.formulas.turns import Moving
from restitution.planning.writing.desk import Source
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.vector import Vector


def stand_as_vectors(scene: Scene, pair: Iterable[Moving]) -> bool:
    """Whether two velocities stand as slanting vectors, and the cosine between them is plain.

    They are given with **i** and **j**, or a line has put them together. Of one along **i** or
    **j** an angle is read off by a tangent.
    """
    both = _slanting(scene, pair)
    if both is None:
        return False
    a, b = both
    dot = tidy(expanded(a.dot(b)))
    squares = tidy(expanded(a.dot(a))) * tidy(expanded(b.dot(b)))
    return bool(dot) and bool(tidy(dot**2 / squares).is_Rational)


def stand_beside_the_line(scene: Scene, pair: Sequence[Moving]) -> bool:
    """Whether two velocities stand as vectors of which the cosine between them is plain.

    They do so beside a slanting line of centres, of which a component would have to be found.
    """
    event = max(stage for _, stage in pair)
    vectors = [_standing(scene, *state) for state in pair]
    if event not in scene.model.frames or not scene.frame(event).is_slanted:
        return False
    a, b = vectors
    if a is None or b is None:
        return False
    frame = scene.frame(event)
    components = [frame.component(kind, body, event) for kind in COMPONENTS for body, _ in pair]
    if not any(_is_new(scene, component) for component in components):
        return False
    squares = tidy(expanded(a.dot(a))) * tidy(expanded(b.dot(b)))
    if squares == 0:
        return False
    squared = tidy(expanded(a.dot(b)) ** 2 / squares)
    return bool(squared) and bool(squared.is_Rational)


def _is_new(scene: Scene, component: Quantity) -> bool:
    """Whether no line has a component, or the item at hand is the first that needs it."""
    known = scene.desk.known(component)
    if known is None:
        return True
    refs = (*known.refs, *scene.put(known.value)[1])
    return any(scene.desk.line(ref).item == scene.desk.item for ref in refs if isinstance(ref, int))


def stand_at_right_angles(scene: Scene, pair: Iterable[Moving]) -> bool:
    """Whether two velocities stand as slanting vectors at right angles."""
    both = _slanting(scene, pair)
    return both is not None and bool(tidy(expanded(both[0].dot(both[1]))) == 0)


def _slanting(scene: Scene, pair: Iterable[Moving]) -> tuple[Vector, Vector] | None:
    """Two velocities that stand as vectors, neither of them along **i** or **j**."""
    a, b = (_standing(scene, *state) for state in pair)
    return None if a is None or b is None or not all((*a, *b)) else (a, b)


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


def change_as_vectors(scene: Scene, body: str, event: int) -> bool:
    """Whether the velocities of a body about an impact stand as vectors without roots.

    Its components along the line of centres, or perpendicular to the wall, have a root then: of
    such a direction as 4**i** − **j**. A velocity that was put together from components is none,
    nor is one after another impact.
    """
    frame = scene.frame(event)
    if not frame.is_slanted or whole_direction(frame.n)[1].is_Rational:
        return False
    if scene.last_event(body, event - 1):
        return False
    component = frame.component("along", body, event)
    if any(getattr(line.relation, "quantity", None) == component for line in scene.desk.lines):
        return False
    after = scene.desk.known(Quantity("velocity", (Name(body),), event))
    if after is not None and _is_made_of(scene, after, component):
        return False
    vectors = [_standing(scene, body, stage) for stage in (event - 1, event)]
    return all(
        vector is not None
        and not any(map(scene.unknown, vector))
        and not any(power.exp.is_Rational and power.exp.q > 1 for power in _powers(vector))
        for vector in vectors
    )


def _is_made_of(scene: Scene, velocity: Source, component: Quantity) -> bool:
    """Whether a velocity was put together from a component."""
    relations = (line.relation for line in scene.desk.lines_under(velocity))
    return any(
        isinstance(relation, Relation) and relation.options[0][0].left == component
        for relation in relations
    )


def _powers(vector: Vector) -> set[sp.Pow]:
    """The powers in the components of a vector."""
    parts = (sp.sympify(part, strict=True) for part in vector)
    return {power for part in parts for power in part.atoms(sp.Pow)}


__all__ = [
    "change_as_vectors",
    "stand_as_vectors",
    "stand_at_right_angles",
    "stand_beside_the_line",
]
