"""How far a body comes between two of its events: its velocity times the time between them."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Binary, Expression, Name, Quantity
from restitution.planning.formulas.whereabouts import last_move, start, velocity
from restitution.planning.journeys.places import coordinate_given, flight_time
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import difference, product, swept, tree_of
from restitution.planning.writing.place_trees import (
    AXES,
    Axis,
    coordinate_tree,
    duration_tree,
    place_tree,
    time_tree,
)
from restitution.planning.writing.scene import Scene


def flown(scene: Scene, asked: Quantity) -> tuple[Source, Source] | None:
    """How far a body comes along **i** and along **j** from one of its events to another.

    Where that is not its next one, what it has in the open direction is the same all the while.
    None of another distance, where both coordinates stand or one of the places is asked, and
    where the data give the place at which it begins.
    """
    flight = _flight_of(scene, asked)
    if flight is None:
        return None
    body, early, late = flight
    if any(place_tree(body, number) in scene.asked_alone for number in (early, late)):
        return None
    given = {axis: _between_given(scene, body, early, late, axis) for axis in AXES}
    open_ = [axis for axis in AXES if given[axis] is None]
    if len(open_) != 1:
        return None
    (axis,) = open_
    mark = scene.desk.mark()
    paces = [velocity(scene, body, stage, axis) for stage in _stages(scene, body, early, late)]
    values = [pace.value for pace in paces]
    if values[0] == 0 or scene.unknown(values[0]) or any(value != values[0] for value in values):
        scene.desk.back(mark)
        return None
    pace = Source(values[0], together(*(pace.refs for pace in paces)))
    length = _write_length(scene, body, (early, late), axis, pace)
    if length is None:
        scene.desk.back(mark)
        return None
    x, y = (given[axis] or length for axis in AXES)
    return x, y


def _flight_of(scene: Scene, asked: Quantity) -> tuple[str, int, int] | None:
    """The body of which a distance is that between two of its events."""
    match asked.arguments:
        case (
            Quantity("position", (Name(body),), int(one)),
            Quantity("position", (Name(other),), int(two)),
        ) if body == other:
            early, late = sorted((one, two))
            is_flight = 0 < early < late and _stages(scene, body, early, late)[0] == early
            if not is_flight or "start" not in scene.facts or early < start(scene)[0]:
                return None
            met = {early, late} <= scene.model.frames.keys() and body in scene.bodies(late)
            round_ = any(circle_of(scene, number) is not None for number in (early, late))
            return (body, early, late) if met and not round_ else None
    return None


def _stages(scene: Scene, body: str, early: int, late: int) -> list[int]:
    """The events of a body at which its ways from one event to another begin, in order."""
    stages = [last_move(scene, body, late)]
    while stages[-1] > early:
        stages.append(last_move(scene, body, stages[-1]))
    return stages[::-1]


def _between_given(scene: Scene, body: str, early: int, late: int, axis: Axis) -> Source | None:
    """How far two places are apart of which one coordinate needs no working; None without."""
    first, last = (coordinate_given(scene, body, number, axis) for number in (early, late))
    if first is None or last is None:
        return None
    return Source(tidy(last.value - first.value), together(first.refs, last.refs))


def _write_length(
    scene: Scene, body: str, events: tuple[int, int], axis: Axis, pace: Source
) -> Source | None:
    """The line of how far a body comes in one direction."""
    early, late = events
    time, length, refs = _time_between(scene, early, late)
    value = tidy(sp.sympify(pace.value * length, strict=True))
    ends = (coordinate_tree(body, number, axis) for number in (late, early))
    right = swept(product(tree_of(pace.value), time))
    relation = chain(Binary("-", *ends), (right, None), (tree_of(value), "rearrange"))
    move = Move("define", "straight-line", late, (body,))
    number = scene.judge.write((move,), together(pace.refs, refs), relation)
    return None if number is None else Source(value, (number,))


def _time_between(
    scene: Scene, early: int, late: int
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The time between two events: by that of each, where lines tell both as numbers."""
    known = [scene.desk.known(time_tree(moment)) for moment in (early, late)]
    standing = scene.desk.known(duration_tree(late, early))
    first, last = known
    if first is None or last is None or standing is not None:
        return flight_time(scene, early, late)
    if not (first.value.is_number and last.value.is_number):
        return flight_time(scene, early, late)
    tree = difference(tree_of(last.value), tree_of(first.value))
    return tree, tidy(last.value - first.value), together(last.refs, first.refs)


__all__ = ["flown"]
