"""Whether the answers to a question tell mistakes apart.

Every misconception that applies is run in doubles. A question is diagnosable if each leads to an
answer that differs from the right one, and from that of every other, by more than one per cent and
in three figures. Mistakes that cannot be told apart by what is asked, whatever its numbers are, are
left to the lines of the working: they are known by numbers that are shaken a little.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from restitution.explaining.mistakes.altered import AlteredProblem, altered
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.expression.tree import Degrees, Number, Quantity, is_binary
from restitution.practice.questions import doubles
from restitution.practice.questions.dice import Dice
from restitution.problem import Event, Given, Let, Problem, Value
from restitution.records import dataclass
from restitution.solving.equations.solution import Solution

RIGHT = "the right answer"
_SHARE = 0.01
_SAME = 1e-7

INSEPARABLE: Mapping[frozenset[str], str] = {
    frozenset({"restitution-omitted", "energy-conserved"}): "both are an impact with e = 1",
    frozenset({"sine-cosine", "angle-from-normal"}): (
        "the angle from the wrong line is sine for cosine in every line"
    ),
}
"""Pairs of mistakes that no numbers tell apart; lines of working do."""

Answers = tuple[tuple[float, ...] | None, ...]


@dataclass(frozen=True)
class Clash:
    """Two mistakes, or a mistake and the right answer, that lead to the same answers."""

    one: str
    other: str

    def __str__(self) -> str:
        return f"{self.one} and {self.other}"


def clash(solution: Solution) -> Clash | None:
    """The first two whose answers are not told apart, or None where a question is diagnosable."""
    desk = _Desk(solution)
    known: dict[str, Answers] = {}
    for name, answers in desk.worlds(solution.problem):
        for other, theirs in known.items():
            if _mistake(name) == _mistake(other) or _in_table(name, other):
                continue
            if not _apart(answers, theirs) and not desk.alike_for_good(name, other):
                return Clash(_mistake(other), _mistake(name))
        known[name] = answers
    return None


def answers_of(solution: Solution) -> dict[str, Answers]:
    """The answers of each part in doubles: the right ones, and those of each variant by its id."""
    return dict(_Desk(solution).worlds(solution.problem))


def difference(solution: Solution, mistake: str) -> float:
    """How far a mistake's answers lie from the right ones: the largest share, 0 where it is not."""
    known = answers_of(solution)
    right = known.get(RIGHT)
    worlds = [answers for name, answers in known.items() if _mistake(name) == mistake]
    if right is None or not worlds:
        return 0.0
    return max(max(_shares(right, world), default=0.0) for world in worlds)


def _mistake(name: str) -> str:
    return name.partition("/")[0]


def _in_table(one: str, other: str) -> bool:
    return frozenset((_mistake(one), _mistake(other))) in INSEPARABLE


# --- worlds -------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Sample:
    """A part solved, with values for all its letters, and the names of those that facts fix.

    ``key`` is the same for parts of which the stories and the facts are the same.
    """

    index: int
    values: Mapping[str, float]
    sought: tuple[str, ...]
    key: object


class _Desk:
    """The worlds of one solved question, and of the same question with shaken numbers."""

    def __init__(self, solution: Solution) -> None:
        self.problem = solution.problem
        self.samples = tuple(samples(solution))
        self._shaken = [_shaken(self.problem, n) for n in (1, 2)]
        self._known: dict[tuple[int, str], Answers | None] = {}

    @cached_property
    def _stories(self) -> list[Any]:
        """The true story of each part; None where it cannot be told in doubles."""
        return [
            doubles.fitted(
                self.problem, self.problem.parts[sample.index], sample.values, sample.sought
            )
            for sample in self.samples
        ]

    def worlds(self, problem: Problem) -> Iterator[tuple[str, Answers]]:
        """Answers with the id of a variant, the right ones first.

        What applies nowhere, or has no world, is left out.
        """
        right = self._answers(problem)
        if right is None or not any(right):
            return
        yield RIGHT, right
        for name, variant in _VARIANTS.items():
            changed = altered(problem, variant)
            if changed is None or not self._is_sensible(changed):
                continue
            led = self._answers(changed.problem)
            if led is not None and any(answer is not None for answer in led):
                yield name, led

    def alike_for_good(self, one: str, other: str) -> bool:
        """Whether two agree with shaken numbers too: what is asked does not tell them apart."""
        for number in range(len(self._shaken)):
            pair = [self._answers_of(number, name) for name in (one, other)]
            if pair[0] is None or pair[1] is None or not _equal(pair[0], pair[1]):
                return False
        return True

    def _answers_of(self, number: int, name: str) -> Answers | None:
        """The answers of a variant to the question with shaken numbers."""
        if (number, name) not in self._known:
            problem = self._shaken[number]
            changed = None if name == RIGHT else altered(problem, _VARIANTS[name])
            self._known[number, name] = self._answers(
                problem if changed is None else changed.problem
            )
        return self._known[number, name]

    def _is_sensible(self, changed: AlteredProblem) -> bool:
        """Whether the signs that are put in by hand are those of the components in the truth."""
        trees = [sense for place in changed.at for sense in place.senses]
        trees += [
            result.sense for one in changed.at for result in one.results if result.sense is not None
        ]
        for story in self._stories if trees else ():
            if story is None:
                continue
            evaluator = story.evaluator(len(story.happenings))
            try:
                if any(evaluator.scalar(tree) < -_SAME for tree in trees):
                    return False
            except doubles.REFUSALS:
                continue
        return True

    def _answers(self, problem: Problem) -> Answers | None:
        """The answers of each part, its unknown letters fitted to its facts."""
        stories: dict[object, Any] = {}
        answers: list[tuple[float, ...] | None] = []
        for sample in self.samples:
            part = problem.parts[sample.index]
            if sample.key not in stories:
                stories[sample.key] = doubles.fitted(problem, part, sample.values, sample.sought)
            story = stories[sample.key]
            try:
                answers.append(None if story is None else doubles.answers(problem, part, story))
            except doubles.REFUSALS:
                answers.append(None)
        return tuple(answers)


_VARIANTS = {
    variant.id: variant
    for mistake in MISCONCEPTIONS.values()
    for variant in mistake.variants
    if variant.solvable
}


def samples(solution: Solution) -> Iterator[_Sample]:
    """Each part that has a number for an answer, with values for its letters."""
    for index, part in enumerate(solution.problem.parts):
        solved = solution.parts.get(part.label)
        if solved is None or not solved.branches:
            continue
        if not any(isinstance(item, Value) for item, _ in solution.problem.asked(part)):
            continue
        branch = solved.branches[0]
        values = {name: float(value) for name, value in branch.sample.items()}
        sought = tuple(name for name in branch.values if name in values)
        story = tuple(
            (step, events)
            for step, events, _ in solution.problem.timeline(part)
            if isinstance(step, Event | Given | Let)
        )
        yield _Sample(index, values, sought, (story, tuple(values.items()), sought))


# --- comparing ----------------------------------------------------------------------------------


def _shares(one: Answers, other: Answers) -> Iterator[float]:
    for a, b in zip(one, other, strict=True):
        for x, y in zip(a or (), b or (), strict=False):
            size = max(abs(x), abs(y))
            yield abs(x - y) / size if size > _SAME else 0.0


def _apart(one: Answers, other: Answers) -> bool:
    """Whether some answers differ by more than a hundredth, and in three figures."""
    if any((a is None) != (b is None) for a, b in zip(one, other, strict=True)):
        return True
    for a, b in zip(one, other, strict=True):
        for x, y in zip(a or (), b or (), strict=True):
            size = max(abs(x), abs(y))
            if size > _SAME and abs(x - y) > _SHARE * size and f"{x:.3g}" != f"{y:.3g}":
                return True
    return False


def _equal(one: Answers, other: Answers) -> bool:
    return not any((a is None) != (b is None) for a, b in zip(one, other, strict=True)) and all(
        share < _SAME for share in _shares(one, other)
    )


# --- what no numbers tell apart -----------------------------------------------------------------


def _shaken(problem: Problem, number: int) -> Problem:
    """A problem with every number of it changed a little, each by its own share."""
    dice = Dice(f"shaken/{number}")
    shaken: Problem = _rebuilt(problem, dice)
    return shaken


def _rebuilt(value: Any, dice: Dice) -> Any:
    if isinstance(value, Degrees) and value.value % 90 == 0:
        return value  # a right angle is what a question is about, and no number of it
    if isinstance(value, Number | Degrees):
        factor = 1 + Fraction(dice.between(-60, 60), 1000)
        return replace(value, value=value.value * factor)
    if is_binary(value, "^"):
        return replace(value, left=_rebuilt(value.left, dice))
    if isinstance(value, Quantity):
        return value
    if isinstance(value, tuple) and not hasattr(value, "_fields"):
        return tuple(_rebuilt(part, dice) for part in value)
    if is_dataclass(value) and not isinstance(value, type):
        changes = {
            field.name: _rebuilt(getattr(value, field.name), dice)
            for field in fields(value)
            if field.init and field.name not in ("place", "notes", "text")
        }
        return replace(value, **changes)
    return value
