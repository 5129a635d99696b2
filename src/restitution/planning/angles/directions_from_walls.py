"""The direction in which a body leaves a slanting wall, by that of the wall and its angle to it."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from restitution.exact import tidy_angle
from restitution.explaining.definitions.next_walls import from_a_wall
from restitution.explaining.lines.derivation import Move, MoveId
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import RIGHT_ANGLE, Degrees, Expression, Name, Quantity
from restitution.planning.formulas.components_of_data import is_polar
from restitution.planning.formulas.next_walls import standing_angle, turn_of_wall
from restitution.planning.formulas.velocity_formulas import body_and_stage
from restitution.planning.writing.angles import angle_to_a_line
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene


def direction_from_a_wall(
    scene: Scene, asked: Quantity, angle_line: Callable[[Scene, Quantity], int]
) -> int | None:
    """The line of a direction by the angle to the wall that a body leaves: 20° + β.

    None where its velocity stands as a vector, or a direction is not in degrees.
    """
    body, stage = body_and_stage(scene, asked)
    model_frame = scene.model.frames.get(stage)
    if model_frame is None or model_frame.wall is None or circle_of(scene, stage) is not None:
        return None
    velocity, wall = Quantity("velocity", (Name(body),), stage), model_frame.wall
    here = turn_of_wall(scene, wall)
    if not isinstance(here, Degrees) or here.value % RIGHT_ANGLE.value == 0:
        return None
    if scene.desk.known(velocity) is not None or not _is_at_an_angle(scene, body, stage):
        return None
    own = scene.velocity(body, stage)
    value = sp.sympify(scene.model.in_data(own.y * own.x), strict=True)
    if scene.unknown(value):
        return None
    mark = scene.desk.mark()
    angle = Quantity("angle", (velocity, Name(wall)))
    line = angle_line(scene, angle)
    known = standing_angle(scene, angle)
    size = scene.desk.last_link(line).right
    move = Move("define", "difference", stage, (body,))
    pool = together((line,), () if known is None else known.refs, (f"wall {wall}",))
    for onward in (1, -1):
        for left in (1, -1):
            for form in from_a_wall(here, angle, onward, left):
                tree = exchanged(form, {angle: size})
                value = tidy_angle(scene.scalar(tree))
                steps: list[tuple[Expression, MoveId | None]] = [(tree, None)]
                if bool((value / sp.pi).is_Rational):
                    steps.append((tree_of(value, angle=True, as_it_is=True), "rearrange"))
                relation = chain(asked, *steps)
                refs = scene.judge.needed(move, pool, relation, (line,))
                if refs is not None:
                    return scene.desk.write(move, refs, relation)
    scene.desk.back(mark)
    return None


def _is_at_an_angle(scene: Scene, body: str, stage: int) -> bool:
    """Whether a velocity of the data is told by an angle; along an axis by that of the wall."""
    if is_polar(scene, body):
        return True
    wall = scene.facts.get(f"wall {scene.model.frames[stage].wall}")
    if wall is None or scene.last_event(body, stage - 1):
        return False
    return angle_to_a_line(scene, body, wall.relation.only[0].right) is not None


__all__ = ["direction_from_a_wall"]
