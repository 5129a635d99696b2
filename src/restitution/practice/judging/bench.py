"""A part of a question with all that judging needs from it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from restitution.expression.tree import (
    Degrees,
    Expression,
    Number,
    has_quantity,
    letters,
    walk,
)
from restitution.practice.judging.bounds import bounds_of
from restitution.practice.judging.extremes import worlds_at_extremes
from restitution.practice.judging.judged_link import Question
from restitution.practice.judging.naming import Names
from restitution.practice.judging.support import Wanted, wanted_of
from restitution.practice.worlds.agreement import numbers_of
from restitution.practice.worlds.sampling import true_worlds
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Extremum, Find, Given, Problem, Range, Show, trees
from restitution.records import dataclass
from restitution.solving.equations.solution import PartSolution, Solution

if TYPE_CHECKING:
    from restitution.practice.marking.scheme import Scheme


@dataclass(frozen=True, eq=False)
class Bench:
    """A part of a question with everything that judging needs from it, worked out once.

    ``fixed`` are values that a script takes for letters of the question: ``take u = 1``.
    """

    solution: Solution
    solved: PartSolution
    fixed: Mapping[str, Fraction] = field(default_factory=dict)

    def taking(self, fixed: Mapping[str, Fraction]) -> Bench:
        """The same part where letters have these values; as it is where they cannot."""
        own = replace(self, fixed=fixed) if fixed else self
        return own if own.worlds else self

    @property
    def problem(self) -> Problem:
        """The question."""
        return self.solution.problem

    @cached_property
    def worlds(self) -> tuple[World, ...]:
        """The true worlds, one for each admissible solution."""
        return true_worlds(self.solution, self.solved, self.fixed)

    @cached_property
    def names(self) -> Names:
        """The names of the mistakes."""
        return Names(self.problem)

    @cached_property
    def question(self) -> Question:
        """What the part prints and asks, and which letters are unknown in it."""
        unknown = {
            name
            for branch in self.solved.branches
            for name in (*branch.values, *branch.angles)
            if any(name in world.letters for world in self.worlds)
        }
        bounds = bounds_of(self.problem, self.solved.part, self.solved)
        asked = (
            step.items if isinstance(step, Find) else (step.subject,)
            for step in self.solved.part.steps
            if isinstance(step, Find | Show)
        )
        extreme = any(isinstance(item, Extremum | Range) for items in asked for item in items)
        reached = worlds_at_extremes(self.solution, self.solved, self.worlds) if extreme else ()
        return Question(self.wanted, frozenset(unknown), self.given, bounds, extreme, reached)

    @cached_property
    def wanted(self) -> Wanted:
        """What the part prints and asks for."""
        return wanted_of(self.problem, self.solved.part)

    @cached_property
    def given(self) -> frozenset[str]:
        """The letters that a fact about letters alone gives a value."""
        names: set[str] = set()
        for step, _, _ in self.problem.timeline(self.solved.part):
            if isinstance(step, Given):
                for relation in step.relations:
                    if isinstance(relation, Compare) and "=" in relation.operators:
                        sides = relation.operands
                        inside = frozenset().union(*map(letters, sides))
                        if len(inside) == 1 and not any(map(has_quantity, sides)):
                            names |= inside
        return frozenset(names)

    @cached_property
    def data(self) -> tuple[Fraction, ...]:
        """The numbers of the statement, and its fractions."""
        own = dict.fromkeys(numbers(trees(self.problem)))
        return (*own, *sorted(set(numbers_of(self.problem)) - own.keys()))

    @cached_property
    def schemes(self) -> tuple[Scheme, ...]:
        """The mark schemes of the part, that of the usual method first."""
        from restitution.practice.marking.scheme import schemes

        return schemes(self.solution, self.solved.part.label)


_BENCHES: dict[tuple[int, str | None], Bench] = {}
_KEPT = 8


def bench_of(question: Problem | Solution, part: str | None) -> Bench:
    """The bench for a part; a few are kept, by the question as an object."""
    key = id(question), part
    known = _BENCHES.get(key)
    if known is not None and question in (known.solution, known.problem):
        return known
    if isinstance(question, Problem):
        from restitution.solving.solver import solve

        solution = solve(question)
    else:
        solution = question
    if part not in solution.parts:
        raise KeyError(part)
    bench = Bench(solution, solution.parts[part])
    while len(_BENCHES) >= _KEPT:
        del _BENCHES[next(iter(_BENCHES))]
    _BENCHES[key] = bench
    return bench


def numbers(expressions: Iterable[Expression]) -> Iterator[Fraction]:
    """The numbers of some trees, in their order."""
    return (
        node.value
        for tree in expressions
        for node in walk(tree)
        if isinstance(node, Number | Degrees)
    )
