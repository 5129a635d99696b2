"""Velocities in an unknown letter that no line of centres allows: the equation without a root.

The line of an impact is along a change of velocity. Where that has an unknown letter, Newton's law
is an equation for the letter. The lines are written in the statement with another velocity, which
can be: it keeps the component that is known.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from restitution.errors import ContradictionError, RestitutionError
from restitution.exact import tidy
from restitution.explaining.lines.derivation import Note
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Expression, Name, Quantity
from restitution.planning.axes.open_lines import write_open_law
from restitution.planning.clashes import scene_without
from restitution.planning.closing.systems import as_a_quadratic
from restitution.planning.unfinished import require_followed
from restitution.planning.writing.desk import UNPLANNED, Desk
from restitution.planning.writing.forms import tree_of
from restitution.problem import Compare, Given, Impact, Part, Problem
from restitution.solving import solve
from restitution.solving.equations.solution import PartSolution, Solution
from restitution.vector import Vector


def write_open_clash(
    solution: Solution, part: PartSolution, desk: Desk, names: list[str]
) -> Desk | None:
    """The desk with the equation that no number satisfies, and a note of that for each item.

    None where no item has such a reason, and where no velocity is given in a letter.
    """
    if part.branches or not names:
        return None
    if not all(isinstance(item.error, ContradictionError) for item in part.items):
        return None
    for without, number in _with_another_velocity(solution.problem, part.part):
        draft = desk.fork()
        try:
            note = _without_a_root(solution.problem, part.part, without, number, draft, names[0])
        except (*UNPLANNED, RestitutionError, StopIteration):
            continue
        if note is not None:
            for name in names:
                draft.note(name, note.kind, premises=note.premises)
            draft.withheld = frozenset()
            return draft
    return None


def _with_another_velocity(problem: Problem, part: Part) -> Iterator[tuple[Problem, int]]:
    """The problem with a velocity that can be in place of one that is given in a letter.

    With the number of its impact, which has no other line, and before which the body met nothing.
    """
    met: set[str] = set()
    last: tuple[Impact, int] | None = None
    for step, events, _ in problem.timeline(part):
        if isinstance(step, Impact):
            last = (step, events) if not met & {step.first, step.second} else None
            met |= {step.first, step.second}
        if not isinstance(step, Given) or last is None or last[0].along is not None:
            continue
        for relation in step.relations:
            match relation:
                case Compare((Quantity("velocity", (Name(body),)) as left, right), ("=",)) if (
                    body in (last[0].first, last[0].second)
                ):
                    other = _another(problem, body, right)
                    if other is None:
                        continue
                    own = replace(relation, operands=(left, other))
                    given = replace(
                        step, relations=tuple(own if e is relation else e for e in step.relations)
                    )
                    parts = (
                        replace(e, steps=tuple(given if s is step else s for s in e.steps))
                        for e in problem.parts
                    )
                    yield replace(problem, parts=tuple(parts)), last[1]


def _another(problem: Problem, body: str, given: Expression) -> Expression | None:
    """A velocity in the same letter along an axis, with the other component as it was before.

    None of a velocity that is not a letter along **i** or **j** and a number along the other.
    """
    (early,) = (sphere.velocity for sphere in problem.spheres if sphere.name == body)
    before = in_letters(early) if isinstance(early, Expression) else None
    value = in_letters(given)
    if not isinstance(value, Vector) or not isinstance(before, Vector):
        return None
    symbols = {e for x in value for e in sp.sympify(x, strict=True).free_symbols}
    if len(symbols) != 1 or sum(bool(x.free_symbols) for x in value) != 1:
        return None
    x, y = (b if not a.free_symbols else a for a, b in zip(value, before, strict=True))
    return tree_of(Vector(tidy(x), tidy(y)))


def _without_a_root(
    problem: Problem, part: Part, without: Problem, number: int, desk: Desk, name: str
) -> Note | None:
    """The lines of Newton's law along the change of velocity, and that it has no root."""
    own = next(other for other in solve(without).parts.values() if other.part.label == part.label)
    if len(own.branches) != 1:
        return None
    scene = scene_without(problem, part, without, own, desk, name)
    desk.withheld = frozenset()
    start = len(desk.lines)
    law = write_open_law(scene, number)
    if law is None:
        return None
    last = as_a_quadratic(scene, *law)
    require_followed(scene, desk.lines[start:])
    note = replace(desk.new_note(name, "impossible"), premises=(last,))
    return note if scene.judge.excludes(note) else None


__all__ = ["write_open_clash"]
