"""Where a sphere is as it touches another."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import (
    Binary,
)
from restitution.planning.formulas.whereabouts import (
    contact_of,
    offset_at,
    partner_of,
    tidied,
)
from restitution.planning.journeys.place_lines import (
    both_radii,
    know_place,
)
from restitution.planning.journeys.places import spot
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import (
    swept,
    tree_of,
)
from restitution.planning.writing.place_trees import (
    AXES,
    place_tree,
)
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def write_touch(scene: Scene, body: str, number: int) -> None:
    """Where a body is when it touches another one that rests, where their centres are apart."""
    other = partner_of(scene, body, number)
    own = next(contact_of(scene, number), None)
    if other is None or own is None or scene.desk.known(place_tree(body, number)) is not None:
        return
    gap = Vector(*(offset_at(scene, body, number, axis) for axis in AXES))
    if not any(gap) or own.left != place_tree(body, number):
        return
    theirs = spot(scene, other, number)
    assert isinstance(own.right, Binary)
    apart, refs = scene.put(gap)
    between = both_radii(scene, own.right.right, apart)
    value = tidied(scene, theirs.value + apart)
    line = scene.desk.write(
        Move("fact"),
        together((f"contact {number}",), theirs.refs, refs),
        chain(
            place_tree(body, number),
            (swept(Binary(own.right.op, tree_of(theirs.value), between)), None),
            (tree_of(value), "rearrange"),
        ),
    )
    know_place(scene, body, number, value, line)
