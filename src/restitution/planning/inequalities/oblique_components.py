"""Components of a velocity that are neither along nor across the line of an impact."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.expression.tree import Name, Quantity
from restitution.planning.formulas.velocity_formulas import body_and_stage, frame_after
from restitution.planning.writing.scene import Scene


def is_oblique(scene: Scene, component: Quantity) -> bool:
    """Whether a component is neither along nor across the line of the last impact of its body."""
    match component.arguments:
        case (Quantity("velocity", (Name(),), int()) as velocity, axis):
            body, stage = body_and_stage(scene, velocity)
        case _:
            return False
    if not stage:
        return False
    frame = frame_after(scene, body, stage)
    direction = scene.model.story.direction(axis, scene.events)
    return all(tidy(direction.cross(own)) != 0 for own in (frame.n, frame.t))


__all__ = ["is_oblique"]
