"""Times by a direction in which nothing changes how a body moves, from the start on."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.data.facts import staged
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Quantity, walk
from restitution.planning.formulas.whereabouts import (
    last_move,
    standing,
    start,
    value_of_velocity,
    velocity,
    without_walls,
)
from restitution.planning.journeys.places import coordinate, coordinate_given
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.flights import divisor_refs, time_quotient
from restitution.planning.writing.forms import swept, tree_of
from restitution.planning.writing.place_trees import AXES, Axis, time_tree
from restitution.planning.writing.scene import Scene
from restitution.problem import Item, Show, Value


def steady_axis(scene: Scene, body: str, number: int) -> Axis | None:
    """The direction in which a component is the same from the start to an event; None without one.

    None on a way without an impact: there both directions are alike.
    """
    since = last_move(scene, body, number)
    if not since or "start" not in scene.facts or start(scene)[0]:
        return None
    if scene.model.story.place(body, 0) is None:
        return None
    for axis in AXES:
        paces, stage = [], since
        while stage:
            paces.append(without_walls(scene, value_of_velocity(scene, body, stage, axis)))
            stage = last_move(scene, body, stage)
        first = value_of_velocity(scene, body, 0, axis)
        if first != 0 and all(pace == first for pace in paces):
            return axis
    return None


def time_at_one_pace(scene: Scene, number: int) -> Source | None:
    """The time of an event, by the whole way in such a direction; None where there is none.

    None too where a time in between stands already, or is asked: then ways are added.
    """
    if not number or standing(scene, time_tree(number)) is not None:
        return None
    body = scene.bodies(number)[0]
    axis = steady_axis(scene, body, number)
    if axis is None or any(circle_of(scene, n) for n in range(1, number + 1)):
        return None
    between = _events_between(scene, body, number)
    if not between or _times_wanted(scene) & set(between):
        return None
    ends = [coordinate_given(scene, body, each, axis) for each in (0, number)]
    if None in ends or any(scene.desk.known(time_tree(each)) is not None for each in between):
        return None
    first, last = (coordinate(scene, body, each, axis) for each in (0, number))
    paces = [velocity(scene, body, stage, axis) for stage in (0, *between)]
    pace = paces[-1]
    distance = tidy(last.value - first.value)
    if scene.unknown(pace.value) or scene.unknown(distance) or distance == 0:
        return None
    tree = swept(time_quotient(scene, last.value, first.value, pace.value))
    value = tidy(distance / pace.value)
    refs: tuple[Ref, ...] = together(
        start(scene)[1],
        first.refs,
        last.refs,
        *(each.refs for each in paces),
        divisor_refs(scene, distance, pace.value),
    )
    relation = chain(time_tree(number), (tree, None), (tree_of(value), "rearrange"))
    move = Move("define", "straight-line", number, (body,))
    needed = scene.judge.enough(move, refs, relation)
    if needed is None:
        return None
    line = scene.desk.write(move, needed, relation)
    return scene.desk.know(time_tree(number), value, (line,))


def _events_between(scene: Scene, body: str, number: int) -> list[int]:
    """The events that change how a body moves before one, in order."""
    between, stage = [], last_move(scene, body, number)
    while stage:
        between.append(stage)
        stage = last_move(scene, body, stage)
    return between[::-1]


def _times_wanted(scene: Scene) -> set[int]:
    """The events of which the question speaks of the time."""
    asked: list[tuple[Item | Show, int]] = list(scene.problem.asked(scene.part))
    trees = [
        staged(scene.problem, item.expression, now)
        for item, now in asked
        if isinstance(item, Value)
    ]
    trees += [side for each in scene.given for side in (each.link.left, each.link.right)]
    return {
        node.stage
        for tree in trees
        for node in walk(tree)
        if isinstance(node, Quantity) and node.kind == "time" and isinstance(node.stage, int)
    }


__all__ = ["steady_axis", "time_at_one_pace"]
