"""How fast two spheres separate along their line of centres, by the law of restitution alone."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Ref
from restitution.expression.tree import Binary, Expression, Letter, Name, Quantity
from restitution.planning.formulas.impacts import (
    after,
    before,
    component_letter,
    in_direction,
    restitution,
)
from restitution.planning.formulas.whereabouts import standing
from restitution.planning.writing.desk import Source, together
from restitution.planning.writing.forms import difference, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene


def _separation_tree(scene: Scene, frame: Frame) -> Expression:
    first, second = scene.bodies(frame.number)
    own, other = (component_letter(scene, body, frame) for body in (second, first))
    return Binary("-", Letter(own.name), Letter(other.name))


def separation_known(scene: Scene, frame: Frame) -> Source | None:
    """How fast two spheres separate along their line of centres, where that is known alone."""
    return standing(scene, _separation_tree(scene, frame))


def with_separation(scene: Scene, frame: Frame, value: sp.Expr) -> sp.Expr:
    """A value with the difference of the components after an impact put in, where it is known."""
    apart = separation_known(scene, frame)
    if apart is None:
        return value
    first, second = (component_letter(scene, body, frame) for body in scene.bodies(frame.number))
    return value.xreplace({second: first + apart.value}).expand()


def write_separation(scene: Scene, frame: Frame) -> None:
    """The law of restitution alone: the speed of separation from that of approach."""
    e = scene.coefficient(frame.number)
    bodies = scene.bodies(frame.number)
    u, x = (before(scene, "along", body, frame) for body in bodies)
    letters = [after(scene, "along", body, frame) for body in bodies]
    value = tidy(e.value * (u.value - x.value))
    number = restitution(scene, frame, value)
    refs = together((number,), *(letter.refs for letter in letters))
    scene.desk.know(_separation_tree(scene, frame), value, refs)


def relative_speed(
    scene: Scene, velocity: Expression
) -> tuple[list[tuple[Expression, sp.Expr]], tuple[Ref, ...]] | None:
    """The components of a relative velocity just after an impact, as trees and values.

    None where the tree is no such velocity, or the speed of separation is not known alone.
    """
    event = event_of_relative(scene, velocity)
    if event is None:
        return None
    frame = scene.frame(event)
    apart = separation_known(scene, frame)
    if apart is None:
        return None
    one, other = (in_direction(scene, "across", e, event, frame) for e in scene.bodies(event))
    gap = tidy(one.value - other.value)
    values = (one.value, other.value)
    a, b = values if scene.model.sign(gap) >= 0 else values[::-1]
    parts = [(tree_of(apart.value), apart.value), (difference(tree_of(a), tree_of(b)), gap)]
    refs = together(apart.refs, one.whole, other.whole, frame.unit_free)
    return (parts if frame.n.x else parts[::-1]), refs


def event_of_relative(scene: Scene, velocity: Expression) -> int | None:
    """The impact of two spheres after which a tree is the velocity of one relative to the other."""
    match velocity:
        case Binary(
            "-",
            Quantity("velocity", (Name(one),), int(event)),
            Quantity("velocity", (Name(other),), int(late)),
        ) if event == late and event in scene.model.frames:
            frame = scene.model.frames[event]
            if frame.wall is None and {one, other} == set(scene.bodies(event)):
                return event
    return None
