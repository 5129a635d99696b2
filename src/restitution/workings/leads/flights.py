"""What stands over lines about places and times: what each of them says."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.data.restated import axis_restated
from restitution.explaining.data.resting import body_that_rests, is_of_a_body_at_rest
from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Line,
    Link,
    Ref,
    Relation,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    Unit,
    is_binary,
    is_quantity,
    is_zero,
    walk,
)
from restitution.planning.writing.place_trees import is_duration
from restitution.workings.leads.particles import first_with_particles
from restitution.workings.leads.speeds_of_flights import speed_of_a_flight
from restitution.workings.naming.measured import vector_worth, worth
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.sources import is_displacement, is_time


def _at_once(naming: Naming, number: int) -> Sentence:
    """That two spheres collide at once: at the start, or in contact since they met."""
    bodies = naming.events[number].bodies
    met = any(
        event.number < number and set(event.bodies) == set(bodies)
        for event in naming.events.values()
    )
    return say("flight.still-in-contact" if met else "flight.at-once", bodies=bodies)


def flight_title(derivation: Derivation, naming: Naming, line: Line) -> Sentence:
    """The title of a line about the way of a body from one event to the next."""
    assert isinstance(line.relation, Relation)
    left = line.relation.options[0][0].left
    body = line.move.bodies[0]
    one = naming.movers == 1
    if is_time(left) and is_zero(line.relation.options[0][-1].right):
        return _at_once(naming, line.move.event or 0)
    if len(line.move.bodies) > 1:
        return say("flight.closing")
    if (several := _several_ways(derivation, naming, line, left)) is not None:
        return several
    if is_time(left) or (isinstance(left, Letter) and _names_a_time(derivation, left)):
        speed = speed_of_a_flight(derivation, naming, line)
        if (other := _stays_there(derivation, line)) is not None:
            if _rests_from_the_start(derivation, other, line.move.event):
                until = naming.called(naming.events[line.move.event or 0])
                name = "flight.time-to-rest-until"
                return say(name, body=body, other=other, event=until, speed=speed)
            return say("flight.time-to-rest", body=body, other=other, speed=speed)
        return (
            say("flight.time", speed=speed)
            if one
            else say("flight.time-of", body=body, speed=speed)
        )
    if is_quantity(left, "position"):
        if is_of_a_body_at_rest(derivation, line):
            if other := _touched(derivation, line):
                return say("flight.rest-beside", body=body, other=other)
            return say("flight.rest", body=body)
        if _from_the_origin(derivation, line):
            if derivation.fact("origin") is not None:
                return say("flight.origin-taken", body=body)
            if event := _left_at(derivation, line, left):
                return say("flight.origin-since", body=body, event=naming.moment(event.number))
            return say("flight.origin") if one else say("flight.origin-of", body=body)
    if (axis := _level_of(derivation, line, left)) is not None:
        return say("flight.level", body=body, axis=axis)
    if _is_place(left) and not _by_the_way(derivation, line):
        assert isinstance(left, Quantity)
        axis, event = _axis_from_zero(derivation, line, left), _left_at(derivation, line, left)
        if axis and event is not None:
            moment = naming.moment(event.number)
            return say("flight.from-zero", body=body, axis=axis, event=moment)
        return say("flight.place") if one else say("flight.place-of", body=body)
    if is_displacement(left):
        return say("flight.displacement") if one else say("flight.displacement-of", body=body)
    if _tells_a_time(derivation, line):
        return say("flight.title") if one else say("flight.title-of", body=body)
    return say("flight.same-time")


def _stays_there(derivation: Derivation, line: Line) -> str | None:
    """The body at rest that another one comes to, where no line is printed of its place."""
    struck = _bodies_at(derivation, line.move.event)
    for own in derivation.lines_in(line.premises):
        match own.relation:
            case Relation(((Link(Quantity("position", (Name(other),)), "=", place), *_),)) if (
                other in struck
                and other not in line.move.bodies
                and is_of_a_body_at_rest(derivation, own)
            ):
                if own.shown == "silent" or (is_zero(place) and own.number not in derivation.held):
                    return other
    return None


def _bodies_at(derivation: Derivation, number: int | None) -> tuple[str, ...]:
    """The bodies of an event."""
    return next((event.bodies for event in derivation.events if event.number == number), ())


def _rests_from_the_start(derivation: Derivation, body: str, number: int | None) -> bool:
    """Whether nothing strikes a body before an event."""
    return not any(
        body in event.bodies for event in derivation.events if event.number < (number or 0)
    )


def _level_of(derivation: Derivation, line: Line, left: Expression) -> str | None:
    """The axis, x or y, to which a body moves parallel: its other coordinate is as it was given."""
    match left:
        case Quantity("along", (Quantity("position", (Name(body),)), Unit(axis))):
            fact = derivation.fact(f"position {body}")
        case _:
            return None
    assert isinstance(line.relation, Relation)
    place = None if fact is None else vector_worth(fact.relation.only[0].right)
    if place is None or _speaks_of_a_time(derivation, line):
        return None
    own = place.x if axis == "i" else place.y
    stays = worth(line.relation.only[0].right) == own
    return ("y" if axis == "i" else "x") if stays else None


def _left_at(derivation: Derivation, line: Line, place: Quantity) -> Event | None:
    """The event at which the time begins that a place is counted by; None of the start.

    It is told by the one difference of two times on which the line rests, or that stands in it.
    """
    if place.kind != "position":
        (place, *_) = (argument for argument in place.arguments if isinstance(argument, Quantity))
    events = {event.number: event for event in derivation.events}
    own = None
    if not isinstance(place.stage, int):
        own = events.get(line.move.event or 0)
    else:
        times = set(_times_of(derivation, line))
        if len(times) == 1:
            ((late, early),) = times
            own = events.get(early) if late == place.stage else None
    return None if own is None or own.kind != "impact" else own


def _times_of(derivation: Derivation, line: Line) -> Iterator[tuple[int, int]]:
    """Between which events the times are on which a line rests, or that it has."""
    relations = [own.relation for own in derivation.lines_in(line.premises)]
    trees = [relation.only[0].left for relation in relations if isinstance(relation, Relation)]
    if isinstance(line.relation, Relation):
        trees += [node for tree in trees_of(line.relation) for node in walk(tree)]
    for tree in trees:
        match tree:
            case Binary("-", Quantity("time", (), int(late)), Quantity("time", (), int(early))):
                yield late, early
            case Quantity("time", (), int(late)):
                yield late, 0


def _axis_from_zero(derivation: Derivation, line: Line, left: Expression) -> str | None:
    """The axis along which a body comes from 0, where a coordinate is a velocity times a time."""
    match left:
        case Quantity("along", (Quantity("position"), Unit("i" | "j" as axis))):
            if _from_the_origin(derivation, line):
                return "x" if axis == "i" else "y"
    return None


def _touched(derivation: Derivation, line: Line) -> str | None:
    """The body beside which another one rests, where its place is by that of the other."""
    assert isinstance(line.relation, Relation)
    if len(line.relation.only) < 2:
        return None  # where it is stands in a line
    for ref in line.premises:
        kind, _, number = str(ref).partition(" ")
        if kind == "contact":
            event = next(e for e in derivation.events if str(e.number) == number)
            return next((body for body in event.bodies if body != line.move.bodies[0]), None)
    return None


def _several_ways(
    derivation: Derivation, naming: Naming, line: Line, left: Expression
) -> Sentence | None:
    """What stands over a time of several ways at one component; None over another one."""
    match left:
        case Quantity("time", (), int(late)) if "start" in line.premises:
            early = 0
        case Binary("-", Quantity("time", (), int(late)), Quantity("time", (), int(early))):
            pass
        case _:
            return None
    body = line.move.bodies[0]
    own = [impact for impact in naming.impacts if body in impact.bodies]
    between = [impact for impact in own if early < impact.number < late]
    if not between:
        return None
    speed = speed_of_a_flight(derivation, naming, line)
    # The impact at its end may well change it.
    ends_in_impact = any(impact.number == late for impact in own)
    if not early and ends_in_impact and len(between) == 1:
        (other,) = (name for name in between[0].bodies if name != body)
        return say("flight.past-one", speed=speed, other=other)
    if early or ends_in_impact or late < derivation.events[-1].number:
        return say("flight.several-ways", speed=speed)
    return say("flight.whole-way", speed=speed)


def chord_title(derivation: Derivation, line: Line, wall: str) -> Sentence:
    """The title of a line about a chord of a circular wall.

    Inside it, a component along the wall is counted to the left of the radius.
    """
    assert isinstance(line.relation, Relation)
    left, right = line.relation.options[0][0].left, line.relation.options[0][0].right
    if is_time(left):
        if any(str(ref).split()[0] == "position" for ref in line.premises) and not is_time(right):
            return say("chord.from-centre", body=line.move.bodies[0], wall=wall)
        return say("chord.as-before") if is_time(right) else say("chord.time")
    if is_quantity(left, "distance"):
        return _length_title(derivation, line, wall)
    if _is_on_a_diameter(derivation, line):
        return say("chord.through", body=line.move.bodies[0])
    before = [e for e in derivation.lines if e.number < line.number and _is_of_a_chord(e)]
    if before and (before[-1].number, before[-1].move.event) == (line.number - 1, line.move.event):
        return chord_title(derivation, before[-1], wall)
    if before and line.shown == "line":
        if before[-1].move.event != line.move.event:
            return say("chord.again")
        if not is_quantity(left, "across"):
            return say("chord.along-radius")
        sensed = _has_sense(line) and not any(map(_has_sense, before))
        return say("chord.along-tangent-sense" if sensed else "chord.along-tangent")
    below = derivation.line(line.number + 1)
    sensed = _has_sense(line) or (below is not None and _has_sense(below))
    return say("chord.title-sense", wall=wall) if sensed else say("chord.title")


def _has_sense(line: Line) -> bool:
    """Whether a line about a chord has a component along the wall, which is not zero."""
    return (
        line.move.record == "chord"
        and isinstance(line.relation, Relation)
        and is_quantity(line.relation.only[0].left, "across")
        and not is_zero(line.relation.only[-1].right)
    )


def _is_of_a_chord(line: Line) -> bool:
    """Whether a line gives a component of the velocity along a chord."""
    match line.relation:
        case Relation(((Link(Quantity("along" | "across")), *_), *_)):
            return line.move.record == "chord" and line.shown == "line"
    return False


def _length_title(derivation: Derivation, line: Line, wall: str) -> Sentence:
    """The title of the length of a chord: of a diameter, or by its angle with the radius."""
    if not _is_diameter(line):
        return say("chord.length")
    earlier = (other for other in derivation.lines if other.number < line.number)
    if any(_is_diameter(other) and other.move.bodies == line.move.bodies for other in earlier):
        return say("chord.through", body=line.move.bodies[0])
    return say("chord.diameter", body=line.move.bodies[0], wall=wall)


def _is_diameter(line: Line) -> bool:
    """Whether a line gives the length of a chord as twice the radius."""
    if line.move.record != "chord" or not isinstance(line.relation, Relation):
        return False
    match line.relation.options[0][0]:
        case Link(Quantity("distance"), _, Binary("*", Number(), right)):
            return not isinstance(right, Binary)
    return False


def _is_on_a_diameter(derivation: Derivation, line: Line) -> bool:
    """Whether a line above gives the length of the chord of a line, which is a diameter."""
    return any(
        _is_diameter(other) and (other.move.event, other.move.bodies) == (event, line.move.bodies)
        for event in (line.move.event,)
        for other in derivation.lines
        if other.number < line.number
    )


def distance_title(derivation: Derivation, naming: Naming, line: Line) -> Sentence:
    """The title of a distance: of the way of a body, of bodies that met, or by coordinates."""
    level = _apart_along_the_line(derivation, line)
    if level is not None:
        return level
    axis = axis_restated(derivation, line)
    if axis is not None:
        return say("distance.along-one", axis="x" if axis.axis == "i" else "y")
    resting = body_that_rests(derivation, line)
    if resting is not None:
        return say("flight.rest", body=resting)
    match line.relation:
        case Relation(((Link(Quantity("distance", _, int(event)), "=", right),),)) if is_zero(
            right
        ) and line.premises == (f"contact {event}",):
            bodies = naming.events[event].bodies
            return say("distance.none", bodies=bodies, event=naming.moment(event))
        case Relation(((Link(Quantity("distance", ends), "=", Binary("*")), *_),)) if (
            not line.move.event and not _is_a_coordinate(derivation, line)
        ):
            places = [end for end in ends if isinstance(end, Quantity)]
            if not places:
                return say("distance.coordinates")
            first = min(
                places, key=lambda place: place.stage if isinstance(place.stage, int) else 0
            )
            match first.arguments:
                case (Name(body),):
                    return say("flight.title-of", body=body)
    if any(_tells_a_displacement(derivation, ref) for ref in line.premises):
        return say("distance.displacements")
    if not line.move.event:
        return say("distance.coordinates")
    met = naming.events[line.move.event]
    if first_with_particles(derivation) is None:
        return say("distance.relative", event=naming.called(met))
    return say("distance.together", bodies=met.bodies, event=naming.moment(met.number))


def _is_a_coordinate(derivation: Derivation, line: Line) -> bool:
    """Whether a distance is a coordinate that a line gives: no time is among its premises."""
    premises = derivation.lines_in(line.premises)
    subjects = [
        ref.relation.options[0][0].left for ref in premises if isinstance(ref.relation, Relation)
    ]
    places = [subject for subject in subjects if is_quantity(subject, "along")]
    return any(is_quantity(e.arguments[0], "position") for e in places) and not any(
        is_time(subject) or is_duration(subject) for subject in subjects
    )


def _tells_a_displacement(derivation: Derivation, ref: Ref) -> bool:
    """Whether a premise is the line of how far a body comes in one direction."""
    own = derivation.line(ref)
    match None if own is None else own.relation:
        case Relation(options=((Link(left), *_), *_)):
            return is_displacement(left)
    return False


def _apart_along_the_line(derivation: Derivation, line: Line) -> Sentence | None:
    """That two bodies that met are as far apart as they are along the line of centres.

    None where they do not move across it, or not with the same component.
    """
    event = next((event for event in derivation.events if event.number == line.move.event), None)
    cited = derivation.lines_in(line.premises)
    values = [
        line.relation.only[-1].right
        for line in cited
        if isinstance(line.relation, Relation) and line.move.record == "unchanged"
    ]
    if event is None or len(values) != 2 or values[0] != values[1] or is_zero(values[0]):
        return None
    one, other = event.bodies
    if first_with_particles(derivation) is None:
        return say("distance.level", one=one, other=other)
    return say("distance.level-together", one=one, other=other)


def _from_the_origin(derivation: Derivation, line: Line) -> bool:
    """Whether a place is a velocity times a time, and nothing more."""
    assert isinstance(line.relation, Relation)
    right = line.relation.options[0][0].right
    return _speaks_of_a_time(derivation, line) and not is_binary(right, "+", "-")


def _names_a_time(derivation: Derivation, letter: Letter) -> bool:
    """Whether the statement lets a letter stand for a time."""
    fact = derivation.fact(f"let {letter.name}")
    return fact is not None and is_time(fact.relation.only[0].left)


def _is_place(tree: Expression) -> bool:
    match tree:
        case Quantity("position"):
            return True
        case Quantity("along" | "across", (Quantity("position"), _)):
            return True
    return False


def _speaks_of_a_time(derivation: Derivation, line: Line) -> bool:
    """Whether a time is in a line, or is put into it."""
    assert isinstance(line.relation, Relation)
    nodes = [node for tree in trees_of(line.relation) for node in walk(tree)]
    return any(map(is_time, nodes)) or _tells_a_time(derivation, line)


def _by_the_way(derivation: Derivation, line: Line) -> bool:
    """Whether a line tells a place without the time: by the components of the velocity."""
    moved = any(
        isinstance(premise, int) or premise.startswith("velocity") for premise in line.premises
    )
    assert isinstance(line.relation, Relation)
    match line.relation.options[0][0].left:
        case Quantity("along" | "across"):
            pass
        case _:
            return False
    # Of equal components the quotient is not printed.
    right = line.relation.options[0][0].right
    quotient = any(is_binary(node, "/") for node in walk(right))
    quotient |= is_binary(right, "+", "-")
    return moved and quotient and not _speaks_of_a_time(derivation, line)


def _tells_a_time(derivation: Derivation, line: Line) -> bool:
    """Whether a line rests on a time."""
    for ref in line.premises:
        if ref == "start":
            return True
        own = derivation.cited(ref)
        match None if own is None else own.relation:
            case Relation(options=((Link(left=left), *_), *_)) if is_time(left):
                return True
    return False
