"""What is so where a coefficient is 0 or 1, if the condition of an answer excludes that."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.errors import ContradictionError, ImpossibleError, RestitutionError
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Letter, Number
from restitution.problem import (
    Compare,
    Event,
    Extremum,
    Given,
    Impact,
    Problem,
    bodies_of,
)
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.solving import solve
from restitution.solving.equations.solution import Answer, ItemResult, PartSolution, Solution
from restitution.solving.story.letters import roles


@dataclass(frozen=True)
class ExcludedEnd:
    """The end of a coefficient, and what is asked there; None where nothing is possible.

    ``staying`` is then a body that goes on after a wall, which it does not leave there.
    """

    end: Layout
    answer: Layout | None
    staying: tuple[str, str] | None = None


def excluded_end(
    solution: Solution, part: PartSolution, item: ItemResult, answer: Answer
) -> ExcludedEnd | None:
    """What the statement comes to at the one end that a condition such as ``0 < e`` excludes.

    None of any other condition, and where that cannot be said.
    """
    known = roles(solution.problem)
    ends = {
        text: (name, value)
        for name, role in known.items()
        if role.kind == "restitution" and (role.low, role.high) == (0, 1)
        for text, value, closed in ((f"0 < {name}", 0, 0), (f"{name} < 1", 1, 1))
        if role.closed[closed]
    }
    if len(answer.condition) != 1 or answer.condition[0] not in ends:
        return None
    name, value = ends[answer.condition[0]]
    end = lay.Relation((lay.from_sympy(sp.Symbol(name)), lay.Number(str(value))), ("=",))
    given = Given((Compare((Letter(name), Number(Fraction(value))), ("=",)),))
    parts = list(solution.problem.parts)
    place = parts.index(part.part)
    own = replace(part.part, steps=(given, *part.part.steps))
    try:
        there = solve(replace(solution.problem, parts=(*parts[:place], own, *parts[place + 1 :])))
    except RestitutionError:
        return None
    result = there.parts[part.part.label].items[part.items.index(item)]
    if isinstance(result.error, ContradictionError | ImpossibleError):
        # That there is no greatest value says nothing of what is described.
        if isinstance(item.item, Extremum):
            return None
        return ExcludedEnd(end, None, _staying(solution.problem, part, name, value))
    (only, *others) = result.distinct or (None,)
    if only is None or others or only.layout is None or only.condition:
        return None
    return ExcludedEnd(end, only.layout)


def _staying(problem: Problem, part: PartSolution, name: str, value: int) -> tuple[str, str] | None:
    """The body that has an event after one at a wall of which the coefficient is 0, and the wall.

    A letter is ``value`` there.
    """
    events = [step for step, _, _ in problem.timeline(part.part) if isinstance(step, Event)]
    walls = {wall.name for wall in problem.walls}
    for place, step in enumerate(events):
        if not isinstance(step, Impact) or step.second not in walls:
            continue
        coefficient = in_letters(step.e or Letter("e")).subs(sp.Symbol(name), value)
        if coefficient == 0 and any(step.first in bodies_of(e) for e in events[place + 1 :]):
            return step.first, step.second
    return None


__all__ = ["ExcludedEnd", "excluded_end"]
