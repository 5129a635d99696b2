"""Definitions worked out for an event and its bodies: energies, ties, places."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

from restitution.explaining.data.offset_angles import named_angles
from restitution.explaining.definitions.turnings import turnings
from restitution.explaining.definitions.wall_angles import by_angles, to_walls
from restitution.explaining.lines.derivation import FLIPPED, Event, Link, Relation, Sign, whole_of
from restitution.explaining.lines.quotients import Plane, Quotient
from restitution.explaining.lines.trees import settled
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
    walk,
)

ZERO = Number(Fraction(0))


_HALF = Binary("/", Number(Fraction(1)), Number(Fraction(2)))


RIGHT_ANGLE = Degrees(Fraction(90))
_TIES: Mapping[Expression, Sign] = {
    RIGHT_ANGLE: "perpendicular to",
    Degrees(Fraction(0)): "parallel to",
    Degrees(Fraction(180)): "parallel to",
}
"""How directions stand to each other that make an angle of so much."""


def places(step: Step, event: Event | None, line: Link) -> Iterator[Link]:
    """Of a place at a time, and of a distance, what each is: times and bodies are the line's."""
    if step.move.record == "straight-line" and event is not None:
        yield from _journeys(step, event)
        yield from _several_ways(step, event)
    for tree in (*walk(line.left), *walk(line.right)):
        match tree:
            case Quantity("position", _, AtTime()):
                yield Link(tree, "=", _place_of(tree, event))
            case Quantity("distance", (a, b), stage):
                there = [
                    Quantity("position", (each,), _stage_of(step, each, stage))
                    if isinstance(each, Name)
                    else each
                    for each in (a, b)
                ]
                places = [_place_of(each, event) for each in there]
                yield Link(tree, "=", Apply("abs", Binary("-", places[0], places[1])))
                if places != there:
                    yield Link(tree, "=", Apply("abs", Binary("-", there[0], there[1])))


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
    last, first = (Quantity("position", (name,), each) for each in (event.number, since))
    late, early = (Quantity("time", (), each) for each in (event.number, since))
    velocity = Quantity("velocity", (name,), since)
    flight = Binary("-", late, early)
    yield Link(Binary("-", last, first), "=", Binary("*", velocity, flight))
    lengths, paces = [], []
    for axis in "ij":
        a, b, pace = (Quantity("along", (e, _unit(axis))) for e in (last, first, velocity))
        lengths.append(Binary("-", a, b))
        paces.append(pace)
        yield Link(lengths[-1], "=", Binary("*", pace, flight))
    yield Link(Binary("*", lengths[1], paces[0]), "=", Binary("*", lengths[0], paces[1]))


def _several_ways(step: Step, event: Event) -> Iterator[Link]:
    """How far a body comes from an earlier event over several ways, in one direction."""
    for body in step.move.bodies:
        own = [e.number for e in step.setting.events if body in e.bodies[:2]]
        stages = [0, *(each for each in own if each < event.number), event.number]
        for first, axis in product(range(len(stages) - 2), "ij"):
            lengths: list[Expression] = []
            for early, late in pairwise(stages[first:]):
                flight = Binary("-", Quantity("time", (), late), Quantity("time", (), early))
                lengths.append(Binary("*", _along("velocity", body, early, axis), flight))
            ends = (_along("position", body, each, axis) for each in (stages[-1], stages[first]))
            yield Link(Binary("-", *ends), "=", _sum(lengths))


def _along(kind: str, body: str, stage: int, axis: str) -> Quantity:
    """A coordinate, or a component of a velocity, along **i** or **j**."""
    return Quantity("along", (Quantity(kind, (Name(body),), stage), _unit(axis)))


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


def _chords(step: Step, event: Event | None) -> Iterator[Link]:
    """From one point of a circular wall to the next: equal angles with the radii, and the time.

    The radii are those to the two points, away from the centre. At the start a body may be on the
    circle too.
    """
    if event is None or not (event.wall or event.kind == "arrival"):
        return
    body, number = Name(event.bodies[0]), event.number
    own = [e.number for e in step.setting.events if body.name in e.bodies[:2]]
    since = max((each for each in own if each < number), default=0)
    velocity = Quantity("velocity", (body,), since)
    radial: Expression = Quantity("line_of_centres", (), since)
    chord = _chord_of(body, since, number)
    if any(link.left == chord for link in _wholes(step)):
        flight = Binary("-", Quantity("time", (), number), Quantity("time", (), since))
        for speed in _speeds(velocity, radial):
            yield Link(Binary("*", flight, speed), "=", chord)
    circle = _circle(step, body, number if event.wall else since)
    if circle is None:
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
    along, across = (Quantity(kind, (velocity, radial)) for kind in ("along", "across"))
    if event.wall:
        here = axis_of(event)
        yield Link(Quantity("along", (velocity, here)), "=", Negate(along))
        yield Link(Quantity("across", (velocity, here)), "=", across)
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
    before = max((each for each in own if each < since), default=0)
    if before and _circle(step, body, before) != circle:
        return
    if not before and _radius_to(step, body, 0, *circle) is None:
        return
    sizes = []
    radial = Quantity("line_of_centres", (), since)
    for stage in (before, since):
        velocity = Quantity("velocity", (body,), stage)
        along, across = (Quantity(kind, (velocity, radial)) for kind in ("along", "across"))
        sizes.append((along, _sum([_squared(along), _squared(across)])))
    (towards, early), (away, late) = sizes
    first, second = (
        Binary("-", Quantity("time", (), b), Quantity("time", (), a))
        for a, b in ((before, since), (since, number))
    )
    left = Binary("*", Binary("*", second, late), towards)
    yield Link(left, "=", Binary("*", Binary("*", first, early), Negate(away)))


def _speeds(velocity: Quantity, radial: Expression) -> Iterator[Expression]:
    """A speed by the components along a radius and across it, as it is, and by the vector."""
    parts = [Quantity(kind, (velocity, radial)) for kind in ("along", "across")]
    yield Apply("sqrt", _sum([_squared(part) for part in parts]))
    yield replace(velocity, kind="speed")
    yield Apply("abs", velocity)


def _chord_of(body: Expression, since: int, number: int) -> Quantity:
    """How far apart the places are at which a body is at two events."""
    return Quantity("distance", tuple(Quantity("position", (body,), e) for e in (since, number)))


def _rounds(step: Step, event: Event | None) -> Iterator[Link]:
    """Of three chords of one circle that close, that their angles with the radii make 90°.

    Each spans 180° less twice its angle at the centre; together they can only span 360°.
    """
    for name in step.move.bodies if event is not None else ():
        body = Name(name)
        assert event is not None
        own = [e.number for e in step.setting.events if name in e.bodies[:2]]
        own = [each for each in own if each <= event.number]
        if len(own) != 3 or own[-1] != event.number:
            continue
        first, second, last = own
        circle = _circle(step, body, first)
        if circle is None or _circle(step, body, second) != circle:
            continue
        start, end = (_cited_place(step, body, each) for each in (0, last))
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


def _moving_off(step: Step, event: Event | None) -> Iterator[Link]:
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
        there, here = (Quantity("position", (body,), each) for each in (min(later), number))
        separation = (
            Binary("-", there, here) if name == event.bodies[1] else Binary("-", here, there)
        )
        yield Link(axis, "parallel to", separation)


def _beside(step: Step, event: Event | None) -> Iterator[Link]:
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
                if (
                    isinstance(radius_vector, Binary)
                    and radius_vector.op == "-"
                    and radius_vector.left == place
                ):
                    return radius_vector.right, radius
    return None


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


def nothing(step: Step, event: Event | None) -> Iterable[Link]:
    """Of the other records there is nothing to work out."""
    return ()


def axis_of(event: Event) -> Expression:
    """The line of centres of an event."""
    return Quantity("line_of_centres", (), event.number)


def _component(kind: str, body: str, stage: int, event: Event) -> Expression:
    return Quantity(kind, (Quantity("velocity", (Name(body),), stage), axis_of(event)))


def _sum(terms: Sequence[Expression]) -> Expression:
    total = terms[0]
    for term in terms[1:]:
        total = Binary("+", total, term)
    return total


def _squared(tree: Expression) -> Expression:
    return Binary("^", tree, Number(Fraction(2)))


def _squares(form: str, body: str, stage: int, event: Event | None) -> Expression:
    """The square of a speed: by components of an event, by the vector, or as it is."""
    velocity = Quantity("velocity", (Name(body),), stage)
    if form == "components" and event is not None and body in event.bodies:
        parts = (_component(kind, body, stage, event) for kind in ("along", "across"))
        return _sum([_squared(part) for part in parts])
    if form == "along" and event is not None:
        return _squared(_component("along", body, stage, event))
    if form == "speed":
        return _squared(Quantity("speed", (Name(body),), stage))
    return Quantity("dot", (velocity, velocity))


def _kinetic(
    step: Step,
    form: str,
    body: str,
    stage: int,
    event: Event | None,
    cited: frozenset[Expression] = frozenset(),
) -> Expression:
    """The energy of a sphere: as it is where it is cited, else by the square of the speed."""
    own = Quantity("energy", (Name(body),), stage)
    if form == "energy" or step.setting.quantity(own) in cited:
        return own
    mass = Quantity("mass", (Name(body),))
    return Binary("*", Binary("*", _HALF, mass), _squares(form, body, stage, event))


def _cited_energies(step: Step) -> frozenset[Expression]:
    """The energies of spheres of which the values are cited."""
    return frozenset(
        step.setting.quantity(link.left)
        for link in _wholes(step)
        if isinstance(link.left, Quantity) and link.left.kind == "energy" and link.sign == "="
    )


def _total(step: Step, event: Event | None) -> Iterator[Link]:
    """The energy of all spheres before an event and after it."""
    number = 0 if event is None else event.number
    cited = _cited_energies(step)
    for stage in {number, max(0, number - 1)}:
        for form in ("components", "vectors", "speed", "energy"):
            terms = [
                _kinetic(step, form, body, stage, event, cited) for body in step.setting.spheres
            ]
            if terms:
                yield Link(Quantity("energy", (), stage), "=", _sum(terms))
    if event is not None and event.kind == "impact":
        before = Quantity("energy", (), number - 1)
        lost = Quantity("energy_lost", (), number)
        yield Link(Quantity("energy", (), number), "=", Binary("-", before, lost))
    yield from _of_told_speeds(step)


def _of_told_speeds(step: Step) -> Iterator[Link]:
    """The energy at the start, where only some velocities are told by their size and an angle."""
    sized = {
        link.left.arguments[0]
        for link in step.links
        if isinstance(link.left, Quantity)
        and link.left.kind == "velocity"
        and isinstance(link.right, Polar)
    }
    terms = [
        _kinetic(step, "speed" if Name(body) in sized else "vectors", body, 0, None)
        for body in step.setting.spheres
    ]
    if 0 < len(sized) < len(terms):
        yield Link(Quantity("energy", (), 0), "=", _sum(terms))


def _momentum_of_all(step: Step, event: Event | None) -> Iterator[Link]:
    """The momentum of all spheres before an event and after it; of one its parts and its change."""
    yield from _momentum_in_directions(step, event)
    number = 0 if event is None else event.number
    for body in step.move.bodies if number and len(step.move.bodies) == 1 else ():
        late, early = (
            [Quantity(kind, (Name(body),), stage) for stage in (number, number - 1)]
            for kind in ("momentum", "velocity")
        )
        mass = Quantity("mass", (Name(body),))
        yield Link(Binary("-", *late), "=", Binary("*", mass, Binary("-", *early)))
    for stage in {number, max(0, number - 1)}:
        terms: list[Expression] = [
            Binary("*", Quantity("mass", (Name(body),)), Quantity("velocity", (Name(body),), stage))
            for body in step.setting.spheres
        ]
        if terms:
            yield Link(Quantity("momentum", (), stage), "=", _sum(terms))


def _momentum_in_directions(step: Step, event: Event | None) -> Iterator[Link]:
    """The components of the momentum of a sphere, of those of its velocity."""
    number = 0 if event is None else event.number
    axes: list[Expression] = [Unit("i"), Unit("j"), Quantity("line_of_centres", (), number)]
    for body in step.move.bodies if len(step.move.bodies) == 1 else ():
        for stage in {number, max(0, number - 1)}:
            mass = Quantity("mass", (Name(body),))
            whole, velocity = (
                Quantity(each, (Name(body),), stage) for each in ("momentum", "velocity")
            )
            for axis in axes:
                for kind in ("along", "across"):
                    component = Quantity(kind, (velocity, axis))
                    yield Link(Quantity(kind, (whole, axis)), "=", Binary("*", mass, component))


def _momentum_kept(step: Step, event: Event | None) -> Iterator[Link]:
    """That the momentum of all spheres is the same before and after two of them meet."""
    if event is None or event.kind != "impact" or event.wall:
        return
    terms = [
        Binary(
            "*", Quantity("mass", (Name(b),)), Quantity("velocity", (Name(b),), event.number - 1)
        )
        for b in step.setting.spheres
    ]
    yield Link(_sum(terms), "=", Quantity("momentum", (), event.number))


def _total_lost(step: Step, event: Event | None) -> Iterator[Link]:
    """The energy that all spheres lose from the beginning to the end of an event."""
    if event is None:
        return
    cited = _cited_energies(step)
    for form in ("components", "vectors", "speed", "energy"):
        terms = [
            Binary(
                "-",
                _kinetic(step, form, body, 0, None, cited),
                _kinetic(step, form, body, event.number, event, cited),
            )
            for body in step.setting.spheres
        ]
        yield Link(Quantity("total_energy_lost", (), event.number), "=", _sum(terms))
    before, after = (Quantity("energy", (), stage) for stage in (0, event.number))
    lost = Binary("-", before, after)
    yield Link(Quantity("total_energy_lost", (), event.number), "=", lost)
    earlier = [each for each in step.setting.events if each.number <= event.number]
    if all(each.kind == "impact" for each in earlier):
        losses = [Quantity("energy_lost", (), each.number) for each in earlier]
        yield Link(Quantity("total_energy_lost", (), event.number), "=", _sum(losses))
    if event.number == 1 and event.kind == "impact":
        # Nothing else has happened: it is what the impact takes.
        for link in _energy_lost(step, event):
            if link.left == Quantity("energy_lost", (), 1):
                yield replace(link, left=Quantity("total_energy_lost", (), 1))


def _energy_lost(step: Step, event: Event | None) -> Iterator[Link]:
    """The energy that the bodies of an event lose: whole, or by components along the line."""
    if event is None:
        return
    spheres = [each for each in event.bodies if each in step.setting.spheres]
    cited = _cited_energies(step)
    for form in ("components", "along", "vectors", "speed", "energy"):
        terms = [
            Binary(
                "-",
                _kinetic(step, form, body, event.number - 1, event, cited),
                _kinetic(step, form, body, event.number, event, cited),
            )
            for body in spheres
        ]
        lost = _sum(terms)
        yield Link(Quantity("energy_lost", (), event.number), "=", lost)
        stages = (event.number - 1, event.number)
        before, after = (Quantity("energy", (), stage) for stage in stages)
        yield Link(Binary("-", before, after), "=", lost)
    yield Link(Quantity("energy_lost", (), event.number), "=", Binary("-", before, after))
    changes = _changes_cited(step, event, spheres)
    if changes:
        yield Link(Quantity("energy_lost", (), event.number), "=", _sum(changes))


def _changes_cited(step: Step, event: Event, spheres: Sequence[str]) -> list[Expression]:
    """What each sphere loses at an event by a change of its energy that is cited; else nothing."""
    wholes = {link.left: link.right for link in _wholes(step) if link.sign == "="}
    changes: list[Expression] = []
    for body in spheres:
        early, late = (
            step.setting.quantity(Quantity("energy", (Name(body),), number))
            for number in (event.number - 1, event.number)
        )
        if (lost := wholes.get(Binary("-", early, late))) is not None:
            changes.append(lost)
        elif (gained := wholes.get(Binary("-", late, early))) is not None:
            changes.append(Negate(gained))
        else:
            return []
    return changes


def _tied(step: Step, event: Event | None) -> Iterator[Link]:
    """What a cited right angle, or a cited common direction, says of components."""
    relation = "perpendicular to" if step.move.record == "perpendicular" else "parallel to"
    for link in (*step.links, *_named_angles(step)):
        tie = tie_of(link)
        if tie is not None and tie[2] == relation:
            yield from ties(step, event, *tie)
            if relation == "perpendicular to" and event is not None and not event.wall:
                yield from _across_who_moves_along(step, event, *tie[:2])
        past = past_a_right_angle(link)
        if past is not None and step.move.record == "perpendicular":
            for each in ties(step, event, *past[:2], relation):
                yield replace(each, sign=past[2])


def _across_who_moves_along(
    step: Step, event: Event, left: Expression, right: Expression
) -> Iterator[Link]:
    """At right angles to who moves along the line of centres, a sphere has no component along it.

    There is a right angle only between spheres that both move.
    """
    axis = axis_of(event)
    for one, other in ((left, right), (right, left)):
        match one, other:
            case (
                Quantity("velocity", (Name(body),), event.number),
                Quantity("velocity", (Name(last),), event.number),
            ) if {body, last} == set(event.bodies):
                across = step.setting.quantity(Quantity("across", (one, axis)))
                value = step.rules().put_into(step.world.value(across))
                if isinstance(value, Quotient) and value.vanishes:
                    yield Link(Quantity("along", (other, axis)), "=", ZERO)


def _named_angles(step: Step) -> Iterator[Link]:
    """What is cited of letters for angles, said of the angles."""
    named = {Letter(let.letter): let.quantity for let in step.lets}
    named |= {
        each.right: each.left
        for each in step.links
        if each.sign == "=" and isinstance(each.right, Letter) and isinstance(each.left, Quantity)
    }
    for link in _wholes(step):
        if link.left in named:
            yield Link(named[link.left], link.sign, link.right)


def tie_of(link: Link) -> tuple[Expression, Expression, str] | None:
    """The two directions of which a relation says how they stand to each other."""
    if link.sign in ("perpendicular to", "parallel to"):
        return _moving(link.left), _moving(link.right), link.sign
    match link:
        case Link(Quantity("direction", (Name() as body,), int(stage)), "=", angle):
            unit = Polar(Number(Fraction(1)), angle)
            return Quantity("velocity", (body,), stage), unit, "parallel to"
    if link.sign != "=" or link.right not in _TIES:
        return None
    match link.left:
        case Quantity("angle", (left, right)):
            return left, right, _TIES[link.right]
        case Quantity("deflection", (turned,), int(stage)):
            before, after = (Quantity("velocity", (turned,), each) for each in (stage - 1, stage))
            return before, after, _TIES[link.right]
    return None


def _moving(tree: Expression) -> Expression:
    """The velocity of a body for its momentum, which has the same direction."""
    match tree:
        case Quantity("momentum", (Name(),)):
            return replace(tree, kind="velocity")
    return tree


def past_a_right_angle(link: Link) -> tuple[Expression, Expression, Sign] | None:
    """Of an angle that is more than 90°, or less: its directions, and the sign of their product."""
    turned = FLIPPED.get(link.sign)
    tie = None if turned is None else tie_of(replace(link, sign="="))
    if turned is None or tie is None or tie[2] != "perpendicular to":
        return None
    return tie[0], tie[1], turned


def ties(
    step: Step, event: Event | None, left: Expression, right: Expression, relation: str
) -> Iterator[Link]:
    """What it says of components that two directions are perpendicular, or parallel."""
    kinds = ("along", "across")
    for a, b in ((left, right), (right, left)):
        for axis in () if event is None else (axis_of(event),):
            wall = len(event.bodies) > 1 and b == Name(event.bodies[1]) if event else False
            if b == axis or wall:
                square = (relation == "perpendicular to") != wall
                yield Link(Quantity(kinds[0] if square else kinds[1], (a, axis)), "=", ZERO)
    for axes in (axis_of(event),) if event is not None else ():
        (a, b), (c, d) = ([Quantity(k, (each, axes)) for k in kinds] for each in (left, right))
        if relation == "perpendicular to":
            yield Link(Binary("+", Binary("*", a, c), Binary("*", b, d)), "=", ZERO)
        else:
            yield Link(Binary("-", Binary("*", a, d), Binary("*", b, c)), "=", ZERO)
    if relation == "perpendicular to":
        yield Link(Quantity("dot", (left, right)), "=", ZERO)
    else:
        yield Link(_cross(left, right), "=", ZERO)


def is_no_product(step: Step, left: Expression, right: Expression) -> bool:
    """Whether a line is cited by which the scalar product of two directions is zero."""
    products = [
        settled(Quantity("dot", e), step.setting.events) for e in ((left, right), (right, left))
    ]
    return any(
        link.left in products and link.sign == "=" and link.right == ZERO for link in _wholes(step)
    )


def _cross(left: Expression, right: Expression) -> Expression:
    x, y = (tuple(Quantity("dot", (each, _unit(axis))) for axis in "ij") for each in (left, right))
    return Binary("-", Binary("*", x[0], y[1]), Binary("*", x[1], y[0]))


def _unit(axis: str) -> Expression:
    return Unit(axis)  # type: ignore[arg-type]


def _between_directions(step: Step, event: Event | None) -> Iterator[Link]:
    """The angles between velocities, at any two times, or lines, for which letters are cited.

    Of a line of centres by an offset, the sine of the angle with the path.
    """
    for meaning, own in named_angles(step.lets, step.links, step.setting):
        yield Link(Apply("sin", meaning.quantity), "=", own.sine)
    for angle in (
        *(meaning.quantity for meaning in step.lets),
        *(side for link in step.links for side in (link.left, link.right)),
    ):
        match angle:
            case Quantity("angle", (a, b)):
                p, q = (_pointing(step, each) for each in (a, b))
                sizes = Binary("*", Apply("abs", p), Apply("abs", q))
                cosine = Binary("/", Quantity("dot", (p, q)), sizes)
                yield Link(Apply("cos", angle), "=", cosine)
                yield from _by_product_and_speeds(step, angle, a, b)
            case Quantity("deflection", (Name() as body,), int(stage)):
                early, late = (
                    settled(Quantity("velocity", (body,), each), step.setting.events)
                    for each in (stage - 1, stage)
                )
                yield from _by_product_and_speeds(step, angle, early, late)


def _by_product_and_speeds(
    step: Step, angle: Expression, one: Expression, other: Expression
) -> Iterator[Link]:
    """The cosine of an angle between velocities, where a line gives their product.

    Lines give their sizes too; one that a line does not give is that of the velocity.
    """
    wholes = {link.left: link.right for link in _wholes(step) if link.sign == "="}
    product = next(
        (e for e in (Quantity("dot", (one, other)), Quantity("dot", (other, one))) if e in wholes),
        None,
    )
    sizes = [
        wholes.get(replace(each, kind="speed"), Apply("abs", each))
        for each in (one, other)
        if isinstance(each, Quantity) and each.kind == "velocity"
    ]
    if product is not None and len(sizes) == 2:
        yield Link(Apply("cos", angle), "=", Binary("/", wholes[product], Binary("*", *sizes)))


def _wholes(step: Step) -> Iterator[Link]:
    """What is cited without alternatives, each chain from its first side to its last."""
    for each in step.cited:
        if isinstance(each.relation, Relation) and len(each.relation.options) == 1:
            whole = whole_of(each.relation.only)
            if whole is not None:
                yield whole


def _pointing(step: Step, tree: Expression) -> Expression:
    """A vector in the direction of a wall or a line of centres that is cited; else the tree."""
    directions = step.world.directions
    own: Expression = Quantity("direction", (tree,)) if isinstance(tree, Name) else tree
    seen = 0
    while own in directions and seen < len(directions):
        own, seen = directions[own], seen + 1
    if step.world.is_angle(own):
        return Polar(Number(Fraction(1)), own)
    return own if seen else tree


WORKED_OUT: Mapping[str, Callable[[Step, Event | None], Iterable[Link]]] = {
    "difference": turnings,
    "tan": to_walls,
    "speed": by_angles,
    "total": _total,
    "total-lost": _total_lost,
    "momentum-of": _momentum_of_all,
    "momentum-vector": _momentum_kept,
    "energy-lost": _energy_lost,
    "perpendicular": _tied,
    "parallel": _tied,
    "scalar-angle": _between_directions,
    "chord": _chords,
    "moves-off": _moving_off,
    "beside": _beside,
    "round": _rounds,
}
