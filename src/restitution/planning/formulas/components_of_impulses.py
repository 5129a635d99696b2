"""The component of an impulse along a line or across it, of the impulse as a vector."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Name, Quantity, is_quantity, walk
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.impulse_formulas import impulse_formula
from restitution.planning.formulas.velocity_formulas import component_formula
from restitution.planning.writing.desk import Source, together
from restitution.planning.writing.forms import product, total, tree_of
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def any_component_formula(scene: Scene, quantity: Quantity) -> Formula:
    """A component of a velocity, of a momentum or of an impulse."""
    match quantity.arguments[0]:
        case Quantity("impulse", (Name(),), int(event)) as impulse:
            return _component_of_impulse(scene, quantity, impulse, event)
    return component_formula(scene, quantity)


def _component_of_impulse(
    scene: Scene, quantity: Quantity, impulse: Quantity, event: int
) -> Formula:
    """The scalar product of an impulse, which has a line by then, with a unit vector."""
    direction = quantity.arguments[1]
    wanted = scene.model.story.direction(direction, scene.events)
    if quantity.kind == "across":
        wanted = wanted.turned_left()
    size = scene.model.story.size(wanted)
    unit = Vector(tidy(wanted.x / size), tidy(wanted.y / size))
    whole = _as_a_vector(scene, impulse)
    used = [(a, b) for a, b in zip(whole.value, unit, strict=True) if b != 0]
    right = total(product(tree_of(a), tree_of(b)) for a, b in used)
    value = tidy(sum(a * b for a, b in used))
    named = {node.name for node in walk(direction) if isinstance(node, Name)}
    walls = (f"wall {name}" for name in named if f"wall {name}" in scene.facts)
    axes: tuple[Ref, ...] = ()
    if is_quantity(direction, "line_of_centres") and f"axis {direction.stage}" in scene.facts:
        axes = (f"axis {direction.stage}",)
    body = next(node.name for node in walk(impulse) if isinstance(node, Name))
    refs = together(whole.refs, walls, axes)
    return Formula(
        Move("define", "component", event, (body,)), itself, quantity, right, value, refs
    )


def _as_a_vector(scene: Scene, impulse: Quantity) -> Source:
    """An impulse as a line has it, which is written where there is none; a blow as it is given."""
    blow = scene.facts.get(f"impulse {impulse.stage}")
    if blow is not None:
        given = scene.value(blow.relation.only[-1].right)
        if isinstance(given, Vector):
            return Source(given, (blow.id,))
    known = scene.desk.known(impulse)
    if known is None:
        own = impulse_formula(scene, impulse)
        number = write_formula(scene, own)
        known = scene.desk.known(impulse) or Source(own.value, (number,))
    value, refs = scene.put(known.value)
    return Source(value, together(known.refs, refs))


__all__ = ["any_component_formula"]
