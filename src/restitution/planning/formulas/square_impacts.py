"""Impacts with a wall that are given to be at right angles: the speed is all that counts there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.definitions.ties import tie_of
from restitution.explaining.lines.derivation import Move, Ref, Showing
from restitution.expression.tree import Apply, Name, Quantity, letters
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import ZERO, square, total, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def component_at_right_angles(
    scene: Scene, kind: str, body: str, stage: int, frame: Frame, parts: Sequence[Source]
) -> Source | None:
    """A component before an impact with a wall that is struck at right angles, as given or shown.

    Along the wall it is zero, towards it the speed, by the ``parts`` of the velocity in its own
    frame. None where that is not given, or where a part has an unknown.
    """
    given = _right_angle(scene, body, stage, frame)
    if given is None or any(scene.unknown(part.value) for part in parts):
        return None
    beside, towards = (frame.component(own, body, stage) for own in ("across", "along"))
    if scene.desk.known(towards) is None or scene.desk.known(beside) is None:
        mark = scene.desk.mark()
        if not _written(scene, beside, towards, frame, parts, given):
            scene.desk.back(mark)
            return None
    return scene.desk.known(towards if kind == "along" else beside)


def _right_angle(scene: Scene, body: str, stage: int, frame: Frame) -> tuple[Ref, ...] | None:
    """What says that the velocity before an impact is perpendicular to the wall."""
    if frame.wall is None or scene.last_event(body, frame.number - 1) != stage:
        return None
    sides = {Quantity("velocity", (Name(body),), stage), Name(frame.wall)}
    for equation in scene.given:
        tie = tie_of(equation.link)
        if tie is not None and tie[2] == "perpendicular to" and set(tie[:2]) == sides:
            return (*equation.refs, f"wall {frame.wall}", f"axis {frame.number}")
    for end in scene.desk.ends:
        if end.shown and scene.desk.holds(end.line):
            tie = tie_of(end.answer.options[0][0])
            if tie is not None and tie[2] == "perpendicular to" and set(tie[:2]) == sides:
                return (end.line, f"wall {frame.wall}", f"axis {frame.number}")
    return None


def _written(
    scene: Scene,
    beside: Quantity,
    towards: Quantity,
    frame: Frame,
    parts: Sequence[Source],
    given: tuple[Ref, ...],
) -> bool:
    """Whether the lines of both components are written, below that of the speed."""
    (velocity, *_) = beside.arguments
    assert isinstance(velocity, Quantity)
    speed = replace(velocity, kind="speed")
    (body,) = speed.arguments
    assert isinstance(body, Name)
    assert isinstance(speed.stage, int)
    move = Move("define", "perpendicular", frame.number, (body.name,))
    relation = chain(beside, (ZERO, None))
    refs = scene.judge.needed(move, given, relation)
    if refs is None:
        return False
    # What was shown is recalled in the words before the next line.
    shown: Showing = "silent" if any(isinstance(ref, int) for ref in refs) else "line"
    zero = scene.desk.write(move, refs, relation, shown)
    scene.desk.know(beside, sp.Integer(0), (zero,))
    known = scene.desk.known(speed)
    if known is None:
        number = write_formula(scene, _speed(speed, body.name, speed.stage, parts))
        own = scene.desk.line(number)
        if not scene.judge.follows(own.move, own.premises, scene.desk.relation(number)):
            return False
        known = scene.desk.known(speed)
    assert known is not None
    move = Move("define", "component", frame.number, (body.name,))
    relation = chain(towards, (tree_of(known.value), None))
    others = background(scene, letters(relation.only[0].right))
    refs = scene.judge.enough(move, (*known.refs, zero), relation, others)
    if refs is None:
        return False
    scene.desk.know(towards, known.value, (scene.desk.write(move, refs, relation),))
    return True


def _speed(speed: Quantity, body: str, stage: int, parts: Sequence[Source]) -> Formula:
    """The speed by its components."""
    tree = Apply("sqrt", total(square(tree_of(part.value)) for part in parts if part.value != 0))
    value = tidy(sp.sqrt(tidy(sum(part.value**2 for part in parts))))
    refs = together(*(part.refs for part in parts))
    return Formula(Move("define", "speed", stage, (body,)), itself, speed, tree, value, refs)
