"""The angle of a path to a wall by that to the last one: at right angles to it, or any other."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from restitution.exact import tidy_angle
from restitution.explaining.lines.derivation import Move, numbers_in
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    Binary,
    Degrees,
    Letter,
    Name,
    Quantity,
)
from restitution.planning.angles.turn_lines import inverse_of_data
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.named_angles import letter_known
from restitution.planning.formulas.next_walls import angle_to_a_wall, standing_angle, turn_of_wall
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.scene import Scene


def complement_to_a_wall(scene: Scene, body: str, stage: int, wall: str) -> Source | None:
    """The angle to a wall by that to the last one, at right angles to it: 90° − β.

    The angle β stands by its inverse tangent; None where it does not.
    """
    frame = scene.model.frames.get(stage)
    if frame is None or frame.wall in (None, wall) or circle_of(scene, stage) is not None:
        return None
    assert frame.wall is not None
    here, there = (turn_of_wall(scene, name) for name in (frame.wall, wall))
    if not (isinstance(here, Degrees) and isinstance(there, Degrees)):
        return None
    velocity = Quantity("velocity", (Name(body),), stage)
    first = Quantity("angle", (velocity, Name(frame.wall)))
    named, known = letter_known(scene, first), standing_angle(scene, first)
    if abs(here.value - there.value) != RIGHT_ANGLE.value or named is None or known is None:
        return None
    mark = scene.desk.mark()
    letter, value = Letter(named[0]), tidy_angle(sp.pi / 2 - known.value)
    asked = Quantity("angle", (velocity, Name(wall)))
    move = Move("define", "difference", stage, (body,))
    relation = chain(asked, (Binary("-", RIGHT_ANGLE, letter), None))
    frame_ = scene.frame(stage)
    parts = (in_direction(scene, kind, body, stage, frame_) for kind in COMPONENTS)
    walls = (f"wall {frame.wall}", f"wall {wall}")
    pool = together(known.refs, *(own.whole for own in parts), walls)
    refs = scene.judge.needed(move, pool, relation, known.refs)
    if refs is None:
        return None
    first_line = scene.desk.write(move, refs, relation, shown="inline")
    lines = numbers_in(known.refs)
    stands = next(scene.desk.last_link(n) for n in lines if scene.desk.line(n).move.id != "let")
    right = Binary("-", RIGHT_ANGLE, stands.right)
    put = scene.judge.needed(Move("put"), (first_line, *lines), chain(asked, (right, None)))
    if put is None:
        scene.desk.back(mark)
        return None
    line = scene.desk.write(Move("put"), put, chain(asked, (right, None)))
    return scene.desk.know(asked, value, (line,))


def by_the_wall_before(
    scene: Scene,
    body: str,
    stage: int,
    wall: str,
    angle_line: Callable[[Scene, Quantity], int],
) -> Source | None:
    """The angle to the next wall by that to the wall before, which is worked out first.

    None at right angles to it: components are along both walls.
    """
    frame = scene.model.frames.get(stage)
    walls = [None if frame is None else frame.wall, wall]
    turns = [turn_of_wall(scene, name) for name in walls if name is not None]
    if frame is None or frame.wall == wall or len(turns) < 2:
        return None
    degrees = [turn.value for turn in turns if isinstance(turn, Degrees)]
    if frame.axis is None or len(degrees) < len(turns):
        return None
    if abs(degrees[0] - degrees[1]) == RIGHT_ANGLE.value:
        return None
    mark = scene.desk.mark()
    velocity = Quantity("velocity", (Name(body),), stage)
    try:
        angle_line(scene, Quantity("angle", (velocity, Name(frame.wall or ""))))
        own = angle_to_a_wall(scene, body, stage, wall)
    except NotPlannedError:
        own = None
    if own is None:
        scene.desk.back(mark)
    return own


def angle_by_walls(
    scene: Scene, asked: Quantity, angle_line: Callable[[Scene, Quantity], int]
) -> int | None:
    """The line of an angle to a wall by that to the wall before, or by that before it; or None."""
    match asked:
        case Quantity("angle", (Quantity("velocity", (Name(body),), int(stage)), Name(wall))):
            own = angle_to_a_wall(scene, body, stage, wall)
            own = own or complement_to_a_wall(scene, body, stage, wall)
            own = own or by_the_wall_before(scene, body, stage, wall, angle_line)
            lines = () if own is None else (ref for ref in own.refs if isinstance(ref, int))
            line = next(iter(lines), None)
            return None if line is None else by_a_given_ratio(scene, asked, line)
    return None


def by_a_given_ratio(scene: Scene, asked: Quantity, line: int) -> int:
    """The line of an angle that is a letter of the data, with what a ratio says that this is."""
    own = scene.desk.last_link(line).right
    if not isinstance(own, Letter) or own.name not in scene.ratio_facts:
        return line
    known = inverse_of_data(scene, own.name)
    relation = chain(asked, (scene.desk.last_link(known).right, None))
    premises = scene.judge.enough(Move("put"), (line, known), relation)
    if premises is None:
        return line
    return scene.desk.write(Move("put"), premises, relation)


__all__ = ["angle_by_walls", "by_a_given_ratio"]
