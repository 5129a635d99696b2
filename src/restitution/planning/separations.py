"""How fast two spheres separate along their line of centres."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Move
from restitution.expression.tree import Binary, Expression, Name, Quantity, Unit
from restitution.planning.desk import Source, chain, together
from restitution.planning.forms import difference, product, swept, tree_of
from restitution.planning.frames import Frame
from restitution.planning.impacts import before
from restitution.planning.place_trees import AXES
from restitution.planning.resolving import unit_of
from restitution.planning.scene import Scene
from restitution.planning.whereabouts import standing


def separation_direction(frame: Frame) -> Expression:
    """The direction in which a separation is counted: of an axis, where that is the line."""
    for axis in AXES:
        if frame.n == unit_of(axis):
            return Unit(axis)
    return frame.along


def _separation_tree(scene: Scene, frame: Frame) -> Expression:
    first, second = scene.bodies(frame.number)
    direction = separation_direction(frame)
    own, other = (
        Quantity("along", (Quantity("velocity", (Name(each),), frame.number), direction))
        for each in (second, first)
    )
    return Binary("-", own, other)


def separation_known(scene: Scene, frame: Frame) -> Source | None:
    """How fast two spheres separate along their line of centres, where that is known alone."""
    return standing(scene, _separation_tree(scene, frame))


def write_separation(scene: Scene, frame: Frame) -> None:
    """The law of restitution alone: the speed of separation from that of approach."""
    first, second = scene.bodies(frame.number)
    e = scene.coefficient(frame.number)
    u, x = (before(scene, "along", each, frame) for each in (first, second))
    if e.value == 0:
        u = x = Source(sp.Integer(0))
    value = tidy(e.value * (u.value - x.value))
    quantity = _separation_tree(scene, frame)
    approach = difference(tree_of(u.value), tree_of(x.value))
    number = scene.desk.write(
        Move("law", "restitution", frame.number, (first, second)),
        together(e.refs, u.whole, x.whole, frame.names_axis("along")),
        chain(
            quantity,
            (swept(product(tree_of(e.value), approach)), None),
            (tree_of(value), "rearrange"),
        ),
    )
    scene.desk.know(quantity, value, (number,))
