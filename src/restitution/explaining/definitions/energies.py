"""Energies and momenta of spheres, and what is lost of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

from restitution.explaining.definitions.common import axis_of, total_of, whole_links
from restitution.explaining.lines.derivation import Event, Link
from restitution.explaining.lines.trees import squared
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    COMPONENTS,
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
    is_quantity,
)

_HALF = Binary("/", Number(Fraction(1)), Number(Fraction(2)))


def _component(kind: str, body: str, stage: int, event: Event) -> Quantity:
    return Quantity(kind, (Quantity("velocity", (Name(body),), stage), axis_of(event)))


def impulse_along_the_line(step: Step, event: Event | None) -> Iterator[Link]:
    """The impulse on a body as a vector along a line that slants: m times the change there.

    Along **i** or **j** it is the difference of two velocities, of which both components are cited.
    """
    for body, number, change, axis in _changes_along(step, event):
        size = Binary("*", Quantity("mass", (Name(body),)), change)
        vector = Polar(size, Degrees(Fraction(0)), axis)
        yield Link(Quantity("impulse", (Name(body),), number), "=", vector)


def impulse_by_its_size(step: Step, event: Event | None) -> Iterator[Link]:
    """The impulse on a body: its size along the line of centres, away from the other body."""
    if event is None or event.kind != "impact" or step.world.direction(axis_of(event)) is None:
        return
    size = Quantity("impulse", (), event.number)
    for body in step.move.bodies:
        towards = Negate(size) if body == event.bodies[0] else size
        vector = Polar(towards, Degrees(Fraction(0)), axis_of(event))
        yield Link(Quantity("impulse", (Name(body),), event.number), "=", vector)


def velocity_by_its_change(step: Step, event: Event | None) -> Iterator[Link]:
    """A velocity after an impact by that before it, and its change along a line that slants."""
    for body, number, change, axis in _changes_along(step, event):
        late, early = (Quantity("velocity", (Name(body),), n) for n in (number, number - 1))
        vector = Polar(change, Degrees(Fraction(0)), axis)
        yield Link(late, "=", Binary("+", early, vector))


def _changes_along(
    step: Step, event: Event | None
) -> Iterator[tuple[str, int, Expression, Expression]]:
    """The change of each body's component along a line of centres that slants, and that line.

    With it the body, and the number of the impact.
    """
    if event is None or event.kind != "impact":
        return
    direction = step.world.direction(axis_of(event))
    if direction is None or direction.x.vanishes or direction.y.vanishes:
        return
    for body in step.move.bodies:
        late, early = (
            _component("along", body, stage, event) for stage in (event.number, event.number - 1)
        )
        yield body, event.number, Binary("-", _by_its_letter(step, late), early), axis_of(event)


def _by_its_letter(step: Step, component: Quantity) -> Expression:
    """A component as the letter that is cited for it: of a line in letters no vector tells it."""
    named = (meaning for meaning in step.lets if meaning.quantity == component)
    own = next(
        (meaning for meaning in named if meaning.sense in (None, component.arguments[1])), None
    )
    return component if own is None else Letter(own.letter)


def _squares(form: str, body: str, stage: int, event: Event | None) -> Expression:
    """The square of a speed: by components of an event, by the vector, or as it is."""
    velocity = Quantity("velocity", (Name(body),), stage)
    if form == "components" and event is not None and body in event.bodies:
        parts = (_component(kind, body, stage, event) for kind in COMPONENTS)
        return total_of([squared(part) for part in parts])
    if form == "along" and event is not None:
        return squared(_component("along", body, stage, event))
    if form == "speed":
        return squared(Quantity("speed", (Name(body),), stage))
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
        for link in whole_links(step)
        if is_quantity(link.left, "energy") and link.sign == "="
    )


def total(step: Step, event: Event | None) -> Iterator[Link]:
    """The energy of all spheres before an event and after it."""
    number = 0 if event is None else event.number
    cited = _cited_energies(step)
    for stage in {number, max(0, number - 1)}:
        for form in ("components", "vectors", "speed", "energy"):
            terms = [
                _kinetic(step, form, body, stage, event, cited) for body in step.setting.spheres
            ]
            if terms:
                yield Link(Quantity("energy", (), stage), "=", total_of(terms))
        yield from _of_vectors_and_components(step, event, stage, cited)
        yield from _without_the_others(step, event, stage)
    if event is not None and event.kind == "impact":
        lost = Quantity("energy_lost", (), number)
        bodies = step.setting.spheres
        # The energy of all is that of the one body.
        names = ((), tuple(map(Name, bodies))) if len(bodies) == 1 else ((),)
        for late, early in product(names, repeat=2):
            before = Quantity("energy", early, number - 1)
            yield Link(Quantity("energy", late, number), "=", Binary("-", before, lost))
    yield from _of_given_speeds(step)


def _without_the_others(step: Step, event: Event | None, stage: int) -> Iterator[Link]:
    """The energy of one sphere: that of all, without those of the others."""
    whole = Quantity("energy", (), stage)
    for body in step.move.bodies if len(step.move.bodies) == 1 else ():
        for form in ("components", "vectors"):
            others = [
                _kinetic(step, form, other, stage, event)
                for other in step.setting.spheres
                if other != body
            ]
            if others:
                own = Quantity("energy", (Name(body),), stage)
                yield Link(own, "=", Binary("-", whole, total_of(others)))


def _of_vectors_and_components(
    step: Step, event: Event | None, stage: int, cited: frozenset[Expression]
) -> Iterator[Link]:
    """The energy of all spheres, where some velocities are cited as vectors, others not."""
    vectors = {link.left.arguments[0] for link in step.links if is_quantity(link.left, "velocity")}
    forms = {
        body: "vectors" if Name(body) in vectors else "components" for body in step.setting.spheres
    }
    if event is not None and len({*forms.values()}) > 1:
        terms = [_kinetic(step, forms[body], body, stage, event, cited) for body in forms]
        yield Link(Quantity("energy", (), stage), "=", total_of(terms))


def _of_given_speeds(step: Step) -> Iterator[Link]:
    """The energy at the start, where only some velocities are told by their size and an angle."""
    sized = {
        link.left.arguments[0]
        for link in step.links
        if is_quantity(link.left, "velocity") and isinstance(link.right, Polar)
    }
    terms = [
        _kinetic(step, "speed" if Name(body) in sized else "vectors", body, 0, None)
        for body in step.setting.spheres
    ]
    if 0 < len(sized) < len(terms):
        yield Link(Quantity("energy", (), 0), "=", total_of(terms))


def momentum_of_all(step: Step, event: Event | None) -> Iterator[Link]:
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
            yield Link(Quantity("momentum", (), stage), "=", total_of(terms))


def _momentum_in_directions(step: Step, event: Event | None) -> Iterator[Link]:
    """The components of the momentum of a sphere, of those of its velocity."""
    number = 0 if event is None else event.number
    axes: list[Expression] = [Unit("i"), Unit("j"), Quantity("line_of_centres", (), number)]
    for body in step.move.bodies if len(step.move.bodies) == 1 else ():
        for stage in {number, max(0, number - 1)}:
            mass = Quantity("mass", (Name(body),))
            whole, velocity = (
                Quantity(kind, (Name(body),), stage) for kind in ("momentum", "velocity")
            )
            for axis in axes:
                for kind in COMPONENTS:
                    component = Quantity(kind, (velocity, axis))
                    yield Link(Quantity(kind, (whole, axis)), "=", Binary("*", mass, component))


def momentum_kept(step: Step, event: Event | None) -> Iterator[Link]:
    """That the momentum of all spheres is the same before and after two of them meet."""
    if event is None or event.kind != "impact" or event.wall:
        return
    terms = [
        Binary(
            "*", Quantity("mass", (Name(b),)), Quantity("velocity", (Name(b),), event.number - 1)
        )
        for b in step.setting.spheres
    ]
    yield Link(total_of(terms), "=", Quantity("momentum", (), event.number))


def total_lost(step: Step, event: Event | None) -> Iterator[Link]:
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
        yield Link(Quantity("total_energy_lost", (), event.number), "=", total_of(terms))
    before, after = (Quantity("energy", (), stage) for stage in (0, event.number))
    lost = Binary("-", before, after)
    yield Link(Quantity("total_energy_lost", (), event.number), "=", lost)
    earlier = [other for other in step.setting.events if other.number <= event.number]
    if all(event.kind != "arrival" for event in earlier):
        losses = [Quantity("energy_lost", (), event.number) for event in earlier]
        yield Link(Quantity("total_energy_lost", (), event.number), "=", total_of(losses))
    if event.number == 1 and event.kind == "impact":
        # Nothing else has happened: it is what the impact takes.
        for link in energy_lost(step, event):
            if link.left == Quantity("energy_lost", (), 1):
                yield replace(link, left=Quantity("total_energy_lost", (), 1))


def energy_lost(step: Step, event: Event | None) -> Iterator[Link]:
    """The energy that the bodies of an event lose: whole, or by components along the line."""
    if event is None:
        return
    spheres = [body for body in event.bodies if body in step.setting.spheres]
    cited = _cited_energies(step)
    forms = ("components", "along", "vectors", "speed", "energy")
    for early, late in (*zip(forms, forms, strict=True), ("vectors", "speed")):
        terms = [
            Binary(
                "-",
                _kinetic(step, early, body, event.number - 1, event, cited),
                _kinetic(step, late, body, event.number, event, cited),
            )
            for body in spheres
        ]
        lost = total_of(terms)
        yield Link(Quantity("energy_lost", (), event.number), "=", lost)
        stages = (event.number - 1, event.number)
        before, after = (Quantity("energy", (), stage) for stage in stages)
        yield Link(Binary("-", before, after), "=", lost)
        if len(spheres) == len(step.setting.spheres) and step.setting.quantity(before) in cited:
            left = [_kinetic(step, late, body, event.number, event, cited) for body in spheres]
            rest = Binary("-", before, total_of(left))
            yield Link(Quantity("energy_lost", (), event.number), "=", rest)
    if len(step.setting.spheres) == 1:
        # The energy of all is that of the one body.
        own = tuple(
            Quantity("energy", (Name(body),), stage) for body in spheres for stage in stages
        )
        for pair in ((before, own[1]), (own[0], after)) if own else ():
            yield Link(Quantity("energy_lost", (), event.number), "=", Binary("-", *pair))
    yield Link(Quantity("energy_lost", (), event.number), "=", Binary("-", before, after))
    changes = _changes_cited(step, event, spheres)
    if changes:
        yield Link(Quantity("energy_lost", (), event.number), "=", total_of(changes))


def fraction_lost(step: Step, event: Event | None) -> Iterator[Link]:
    """The fraction of its energy that a sphere loses, or keeps, by squares of speeds."""
    yield from _energies_apart(step, event)
    if event is None or len(step.setting.spheres) != 1:
        return
    (body,) = step.setting.spheres
    yield from _of_earlier_energies(step, event, body)
    for kind, stage in (("energy_lost", event.number - 1), ("total_energy_lost", 0)):
        lost = Quantity(kind, (), event.number)
        forms = ("speed", "components", "vectors")
        early, late = (
            [_squares(form, body, at, event) for form in forms] for at in (stage, event.number)
        )
        changes = [Binary("-", first, last) for first in early for last in late]
        if stage == event.number - 1:
            first, last = (_squares("along", body, at, event) for at in (stage, event.number))
            changes.append(Binary("-", first, last))
        for bodies in ((), (Name(body),)):
            before = Quantity("energy", bodies, stage)
            for change in changes:
                for whole in early:
                    yield Link(Binary("/", lost, before), "=", Binary("/", change, whole))
        # The energy of all is that of the one body.
        energies = [
            [Quantity("energy", own, at) for own in ((), (Name(body),))]
            for at in (event.number, stage)
        ]
        for (after, before), pair in product(product(*energies), product(late, early)):
            yield Link(Binary("/", after, before), "=", Binary("/", *pair))
        for after, before in product(*energies):
            for first in energies[1]:  # what is lost is what is not kept
                shares = [Binary("/", lost, first), Binary("/", after, before)]
                for one, other in (shares, shares[::-1]):
                    yield Link(one, "=", Binary("-", Number(Fraction(1)), other))


def _of_earlier_energies(step: Step, event: Event, body: str) -> Iterator[Link]:
    """What an impact takes of the energy that a sphere had before others; of several the sum."""
    forms = ("speed", "components", "vectors")
    number = event.number
    lost = Quantity("energy_lost", (), number)
    first, last = (
        [_squares(form, body, at, event) for form in (*forms, "along")]
        for at in (number - 1, number)
    )
    for stage in range(number):
        wholes = [_squares(form, body, stage, event) for form in forms]
        for bodies in ((), (Name(body),)):
            before = Quantity("energy", bodies, stage)
            if stage == 0:
                fractions: list[Expression] = [
                    Binary("/", Quantity("energy_lost", (), at), before)
                    for at in range(1, number + 1)
                ]
                whole_loss = Quantity("total_energy_lost", (), number)
                yield Link(Binary("/", whole_loss, before), "=", total_of(fractions))
            if stage < number - 1:
                for one, other in zip(first, last, strict=True):
                    for whole in wholes:
                        change = Binary("-", one, other)
                        yield Link(Binary("/", lost, before), "=", Binary("/", change, whole))


def _energies_apart(step: Step, event: Event | None) -> Iterator[Link]:
    """The energy of a sphere after an event over what it was before others: its mass cancels."""
    if event is None:
        return
    forms = ("speed", "components", "vectors")
    for body in step.move.bodies:
        late = Quantity("energy", (Name(body),), event.number)
        above = [_squares(form, body, event.number, event) for form in forms]
        for stage in range(event.number - 1):
            early = Quantity("energy", (Name(body),), stage)
            below = [_squares(form, body, stage, event) for form in forms]
            for pair in product(above, below):
                yield Link(Binary("/", late, early), "=", Binary("/", *pair))


def _changes_cited(step: Step, event: Event, spheres: Sequence[str]) -> list[Expression]:
    """What each sphere loses at an event by a change of its energy that is cited; else nothing."""
    wholes = {link.left: link.right for link in whole_links(step) if link.sign == "="}
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
