"""What names of velocities and of their components may mean: ``speed of A``, ``perp after``.

So may those of masses and of the mass centre, which velocities are measured by.
"""

from __future__ import annotations

from collections.abc import Iterator

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Name,
    Negate,
    Quantity,
    Stage,
    Unit,
    negated,
    unsigned,
)
from restitution.practice.reading.features import AXES
from restitution.practice.reading.right_angles import RightAngles
from restitution.problem import Impact

_UNITS = Unit("j"), Unit("i")


class VelocityNames(RightAngles):
    """The velocities that a phrase may name, their sizes, components and changes."""

    def gradient(self, event: int) -> Iterator[Expression]:
        """Gradients: of an impulse or a line of centres, of a wall or a tangent, of velocities."""
        up, across = (Quantity("along", (self.line(event), unit)) for unit in _UNITS)
        centres = "impulse" in self.features.heads or self.features.direction == "along centres"
        of_wall = self.features.wall or not set(self.features.names).isdisjoint(self.walls)
        if centres or (self.features.direction and not of_wall):
            yield Binary("/", up, across)
        if of_wall or (self.features.direction and not centres):
            yield Negate(Binary("/", across, up))
        for body in () if of_wall or self.features.direction or centres else self.bodies(event):
            velocity = self.of("velocity", body, event)
            rise, run = (Quantity("along", (velocity, unit)) for unit in _UNITS)
            yield Binary("/", rise, run)

    def speed(self, event: int) -> Iterator[Expression]:
        """Speeds; the speed of a component next."""
        for body in self.bodies(event):
            yield self.of("speed", body, event)
        for body in self.bodies(event):
            component = Quantity("along", (self.of("velocity", body, event), self.line(event)))
            yield Apply("abs", component)

    def velocity(self, event: int) -> Iterator[Expression]:
        """Velocities, their sizes, and their components along the line of centres."""
        if "magnitude" in self.features.heads:
            yield from (self.of("speed", body, event) for body in self.bodies(event))
            return
        if self.features.sense:
            yield from self.component(event)
        for body in self.bodies(event):
            velocity = self.of("velocity", body, event)
            yield velocity
            yield self.of("speed", body, event)
            yield Quantity("along", (velocity, self.line(event)))
            yield Negate(Quantity("along", (velocity, self.line(event))))

    def component(self, event: int) -> Iterator[Expression]:
        """Components along the direction named, in the sense named or in either."""
        for body in self.bodies(event):
            velocity = self.of("velocity", body, event)
            for value in self.components(velocity, event, body):
                yield value
                if not self.features.sense:
                    yield negated(value)

    def of_the_axis(self, event: int) -> Iterator[Expression]:
        """What else a line about a direction may work out: a momentum, or an impulse."""
        for body in self.bodies(event):
            for vector in (
                Quantity("impulse", (Name(body),), self.after(event)),
                self.of("momentum", body, event),
            ):
                for value in self.components(vector, event, body):
                    yield value
                    yield negated(value)

    def components(self, velocity: Expression, event: int, body: str) -> Iterator[Expression]:
        features, line, wall = self.features, self.line(event), self.wall(event)
        named = features.direction or ""
        sense = self.along_sense(event, body)
        if features.axis is not None and "perpendicular" not in named:
            yield Quantity("along", (velocity, self.axis_in_its_sense(event, body)))
        elif features.axis is not None:
            yield Quantity("across", (velocity, features.axis))
        elif "centres" in named and "perpendicular" not in named:
            if sense is not None and features.sense not in ("towards", "away"):
                yield Quantity("along", (velocity, sense))
            turned = features.sense == "opposite" or self.turned(event, body)
            value = Quantity("along", (velocity, line))
            yield Negate(value) if turned else value
        elif "centres" in named:
            yield Quantity("across", (velocity, line))
        elif features.sense in ("towards", "away"):
            value = Quantity("along", (velocity, line))
            yield Negate(value) if self.turned(event, body) else value
        elif sense is not None:
            yield Quantity("along", (velocity, sense))
        elif wall is not None:
            yield from self.at_wall(velocity, wall, line, "perpendicular" in named)
            if not named:
                yield from self.at_wall(velocity, wall, line, True)
        elif named == "perpendicular":
            yield Quantity("across", (velocity, line))
            yield Quantity("along", (velocity, line))
        else:
            yield Quantity("along", (velocity, line))
            if named == "parallel":
                yield Quantity("across", (velocity, line))

    def at_wall(
        self, velocity: Expression, wall: Expression, line: Expression, perpendicular: bool
    ) -> Iterator[Expression]:
        """Components along a wall, or perpendicular to it and away from it after the impact."""
        if not perpendicular:
            yield Quantity("along", (velocity, wall))
            return
        into = Quantity("along", (velocity, line))
        yield into if self.features.stage == "before" else Negate(into)
        yield Quantity("across", (velocity, wall))

    def along_sense(self, event: int, body: str) -> Expression | None:
        """The direction of *to the left* and its like."""
        return AXES.get(self.features.sense or "")

    def axis_in_its_sense(self, event: int, body: str) -> Expression:
        """The axis named, turned where other words give the sense: *to the left along i*."""
        axis, sense = self.features.axis, self.features.sense
        assert axis is not None
        if sense == "opposite":
            return negated(axis)
        wanted = AXES.get(sense or "")
        impact = self.events[event - 1] if 0 < event <= len(self.events) else None
        if sense in ("towards", "away") and isinstance(impact, Impact) and impact.along:
            wanted = negated(impact.along) if self.turned(event, body) else impact.along
        return wanted if wanted is not None and unsigned(wanted) == unsigned(axis) else axis

    def turned(self, event: int, body: str) -> bool:
        """Whether *towards B*, *away from the wall* is against the line of centres."""
        sense, target = self.features.sense, self.features.target
        if sense not in ("towards", "away") or not 0 < event <= len(self.events):
            return False
        impact = self.events[event - 1]
        if not isinstance(impact, Impact):
            return False
        towards_first = body == impact.second or target == impact.first
        return towards_first == (sense == "towards")

    def relative(self, event: int) -> Iterator[Expression]:
        """Speeds of approach and of separation."""
        bodies = self.bodies_met(event)
        heads = self.features.heads
        approach = "approach" in heads or ("relative" in heads and self.features.stage == "before")
        stage: Stage = event - 1 if approach else self.after(event)
        velocities = [Quantity("velocity", (Name(body),), stage) for body in bodies]
        if not velocities:
            return
        line = self.line(event)
        difference: Expression = velocities[0]
        if len(velocities) > 1:
            difference = Binary("-", velocities[0], velocities[1])
        if "perpendicular" in (self.features.direction or ""):
            across = Quantity("across", (difference, line))
            yield from (across, Negate(across))
            return
        value = Quantity("along", (difference, line))
        yield value if approach else Negate(value)
        yield Negate(value) if approach else value
        if len(velocities) > 1 and "relative" in heads:
            yield Binary("-", velocities[0], velocities[1])
            yield Binary("-", velocities[1], velocities[0])
        if len(velocities) > 1:
            yield Apply("abs", difference)
        if "relative" in heads:
            yield from self.beside_the_mass_centre(event)

    def beside_the_mass_centre(self, event: int) -> Iterator[Expression]:
        """The velocity of one sphere that is named, relative to the mass centre: *to it A 2.4*."""
        named = [name for name in self.features.names if name in self.spheres]
        if len(named) != 1:
            return
        for stage in (event - 1, self.after(event)):
            for velocity in self.of_the_mass_centre(stage):
                own = Binary("-", Quantity("velocity", (Name(named[0]),), stage), velocity)
                yield from self._along_axes(own, event)

    def of_the_mass_centre(self, stage: Stage) -> Iterator[Expression]:
        """The velocity of the mass centre as a vector; none of one sphere alone."""
        masses = [Quantity("mass", (Name(sphere),)) for sphere in self.spheres]
        if len(masses) < 2:
            return
        whole: Expression = masses[0]
        for mass in masses[1:]:
            whole = Binary("+", whole, mass)
        yield Binary("/", Quantity("momentum", (), stage), whole)

    def mass_centre(self, event: int) -> Iterator[Expression]:
        """The velocity of the mass centre along the line of centres, and as a vector."""
        for velocity in self.of_the_mass_centre(self.stage(event)):
            yield from self._along_axes(velocity, event)
            yield velocity
            yield Apply("abs", velocity)

    def _along_axes(self, velocity: Expression, event: int) -> Iterator[Expression]:
        """The components of a velocity along the line of centres and the axes, in either sense."""
        for axis in (self.features.axis or self.line(event), Unit("i"), Unit("j")):
            yield Quantity("along", (velocity, axis))
            yield Negate(Quantity("along", (velocity, axis)))

    def relative_size(self, event: int) -> Iterator[Expression]:
        """The size of the relative velocity of two spheres."""
        velocities = [self.of("velocity", body, event) for body in self.bodies_met(event)]
        if len(velocities) == 2:
            yield Apply("abs", Binary("-", *velocities))

    def mass(self, event: int) -> Iterator[Expression]:
        """Masses; of two that meet the reduced mass, or the sum, where the words say so."""
        masses = [Quantity("mass", (Name(body),)) for body in self.bodies_met(event)]
        if len(masses) == 2 and (self.features.reduced or self.features.both):
            total = Binary("+", *masses)
            reduced = Binary("/", Binary("*", *masses), total)
            yield reduced if self.features.reduced else total
            return
        yield from (Quantity("mass", (Name(body),)) for body in self.bodies(event))

    def change(self, event: int) -> Iterator[Expression]:
        """A change of velocity, or of a component of it."""
        for body in self.bodies(event):
            after = Quantity("velocity", (Name(body),), self.after(event))
            before = Quantity("velocity", (Name(body),), event - 1)
            difference = Binary("-", after, before)
            if self.features.direction or self.features.axis is not None:
                yield from self.components(difference, event, body)
            yield difference
            yield Apply("abs", difference)
