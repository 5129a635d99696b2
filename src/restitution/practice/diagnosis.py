"""Whether the answers to a question tell mistakes apart.

Every misconception that applies is run in doubles. A question is diagnosable if each leads to an
answer that differs from the right one, and from that of every other, by more than one per cent and
in three figures. Mistakes that cannot be told apart by what is asked, whatever its numbers are, are
left to the lines of the working: they are known by numbers that are shaken a little.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from typing import Any

from restitution.explaining.altered import altered
from restitution.explaining.misconceptions import MISCONCEPTIONS
from restitution.expression.tree import Binary, Degrees, Number, Quantity
from restitution.practice import doubles
from restitution.practice.dice import Dice
from restitution.problem import Problem
from restitution.solving.solution import Solution

RIGHT = "the right answer"
_SHARE = 0.01
_SAME = 1e-7

INSEPARABLE: Mapping[frozenset[str], str] = {
    frozenset({"restitution-omitted", "energy-conserved"}): "both are an impact with e = 1",
    frozenset({"sine-cosine", "angle-from-normal"}): "sine for cosine in every line is both",
    frozenset({"speed-for-component", "impulse-of-speeds"}): "both put whole speeds into an impulse",
    frozenset({"across-changed", "speed-for-component"}): (
        "an impact treated as a direct one has no component across"
    ),
    frozenset({"energy-one-sphere", "energy-component-missing"}): (
        "where one sphere has no component left, its energy is what is missing"
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
    problem = solution.problem
    known = _worlds(problem, solution)
    if RIGHT not in known:
        return None
    alike = None
    for one, other in combinations(known, 2):
        if _mistake(one) == _mistake(other) or _in_table(one, other):
            continue
        if _apart(known[one], known[other]):
            continue
        alike = _alike_for_good(problem, solution) if alike is None else alike
        if frozenset((one, other)) not in alike:
            return Clash(_mistake(one), _mistake(other))
    return None


def answers_of(solution: Solution) -> dict[str, Answers]:
    """The answers of each part in doubles: the right ones, and those of each variant by its id."""
    return _worlds(solution.problem, solution)


def difference(solution: Solution, mistake: str) -> float:
    """How far a mistake's answers lie from the right ones: the largest share, 0 where it is not."""
    known = answers_of(solution)
    right = known.get(RIGHT)
    worlds = [each for name, each in known.items() if _mistake(name) == mistake]
    if right is None or not worlds:
        return 0.0
    return max(max(_shares(right, each), default=0.0) for each in worlds)


def _mistake(name: str) -> str:
    return name.partition("/")[0]


def _in_table(one: str, other: str) -> bool:
    return frozenset((_mistake(one), _mistake(other))) in INSEPARABLE


# --- worlds -------------------------------------------------------------------------------------


def _worlds(problem: Problem, solution: Solution) -> dict[str, Answers]:
    """Answers by the id of a variant; what applies nowhere, or has no world, is left out."""
    right = _answers(problem, solution, problem)
    if right is None or not any(right):
        return {}
    known: dict[str, Answers] = {RIGHT: right}
    for mistake in MISCONCEPTIONS.values():
        for variant in mistake.variants:
            if not variant.solvable:
                continue
            changed = altered(problem, variant)
            if changed is None or not _sensible(changed.at, problem, solution):
                continue
            led = _answers(changed.problem, solution, problem)
            if led is not None and any(each is not None for each in led):
                known[variant.id] = led
    return known


def _sensible(at: Any, problem: Problem, solution: Solution) -> bool:
    """Whether the signs that are put in by hand are those of the components in the true world."""
    trees = [sense for each in at for sense in each.senses]
    trees += [each.sense for one in at for each in one.results if each.sense is not None]
    if not trees:
        return True
    for part, values, _ in _samples(solution):
        try:
            story = doubles.tell(problem, part, values)
            evaluator = story.evaluator(len(story.happenings))
            if any(evaluator.scalar(tree) < -_SAME for tree in trees):
                return False
        except doubles.REFUSALS:
            continue
    return True


def _answers(problem: Problem, solution: Solution, true: Problem) -> Answers | None:
    """The answers of each part of a problem, its unknown letters fitted to its facts."""
    found: list[tuple[float, ...] | None] = []
    for (part, values, sought), own in zip(
        _samples(solution), _parts(problem, solution), strict=True
    ):
        if not any(True for _ in problem.asked(own)):
            found.append(())
            continue
        fit = doubles.fitted(problem, own, values, sought)
        try:
            found.append(
                None
                if fit is None
                else doubles.answers(problem, own, doubles.tell(problem, own, fit))
            )
        except doubles.REFUSALS:
            found.append(None)
    return tuple(found)


def _parts(problem: Problem, solution: Solution) -> Iterator[Any]:
    """The parts of a problem that stand where those of the solution do."""
    for solved in solution.parts.values():
        if solved.branches:
            yield problem.parts[solution.problem.parts.index(solved.part)]


def _samples(solution: Solution) -> Iterator[tuple[Any, dict[str, float], tuple[str, ...]]]:
    """Each part solved with values for all its letters, and the names of those that facts fix."""
    for solved in solution.parts.values():
        if not solved.branches:
            continue
        branch = solved.branches[0]
        values = {name: float(value) for name, value in branch.sample.items()}
        yield solved.part, values, tuple(name for name in branch.values if name in values)


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


def _alike_for_good(problem: Problem, solution: Solution) -> frozenset[frozenset[str]]:
    """Pairs that agree with shaken numbers too: what is asked does not tell them apart."""
    known = [_worlds(_shaken(problem, n), solution) for n in (1, 2)]
    names = set(known[0]) & set(known[1])
    pairs = (frozenset(pair) for pair in combinations(sorted(names), 2))
    return frozenset(
        pair for pair in pairs if all(_equal(*(each[name] for name in pair)) for each in known)
    )


def _shaken(problem: Problem, number: int) -> Problem:
    """A problem with every number of it changed a little, each by its own share."""
    dice = Dice(f"shaken/{number}")
    shaken: Problem = _rebuilt(problem, dice)
    return shaken


def _rebuilt(value: Any, dice: Dice) -> Any:
    if isinstance(value, Number | Degrees):
        factor = 1 + Fraction(dice.between(-60, 60), 1000)
        return replace(value, value=value.value * factor)
    if isinstance(value, Binary) and value.op == "^":
        return replace(value, left=_rebuilt(value.left, dice))
    if isinstance(value, Quantity):
        return value
    if isinstance(value, tuple) and not hasattr(value, "_fields"):
        return tuple(_rebuilt(each, dice) for each in value)
    if is_dataclass(value) and not isinstance(value, type):
        changes = {
            each.name: _rebuilt(getattr(value, each.name), dice)
            for each in fields(value)
            if each.init and each.name not in ("place", "notes", "text")
        }
        return replace(value, **changes)
    return value


_ = lru_cache
