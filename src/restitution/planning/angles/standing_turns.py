"""A deflection by the angles of both paths to one line, where both of these stand already."""

from __future__ import annotations

from collections.abc import Callable

from restitution.expression.tree import Quantity
from restitution.planning.angles.turn_lines import write_turn
from restitution.planning.formulas.turns import Direction, turns_of
from restitution.planning.writing.scene import Scene


def turn_of_standing_angles(
    scene: Scene, asked: Quantity, angle_line: Callable[[Scene, Quantity], int]
) -> int | None:
    """The line of a deflection as the difference of two angles that are lines, or its like.

    None where one of both would still have to be worked out.
    """
    mark = scene.desk.mark()
    for turn in turns_of(scene, asked):
        if _stands(scene, turn.first) and _stands(scene, turn.second):
            line = write_turn(scene, turn, angle_line)
            if line is not None:
                return line
        scene.desk.back(mark)
    return None


def _stands(scene: Scene, side: Direction) -> bool:
    """Whether a line says what an angle is, which is more than that the data have it."""
    return scene.desk.known(side.named) is not None


__all__ = ["turn_of_standing_angles"]
