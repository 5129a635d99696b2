"""Angles that may be obtuse where no acute one is possible: what errors say of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from restitution.errors import ContradictionError, ImpossibleError, RestitutionError
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Letter,
)
from restitution.oracle.roles import ACUTE
from restitution.problem import Compare, Problem, with_facts
from restitution.render.layout import display
from restitution.render.text import to_text
from restitution.solving.equations.solution import ItemResult, PartSolution, Solution
from restitution.solving.story.letters import roles
from restitution.work import limited

_MOST_LETTERS = 2
"""Each costs another solution of the whole."""
_HINT = 100_000


def with_hints(
    solution: Solution, solved: Callable[[Problem], Solution], operations: int
) -> Solution:
    """The solution, whose errors name the angle that would have to be 90° or more.

    A letter for an angle is acute unless a fact says otherwise; who does not know it sees an error
    that tells nothing. ``solved`` solves a problem, and ``operations`` are what the solution took:
    a hint is not worth much more.
    """
    problem = solution.problem
    refused = {
        id(item)
        for part in solution.parts.values()
        for item in part.items
        if isinstance(item.error, ContradictionError | ImpossibleError)
    }
    acute = [name for name, role in roles(problem).items() if role == ACUTE]
    if not refused or not 0 < len(acute) <= _MOST_LETTERS:
        return solution
    for name in acute:
        try:
            with limited(operations=_HINT + 2 * operations):
                other = solved(_up_to_180(problem, name))
        except RestitutionError:
            continue
        parts = {
            label: _part_with_hints(part, other.parts[label], name, refused)
            for label, part in solution.parts.items()
        }
        if any(part is not solution.parts[label] for label, part in parts.items()):
            return replace(solution, parts=parts)
    return solution


def _up_to_180(problem: Problem, name: str) -> Problem:
    return with_facts(problem, Compare((Letter(name), STRAIGHT_ANGLE), ("<",)))


def _part_with_hints(
    part: PartSolution, other: PartSolution, name: str, refused: set[int]
) -> PartSolution:
    items = tuple(
        _with_hint(item, name) if id(item) in refused and wide.error is None else item
        for item, wide in zip(part.items, other.items, strict=True)
    )
    return part if items == part.items else replace(part, items=items)


def _with_hint(item: ItemResult, name: str) -> ItemResult:
    assert item.error is not None
    error = item.error
    shown = to_text(display(ACUTE.symbol(name)))
    hint = (
        f"a letter for an angle is acute, and {shown} would be 90° or more: write "
        f"'given {name} < 180°' if that is meant"
    )
    own = type(error)(f"{error.message}; {hint}", error.line, error.column)
    own.fixes = error.fixes
    because = error.because or error.message
    # A value that no acute angle has is a reason by itself.
    by_itself = because.startswith("it cannot be that")
    own.because = because if by_itself else f"for an acute {shown}, {because}"
    return replace(item, error=own)


__all__ = ["with_hints"]
