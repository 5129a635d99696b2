"""Lines that say where a body is, and which of them stand."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.explaining.lines.derivation import Move, Ref, numbers_in
from restitution.expression.tree import (
    Binary,
    Expression,
    walk,
)
from restitution.planning.formulas.whereabouts import (
    contact_of,
    keeps_still,
    offset_at,
    partner_of,
    standing,
    velocity,
)
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import (
    product,
    swept,
    tree_of,
    vector,
)
from restitution.planning.writing.place_trees import (
    AXES,
    Axis,
    coordinate_tree,
    place_tree,
    time_tree,
)
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.vector import Vector


def write_place(
    scene: Scene,
    move: Move,
    quantity: Expression,
    refs: Sequence[Ref],
    tree: Expression,
    value: Vector,
) -> int:
    """Writes a place, and what it comes to in a line below; returns the number of the last."""
    own, relation = tree_of(value), chain(quantity, (tree, None))
    needed = scene.judge.needed(move, refs, relation)
    number = scene.desk.write(move, refs if needed is None else needed, relation)
    if own != tree:
        number = scene.desk.write(Move("rearrange"), (number,), chain(quantity, (own, None)))
    return number


def know_place(scene: Scene, body: str, stage: int, value: Vector, number: int) -> Source:
    """Both coordinates of a place, which a line has, as known from it."""
    for axis, coordinate in zip(AXES, value, strict=True):
        scene.desk.know(coordinate_tree(body, stage, axis), coordinate, (number,))
    return scene.desk.know(place_tree(body, stage), value, (number,))


def both_radii(scene: Scene, between: Expression, apart: Vector) -> Expression:
    """The way from one centre to another that it touches: two radii times a unit vector."""
    match between:
        case Binary("*", both, unit):
            size, _ = scene.put(scene.scalar(both))
            direction = scene.vector(unit)
            whole, length = whole_direction(direction)
            tree = vector(*map(tree_of, whole))
            return product(
                tree_of(size), tree if length == 1 else Binary("/", tree, tree_of(length))
            )
    return tree_of(apart)


def stays_where_it_touched(
    scene: Scene, move: Move, near: int, quantity: Expression, refs: Sequence[Ref], value: Vector
) -> int | None:
    """Writes the place of who rests by that of whom it touched at an event: ``4i - i``.

    None where a line has its own place, where it moves, and where the centres were not apart.
    """
    (body,) = move.bodies
    other = partner_of(scene, body, near)
    theirs = None if other is None else standing(scene, place_tree(other, near))
    own = next(contact_of(scene, near), None)
    if theirs is None or own is None or own.left != place_tree(body, near):
        return None
    if standing(scene, own.left) is not None or any(velocity_then(scene, body, near).value):
        return None
    apart, _ = scene.put(Vector(*(offset_at(scene, body, near, axis) for axis in AXES)))
    if not any(apart) or not isinstance(own.right, Binary):
        return None
    between = both_radii(scene, own.right.right, apart)
    touched = swept(Binary(own.right.op, tree_of(theirs.value), between))
    relation = chain(quantity, (touched, None), (tree_of(value), "rearrange"))
    return scene.desk.write(move, refs, relation)


def velocity_then(scene: Scene, body: str, stage: int) -> Source:
    """A velocity as a vector, by its components along **i** and **j**."""
    x, y = (velocity(scene, body, stage, axis) for axis in AXES)
    return Source(Vector(x.value, y.value), together(x.refs, y.refs))


def open_line(scene: Scene, body: str, stage: int) -> int | None:
    """The line that says where a body is by a time that is not yet known."""
    for line in scene.desk.lines:
        if line.move == Move("define", "straight-line", stage, (body,)) and scene.desk.holds(
            line.number
        ):
            (own, *_) = scene.desk.relation(line.number).only
            if own.left == place_tree(body, stage) and time_tree(stage) in set(walk(own.right)):
                return line.number
    return None


def nearest(scene: Scene, body: str, since: int, stage: int, axis: Axis | None = None) -> int:
    """The last event before another at which a line says where a body is; else its own last one."""
    near = stage - 1
    if near <= since:
        return since
    tree = place_tree(body, near) if axis is None else coordinate_tree(body, near, axis)
    if scene.desk.known(tree) is not None:
        return near
    moving = [own for own in AXES if not keeps_still(scene, body, since, own)]
    if axis is None and moving:
        known = [scene.desk.known(coordinate_tree(body, near, own)) for own in moving]
        # One that no other line takes would stand for this place alone.
        if all(own is not None and _is_taken(scene, own) for own in known):
            return near
    return since


def _is_taken(scene: Scene, own: Source) -> bool:
    """Whether a line rests on one that gives a value."""
    numbers = set(numbers_in(own.refs))
    return any(numbers & {*line.premises} for line in scene.desk.lines)
