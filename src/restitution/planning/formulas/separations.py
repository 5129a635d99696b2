"""How fast two spheres separate along their line of centres, by the law of restitution alone."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Binary, Expression, Name, Quantity, plain_letter
from restitution.planning.formulas.definitions import Formula, itself
from restitution.planning.formulas.impacts import (
    after,
    before,
    component_letter,
    in_direction,
    restitution,
)
from restitution.planning.formulas.whereabouts import standing
from restitution.planning.writing.desk import Source, together
from restitution.planning.writing.forms import difference, product, total, tree_of, vector
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import unit_tree
from restitution.vector import Vector


def _separation_tree(scene: Scene, frame: Frame) -> Expression:
    first, second = scene.bodies(frame.number)
    own, other = (component_letter(scene, body, frame) for body in (second, first))
    return Binary("-", plain_letter(own.name), plain_letter(other.name))


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


def relative_velocity(scene: Scene, asked: Expression) -> Formula | None:
    """The velocity of one sphere relative to the other just after an impact, by its components.

    None of another tree, and where the speed of separation is not known alone.
    """
    event = event_of_relative(scene, asked)
    apart = separation_known(scene, scene.frame(event)) if event is not None else None
    if event is None or apart is None or not isinstance(asked, Binary):
        return None
    frame, bodies = scene.frame(event), scene.bodies(event)
    first = asked.left == Quantity("velocity", (Name(bodies[0]),), event)
    sources = [in_direction(scene, "across", body, event, frame) for body in bodies]
    one, other = sources if first else sources[::-1]
    along = tidy((-1 if first else 1) * frame.letter_sign * apart.value)
    gap = tidy(one.value - other.value)
    across = difference(tree_of(one.value), tree_of(other.value))
    refs = together(apart.refs, one.whole, other.whole, frame.unit_free)
    value = frame.n * along + frame.t * gap
    if frame.n in (Vector(1, 0), Vector(0, 1)):
        parts = (tree_of(along), across)
        right = vector(*(parts if frame.n.x else parts[::-1]))
    else:
        pairs = ((tree_of(along), frame.n), (across, frame.t))
        right = total(product(part, unit_tree(direction)) for part, direction in pairs)
    move = Move("define", "relative-velocity", event)
    return Formula(move, itself, asked, right, Vector(*map(tidy, value)), refs)


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
