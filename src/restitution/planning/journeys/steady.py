"""Times by a direction in which nothing changes how a body moves, from one event to another."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.data.facts import staged
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Expression, Name, Quantity, is_quantity, walk
from restitution.planning.formulas.whereabouts import (
    last_move,
    standing,
    start,
    value_of_velocity,
    velocity,
    without_walls,
)
from restitution.planning.journeys.places import coordinate, coordinate_given, time_of
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.flights import divisor_refs, time_quotient, time_relation
from restitution.planning.writing.forms import difference, tree_of
from restitution.planning.writing.place_trees import AXES, Axis, duration_tree, time_tree
from restitution.planning.writing.scene import Scene
from restitution.problem import Item, Show, Value
from restitution.solving.story.letters import roles


def steady_axis(scene: Scene, body: str, number: int, first: int = 0) -> Axis | None:
    """The direction in which a component is the same from an event, or the start, to another.

    None without one, and on a way without an impact: there both directions are alike.
    """
    since = last_move(scene, body, number)
    if since <= first or "start" not in scene.facts or start(scene)[0]:
        return None
    if scene.model.story.place(body, 0) is None:
        return None
    for axis in AXES:
        paces, stage = [], since
        while stage > first:
            paces.append(without_walls(scene, value_of_velocity(scene, body, stage, axis)))
            stage = last_move(scene, body, stage)
        early = value_of_velocity(scene, body, first, axis)
        early = without_walls(scene, early) if first else early
        if early != 0 and all(pace == early for pace in paces):
            return axis
    return None


def time_at_one_pace(
    scene: Scene, number: int, since: int = 0, *, at_once: bool = False
) -> Source | None:
    """The time from an event, or the start, by the whole way in such a direction; None without one.

    None too where a time in between is asked: then ways are added, unless it is to be had
    ``at_once``.
    """
    own = time_tree(number) if since == 0 else duration_tree(number, since)
    if not number or standing(scene, own) is not None:
        return None
    body = scene.bodies(number)[0]
    axis = steady_axis(scene, body, number, since)
    if axis is None or any(circle_of(scene, n) for n in range(since + 1, number + 1)):
        return None
    between = _events_between(scene, body, number, since)
    if not between or (_times_wanted(scene) & set(between) and not at_once):
        return None
    ends = [coordinate_given(scene, body, stage, axis) for stage in (since, number)]
    if None in ends:
        return None
    early = [known.value for number in between if (known := scene.desk.known(time_tree(number)))]
    in_lines = any(isinstance(ref, int) for end in ends if end is not None for ref in end.refs)
    numbers = all(value.is_number for value in early)
    short = _stand(scene, (since, *between, number)) if numbers else in_lines
    if early and not at_once and short:
        return None  # the sum is as short
    if _are_added(scene, (since, *between, number)):
        return None
    first, last = (coordinate(scene, body, stage, axis) for stage in (since, number))
    paces = [velocity(scene, body, stage, axis) for stage in (since, *between)]
    pace = paces[-1]
    distance = tidy(last.value - first.value)
    # A letter of the question that is sought may stand in the pace: the time is given for it.
    open_ = {symbol.name for symbol in scene.unknown(pace.value)} - roles(scene.problem).keys()
    if open_ or scene.unknown(distance) or distance == 0:
        return None
    tree = time_quotient(scene, last.value, first.value, pace.value)
    value = tidy(distance / pace.value)
    refs: tuple[Ref, ...] = together(
        () if since else start(scene)[1],
        first.refs,
        last.refs,
        *(pace.refs for pace in paces),
        divisor_refs(scene, distance, pace.value),
    )
    relation = time_relation(own, tree, value, pace.value)
    move = Move("define", "straight-line", number, (body,))
    needed = scene.judge.enough(move, refs, relation)
    if needed is None:
        return None
    line = scene.desk.write(move, needed, relation)
    return scene.desk.know(own, value, (line,))


def write_last_way(scene: Scene, number: int, since: int) -> None:
    """Writes the time of the last way to an event as what is left of a time that is asked.

    Both times are numbers from the start on. Nothing is written where a place between is wanted
    anyway.
    """
    body = scene.bodies(number)[0]
    axis = steady_axis(scene, body, number)
    if axis is None or number not in _times_wanted(scene):
        return
    if _events_between(scene, body, number) != [since]:
        return
    if standing(scene, duration_tree(number, since)) is not None:
        return
    if coordinate_given(scene, body, since, axis) is not None or _is_asked(scene, body, since):
        return
    mark = scene.desk.mark()
    early, late = time_of(scene, since), time_at_one_pace(scene, number, at_once=True)
    if late is None or not early.value.is_number or not late.value.is_number:
        scene.desk.back(mark)
        return
    value = tidy(late.value - early.value)
    left = difference(tree_of(late.value), tree_of(early.value))
    relation = chain(duration_tree(number, since), (left, None), (tree_of(value), "rearrange"))
    line = scene.desk.write(Move("put"), together(late.refs, early.refs), relation)
    scene.desk.know(duration_tree(number, since), value, (line,))


def _is_asked(scene: Scene, body: str, number: int) -> bool:
    """Whether the place of a body at an event is asked."""
    return Quantity("position", (Name(body),), number) in scene.asked


def _are_added(scene: Scene, stages: Sequence[int]) -> bool:
    """Whether the times of all ways between events stand, and are multiples of one of them."""
    if not _stand(scene, stages):
        return False
    values = [value for pair in pairwise(stages) for value in _time_of_way(scene, *pair)]
    return all(tidy(value / values[0]).is_number for value in values)


def _stand(scene: Scene, stages: Sequence[int]) -> bool:
    """Whether the times of all ways between events are lines."""
    return all(_time_of_way(scene, *pair) for pair in pairwise(stages))


def _time_of_way(scene: Scene, early: int, late: int) -> list[sp.Expr]:
    """The time of a way that a line gives; none where none does."""
    trees = (duration_tree(late, early), *((time_tree(late),) if early == 0 else ()))
    known = next((own for tree in trees if (own := scene.desk.known(tree))), None)
    return [] if known is None else [sp.sympify(known.value, strict=True)]


def write_steady_ways(scene: Scene, number: int) -> None:
    """Writes the time of each way to an event over several impacts that leave a component alone.

    Where a time on such a way stands already, or is asked, its ways are added.
    """
    if not number or standing(scene, time_tree(number)) is not None:
        return
    body = scene.bodies(number)[0]
    stages = [0, *_events_between(scene, body, number), number]
    chosen: list[tuple[int, int]] = []
    end = len(stages) - 1
    while end > 1:
        begins = (n for n in range(end - 1) if _is_open_way(scene, body, stages[n : end + 1]))
        begin = next(begins, end - 1)
        if begin < end - 1:
            chosen.append((stages[begin], stages[end]))
        end = begin
    for since, last in reversed(chosen):
        time_at_one_pace(scene, last, since)


def _is_open_way(scene: Scene, body: str, stages: Sequence[int]) -> bool:
    """Whether a component is the same between events, and no line tells of a time between them."""
    first, last = stages[0], stages[-1]
    times: list[Expression] = [duration_tree(late, early) for early, late in pairwise(stages)]
    times += map(time_tree, stages[1:-1])
    if any(scene.desk.known(tree) is not None for tree in times):
        return False
    axis = steady_axis(scene, body, last, first)
    return axis is not None and None not in [
        coordinate_given(scene, body, number, axis) for number in (first, last)
    ]


def _events_between(scene: Scene, body: str, number: int, since: int = 0) -> list[int]:
    """The events that change how a body moves before one, and after another, in order."""
    between, stage = [], last_move(scene, body, number)
    while stage > since:
        between.append(stage)
        stage = last_move(scene, body, stage)
    return between[::-1]


def _times_wanted(scene: Scene) -> set[int]:
    """The events whose times the question names."""
    asked: list[tuple[Item | Show, int]] = list(scene.problem.asked(scene.part))
    trees = [
        staged(scene.problem, item.expression, now)
        for item, now in asked
        if isinstance(item, Value)
    ]
    trees += [
        side for equation in scene.given for side in (equation.link.left, equation.link.right)
    ]
    return {
        node.stage
        for tree in trees
        for node in walk(tree)
        if is_quantity(node, "time") and isinstance(node.stage, int)
    }


__all__ = ["steady_axis", "time_at_one_pace", "write_last_way", "write_steady_ways"]
