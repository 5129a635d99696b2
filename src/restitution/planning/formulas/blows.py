"""Blows: the velocity of a body after an impulse that is given."""

from __future__ import annotations

from restitution.expression.tree import Name, Quantity
from restitution.planning.formulas.impacts import blown
from restitution.planning.writing.desk import together
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.vectors import velocity_given
from restitution.problem import Kick


def write_blows(scene: Scene) -> None:
    """Writes the velocities after blows, as far as all is known on which they rest."""
    for number in range(1, scene.events + 1):
        step = scene.model.happening(number).step
        if not isinstance(step, Kick):
            continue
        quantity = Quantity("velocity", (Name(step.body),), number)
        if scene.desk.known(quantity) is None:
            given = velocity_given(scene, step.body, number)
            if given is not None and not scene.unknown(given[1]):
                value, refs = scene.put(given[1])
                scene.desk.know(quantity, value, together(given[2], refs))
                continue
            velocities = [scene.velocity(step.body, stage) for stage in (number - 1, number)]
            if not any(scene.unknown(velocity) for velocity in velocities):
                blown(scene, step.body, number)
