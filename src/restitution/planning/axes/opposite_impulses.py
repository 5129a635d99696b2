"""Impulses as vectors: by their size, by velocities of the sphere itself or of the other one."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Binary, Expression, Letter, Name, Quantity
from restitution.planning.axes.by_changes import rests_on_vectors
from restitution.planning.axes.momenta import velocity_as_vector
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.given_values import given_value
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import negative, product, tree_of
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import unit_tree, whole_direction
from restitution.vector import Vector


def write_impulse_by_its_size(scene: Scene, impulse: Expression) -> None:
    """Writes the impulse on a body as its size, which is given, along a line that the data tell.

    Nothing is written where a velocity after the impact stands, or the impulse on the other
    sphere: then it comes by that.
    """
    match impulse:
        case Quantity("impulse", (Name(body),), int(event)) if event in scene.model.frames:
            size = Quantity("impulse", (), event)
        case _:
            return
    impulses = (Quantity("impulse", (Name(sphere),), event) for sphere in scene.spheres(event))
    standing = (*impulses, Quantity("velocity", (Name(body),), event))
    if any(scene.desk.known(own) is not None for own in standing):
        return
    own_frame, own = scene.model.frames[event], given_value(scene, size)
    if own is None or f"axis {event}" not in scene.facts or own_frame.by_values:
        return
    if not all(component.is_number for component in own_frame.n):
        return
    if own_frame.wall is None and not _leads_to_the_second(scene, event):
        return
    # A frame leads away from a wall, and from the first sphere to the second.
    away = own_frame.n if own_frame.wall or body != scene.spheres(event)[0] else -own_frame.n
    whole, length = whole_direction(away)
    value = Vector(*(tidy(own.value * component) for component in away))
    right, between = tree_of(value), None
    if all(away):
        right = product(tree_of(own.value), unit_tree(away))
        between = product(tree_of(tidy(own.value / length)), tree_of(whole))
    move = Move("law", "impulse-direction", event, (body,))
    refs = together(own.refs, scene.frame(event).refs)
    if scene.judge.follows(move, refs, chain(impulse, (right, None))):
        write_formula(scene, Formula(move, itself, impulse, right, value, refs, between))


def _leads_to_the_second(scene: Scene, event: int) -> bool:
    """Whether the line of centres is typed in the sense in which the first sphere approaches."""
    first, second = (scene.velocity(sphere, event - 1) for sphere in scene.spheres(event))
    approach = (first - second).dot(scene.model.frames[event].n)
    return scene.model.sign(scene.model.in_data(approach)) > 0


def write_opposite_impulse(scene: Scene, impulse: Expression) -> None:
    """Writes the impulse on a sphere as −m(**v** − **u**) of the other, or as minus that impulse.

    Nothing is written where the velocity of the sphere after the impact is known, or one of the
    other sphere is no vector that is known.
    """
    match impulse:
        case Quantity("impulse", (Name(body),), int(event)) if event in scene.model.frames:
            others = [sphere for sphere in scene.spheres(event) if sphere != body]
        case _:
            return
    if len(others) != 1 or scene.desk.known(impulse) is not None:
        return
    (other,) = others
    move = Move("law", "opposite-impulses", event, scene.bodies(event))
    known = scene.desk.known(Quantity("impulse", (Name(other),), event))
    if known is not None and isinstance(known.value, Vector):
        value = Vector(*(tidy(-component) for component in known.value))
        if any(map(scene.unknown, value)):
            return
        write_formula(scene, Formula(move, itself, impulse, tree_of(value), value, known.refs))
        return
    component = scene.model.components.get((event, body))
    if component is not None and scene.desk.known(Letter(component.symbol.name)) is not None:
        return
    if velocity_as_vector(scene, body, event) is not None:
        return
    own = _change(scene, other, event)
    if own is not None:
        change, value, refs = own
        whole = Vector(*(tidy(-component) for component in value))
        write_formula(scene, Formula(move, itself, impulse, negative(change), whole, refs))


def write_impulse_of_an_open_line(scene: Scene, size: Expression) -> None:
    """Writes an impulse as m(**v** − **u**), of which the size is asked and the line is open.

    Nothing is written where a line or the data tell its line, or no body has both velocities.
    """
    match size:
        case Quantity("impulse", (), int(event)) if event in scene.model.frames:
            bodies = scene.spheres(event)
        case _:
            return
    if f"axis {event}" in scene.facts or event in scene.frames:
        return
    for body in bodies:
        own = _change(scene, body, event)
        if own is not None:
            change, value, refs = own
            impulse = Quantity("impulse", (Name(body),), event)
            move = Move("law", "impulse-vector", event, (body,))
            write_formula(scene, Formula(move, itself, impulse, change, value, refs))
            return


def _change(
    scene: Scene, body: str, event: int
) -> tuple[Expression, Vector, tuple[Ref, ...]] | None:
    """The change of momentum of a body as a vector; None where something is open in it."""
    mass = scene.mass(body)
    early, late = (velocity_as_vector(scene, body, stage) for stage in (event - 1, event))
    if early is None or late is None:
        return None
    if any(map(scene.unknown, (mass.value, *early.value, *late.value))):
        return None
    first, last = tree_of(early.value), tree_of(late.value)
    change: Expression = Binary("-", last, first) if any(early.value) else last
    value = Vector(
        *(tidy(mass.value * (v - u)) for u, v in zip(early.value, late.value, strict=True))
    )
    return product(tree_of(mass.value), change), value, together(mass.refs, late.refs, early.refs)


def is_by_vectors(scene: Scene, impulse: Quantity) -> bool:
    """Whether an impulse stands by velocities as vectors, or that whose size is asked."""
    match impulse:
        case Quantity("impulse", (), int(event)) if event in scene.model.frames:
            own = [Quantity("impulse", (Name(body),), event) for body in scene.spheres(event)]
        case Quantity("impulse"):
            own = [impulse]
        case _:
            return False
    known = filter(None, map(scene.desk.known, own))
    return any(
        isinstance(source.value, Vector) and rests_on_vectors(scene, source) for source in known
    )


__all__ = [
    "is_by_vectors",
    "write_impulse_by_its_size",
    "write_impulse_of_an_open_line",
    "write_opposite_impulse",
]
