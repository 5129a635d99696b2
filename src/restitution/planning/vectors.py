"""Velocities that are given as vectors: by their parts, or by a size and a direction."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Link, Ref
from restitution.expression.tree import Expression, Name, Quantity, walk
from restitution.planning.desk import together
from restitution.planning.forms import tree_of, vector
from restitution.planning.scene import GivenEquation, Scene
from restitution.vector import Vector


def velocity_given(
    scene: Scene, body: str, number: int
) -> tuple[Expression, Vector, tuple[Ref, ...]] | None:
    """A velocity after an event that is given: as a vector, or by its size and direction."""
    velocity = Quantity("velocity", (Name(body),), number)
    parts: dict[str, GivenEquation] = {}
    for each in scene.given:
        if each.link.sign != "=":
            continue
        if each.link.left == velocity and common_velocity(each) is None:
            value = scene.model.story.evaluator(scene.events).vector(each.link.right)
            tree = tree_of(tuple(tidy(part) for part in value))
            return tree, value, together(each.refs, _started(scene, each.link.right))
        match each.link.left:
            case Quantity("speed" | "direction" as kind, (Name(name),), event) if (
                name == body and event == number
            ):
                parts[kind] = each
    if len(parts) != 2:
        return None
    angle = scene.scalar(parts["direction"].link.right)
    direction = Vector(tidy(sp.cos(angle)), tidy(sp.sin(angle)))
    size = scene.scalar(parts["speed"].link.right)
    refs = tuple(each.fact.id for each in parts.values())
    value = direction * size
    return vector(*map(tree_of, direction)), value, together(refs)


def common_velocity(given: GivenEquation) -> tuple[str, str, int] | None:
    """Two bodies of which it is given that they have one velocity after an event."""
    match given.link:
        case Link(
            Quantity("velocity", (Name(one),), int(event)),
            "=",
            Quantity("velocity", (Name(other),), int(last)),
        ) if event == last and event and one != other:
            return one, other, event
    return None


def _started(scene: Scene, tree: Expression) -> tuple[Ref, ...]:
    """The velocities at the start of which a tree speaks."""
    return tuple(
        f"velocity {each.arguments[0].name}"
        for each in walk(tree)
        if isinstance(each, Quantity)
        and each.kind == "velocity"
        and each.stage == 0
        and isinstance(each.arguments[0], Name)
        and f"velocity {each.arguments[0].name}" in scene.facts
    )
