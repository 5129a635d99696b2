"""Blows: the velocity of a body after an impulse that is given."""

from __future__ import annotations

from restitution.expression.tree import Name, Quantity
from restitution.planning.impacts import blown
from restitution.planning.scene import Scene
from restitution.problem import Kick


def write_blows(scene: Scene) -> None:
    """Writes the velocities after blows, as far as all is known on which they rest."""
    for number in range(1, scene.events + 1):
        step = scene.model.happening(number).step
        if not isinstance(step, Kick):
            continue
        if scene.desk.known(Quantity("velocity", (Name(step.body),), number)) is None:
            velocities = [scene.velocity(step.body, each) for each in (number - 1, number)]
            if not any(scene.unknown(each) for each in velocities):
                blown(scene, step.body, number)
