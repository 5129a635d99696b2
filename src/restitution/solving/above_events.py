"""Items that stand above an event which cannot happen: they are answered without it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from restitution.errors import ImpossibleError
from restitution.expression.tree import Letter
from restitution.problem import Event, Find, Part, Problem, Show, Unknown, Value, count_of_items
from restitution.solving.equations.solution import ItemResult, PartSolution

Solver = Callable[[Problem, Part], PartSolution]


def answered_above(
    problem: Problem, part: Part, results: tuple[ItemResult, ...], solve: Solver
) -> tuple[tuple[ItemResult, ...], PartSolution | None]:
    """The items of a part that has no solution, with the answers of those above its last events.

    With them comes the part up to the first event that cannot happen, by whose solutions they are
    answered; None where nothing is. ``solve`` solves a part of a problem.
    """
    events = [n for n, step in enumerate(part.steps) if isinstance(step, Event)]
    for cut in reversed(events):
        above = sum(map(count_of_items, part.steps[:cut]))
        if not above:
            return results, None
        own = replace(part, steps=part.steps[:cut])
        number = problem.parts.index(part)
        before = solve(replace(problem, parts=(*problem.parts[:number], own)), own)
        if not before.branches:
            continue
        sought = _sought(part)
        merged = tuple(
            _kept(own_result, whole, sought)
            for own_result, whole in zip(before.items, results[:above], strict=True)
        )
        if all(result.error is not None for result in merged):
            return results, None
        return (*merged, *results[above:]), before
    return results, None


def _sought(part: Part) -> frozenset[str]:
    """The letters that a part asks for, or calls unknown."""
    asked = {
        item.expression.name
        for step in part.steps
        if isinstance(step, Find)
        for item in step.items
        if isinstance(item.expression, Letter)
    }
    unknown = (step.letters for step in part.steps if isinstance(step, Unknown))
    return frozenset(asked.union(*unknown))


def _kept(own: ItemResult, whole: ItemResult, sought: frozenset[str]) -> ItemResult:
    """An item as it is answered without the events below it, where it has an answer there.

    One in letters that are sought has none, as these are not found.
    """
    if not isinstance(whole.error, ImpossibleError) or own.error is not None:
        return whole
    if isinstance(own.item, Show):
        return own if own.holds else whole
    # A range hangs on all that happens; and what holds under a condition may hang on it as well.
    plain = isinstance(own.item, Value) and not any(answer.condition for answer in own.answers)
    determined = all(sought.isdisjoint(answer.letters) for answer in own.answers)
    return own if plain and determined else whole
