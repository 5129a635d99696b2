"""Places, chords and rounds, by where bodies were and how they moved."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

from restitution.explaining.definitions.common import axis_of, total_of, unit_vector, whole_links
from restitution.explaining.lines.derivation import Event, Link
from restitution.explaining.lines.quotients import Plane
from restitution.explaining.lines.trees import settled, squared
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    Apply,
    AtTime,
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Quantity,
    is_binary,
    is_zero,
    walk,
)


def places(step: Step, event: Event | None, line: Link) -> Iterator[Link]:
    """What a place at a time, and a distance, is; times and bodies are the line's."""
    if step.move.record == "straight-line" and event is not None:
        yield from _journeys(step, event)
        yield from _several_ways(step, event)
        yield from _gaps_closed(step, event)
    for tree in (*walk(line.left), *walk(line.right)):
        match tree:
            case Quantity("position", _, AtTime()):
                yield Link(tree, "=", _place_of(tree, event))
            case Quantity("distance", (a, b), stage):
                there = _ends_of(step, (a, b), stage)
                places = [_place_of(tree, event) for tree in there]
                match stage:  # at the time of an event they are where they are at that event
                    case AtTime(Quantity("time", (), int(number))):
                        ends = _ends_of(step, (a, b), number)
                        yield Link(tree, "=", Apply("abs", Binary("-", *ends)))
                yield Link(tree, "=", Apply("abs", Binary("-", places[0], places[1])))
                if places != there:
                    yield Link(tree, "=", Apply("abs", Binary("-", there[0], there[1])))
                if _go_on_from(step, event, (a, b), stage):
                    then = AtTime(Quantity("time", (), stage))
                    ends = [_place_of(Quantity("position", (e,), then), event) for e in (a, b)]
                    yield Link(tree, "=", Apply("abs", Binary("-", *ends)))


def _ends_of(step: Step, ends: tuple[Expression, Expression], stage: Any) -> list[Expression]:
    """The places between which a distance is."""
    return [
        Quantity("position", (end,), _stage_of(step, end, stage)) if isinstance(end, Name) else end
        for end in ends
    ]


def _go_on_from(
    step: Step, event: Event | None, bodies: tuple[Expression, Expression], stage: Any
) -> bool:
    """Whether two bodies go on from an impact with each other until a later event."""
    names = {body.name for body in bodies if isinstance(body, Name)}
    if event is None or event.kind != "impact" or names != set(event.bodies):
        return False
    if not isinstance(stage, int) or stage <= event.number:
        return False
    between = (own for own in step.setting.events if event.number < own.number < stage)
    return not any(names & set(own.bodies) for own in between)


def _journeys(step: Step, event: Event) -> Iterator[Link]:
    """How a body comes to an event from its last one, where others happened in between.

    At a point that it comes to nothing changes: the way may begin at the event before that.
    """
    for body in step.move.bodies:
        own = [e for e in step.setting.events if body in e.bodies[:2] and e.number < event.number]
        while own and own[-1].kind == "arrival":
            yield from _journey(body, own.pop().number, event)
        yield from _journey(body, own[-1].number if own else 0, event)


def _journey(body: str, since: int, event: Event) -> Iterator[Link]:
    """How a body comes to an event from an earlier one that is not the one before it."""
    if since == event.number - 1:
        return
    name = Name(body)
    last, first = (Quantity("position", (name,), number) for number in (event.number, since))
    late, early = (Quantity("time", (), number) for number in (event.number, since))
    velocity = Quantity("velocity", (name,), since)
    flight = Binary("-", late, early)
    yield Link(Binary("-", last, first), "=", Binary("*", velocity, flight))
    lengths, paces = [], []
    for axis in "ij":
        a, b, pace = (Quantity("along", (e, unit_vector(axis))) for e in (last, first, velocity))
        lengths.append(Binary("-", a, b))
        paces.append(pace)
        yield Link(lengths[-1], "=", Binary("*", pace, flight))
    yield Link(Binary("*", lengths[1], paces[0]), "=", Binary("*", lengths[0], paces[1]))


def _several_ways(step: Step, event: Event) -> Iterator[Link]:
    """How far a body comes from an earlier event over several ways, in one direction."""
    for body in step.move.bodies:
        own = [e.number for e in step.setting.events if body in e.bodies[:2]]
        stages = [0, *(number for number in own if number < event.number), event.number]
        for first, axis in product(range(len(stages) - 2), "ij"):
            lengths: list[Expression] = []
            for early, late in pairwise(stages[first:]):
                flight = Binary("-", Quantity("time", (), late), Quantity("time", (), early))
                lengths.append(Binary("*", _along("velocity", body, early, axis), flight))
            ends = (
                _along("position", body, number, axis) for number in (stages[-1], stages[first])
            )
            yield Link(Binary("-", *ends), "=", total_of(lengths))


def _gaps_closed(step: Step, event: Event) -> Iterator[Link]:
    """How long two bodies take to close the gap between them, which move along **i**, or **j**.

    It is cited that they meet with no gap left, or with two radii between their centres. Their
    distance is that at an event since which neither has changed how it moves.
    """
    bodies = tuple(map(Name, event.bodies))
    if len(bodies) != 2 or set(step.move.bodies) != set(event.bodies) or event.wall:
        return
    ends = [Quantity("position", (body,), event.number) for body in bodies]
    contacts = [link for link in step.links if link.sign == "=" and link.left in ends]
    together = any({link.left, link.right} == set(ends) for link in contacts)
    if not together and not any(isinstance(link.right, Binary) for link in contacts):
        return
    own = (
        e.number
        for e in step.setting.events
        if e.number < event.number and set(event.bodies) & set(e.bodies[:2])
    )
    for since in range(max(own, default=0), event.number):
        paces = [settled(Quantity("velocity", (b,), since), step.setting.events) for b in bodies]
        closing = step.rules().put_into(step.world.value(Binary("-", *paces)))
        parting = isinstance(closing, Plane) and any(
            step.signs.of(pace) in (1, -1) for pace in (closing.x, closing.y)
        )
        if together and parting and _are_in_one_place(step, bodies, since):
            # Who is together and parts meets there and then.
            yield Link(Quantity("time", (), event.number), "=", Quantity("time", (), since))
        if not isinstance(closing, Plane) or closing.x.vanishes == closing.y.vanishes:
            continue
        axis, pace = ("i", closing.x) if closing.y.vanishes else ("j", closing.y)
        sign = step.signs.of(pace)
        if sign not in (1, -1):
            continue
        along = [Quantity("along", (pace, unit_vector(axis))) for pace in paces[::sign]]
        times = (Quantity("time", (), number) for number in (event.number, since))
        quotient = Binary("*", Binary("-", *along), Binary("-", *times))
        late, early = (
            Binary("-", *(_along("position", e.name, at, axis) for e in bodies[::-sign]))
            for at in (event.number, since)
        )
        lengths: list[Expression] = [
            Quantity("distance", own, since) for own in (bodies, bodies[::-1])
        ]
        for length in (*lengths, early):
            left = length if together else Binary("-", length, late)
            yield Link(left, "=", quotient)


def _are_in_one_place(step: Step, bodies: tuple[Name, ...], number: int) -> bool:
    """Whether what is cited says that two bodies are at one place at an event, or at the start."""
    ends = [settled(Quantity("position", (b,), number), step.setting.events) for b in bodies]
    gap = step.rules().put_into(step.world.value(Binary("-", *ends)))
    return isinstance(gap, Plane) and gap.x.vanishes and gap.y.vanishes


def _along(kind: str, body: str, stage: int, axis: str) -> Quantity:
    """A coordinate, or a component of a velocity, along **i** or **j**."""
    return Quantity("along", (Quantity(kind, (Name(body),), stage), unit_vector(axis)))


def _stage_of(step: Step, body: Expression, stage: Any) -> Any:
    """The stage of a place: a point has none."""
    moves = isinstance(body, Name) and body.name in step.setting.spheres
    return stage if moves else None


def _place_of(place: Expression, event: Event | None) -> Expression:
    """A place; at a time after an event, or after the start, by the place and the velocity then."""
    match place:
        case Quantity("position", (body,), AtTime(time)):
            number = 0 if event is None else event.number
            since = Binary("-", time, Quantity("time", (), number))
            velocity = Quantity("velocity", (body,), number)
            start = Quantity("position", (body,), number)
            return Binary("+", start, Binary("*", velocity, since))
    return place


def chords(step: Step, event: Event | None) -> Iterator[Link]:
    """From one point of a circular wall to the next: equal angles with the radii, and the time.

    The radii are those to the two points, away from the centre. At the start a body may be on the
    circle too; from its centre it moves along a radius.
    """
    if event is None or not (event.wall or event.kind == "arrival"):
        return
    body, number = Name(event.bodies[0]), event.number
    own = [e.number for e in step.setting.events if body.name in e.bodies[:2]]
    since = max((other for other in own if other < number), default=0)
    velocity = Quantity("velocity", (body,), since)
    radial: Expression = Quantity("line_of_centres", (), since)
    chord = _chord_of(body, since, number)
    if any(link.left == chord for link in whole_links(step)):
        flight = Binary("-", Quantity("time", (), number), Quantity("time", (), since))
        for speed in (*_back_along(step, velocity, radial), *_speeds(velocity, radial)):
            yield Link(chord, "=", Binary("*", speed, flight))
    circle = _circle(step, body, number if event.wall else since)
    if circle is None:
        return
    if event.wall and not since and _is_at_the_centre(step, body, circle[0]):
        flight = Binary("-", Quantity("time", (), number), Quantity("time", (), since))
        for speed in (replace(velocity, kind="speed"), Apply("abs", velocity)):
            yield Link(Binary("*", flight, speed), "=", circle[1])
        return
    double = Binary("*", Number(Fraction(2)), circle[1])
    if event.wall:
        towards = Quantity("along", (velocity, axis_of(event)))
        for speed in _speeds(velocity, axis_of(event)):
            yield Link(Binary("*", chord, speed), "=", Binary("*", double, towards))
    if not event.wall:
        if _radius_to(step, body, number, *circle) is None:
            return
    elif since:
        if _circle(step, body, since) != circle:
            return
    else:
        place = _radius_to(step, body, 0, *circle)
        if place is None:
            return
        radial = place
    along, across = (Quantity(kind, (velocity, radial)) for kind in COMPONENTS)
    if event.wall:
        here = axis_of(event)
        yield Link(Quantity("along", (velocity, here)), "=", Negate(along))
        yield Link(Quantity("across", (velocity, here)), "=", across)
    for _ in _back_along(step, velocity, radial):
        yield Link(chord, "=", double)  # through the centre
    for speed in _speeds(velocity, radial):
        yield Link(Binary("*", chord, speed), "=", Binary("*", double, Negate(along)))
    if since:
        yield from _chord_as_before(step, body, (since, number), circle)


def _chord_as_before(
    step: Step, body: Name, ends: tuple[int, int], circle: tuple[Expression | None, Expression]
) -> Iterator[Link]:
    """The times of a chord and of the one before it: as 2r times a component over speed squared."""
    since, number = ends
    own = [e.number for e in step.setting.events if body.name in e.bodies[:2]]
    before = max((number for number in own if number < since), default=0)
    if before and _circle(step, body, before) != circle:
        return
    if not before and _radius_to(step, body, 0, *circle) is None:
        return
    sizes = []
    radial = Quantity("line_of_centres", (), since)
    for stage in (before, since):
        velocity = Quantity("velocity", (body,), stage)
        along, across = (Quantity(kind, (velocity, radial)) for kind in COMPONENTS)
        sizes.append((along, total_of([squared(along), squared(across)])))
    (towards, early), (away, late) = sizes
    first, second = (
        Binary("-", Quantity("time", (), b), Quantity("time", (), a))
        for a, b in ((before, since), (since, number))
    )
    left = Binary("*", Binary("*", second, late), towards)
    yield Link(left, "=", Binary("*", Binary("*", first, early), Negate(away)))


def _speeds(velocity: Quantity, radial: Expression) -> Iterator[Expression]:
    """A speed by the components along a radius and across it, as it is, and by the vector."""
    parts = [Quantity(kind, (velocity, radial)) for kind in COMPONENTS]
    yield Apply("sqrt", total_of([squared(part) for part in parts]))
    yield replace(velocity, kind="speed")
    yield Apply("abs", velocity)


def _back_along(step: Step, velocity: Quantity, radial: Expression) -> Iterator[Expression]:
    """The speed of who goes straight back from a circular wall: the component away from it."""
    across = Quantity("across", (velocity, radial))
    if any(
        link.left == across and link.sign == "=" and is_zero(link.right)
        for link in whole_links(step)
    ):
        yield Negate(Quantity("along", (velocity, radial)))


def _chord_of(body: Expression, since: int, number: int) -> Quantity:
    """How far apart the places are at which a body is at two events."""
    return Quantity("distance", tuple(Quantity("position", (body,), e) for e in (since, number)))


def rounds(step: Step, event: Event | None) -> Iterator[Link]:
    """The angles of three chords of one circle that close, with their radii: their sum is 90°.

    Each spans 180° less twice its angle at the centre; together they can only span 360°.
    """
    for name in step.move.bodies if event is not None else ():
        body = Name(name)
        assert event is not None
        own = [e.number for e in step.setting.events if name in e.bodies[:2]]
        own = [number for number in own if number <= event.number]
        if len(own) != 3 or own[-1] != event.number:
            continue
        first, second, last = own
        circle = _circle(step, body, first)
        if circle is None or _circle(step, body, second) != circle:
            continue
        start, end = (_cited_place(step, body, number) for number in (0, last))
        if start is None or end is None or _radius_to(step, body, 0, *circle) is None:
            continue
        gap = step.world.value(Binary("-", start, end))
        if not isinstance(gap, Plane) or not (gap.x.vanishes and gap.y.vanishes):
            continue
        a, b, c = (
            Quantity(
                "angle",
                (Quantity("velocity", (body,), stage), Quantity("line_of_centres", (), hit)),
            )
            for stage, hit in ((0, first), (first, first), (second, second))
        )
        yield Link(Binary("+", a, b), "=", Binary("-", RIGHT_ANGLE, c))


def _cited_place(step: Step, body: Name, number: int) -> Expression | None:
    """Where a body is at an event, or at the start, as is cited."""
    place = Quantity("position", (body,), number)
    places = (link.right for link in step.links if link.left == place and link.sign == "=")
    return next(places, None)


def moving_off(step: Step, event: Event | None) -> Iterator[Link]:
    """That who was at rest moves off along the line of centres, to its next event."""
    if event is None or event.kind != "impact" or event.wall:
        return
    axis, number = axis_of(event), event.number
    for name in set(step.move.bodies) & set(event.bodies):
        body = Name(name)
        before = settled(Quantity("velocity", (body,), number - 1), step.setting.events)
        velocity = step.rules().put_into(step.world.value(before))
        still = isinstance(velocity, Plane) and velocity.x.vanishes and velocity.y.vanishes
        later = [e.number for e in step.setting.events if e.number > number and name in e.bodies]
        if not still or not later:
            continue
        there, here = (Quantity("position", (body,), stage) for stage in (min(later), number))
        separation = (
            Binary("-", there, here) if name == event.bodies[1] else Binary("-", here, there)
        )
        yield Link(axis, "parallel to", separation)


def beside(step: Step, event: Event | None) -> Iterator[Link]:
    """Where the one centre is by the other: as far along the line of centres as they are apart."""
    if event is None or event.kind != "impact" or event.wall:
        return
    first, second = (Quantity("position", (Name(body),), event.number) for body in event.bodies)
    radii = [
        link.left
        for link in step.links
        if link.left == Quantity("dot", (Binary("-", second, first),) * 2)
    ]
    for link in step.links if radii else ():
        if link.left == axis_of(event) and link.sign == "parallel to":
            apart = next(e.right for e in step.links if e.left == radii[0])
            if not isinstance(apart, Binary):
                continue
            unit = Binary("/", link.right, Apply("abs", link.right))
            yield Link(Binary("-", second, first), "=", Binary("*", apart.left, unit))


def _circle(step: Step, body: Name, number: int) -> tuple[Expression | None, Expression] | None:
    """The centre and the radius of a circle on which a body is at an event, as is cited."""
    place = Quantity("position", (body,), number)
    for link in step.links:
        match link:
            case Link(
                Quantity("dot", (radius_vector, other)), "=", Binary("^", radius, Number())
            ) if radius_vector == other:
                if radius_vector == place:
                    return None, radius
                if is_binary(radius_vector, "-") and radius_vector.left == place:
                    return radius_vector.right, radius
    return None


def _is_at_the_centre(step: Step, body: Name, centre: Expression | None) -> bool:
    """Whether the place of a body at the start, which is cited, is the centre of a circle."""
    start = Quantity("position", (body,), 0)
    for link in step.links:
        if link.left == start and link.sign == "=":
            displacement = link.right if centre is None else Binary("-", link.right, centre)
            value = step.world.value(displacement)
            return isinstance(value, Plane) and value.x.vanishes and value.y.vanishes
    return False


def _radius_to(
    step: Step, body: Name, number: int, centre: Expression | None, radius: Expression
) -> Expression | None:
    """The radius to a place at an event, or at the start, that is cited, if it is on a circle."""
    start = Quantity("position", (body,), number)
    for link in step.links:
        if link.left == start and link.sign == "=":
            radius_vector = link.right if centre is None else Binary("-", link.right, centre)
            value = step.world.value(radius_vector)
            if isinstance(value, Plane):
                size = step.world.scalar(radius)
                square = step.world.reduced(value.x * value.x + value.y * value.y - size * size)
                return radius_vector if square.vanishes else None
    return None
