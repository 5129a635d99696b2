"""Directions of which both parts are unknown letters: only their ratio could be found.

``wall W: along a i + b j`` is a wall of unknown direction where nothing else speaks of a and b, and
what is given makes it certain; so it is of a line of centres.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Negate,
    Unit,
    letters,
)
from restitution.problem import Find, Given, Impact, Problem, Show, Step, Unknown, trees


def with_open_directions(problem: Problem) -> Problem | None:
    """The problem without such directions; None where it has none, or gives nothing of motion."""
    if not any(isinstance(step, Given) for _, step in problem.steps()):
        return None
    uses = Counter(name for tree in trees(problem) for name in letters(tree))
    uses.update(name for _, step in problem.steps() for name in _terms(step))
    directions = [wall.along for wall in problem.walls]
    directions += [step.along for step in problem.events if isinstance(step, Impact)]
    open_ = [
        tree
        for tree in directions
        if isinstance(tree, Expression)
        and (names := _parts(tree)) is not None
        and all(uses[name] == 1 for name in names)
    ]
    if not open_:
        return None
    gone = frozenset().union(*map(letters, open_))
    walls = tuple(
        replace(wall, along=None) if wall.along in open_ else wall for wall in problem.walls
    )
    parts = tuple(
        replace(part, steps=tuple(_without(part.steps, open_, gone))) for part in problem.parts
    )
    return replace(problem, walls=walls, parts=parts)


def _without(
    steps: tuple[Step, ...], open_: list[Expression], gone: frozenset[str]
) -> Iterator[Step]:
    """Steps without some directions, and without their letters."""
    for step in steps:
        match step:
            case Impact(along=along) if along is not None and along in open_:
                yield replace(step, along=None)
            case Unknown(names):
                left = tuple(name for name in names if name not in gone)
                if left:
                    yield replace(step, letters=left)
            case _:
                yield step


def _terms(step: Step) -> tuple[str, ...]:
    """The letters in terms of which an answer is asked."""
    return (step.in_terms_of or ()) if isinstance(step, Find | Show) else ()


def _parts(direction: Expression) -> frozenset[str] | None:
    """The letters of a vector with one along **i** and another along **j**; None of any other."""
    match direction:
        case Binary("+" | "-", left, right):
            pass
        case _:
            return None
    pairs = [_letter_and_unit(tree) for tree in (left, right)]
    names = frozenset(pair[0] for pair in pairs if pair is not None)
    axes = {pair[1] for pair in pairs if pair is not None}
    return names if len(names) == 2 and axes == {"i", "j"} else None


def _letter_and_unit(tree: Expression) -> tuple[str, str] | None:
    match tree:
        case Negate(operand):
            return _letter_and_unit(operand)
        case Binary("*", Letter(name), Unit(axis)):
            return name, axis
    return None


__all__ = ["with_open_directions"]
