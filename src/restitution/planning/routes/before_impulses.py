"""A velocity before an impulse that is given as a vector, by the velocity after it.

It is a difference of vectors, and needs neither the line of the impact nor letters for components.
"""

from __future__ import annotations

from functools import partial

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref, equality
from restitution.expression.tree import Binary, Expression, Name, Negate, Polar, Quantity
from restitution.planning.axes.open_lines import tried
from restitution.planning.routes.back_through_walls import take_start
from restitution.planning.writing.desk import Source, together
from restitution.planning.writing.forms import negative, product, swept, tree_of
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.vectors import velocity_given
from restitution.vector import Vector


def write_before_impulses(scene: Scene) -> None:
    """The velocities at the start that impulses and velocities after them tell."""
    for given in scene.given:
        match given.link.left:
            case Quantity("impulse", (Name(body),), int(event)) if given.link.sign == "=":
                for sphere in scene.spheres(event) if event in scene.model.frames else ():
                    if _is_open(scene, sphere, event):
                        tried(scene, partial(_write, scene, given, body, sphere, event))


def _is_open(scene: Scene, body: str, event: int) -> bool:
    """Whether a velocity at the start is sought, and the event is the first one of the body."""
    parts = scene.velocity(body, 0)
    return not scene.last_event(body, event - 1) and all(
        part.is_Symbol and scene.unknown(part) for part in parts
    )


def _write(scene: Scene, given: GivenEquation, struck: str, body: str, event: int) -> bool:
    """The velocity of a body before an impulse on the sphere that is ``struck``."""
    after, mass = velocity_given(scene, body, event), scene.mass(body)
    push = scene.vector(given.link.right)
    sizes = (*push, *(() if after is None else after[1]), mass.value)
    if after is None or any(map(scene.unknown, sizes)):
        return False
    impulse: Expression = given.link.right
    if isinstance(impulse, Polar):
        impulse = tree_of(Vector(*map(tidy, push)))
    refs: tuple[Ref, ...] = given.refs
    if struck != body:
        push = -push
        impulse = impulse.operand if isinstance(impulse, Negate) else negative(impulse)
        law = Move("law", "opposite-impulses", event, scene.bodies(event))
        own = Quantity("impulse", (Name(body),), event)
        impulse = tree_of(Vector(*map(tidy, push)))
        refs = (scene.desk.write(law, refs, equality(own, impulse)),)
    late, sought = after[0], Quantity("velocity", (Name(body),), 0)
    change = swept(product(tree_of(mass.value), Binary("-", late, sought)))
    pool = together(refs, mass.refs, after[2])
    law = Move("law", "impulse-vector", event, (body,))
    line = scene.judge.write((law,), pool, equality(impulse, change))
    value = Vector(*(tidy(v - p / mass.value) for v, p in zip(after[1], push, strict=True)))
    if line is not None:
        relation = equality(sought, tree_of(value))
        line = scene.judge.write((Move("rearrange"),), (line,), relation)
    if line is None:
        return False
    scene.desk.know(sought, value, (line,))
    take_start(scene, body, Source(value, (line,)))
    return True


__all__ = ["write_before_impulses"]
