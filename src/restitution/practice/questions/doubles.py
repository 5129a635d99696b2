"""The story of a part told in doubles, in the true world or in an altered one.

`solving.Story` tells in any arithmetic; this is the quick one. Letters take their values from a
sample of the solution, and those that facts fix are sought again where a law is altered.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.evaluate import Angle
from restitution.planning.writing.checking import Floats
from restitution.problem import Part, Problem, Value
from restitution.records import dataclass
from restitution.solving.equations import facts
from restitution.solving.story.conditions import Equation
from restitution.solving.story.forward import Story, lets_of
from restitution.vector import Vector

REFUSALS = (RestitutionError, ArithmeticError, ValueError, LookupError, TypeError, AttributeError)
_TINY = 1e-10


class Doubles(Floats):
    """Doubles in which zero is anything tiny, and the root of a negative number an error."""

    def sqrt(self, x: float) -> float:
        return math.sqrt(x) if x > 0 else math.sqrt(0.0 if x > -_TINY else x)

    def is_zero(self, x: float) -> bool:
        return abs(x) < _TINY


DOUBLES: Any = Doubles()


class Letters:
    """Letters and hidden unknowns with their values, by name."""

    def __init__(self, values: Mapping[str, float]) -> None:
        self.values = values

    def letter(self, name: str) -> float:
        return self.values[name]

    def hidden(self, key: str, phrase: str, sign: str) -> float:
        return self.values[key if key in self.values else f"_{key}"]

    def sign(self, x: float, given: Sequence[Any] = ()) -> int | None:
        return 0 if abs(x) < _TINY else (1 if x > 0 else -1)


class _Teller:
    """A part that is told again and again, with other values."""

    def __init__(self, problem: Problem, part: Part) -> None:
        self.problem, self.part = problem, part
        self.lets = lets_of(problem, part)
        self.givens = facts.givens(problem, part)

    def story(self, values: Mapping[str, float]) -> Story:
        """The story up to the part. What is not known, or cannot be, raises a refusal."""
        letters: Any = Letters(values)
        return Story(self.problem, self.part, DOUBLES, letters, self.lets)

    def residuals(self, story: Story) -> list[float]:
        """What vanishes where all facts hold."""
        equations = list(story.equations)
        for given, now in self.givens:
            for relation in given.relations:
                required = facts.requirements(relation, story, now)
                equations += [
                    condition for condition in required if isinstance(condition, Equation)
                ]
        return [float(equation.value) for equation in equations]


def fitted(
    problem: Problem, part: Part, values: Mapping[str, float], sought: Sequence[str]
) -> Story | None:
    """The story with the values sought changed so that all facts hold, or None.

    By Broyden's method from the values given; the least change where facts leave room.
    """
    current, teller = dict(values), _Teller(problem, part)
    trial = _trial(teller, current)
    if trial is None or _is_met(trial.errors, current):
        return None if trial is None else trial.story
    slopes = _slopes(teller, current, sought, trial.errors)
    for _ in range(_MOST_STEPS if slopes is not None else 0):
        assert slopes is not None
        change = np.linalg.lstsq(slopes, -trial.errors, rcond=None)[0]
        if not np.all(np.isfinite(change)):
            return None
        for name, by in zip(sought, change, strict=True):
            current[name] += float(by)
        moved = _trial(teller, current)
        if moved is None or moved.errors.shape != trial.errors.shape:
            return None
        if _is_met(moved.errors, current):
            return moved.story
        square = float(change @ change)
        if square == 0.0:
            return None
        off = moved.errors - trial.errors - slopes @ change
        slopes = slopes + np.outer(off, change) / square
        trial = moved
    return None


_MOST_STEPS = 16


@dataclass(frozen=True)
class _Trial:
    story: Story
    errors: np.ndarray


def _trial(teller: _Teller, values: Mapping[str, float]) -> _Trial | None:
    """The story and what should vanish, an array; None where something cannot be."""
    try:
        story = teller.story(values)
        errors = np.array(teller.residuals(story), dtype=float)
    except REFUSALS:
        return None
    return _Trial(story, errors) if np.all(np.isfinite(errors)) else None


def _is_met(errors: np.ndarray, values: Mapping[str, float]) -> bool:
    scale = max(1.0, *map(abs, values.values())) if values else 1.0
    return not errors.size or float(np.max(np.abs(errors))) < 1e-8 * scale


def _slopes(
    teller: _Teller,
    values: Mapping[str, float],
    sought: Sequence[str],
    errors: np.ndarray,
) -> np.ndarray | None:
    """Slopes of the errors in each value sought, a matrix; None where one has no value."""
    columns = []
    for name in sought:
        step = 1e-6 * max(abs(values[name]), 0.1)
        moved = _trial(teller, {**values, name: values[name] + step})
        if moved is None or moved.errors.shape != errors.shape:
            return None
        columns.append((moved.errors - errors) / step)
    return np.column_stack(columns) if columns else None


def answers(problem: Problem, part: Part, story: Story) -> tuple[float, ...]:
    """Answers of a part in doubles: components of vectors one by one, angles in radians.

    Ranges, extrema and what is to be shown have no number. Raises one of ``REFUSALS``.
    """
    numbers: list[float] = []
    for item, now in problem.asked(part):
        if not isinstance(item, Value):
            continue
        value = story.evaluator(now).value(item.expression)
        if isinstance(value, Vector):
            numbers += [float(value.x), float(value.y)]
        else:
            numbers.append(float(value.measure() if isinstance(value, Angle) else value))
    if not all(map(math.isfinite, numbers)):
        raise ArithmeticError("a value is not finite")
    return tuple(numbers)
