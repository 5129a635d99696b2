"""What names of energies, impulses and momenta may mean: ``KE lost by A``, ``impulse on B``.

So may those of ratios, most of which are of energies.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from math import inf

from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Quantity,
    Stage,
    Unit,
    is_binary,
    negated,
)
from restitution.practice.reading.journeys import names_in
from restitution.practice.reading.velocity_names import VelocityNames


class EnergyNames(VelocityNames):
    """The energies, impulses and momenta that a phrase may name, and ratios of them."""

    def energy(self, event: int) -> Iterator[Expression]:
        """Kinetic energies, and what is lost of them; a change alone may have either sense."""
        named = [name for name in self.features.names if name in self.spheres]
        body = named[0] if len(named) == 1 and not self.features.both else None
        after, before = self.after(event), event - 1
        if self.features.heads & {"loss", "gain", "change"}:
            gain = "gain" in self.features.heads
            either = "change" in self.features.heads
            if body is not None:
                for start in self.starts_of_a_change(before):
                    own = (Quantity("energy", (Name(body),), stage) for stage in (start, after))
                    lost = Binary("-", *own)
                    yield Negate(lost) if gain else lost
                    if either:
                        yield lost if gain else Negate(lost)
            else:
                yield from self.changes_of_energy_asked(gain)
                last = Quantity("energy_lost", (), after)
                whole = Quantity("total_energy_lost", (), after)
                if self.features.both and len(self.events) > 1 and len(self.spheres) == 1:
                    last = whole  # of one sphere the total is that of all impacts
                several = (last, whole) if len(self.events) > 1 else (last,)
                if self.features.both and any(self.asked("total_energy_lost")):
                    several = several[::-1]  # of two spheres a total may be of one impact
                for value in dict.fromkeys(several):
                    yield Negate(value) if gain else value
                if either:
                    yield last if gain else Negate(last)
            return
        stage = before if self.features.stage == "before" else after
        if self.features.start and before:
            yield Quantity("energy", () if body is None else (Name(body),), 0)
        if self.features.direction or self.features.axis is not None:
            yield self.energy_of_components(event, body)
        elif body is not None:
            yield Quantity("energy", (Name(body),), stage)
        else:
            yield Quantity("energy", (), stage)
            if len(met := self.bodies_met(event)) == 1 and not self.features.both:
                yield Quantity("energy", (Name(met[0]),), stage)  # who comes to a wall alone

    def starts_of_a_change(self, before: int) -> tuple[int, ...]:
        """The stages since which a body's energy may change: an impact, or all that are asked of.

        Where what all impacts lose is asked, B may gain from the first to the last.
        """
        of_all = any(self.asked("total_energy_lost"))
        return (before, 0) if of_all and before else (before,)

    def changes_of_energy_asked(self, gain: bool) -> Iterator[Expression]:
        """What one body loses of its kinetic energy, or gains, where the question asks for it."""
        for tree in self.values_asked():
            match tree:
                case Binary(
                    "-", Quantity("energy", (Name(), *_)) as first, Quantity("energy") as last
                ):
                    if first.arguments == last.arguments:
                        is_gain = _latest(first) > _latest(last)
                        yield tree if is_gain == gain else Binary("-", last, first)

    def energy_of_components(self, event: int, body: str | None) -> Expression:
        """The part of a kinetic energy that components along a direction have."""
        terms: list[Expression] = []
        for sphere in self.spheres if body is None else (body,):
            component = next(self.components(self.of("velocity", sphere, event), event, sphere))
            square = Binary("^", component, Number(Fraction(2)))
            half = Binary("*", Number(Fraction(1, 2)), Quantity("mass", (Name(sphere),)))
            terms.append(Binary("*", half, square))
        return reduce(lambda one, other: Binary("+", one, other), terms)

    def impulse(self, event: int) -> Iterator[Expression]:
        """The size of an impulse; the impulse on a body as a vector as well."""
        after = self.after(event)
        named = [name for name in self.features.names if name in self.spheres]
        size: Expression = Quantity("impulse", (), after)
        vectors = [Quantity("impulse", (Name(name),), after) for name in named[:2]]
        yield from (size, *vectors, negated(size))
        for body in self.bodies_met(event) if self.features.target not in named else ():
            yield Quantity("impulse", (Name(body),), after)
        yield from self.blows()

    def momentum(self, event: int) -> Iterator[Expression]:
        """Momenta along the line of centres, and as vectors."""
        stage = self.stage(event)
        named = [name for name in self.features.names if name in self.spheres]
        line = self.features.axis or self.line(event)
        if "change" in self.features.heads:
            yield from self.impulse(event)
            return
        whole: tuple[Expression, ...] = (Name(named[0]),) if len(named) == 1 else ()
        momentum = Quantity("momentum", whole, stage)
        yield Quantity("along", (momentum, line))
        yield Negate(Quantity("along", (momentum, line)))
        yield momentum
        for axis in (Unit("i"), Unit("j")) if self.features.axis is None else ():
            yield Quantity("along", (momentum, axis))

    def ratio(self, event: int) -> Iterator[Expression]:
        """Ratios: of energy lost to that before, of energies, of speeds, of masses."""
        if self.features.heads == {"ratio"} and (asked := tuple(self.ratios_asked())):
            yield from asked
            return  # a fraction of which no more is said is the one that is asked
        after, before = self.after(event), event - 1
        energy = Quantity("energy", (), before)
        if (heads := self.features.heads) & {"gain", "loss"}:
            yield from self.shares_of_bodies(after, before)
        if heads & {"energy", "loss"} or heads == {"ratio"}:
            yield Binary("/", Quantity("energy_lost", (), after), energy)
            if len(self.events) > 1:
                whole = Quantity("total_energy_lost", (), after)
                yield Binary("/", whole, Quantity("energy", (), 0))
            if "loss" not in heads:
                yield Binary("/", Quantity("energy", (), after), energy)
                if before:
                    yield Binary("/", Quantity("energy", (), after), Quantity("energy", (), 0))
        if heads & {"speed", "velocity"} or heads == {"ratio"}:
            for body in self.bodies(event):
                name = (Name(body),)
                yield Binary("/", Quantity("speed", name, after), Quantity("speed", name, before))
        met = self.bodies_met(event)
        bare = heads == {"ratio"} and not self.features.percent
        if len(met) == 2 and ("mass" in heads or bare):
            first, second = (Quantity("mass", (Name(body),)) for body in met)
            yield Binary("/", first, second)
            yield Binary("/", second, first)

    def shares_of_bodies(self, after: Stage, before: int) -> Iterator[Expression]:
        """What spheres that are named lose of their own energies; what any gains."""
        gain = "gain" in self.features.heads
        named = [name for name in self.features.names if name in self.spheres]
        for name in named or (self.spheres if gain else ()):
            early, late = (Quantity("energy", (Name(name),), stage) for stage in (before, after))
            change = Binary("-", late, early) if gain else Binary("-", early, late)
            yield Binary("/", change, early)

    def ratios_asked(self) -> Iterator[Expression]:
        """The ratios for which the question asks, of the bodies that are named first."""
        named = {name for name in self.features.names if name in self.spheres}
        asked = [tree for tree in self.values_asked() if is_binary(tree, "/")]
        yield from sorted(asked, key=lambda tree: not named <= names_in(tree))


def _latest(quantity: Quantity) -> float:
    """The event after which a quantity is meant; after all of them if it has none."""
    if isinstance(quantity.stage, int):
        return quantity.stage
    return -1 if quantity.stage == "before" else inf
