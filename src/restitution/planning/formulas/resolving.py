"""Components along **i** and **j** of velocities that are known in other directions."""

from __future__ import annotations

from typing import Literal

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import COMPONENTS, Name, Quantity, Unit
from restitution.planning.formulas.impacts import after
from restitution.planning.formulas.settled import settled
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import product, swept, total, tree_of
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def unit_of(axis: Literal["i", "j"]) -> Vector:
    """The unit vector of an axis."""
    return Vector(1, 0) if axis == "i" else Vector(0, 1)


def along_axis(scene: Scene, body: str, stage: int, axis: Literal["i", "j"]) -> Source:
    """The component of a velocity along **i** or **j**, after so many events."""
    last = scene.last_event(body, stage)
    unit = unit_of(axis)
    if last == 0:
        if f"velocity {body}" not in scene.facts:
            return scene.sought(body, axis)
        initial = scene.initial(body)
        return Source(tidy(initial.value.dot(unit)), initial.refs)
    vector = scene.desk.known(Quantity("velocity", (Name(body),), last))
    if vector is not None and last not in scene.model.frames:
        return Source(tidy(vector.value.dot(unit)), vector.refs)
    frame = scene.frame(last)
    for kind in COMPONENTS:
        share = tidy(frame.direction(kind).dot(unit))
        if share in (1, -1):
            component = frame.component(kind, body, last)
            own = settled(scene, component) or after(scene, kind, body, frame)
            named = component.arguments[-1] == Unit(axis)
            refs = own.refs if named else together(own.refs, own.axis, frame.refs)
            return Source(share * own.value, refs)
    quantity = Quantity("along", (Quantity("velocity", (Name(body),), last), Unit(axis)))
    known = scene.desk.known(quantity)
    if known is not None:
        return known
    if vector is not None:
        return Source(tidy(vector.value.dot(unit)), vector.refs)
    parts = []
    for kind in COMPONENTS:
        own = after(scene, kind, body, frame)
        value, refs = scene.put(own.value)
        parts.append((value, frame.direction(kind).dot(unit), together(own.whole, refs)))
    value = tidy(sum(value * share for value, share, _ in parts))
    tree = total(product(tree_of(a), tree_of(tidy(b))) for a, b, _ in parts if a != 0)
    number = scene.desk.write(
        Move("define", "component", last, (body,)),
        together(*(refs for *_, refs in parts), frame.refs),
        chain(quantity, (swept(tree), None), (tree_of(value), "rearrange")),
    )
    return scene.desk.know(quantity, value, (number,))
