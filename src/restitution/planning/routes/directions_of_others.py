"""Directions that are given by the velocity of another body: that velocity is worked out first."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.expression.tree import Expression, Name, Quantity
from restitution.planning.angles.lines_between import whole_velocity
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import UNPLANNED
from restitution.planning.writing.scene import Scene


def write_velocities_of_others(scene: Scene, solver: Solver) -> None:
    """Writes the velocities along or across which those move off who were at rest.

    They are written where they tell a line of centres, and come of earlier impacts.
    """
    for number, own in scene.model.frames.items():
        if own.wall is not None or f"axis {number}" in scene.facts or number in scene.frames:
            continue
        for other, event in list(_velocities(scene, number)):
            if scene.desk.known(Quantity("velocity", (Name(other),), event)) is not None:
                continue
            standing = solver.mark()
            try:
                solver.determine(list(scene.velocity(other, event)))
                source = whole_velocity(scene, other, event)
                if scene.unknown(source.value):
                    solver.back(standing)
                else:
                    velocity = Quantity("velocity", (Name(other),), event)
                    scene.desk.know(velocity, source.value, source.refs)
            except UNPLANNED:
                solver.back(standing)


def _velocities(scene: Scene, number: int) -> Iterator[tuple[str, int]]:
    """The velocities before an impact by which the directions after it are given."""
    for equation in scene.given:
        if equation.link.sign not in ("parallel to", "perpendicular to"):
            continue
        sides: tuple[Expression, ...] = (equation.link.left, equation.link.right)
        for late, other in (sides, sides[::-1]):
            match late, other:
                case (
                    Quantity("velocity", (Name(body),), int(event)),
                    Quantity("velocity", (Name(name),), int(stage)),
                ) if event == number and body in scene.spheres(number):
                    last = scene.last_event(name, stage)
                    if 0 < last < number:
                        yield name, last


__all__ = ["write_velocities_of_others"]
