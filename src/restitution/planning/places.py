"""Where a body is at an event, and when that is.

Between two events a body moves in a straight line at constant speed. A time follows from a
distance and the component of the velocity in that one direction; a place follows from a time.
Everything is counted along **i** and **j**.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import Binary, Expression, Quantity, walk
from restitution.planning.aims import striker, write_aim
from restitution.planning.circles import chord_from, circle_of
from restitution.planning.closing import nonzero
from restitution.planning.desk import NotPlannedError, Source, chain, link, together
from restitution.planning.flights import added, divisor_refs, time_quotient
from restitution.planning.forms import ZERO, difference, product, swept, total, tree_of
from restitution.planning.place_trees import AXES, Axis, coordinate_tree, place_tree, time_tree
from restitution.planning.rims import Way, time_of_touching, time_on_a_chord
from restitution.planning.scene import Scene
from restitution.planning.whereabouts import (
    axis_for,
    axis_of_approach,
    contact_of,
    keeps_still,
    last_move,
    of_contact,
    offset_at,
    part_of,
    partner_of,
    rests,
    source_of,
    standing,
    start,
    tidied,
    velocity,
)
from restitution.problem import Arrival, Impact
from restitution.vector import Vector


def coordinate(scene: Scene, body: str, stage: int, axis: Axis) -> Source:
    """A coordinate of a body at an event; written down where it is worked out."""
    given = coordinate_given(scene, body, stage, axis)
    return coordinate_moved(scene, body, stage, axis) if given is None else given


def coordinate_given(scene: Scene, body: str, stage: int, axis: Axis) -> Source | None:
    """A coordinate that needs no working: of the data, of a line, or of the other body there."""
    if stage == 0:
        fact = scene.facts.get(f"position {body}")
        if fact is None:
            raise NotPlannedError(f"the place of {body} at the start is not given")
        place = scene.value(fact.relation.only[0].right)
        return source_of(scene, part_of(place, axis), (fact.id,))
    known = standing(scene, coordinate_tree(body, stage, axis))
    if known is not None:
        return known
    if last_move(scene, body, stage) == 0 and rests(scene, body, stage):
        # Who rests stays where it is.
        own = coordinate_given(scene, body, 0, axis)
        return None if own is None else Source(own.value, together(own.refs, (f"velocity {body}",)))
    if body not in scene.bodies(stage):
        return None
    if "origin" in scene.facts and stage == start(scene)[0]:
        if body == scene.bodies(stage)[0]:
            return Source(sp.Integer(0), ("origin",))
        offset = offset_at(scene, body, stage, axis)
        return source_of(scene, offset, (f"contact {stage}", "origin"))
    given = of_contact(scene, body, stage, axis)
    if given is not None:
        return given
    other = partner_of(scene, body, stage)
    if circle_of(scene, stage) is not None:
        return None  # how far apart they are does not tell in which direction
    if other is None or not any(True for _ in contact_of(scene, stage)):
        return None
    theirs = standing(scene, coordinate_tree(other, stage, axis))
    if theirs is None and rests(scene, other, stage):
        theirs = coordinate_moved(scene, other, stage, axis)
    if theirs is None:
        return None
    gap, refs = scene.put(offset_at(scene, body, stage, axis))
    return Source(tidy(theirs.value + gap), together((f"contact {stage}",), theirs.refs, refs))


def coordinate_moved(scene: Scene, body: str, stage: int, axis: Axis) -> Source:
    """A coordinate by the time since the last event of a body."""
    if rests(scene, body, stage) or _open_line(scene, body, stage) is not None:
        place = place_moved(scene, body, stage)
        return Source(part_of(place.value, axis), place.refs)
    since = last_move(scene, body, stage)
    if not keeps_still(scene, body, since, axis):
        time_of(scene, stage)
    first = coordinate(scene, body, since, axis)
    pace = velocity(scene, body, since, axis)
    refs = [*first.refs, *pace.refs]
    tree: Expression = tree_of(first.value)
    value = first.value
    if pace.value != 0:
        flight, length, used = _flight_time(scene, since, stage)
        refs += used
        tree = total((tree, product(tree_of(pace.value), flight)))
        value = tidy(first.value + pace.value * length)
    quantity = coordinate_tree(body, stage, axis)
    number = scene.desk.write(
        Move("define", "straight-line", stage, (body,)),
        refs,
        chain(quantity, (swept(tree), None), (tree_of(value), "rearrange")),
    )
    return scene.desk.know(quantity, value, (number,))


def _flight_time(
    scene: Scene, since: int, stage: int
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The time between two events, as a difference, and what it is worth."""
    early, late = time_of(scene, since), time_of(scene, stage)
    tree = difference(tree_of(late.value), tree_of(early.value))
    return tree, tidy(late.value - early.value), together(early.refs, late.refs)


def place_moved(scene: Scene, body: str, stage: int) -> Source:
    """A place by the velocity since the last event of a body, as a vector."""
    quantity = place_tree(body, stage)
    known = standing(scene, quantity)
    if known is not None:
        return known
    since = last_move(scene, body, stage)
    if not rests(scene, body, stage):
        time_of(scene, stage)
    open_ = _open_line(scene, body, stage)
    if open_ is not None:
        time = time_of(scene, stage)
        value = tidied(scene, scene.value(quantity))
        number = scene.desk.write(
            Move("put"), (open_, *time.refs), chain(quantity, (tree_of(value), None))
        )
        return _know_place(scene, body, stage, value, number)
    first, pace = spot(scene, body, since), velocity_then(scene, body, since)
    refs = together(first.refs, pace.refs)
    tree: Expression = tree_of(first.value)
    value = first.value
    if tuple(pace.value) != (0, 0):
        flight, length, used = _flight_time(scene, since, stage)
        refs = together(refs, used)
        tree = added(first.value, flight, pace.value)
        value = Vector(
            *(tidy(a + b * length) for a, b in zip(first.value, pace.value, strict=True))
        )
    number = write_place(
        scene, Move("define", "straight-line", stage, (body,)), quantity, refs, tree, value
    )
    return _know_place(scene, body, stage, value, number)


def write_place(
    scene: Scene,
    move: Move,
    quantity: Expression,
    refs: Sequence[Ref],
    tree: Expression,
    value: Vector,
) -> int:
    """Writes a place, and what it comes to in a line below; returns the number of the last."""
    own = tree_of(value)
    number = scene.desk.write(move, refs, chain(quantity, (tree, None)))
    if own != tree:
        number = scene.desk.write(Move("rearrange"), (number,), chain(quantity, (own, None)))
    return number


def _know_place(scene: Scene, body: str, stage: int, value: Vector, number: int) -> Source:
    for axis, each in zip(AXES, value, strict=True):
        scene.desk.know(coordinate_tree(body, stage, axis), each, (number,))
    return scene.desk.know(place_tree(body, stage), value, (number,))


def spot(scene: Scene, body: str, stage: int) -> Source:
    """A place by its coordinates, without a line of its own."""
    known = standing(scene, place_tree(body, stage))
    if known is not None:
        return known
    if stage and all(coordinate_given(scene, body, stage, axis) is None for axis in AXES):
        return place_moved(scene, body, stage)
    x, y = (coordinate(scene, body, stage, axis) for axis in AXES)
    return Source(Vector(x.value, y.value), together(x.refs, y.refs))


def velocity_then(scene: Scene, body: str, stage: int) -> Source:
    """A velocity as a vector, by its components along **i** and **j**."""
    x, y = (velocity(scene, body, stage, axis) for axis in AXES)
    return Source(Vector(x.value, y.value), together(x.refs, y.refs))


def _open_line(scene: Scene, body: str, stage: int) -> int | None:
    """The line that says where a body is by a time that is not yet known."""
    for each in scene.desk.lines:
        if each.move == Move("define", "straight-line", stage, (body,)) and scene.desk.holds(
            each.number
        ):
            (own, *_) = scene.desk.relation(each.number).only
            if own.left == place_tree(body, stage) and time_tree(stage) in set(walk(own.right)):
                return each.number
    return None


def time_of(scene: Scene, number: int) -> Source:
    """The time of an event; written down where it is worked out."""
    first, refs = start(scene)
    if number == first:
        return Source(sp.Integer(0), refs)
    known = standing(scene, time_tree(number))
    if known is not None:
        return known
    if number < first:
        raise NotPlannedError("a time before the clock starts")
    if number == 0:
        raise NotPlannedError("the start has no time")
    step = scene.model.happening(number).step
    if isinstance(step, Impact) and step.second in scene.model.story.spheres:
        return _time_of_meeting(scene, number, step)
    if not isinstance(step, Impact | Arrival):
        raise NotPlannedError("the time of a blow")
    body = scene.bodies(number)[0]
    axis = axis_for(scene, body, number)
    if circle_of(scene, number) is not None:
        return _time_to_circle(scene, body, number)
    if axis is None:
        return _time_to_slanted(scene, body, number)
    return time_along(scene, body, number, axis)


def time_along(scene: Scene, body: str, number: int, axis: Axis) -> Source:
    """A time by a distance and a speed in one direction."""
    since = last_move(scene, body, number)
    early = time_of(scene, since)
    first, last = coordinate(scene, body, since, axis), coordinate(scene, body, number, axis)
    pace = velocity(scene, body, since, axis)
    return _flight(scene, number, body, (first, last), pace, early)


def _flight(
    scene: Scene,
    number: int,
    body: str,
    ends: tuple[Source, Source],
    pace: Source,
    early: Source,
) -> Source:
    first, last = ends
    tree = time_quotient(scene, last.value, first.value, pace.value)
    value = tidy(early.value + (last.value - first.value) / pace.value)
    refs = together(
        first.refs,
        last.refs,
        pace.refs,
        early.refs,
        divisor_refs(scene, tidy(last.value - first.value), pace.value),
    )
    quantity = time_tree(number)
    line = scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        refs,
        chain(
            quantity,
            (swept(total((tree_of(early.value), tree))), None),
            (tree_of(value), "rearrange"),
        ),
    )
    return scene.desk.know(quantity, value, (line,))


def _time_to_circle(scene: Scene, body: str, number: int) -> Source:
    """The time to a circular wall, from another point of it or from beside it."""
    since = last_move(scene, body, number)
    early = time_of(scene, since)
    if chord_from(scene, body, number) is not None:
        return time_on_a_chord(scene, body, number, since, early)
    first, pace = spot(scene, body, since), velocity_then(scene, body, since)
    return time_of_touching(scene, number, [Way(body, first, pace, early)])


def _time_to_slanted(scene: Scene, body: str, number: int) -> Source:
    """The time to a wall that is not along an axis: the coordinates by the time, on its line."""
    match next(contact_of(scene, number), None):
        case Link(Quantity("dot", (Binary("-", _, through), normal)), "=", _):
            place, axis = tidied(scene, scene.value(through)), tidied(scene, scene.value(normal))
        case _:
            raise NotPlannedError("the time to a wall whose place is not given")
    since = last_move(scene, body, number)
    first, pace, early = (
        spot(scene, body, since),
        velocity_then(scene, body, since),
        time_of(scene, since),
    )
    t = time_tree(number)
    flight = difference(t, tree_of(early.value))
    open_ = scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        together(first.refs, pace.refs, early.refs),
        chain(place_tree(body, number), (added(first.value, flight, pace.value), None)),
    )
    terms = [
        product(
            tree_of(n),
            total((tree_of(tidy(a - b)), product(tree_of(v), flight))),
        )
        for n, a, b, v in zip(axis, first.value, place, pace.value, strict=True)
        if n != 0
    ]
    fact = scene.desk.write(
        Move("fact"), (f"contact {number}", open_), Relation(((link(swept(total(terms)), ZERO),),))
    )
    closing = tidy(pace.value.dot(axis))
    value = tidy(early.value + (place - first.value).dot(axis) / closing)
    line = scene.desk.write(
        Move("rearrange"), (fact, *nonzero(scene, closing)), chain(t, (tree_of(value), None))
    )
    return scene.desk.know(t, value, (line,))


def _time_of_meeting(scene: Scene, number: int, step: Impact) -> Source:
    """The time at which two spheres meet, from the one direction in which they approach."""
    if not any(True for _ in contact_of(scene, number)):
        raise NotPlannedError("where spheres with radii touch")
    aimed = striker(scene, number)
    if aimed is not None:
        write_aim(scene, number)
        pace = scene.velocity(aimed, last_move(scene, aimed, number))
        return time_along(scene, aimed, number, "i" if pace.x != 0 else "j")
    if circle_of(scene, number) is not None:
        return time_of_touching(
            scene, number, [_way(scene, each, number) for each in scene.bodies(number)]
        )
    for body, other in ((step.first, step.second), (step.second, step.first)):
        if rests(scene, other, number):
            return _time_to_resting(scene, number, body, other)
    if any(offset_at(scene, step.first, number, axis) != 0 for axis in AXES):
        raise NotPlannedError("where two spheres with radii touch that both move")
    return _time_of_two(scene, number, step.first, step.second)


def _way(scene: Scene, body: str, number: int) -> Way:
    """How a body comes to an event."""
    since = last_move(scene, body, number)
    first, pace = spot(scene, body, since), velocity_then(scene, body, since)
    early = None if rests(scene, body, number) else time_of(scene, since)
    return Way(body, first, pace, early)


def _time_to_resting(scene: Scene, number: int, body: str, other: str) -> Source:
    since = last_move(scene, body, number)
    axis = axis_of_approach(scene, number, body, other)
    first, last = coordinate(scene, body, since, axis), coordinate(scene, body, number, axis)
    pace, early = velocity(scene, body, since, axis), time_of(scene, since)
    return _flight(scene, number, body, (first, last), pace, early)


def _time_of_two(scene: Scene, number: int, body: str, other: str) -> Source:
    """The one's coordinate with the time as unknown; the other comes to the same place then."""
    axis = axis_of_approach(scene, number, body, other)
    t = time_tree(number)
    since = last_move(scene, other, number)
    first, pace = coordinate(scene, other, since, axis), velocity(scene, other, since, axis)
    if pace.value == 0:
        last = coordinate_moved(scene, other, number, axis)
        there, constant, used = tree_of(last.value), last.value, last.refs
    else:
        early = time_of(scene, since)
        flight = difference(t, tree_of(early.value))
        there = swept(total((tree_of(first.value), product(tree_of(pace.value), flight))))
        constant = first.value - pace.value * early.value
        used = (
            scene.desk.write(
                Move("define", "straight-line", number, (other,)),
                together(first.refs, pace.refs, early.refs),
                chain(coordinate_tree(other, number, axis), (there, None)),
            ),
        )
    since = last_move(scene, body, number)
    start_, speed = coordinate(scene, body, since, axis), velocity(scene, body, since, axis)
    early = time_of(scene, since)
    flight = difference(t, tree_of(early.value))
    own = swept(total((tree_of(start_.value), product(tree_of(speed.value), flight))))
    met = scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        together(start_.refs, speed.refs, early.refs, (f"contact {number}",), used),
        chain(own, (there, None)),
    )
    closing = tidy(speed.value - pace.value)
    value = tidy((constant - start_.value + speed.value * early.value) / closing)
    line = scene.desk.write(
        Move("rearrange"),
        (met, *nonzero(scene, closing)),
        chain(t, (tree_of(value), None)),
    )
    return scene.desk.know(t, value, (line,))
