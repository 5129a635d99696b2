"""Places that are given: at an event, or at a time that is none, as equations for what is open."""

from __future__ import annotations

from typing import Literal

import sympy as sp

from restitution.explaining.lines.derivation import Link, Move
from restitution.expression.tree import AtTime, Name, Quantity, Unit
from restitution.planning.journeys.instants import place_then
from restitution.planning.journeys.places import coordinate, coordinate_moved
from restitution.planning.writing import place_trees
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.vector import Vector


def write_given_place(scene: Scene, equation: GivenEquation) -> int:
    """A place that is given at an event, by the coordinate in which something is unknown."""
    match equation.link:
        case Link(Quantity("position", (Name(body),), AtTime()) as there, "=", right):
            return _place_then(scene, equation, there, body, scene.vector(right))
        case Link(Quantity("position", (Name(body),), int(stage)), "=", right):
            place = scene.vector(right)
        case Link(
            Quantity("along", (Quantity("position", (Name(body),), AtTime()) as there, Unit(axis))),
            "=",
            right,
        ):
            return _coordinate_then(scene, equation, there, axis, scene.scalar(right))
        case _:
            raise NotPlannedError("a relation with places")
    for axis, given in zip(place_trees.AXES, place, strict=True):
        mark = scene.desk.mark()
        own = coordinate(scene, body, stage, axis)
        if not any(isinstance(ref, int) for ref in own.refs):
            own = coordinate_moved(scene, body, stage, axis)
        relation = chain(tree_of(own.value), (tree_of(given), None))
        premises = None
        if scene.unknown(own.value):
            premises = scene.judge.enough(Move("put"), (*own.refs, *equation.refs), relation)
        if premises is not None:
            return scene.desk.write(Move("put"), premises, relation)
        # Where a wall is told, that the body is there is not worked out.
        scene.desk.back(mark)
    raise NotPlannedError("a place that is given at an event")


def _place_then(
    scene: Scene, equation: GivenEquation, there: Quantity, body: str, place: Vector
) -> int:
    """A place given at a time between events, by the coordinate with the fewest unknowns."""
    own = place_then(scene, there, body)
    coordinates = zip(place_trees.AXES, own.value, place, strict=True)
    for axis, value, given in sorted(coordinates, key=lambda pair: len(scene.unknown(pair[1]))):
        if not scene.unknown(value):
            continue
        try:
            return _coordinate_then(scene, equation, there, axis, given)
        except NotPlannedError:
            continue
    raise NotPlannedError("a place that is given at a time")


def _coordinate_then(
    scene: Scene, equation: GivenEquation, there: Quantity, axis: Literal["i", "j"], given: sp.Expr
) -> int:
    """One coordinate that is given at a time between events."""
    (body,) = there.arguments
    assert isinstance(body, Name)
    own = place_then(scene, there, body.name)
    value = dict(zip(place_trees.AXES, own.value, strict=True))[axis]
    coordinate_then = chain(Quantity("along", (there, Unit(axis))), (tree_of(value), None))
    line = scene.desk.write(Move("rearrange"), own.refs, coordinate_then, "silent")
    relation = chain(tree_of(value), (tree_of(given), None))
    premises = scene.judge.enough(Move("put"), (line, *equation.refs), relation)
    if premises is None:
        raise NotPlannedError("a place that is given at a time")
    return scene.desk.write(Move("put"), premises, relation)
