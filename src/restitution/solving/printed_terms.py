"""Claims that print what a letter is by others: where they are not decided, that tells the unknown.

Of ``show tan²α = e³/(1 + e + e²)`` either letter may be sought in the facts. An equation of the
third degree in e is one of the second in the tangent.
"""

from __future__ import annotations

from dataclasses import replace

from restitution.errors import UnsupportedError
from restitution.expression.tree import AtTime, Quantity, has_quantity, letters, walk
from restitution.problem import Compare, Given, Problem, Show, Step, trees_of_step
from restitution.solving.equations.solution import ItemResult, Solution


def in_printed_terms(solution: Solution) -> Problem | None:
    """The problem with its undecided claims in terms of their right sides; None without one."""
    problem = solution.problem
    claims = {
        id(item.item): terms
        for part in solution.parts.values()
        for item in part.items
        if (terms := _terms(item)) is not None
    }
    if not claims or any(map(_is_of_a_time, (step for _, step in problem.steps()))):
        return None
    parts = tuple(
        replace(
            part,
            steps=tuple(
                replace(step, in_terms_of=claims[id(step)])
                if isinstance(step, Show) and id(step) in claims
                else step
                for step in part.steps
            ),
        )
        for part in problem.parts
    )
    return replace(problem, parts=parts)


def _is_of_a_time(step: Step) -> bool:
    """Whether a fact names the motion at a time between events: a further unknown."""
    return isinstance(step, Given) and any(
        isinstance(node, Quantity) and isinstance(node.stage, AtTime)
        for tree in trees_of_step(step)
        for node in walk(tree)
    )


def _terms(item: ItemResult) -> tuple[str, ...] | None:
    """The letters of the right side of a claim that is too hard; None of another item."""
    match item.item, item.error:
        case (
            Show(relation=Compare((left, right), ("=",)), subject=None, in_terms_of=None),
            UnsupportedError(),
        ):
            own, other = letters(left), letters(right)
            if own and other and not own & other and not any(map(has_quantity, (left, right))):
                return tuple(sorted(other))
    return None


def refused(solution: Solution) -> int:
    """How many items have no answer."""
    return sum(item.error is not None for part in solution.parts.values() for item in part.items)
