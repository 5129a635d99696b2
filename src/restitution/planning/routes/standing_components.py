"""A velocity that is given, of which an earlier part has a component in a letter: 3eu = u."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import COMPONENTS, Expression, Name, Quantity
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import UnwrittenError, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.vector import Vector


class _Standing(NamedTuple):
    """A component that a line has: of which body, what it is, its value, and its axis."""

    body: str
    component: Expression
    value: Source
    axis: Vector
    frame: Frame


def is_compared(scene: Scene, given: GivenEquation) -> bool:
    """Whether a line has a component, in letters that are open, of a velocity that is given.

    Then the line that compares them can be written.
    """
    if not any(_standing(scene, given)):
        return False
    mark = scene.desk.mark()
    try:
        write_component_given(scene, given)
    except (NotPlannedError, UnwrittenError):
        return False
    finally:
        scene.desk.back(mark)
    return True


def write_component_given(scene: Scene, given: GivenEquation) -> int:
    """The line in which a component that stands in letters is that of the given vector.

    Raises NotPlannedError where none stands so.
    """
    mark = scene.desk.mark()
    for own in _standing(scene, given):
        value, refs = scene.put(scene.vector(given.link.right).dot(own.axis))
        move = Move("define", "component", own.frame.number, (own.body,))
        pool, right = together(given.refs, refs, own.frame.refs), tree_of(value)
        relation = chain(tree_of(own.value.value), (right, None))
        line = scene.judge.write((move,), together(pool, own.value.refs), relation)
        if line is not None:
            return line
        component = chain(own.component, (right, None))
        number = scene.judge.write((move,), pool, component, (), "silent")
        if number is not None:
            line = scene.judge.write((Move("put"),), (number, *own.value.refs), relation)
            if line is not None:
                return line
        scene.desk.back(mark)
    raise NotPlannedError("a velocity that is given is put into the laws")


def _standing(scene: Scene, given: GivenEquation) -> Iterator[_Standing]:
    match given.link.left:
        case Quantity("velocity", (Name(body),), int(stage)) if stage in scene.model.frames:
            frame = scene.frame(stage)
        case _:
            return
    for kind, axis in zip(COMPONENTS, (frame.n, frame.t), strict=True):
        component = frame.component(kind, body, stage)
        own = scene.desk.known(component)
        if own is not None and not isinstance(own.value, Vector) and scene.unknown(own.value):
            yield _Standing(body, component, own, axis, frame)


__all__ = ["is_compared", "write_component_given"]
