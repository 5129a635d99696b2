"""Times of flight by coordinates in the time: to the line of a wall, and of two to one place."""

from __future__ import annotations

from typing import NamedTuple

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import Binary, Expression, Quantity
from restitution.planning.closing.shapes import nonzero
from restitution.planning.formulas.whereabouts import contact_of, tidied
from restitution.planning.journeys.flights import collected, time_since
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.flights import added
from restitution.planning.writing.forms import product, total, tree_of
from restitution.planning.writing.place_trees import place_tree
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.straight_walls import equation_of_line
from restitution.vector import Vector


class Coordinate(NamedTuple):
    """A coordinate in the time as unknown: where it is at time 0, how fast it grows."""

    tree: Expression
    start: sp.Expr
    pace: sp.Expr
    refs: tuple[Ref, ...]


def line_of_wall(scene: Scene, number: int) -> tuple[Vector, Vector]:
    """A point of the wall of an event, and its normal."""
    match next(contact_of(scene, number), None):
        case Link(Quantity("dot", (Binary("-", _, through), normal)), "=", _):
            return tidied(scene, scene.value(through)), tidied(scene, scene.value(normal))
    raise NotPlannedError("the time to a wall whose place is not given")


def time_to_wall(
    scene: Scene,
    body: str,
    number: int,
    wall: tuple[Vector, Vector],
    path: tuple[Source, Source, int, tuple[Ref, ...]],
) -> Source:
    """The time to a wall: the coordinates by the time, on its line.

    The path is where the body is after an event, its velocity then, the event, and its time.
    """
    (place, axis), (first, pace, since, begin) = wall, path
    flight = time_since(scene, number, since)
    open_ = scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        together(first.refs, pace.refs, begin),
        chain(place_tree(body, number), (added(first.value, flight, pace.value), None)),
    )
    there = [
        total((tree_of(a), product(tree_of(v), flight)))
        for a, v in zip(first.value, pace.value, strict=True)
    ]
    refs = (f"contact {number}", open_, *background(scene, symbol_names(*axis)))
    for by_slope in (True, False):
        own = equation_of_line(axis, place, there, by_slope=by_slope)
        fact = scene.judge.write((Move("fact"),), refs, Relation(((own,),)))
        if fact is not None:
            break
    else:
        raise NotPlannedError("a place on the line of a wall")
    slope = tidy(sp.trigsimp(-axis.x / axis.y))
    if by_slope and isinstance(slope, sp.tan):
        axis = Vector(-slope, sp.Integer(1))
    closing = tidy(pace.value.dot(axis))
    value = tidy((place - first.value).dot(axis) / closing)
    return _made_the_subject(scene, fact, flight, closing, value)


def time_of_both(
    scene: Scene, number: int, flight: Expression, own: Coordinate, theirs: Coordinate
) -> Source:
    """The time at which two coordinates are one, by the contact of an event.

    The refs of both are those of the equation, in which they stand as they are written.
    """
    sides = (theirs.tree, own.tree) if own.tree == flight else (own.tree, theirs.tree)
    met = scene.desk.write(
        Move("fact"),
        together((f"contact {number}", *own.refs), theirs.refs),
        chain(sides[0], (sides[1], None)),
    )
    closing = tidy(own.pace - theirs.pace)
    apart = tidy(theirs.start - own.start)
    if theirs.pace != 0:
        met = collected(scene, met, closing, flight, apart)
    return _made_the_subject(scene, met, flight, closing, tidy(apart / closing))


def _made_the_subject(
    scene: Scene, line: int, flight: Expression, closing: sp.Expr, value: sp.Expr
) -> Source:
    """The time of a line, divided by the speed beside it, which is not zero."""
    solved = scene.desk.write(
        Move("rearrange"), (line, *nonzero(scene, closing)), chain(flight, (tree_of(value), None))
    )
    return scene.desk.know(flight, value, (solved,))
