"""The motion of a story at many samples: what a world holds, and what never differs in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any

import numpy as np

from restitution.practice.worlds.arrays import Array
from restitution.problem import Event, Let, Part, Point, Problem, Sphere, Wall
from restitution.records import dataclass
from restitution.solving.story.forward import Story, lets_up_to
from restitution.vector import Vector

Stage = tuple[int, str]


@dataclass(frozen=True)
class Stop:
    """A place that the story knows of a sphere: after which event, where, and how it is reached.

    ``where`` is None where it is no longer known. ``jump`` is what the place differs by from the
    one to which the sphere has moved since its last stop; None at the first of them.
    """

    event: int
    where: Vector | None
    jump: Vector | None = None


@dataclass(frozen=True, eq=False)
class Plot:
    """Parts of a story that no number changes: events, names in force, bodies by their names.

    ``known`` keeps what has been worked out of these alone.
    """

    events: tuple[Event, ...]
    lets: Mapping[str, tuple[Let, int]]
    spheres: Mapping[str, Sphere]
    walls: Mapping[str, Wall]
    points: Mapping[str, Point]
    open_times: frozenset[str]
    known: dict[str, Any] = field(default_factory=dict, repr=False)

    @classmethod
    def of(cls, story: Story, part: Part) -> Plot:
        """The plot of a story that has been told, with the names that earlier parts gave."""
        steps = tuple(happening.step for happening in story.happenings)
        lets = lets_up_to(story.problem, part) | dict(story.lets)
        return cls(steps, lets, story.spheres, story.walls, story.points, story.open_times)


@dataclass(frozen=True, eq=False)
class SampledMotion:
    """The story up to and with ``part`` at ``samples`` samples.

    Scalars are arrays of shape (samples,), or single numbers. ``letters`` holds the letters of the
    statement and its hidden unknowns (``_m_A``) by name, angles in radians; ``angles`` are the
    names of those that are angles. ``after`` has the velocities after an event, by its number and
    the body; ``lines`` unit vectors along the line of centres of an impact, from the first body to
    the second, or into the wall. ``times`` are None where nothing is known of places. The facts of
    the statement give the letters ``determined`` their values.
    """

    problem: Problem
    part: Part
    solution: int
    samples: int
    letters: Mapping[str, Array]
    angles: frozenset[str]
    start: Mapping[str, Vector]
    after: Mapping[Stage, Vector]
    lines: Mapping[int, Vector]
    walls: Mapping[str, Vector]
    times: Mapping[int, Array | None]
    stops: Mapping[str, tuple[Stop, ...]]
    plot: Plot
    determined: frozenset[str] = frozenset()
    _known: dict[Any, Any] = field(default_factory=dict, init=False, repr=False)

    @property
    def events(self) -> tuple[Event, ...]:
        """The events of the story, in order."""
        return self.plot.events

    @property
    def lets(self) -> Mapping[str, tuple[Let, int]]:
        """The names in force, each with the number of events told before its line."""
        return self.plot.lets

    def spread(self, x: Array) -> Array:
        """A number for all samples as an array of shape (samples,)."""
        if isinstance(x, np.ndarray) and x.shape == (self.samples,):
            return x
        return np.full(self.samples, x, dtype=float)
