"""The angle of a path to a wall by that to the last one, at right angles to it."""

from __future__ import annotations

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
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.named_angles import letter_known
from restitution.planning.formulas.next_walls import standing_angle, turn_of_wall
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import tree_of
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
    if sp.sympify(known.value, strict=True).free_symbols:
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
    right = Binary("-", RIGHT_ANGLE, tree_of(known.value, angle=True, as_it_is=True))
    lines = numbers_in(known.refs)
    put = scene.judge.needed(Move("put"), (first_line, *lines), chain(asked, (right, None)))
    if put is None:
        scene.desk.back(mark)
        return None
    line = scene.desk.write(Move("put"), put, chain(asked, (right, None)))
    return scene.desk.know(asked, value, (line,))


__all__ = ["complement_to_a_wall"]
