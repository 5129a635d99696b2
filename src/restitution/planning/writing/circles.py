"""Circular walls, as the facts tell of them."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Number,
    Pair,
    Polar,
    Quantity,
    is_quantity,
    walk,
)
from restitution.planning.writing.place_trees import place_tree
from restitution.planning.writing.scene import Scene
from restitution.problem import Arrival, trees
from restitution.vector import Vector


def circle_of(scene: Scene, number: int) -> tuple[Expression, Expression] | None:
    """The way from the centre of a circular wall to who is at it, and its radius.

    Of two spheres that touch, the way from the one centre to the other, and both radii. None where
    a contact is told in another way, or not at all.
    """
    fact = scene.facts.get(f"contact {number}")
    if fact is None:
        return None
    match fact.relation.only[0]:
        case Link(Quantity("dot", (radius_vector, other)), "=", Binary("^", radius, Number())) if (
            radius_vector == other
        ):
            return radius_vector, radius
    return None


def centre_of(radius_vector: Expression) -> Expression | None:
    """The centre of a circle, by the way from there; None for the origin."""
    return radius_vector.right if isinstance(radius_vector, Binary) else None


def from_centre(scene: Scene, number: int, place: Vector) -> Vector:
    """A place, as seen from the centre of the circle of an event."""
    circle = circle_of(scene, number)
    assert circle is not None
    centre = centre_of(circle[0])
    return place if centre is None else place - scene.vector(centre)


def chord_from(scene: Scene, body: str, number: int) -> int | None:
    """The event at which a chord begins that ends at another; 0 where a body starts on the circle.

    None where a body does not come to a circular wall from another point of it.
    """
    circle = circle_of(scene, number)
    if circle is None or len(scene.spheres(number)) > 1:
        return None
    since = scene.model.story.latest(body, number - 1)
    if since is not None:
        other = circle_of(scene, since.number)
        same = other is not None and (centre_of(other[0]), other[1]) == (
            centre_of(circle[0]),
            circle[1],
        )
        return since.number if same else None
    fact = scene.facts.get(f"position {body}")
    if fact is None or not isinstance(fact.relation.only[0].right, Pair):
        return None
    radius_vector = from_centre(scene, number, scene.vector(fact.relation.only[0].right))
    radius = scene.scalar(circle[1])
    if not scene.model.identically_zero(radius_vector.dot(radius_vector) - radius**2):
        return None
    return None if _is_told_by_places(scene, body, radius_vector) else 0


def _is_told_by_places(scene: Scene, body: str, radius_vector: Vector) -> bool:
    """Whether a way from a point of a circle is one of numbers, and directions are asked.

    The place at its end has to be found then, and gives the components there. The angle with the
    radius helps where it is one of the data, or 0.
    """
    velocity = scene.initial(body).value
    story = scene.model.story
    cosine = tidy(-velocity.dot(radius_vector) / (story.size(velocity) * story.size(radius_vector)))
    if cosine.free_symbols or cosine.has(sp.cos, sp.sin) or cosine == 1:
        return False
    velocity_fact = scene.facts.get(f"velocity {body}")
    in_degrees = velocity_fact is not None and isinstance(
        velocity_fact.relation.only[0].right, Polar
    )
    if in_degrees and cosine in _COSINES:
        return False
    nodes = [node for tree in trees(scene.problem) for node in walk(tree)]
    of_the_wall = {
        side
        for node in nodes
        if is_quantity(node, "angle") and _has_a_wall(node)
        for side in node.arguments
    }
    return any(
        isinstance(node, Quantity) and node.kind in _DIRECTED and node not in of_the_wall
        for node in nodes
    )


def _has_a_wall(angle: Quantity) -> bool:
    """Whether an angle is one with a wall, which every chord makes at both its ends."""
    return any(isinstance(side, Name) for side in angle.arguments)


_COSINES = (sp.sqrt(3) / 2, sp.sqrt(2) / 2, sp.S.Half)
_DIRECTED = {"position", "velocity", "direction", "line_of_centres"}


def chord_to_a_point(scene: Scene, body: str, number: int) -> int | None:
    """The impact with a circular wall from which a body comes straight to a point of that wall.

    None where it comes in another way.
    """
    if not isinstance(scene.model.happening(number).step, Arrival):
        return None
    since = scene.model.story.latest(body, number - 1)
    circle = None if since is None else circle_of(scene, since.number)
    if since is None or circle is None or len(scene.spheres(since.number)) > 1:
        return None
    radius_vector = from_centre(scene, since.number, Vector(*scene.value(place_tree(body, number))))
    radius = scene.scalar(circle[1])
    return (
        since.number
        if scene.model.identically_zero(radius_vector.dot(radius_vector) - radius**2)
        else None
    )
