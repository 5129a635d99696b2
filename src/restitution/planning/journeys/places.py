"""Where a body is at an event, and when that is.

Between two events a body moves in a straight line at constant speed. A time follows from a
distance and the component of the velocity in that one direction; a place follows from a time.
Everything is counted along **i** and **j**.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Binary,
    Expression,
)
from restitution.planning.formulas.settled import settled
from restitution.planning.formulas.whereabouts import (
    axis_for,
    axis_of_approach,
    contact_of,
    hide_place_of_rest,
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
    value_of_velocity,
    velocity,
)
from restitution.planning.journeys.aims import striker, write_aim
from restitution.planning.journeys.arrivals import (
    Coordinate,
    line_of_wall,
    time_of_both,
    time_to_wall,
)
from restitution.planning.journeys.closing_gaps import time_at_once, time_of_closing
from restitution.planning.journeys.encounters import with_the_gap
from restitution.planning.journeys.flights import (
    begin_of,
    by_degrees,
    flight_by_axis,
    standing_leg,
    time_since,
)
from restitution.planning.journeys.place_lines import (
    know_place,
    nearest,
    open_line,
    stays_where_it_touched,
    velocity_then,
    write_place,
)
from restitution.planning.journeys.rims import (
    Approach,
    place_on_a_level,
    time_from_the_centre,
    time_of_touching,
    time_on_a_chord,
)
from restitution.planning.writing.circles import chord_from, chord_to_a_point, circle_of
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.flights import (
    added,
    divisor_refs,
    slope,
)
from restitution.planning.writing.forms import (
    difference,
    product,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.one_fraction import added_up
from restitution.planning.writing.place_trees import (
    AXES,
    Axis,
    coordinate_tree,
    duration_tree,
    place_tree,
    time_tree,
)
from restitution.planning.writing.scene import Scene
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
    settled(scene, coordinate_tree(body, stage, axis))
    known = standing(scene, coordinate_tree(body, stage, axis))
    if known is not None:
        return known
    placed = f"position {body}" in scene.facts
    if placed and last_move(scene, body, stage) == 0 and rests(scene, body, stage):
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
    if theirs is None and (rests(scene, other, stage) or _is_met(scene, body, other, stage, axis)):
        theirs = coordinate_moved(scene, other, stage, axis)
    if theirs is None:
        return None
    gap, refs = scene.put(offset_at(scene, body, stage, axis))
    return Source(tidy(theirs.value + gap), together((f"contact {stage}",), theirs.refs, refs))


def _is_met(scene: Scene, body: str, other: str, stage: int, axis: Axis) -> bool:
    """Whether the other body alone keeps its coordinate until both meet."""
    own, theirs = (keeps_still(scene, e, last_move(scene, e, stage), axis) for e in (body, other))
    return theirs and not own


def coordinate_moved(scene: Scene, body: str, stage: int, axis: Axis) -> Source:
    """A coordinate by the time since the last event of a body."""
    if rests(scene, body, stage) or open_line(scene, body, stage) is not None:
        place = place_moved(scene, body, stage)
        return Source(part_of(place.value, axis), place.refs)
    since = last_move(scene, body, stage)
    if not keeps_still(scene, body, since, axis):
        known = _by_the_other(scene, body, stage, axis)
        if known is not None:
            return known
        leg(scene, stage)
    near = nearest(scene, body, since, stage, axis)
    earlier: tuple[Ref, ...] = ()
    if near == since:
        near, earlier = _steady_since(scene, body, since, axis)
    mark = scene.desk.mark()
    own = _moved(scene, body, stage, axis, near, earlier)
    if own is None and near != since:
        # Over several ways at once it is not seen: one way after the other.
        scene.desk.back(mark)
        own = _moved(scene, body, stage, axis, since, ())
    if own is None:
        raise NotPlannedError("a coordinate by the time")
    return own


def _moved(
    scene: Scene, body: str, stage: int, axis: Axis, near: int, earlier: tuple[Ref, ...]
) -> Source | None:
    """A coordinate by that at an event before, and the time since; None if it does not follow.

    ``earlier`` tells of the component on the ways before the last one.
    """
    pace = velocity(scene, body, last_move(scene, body, stage), axis)
    first = coordinate(scene, body, near, axis)
    refs = [*first.refs, *pace.refs, *earlier]
    tree: Expression = tree_of(first.value)
    value = first.value
    if pace.value != 0:
        flight, length, used = flight_time(scene, near, stage)
        refs += used
        if length == 0:
            return _where_it_was(scene, body, stage, axis, first.value, refs)
        in_degrees = by_degrees(scene, body, last_move(scene, body, stage), axis)
        if in_degrees is None or scene.model.sign(scene.model.in_data(pace.value)) < 0:
            in_degrees = tree_of(pace.value)
        distance = swept(product(in_degrees, flight))
        if first.value == 0 and sp.Integer(1) in (pace.value, length) and length.is_number:
            # Of speed and time a reader looks for both, also where one of them is 1.
            distance = Binary("*", tree_of(pace.value), tree_of(length))
        tree = distance if first.value == 0 else swept(total((tree, distance)))
        value = tidy(first.value + pace.value * length)
    quantity = coordinate_tree(body, stage, axis)
    move, relation = (
        Move("define", "straight-line", stage, (body,)),
        added_up(scene, quantity, tree, value),
    )
    if earlier and not scene.judge.follows(move, refs, relation):
        return None
    return scene.desk.know(quantity, value, (scene.desk.write(move, refs, relation),))


def _where_it_was(
    scene: Scene, body: str, stage: int, axis: Axis, value: sp.Expr, refs: Sequence[Ref]
) -> Source | None:
    """A coordinate at an event that is at the time of the one before: nothing has moved since."""
    quantity = coordinate_tree(body, stage, axis)
    move = Move("define", "straight-line", stage, (body,))
    relation = chain(quantity, (tree_of(value), None))
    line = scene.judge.write((move,), refs, relation, shown="silent")
    return None if line is None else scene.desk.know(quantity, value, (line,))


def _steady_since(scene: Scene, body: str, since: int, axis: Axis) -> tuple[int, tuple[Ref, ...]]:
    """The event at which a body was in a known place, and since which a component is the same.

    With it what tells of the component from then on. It is ``since`` itself where something
    changed the component after that event.
    """
    pace = velocity(scene, body, since, axis).value
    stage = since
    refs: list[Ref] = []
    while stage and pace != 0 and coordinate_given(scene, body, stage, axis) is None:
        stage = last_move(scene, body, stage)
        own = velocity(scene, body, stage, axis)
        if circle_of(scene, stage) is not None or own.value != pace:
            return since, ()
        refs += own.refs
    return stage, tuple(refs)


def _by_the_other(scene: Scene, body: str, stage: int, axis: Axis) -> Source | None:
    """A coordinate by how far a body goes in the other direction, without the time.

    None where the time stands, or is wanted and can be told.
    """
    since = last_move(scene, body, stage)
    other: Axis = "j" if axis == "i" else "i"
    if len(scene.spheres(stage)) > 1 or body not in scene.bodies(stage) or stage == since:
        return None
    if circle_of(scene, stage) is not None or axis_for(scene, body, stage) != other:
        return None
    if since and circle_of(scene, since) is not None:
        return None
    stands: list[Expression] = [duration_tree(stage, index) for index in range(stage)]
    if any(scene.desk.known(tree) is not None for tree in (*stands, time_tree(stage))):
        return None
    beside = value_of_velocity(scene, body, since, other)
    if scene.speaks_of_times and scene.unknown(beside):
        beside = velocity(scene, body, since, other).value  # with its law written
    if scene.speaks_of_times and not scene.unknown(beside):
        return None
    start_, end = (coordinate(scene, body, number, other) for number in (since, stage))
    first = coordinate(scene, body, since, axis)
    pace, over = velocity(scene, body, since, axis), velocity(scene, body, since, other)
    distance = tidy(end.value - start_.value)
    value = tidy(first.value + distance * pace.value / over.value)
    one, two = (by_degrees(scene, body, since, letter) for letter in (axis, other))
    shares = None if one is None or two is None else (one, two)
    slope_ = slope(scene, end.value, start_.value, pace.value, over.value, shares)
    quantity = coordinate_tree(body, stage, axis)
    number = scene.desk.write(
        Move("define", "straight-line", stage, (body,)),
        together(
            *(source.refs for source in (start_, end, first, pace, over)),
            divisor_refs(scene, distance, over.value),
        ),
        chain(
            quantity,
            (swept(total((tree_of(first.value), slope_))), None),
            (tree_of(value), "rearrange"),
        ),
    )
    return scene.desk.know(quantity, value, (number,))


def place_moved(scene: Scene, body: str, stage: int) -> Source:
    """A place by the velocity since the last event of a body, as a vector."""
    quantity = place_tree(body, stage)
    known = standing(scene, quantity)
    if known is not None:
        return known
    since = last_move(scene, body, stage)
    if (level := _on_a_level(scene, body, stage)) is not None:
        return level
    if not rests(scene, body, stage):
        leg(scene, stage)
    open_ = open_line(scene, body, stage)
    if open_ is not None:
        _, time = leg(scene, stage)
        value = tidied(scene, scene.value(quantity))
        number = scene.desk.write(
            Move("put"), (open_, *time.refs), chain(quantity, (tree_of(value), None))
        )
        return know_place(scene, body, stage, value, number)
    near = nearest(scene, body, since, stage)
    first, pace = spot(scene, body, near), velocity_then(scene, body, since)
    refs = together(first.refs, pace.refs)
    tree: Expression = tree_of(first.value)
    value = first.value
    if tuple(pace.value) != (0, 0):
        flight, length, used = flight_time(scene, near, stage)
        refs = together(refs, used)
        tree = added(first.value, flight, pace.value)
        value = Vector(
            *(tidy(a + b * length) for a, b in zip(first.value, pace.value, strict=True))
        )
    move = Move("define", "straight-line", stage, (body,))
    number = stays_where_it_touched(scene, move, near, quantity, refs, value) or write_place(
        scene, move, quantity, refs, tree, value
    )
    hide_place_of_rest(scene, body, since, number)
    return know_place(scene, body, stage, value, number)


def _on_a_level(scene: Scene, body: str, number: int) -> Source | None:
    """Where a body that moves parallel to an axis comes to a circular wall, without the time.

    From inside, where the time is asked, that is found first: it has one positive root.
    """
    inside = f"order {number}" in scene.facts
    if scene.speaks_of_times and inside:
        return None
    if circle_of(scene, number) is None or len(scene.spheres(number)) > 1:
        return None
    if open_line(scene, body, number) is not None:  # the place is by the time already
        return None
    since = last_move(scene, body, number)
    still: list[Axis] = [axis for axis in AXES if keeps_still(scene, body, since, axis)]
    if len(still) != 1 or chord_from(scene, body, number) is not None:
        return None
    known = standing(scene, place_tree(body, number))
    if known is not None:
        return known
    along: Axis = "j" if still == ["i"] else "i"
    mark = scene.desk.mark()
    level = coordinate_moved(scene, body, number, still[0])
    pace = velocity(scene, body, since, along)
    own = place_on_a_level(scene, body, number, along, level, pace)
    if own is None:
        scene.desk.back(mark)
    return own


def spot(scene: Scene, body: str, stage: int) -> Source:
    """A place by its coordinates, without a line of its own."""
    known = standing(scene, place_tree(body, stage))
    if known is not None:
        return known
    if stage and all(coordinate_given(scene, body, stage, axis) is None for axis in AXES):
        return place_moved(scene, body, stage)
    x, y = (coordinate(scene, body, stage, axis) for axis in AXES)
    return Source(Vector(x.value, y.value), together(x.refs, y.refs))


def place(scene: Scene, body: str, stage: int) -> Source:
    """A place by its coordinates, where one of them is given; else by a vector."""
    quantity = place_tree(body, stage)
    known = standing(scene, quantity)
    if known is not None:
        return known
    if all(coordinate_given(scene, body, stage, axis) is None for axis in AXES):
        if (level := _on_a_level(scene, body, stage)) is not None:
            return level
        if not rests(scene, body, stage):
            leg(scene, stage)
        along, beside = (_with_its_time(scene, body, stage, axis) for axis in AXES)
        if not (along or beside):
            return place_moved(scene, body, stage)
    parts = [worked_out(scene, body, stage, axis) for axis in AXES]
    value = Vector(*(part.value for part in parts))
    number = scene.desk.write(
        Move("define", "assemble", stage or None, (body,)),
        together(*(part.refs for part in parts)),
        chain(quantity, (tree_of(value), None)),
    )
    return scene.desk.know(quantity, value, (number,))


def worked_out(scene: Scene, body: str, stage: int, axis: Axis) -> Source:
    """A coordinate; if letters in its line have been found since, by a line with these put in."""
    own = coordinate(scene, body, stage, axis)
    tree = coordinate_tree(body, stage, axis)
    known = scene.desk.known(tree)
    if known is None or own.value == known.value or known.value.is_Symbol:
        return own
    relation = chain(tree, (tree_of(own.value), None))
    line = scene.judge.write((Move("put"),), (*known.refs, *own.refs), relation)
    return own if line is None else scene.desk.know(tree, own.value, (line,))


def _with_its_time(scene: Scene, body: str, stage: int, axis: Axis) -> bool:
    """Puts its time into a coordinate that a line has by that, which was open; whether one has."""
    quantity = coordinate_tree(body, stage, axis)
    move = Move("define", "straight-line", stage, (body,))
    open_ = [
        line.number
        for line in scene.desk.lines
        if line.move == move
        and scene.desk.holds(line.number)
        and scene.desk.relation(line.number).only[0].left == quantity
    ]
    if not open_:
        return False
    begin, time = leg(scene, stage)
    flight, length = time_since(scene, stage, begin), tree_of(time.value)
    right = scene.desk.relation(open_[0]).only[0].right
    put = swept(rebuilt(right, lambda tree: length if tree == flight else tree))
    value = part_of(tidied(scene, scene.value(place_tree(body, stage))), axis)
    relation = added_up(scene, quantity, put, value)
    number = scene.judge.write((Move("put"),), (open_[0], *time.refs), relation)
    if number is not None:
        scene.desk.know(quantity, value, (number,))
    return number is not None


# --- times -----------------------------------------------------------------------------------


def time_of(scene: Scene, number: int) -> Source:
    """The time of an event; written down where it is worked out, as a sum of the ways to it."""
    first, refs = start(scene)
    if number == first:
        return Source(sp.Integer(0), refs)
    known = standing(scene, time_tree(number))
    if known is not None:
        return known
    legs = _legs(scene, number, first)
    if len(legs) == 1:
        return legs[number]
    for moment in sorted(legs)[-2:0:-1]:
        # A time that stands is not added up once more.
        early = standing(scene, time_tree(moment))
        if early is not None:
            legs = {moment: early} | {end: own for end, own in legs.items() if end > moment}
            break
    value = tidy(sum(source.value for source in legs.values()))
    terms = [tree_of(legs[end].value) for end in sorted(legs)]
    line = scene.desk.write(
        Move("put"),
        (*leg_line(scene, number), *(ref for source in legs.values() for ref in source.refs)),
        added_up(scene, time_tree(number), swept(total(terms)), value),
    )
    return scene.desk.know(time_tree(number), value, (line,))


def flight_time(
    scene: Scene, since: int, stage: int
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The time between two events by the ways in between: a tree, its value, what it rests on."""
    first, begin = start(scene)
    if since != first:
        before, own = leg(scene, stage)
        if before == since:
            return tree_of(own.value), own.value, own.refs
    known = standing(scene, time_tree(stage)) if since == first else None
    if known is None and since == first and time_tree(stage) in scene.asked_alone:
        known = time_of(scene, stage)  # it is asked: what rests on it comes after it
    if known is not None:
        return tree_of(known.value), known.value, together(begin, known.refs)
    mark = scene.desk.mark()
    late, early = _legs(scene, stage, since), dict[int, Source]()
    if not late:
        scene.desk.back(mark)
        late, early = _legs(scene, stage, first), _legs(scene, since, first)
    more = [late[key] for key in sorted(late.keys() - early.keys())]
    less = [early[key] for key in sorted(early.keys() - late.keys())]
    tree = difference(
        total(tree_of(source.value) for source in more),
        total(tree_of(source.value) for source in less),
    )
    value = tidy(sum(source.value for source in more) - sum(source.value for source in less))
    refs = begin if since == first else ()
    return tree, value, together(refs, *(source.refs for source in (*more, *less)))


def _legs(scene: Scene, number: int, first: int) -> dict[int, Source]:
    """The ways from one event to another, each by the event at its end; none of others' ways."""
    sources: dict[int, Source] = {}
    if number > first:
        # The ways are written in the order of the story.
        known = standing_leg(scene, number)
        since = last_move(scene, scene.bodies(number)[0], number) if known is None else known[0]
        if since > first:
            _legs(scene, since, first)
    while number > first:
        begin, own = leg(scene, number)
        sources[number] = own
        number = begin
    return sources if number == first else {}


def leg(scene: Scene, number: int) -> tuple[int, Source]:
    """The event at which the last way to an event begins, and how long that takes.

    It is written down where it is worked out.
    """
    first, refs = start(scene)
    if number == first:
        return first, Source(sp.Integer(0), refs)
    if (stands := standing_leg(scene, number)) is not None:
        return stands
    known = standing(scene, time_tree(number))
    if known is not None:
        return first, known
    if number < first:
        raise NotPlannedError("a time before the clock starts")
    if number == 0:
        raise NotPlannedError("the start has no time")
    step = scene.model.happening(number).step
    if isinstance(step, Impact) and step.second in scene.model.story.spheres:
        return _leg_of_meeting(scene, number, step)
    if not isinstance(step, Impact | Arrival):
        raise NotPlannedError("the time of a blow")
    body = scene.bodies(number)[0]
    axis = axis_for(scene, body, number)
    if circle_of(scene, number) is not None:
        return _leg_to_circle(scene, body, number)
    if chord_to_a_point(scene, body, number) is not None:
        since = last_move(scene, body, number)
        return since, time_on_a_chord(scene, body, number, since, time_since(scene, number, since))
    if axis is None:
        return _leg_to_slanted(scene, body, number)
    return leg_along(scene, body, number, axis)


def leg_line(scene: Scene, number: int) -> tuple[Ref, ...]:
    """The line of the last way to an event, from which a sum of times starts."""
    known = scene.desk.known(time_since(scene, number, leg(scene, number)[0]))
    return () if known is None else known.refs


def leg_along(scene: Scene, body: str, number: int, axis: Axis) -> tuple[int, Source]:
    """The time of a way by a distance and a speed in one direction."""
    since = last_move(scene, body, number)
    refs = begin_of(scene, since)
    first, last = coordinate(scene, body, since, axis), coordinate(scene, body, number, axis)
    return since, flight_by_axis(scene, number, body, (first, last), since, axis, refs)


def _leg_to_circle(scene: Scene, body: str, number: int) -> tuple[int, Source]:
    """The time to a circular wall, from another point of it or from beside it."""
    since = last_move(scene, body, number)
    refs = begin_of(scene, since)
    flight = time_since(scene, number, since)
    if chord_from(scene, body, number) is not None:
        return since, time_on_a_chord(scene, body, number, since, flight)
    if direct := time_from_the_centre(scene, body, number, flight):
        return since, direct
    level = None if f"order {number}" in scene.facts else _on_a_level(scene, body, number)
    if level is not None:
        return leg_along(scene, body, number, "j" if keeps_still(scene, body, since, "i") else "i")
    early = time_of(scene, since) if since != start(scene)[0] else Source(sp.Integer(0), refs)
    first, pace = spot(scene, body, since), velocity_then(scene, body, since)
    return start(scene)[0], time_of_touching(scene, number, [Approach(body, first, pace, early)])


def _leg_to_slanted(scene: Scene, body: str, number: int) -> tuple[int, Source]:
    """The time to a wall that is not along an axis."""
    wall = line_of_wall(scene, number)
    since = last_move(scene, body, number)
    begin = begin_of(scene, since)
    first, pace = spot(scene, body, since), velocity_then(scene, body, since)
    return since, time_to_wall(scene, body, number, wall, (first, pace, since, begin))


def _leg_of_meeting(scene: Scene, number: int, step: Impact) -> tuple[int, Source]:
    """The time to where two spheres meet, from the one direction in which they approach."""
    if not any(True for _ in contact_of(scene, number)):
        raise NotPlannedError("where spheres with radii touch")
    aimed = striker(scene, number)
    if aimed is not None:
        write_aim(scene, number)
        pace = scene.velocity(aimed, last_move(scene, aimed, number))
        return leg_along(scene, aimed, number, "i" if pace.x != 0 else "j")
    if circle_of(scene, number) is not None:
        approaches = [_approach(scene, body, number) for body in scene.bodies(number)]
        return start(scene)[0], time_of_touching(scene, number, approaches)
    at_once = time_at_once(scene, number, (step.first, step.second))
    if at_once is not None:
        return start(scene)[0], at_once
    for body, other in ((step.first, step.second), (step.second, step.first)):
        if rests(scene, other, number) or _comes_across(scene, number, body, other):
            return _leg_to_resting(scene, number, body, other)
    return _leg_of_two(scene, number, step.first, step.second)


def _comes_across(scene: Scene, number: int, body: str, other: str) -> bool:
    """Whether the other sphere keeps its coordinate in the direction in which they approach."""
    axis = axis_of_approach(scene, number, body, other)
    own, theirs = (velocity(scene, e, last_move(scene, e, number), axis) for e in (body, other))
    return bool(theirs.value == 0 and own.value != 0)


def _approach(scene: Scene, body: str, number: int) -> Approach:
    """How a body comes to an event."""
    since = last_move(scene, body, number)
    first, pace = spot(scene, body, since), velocity_then(scene, body, since)
    early = None if rests(scene, body, number) else time_of(scene, since)
    return Approach(body, first, pace, early)


def _leg_to_resting(scene: Scene, number: int, body: str, other: str) -> tuple[int, Source]:
    since = last_move(scene, body, number)
    begin = begin_of(scene, since)
    axis = axis_of_approach(scene, number, body, other)
    first, last = coordinate(scene, body, since, axis), coordinate(scene, body, number, axis)
    theirs = tree_of(tidy(last.value - offset_at(scene, body, number, axis)))
    end = with_the_gap(scene, body, number, axis, theirs)
    return since, flight_by_axis(scene, number, body, (first, last), since, axis, begin, end)


def _leg_by_a_gap(
    scene: Scene, number: int, pair: tuple[str, str], begin: int, axis: Axis
) -> Source | None:
    """The time in which a pair that moves along an axis closes the gap between them."""
    mark = scene.desk.mark()
    places = {sphere: coordinate(scene, sphere, begin, axis) for sphere in pair}
    closed = time_of_closing(scene, number, pair, begin, axis, places)
    if closed is None:
        scene.desk.back(mark)
    return closed


def _leg_of_two(scene: Scene, number: int, body: str, other: str) -> tuple[int, Source]:
    """The one's coordinate with the time as unknown; the other comes to the same place then.

    The time is counted from the later of their last events, at which the other one has a place
    too; where others met in between, from the start.
    """
    axis = axis_of_approach(scene, number, body, other)
    first, _ = start(scene)
    last = {sphere: last_move(scene, sphere, number) for sphere in (body, other)}
    begin = max(last.values())
    if begin != number - 1 and set(last.values()) != {begin}:
        begin = first
    begins = begin_of(scene, begin)
    if begin == max(last.values()):
        closed = _leg_by_a_gap(scene, number, (body, other), begin, axis)
        if closed is not None:
            return begin, closed
    flight = time_since(scene, number, begin)
    own = _in_the_time(scene, body, number, (begin, begins), axis)
    line = _coordinate_line(scene, body, number, axis, own)
    if velocity(scene, other, last[other], axis).value == 0:
        end = coordinate_moved(scene, other, number, axis)
        theirs = Coordinate(tree_of(end.value), end.value, sp.Integer(0), end.refs)
    else:
        moving = _in_the_time(scene, other, number, (begin, begins), axis)
        open_ = _coordinate_line(scene, other, number, axis, moving)
        theirs = moving._replace(refs=(open_,))
    gap = tidy(offset_at(scene, body, number, axis))
    theirs = theirs._replace(
        tree=with_the_gap(scene, body, number, axis, theirs.tree), start=theirs.start + gap
    )
    return begin, time_of_both(scene, number, flight, own._replace(refs=(line,)), theirs)


def _in_the_time(
    scene: Scene, body: str, number: int, since: tuple[int, tuple[Ref, ...]], axis: Axis
) -> Coordinate:
    """A coordinate at an event, in the time since another, which has its refs, as unknown."""
    begin, begins = since
    last = last_move(scene, body, number)
    flight = time_since(scene, number, begin)
    pace = velocity(scene, body, last, axis)
    near = max(begin, last)
    if near > last:
        spot(scene, body, near)
    place = coordinate(scene, body, near, axis)
    if near == begin:
        duration, constant, refs = flight, place.value, begins
    else:
        early = time_of(scene, near)
        duration = difference(flight, tree_of(early.value))
        constant, refs = place.value - pace.value * early.value, early.refs
    tree = swept(total((tree_of(place.value), product(tree_of(pace.value), duration))))
    return Coordinate(tree, constant, pace.value, together(place.refs, pace.refs, refs))


def _coordinate_line(scene: Scene, body: str, number: int, axis: Axis, own: Coordinate) -> int:
    return scene.desk.write(
        Move("define", "straight-line", number, (body,)),
        own.refs,
        chain(coordinate_tree(body, number, axis), (own.tree, None)),
    )
