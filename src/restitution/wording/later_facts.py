"""Facts that stand below what is asked without them: *Given that tan α = ¾, find β*."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
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
    trees_of_relation,
    trees_of_step,
)
from restitution.wording.letters import named_letters


def asked_above(problem: Problem, steps: Sequence[Step]) -> int:
    """How many of the first questions of some steps stand above the first fact after them.

    These are asked in all the ratios and angles that are data: in terms of them, or to be shown.
    What is asked else belongs to the fact, so that none is counted where nothing else is asked.
    """
    asks = [step for step in steps if isinstance(step, Find | Show)]
    first = next((n for n, step in enumerate(steps) if isinstance(step, Find | Show)), len(steps))
    fact = next((n for n, step in enumerate(steps) if n > first and isinstance(step, Given)), None)
    if fact is None:
        return 0
    before = [step for step in steps[:fact] if isinstance(step, Find | Show)]
    above = takewhile(lambda step: _is_in_letters(problem, step), before)
    count = sum(1 for _ in above)
    return count if count < len(asks) else 0


@once_a_problem
def later_relations(problem: Problem) -> tuple[Relation, ...]:
    """What is given below questions that stand above it, in the parts without a label."""
    return tuple(
        relation
        for part in problem.parts
        if part.label is None
        for steps in between_events(part)
        for given in facts_below(problem, steps)
        for relation in given.relations
    )


def facts_below(problem: Problem, steps: Sequence[Step]) -> tuple[Given, ...]:
    """The facts among some steps that stand below the questions above them."""
    if not asked_above(problem, steps):
        return ()
    first = next(n for n, step in enumerate(steps) if isinstance(step, Find | Show))
    return tuple(step for step in steps[first:] if isinstance(step, Given))


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
    for sphere in problem.spheres:
        for value in (sphere.mass, sphere.velocity, sphere.position, sphere.radius):
            if isinstance(value, Expression):
                yield value
    for wall in problem.walls:
        yield from (each for each in (wall.along, *wall.lengths) if isinstance(each, Expression))
    for _, step in problem.steps():
        if isinstance(step, Event):
            yield from trees_of_step(step)
        if isinstance(step, Impact) and step.e is None:
            yield Letter("e")
