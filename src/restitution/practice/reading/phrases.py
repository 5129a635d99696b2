"""Phrases that name a quantity: ``speed of A``, ``KE lost``, ``angle to the wall after``.

A phrase is a bag of the features that its words have: what it is of, when, in which direction and
sense. So word order, fillers and capitals do not matter. What it may mean is a list of trees of
the statement language, the most natural first.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from typing import Literal

from restitution.errors import StatementError
from restitution.expression import read_expression
from restitution.expression.tree import (
    Expression,
    Name,
    Quantity,
)
from restitution.practice.reading.angle_names import AngleNames
from restitution.practice.reading.features import Features, features_of, words_of
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
from restitution.problem import Impact, Problem

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


def _unique(candidates: Iterator[Expression]) -> tuple[Expression, ...]:
    trees: dict[Expression, None] = {}
    for candidate in candidates:
        trees.setdefault(candidate)
        if len(trees) >= MAX_CANDIDATES:
            break
    return tuple(trees)


class _Reader(AngleNames):
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
