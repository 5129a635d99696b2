"""Phrases that name a quantity: ``speed of A``, ``KE lost``, ``angle to the wall after``.

A phrase is a bag of the features that its words have: what it is of, when, in which direction and
sense. So word order, fillers and capitals do not matter. What it may mean is a list of trees of
the statement language, the most natural first.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import chain
from math import inf
from typing import Literal

from restitution.errors import StatementError
from restitution.expression import read_expression
from restitution.expression.tree import (
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Quantity,
    Stage,
    Unit,
    is_binary,
    is_quantity,
    negated,
    unsigned,
)
from restitution.practice.reading.features import AXES, Features, features_of, words_of
from restitution.practice.reading.journeys import names_in
from restitution.practice.reading.phrase_names import (
    UNNAMED_ANGLE,
    UNNAMED_DIRECTION,
    event_of,
    is_phrase,
    is_relative,
    is_vague,
    names_axis,
    names_quantity,
    names_time,
    names_way_back,
    names_whole_time,
    speaks_of_the_end,
    tells_after,
)
from restitution.practice.reading.right_angles import RightAngles
from restitution.problem import Impact, Kick, Problem

__all__ = [
    "UNNAMED_ANGLE",
    "UNNAMED_DIRECTION",
    "event_of",
    "is_phrase",
    "is_relative",
    "is_vague",
    "names_axis",
    "names_quantity",
    "names_time",
    "names_way_back",
    "names_whole_time",
    "read_phrase",
    "speaks_of_the_end",
    "tells_after",
    "words_of",
]

MAX_CANDIDATES = 40
# What people compare with the start under any heading.
_OF_THE_WHOLE = frozenset(("energy", "loss", "gain", "ratio"))
_UNITS = Unit("j"), Unit("i")
_DIRECTION = re.compile(
    r"\b(along|of|to|direction)\s+((?:\(?\s*-?\s*[\d√./()\s]*[ij][\s)/\d√.+-]*){2,})", re.IGNORECASE
)


def read_phrase(
    words: str, problem: Problem, event: int | None = None, until: int | None = None
) -> tuple[Expression, ...]:
    """What a phrase may mean, as quantities of the statement language, most natural first.

    Text of the statement language itself (``along(velocity(A), i)``) is read as it stands. Where
    no event is named, it is that of the heading above, ``event``; else the latest one comes first,
    of those ``until`` the number that a part has come to. None where the words name nothing.
    """
    text = words.strip()[:400]
    if "(" in text:
        exact = _exact(text, problem)
        if exact is not None:
            return (exact,)
    axis = _DIRECTION.search(text)
    direction = _exact(axis[2].strip(), problem) if axis else None
    if axis is not None and direction is not None:
        text = text[: axis.start(2)] + text[axis.end() :]
    features = features_of(words_of(text)[:40], problem)
    if direction is not None:
        features = replace(features, axis=direction)
    if event is not None and features.event is None and not features.heads & _OF_THE_WHOLE:
        features = replace(features, event=_counted(event, features, problem))
    stages: tuple[Literal["after", "before"], ...] = ("after", "before")
    staged = [replace(features, stage=stage) for stage in stages]
    if features.stage:
        staged = [replace(features, timed=True)]
    if features.heads == {"energy"} and not (features.stage or features.names):
        # As a title it may stand for what is lost: KE: 50 - 34 = 16.
        staged.append(replace(features, heads=frozenset(("energy", "loss"))))
    return _unique(
        chain.from_iterable(_Reader(reading, problem, until).candidates() for reading in staged)
    )


def _counted(event: int, features: Features, problem: Problem) -> int | None:
    """Which impact an event is, counted from 1, if the phrase may speak of it."""
    impacts = [n for n, event in enumerate(problem.events, 1) if isinstance(event, Impact)]
    if event not in impacts:
        return None
    impact = problem.events[event - 1]
    assert isinstance(impact, Impact)
    met = {impact.first, impact.second}
    return impacts.index(event) + 1 if set(features.names) <= met else None


def _exact(text: str, problem: Problem) -> Expression | None:
    names = {sphere.name for sphere in problem.spheres}
    names |= {wall.name for wall in problem.walls} | {point.name for point in problem.points}
    try:
        return read_expression(text, names=names)
    except (StatementError, RecursionError):
        return None


def _is_of_velocities(angle: Expression) -> bool:
    """Whether an angle is one between two velocities."""
    return isinstance(angle, Quantity) and all(
        is_quantity(argument, "velocity") for argument in angle.arguments
    )


def _latest(quantity: Quantity) -> float:
    """The event after which a quantity is meant; after all of them if it has none."""
    if isinstance(quantity.stage, int):
        return quantity.stage
    return -1 if quantity.stage == "before" else inf


def _unique(candidates: Iterator[Expression]) -> tuple[Expression, ...]:
    trees: dict[Expression, None] = {}
    for candidate in candidates:
        trees.setdefault(candidate)
        if len(trees) >= MAX_CANDIDATES:
            break
    return tuple(trees)


class _Reader(RightAngles):
    """The candidates of one phrase."""

    def candidates(self) -> Iterator[Expression]:
        """What the phrase may mean, the most natural first; the same quantity may come twice."""
        heads = self.features.heads
        for event in self.numbers():
            if self.features.mass_centre and "relative" in heads:
                yield from self.beside_the_mass_centre(event)
            elif self.features.mass_centre:
                yield from self.mass_centre(event)
            elif "gradient" in heads:
                yield from self.gradient(event)
            elif "ratio" in heads:
                yield from self.ratio(event)
            elif "scalar product" in heads:
                yield from self.scalar_products(event)
            elif "deflection" in heads:
                yield from self.deflection(event)
            elif "angle" in heads:
                yield from self.angle(event)
                walls = set(self.features.names) & set(self.walls)
                asked = (tree for tree in self.asked("angle") if walls <= names_in(tree))
                yield from (tree for tree in asked if not self._is_of_another_wall(tree, event))
                yield from self.asked("direction")
            elif heads & {"energy", "loss", "gain"}:
                yield from self.energy(event)
            elif "impulse" in heads:
                yield from self.impulse(event)
            elif "position" in heads:
                yield from self.places(event)
            elif "coefficient" in heads:
                yield Quantity("restitution", (), event)
            elif "mass" in heads:
                yield from self.mass(event)
            elif heads & {"approach", "separation", "relative"}:
                yield from self.relative(event)
            elif "momentum" in heads:
                yield from self.momentum(event)
            elif heads == {"distance"} and len(self.features.names) != 2:
                yield from self.travelled()
                yield from self.gaps()
                yield from self.asked("distance")
            elif "change" in heads and heads & {"velocity", "component"}:
                yield from self.change(event)
            elif heads == {"change"}:
                yield from self.change(event)
                yield from self.impulse(event)
            elif heads == {"time"}:
                if not (self.features.both or self.features.back):
                    yield Quantity("time", (), event)
                yield from self.times()
            elif self.features.direction or self.features.axis is not None or "component" in heads:
                yield from self.component(event)
                if self.features.axis is not None and heads <= {"direction"}:
                    yield from self.of_the_axis(event)
            elif "speed" in heads:
                if self.features.sense:  # the speed away from a wall, or to the left
                    yield from self.component(event)
                yield from self.speed(event)
            elif heads == {"magnitude"} and not self.features.names:
                yield from self.impulse(event)
                yield from self.velocity(event)
                yield from self.relative_size(event)
            elif heads & {"velocity", "magnitude"} or self.features.sense:
                yield from self.velocity(event)
            elif "direction" in heads:
                yield from (self.of("direction", body, event) for body in self.bodies(event))
                yield from self.inclinations(event)
                if self.features.wall or set(self.features.names) & set(self.walls):
                    yield from self.component(event)  # AB direction: 0.8u
            elif "distance" in heads and len(self.features.names) == 2:
                first, second = self.features.names
                yield Quantity("distance", (Name(first), Name(second)))
            elif "distance" in heads:
                yield from self.asked("distance")
            elif self.features.names:
                yield from self.velocity(event)

    # -- quantities ---------------------------------------------------------------------------

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

    def _is_of_another_wall(self, angle: Expression, event: int) -> bool:
        """Whether an angle is to another wall than that of which a heading speaks: ``at BC:``."""
        struck = self.met(event) & set(self.walls)
        own = names_in(angle) & set(self.walls)
        return self.features.event is not None and bool(struck and own) and not struck & own

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

    def energy(self, event: int) -> Iterator[Expression]:
        """Kinetic energies, and what is lost of them; a change alone may have either sense."""
        named = [name for name in self.features.names if name in self.spheres]
        body = named[0] if len(named) == 1 and not self.features.both else None
        after, before = self.after(event), event - 1
        if self.features.heads & {"loss", "gain", "change"}:
            gain = "gain" in self.features.heads
            either = "change" in self.features.heads
            if body is not None:
                own = (Quantity("energy", (Name(body),), stage) for stage in (before, after))
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
                for value in dict.fromkeys((last, whole)) if len(self.events) > 1 else (last,):
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

    def deflection(self, event: int) -> Iterator[Expression]:
        """Angles of deflection."""
        for body in self.bodies(event):
            yield Quantity("deflection", (Name(body),), self.after(event))
            if event > 1:
                ends = (
                    Quantity("velocity", (Name(body),), stage) for stage in (self.after(event), 0)
                )
                yield Quantity("angle", tuple(ends))

    def angle(self, event: int) -> Iterator[Expression]:
        """Angles to a wall, to the line of centres, to an axis, and between velocities."""
        features, line = self.features, self.line(event)
        spheres = [name for name in features.names if name in self.spheres]
        if len(spheres) > 1 and features.direction is None and features.axis is None:
            first, second = (self.of("velocity", sphere, event) for sphere in spheres[:2])
            yield Quantity("angle", (first, second))
        directed = features.axis is not None or features.direction is not None
        if features.between and not (spheres or directed) and len(self.bodies_met(event)) == 2:
            yield self.angle_between(event)
            if not any(map(_is_of_velocities, self.asked("angle"))):
                yield from self.inclinations(event)
            return
        if features.between and not (spheres or features.wall or features.direction):
            between = [tree for tree in self.asked("angle") if _is_of_velocities(tree)]
            if between and features.axis is None and not features.names:
                yield from between
                return
        if features.axis is not None and "centres" in (features.direction or ""):
            own = Quantity("angle", (line, features.axis))
            yield own
            yield Binary("-", STRAIGHT_ANGLE, own)
        if not spheres:
            own_angles = tuple(self.angles_of_wall(event))
            yield from own_angles
            if own_angles and features.lies and features.axis is not None:
                return
        for body in self.bodies(event):
            velocity = self.of("velocity", body, event)
            other = self.other_direction(event, line)
            value = Quantity("angle", (velocity, other))
            square = Binary("-", RIGHT_ANGLE, value)
            normal = (features.direction or "").startswith("perpendicular")
            to_wall = features.wall or not set(features.names).isdisjoint(self.walls)
            yield square if normal else value
            if features.axis is None and (normal or not to_wall):
                yield value if normal else square
            if features.axis is None:
                yield Binary("-", STRAIGHT_ANGLE, value)
            to_line = to_wall or features.direction or features.axis is not None
            if not (features.timed or to_line):  # that of before or after is to a line
                yield Quantity("deflection", (Name(body),), self.after(event))
        if not spheres and features.direction is None and len(self.bodies_met(event)) == 2:
            yield self.angle_between(event)
        if not spheres and features.axis is None and "centres" in (features.direction or ""):
            own = Quantity("angle", (line, Unit("i")))  # angle of the line of centres
            yield own
            yield Binary("-", RIGHT_ANGLE, own)
        if features.direction is None and not (directed or features.between):
            yield from self.angles_to_axes(event)

    def angles_to_axes(self, event: int) -> Iterator[Expression]:
        """The angles to i, or j, of a line of centres that slants, and of velocities beside it.

        At a blow they are those of the velocity of the body that receives it.
        """
        met = self.bodies_met(event)
        match self.events[event - 1] if 0 < event <= len(self.events) else None:
            case Kick(body):
                lines = [self.of("velocity", body, event)]
            case Impact(along=along) if len(met) == 2 and not isinstance(along, Unit):
                named = [name for name in self.features.names if name in met]
                lines = [self.of("velocity", name, event) for name in named] or [self.line(event)]
            case _:
                return
        for line in lines:
            angle = Quantity("angle", (line, Unit("i")))
            yield angle
            yield Binary("-", RIGHT_ANGLE, angle)
            yield Binary("-", STRAIGHT_ANGLE, angle)

    def inclinations(self, event: int) -> Iterator[Expression]:
        """The angles of velocities to the line of centres, measured either way."""
        for body in self.bodies(event):
            angle = Quantity("angle", (self.of("velocity", body, event), self.line(event)))
            yield angle
            yield Binary("-", STRAIGHT_ANGLE, angle)

    def angle_between(self, event: int) -> Expression:
        """The angle between the velocities of two spheres that meet."""
        first, second = (self.of("velocity", body, event) for body in self.bodies_met(event))
        return Quantity("angle", (first, second))

    def other_direction(self, event: int, line: Expression) -> Expression:
        """That to which an angle is measured."""
        if self.features.axis is not None:
            return self.features.axis
        named = self.features.direction or ""
        wall = self.wall(event)
        return line if "centres" in named or wall is None else wall

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
