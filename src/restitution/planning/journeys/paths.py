"""Equations of journeys: that a body comes to a point, and equations between times.

Where something in the data is asked for because a body comes to a point, its path gives an
equation, in which no time stands.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Move, Ref
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Expression, Negate, Quantity, has_quantity, walk
from restitution.planning.formulas.whereabouts import (
    axis_for,
    contact_of,
    last_move,
    of_contact_tree,
    offset_at,
    partner_of,
    rests,
    standing,
    start,
    value_of_coordinate,
    value_of_velocity,
    velocity,
    without_walls,
)
from restitution.planning.journeys.aims import place_at, striker, write_aim
from restitution.planning.journeys.encounters import aside, both_moving, in_the_other, with_the_gap
from restitution.planning.journeys.places import (
    coordinate,
    coordinate_moved,
    flight_time,
    leg,
    leg_along,
    time_of,
)
from restitution.planning.journeys.steady import steady_axis, write_last_way
from restitution.planning.journeys.touching import write_touch
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.flights import gradient, slope, swept_product
from restitution.planning.writing.forms import (
    ZERO,
    difference,
    in_tangents,
    product,
    swept,
    tree_of,
)
from restitution.planning.writing.place_trees import AXES, Axis, place_tree, time_tree
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.problem import Arrival, Impact
from restitution.records import dataclass
from restitution.solving.story.quantities import quantity as quantity_of
from restitution.vector import Vector


def residuals(scene: Scene, own: Link) -> tuple[sp.Expr, ...]:
    """An equation between times and places, each time by one direction as lines have it."""
    story = scene.model.story

    def value(tree: Quantity) -> Any:
        match tree:
            case Quantity("time", (), int(number)):
                return _time_value(scene, number)
        return quantity_of(story, tree, scene.events)

    read = type(story.evaluator(scene.events))(
        story.field, scene.model.unknowns.letter, value, story.named, story.wall_direction
    )
    gap = [read.scalar(side) for side in (own.left, own.right)]
    return (tidy(without_walls(scene, gap[0] - gap[1])),)


def _time_value(scene: Scene, number: int) -> sp.Expr:
    """A time as lines come to it: at a point, by the direction that is the simplest."""
    own = scene.value(time_tree(number))
    if number == 0 or not isinstance(scene.model.happening(number).step, Arrival):
        return own
    body = scene.bodies(number)[0]
    axis = axis_for(scene, body, number)
    since = last_move(scene, body, number)
    if axis is None:
        return own
    first, last = (value_of_coordinate(scene, body, stage, axis) for stage in (since, number))
    pace = value_of_velocity(scene, body, since, axis)
    early = _time_value(scene, since) if since else sp.Integer(0)
    return early + (last - first) / pace


@dataclass(frozen=True)
class Steady:
    """A direction in which a component is the same from the start on, and how long that is."""

    axis: Axis
    time: GivenEquation


@dataclass(frozen=True)
class Path:
    """That a body comes to a point, as an equation of a route."""

    number: int
    body: str
    candidate: Candidate
    steady: Steady | None = None


def paths(scene: Scene) -> Iterator[Path]:
    """The equations of the paths to points, in which something unknown stands."""
    for number in range(1, scene.events + 1):
        step = scene.model.happening(number).step
        aimed = striker(scene, number)
        if aimed is not None and (own := _aim(scene, aimed, number)) is not None:
            yield own
        pair = both_moving(scene, number)
        if pair is not None:
            gap = tidy(without_walls(scene, aside(scene, number, pair)))
            if scene.unknown(gap):
                yield Path(number, pair[0], Candidate(f"path {number}", 2.0, (gap,)))
            continue
        body = _who_goes(scene, number)
        if body is None:
            continue
        since = last_move(scene, body, number)
        if scene.model.story.place(body, since) is None or _by_a_circle(scene, body, number):
            continue
        are_placed = all(of_contact_tree(scene, body, number, axis) is not None for axis in AXES)
        if not are_placed and isinstance(step, Arrival):
            continue
        steady = _steady(scene, body, number)
        if steady is not None:
            residual = _over_the_whole_time(scene, body, number, steady)
            if scene.unknown(residual):
                yield Path(number, body, Candidate(f"path {number}", 2.0, (residual,)), steady)
                continue
        place, end = scene.value(place_tree(body, since)), _end_of(scene, body, number)
        gap = Vector(end.x - place.x, end.y - place.y)
        residual = tidy(without_walls(scene, gap.cross(scene.velocity(body, since))))
        if scene.unknown(residual):
            yield Path(number, body, Candidate(f"path {number}", 2.0, (residual,)))


def _steady(scene: Scene, body: str, number: int) -> Steady | None:
    """The direction in which nothing changes how a body moves, where the time to an event is given.

    None on a way without an impact: there both directions are alike.
    """
    times = [
        equation
        for equation in scene.given
        if equation.link == Link(time_tree(number), "=", equation.link.right)
        and not has_quantity(_without_times(equation.link.right, number))
    ]
    if not times or _by_a_circle(scene, body, number):
        return None
    axis = steady_axis(scene, body, number)
    return None if axis is None else Steady(axis, times[0])


def _without_times(tree: Expression, number: int) -> Expression:
    """An expression without the times of the events before one."""
    return exchanged(tree, {time_tree(index): ZERO for index in range(1, number)})


def _over_the_whole_time(scene: Scene, body: str, number: int, steady: Steady) -> sp.Expr:
    """The equation of a way at one component over the time that is given."""
    first, last = (value_of_coordinate(scene, body, stage, steady.axis) for stage in (0, number))
    pace = value_of_velocity(scene, body, 0, steady.axis)
    return tidy(last - first - pace * scene.scalar(steady.time.link.right))


def _write_steady(scene: Scene, path: Path, steady: Steady) -> int:
    """The line of a way at one component over the time that is given."""
    body, number = path.body, path.number
    first, last = (coordinate(scene, body, event, steady.axis) for event in (0, number))
    stage = last_move(scene, body, number)
    pace = velocity(scene, body, stage, steady.axis)
    refs = list(pace.refs)
    while stage:
        stage = last_move(scene, body, stage)
        refs += velocity(scene, body, stage, steady.axis).refs
    distance = swept(difference(tree_of(last.value), tree_of(first.value)))
    time = steady.time.link.right
    parts = set(walk(time))
    times = {
        time_tree(index): time_of(scene, index)
        for index in range(1, number)
        if time_tree(index) in parts
    }
    refs += [ref for source in times.values() for ref in source.refs]
    time = exchanged(time, {quantity: tree_of(own.value) for quantity, own in times.items()})
    flight = swept(product(tree_of(pace.value), time))
    whole = together(steady.time.refs, start(scene)[1], first.refs, last.refs, refs)
    if not times:
        return scene.desk.write(move_of(path), whole, chain(distance, (flight, None)))
    value = tidy(pace.value * scene.scalar(time))
    relation = chain(distance, (flight, None), (tree_of(in_tangents(value)), "rearrange"))
    return scene.judge.write((move_of(path),), whole, relation) or scene.desk.write(
        move_of(path), whole, chain(distance, (flight, None))
    )


def _who_goes(scene: Scene, number: int) -> str | None:
    """Who comes to a place that is known: a point, or where another body is at rest."""
    step = scene.model.happening(number).step
    if isinstance(step, Arrival):
        return step.body
    if not isinstance(step, Impact) or step.second not in scene.model.story.spheres:
        return None
    if circle_of(scene, number) is not None or striker(scene, number) is not None:
        return None
    if not any(True for _ in contact_of(scene, number)):
        return None
    pairs = ((step.first, step.second), (step.second, step.first))
    return next(
        (
            body
            for body, other in pairs
            if rests(scene, other, number) and f"position {other}" in scene.facts
        ),
        None,
    )


def _end_of(scene: Scene, body: str, number: int) -> Vector:
    """The place to which a body comes: of another that rests there, by that."""
    other = partner_of(scene, body, number)
    if other is None:
        return Vector(*scene.value(place_tree(body, number)))
    there = scene.vector(scene.facts[f"position {other}"].relation.only[0].right)
    return there + Vector(*(offset_at(scene, body, number, axis) for axis in AXES))


def _by_a_circle(scene: Scene, body: str, number: int) -> bool:
    """Whether a body comes from a circular wall, where its place gives no equation for a line."""
    return any(
        body in scene.bodies(index) and circle_of(scene, index) is not None
        for index in range(1, number)
        if len(scene.spheres(index)) == 1
    )


def _aim(scene: Scene, body: str, number: int) -> Path | None:
    """That a body has to come to a place from which it sends another one where it is told."""
    since = last_move(scene, body, number)
    place = scene.model.story.place(body, since)
    if place is None or (since and striker(scene, since) is not None):
        return None
    end = place_at(scene, number)
    place = scene.value(place_tree(body, since))
    if not since and (fact := scene.facts.get(f"position {body}")) is not None:
        place = scene.vector(fact.relation.only[0].right)  # with the letters of the data
    gap = Vector(end.x - place.x, end.y - place.y)
    residual = tidy(without_walls(scene, gap.cross(scene.velocity(body, since))))
    if not scene.unknown(residual):
        return None
    return Path(number, body, Candidate(f"aim {number}", 2.0, (residual,)))


def write_path(scene: Scene, path: Path) -> int:
    """The line of a path, and its number: at the time at which the body comes there, else without.

    Where one direction tells the time, the other gives the equation.
    """
    body, number = path.body, path.number
    if path.steady is not None:
        return _write_steady(scene, path, path.steady)
    pair = both_moving(scene, number)
    if pair is not None:
        return _write_meeting(scene, number, pair)
    since = last_move(scene, body, number)
    if striker(scene, number) == body:
        write_aim(scene, number)
    if partner_of(scene, body, number) is not None:
        write_touch(scene, body, number)
    for axis, other in (AXES, AXES[::-1]) if scene.speaks_of_times else ():
        pace = value_of_velocity(scene, body, since, axis)
        first = value_of_coordinate(scene, body, since, axis)
        last = value_of_coordinate(scene, body, number, axis)
        when = scene.model.happening(since).time if since else sp.Integer(0)
        values = [without_walls(scene, value) for value in (pace, first, last, when)]
        if pace == 0 or any(scene.unknown(value) for value in values):
            continue
        ends = [coordinate(scene, body, stage, other) for stage in (since, number)]
        if since and steady_axis(scene, body, number) == axis:
            write_last_way(scene, number, since)
        if standing(scene, time_tree(number)) is None:
            leg_along(scene, body, number, axis)
        flight, _, timed = flight_time(scene, since, number)
        speed = velocity(scene, body, since, other)
        return scene.desk.write(
            Move("define", "straight-line", number, (body,)),
            # Along a direction in which it does not move no time is needed.
            together(*(end.refs for end in ends), speed.refs, timed if speed.value != 0 else ()),
            chain(
                swept(difference(tree_of(ends[1].value), tree_of(ends[0].value))),
                (swept(product(tree_of(speed.value), flight)), None),
            ),
        )
    sides: list[Expression] = []
    refs: list[Ref] = []
    for axis in AXES:
        coordinate(scene, body, since, axis)
    paces = [velocity(scene, body, since, axis) for axis in AXES]
    by_slope = _by_slope(scene, path, paces)
    if by_slope is not None:
        return by_slope
    by_tangent = _by_tangent(scene, path, paces)
    if by_tangent is not None:
        return by_tangent
    for axis, pace in zip(AXES, reversed(paces), strict=True):
        ends = [coordinate(scene, body, stage, axis) for stage in (since, number)]
        refs += [ref for end in (*ends, pace) for ref in end.refs]
        sides.append(swept_product(scene, ends[1].value, ends[0].value, pace.value))
    match sides:
        case [Negate(left), Negate(right)]:
            sides = [left, right]
    return scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        refs,
        chain(sides[0], (sides[1], None)),
    )


def _write_meeting(scene: Scene, number: int, pair: tuple[str, str]) -> int:
    """That two that both move are in one place then, in the direction that does not tell when."""
    axis = in_the_other(scene, number, pair)
    leg(scene, number)
    first, second = (coordinate_moved(scene, sphere, number, axis) for sphere in pair)
    there = with_the_gap(scene, pair[0], number, axis, tree_of(second.value))
    relation = chain(tree_of(first.value), (there, None))
    refs = together((f"contact {number}",), first.refs, second.refs)
    return scene.desk.write(Move("fact"), refs, relation)


def _by_slope(scene: Scene, path: Path, paces: Sequence[Source]) -> int | None:
    """The way in one direction by that in the other and the ratio of the components.

    None where they have no factor in common that may vanish, by which both sides would be
    multiplied.
    """
    across, over = (pace.value for pace in paces)
    if across == 0 or over == 0:
        return None
    ratio = tidy(over / across)
    shared = (across.free_symbols & over.free_symbols) - ratio.free_symbols
    if all(proved_sign(scene.model.ground, symbol) for symbol in shared):
        return None
    return next(filter(None, (_slope_line(scene, path, paces, n) for n in ((0, 1), (1, 0)))), None)


def _slope_line(
    scene: Scene, path: Path, paces: Sequence[Source], order: Sequence[int]
) -> int | None:
    """The line of a way in the second direction, by that in the first; None if it fails."""
    body, number = path.body, path.number
    since = last_move(scene, body, number)
    ends = [[coordinate(scene, body, stage, AXES[n]) for stage in (since, number)] for n in order]
    (begin, end), (first, last) = ends
    pace, beside = (paces[n].value for n in order)
    distance = slope(scene, end.value, begin.value, beside, pace)
    value = tidy((end.value - begin.value) * beside / pace)
    left, right = swept(difference(tree_of(last.value), tree_of(first.value))), swept(distance)
    match left, right:
        case Negate(), Negate():
            left, right, value = left.operand, right.operand, -value
    relation = chain(left, (right, None), (tree_of(value), "rearrange"))
    refs = together(*(pace.refs for pace in (begin, end, first, last, *paces)))
    return scene.judge.write((move_of(path),), refs, relation)


def _by_tangent(scene: Scene, path: Path, paces: Sequence[Source]) -> int | None:
    """The tangent of an open angle by the ways, or an open way by the other one and the tangent.

    None where the ratio of the components is not a multiple of such a tangent.
    """
    if any(pace.value == 0 for pace in paces):
        return None
    since = last_move(scene, path.body, path.number)
    ends = [
        [coordinate(scene, path.body, number, axis) for number in (since, path.number)]
        for axis in AXES
    ]
    open_ = [bool(scene.unknown(last.value - first.value)) for first, last in ends]
    for order in ((1, 0), (0, 1)):
        over, beside = (paces[n].value for n in order)
        ratio = in_tangents(tidy(over / beside))
        if ratio.has(sp.sin, sp.cos) or len(ratio.atoms(sp.tan)) != 1 or not scene.unknown(ratio):
            continue
        if any(open_):
            known = [n for n in (0, 1) if not open_[n]]
            return _slope_line(scene, path, paces, (*known, 1 - known[0])) if known else None
        return _gradient_line(scene, path, ratio, [ends[n] for n in order], paces)
    return None


def _gradient_line(
    scene: Scene,
    path: Path,
    ratio: sp.Expr,
    ends: Sequence[Sequence[Source]],
    paces: Sequence[Source],
) -> int | None:
    """The line of a multiple of a tangent as a way over another one; None if it fails."""
    quotient, minus = gradient(scene, *ends)
    above, below = (last.value - first.value for first, last in ends)
    value = tidy(above / below)
    relation = chain(
        tree_of(-ratio if minus else ratio),
        (quotient, None),
        (tree_of(-value if minus else value), "rearrange"),
    )
    refs = together(*(source.refs for pair in ends for source in pair), *(e.refs for e in paces))
    known = background(scene, symbol_names(ratio))
    premises = scene.judge.enough(move_of(path), refs, relation, known)
    return None if premises is None else scene.desk.write(move_of(path), premises, relation)


def move_of(path: Path) -> Move:
    """The definition that the equation of a path is."""
    return Move("define", "straight-line", path.number, (path.body,))
