"""A world with the interface of a story: bodies, velocities, places and events over arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from restitution.expression.evaluate import Value
from restitution.expression.tree import Expression, Letter, Name, Quantity, letters
from restitution.practice.worlds.arrays import (
    FIELD,
    Array,
    ArrayEvaluator,
    Arrays,
    UnvaluedError,
    angle,
)
from restitution.practice.worlds.motion import SampledMotion, Stop
from restitution.problem import Arrival, Event, Impact, Let
from restitution.records import dataclass
from restitution.solving.story import quantities
from restitution.solving.story.happenings import Happening
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.solving.story.forward import Story

Meanings = Mapping[str, Expression]
NO_MEANINGS: Meanings = {}
NO_NUMBERS: Mapping[int, Array] = {}
NO_VALUES: Mapping[str, Value] = {}


@dataclass(frozen=True)
class _Track:
    places: Sequence[tuple[int, Vector | None, Array]]


class Telling:
    """A world as a story that `solving.story.quantities` can ask, meanings of letters with it."""

    field: Arrays = FIELD

    def __init__(
        self,
        world: SampledMotion,
        meanings: Meanings = NO_MEANINGS,
        degrees: bool = True,
        values: Mapping[str, Value] = NO_VALUES,
        noted: list[Expression] | None = None,
    ) -> None:
        self.world = world
        self.meanings = meanings
        self.degrees = degrees
        self.values = values
        self.problem = world.problem
        self.noted = noted
        self.spheres = world.plot.spheres
        self.walls = world.plot.walls
        self.points = world.plot.points
        self.open_times = world.plot.open_times
        self.unknowns = self
        self._open: list[str] = []

    # --- reading trees ------------------------------------------------------------------------

    def evaluator(self, now: int, put: Mapping[int, Array] = NO_NUMBERS) -> ArrayEvaluator:
        """Reads trees as they are meant after ``now`` events."""
        return ArrayEvaluator(
            lambda name: self._letter(name, now),
            lambda tree: self.quantity(tree, now),
            lambda tree: self._named(tree, now),
            self.wall_direction,
            degrees=self.degrees,
            put=put,
            noted=self.noted,
        )

    def _letter(self, name: str, now: int) -> Value:
        if name in self.values:
            return self.values[name]
        if name in self.meanings and name not in self._open:
            return self._opened(name, self.meanings[name], now)
        known = self.world.letters
        if name in known and name not in self.world.lets:
            value = self.world.spread(known[name])
            return angle(value) if name in self.world.angles else value
        if name in self.world.lets and f"let {name}" not in self._open:
            step, since = self.world.lets[name]
            return self._kept(("let", name), lambda: self._let(name, step, since))
        if name == "m" and len(masses := self._open_masses()) == 1:
            return self.mass(masses[0])
        raise UnvaluedError(f"{name} has no meaning here", name)

    def _opened(self, name: str, tree: Expression, now: int) -> Value:
        self._open.append(name)
        try:
            return self.evaluator(now).value(tree)
        finally:
            self._open.pop()

    def _let(self, name: str, step: Let, since: int) -> Value:
        """The value of a name of the statement, in which letters mean what they mean there."""
        plain = Telling(self.world, degrees=False)
        plain._open = [*self._open, f"let {name}"]
        return plain.evaluator(since).value(step.expression)

    def _open_masses(self) -> list[str]:
        """The spheres of which no mass is given."""
        return [name for name, sphere in self.spheres.items() if sphere.mass is None]

    def _kept(self, key: Any, work: Any) -> Value:
        known = self.world._known.get(key)
        if known is None:
            known = self.world._known[key] = work()
        return known

    def _named(self, tree: Name, now: int) -> Value:
        """What a name alone stands for: a place, the direction of a wall, a sphere's velocity."""
        if tree.name in self.points:
            return self.read(self.points[tree.name].position, 0)
        if tree.name in self.walls:
            return self.wall_direction(tree)
        if tree.name in self.spheres:
            return self.velocity(tree.name, now)
        raise UnvaluedError(f"{tree.name} has no meaning here", tree.name)

    def read(self, tree: Any, now: int = 0) -> Any:
        """A property of a body: a tree, a number put in by Python, or a pair of these."""
        if isinstance(tree, Expression):
            return self._kept(("property", tree, now), lambda: self._plain(tree, now))
        if isinstance(tree, tuple | list):
            return Vector(*(self.read(part, now) for part in tree))
        return np.float64(tree)

    def _plain(self, tree: Expression, now: int) -> Value:
        """The value of a tree of the statement, in which letters mean what they mean there."""
        return Telling(self.world, degrees=False).evaluator(now).value(tree)

    # --- what a story is asked ----------------------------------------------------------------

    @property
    def happenings(self) -> tuple[Happening, ...]:
        """The events, with the velocities of this world."""
        # Asked more often than anything else.
        known = self.world._known.get("happenings") or self._kept(
            "happenings", self._all_happenings
        )
        return cast("tuple[Happening, ...]", known)

    def _all_happenings(self) -> tuple[Happening, ...]:
        return tuple(
            self._happening(number, step) for number, step in enumerate(self.world.events, 1)
        )

    def _happening(self, number: int, step: Event) -> Happening:
        bodies = (step.first, step.second) if isinstance(step, Impact) else (step.body,)
        spheres = [name for name in bodies if name in self.spheres]
        return Happening(
            number,
            step,
            {name: self.velocity(name, number - 1) for name in spheres},
            {name: self.velocity(name, number) for name in spheres},
            centres=self.world.lines.get(number),
            time=self.world.times.get(number),
            unknown_line=True,
        )

    @property
    def tracks(self) -> Mapping[str, _Track]:
        """The places of the spheres, as far as they are known."""
        return cast("Mapping[str, _Track]", self._kept("tracks", self._tracked))

    def _tracked(self) -> Mapping[str, _Track]:
        return {name: self._track(name, stops) for name, stops in self.world.stops.items()}

    def _track(self, name: str, stops: Sequence[Stop]) -> _Track:
        places: list[tuple[int, Vector | None, Array]] = []
        last: tuple[int, Vector, Array] | None = None
        for stop in stops:
            when = self.world.times.get(stop.event) if stop.event else FIELD.zero
            where = stop.where
            if stop.jump is not None and last is not None and when is not None:
                event, place, since = last
                where = place + self.velocity(name, event) * (when - since) + stop.jump
            places.append((stop.event, where, when))
            last = None if where is None or when is None else (stop.event, where, when)
        return _Track(places)

    def velocity(self, name: str, stage: int) -> Vector:
        """The velocity of a sphere just after event ``stage`` (0 is the start)."""
        for number in range(stage, 0, -1):
            known = self.world.after.get((number, name))
            if known is not None:
                return known
        return self.world.start[name]

    def latest(self, name: str, now: int) -> Happening | None:
        """The latest event of a body among the first ``now``."""
        return next((h for h in reversed(self.happenings[:now]) if name in h.bodies), None)

    def place(self, name: str, stage: int) -> tuple[Vector, Array] | None:
        """Where a sphere's centre was last known to be up to an event, and when."""
        known = [(p, t) for n, p, t in self.tracks[name].places if n <= stage]
        return None if not known or known[-1][0] is None else (known[-1][0], known[-1][1])

    def mass(self, name: str) -> Array:
        """The mass of a sphere."""
        sphere = self.spheres[name]
        if sphere.mass is None:
            return self.hidden(f"m_{name}")
        return self.read(sphere.mass)

    def radius(self, name: str) -> Array | None:
        """The radius of the spheres; None where it is negligible."""
        own = (self.spheres[name], *self.spheres.values())
        value = next((sphere.radius for sphere in own if sphere.radius is not None), None)
        return None if value is None else self.read(value)

    def hidden(self, key: str, phrase: str = "", sign: str = "") -> Array:
        """What the text leaves open and the motion needs."""
        try:
            return self.world.letters[f"_{key}"]
        except KeyError:
            raise UnvaluedError(f"{phrase or key} is not known") from None

    def size(self, v: Vector) -> Array:
        return np.hypot(v.x, v.y)

    def sign(self, x: Array) -> int | None:
        """The sign of a number, if it is the same in all samples."""
        signs = np.unique(np.sign(x))
        return int(signs[0]) if len(signs) == 1 else None

    def rational(self, x: Array) -> Array:
        return x

    def direction(self, tree: Expression, now: int) -> Vector:
        return self.evaluator(now).direction(tree)

    def wall_direction(self, tree: Expression) -> Vector:
        """A direction vector of a wall; of a circle, the tangent where it was struck last."""
        name = tree.name if isinstance(tree, Name) else ""
        if name in self.world.walls:
            return self.world.walls[name]
        struck = [n for n, h in enumerate(self.happenings, 1) if name in h.bodies]
        if not struck:
            raise UnvaluedError(f"{name} has no one direction")
        return self.world.lines[struck[-1]].turned_left()

    def coefficient(self, number: int) -> Array:
        """The coefficient of restitution of an impact."""
        step = self.world.events[number - 1]
        if not isinstance(step, Impact):
            raise UnvaluedError(f"event {number} is no impact")
        return self.read(Letter("e") if step.e is None else step.e, number - 1)

    # --- quantities ---------------------------------------------------------------------------

    def quantity(self, tree: Quantity, now: int) -> Value:
        """The value of a quantity asked for after ``now`` events."""
        for own in (self.meanings, self.values):
            if own and not letters(tree).isdisjoint(own):
                return self._quantity(tree, now)
        return self._kept((tree, now), lambda: self._quantity(tree, now))

    def _quantity(self, tree: Quantity, now: int) -> Value:
        if tree.kind == "impulse":
            return self._impulse(tree, now)
        if tree.kind == "restitution":
            event = quantities.event_of(self._as_story(), tree, now)
            return self.coefficient(event.number)
        return quantities.quantity(self._as_story(), tree, now)

    def _as_story(self) -> Story:
        return cast("Story", self)

    def _impulse(self, tree: Quantity, now: int) -> Value:
        """Mass times the change of velocity; on a wall, what the sphere receives, reversed."""
        body = tree.arguments[0] if tree.arguments else None
        name = body.name if isinstance(body, Name) else None
        event = quantities.event_of(self._as_story(), tree, now, name)
        if name is not None and name not in self.spheres:
            raise UnvaluedError("impulse(…) needs the name of a sphere")
        moved = name or [body for body in event.bodies if body in self.spheres][-1]
        if isinstance(event.step, Arrival):
            vector = Vector(FIELD.zero, FIELD.zero)
        else:
            vector = (event.after[moved] - event.before[moved]) * self.mass(moved)
        return vector if name is not None else self.size(vector)
