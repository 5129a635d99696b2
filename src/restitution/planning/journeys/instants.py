"""Where a body is at a time between events."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import AtTime, Binary, Expression, Quantity, letters, walk
from restitution.planning.formulas.whereabouts import hide_place_of_rest, standing
from restitution.planning.journeys.place_lines import velocity_then, write_place
from restitution.planning.journeys.places import spot, time_of
from restitution.planning.writing.desk import NotPlannedError, Source, together
from restitution.planning.writing.flights import added
from restitution.planning.writing.forms import difference, swept, total, tree_of
from restitution.planning.writing.place_trees import time_tree
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def place_then(scene: Scene, asked: Quantity, body: str) -> Source:
    """A place at a time: by the place and the velocity at the last event before it."""
    assert isinstance(asked.stage, AtTime)
    known = standing(scene, asked)
    if known is not None:
        return known
    since = piece(scene, body, asked.stage.time)
    first, pace, early = (
        spot(scene, body, since),
        velocity_then(scene, body, since),
        time_of(scene, since),
    )
    flight, length, refs = time_since(scene, asked.stage.time, since, early)
    tree = added(first.value, flight, pace.value)
    value = Vector(*(tidy(a + b * length) for a, b in zip(first.value, pace.value, strict=True)))
    used = together(first.refs, pace.refs)
    if tuple(pace.value) != (0, 0):
        used = together(used, refs)
    number = write_place(
        scene, Move("define", "straight-line", since or None, (body,)), asked, used, tree, value
    )
    if tuple(pace.value) == (0, 0):
        hide_place_of_rest(scene, body, since, number)
    return scene.desk.know(asked, value, (number,))


def piece(scene: Scene, body: str, time: Expression) -> int:
    """The last event of a body before a time; of a letter that is open, its last one."""
    own = [n for n in range(1, scene.events + 1) if body in scene.bodies(n)]
    value = scene.scalar(time)
    later = bool(letters(time) & scene.model.story.open_times)
    if later:
        return own[-1] if own else 0
    chosen = 0
    for number in own:
        when = scene.model.happening(number).time
        if when is None:
            raise NotPlannedError("the time of an event is not known")
        if scene.model.sign(value - when) >= 0:
            chosen = number
    return chosen


def time_since(
    scene: Scene, time: Expression, event: int, early: Source
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """How long after an event a time is, as a tree, in value, and what that rests on."""
    match time:
        case Binary("+", own, later) if own == time_tree(event):
            value, refs = scene.put(scene.scalar(later))
            return tree_of(value), value, refs
    when, refs = scene.put(scene.scalar(time))
    for node in walk(time):
        match node:
            case Quantity("time", (), int(number)) if number:
                refs = together(refs, time_of(scene, number).refs)
    tree = difference(_as_a_sum(scene, time, when), tree_of(early.value))
    return tree, tidy(when - early.value), together(early.refs, refs)


def _as_a_sum(scene: Scene, time: Expression, when: sp.Expr) -> Expression:
    """A time after an event as the time of that and the one since, as both are put in."""
    match time:
        case Binary("+", Quantity("time", (), int(number)), later) if number:
            terms = time_of(scene, number).value, scene.put(scene.scalar(later))[0]
            return swept(total(map(tree_of, terms)))
    return tree_of(when)
