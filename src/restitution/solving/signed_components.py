"""Letters that are components, and may have either sign: a note where that splits an answer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from restitution.errors import RestitutionError
from restitution.expression.tree import Letter, Number
from restitution.problem import Compare, Find, Problem, Unknown, with_facts
from restitution.render.layout import display
from restitution.render.text import to_text
from restitution.solving.equations.solution import ItemResult, Solution
from restitution.solving.story.letters import roles


def with_note_of_signs(solution: Solution, solved: Callable[[Problem], Solution]) -> Solution:
    """The solution, with a warning where an answer is several only as components may be negative.

    In ``velocity u i - v j`` each letter is any number; who means sizes would not expect one answer
    for ``v > 0`` and one for ``v < 0``. ``solved`` solves a problem.
    """
    problem = solution.problem
    names = _components(problem)
    split = [
        (label, number)
        for label, part in solution.parts.items()
        for number, item in enumerate(part.items)
        if _is_split(item)
    ]
    if not names or not split:
        return solution
    try:
        other = solved(_positive(problem, names))
    except RestitutionError:
        return solution
    if not any(_is_one(other.parts[label].items[number]) for label, number in split):
        return solution
    shown = [to_text(display(roles(problem)[name].symbol(name))) for name in names]
    facts = ", ".join(f"{name} > 0" for name in names)
    note = (
        f"{' and '.join(shown)} may have either sign, as components and coordinates may: write "
        f"'given {facts}' where positive values are meant"
    )
    return replace(solution, warnings=(*solution.warnings, note))


def _components(problem: Problem) -> list[str]:
    """The letters that may have either sign and are data of the whole statement."""
    asked: set[str] = set()
    for _, step in problem.steps():
        if isinstance(step, Unknown):
            asked |= set(step.letters)
        elif isinstance(step, Find):
            own = (item.expression for item in step.items)
            asked |= {tree.name for tree in own if isinstance(tree, Letter)}
    return sorted(
        name for name, role in roles(problem).items() if role.kind == "real" and name not in asked
    )


def _is_split(item: ItemResult) -> bool:
    """Whether an item has several answers, or one under a condition."""
    return item.error is None and (
        len(item.distinct) > 1 or any(answer.condition for answer in item.distinct)
    )


def _is_one(item: ItemResult) -> bool:
    return item.error is None and len(item.distinct) == 1 and not item.distinct[0].condition


def _positive(problem: Problem, names: list[str]) -> Problem:
    zero = Number(Fraction(0))
    return with_facts(problem, *(Compare((Letter(name), zero), (">",)) for name in names))
