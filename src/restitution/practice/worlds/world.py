"""The story of a part in numbers, at many samples of its letters at once.

A world holds letters, the velocities after each event, lines of centres, times and places. All
else is worked out from these, by the definitions of `solving.story.quantities`; so a world in
which a velocity, a coefficient or a line of centres is replaced is a world too, whatever law it
breaks.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.evaluate import Angle, Value
from restitution.expression.tree import Expression, Name, Quantity, is_quantity, walk
from restitution.practice.script import ANYWHERE, Scope
from restitution.practice.worlds import effort
from restitution.practice.worlds.arrays import Array, UnvaluedError
from restitution.practice.worlds.motion import Plot, SampledMotion, Stage, Stop
from restitution.practice.worlds.telling import (
    NO_MEANINGS,
    NO_NUMBERS,
    NO_VALUES,
    Meanings,
    Telling,
)
from restitution.practice.worlds.turning import turned, unit
from restitution.problem import Impact, Item, Part
from restitution.records import dataclass
from restitution.shapes import Circle
from restitution.solving.story.forward import Story
from restitution.vector import Vector

_NOTHING = 1e-9
_REFUSALS = (
    RestitutionError,
    ArithmeticError,
    LookupError,
    AssertionError,
    TypeError,
    ValueError,
    AttributeError,
)


@dataclass(frozen=True, eq=False)
class World(SampledMotion):
    """The story up to and with ``part`` at ``samples`` samples.

    Scalars are arrays of shape (samples,), or single numbers. ``letters`` holds the letters of the
    statement and its hidden unknowns (``_m_A``) by name, angles in radians; ``angles`` are the
    names of those that are angles. ``after`` has the velocities after an event, by its number and
    the body; ``lines`` unit vectors along the line of centres of an impact, from the first body to
    the second, or into the wall. ``times`` are None where nothing is known of places. The facts of
    the statement give the letters ``determined`` their values.
    """

    @cached_property
    def _asked_after(self) -> int:
        """The number of events before the last question of the part."""
        asked = [now for _, now in self.problem.asked(self.part)]
        return max(asked, default=len(self.events))

    @cached_property
    def first_stage(self) -> int:
        """The number of events of earlier parts, where the part has events of its own.

        None of them counts where the part asks for what they do as well: a deflection in all.
        """
        if not self.part.events or self.part not in self.problem.parts:
            return 0
        earlier = self.problem.parts[: self.problem.parts.index(self.part)]
        first = sum(len(part.events) for part in earlier)
        for item, _ in self.problem.asked(self.part):
            for node in walk(item.expression) if isinstance(item, Item) else ():
                stage = node.stage if isinstance(node, Quantity) else None
                if is_quantity(node, "deflection") or (isinstance(stage, int) and stage < first):
                    return 0
        return first

    @cached_property
    def is_in_one_line(self) -> bool:
        """Whether all bodies move along i, or all along j: there a speed is a velocity's worth."""
        vectors = (*self.start.values(), *self.after.values(), *self.lines.values())
        columns = zip(*((vector.x, vector.y) for vector in vectors), strict=True)
        return any(all(np.all(np.abs(x) < _NOTHING) for x in parts) for parts in columns)

    def wall_impacts(self) -> Iterator[tuple[int, str]]:
        """The impacts with walls, each with its sphere."""
        for number, step in enumerate(self.events, 1):
            if isinstance(step, Impact) and step.second in self.walls:
                yield number, step.first

    def now(self, scope: Scope = ANYWHERE) -> int:
        """After how many events a line of this scope stands."""
        if scope.event is None:
            return self._asked_after
        return scope.event - (scope.stage == "before")

    # --- values -------------------------------------------------------------------------------

    def value(
        self,
        tree: Expression,
        meanings: Meanings = NO_MEANINGS,
        scope: Scope = ANYWHERE,
        *,
        now: int | None = None,
        degrees: bool = True,
        put: Mapping[int, Array] = NO_NUMBERS,
        values: Mapping[str, Value] = NO_VALUES,
        noted: list[Expression] | None = None,
    ) -> Value:
        """The value of a tree: an array, a Vector of arrays, or an Angle.

        ``meanings`` are those of the student's letters and phrases; bare numbers beside angles are
        in degrees, or, where ``degrees`` is False, in radians. ``put`` replaces numbers of the
        tree by the columns at which they stand. ``values`` are those of letters, before any
        meaning: arrays of which the last axis is that of the samples, vectors of them, or angles;
        more axes before it are kept. Bare numbers taken for angles are added to ``noted``. What is
        not real is nan. Raises UnvaluedError for a letter that has no meaning, and for what makes
        no sense.
        """
        effort.evaluate()
        telling = Telling(self, meanings, degrees, values, noted)
        with np.errstate(all="ignore"):
            try:
                return telling.evaluator(self.now(scope) if now is None else now, put).value(tree)
            except UnvaluedError:
                raise
            except _REFUSALS as error:
                raise UnvaluedError(str(error)) from error

    def scalar(self, tree: Expression, meanings: Meanings = NO_MEANINGS, **how: Any) -> Array:
        """The value of a tree that is a number, shape (samples,); angles in radians.

        Raises UnvaluedError where it is a vector.
        """
        value = self.value(tree, meanings, **how)
        if isinstance(value, Vector):
            raise UnvaluedError("a vector stands where a number is needed")
        number = value.measure() if isinstance(value, Angle) else value
        return self.spread(number)

    # --- other worlds -------------------------------------------------------------------------

    def replaced(
        self,
        *,
        letters: Mapping[str, Array] | None = None,
        angles: frozenset[str] = frozenset(),
        after: Mapping[Stage, Vector] | None = None,
        lines: Mapping[int, Vector] | None = None,
        times: Mapping[int, Array] | None = None,
    ) -> World:
        """The world with some values replaced, and all that is worked out from them.

        Replaced letters turn walls, lines of centres and velocities at the start where the
        statement writes these with them; velocities after an event stay unless ``after`` has them.
        """
        world = replace(
            self,
            letters={**self.letters, **(letters or {})},
            angles=self.angles | angles,
            after={**self.after, **(after or {})},
            lines={**self.lines, **(lines or {})},
            times={**self.times, **(times or {})},
        )
        if letters:
            world = turned(world, frozenset(letters), frozenset(lines or ()))
        return world

    def repeated(self, times: int) -> World:
        """The same world with its samples repeated in blocks, ``times`` of each block."""
        key = ("repeated", times)
        if key not in self._known:
            self._known[key] = _repeated(self, times)
        world: World = self._known[key]
        return world


# --- stacking ---------------------------------------------------------------------------------


def stacked(worlds: Sequence[World]) -> World:
    """Several worlds of one part as one, their samples one after another."""
    first = worlds[0]
    sizes = [world.samples for world in worlds]

    def joined(values: Sequence[Any]) -> Any:
        if any(value is None for value in values):
            return None
        if isinstance(values[0], Vector):
            return Vector(joined([v.x for v in values]), joined([v.y for v in values]))
        return np.concatenate(
            [np.broadcast_to(np.asarray(v, dtype=float), (n,)) for v, n in zip(values, sizes)]
        )

    def entries(name: str) -> dict[Any, Any]:
        tables = [getattr(world, name) for world in worlds]
        keys = [key for key in tables[0] if all(key in table for table in tables)]
        return {key: joined([table[key] for table in tables]) for key in keys}

    stops = {
        name: tuple(
            Stop(
                stop.event,
                joined([world.stops[name][k].where for world in worlds]),
                joined([world.stops[name][k].jump for world in worlds]),
            )
            for k, stop in enumerate(first.stops[name])
        )
        for name in first.stops
    }
    tables: dict[str, Any] = {
        name: entries(name) for name in ("letters", "start", "after", "lines", "walls", "times")
    }
    return replace(first, samples=sum(sizes), stops=stops, **tables)


def _repeated(world: World, times: int) -> World:
    """A world with its samples repeated; single numbers serve for all samples as they are."""

    def of(value: Any) -> Any:
        if isinstance(value, Vector):
            return Vector(of(value.x), of(value.y))
        if isinstance(value, np.ndarray) and value.shape == (world.samples,):
            return np.concatenate([value] * times)
        return value

    tables: dict[str, Any] = {
        name: {key: of(value) for key, value in getattr(world, name).items()}
        for name in ("letters", "start", "after", "lines", "walls", "times")
    }
    stops = {
        name: tuple(Stop(stop.event, of(stop.where), of(stop.jump)) for stop in known)
        for name, known in world.stops.items()
    }
    return replace(world, samples=times * world.samples, stops=stops, **tables)


# --- from a story told in numbers -----------------------------------------------------------------


def world_of(
    story: Story, part: Part, solution: int, letters: Mapping[str, Any], angles: frozenset[str]
) -> World:
    """A story told in numbers as a world of one sample.

    ``letters`` are its letters and hidden unknowns, as numbers. Masses that nothing is known of
    have to be among them.
    """
    values = {name: float(value) for name, value in letters.items()}
    after: dict[Stage, Vector] = {}
    lines: dict[int, Vector] = {}
    times: dict[int, Array | None] = {}
    for happening in story.happenings:
        number = happening.number
        times[number] = None if happening.time is None else float(happening.time)
        for name, velocity in happening.after.items():
            after[number, name] = _floats(velocity)
        if happening.centres is not None:
            lines[number] = unit(_floats(happening.oriented()))
    walls = {
        wall.name: unit(_floats(story.wall_direction(Name(wall.name))))
        for wall in story.problem.walls
        if not isinstance(wall.shape, Circle)
    }
    return World(
        story.problem,
        part,
        solution,
        1,
        values,
        angles,
        {name: _floats(story.velocity(name, 0)) for name in story.spheres},
        after,
        lines,
        walls,
        times,
        {name: _stops(story, name) for name in story.spheres},
        Plot.of(story, part),
    )


def _stops(story: Story, name: str) -> tuple[Stop, ...]:
    """The places of a sphere, each by how it differs from the one to which it has moved."""
    stops: list[Stop] = []
    last: tuple[int, Vector, float] | None = None
    for event, place, when in story.tracks[name].places:
        where = None if place is None else _floats(place)
        time = None if when is None else float(when)
        jump = None
        if where is not None and time is not None and last is not None:
            moved = last[1] + _floats(story.velocity(name, last[0])) * (time - last[2])
            jump = where - moved
        stops.append(Stop(event, where, jump))
        last = None if where is None or time is None else (event, where, time)
    return tuple(stops)


def _floats(v: Vector) -> Vector:
    return Vector(np.float64(float(v.x)), np.float64(float(v.y)))
