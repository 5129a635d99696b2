"""The story of a problem, told forward: velocities, places and times after every event.

The same telling serves exact symbols and numbers of high precision, so what was solved in symbols
can be checked by telling it again in numbers. What the text leaves open and the motion needs (a
velocity before, a line of centres, a mass) becomes a *hidden* unknown; each comes with a phrase
that says what it is. While telling, the story collects

- equations, which hold whatever is asked (the law for an unknown line of centres, a sphere that
  does come to the point it is said to reach), and
- conditions, the physics that has to be possible (bodies approach before they collide, times are
  in order, coefficients lie in [0, 1]).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Literal, Protocol

import sympy as sp

from restitution import law
from restitution.errors import StatementError, UnsupportedError
from restitution.expression.evaluate import Angle, Evaluator, Numeric, Scalar, Symbolic, Value
from restitution.expression.tree import (
    AtTime,
    Expression,
    Name,
    Place,
    Quantity,
    has_quantity,
    letters,
)
from restitution.problem import (
    Arrival,
    Event,
    Impact,
    Kick,
    Let,
    Part,
    Point,
    Problem,
    Sphere,
    Wall,
)
from restitution.solve.neat import neat
from restitution.vector import Vector

Sign = Literal["positive", "real"]


class Unknowns(Protocol):
    """Where letters and hidden unknowns take their values from."""

    def letter(self, name: str) -> Value: ...

    def hidden(self, key: str, phrase: str, sign: Sign) -> Scalar: ...

    def sign(self, x: Scalar) -> int | None:
        """The sign of a scalar, or None where it depends on the letters."""


@dataclass(frozen=True)
class Condition:
    """Something that must be so: ``value > 0``, or ``>= 0``, or ``!= 0``; else ``reason``."""

    value: Scalar
    relation: Literal[">", ">=", "!="]
    reason: str
    kind: Literal["coefficient", "approach", "sign", "time", "place", "fact"] = "sign"


@dataclass(frozen=True)
class AnyOf:
    """At least one of several conditions must hold."""

    options: tuple[Condition, ...]
    reason: str
    kind: Literal["place", "fact"] = "place"


@dataclass(frozen=True)
class Equation:
    """``value`` = 0, by ``reason``; ``place`` is where the text says so."""

    value: Scalar
    reason: str
    place: Place | None = None
    fact: bool = False


@dataclass(frozen=True)
class Happening:
    """An event as it happened.

    ``centres`` is a vector along the line of centres (into a wall: along its normal) of any
    length; times ``closing``, its scalar product with the velocity of approach, it points from
    the first body to the second. ``time`` is None where nothing is known of places.
    """

    number: int
    step: Event
    before: Mapping[str, Vector]
    after: Mapping[str, Vector]
    centres: Vector | None = None
    closing: Scalar = None
    e: Scalar = None
    impulse: Vector | None = None  # on the second body, or on the body kicked; mass times that
    impulse_mass: str | None = None  # the body whose mass the impulse is still to be multiplied by
    time: Scalar = None
    unknown_line: bool = False

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of the bodies in this event."""
        step = self.step
        return (step.first, step.second) if isinstance(step, Impact) else (step.body,)

    def oriented(self) -> Vector:
        """A vector from the first body to the second."""
        assert self.centres is not None
        return self.centres * self.closing if not self.unknown_line else self.centres


@dataclass
class _Track:
    """What is known of one sphere as the story goes on."""

    velocities: list[tuple[int, Vector]]
    places: list[tuple[int, Vector, Scalar]] = field(default_factory=list)  # event, where, when


class Story:
    """The events of ``problem`` up to and with ``part``, told in one arithmetic.

    Raises StatementError for what makes no sense and UnsupportedError for what is beyond this
    package; what is not known is no error here.
    """

    def __init__(
        self,
        problem: Problem,
        part: Part,
        arithmetic: Symbolic | Numeric,
        unknowns: Unknowns,
        lets: Mapping[str, tuple[Let, int]],
    ) -> None:
        self.problem = problem
        self.field = arithmetic
        self.unknowns = unknowns
        self.spheres: dict[str, Sphere] = {each.name: each for each in problem.spheres}
        self.walls: dict[str, Wall] = {each.name: each for each in problem.walls}
        self.points: dict[str, Point] = {each.name: each for each in problem.points}
        self.equations: list[Equation] = []
        self.conditions: list[Condition | AnyOf] = []
        self.happenings: list[Happening] = []
        self._lets = lets
        self._open_lets: list[str] = []
        self._let_values: dict[str, Value] = {}
        self._masses: dict[str, Scalar] = {}
        self._normals: dict[str, Vector] = {}
        self._contacts: dict[tuple[str, str], Vector] = {}
        self._now = 0
        self._evaluators: dict[int, Evaluator] = {}
        self._tracks = {name: _Track([]) for name in self.spheres}
        for sphere in problem.spheres:
            self._start(sphere)
        parts = problem.parts[: problem.parts.index(part) + 1]
        for each in parts:
            for step in each.steps:
                if isinstance(step, Impact | Kick | Arrival):
                    self._tell(step)

    # --- reading expressions ------------------------------------------------------------------

    def evaluator(self, now: int) -> Evaluator:
        """Reads expressions as they are meant after ``now`` events."""
        if now not in self._evaluators:
            self._evaluators[now] = Evaluator(
                self.field,
                self._letter,
                lambda tree: self.quantity(tree, now),
                self._named,
                self.wall_direction,
            )
        return self._evaluators[now]

    def _letter(self, name: str) -> Value:
        if name not in self._lets:
            return self.unknowns.letter(name)
        if name not in self._let_values:
            if name in self._open_lets:
                raise StatementError(f"{name} is defined by itself")
            step, now = self._lets[name]
            if now > len(self.happenings):
                raise StatementError(
                    f"{name} is used before the event that it speaks of",
                    *_where(step.place),
                )
            self._open_lets.append(name)
            self._let_values[name] = self.evaluator(now).value(step.expression)
            self._open_lets.pop()
        return self._let_values[name]

    def _named(self, tree: Name) -> Value:
        if tree.name in self.points:
            return self.evaluator(0).vector(self.points[tree.name].position)
        if tree.name in self.walls:
            return self.wall_direction(tree)
        raise StatementError(
            f"{tree.name} is a sphere, where a vector or a number is needed", *_where(tree.place)
        )

    def _vector(self, tree: Any, what: str) -> Vector:
        """A vector property of a body."""
        x, y = self._read(tree, what, "vector")
        return Vector(x, y)

    def _read(self, tree: Any, what: str, kind: str = "scalar", now: int = 0) -> Any:
        """A property of a body: a tree, or a number put in by Python."""
        if isinstance(tree, Expression):
            evaluator = self.evaluator(now)
            return getattr(evaluator, kind)(tree)
        if kind != "scalar" and isinstance(tree, tuple | list) and len(tree) == 2:
            return Vector(*(self._read(each, what) for each in tree))
        if isinstance(tree, sp.Expr) and self.field.exact:
            return tree
        if isinstance(tree, int | float):
            return self.field.number(Fraction(repr(tree)))
        raise UnsupportedError(f"{what} is {tree!r}, which is no number, letter or text")

    # --- the start ----------------------------------------------------------------------------

    def _start(self, sphere: Sphere) -> None:
        name, track = sphere.name, self._tracks[sphere.name]
        if sphere.velocity is None:
            velocity = Vector(
                self.unknowns.hidden(f"u_{name}x", f"the velocity of {name} at the start", "real"),
                self.unknowns.hidden(f"u_{name}y", f"the velocity of {name} at the start", "real"),
            )
        else:
            velocity = self._vector(sphere.velocity, f"the velocity of {name}")
            if self.field.exact:
                velocity = self._neat(velocity)
        track.velocities.append((0, velocity))
        if sphere.position is not None:
            where = self._vector(sphere.position, f"the place of {name}")
            track.places.append((0, where, self.field.zero))

    def mass(self, name: str) -> Scalar:
        """The mass of a sphere: a hidden unknown where it is not given."""
        if name not in self._masses:
            sphere = self.spheres[name]
            if sphere.mass is None:
                self._masses[name] = self.unknowns.hidden(
                    f"m_{name}", f"the mass of {name}", "positive"
                )
            else:
                mass = self._read(sphere.mass, f"the mass of {name}")
                self._masses[name] = mass
                self.conditions.append(
                    Condition(mass, ">", f"the mass of {name} must be positive", "sign")
                )
        return self._masses[name]

    def radius(self, name: str) -> Scalar | None:
        """The radius of a sphere, or that of any other (all have one); None where negligible."""
        value = self.spheres[name].radius
        if value is None:
            value = next((s.radius for s in self.problem.spheres if s.radius is not None), None)
        return None if value is None else self._read(value, f"the radius of {name}")

    def wall_direction(self, tree: Expression) -> Vector:
        """A direction vector of a wall."""
        if not isinstance(tree, Name) or tree.name not in self.walls:
            raise StatementError("a wall is needed here", *_where(getattr(tree, "place", None)))
        wall = self.walls[tree.name]
        if wall.along is not None:
            if isinstance(wall.along, tuple | list):
                return self._vector(wall.along, f"the direction of {wall.name}")
            return self.evaluator(0).direction(wall.along)
        if wall.start is not None:
            start, end = self._vector(wall.start, ""), self._vector(wall.end, "")
            return end - start
        if wall.centre is not None:
            hit = next((h for h in reversed(self.happenings) if wall.name in h.bodies), None)
            if hit is not None and hit.centres is not None:
                return hit.centres.turned_left()
            raise StatementError(
                f"the wall {wall.name} is a circle and has no one direction", *_where(tree.place)
            )
        if wall.name in self._normals:
            return self._normals[wall.name].turned_left()
        if not self._frame_matters():
            return Vector(self.field.number(Fraction(1)), self.field.zero)
        phrase = f"the direction of the wall {wall.name}"
        p = self.unknowns.hidden(f"d_{wall.name}x", phrase, "real")
        q = self.unknowns.hidden(f"d_{wall.name}y", phrase, "real")
        self.equations.append(Equation(p * p + q * q - 1, phrase))
        self._normals[wall.name] = Vector(q, -p)
        return Vector(p, q)

    def _frame_matters(self) -> bool:
        """Whether anything but directions to the one wall fixes the axes."""
        from restitution.expression.tree import Pair, Polar, Unit, walk
        from restitution.solve.letters import trees

        if len(self.walls) != 1:
            return True
        for tree in trees(self.problem):
            for node in walk(tree):
                if isinstance(node, Unit | Pair):
                    return True
                if isinstance(node, Polar) and node.wall is None:
                    return True
                if isinstance(node, Quantity) and node.kind == "direction":
                    return True
        return False

    # --- looking things up --------------------------------------------------------------------

    def velocity(self, name: str, stage: int) -> Vector:
        """The velocity of a sphere just after event ``stage`` (0 is the start)."""
        known: list[Vector] = [v for n, v in self._tracks[name].velocities if n <= stage]
        return known[-1]

    def latest(self, name: str, now: int) -> Happening | None:
        """The latest event of a body among the first ``now``."""
        return next((h for h in reversed(self.happenings[:now]) if name in h.bodies), None)

    def _stage(self, tree: Quantity, now: int, name: str | None) -> int:
        stage = tree.stage
        if stage is None:
            return now
        if isinstance(stage, int):
            if stage > len(self.happenings):
                raise StatementError(
                    f"event {stage} is asked for, and {len(self.happenings)} "
                    f"{'is' if len(self.happenings) == 1 else 'are'} told",
                    *_where(tree.place),
                )
            return stage
        if stage == "before":
            latest = self.latest(name, now) if name is not None else None
            if latest is None:
                raise StatementError(f"no event of {name} is told yet", *_where(tree.place))
            return latest.number - 1
        raise StatementError("a time has no meaning here", *_where(tree.place))

    def _event(self, tree: Quantity, now: int, name: str | None = None) -> Happening:
        """The event that a quantity speaks of: the latest, that of a body, or by number."""
        if isinstance(tree.stage, int):
            if not 1 <= tree.stage <= len(self.happenings):
                raise StatementError(
                    f"event {tree.stage} is asked for, and {len(self.happenings)} "
                    f"{'is' if len(self.happenings) == 1 else 'are'} told",
                    *_where(tree.place),
                )
            happening = self.happenings[tree.stage - 1]
            if name is not None and name not in happening.bodies:
                raise StatementError(
                    f"{name} has no part in event {tree.stage}", *_where(tree.place)
                )
            return happening
        if name is not None:
            latest = self.latest(name, now)
        else:
            latest = self.happenings[now - 1] if now else None
        if latest is None:
            about = "no event" if name is None else f"no event of {name}"
            raise StatementError(f"{about} is told before this line", *_where(tree.place))
        return latest

    # --- quantities ---------------------------------------------------------------------------

    def quantity(self, tree: Quantity, now: int) -> Value:
        """The value of a quantity asked for after ``now`` events."""
        kind, arguments = tree.kind, tree.arguments
        evaluator = self.evaluator(now)
        body = arguments[0].name if arguments and isinstance(arguments[0], Name) else None
        match kind:
            case "velocity":
                return self.velocity(_sphere(self, tree, body), self._stage(tree, now, body))
            case "speed":
                v = self.velocity(_sphere(self, tree, body), self._stage(tree, now, body))
                return self.size(v)
            case "direction":
                if body in self.walls:
                    assert isinstance(arguments[0], Name)
                    return self.wall_direction(arguments[0])
                v = self.velocity(_sphere(self, tree, body), self._stage(tree, now, body))
                return Angle(v.x, v.y, lambda: self.field.arctan2(v.y, v.x))
            case "along" | "across":
                v = evaluator.vector(arguments[0])
                d = self.direction(arguments[1], now)
                if kind == "across":
                    d = d.turned_left()
                length = self.size(d)
                if self.field.is_zero(length):
                    raise StatementError("the zero vector has no direction", *_where(tree.place))
                return v.dot(d) / length
            case "angle":
                return self._angle(arguments[0], arguments[1], now)
            case "deflection":
                name = _sphere(self, tree, body)
                event = self._event(tree, now, name)
                return self.angle_between(event.before[name], event.after[name])
            case "impulse":
                if body is not None:
                    return self.impulse_on(_sphere(self, tree, body), self._event(tree, now, body))
                return self._impulse_size(self._event(tree, now))
            case "energy":
                names = [_sphere(self, tree, body)] if arguments else list(self.spheres)
                stage = self._stage(tree, now, body)
                return self._add(self._energy(name, stage) for name in names)
            case "energy_lost":
                return self.energy_lost(self._event(tree, now))
            case "total_energy_lost":
                upto = self._stage(tree, now, None)
                return self._add(self.energy_lost(each) for each in self.happenings[:upto])
            case "momentum":
                names = [_sphere(self, tree, body)] if arguments else list(self.spheres)
                stage = self._stage(tree, now, body)
                total = Vector(self.field.zero, self.field.zero)
                for name in names:
                    total = total + self.velocity(name, stage) * self.mass(name)
                return total
            case "line_of_centres":
                event = self._event(tree, now)
                if event.centres is None:
                    raise StatementError("this event has no line of centres", *_where(tree.place))
                along = event.oriented()
                return along / self.size(along)
            case "mass":
                return self.mass(_sphere(self, tree, body))
            case "time":
                return self._time(tree)
            case "position":
                name = _sphere(self, tree, body)
                return self._position_at(name, tree, now)
            case "distance":
                one, other = (self._point(each, tree, now) for each in arguments)
                return self.size(one - other)
            case "dot":
                return evaluator.vector(arguments[0]).dot(evaluator.vector(arguments[1]))
        raise UnsupportedError(f"the quantity {kind} is not known here", *_where(tree.place))

    def size(self, v: Vector) -> Scalar:
        """The size of a vector; exactly |x| where it lies along an axis."""
        if self.field.is_zero(v.y):
            return self.field.abs(v.x)
        if self.field.is_zero(v.x):
            return self.field.abs(v.y)
        return self.field.sqrt(v.x * v.x + v.y * v.y)

    def angle_between(self, a: Vector, b: Vector) -> Angle:
        """The angle between two vectors, 0 to 180°."""
        for each in (a, b):
            if self.field.is_zero(each.x) and self.field.is_zero(each.y):
                raise StatementError("a body at rest has no direction of motion")
        x, y = a.dot(b), self.field.abs(a.cross(b))
        return Angle(x, y, lambda: self.field.arctan2(y, x))

    def direction(self, tree: Expression, now: int) -> Vector:
        """A direction: a vector, an angle, a wall or ``line_of_centres``."""
        return self.evaluator(now).direction(tree)

    def _angle(self, left: Expression, right: Expression, now: int) -> Angle:
        a, b = self.direction(left, now), self.direction(right, now)
        angle = self.angle_between(a, b)
        if not (self._is_line(left) or self._is_line(right)):
            return angle
        x = self.field.abs(angle.x)
        return Angle(x, angle.y, lambda: self.field.arctan2(angle.y, x))

    def _is_line(self, tree: Expression) -> bool:
        """Walls and lines of centres are lines: the angle to one is at most 90°."""
        if isinstance(tree, Name):
            return tree.name in self.walls
        return isinstance(tree, Quantity) and (
            tree.kind == "line_of_centres"
            or (
                tree.kind == "direction"
                and isinstance(tree.arguments[0], Name)
                and tree.arguments[0].name in self.walls
            )
        )

    def impulse_on(self, name: str, event: Happening) -> Vector:
        """The impulse on a body in an event: a vector, in N s."""
        if isinstance(event.step, Arrival):
            return Vector(self.field.zero, self.field.zero)
        assert event.impulse is not None
        total = event.impulse
        if event.impulse_mass is not None:
            total = total * self.mass(event.impulse_mass)
        if isinstance(event.step, Impact) and name == event.step.first:
            return -total
        return total

    def _impulse_size(self, event: Happening) -> Scalar:
        vector = self.impulse_on(event.bodies[-1], event)
        if event.centres is None or event.unknown_line:
            return self.size(vector)
        return self.field.abs(vector.dot(event.centres)) / self.size(event.centres)

    def _energy(self, name: str, stage: int) -> Scalar:
        v = self.velocity(name, stage)
        return self.mass(name) * (v.x * v.x + v.y * v.y) / 2

    def energy_lost(self, event: Happening) -> Scalar:
        """Kinetic energy of all spheres lost in an event, in J."""
        step = event.step
        if isinstance(step, Impact) and event.centres is not None and not event.unknown_line:
            u1 = event.before[step.first]
            m1 = self.mass(step.first)
            if step.second in self.walls:
                zero = Vector(self.field.zero, self.field.zero)
                return m1 * self._rational(
                    law.kinetic_energy_lost(u1, zero, 1, 0, event.centres, event.e)
                )
            m2, u2 = self.mass(step.second), event.before[step.second]
            return m1 * m2 * law.kinetic_energy_lost(u1, u2, m2, m1, event.centres, event.e)
        total = self.field.zero
        for name in event.bodies:
            if name in self.spheres:
                u, v = event.before[name], event.after[name]
                total = total + self.mass(name) * (u.dot(u) - v.dot(v)) / 2
        return total

    def _add(self, values: Iterator[Scalar]) -> Scalar:
        total = self.field.zero
        for value in values:
            total = total + value
        return total

    def _rational(self, x: Scalar) -> Scalar:
        return neat(x) if self.field.exact else x

    # --- places and times ---------------------------------------------------------------------

    def _time(self, tree: Quantity) -> Scalar:
        if not isinstance(tree.stage, int):
            raise StatementError("time needs the number of an event", *_where(tree.place))
        if tree.stage == 0:
            return self.field.zero
        event = self._event(tree, len(self.happenings))
        if event.time is None:
            return self.unknowns.hidden(
                f"t_{event.number}", f"where the bodies of event {event.number} are", "positive"
            )
        return event.time

    def place(self, name: str, stage: int) -> tuple[Vector, Scalar] | None:
        """Where a sphere's centre was last known to be up to an event, and when."""
        known = [(p, t) for n, p, t in self._tracks[name].places if n <= stage]
        return known[-1] if known else None

    def _position_at(self, name: str, tree: Quantity, now: int) -> Vector:
        stage = tree.stage
        if isinstance(stage, AtTime):
            return self._position_when(name, self.evaluator(now).scalar(stage.time), now)
        n = self._stage(tree, now, name)
        known = self.place(name, n)
        if known is None:
            return self._missing_place(name)
        event = self.happenings[n - 1] if n else None
        if event is None or name in event.bodies:
            return known[0]
        if event.time is None:
            return self._missing_place(name)
        where, when = known
        moved: Vector = where + self.velocity(name, n) * (event.time - when)
        return moved

    def _position_when(self, name: str, t: Scalar, now: int) -> Vector:
        """The place at a time: on the piece of the path that the time belongs to."""
        places = [each for each in self._tracks[name].places if each[0] <= now]
        if not places:
            return self._missing_place(name)
        chosen = places[0]
        for each in places[1:]:
            sign = self.unknowns.sign(t - each[2])
            if sign is not None and sign >= 0:
                chosen = each
        n, where, when = chosen
        moved: Vector = where + self.velocity(name, n) * (t - when)
        return moved

    def _missing_place(self, name: str) -> Vector:
        phrase = f"where {name} is"
        return Vector(
            self.unknowns.hidden(f"p_{name}x", phrase, "real"),
            self.unknowns.hidden(f"p_{name}y", phrase, "real"),
        )

    def _point(self, argument: Expression, tree: Quantity, now: int) -> Vector:
        """A point, or the centre of a sphere at the stage of the quantity."""
        if isinstance(argument, Name) and argument.name in self.spheres:
            return self._position_at(
                argument.name, Quantity("position", (argument,), tree.stage, place=tree.place), now
            )
        return self.evaluator(now).vector(argument)

    # --- telling ------------------------------------------------------------------------------

    def _tell(self, step: Event) -> None:
        number = len(self.happenings) + 1
        match step:
            case Impact():
                happening = self._impact(number, step)
            case Kick():
                happening = self._kick(number, step)
            case Arrival():
                happening = self._arrival(number, step)
        self.happenings.append(happening)
        for name, velocity in happening.after.items():
            if name in self.spheres:
                self._tracks[name].velocities.append((number, velocity))

    def _neat(self, v: Vector) -> Vector:
        return Vector(neat(v.x), neat(v.y)) if self.field.exact else v

    def _kick(self, number: int, step: Kick) -> Happening:
        name = step.body
        impulse = self.evaluator(number - 1).vector(step.impulse)
        before = self.velocity(name, number - 1)
        after = self._neat(before + impulse / self.mass(name))
        known = self.place(name, number - 1)
        time = None
        if known is not None:
            n = self._tracks[name].places[-1][0]
            if n == 0 and self.field.is_zero(known[1]) and self._still(before):
                time = self.field.zero  # at rest until it is struck: the clock starts then
            else:
                time = self.unknowns.hidden(
                    f"t_{number}", f"the time of event {number}", "positive"
                )
            where = known[0] + before * (time - known[1])
            self._tracks[name].places.append((number, where, time))
        return Happening(number, step, {name: before}, {name: after}, impulse=impulse, time=time)

    def _still(self, v: Vector) -> bool:
        return self.field.is_zero(v.x) and self.field.is_zero(v.y)

    def _arrival(self, number: int, step: Arrival) -> Happening:
        name = step.body
        velocity = self.velocity(name, number - 1)
        if isinstance(step.target, Name) and step.target.name in self.walls:
            time = self._time_to_wall(number, name, self.walls[step.target.name])
        else:
            point = self.evaluator(number - 1).vector(step.target)
            time = self._time_to_point(number, name, point, step)
        return Happening(number, step, {name: velocity}, {name: velocity}, time=time)

    def _time_to_point(self, number: int, name: str, point: Vector, step: Arrival) -> Scalar:
        known = self.place(name, number - 1)
        velocity = self.velocity(name, number - 1)
        if known is None:
            time = self.unknowns.hidden(f"t_{number}", f"the time of event {number}", "positive")
        else:
            way = point - known[0]
            if self._still(velocity):
                raise StatementError(f"{name} is at rest and reaches nothing", *_where(step.place))
            flight = self._rational(way.dot(velocity) / velocity.dot(velocity))
            self._off(way.cross(velocity), f"{name} does not pass through that point", step.place)
            self._flight(name, flight, number, f"{name} moves away from that point")
            time = known[1] + flight
        self._tracks[name].places.append((number, point, time))
        return time

    def _off(self, value: Scalar, reason: str, place: Place | None) -> None:
        if not self.field.is_zero(value):
            self.equations.append(Equation(value, reason, place))

    def _flight(self, name: str, flight: Scalar, number: int, reason: str) -> None:
        """A time of flight must be positive."""
        self.conditions.append(Condition(flight, ">", reason, "time"))

    def _time_to_wall(self, number: int, name: str, wall: Wall) -> Scalar | None:
        """When a sphere comes to a wall; None where nothing is known of places."""
        known = self.place(name, number - 1)
        velocity = self.velocity(name, number - 1)
        radius = self.radius(name)
        if wall.centre is not None:
            return self._time_to_circle(number, name, wall, known, velocity, radius)
        origin = wall.through if wall.through is not None else wall.start
        if known is None:
            return None
        if origin is None:
            time = self.unknowns.hidden(
                f"t_{number}", f"the place of the wall {wall.name}", "positive"
            )
            where = known[0] + velocity * (time - known[1])
            self._flight(name, time - known[1], number, "times must be in order")
            self._tracks[name].places.append((number, where, time))
            return time
        through = self._vector(origin, f"the place of {wall.name}")
        along = self.wall_direction(Name(wall.name))
        normal = along.turned_left()
        gap = normal.dot(known[0] - through)
        speed = normal.dot(velocity)
        if self.field.is_zero(speed):
            raise StatementError(f"{name} moves parallel to {wall.name} and does not reach it")
        if radius is not None:
            side = self.unknowns.sign(gap)
            if side in (None, 0):
                side = -(self.unknowns.sign(speed) or 1)
            gap = gap - side * radius * self.size(normal)
        flight = self._rational(-gap / speed)
        self._flight(name, flight, number, f"{name} moves away from {wall.name}")
        where = known[0] + velocity * flight
        if self.field.exact:
            where = self._neat(where)
        if wall.start is not None:
            end = self._vector(wall.end, f"the end of {wall.name}")
            share = self._rational((where - through).dot(along))
            reason = f"{name} passes the end of {wall.name}"
            self.conditions.append(Condition(share, ">", reason, "place"))
            self.conditions.append(Condition(along.dot(along) - share, ">", reason, "place"))
            del end
        self._nothing_first(name, wall, known[0], velocity, flight, number)
        time = known[1] + flight
        self._tracks[name].places.append((number, where, time))
        return time

    def _nothing_first(
        self,
        name: str,
        target: Wall | None,
        start: Vector,
        velocity: Vector,
        flight: Scalar,
        number: int,
    ) -> None:
        """No other wall whose place is known is struck before."""
        radius = self.radius(name)
        left = self.latest(name, number - 1)
        for wall in self.walls.values():
            origin = wall.through if wall.through is not None else wall.start
            if wall is target or origin is None:
                continue
            if left is not None and wall.name in left.bodies:
                continue  # it has just left that wall
            through = self._vector(origin, "")
            along = self.wall_direction(Name(wall.name))
            normal = along.turned_left()
            gap, speed = normal.dot(start - through), normal.dot(velocity)
            if self.field.is_zero(speed):
                continue
            if radius is not None:
                side = self.unknowns.sign(gap)
                if side in (None, 0):
                    side = -(self.unknowns.sign(speed) or 1)
                gap = gap - side * radius * self.size(normal)
            crossing = self._rational(-gap / speed)
            reason = f"{name} strikes {wall.name} first"
            options = [
                Condition(-crossing, ">=", reason, "place"),
                Condition(crossing - flight, ">", reason, "place"),
            ]
            if wall.start is not None:
                share = self._rational((start + velocity * crossing - through).dot(along))
                options.append(Condition(-share, ">=", reason, "place"))
                options.append(Condition(share - along.dot(along), ">=", reason, "place"))
            self.conditions.append(AnyOf(tuple(options), reason))

    def _time_to_circle(
        self,
        number: int,
        name: str,
        wall: Wall,
        known: tuple[Vector, Scalar] | None,
        velocity: Vector,
        radius: Scalar | None,
    ) -> Scalar | None:
        centre = self._vector(wall.centre, f"the centre of {wall.name}")
        size = self._read(wall.radius, f"the radius of {wall.name}")
        if known is None:
            return None
        out = known[0] - centre
        square = self._rational(out.dot(out))
        inside = self.unknowns.sign(square - size * size)
        reach = size
        if radius is not None:
            reach = size + radius if inside == 1 else size - radius
        excess = self._rational(square - reach * reach)
        vv, ov = velocity.dot(velocity), out.dot(velocity)
        if self._still(velocity):
            raise StatementError(f"{name} is at rest and does not reach {wall.name}")
        left = self.latest(name, number - 1)
        if self.field.is_zero(excess) or (left is not None and wall.name in left.bodies):
            flight = -2 * ov / vv
        else:
            under = self._rational(ov * ov - vv * excess)
            self.conditions.append(Condition(under, ">", f"{name} passes by {wall.name}", "place"))
            depth = self.field.sqrt(under)
            flight = (-ov - depth) / vv if inside == 1 else (-ov + depth) / vv
        flight = self._rational(flight)
        self._flight(name, flight, number, f"{name} moves away from {wall.name}")
        where = known[0] + velocity * flight
        if self.field.exact:
            where = self._neat(where)
        self._nothing_first(name, wall, known[0], velocity, flight, number)
        time = known[1] + flight
        self._tracks[name].places.append((number, where, time))
        return time

    # --- impacts ------------------------------------------------------------------------------

    def _impact(self, number: int, step: Impact) -> Happening:
        if step.second in self.walls:
            return self._impact_with_wall(number, step)
        return self._impact_of_spheres(number, step)

    def _coefficient(self, number: int, step: Impact) -> Scalar:
        e = self._letter("e") if step.e is None else self.evaluator(number - 1).scalar(step.e)
        reason = "a coefficient of restitution lies in [0, 1]"
        one = self.field.number(Fraction(1))
        self.conditions.append(Condition(e, ">=", reason, "coefficient"))
        self.conditions.append(Condition(one - e, ">=", reason, "coefficient"))
        return e

    def _approach(
        self,
        key: tuple[str, str],
        u: Vector,
        c: Vector,
        closing: Scalar,
        unknown: bool,
        what: str,
        own: Scalar = None,
    ) -> None:
        """The bodies must approach; if they met before on the same line, from the same side.

        ``own`` is the first body's component along c where nothing else tells which side the
        second is on: A hits B, so B lies on the side to which A moves.
        """
        earlier = self._contacts.get(key)
        if (
            not unknown
            and (earlier is None or not self._same_line(earlier, c))
            and own is not None
            and not self.field.is_zero(own)
        ):
            self.conditions.append(Condition(own * closing, ">", what, "approach"))
        elif unknown:
            self.conditions.append(Condition(closing, ">", what, "approach"))
        elif earlier is not None and self._same_line(earlier, c):
            self.conditions.append(Condition(u.dot(earlier), ">", what, "approach"))
        else:
            self.conditions.append(Condition(closing, "!=", what, "approach"))
        oriented = c if unknown else c * closing
        self._contacts[key] = oriented
        self._contacts[key[1], key[0]] = -oriented

    def _same_line(self, a: Vector, b: Vector) -> bool:
        cross = a.cross(b)
        if self.field.exact:
            cross = neat(cross)
        return self.field.is_zero(cross)

    def _impact_with_wall(self, number: int, step: Impact) -> Happening:
        name, wall = step.first, self.walls[step.second]
        u = self.velocity(name, number - 1)
        e = self._coefficient(number, step)
        time = self._time_to_wall(number, name, wall)
        zero = Vector(self.field.zero, self.field.zero)
        unknown = False
        if wall.centre is not None:
            known = self.place(name, number)
            if known is not None and self._tracks[name].places[-1][0] == number:
                c = known[0] - self._vector(wall.centre, "")
            else:
                phrase = f"the place where {name} strikes {wall.name}"
                c = Vector(
                    self.unknowns.hidden(f"n_{number}x", phrase, "real"),
                    self.unknowns.hidden(f"n_{number}y", phrase, "real"),
                )
                self.equations.append(Equation(c.dot(c) - 1, phrase))
        elif (
            wall.along is None
            and wall.start is None
            and wall.name not in self._normals
            and self._frame_matters()
        ):
            # The change of velocity itself is along the normal: linear in what is unknown.
            phrase = f"the direction of the wall {wall.name}"
            c = Vector(
                self.unknowns.hidden(f"k_{number}x", phrase, "real"),
                self.unknowns.hidden(f"k_{number}y", phrase, "real"),
            )
            unknown = True
            self._normals[wall.name] = c
        elif wall.name in self._normals and wall.along is None and wall.start is None:
            c = self._normals[wall.name]
        else:
            c = -self.wall_direction(Name(wall.name)).turned_left()
        closing = self._rational(u.dot(c))
        what = f"{name} is moving away from {wall.name}, or along it"
        self._approach((name, wall.name), u, c, closing, unknown, what)
        if unknown:
            v, push = self._neat(u - c), c
            self.equations.append(
                Equation(c.dot(c) - (1 + e) * closing, "Newton's experimental law")
            )
        else:
            v = self._neat(law.impact(u, zero, 1, 0, c, e)[0])
            push = self._neat(law.impulse(u, zero, 1, 0, c, e))
        return Happening(
            number,
            step,
            {name: u},
            {name: v},
            centres=c,
            closing=closing,
            e=e,
            impulse=push,
            impulse_mass=name,
            time=time,
            unknown_line=unknown,
        )

    def _impact_of_spheres(self, number: int, step: Impact) -> Happening:
        first, second = step.first, step.second
        u1, u2 = self.velocity(first, number - 1), self.velocity(second, number - 1)
        m1, m2 = self.mass(first), self.mass(second)
        e = self._coefficient(number, step)
        approach = u1 - u2
        time, geometric = self._meeting(number, step, approach)
        unknown = False
        if step.along is not None:
            c = self.direction(step.along, number - 1)
        elif step.offset is not None:
            c = self._by_offset(number, step, approach)
        elif geometric is not None:
            c = geometric
        else:
            phrase = f"the line of centres of {first} and {second}"
            c = Vector(
                self.unknowns.hidden(f"k_{number}x", phrase, "real"),
                self.unknowns.hidden(f"k_{number}y", phrase, "real"),
            )
            unknown = True
        closing = self._rational(approach.dot(c))
        what = f"{first} and {second} are separating along the line of centres"
        placed = time is not None and self._meeting_time(number) is not None
        own = self._rational(u1.dot(c)) if step.along is not None and not placed else None
        self._approach((first, second), approach, c, closing, unknown, what, own)
        if unknown:
            # The impulse itself is along the line of centres: linear in what is unknown.
            v1, v2 = self._neat(u1 - c / m1), self._neat(u2 + c / m2)
            push = c
            self.equations.append(
                Equation(
                    c.dot(c) * (m1 + m2) - (1 + e) * closing * m1 * m2,
                    "Newton's experimental law",
                )
            )
        else:
            # Inverse masses matter up to a factor: m2 and m1 serve, and keep fractions out.
            v1, v2 = law.impact(u1, u2, m2, m1, c, e)
            v1, v2 = self._neat(v1), self._neat(v2)
            push = self._neat(law.impulse(u1, u2, m2, m1, c, e) * (m1 * m2))
        self._place_after_meeting(number, step, c, closing, unknown, time)
        return Happening(
            number,
            step,
            {first: u1, second: u2},
            {first: v1, second: v2},
            centres=c,
            closing=closing,
            e=e,
            impulse=push,
            time=time if time is not None else self._meeting_time(number),
            unknown_line=unknown,
        )

    def _meeting_time(self, number: int) -> Scalar | None:
        for track in self._tracks.values():
            if track.places and track.places[-1][0] == number:
                return track.places[-1][2]
        return None

    def _by_offset(self, number: int, step: Impact, approach: Vector) -> Vector:
        """The line of centres makes arcsin(d/2r) with the relative path."""
        assert step.offset is not None
        d = self.evaluator(number - 1).scalar(step.offset)
        r = self.radius(step.first)
        if r is None:
            r = self.unknowns.hidden("r", f"the radius of {step.first}", "positive")
        under = 4 * r * r - d * d
        if self.field.exact:
            under = sp.expand(under)
        what = f"the offset must be less than 2r, or {step.first} passes {step.second}"
        self.conditions.append(Condition(under, ">", what, "place"))
        c = approach * self.field.sqrt(under) + approach.turned_left() * d
        return self._neat(c)

    def _meeting(
        self, number: int, step: Impact, approach: Vector
    ) -> tuple[Scalar | None, Vector | None]:
        """When two spheres with known places meet, and the line of centres if they have size."""
        one, other = (self.place(name, number - 1) for name in (step.first, step.second))
        if one is None or other is None:
            return self._meeting_half_known(number, step, one, other), None
        start = self._later(one[1], other[1])
        v1, v2 = (self.velocity(name, number - 1) for name in (step.first, step.second))
        p1, p2 = one[0] + v1 * (start - one[1]), other[0] + v2 * (start - other[1])
        gap = p2 - p1
        if self.field.exact:
            gap = self._neat(gap)
        r = self.radius(step.first)
        ww = approach.dot(approach)
        if self._still(approach):
            raise StatementError(
                f"{step.first} and {step.second} keep their distance", *_where(step.place)
            )
        if r is None:
            flight = gap.dot(approach) / ww
            self._off(
                self._rational(gap.cross(approach)),
                f"{step.first} and {step.second} do not meet",
                step.place,
            )
            c = None
        elif step.along is not None:
            along = self.direction(step.along, number - 1)
            length = self.size(along)
            sign = self.unknowns.sign(approach.dot(along)) or 1
            reach = along * (sign * 2 * r / length)
            way = gap - reach
            flight = way.dot(approach) / ww
            self._off(
                self._rational(way.cross(approach)),
                f"{step.first} and {step.second} do not meet on that line of centres",
                step.place,
            )
            c = None
        else:
            ga = gap.dot(approach)
            under = ga * ga - ww * (gap.dot(gap) - 4 * r * r)
            if self.field.exact:
                under = neat(under)
            self.conditions.append(
                Condition(
                    under, ">", f"{step.first} passes {step.second} without touching it", "place"
                )
            )
            flight = (ga - self.field.sqrt(under)) / ww
            c = self._neat(gap - approach * flight)
        flight = self._rational(flight)
        self.conditions.append(
            Condition(flight, ">", f"{step.first} and {step.second} are separating", "time")
        )
        time = start + flight
        for name, known, v in ((step.first, one, v1), (step.second, other, v2)):
            where = known[0] + v * (time - known[1])
            self._nothing_first(name, None, known[0], v, time - known[1], number)
            self._tracks[name].places.append((number, self._neat(where), time))
        return time, c

    def _later(self, a: Scalar, b: Scalar) -> Scalar:
        sign = self.unknowns.sign(a - b)
        return a if sign is None or sign >= 0 else b

    def _meeting_half_known(
        self,
        number: int,
        step: Impact,
        one: tuple[Vector, Scalar] | None,
        other: tuple[Vector, Scalar] | None,
    ) -> Scalar | None:
        if one is None and other is None:
            placed = any(track.places for track in self._tracks.values())
            fixed = any(
                w.through is not None or w.start is not None or w.centre is not None
                for w in self.problem.walls
            )
            if number == 1 and not placed and not fixed:
                return self.field.zero
            return None
        known = one if one is not None else other
        name = step.first if one is not None else step.second
        assert known is not None
        if self._still(self.velocity(name, number - 1)) and number == 1:
            time = self.unknowns.hidden(f"t_{number}", f"the time of event {number}", "positive")
            return time
        time = self.unknowns.hidden(f"t_{number}", f"the time of event {number}", "positive")
        return time

    def _place_after_meeting(
        self,
        number: int,
        step: Impact,
        c: Vector,
        closing: Scalar,
        unknown: bool,
        time: Scalar | None,
    ) -> None:
        """Where the other centre is, when one is known."""
        tracks = self._tracks[step.first], self._tracks[step.second]
        if time is None or any(t.places and t.places[-1][0] == number for t in tracks):
            return
        r = self.radius(step.first)
        if r is None:
            apart = Vector(self.field.zero, self.field.zero)
        else:
            oriented = c if unknown else c * closing
            sign = self.unknowns.sign(closing) if not unknown else 1
            if sign in (1, -1) and not unknown:
                oriented = c * sign
            apart = oriented * (2 * r / self.size(oriented))
            if self.field.exact:
                apart = self._neat(apart)
        one, other = (self.place(name, number - 1) for name in (step.first, step.second))
        if one is not None:
            v = self.velocity(step.first, number - 1)
            where = one[0] + v * (time - one[1])
        elif other is not None:
            v = self.velocity(step.second, number - 1)
            where = other[0] + v * (time - other[1]) - apart
        else:
            where = Vector(self.field.zero, self.field.zero)
        tracks[0].places.append((number, where, time))
        tracks[1].places.append((number, where + apart, time))


def lets_of(problem: Problem, part: Part) -> dict[str, tuple[Let, int]]:
    """The names in force in a part, each with the number of events told before its line."""
    found: dict[str, tuple[Let, int]] = {}
    now = 0
    for each in problem.parts[: problem.parts.index(part) + 1]:
        for step in each.steps:
            if isinstance(step, Impact | Kick | Arrival):
                now += 1
            elif isinstance(step, Let) and (each.label is None or each is part):
                found[step.letter] = (step, now)
    return found


def letters_at_start(problem: Problem) -> frozenset[str]:
    """The letters in the data of the bodies."""
    found: set[str] = set()
    for body in (*problem.spheres, *problem.walls):
        for value in vars(body).values():
            if isinstance(value, Expression) and not has_quantity(value):
                found |= letters(value)
    return frozenset(found)


def _sphere(story: Story, tree: Quantity, name: str | None) -> str:
    if name is None or name not in story.spheres:
        raise StatementError(f"{tree.kind}(…) needs the name of a sphere", *_where(tree.place))
    return name


def _where(place: Place | None) -> tuple[int | None, int | None]:
    return (None, None) if place is None else (place.line, place.column)


StoryMaker = Callable[[Symbolic | Numeric, Unknowns], Story]
