"""What is known of bodies, walls and letters as a story goes on.

The law of impact, places and times, and the definitions of quantities look it up here. What the
text leaves open and the motion needs becomes a *hidden* unknown where it first turns up.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import field
from fractions import Fraction
from functools import cached_property
from typing import Any, Literal, Protocol

import sympy as sp

from restitution.errors import ImpossibleError, StatementError, UnsupportedError
from restitution.exact.symbols import symbols_in
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
    is_quantity,
    is_zero,
    line_and_column,
    walk,
)
from restitution.problem import (
    Compare,
    Find,
    Given,
    Let,
    Point,
    Problem,
    Relation,
    Show,
    Sphere,
    Wall,
    trees,
    trees_of_relation,
    trees_of_step,
)
from restitution.records import dataclass
from restitution.shapes import Circle, Line, Segment, Shape
from restitution.solving.algebra.neat import neat, ratio_in_numbers
from restitution.solving.story import missing
from restitution.solving.story.conditions import AnyOf, Condition, Equation
from restitution.solving.story.happenings import Happening
from restitution.vector import Vector

Sign = Literal["positive", "real"]


class Unknowns(Protocol):
    """Where letters and hidden unknowns take their values from."""

    def letter(self, name: str) -> Value: ...

    def hidden(self, key: str, phrase: str, sign: Sign) -> Scalar: ...

    def sign(self, x: Scalar, given: Sequence[Condition | AnyOf] = ()) -> int | None:
        """The sign of a scalar where some conditions hold; None where it depends on the letters."""


class Laws(Protocol):
    """Laws that hold at one impact in place of the usual ones."""

    def hold(self, after: Mapping[str, Vector]) -> bool:
        """Whether they hold of the velocities after it."""


@dataclass
class Track:
    """What is known of one sphere as the story goes on."""

    velocities: list[tuple[int, Vector]]
    # After which event, where and when; None for where is "no longer known".
    places: list[tuple[int, Any, Scalar]] = field(default_factory=list)


def _is_later(relation: Relation, events: int) -> bool:
    """Whether a relation says only that a letter is positive, or a time after the last event."""
    match relation:
        case Compare((Letter(), bound), (">" | ">=",)) | Compare((bound, Letter()), ("<" | "<=",)):
            return is_zero(bound) or bound == Quantity("time", (), events)
    return False


class State(ABC):
    """What is known after the events so far, in one arithmetic.

    ``of_statement`` tells that what holds of these values holds of the statement, and not of one
    of several roots. With ``in_frames`` the velocities after an impact are told in components.
    A line of centres that is open is told by its slope to the approach, after this many events.
    """

    def __init__(
        self,
        problem: Problem,
        arithmetic: Symbolic | Numeric,
        unknowns: Unknowns,
        lets: Mapping[str, tuple[Let, int]],
        *,
        of_statement: bool,
        in_frames: bool,
        sloped_after: int | None,
    ) -> None:
        self.problem = problem
        self.field = arithmetic
        self.unknowns = unknowns
        self.lets = lets
        self.of_statement = of_statement
        self.in_frames = in_frames
        self.sloped_after = sloped_after
        self.spheres: dict[str, Sphere] = {sphere.name: sphere for sphere in problem.spheres}
        self.walls: dict[str, Wall] = {wall.name: wall for wall in problem.walls}
        self.points: dict[str, Point] = {point.name: point for point in problem.points}
        self.equations: list[Equation] = []
        self.conditions: list[Condition | AnyOf] = []
        self.happenings: list[Happening] = []
        self.tracks = {name: Track([]) for name in self.spheres}
        self.fault: ImpossibleError | None = None  # proved, and worse than a clash of facts
        # Velocities just before events to whose places, being sought, they lead.
        self.arriving: dict[tuple[int, str], Vector] = {}
        self.altered_laws: dict[int, Laws] = {}
        self.needs_numbers = False  # something is asked that formulas do not say, or not for all
        self.implied = False  # places are counted from the first impact, as the text gives none
        self.normals: dict[str, Vector] = {}  # of walls whose direction follows from the story
        # From the first body to the second, at their latest impact.
        self.contact_lines: dict[tuple[str, str], Vector] = {}
        self._open_lets: list[str] = []
        self._let_values: dict[str, Value] = {}
        self._masses: dict[str, Scalar] = {}
        self._evaluators: dict[int, Evaluator] = {}

    @abstractmethod
    def quantity(self, tree: Quantity, now: int) -> Value:
        """What a quantity of the language is worth after ``now`` events."""

    # --- reading expressions ------------------------------------------------------------------

    def evaluator(self, now: int) -> Evaluator:
        """Reads expressions as they are meant after ``now`` events."""
        if now not in self._evaluators:
            self._evaluators[now] = Evaluator(
                self.field,
                self.letter,
                lambda tree: self.quantity(tree, now),
                self.named,
                self.wall_direction,
            )
        return self._evaluators[now]

    def letter(self, name: str) -> Value:
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

    def named(self, tree: Name) -> Value:
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
            return Vector(*(self.read(component, what) for component in tree))
        if isinstance(tree, sp.Expr) and self.field.exact:
            return tree
        if isinstance(tree, int | float):
            return self.field.number(Fraction(repr(tree)))
        raise UnsupportedError(f"{what} is {tree!r}, which is no number, letter or text")

    # --- bodies -------------------------------------------------------------------------------

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
        if name in self.normals:
            return self.normals[name].turned_left()
        if not self.frame_matters():
            return Vector(self.field.number(Fraction(1)), self.field.zero)
        phrase = missing.direction_of(name)
        p = self.unknowns.hidden(f"d_{name}x", phrase, "real")
        q = self.unknowns.hidden(f"d_{name}y", phrase, "real")
        self.equations.append(Equation(p * p + q * q - 1, phrase, kind="direction"))
        self.normals[name] = Vector(q, -p)
        return Vector(p, q)

    def has_derived_normal(self, wall: str) -> bool:
        """Whether the direction of a wall follows from the story and not from its own line."""
        return wall in self.normals

    def turn_wall(self, wall: str, normal: Vector) -> None:
        """Puts another normal in the place of one that follows from the story."""
        self.normals[wall] = normal

    def frame_matters(self) -> bool:
        """Whether anything but directions to the one wall fixes the axes."""
        if len(self.walls) != 1:
            return True
        for tree in trees(self.problem):
            for node in walk(tree):
                if isinstance(node, Unit | Pair):
                    return True
                if isinstance(node, Polar) and node.wall is None:
                    return True
                if is_quantity(node, "direction"):
                    return True
        return False

    # --- the motion so far --------------------------------------------------------------------

    def velocity(self, name: str, stage: int) -> Vector:
        """The velocity of a sphere just after event ``stage`` (0 is the start)."""
        known: list[Vector] = [v for n, v in self.tracks[name].velocities if n <= stage]
        return known[-1]

    def place(self, name: str, stage: int) -> tuple[Vector, Scalar] | None:
        """Where a sphere's centre was last known to be up to an event, and when."""
        known = [(p, t) for n, p, t in self.tracks[name].places if n <= stage]
        return known[-1] if known and known[-1][0] is not None else None

    def latest(self, name: str, now: int) -> Happening | None:
        """The latest event of a body among the first ``now``."""
        return next((h for h in reversed(self.happenings[:now]) if name in h.bodies), None)

    @cached_property
    def open_times(self) -> frozenset[str]:
        """Letters that stand for a time, as in ``at t``, and of which no fact speaks.

        That such a time is positive, or comes after the last event, says nothing else.
        """
        inside: set[str] = set()
        outside: set[str] = set()
        asked = {
            id(t)
            for _, s in self.problem.steps()
            if isinstance(s, Find | Show)
            for t in trees_of_step(s)
        }
        asked |= {
            id(tree)
            for step, events, _ in self.problem.timeline()
            if isinstance(step, Given)
            for relation in step.relations
            if _is_later(relation, events)
            for tree in trees_of_relation(relation)
        }
        for tree in trees(self.problem):
            times = [
                node
                for quantity in walk(tree)
                if isinstance(quantity, Quantity) and isinstance(quantity.stage, AtTime)
                for node in walk(quantity.stage.time)
            ]
            inside |= {time.name for time in times if isinstance(time, Letter)}
            if id(tree) not in asked:
                within = {id(time) for time in times}
                outside |= {
                    node.name
                    for node in walk(tree)
                    if isinstance(node, Letter) and id(node) not in within
                }
        return frozenset(inside - outside)

    # --- numbers ------------------------------------------------------------------------------

    def size(self, v: Vector) -> Scalar:
        """The size of a vector; exactly |x| where it lies along an axis.

        Along a line at a known slope it is a multiple of |x|, too: its square need not be taken.
        """
        if self.field.is_zero(v.y):
            return self.field.abs(v.x)
        if self.field.is_zero(v.x):
            return self.field.abs(v.y)
        if self.field.exact and symbols_in(v.x):
            slope = ratio_in_numbers(v.y, v.x)
            if slope is not None:
                return self.field.abs(v.x) * self.field.sqrt(neat(1 + slope**2))
        return self.field.sqrt(v.x * v.x + v.y * v.y)

    def sign(self, x: Scalar) -> int | None:
        """The sign of a scalar in all that is possible so far; None where the letters decide."""
        return self.unknowns.sign(x, self.conditions)

    def direction(self, tree: Expression, now: int) -> Vector:
        """A direction: a vector, an angle, a wall or ``line_of_centres``."""
        return self.evaluator(now).direction(tree)

    def rational(self, x: Scalar) -> Scalar:
        return neat(x) if self.field.exact else x

    def neat(self, v: Vector) -> Vector:
        return Vector(neat(v.x), neat(v.y)) if self.field.exact else v

    def real_root(self, under: Scalar, reason: str) -> Scalar:
        """A square root that has to be real: raises ImpossibleError, with the reason, if not."""
        negative = under.is_negative if self.field.exact else under < 0
        if negative:
            raise ImpossibleError(reason)
        return self.field.sqrt(under)

    def still(self, v: Vector) -> bool:
        return self.field.is_zero(v.x) and self.field.is_zero(v.y)
