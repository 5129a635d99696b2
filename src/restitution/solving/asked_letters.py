"""Values that are asked in terms of letters which a fact further down in their part fixes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from restitution.expression.tree import letters
from restitution.problem import Find, Given, Part, Problem, Value, count_of_items
from restitution.solving.equations.solution import ItemResult, PartSolution, Solution


def in_asked_letters(
    problem: Problem, part: PartSolution, solve: Callable[[Problem], Solution]
) -> PartSolution:
    """A part whose values asked ``in terms of`` letters are in these, where only a fact below
    the question gives a number for one.

    ``find tan(beta) in terms of alpha`` above ``given tan(alpha) = 1/2`` asks for an expression in
    alpha: the number belongs to what is asked after the fact.
    """
    items = list(part.items)
    first = 0
    for cut, step in enumerate(part.part.steps):
        last = first + count_of_items(step)
        later = any(isinstance(step, Given) for step in part.part.steps[cut:])
        if isinstance(step, Find) and step.in_terms_of and later:
            listed = frozenset(step.in_terms_of)
            lacking = [n for n in range(first, last) if _lacks(items[n], listed)]
            if lacking:
                alone = solve(_without_facts_after(problem, part.part, cut)).parts[part.part.label]
                for number in lacking:
                    items[number] = _in_letters(items[number], alone.items[number], listed)
        first = last
    return part if items == list(part.items) else replace(part, items=tuple(items))


def _lacks(result: ItemResult, listed: frozenset[str]) -> bool:
    """Whether a value has not all the letters that are listed for it."""
    if result.error is not None or not isinstance(result.item, Value) or not result.answers:
        return False
    own = letters(result.item.expression)
    return any(listed - own - answer.letters for answer in result.answers)


def _without_facts_after(problem: Problem, part: Part, cut: int) -> Problem:
    """The problem without the facts of a part from a step on."""
    steps = part.steps
    own = replace(part, steps=(*steps[:cut], *(s for s in steps[cut:] if not isinstance(s, Given))))
    return replace(problem, parts=tuple(own if other is part else other for other in problem.parts))


def _in_letters(whole: ItemResult, alone: ItemResult, listed: frozenset[str]) -> ItemResult:
    """The result as it is without the facts below, where that is one value in more letters."""
    if alone.error is not None or len(alone.distinct) != 1:
        return whole
    value = alone.distinct[0]
    own = value.letters
    if not own <= listed or not all(answer.letters < own for answer in whole.answers):
        return whole
    answers = tuple(replace(value, solution=answer.solution) for answer in whole.answers)
    return replace(whole, answers=answers, rejected=())
