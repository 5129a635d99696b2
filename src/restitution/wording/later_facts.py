"""Facts that stand below what is asked without them: *Given that tan α = ¾, find β*."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import takewhile

from restitution.expression.dimensions import NONE
from restitution.expression.tree import Expression, Letter, has_quantity, letters
from restitution.language.measuring import dimensions_of_letters
from restitution.problem import (
    Event,
    Find,
    Given,
    Impact,
    Part,
    Problem,
    Relation,
    Show,
    Step,
    Value,
    once_a_problem,
    trees_of_bodies,
    trees_of_relation,
    trees_of_step,
)
from restitution.wording.letters import named_letters


def facts_apart(problem: Problem, steps: Sequence[Step]) -> tuple[list[Step], list[Step]]:
    """Steps up to the questions that stand above a fact, and the fact with what is asked below it.

    These questions are asked in all the ratios and angles that are data: in terms of them, or to
    be shown. What is asked else belongs to the fact. All steps are above where no question does.
    """
    asks = [(n, step) for n, step in enumerate(steps) if isinstance(step, Find | Show)]
    first = asks[0][0] if asks else len(steps)
    facts = [n for n, step in enumerate(steps) if n > first and isinstance(step, Given)]
    before = [ask for n, ask in asks if n < min(facts, default=0)]
    above = len(list(takewhile(partial(_is_in_letters, problem), before)))
    if not 0 < above < len(asks):
        return list(steps), []
    below = [*facts, *(n for n, _ in asks[above:])]
    rest = [step for n, step in enumerate(steps) if n not in below]
    return rest, [steps[n] for n in below]


@once_a_problem
def later_relations(problem: Problem) -> tuple[Relation, ...]:
    """What is given below questions that stand above it, in the parts without a label."""
    return tuple(
        relation
        for part in problem.parts
        if part.label is None
        for steps in between_events(part)
        for given in facts_apart(problem, steps)[1]
        if isinstance(given, Given)
        for relation in given.relations
    )


def between_events(part: Part) -> Iterator[tuple[Step, ...]]:
    """The steps of a part before its first event, then those after each of its events."""
    steps: list[Step] = []
    for step in part.steps:
        if isinstance(step, Event):
            yield tuple(steps)
            steps = []
        else:
            steps.append(step)
    yield tuple(steps)


def _is_in_letters(problem: Problem, ask: Find | Show) -> bool:
    """Whether a question names all ratios and angles that are data and that no fact above fixes."""
    data = _ratios_and_angles(problem)
    if isinstance(ask, Find):
        if any(not isinstance(e, Value) or isinstance(e.expression, Letter) for e in ask.items):
            return False
        return bool(data) and ask.in_terms_of is not None and data <= set(ask.in_terms_of)
    lets = named_letters(problem)
    own = [*trees_of_step(ask)]
    names = frozenset().union(*map(letters, own))
    of_motion = any(map(has_quantity, own)) or bool(names & lets)
    return bool(data) and of_motion and data <= names


@once_a_problem
def _ratios_and_angles(problem: Problem) -> frozenset[str]:
    """The letters of the data that are numbers, but for those of which a first fact speaks."""
    dimensions = dimensions_of_letters(problem)
    names = frozenset().union(*map(letters, _data(problem)))
    fixed: set[str] = set()
    for part in problem.parts:
        for step in takewhile(lambda step: not isinstance(step, Find | Show), part.steps):
            if isinstance(step, Given):
                for relation in step.relations:
                    own = [*trees_of_relation(relation)]
                    if not any(map(has_quantity, own)):
                        fixed |= frozenset().union(*map(letters, own))
    numbers = {name for name in names if dimensions.get(name, NONE) == NONE}
    return frozenset(numbers - fixed - named_letters(problem))


def _data(problem: Problem) -> Iterator[Expression]:
    """What is given of bodies and events."""
    yield from trees_of_bodies(problem)
    for _, step in problem.steps():
        if isinstance(step, Event):
            yield from trees_of_step(step)
        if isinstance(step, Impact) and step.e is None:
            yield Letter("e")
