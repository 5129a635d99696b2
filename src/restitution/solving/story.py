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

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any, Literal, Protocol

import sympy as sp

from restitution import law, work
from restitution.errors import ImpossibleError, StatementError, UnsupportedError
from restitution.expression.evaluate import Evaluator, Numeric, Scalar, Symbolic, Value
from restitution.expression.tree import (
    AtTime,
    Expression,
    Letter,
    Name,
    Pair,
    Polar,
    Quantity,
    Unit,
    letters,
    line_and_column,
    walk,
)
from restitution.problem import (
    Arrival,
    Event,
    Find,
    Impact,
    Kick,
    Let,
    Part,
    Point,
    Problem,
    Show,
    Sphere,
    Wall,
    trees,
    trees_of_step,
)
from restitution.shapes import Circle, Line, Segment, Shape
from restitution.solving import bodies, contacts, places, quantities
from restitution.solving.alteration import AlteredLaws
from restitution.solving.conditions import AnyOf, Condition, Equation
from restitution.solving.neat import neat
from restitution.vector import Vector

Sign = Literal["positive", "real"]


class Unknowns(Protocol):
    """Where letters and hidden unknowns take their values from."""

    def letter(self, name: str) -> Value: ...

    def hidden(self, key: str, phrase: str, sign: Sign) -> Scalar: ...

    def sign(self, x: Scalar, given: Sequence[Condition | AnyOf] = ()) -> int | None:
        """The sign of a scalar where some conditions hold; None where it depends on the letters."""


class Frames(Protocol):
    """Frames in which the impacts of a story are told, in place of the law's velocities alone."""

    def standing(self, story: Story, number: int, step: Impact) -> Mapping[str, Standing]:
        """The velocities, and places if known, by which the line of centres is worked out."""

    def resolved(self, story: Story, happening: Happening) -> Happening:
        """An impact with the velocities after it in components of one's own."""


@dataclass(frozen=True)
class Standing:
    """A sphere before an impact: its velocity, and where it is and since when, if that is known."""

    velocity: Vector
    place: tuple[Vector, Scalar] | None


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
    altered: bool = False  # other equations than the laws hold

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
    # After which event, where and when; None for where is "no longer known".
    places: list[tuple[int, Any, Scalar]] = field(default_factory=list)


class Story:
    """The events of ``problem`` up to and with ``part``, told in one arithmetic.

    With ``frames`` the velocities after each impact are told in components of these.
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
        frames: Frames | None = None,
    ) -> None:
        work.spend()
        self.problem = problem
        self.frames = frames
        self.field = arithmetic
        self.unknowns = unknowns
        self.spheres: dict[str, Sphere] = {each.name: each for each in problem.spheres}
        self.walls: dict[str, Wall] = {wall.name: wall for wall in problem.walls}
        self.points: dict[str, Point] = {point.name: point for point in problem.points}
        self.equations: list[Equation] = []
        self.conditions: list[Condition | AnyOf] = []
        self.happenings: list[Happening] = []
        self.fault: ImpossibleError | None = None  # proved, and worse than a clash of facts
        # Velocities just before events to whose places, being sought, they lead.
        self.arriving: dict[tuple[int, str], Vector] = {}
        self.altered_laws: dict[int, AlteredLaws] = {}
        self.needs_numbers = False  # something is asked that formulas do not say, or not for all
        self.implied = False  # places are counted from the first impact, as the text gives none
        self.lets = lets
        self._open_lets: list[str] = []
        self._let_values: dict[str, Value] = {}
        self._masses: dict[str, Scalar] = {}
        self._normals: dict[str, Vector] = {}
        self._contacts: dict[tuple[str, str], Vector] = {}
        self._now = 0
        self._evaluators: dict[int, Evaluator] = {}
        self.tracks = {name: _Track([]) for name in self.spheres}
        # What holds of these values holds of the statement, and not of one of several roots.
        known = getattr(unknowns, "values", {})
        self._of_statement = arithmetic.exact and known.keys() <= bodies.fixed_letters(
            problem, part
        )
        if self._of_statement:
            bodies.require_bodies(self)
        self._sizes()
        for sphere in problem.spheres:
            self._start(sphere)
        for step, _, _ in problem.timeline(part):
            if isinstance(step, Event):
                self.tell(step)

    # --- reading expressions ------------------------------------------------------------------

    def evaluator(self, now: int) -> Evaluator:
        """Reads expressions as they are meant after ``now`` events."""
        if now not in self._evaluators:
            self._evaluators[now] = Evaluator(
                self.field,
                self._letter,
                lambda tree: quantities.quantity(self, tree, now),
                self._named,
                self.wall_direction,
            )
        return self._evaluators[now]

    def _letter(self, name: str) -> Value:
        if name not in self.lets:
            return self.unknowns.letter(name)
        if name not in self._let_values:
            if name in self._open_lets:
                raise StatementError(f"{name} is defined by itself")
            step, now = self.lets[name]
            if now > len(self.happenings):
                raise StatementError(
                    f"{name} is used before the event that it speaks of",
                    *line_and_column(step.place),
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
            f"{tree.name} is a sphere, where a vector or a number is needed",
            *line_and_column(tree.place),
        )

    def read_vector(self, tree: Any, what: str) -> Vector:
        """A vector property of a body."""
        x, y = self.read(tree, what, "vector")
        return Vector(x, y)

    def read(self, tree: Any, what: str, kind: str = "scalar", now: int = 0) -> Any:
        """A property of a body: a tree, or a number put in by Python."""
        if isinstance(tree, Expression):
            evaluator = self.evaluator(now)
            return getattr(evaluator, kind)(tree)
        if kind != "scalar" and isinstance(tree, tuple | list) and len(tree) == 2:
            return Vector(*(self.read(each, what) for each in tree))
        if isinstance(tree, sp.Expr) and self.field.exact:
            return tree
        if isinstance(tree, int | float):
            return self.field.number(Fraction(repr(tree)))
        raise UnsupportedError(f"{what} is {tree!r}, which is no number, letter or text")

    # --- the start ----------------------------------------------------------------------------

    def _start(self, sphere: Sphere) -> None:
        name, track = sphere.name, self.tracks[sphere.name]
        if sphere.velocity is None:
            velocity = Vector(
                self.unknowns.hidden(f"u_{name}x", f"the velocity of {name} at the start", "real"),
                self.unknowns.hidden(f"u_{name}y", f"the velocity of {name} at the start", "real"),
            )
        else:
            velocity = self.read_vector(sphere.velocity, f"the velocity of {name}")
            if self.field.exact:
                velocity = self.neat(velocity)
        track.velocities.append((0, velocity))
        if sphere.position is not None:
            where = self.read_vector(sphere.position, f"the place of {name}")
            track.places.append((0, where, self.field.zero))

    def _sizes(self) -> None:
        """Radii are positive, and all spheres have one. Raises ImpossibleError for two."""
        radii = {
            sphere.name: self.read(sphere.radius, f"the radius of {sphere.name}")
            for sphere in self.problem.spheres
            if sphere.radius is not None and not _in_lets(sphere.radius, self.lets)
        }
        for name, radius in radii.items():
            what = f"the radius of {name} must be positive"
            self.conditions.append(Condition(radius, ">", what, "sign"))
        for wall in self.problem.walls:
            if wall.radius is not None and not _in_lets(wall.radius, self.lets):
                what = f"the radius of {wall.name}"
                radius = self.read(wall.radius, what)
                self.conditions.append(Condition(radius, ">", f"{what} must be positive", "sign"))
        for (one, r), (other, s) in pairwise(radii.items()):
            if not self.field.is_zero(self.rational(r - s)):
                sizes = (f"{one} has {r}", f"{other} has {s}") if self.field.exact else ()
                listed_sizes = f": {', '.join(sizes)}" if sizes else ""
                raise ImpossibleError(f"all spheres have one radius{listed_sizes}")

    def mass(self, name: str) -> Scalar:
        """The mass of a sphere: a hidden unknown where it is not given."""
        if name not in self._masses:
            sphere = self.spheres[name]
            if sphere.mass is None:
                self._masses[name] = self.unknowns.hidden(
                    f"m_{name}", f"the mass of {name}", "positive"
                )
            else:
                mass = self.read(sphere.mass, f"the mass of {name}")
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
        return None if value is None else self.read(value, f"the radius of {name}")

    def shape(self, wall: str) -> Shape:
        """Where a wall is, with the vectors of its places; a direction stays as it is given."""
        return self.walls[wall].shape.read(wall, self.read_vector, self.read)

    def circle(self, wall: str) -> Circle:
        """A circular wall, with the vector of its centre and its radius."""
        shape = self.shape(wall)
        assert isinstance(shape, Circle)
        return shape

    def wall_direction(self, tree: Expression) -> Vector:
        """A direction vector of a wall."""
        if not isinstance(tree, Name) or tree.name not in self.walls:
            raise StatementError(
                "a wall is needed here", *line_and_column(getattr(tree, "place", None))
            )
        name = tree.name
        match self.walls[name].shape:
            case Line(None):
                return self._sought_direction(name)
            case Line(tuple() | list() as along):
                return self.read_vector(along, f"the direction of {name}")
            case Line(along):
                return self.evaluator(0).direction(along)
            case Segment(start, end):
                return self.read_vector(end, "") - self.read_vector(start, "")
            case Circle():
                return self._tangent(name, tree.place)

    def _tangent(self, name: str, place: Any) -> Vector:
        """The tangent of a circular wall where it was struck last."""
        hit = next((h for h in reversed(self.happenings) if name in h.bodies), None)
        if hit is not None and hit.centres is not None:
            return hit.centres.turned_left()
        raise StatementError(
            f"the wall {name} is a circle and has no one direction", *line_and_column(place)
        )

    def _sought_direction(self, name: str) -> Vector:
        """The direction of a wall of which none is given: hidden unknowns, where it matters."""
        if name in self._normals:
            return self._normals[name].turned_left()
        if not self._frame_matters():
            return Vector(self.field.number(Fraction(1)), self.field.zero)
        phrase = f"the direction of the wall {name}"
        p = self.unknowns.hidden(f"d_{name}x", phrase, "real")
        q = self.unknowns.hidden(f"d_{name}y", phrase, "real")
        self.equations.append(Equation(p * p + q * q - 1, phrase, kind="direction"))
        self._normals[name] = Vector(q, -p)
        return Vector(p, q)

    def _frame_matters(self) -> bool:
        """Whether anything but directions to the one wall fixes the axes."""
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

    @cached_property
    def open_times(self) -> frozenset[str]:
        """Letters that stand for a time, as in ``at t``, and of which no fact speaks."""
        inside: set[str] = set()
        outside: set[str] = set()
        asked = {
            id(t)
            for _, s in self.problem.steps()
            if isinstance(s, Find | Show)
            for t in trees_of_step(s)
        }
        for tree in trees(self.problem):
            times = [
                node
                for each in walk(tree)
                if isinstance(each, Quantity) and isinstance(each.stage, AtTime)
                for node in walk(each.stage.time)
            ]
            inside |= {time.name for time in times if isinstance(time, Letter)}
            if id(tree) not in asked:
                within = {id(time) for time in times}
                outside |= {
                    each.name
                    for each in walk(tree)
                    if isinstance(each, Letter) and id(each) not in within
                }
        return frozenset(inside - outside)

    # --- looking things up --------------------------------------------------------------------

    def velocity(self, name: str, stage: int) -> Vector:
        """The velocity of a sphere just after event ``stage`` (0 is the start)."""
        known: list[Vector] = [v for n, v in self.tracks[name].velocities if n <= stage]
        return known[-1]

    def latest(self, name: str, now: int) -> Happening | None:
        """The latest event of a body among the first ``now``."""
        return next((h for h in reversed(self.happenings[:now]) if name in h.bodies), None)

    # --- quantities ---------------------------------------------------------------------------

    def size(self, v: Vector) -> Scalar:
        """The size of a vector; exactly |x| where it lies along an axis."""
        if self.field.is_zero(v.y):
            return self.field.abs(v.x)
        if self.field.is_zero(v.x):
            return self.field.abs(v.y)
        return self.field.sqrt(v.x * v.x + v.y * v.y)

    def sign(self, x: Scalar) -> int | None:
        """The sign of a scalar in all that is possible so far; None where the letters decide."""
        return self.unknowns.sign(x, self.conditions)

    def direction(self, tree: Expression, now: int) -> Vector:
        """A direction: a vector, an angle, a wall or ``line_of_centres``."""
        return self.evaluator(now).direction(tree)

    def rational(self, x: Scalar) -> Scalar:
        return neat(x) if self.field.exact else x

    def place(self, name: str, stage: int) -> tuple[Vector, Scalar] | None:
        """Where a sphere's centre was last known to be up to an event, and when."""
        known = [(p, t) for n, p, t in self.tracks[name].places if n <= stage]
        return known[-1] if known and known[-1][0] is not None else None

    def has_derived_normal(self, wall: str) -> bool:
        """Whether the direction of a wall follows from the story and not from its own line."""
        return wall in self._normals

    def turn_wall(self, wall: str, normal: Vector) -> None:
        """Puts another normal in the place of one that follows from the story."""
        self._normals[wall] = normal

    # --- telling ------------------------------------------------------------------------------

    def tell(self, step: Event) -> None:
        """Goes on with the next event, by the values that tracks and walls have now."""
        number = len(self.happenings) + 1
        match step:
            case Impact():
                try:
                    happening = self._in_frames(number, step)
                except ImpossibleError as error:
                    raise self.fault or error from None
            case Kick():
                happening = self._kick(number, step)
            case Arrival():
                happening = self._arrival(number, step)
        self.happenings.append(happening)
        if self.frames is not None and isinstance(step, Impact):
            happening = self.frames.resolved(self, happening)
            self.happenings[-1] = happening
        for name, velocity in happening.after.items():
            if name in self.spheres:
                self.tracks[name].velocities.append((number, velocity))

    def _in_frames(self, number: int, step: Impact) -> Happening:
        """An impact by the values in which it stands in its frame, with the velocities as told."""
        if self.frames is None:
            return self._impact(number, step)
        standing = self.frames.standing(self, number, step)
        latest = {name: self.tracks[name].velocities[-1] for name in standing}
        for name, each in standing.items():
            track = self.tracks[name]
            track.velocities[-1] = (latest[name][0], each.velocity)
            if track.places and each.place is not None:
                track.places[-1] = (track.places[-1][0], *each.place)
        happening = self._impact(number, step)
        for name, velocity in latest.items():
            self.tracks[name].velocities[-1] = velocity
        before = {name: velocity for name, (_, velocity) in latest.items()}
        return replace(happening, before={**happening.before, **before})

    def neat(self, v: Vector) -> Vector:
        return Vector(neat(v.x), neat(v.y)) if self.field.exact else v

    def _kick(self, number: int, step: Kick) -> Happening:
        name = step.body
        impulse = self.evaluator(number - 1).vector(step.impulse)
        before = self.velocity(name, number - 1)
        after = self.neat(before + impulse / self.mass(name))
        known = None if self.implied else self.place(name, number - 1)
        time = None
        if self.implied:
            self.tracks[name].places.append((number, None, None))
        if known is not None:
            n = self.tracks[name].places[-1][0]
            if n == 0 and self.field.is_zero(known[1]) and self.still(before):
                time = self.field.zero  # at rest until it is struck: the clock starts then
            else:
                time = self.unknowns.hidden(
                    f"t_{number}", f"the time of event {number}", "positive"
                )
            where = known[0] + before * (time - known[1])
            self.tracks[name].places.append((number, where, time))
        return Happening(number, step, {name: before}, {name: after}, impulse=impulse, time=time)

    def real_root(self, under: Scalar, reason: str) -> Scalar:
        """A square root that has to be real: raises ImpossibleError, with the reason, if not."""
        negative = under.is_negative if self.field.exact else under < 0
        if negative:
            raise ImpossibleError(reason)
        return self.field.sqrt(under)

    def still(self, v: Vector) -> bool:
        return self.field.is_zero(v.x) and self.field.is_zero(v.y)

    def _arrival(self, number: int, step: Arrival) -> Happening:
        name = step.body
        velocity = self.velocity(name, number - 1)
        if isinstance(step.target, Name) and step.target.name in self.walls:
            time = places.time_to_wall(self, number, name, self.walls[step.target.name])
        else:
            point = self.evaluator(number - 1).vector(step.target)
            time = places.time_to_point(self, number, name, point, step)
        return Happening(number, step, {name: velocity}, {name: velocity}, time=time)

    # --- impacts ------------------------------------------------------------------------------

    def _impact(self, number: int, step: Impact) -> Happening:
        if step.second in self.walls:
            return self._impact_with_wall(number, step)
        return self._impact_of_spheres(number, step)

    def _coefficient(self, number: int, step: Impact) -> Scalar:
        e = self._letter("e") if step.e is None else self.evaluator(number - 1).scalar(step.e)
        reason = "a coefficient of restitution lies in [0, 1]"
        one = self.field.number(Fraction(1))
        if bodies.coefficient_outside(step):
            self.conditions.append(Condition(-one, ">=", reason, "coefficient"))
            if self.field.exact:
                self.fault = self.fault or bodies.impossible_coefficient(step)
            return e
        if self._of_statement and e.free_symbols and (e.is_negative or (e - 1).is_positive):
            raise bodies.impossible_coefficient(step)
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
        if not unknown and earlier is None and own is not None and not self.field.is_zero(own):
            self.conditions.append(Condition(own * closing, ">", what, "approach"))
        elif unknown:
            self.conditions.append(Condition(closing, ">", what, "approach"))
        elif earlier is not None and self._same_line(earlier, c) and self._held(key, u, c):
            self.conditions.append(Condition(u.dot(earlier), ">", what, "approach"))
        else:
            self.conditions.append(Condition(closing, "!=", what, "approach"))
        oriented = c if unknown else c * closing
        self._contacts[key] = oriented
        self._contacts[key[1], key[0]] = -oriented

    def _held(self, key: tuple[str, str], u: Vector, c: Vector) -> bool:
        """Whether two bodies that met are still in the same order along their line.

        They are if nothing happened to either since, if one is a wall, or if they move, one
        relative to the other, along that line alone: else they may have passed each other.
        """
        if key[1] in self.walls:
            return True
        last = next(
            number
            for number, event in reversed(list(enumerate(self.happenings)))
            if set(event.bodies) == set(key)
        )
        between = self.happenings[last + 1 :]
        if not any(set(event.bodies) & set(key) for event in between):
            return True
        return self._same_line(u, c)

    def _same_line(self, a: Vector, b: Vector) -> bool:
        cross = a.cross(b)
        if self.field.exact:
            cross = neat(cross)
        return self.field.is_zero(cross)

    def _impact_with_wall(self, number: int, step: Impact) -> Happening:
        name, wall = step.first, self.walls[step.second]
        u = self.velocity(name, number - 1)
        if self.spheres[name].mass is not None:
            self.mass(name)  # no matter for the velocity, but it has to be positive
        e = self._coefficient(number, step)
        time = places.time_to_wall(self, number, name, wall)
        zero = Vector(self.field.zero, self.field.zero)
        unknown = False
        shape = wall.shape
        if isinstance(shape, Circle):
            self._contacts.pop((name, wall.name), None)  # it may be struck on its other side
            known = self.place(name, number)
            if known is not None and self.tracks[name].places[-1][0] == number:
                c = known[0] - self.read_vector(shape.centre, "")
            else:
                phrase = f"the place where {name} strikes {wall.name}"
                c = Vector(
                    self.unknowns.hidden(f"n_{number}x", phrase, "real"),
                    self.unknowns.hidden(f"n_{number}y", phrase, "real"),
                )
                self.equations.append(Equation(c.dot(c) - 1, phrase, kind="direction"))
        elif isinstance(shape, Line) and shape.along is None and wall.name in self._normals:
            c = self._normals[wall.name]
        elif isinstance(shape, Line) and shape.along is None and self._frame_matters():
            # The change of velocity itself is along the normal: linear in what is unknown.
            phrase = f"the direction of the wall {wall.name}"
            c = Vector(
                self.unknowns.hidden(f"k_{number}x", phrase, "real"),
                self.unknowns.hidden(f"k_{number}y", phrase, "real"),
            )
            unknown = True
            self._normals[wall.name] = c
        else:
            c = -self.wall_direction(Name(wall.name)).turned_left()
        u = self.arriving.get((number, name), u)
        closing = self.rational(u.dot(c))
        what = f"{name} is moving away from {wall.name}, or along it"
        self._approach((name, wall.name), u, c, closing, unknown, what)
        altered = self._altered(number, step, {name: u}, c, closing, e, unknown)
        if altered is not None:
            v = altered[name]
            push = self.neat(u - v)
        elif unknown:
            v, push = self.neat(u - c), c
            self.equations.append(
                Equation(c.dot(c) - (1 + e) * closing, "Newton's experimental law", kind="law")
            )
        elif self.frames is not None:
            v, push = u, None  # the frame tells what comes after
        else:
            on_wall = law.impulse(u, zero, 1, 0, c, e)
            v = self.neat(law.after_impulse(u, zero, 1, 0, on_wall)[0])
            push = self.neat(on_wall)
        return Happening(
            number,
            step,
            {name: self.velocity(name, number - 1)},
            {name: v},
            centres=c,
            closing=closing,
            e=e,
            impulse=push,
            impulse_mass=name,
            time=time,
            unknown_line=unknown,
            altered=altered is not None,
        )

    def _impact_of_spheres(self, number: int, step: Impact) -> Happening:
        first, second = step.first, step.second
        u1, u2 = self.velocity(first, number - 1), self.velocity(second, number - 1)
        m1, m2 = self.mass(first), self.mass(second)
        e = self._coefficient(number, step)
        approach = u1 - u2
        time, geometric = places.meeting(self, number, step, approach)
        sought = self.arriving.get((number, first))
        if sought is not None:
            approach = sought
        unknown = False
        if step.along is not None:
            c = self.direction(step.along, number - 1)
            if self._of_statement:
                line = f"the line of centres of {first} and {second}"
                bodies.require_direction(c, line, step.along, step.place)
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
        closing = self.rational(approach.dot(c))
        what = f"{first} and {second} are separating along the line of centres"
        if self.still(approach):
            what = f"{first} and {second} are at rest relative to each other, and do not collide"
        placed = time is not None and places.meeting_time(self, number) is not None
        own = self.rational(u1.dot(c)) if step.along is not None and not placed else None
        if self._of_statement and (own is not None or self.still(approach)):
            self._require_approach(step, c, own, closing, what)
        self._approach((first, second), approach, c, closing, unknown, what, own)
        altered = self._altered(number, step, {first: u1, second: u2}, c, closing, e, unknown)
        if altered is not None:
            v1, v2 = altered[first], altered[second]
            push = self.neat((v2 - u2) * m2)
        elif unknown:
            # The impulse itself is along the line of centres: linear in what is unknown.
            v1, v2 = self.neat(u1 - c / m1), self.neat(u2 + c / m2)
            push = c
            self.equations.append(
                Equation(
                    c.dot(c) * (m1 + m2) - (1 + e) * closing * m1 * m2,
                    "Newton's experimental law",
                    kind="law",
                )
            )
        elif self.frames is not None:
            v1, v2, push = u1, u2, None  # the frame tells what comes after
        elif sought is not None:
            v1, v2, push = contacts.velocities_after(self, number, step, sought, c, e)
        else:
            # Inverse masses matter up to a factor: m2 and m1 serve, and keep fractions out.
            on_2 = law.impulse(u1, u2, m2, m1, c, e)
            v1, v2 = (self.neat(v) for v in law.after_impulse(u1, u2, m2, m1, on_2))
            push = self.neat(on_2 * (m1 * m2))
        places.place_after_meeting(self, number, step, c, closing, unknown, time)
        return Happening(
            number,
            step,
            {first: u1, second: u2},
            {first: v1, second: v2},
            centres=c,
            closing=closing,
            e=e,
            impulse=push,
            time=time if time is not None else places.meeting_time(self, number),
            unknown_line=unknown,
            altered=altered is not None,
        )

    def _altered(
        self,
        number: int,
        step: Impact,
        before: Mapping[str, Vector],
        c: Vector,
        closing: Scalar,
        e: Scalar,
        unknown: bool,
    ) -> Mapping[str, Vector] | None:
        """The velocities after an impact at which other laws hold; None where the laws do."""
        altered = self.problem.altered_at(number)
        if altered is None or self.frames is not None:
            return None
        if not unknown:
            sign = self.sign(closing)
            c = c * closing if sign is None else c * self.field.number(Fraction(sign or 1))
        laws = AlteredLaws(self, altered, step, before, c, e)
        laws.require_senses()
        self.altered_laws[number] = laws
        if not unknown:
            return laws.velocities()
        after, equations = laws.velocities_on_unknown_line()
        self.equations += equations
        return after

    def _require_approach(
        self, step: Impact, c: Vector, own: Scalar, closing: Scalar, what: str
    ) -> None:
        """Raises ImpossibleError where two spheres are proved not to approach on their line.

        Where they would if the names were exchanged, that is suggested.
        """
        first, second = step.first, step.second
        if self.field.is_zero(closing):
            if "relative" not in what:
                what = f"{first} and {second} move alike along the line of centres"
                what += ", and do not collide"
        elif (first, second) in self._contacts or not (own * closing).is_negative:
            return
        elif (closing * (closing - own)).is_positive:
            what += f": {second} is the faster; did you mean '{second} hits {first}'?"
        raise ImpossibleError(what, *line_and_column(step.place))

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
        if self.field.is_zero(under):
            raise ImpossibleError(what)
        self.conditions.append(Condition(under, ">", what, "place"))
        c = approach * self.real_root(under, what) + approach.turned_left() * d
        return self.neat(c)


def _in_lets(value: Any, lets: Mapping[str, object]) -> bool:
    """Whether a property of a body depends on a name that depends on the motion."""
    return isinstance(value, Expression) and not letters(value).isdisjoint(lets)


def lets_of(problem: Problem, part: Part) -> dict[str, tuple[Let, int]]:
    """The names in force in a part, each with the number of events told before its line."""
    return {
        step.letter: (step, events)
        for step, events, _ in problem.timeline(part)
        if isinstance(step, Let)
    }
