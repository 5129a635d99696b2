"""Marks as an examiner would give them: M, A, B, DM, ft and A1*.

The working proposes M1, A1 and B1 beside its lines; here they are made to agree with each other,
part by part:

- **M1** for a principle or a method with its values put in, **A1** for the line being right, and
  for an answer. A value on the way to another value earns none of its own.
- **B1** for what stands by itself: a component that does not change, one read off the data, an
  answer that no method was needed for.
- **DM1** for what cannot be done without an earlier method of the same part: solving equations
  simultaneously, a speed, angle or energy from components that had to be found, a given fact or
  a condition put in terms of these. A principle (momentum, restitution, impulse) is a method by
  itself, and stays M1 whatever is put into it.
- **A1ft** beside such a line if a value in it was found at an earlier impact, in an earlier part
  or as an earlier answer: a slip made there has cost its mark already.
- **A1*** for a printed result that is to be shown, and never ft.
- Of several solutions the methods count once, and each further one adds its answers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from restitution.explain.steps import Explanation, PartExplanation, Step
from restitution.explaining.marks import A1, B1, M1, Mark, Marks, Style, reasoned
from restitution.problem import Problem

_FOLLOWED = frozenset({"impact", "part", "item"})
_HERE = frozenset({"method", "impact", "item"})


def settled(steps: Sequence[Step]) -> tuple[Step, ...]:
    """The steps of a part with marks that agree with each other, each with its reason."""
    seen: set[str] = set()
    out = []
    for step in steps:
        step = _followed(step)
        points, seen = _earned(step.points, seen)
        rows = []
        for row in step.rows:
            own, seen = _earned(row.points, seen)
            rows.append(replace(row, points=own))
        out.append(replace(step, rows=tuple(rows), points=points))
    return tuple(out)


def again(steps: Sequence[Step]) -> list[Step]:
    """The steps of a further solution: of each item only the last A1 counts."""
    last: dict[int | None, tuple[int, int]] = {}
    for index, step in enumerate(steps):
        for line, row in enumerate(step.rows):
            if any(mark.kind == "A" for mark in row.points):
                last[step.item] = (index, line)
    kept = set(last.values())
    return [
        replace(
            step,
            points=(),
            rows=tuple(
                replace(row, points=(A1,) if (index, line) in kept else ())
                for line, row in enumerate(step.rows)
            ),
        )
        for index, step in enumerate(steps)
    ]


def in_style(explanation: Explanation, style: Style) -> Explanation:
    """The same with marks in a style, or without any.

    A part that has a derivation is marked anew, by rule. Any other keeps its marks in every style
    but ``none``.
    """
    problem = None if explanation.solution is None else explanation.solution.problem
    parts = tuple(_part_in_style(each, problem, style) for each in explanation.parts)
    return replace(explanation, parts=parts)


def _part_in_style(part: PartExplanation, problem: Problem | None, style: Style) -> PartExplanation:
    if part.derivation is not None and problem is not None:
        from restitution.explain.derived import explanation_of
        from restitution.explaining.awarding import awarded

        derivation = awarded(part.derivation, style)
        told = explanation_of(derivation, problem).parts
        steps = next((each.steps for each in told if each.label == part.label), part.steps)
        return replace(part, steps=steps, derivation=derivation)
    if style != "none":
        return part
    steps = tuple(
        replace(step, points=(), rows=tuple(replace(row, points=()) for row in step.rows))
        for step in part.steps
    )
    return replace(part, steps=steps)


def without_method(points: Marks) -> Marks:
    """The same without an M1 before other marks: the method has been shown, or is not."""
    return points[1:] if len(points) > 1 and points[0] == M1 else points


def _followed(step: Step) -> Step:
    """DM1 and A1ft, by where the values come from that are put in."""
    origins = set(step.uses.values())
    proposed = {
        mark for points in (step.points, *(row.points for row in step.rows)) for mark in points
    }
    depends = step.principle is None and bool(origins & _HERE)
    follows = M1 in proposed and bool(origins & _FOLLOWED)

    def changed(points: Marks) -> Marks:
        return tuple(
            replace(mark, dependent=True)
            if depends and mark.kind == "M"
            else replace(mark, ft=True)
            if follows and mark == A1
            else mark
            for mark in points
        )

    rows = tuple(replace(row, points=changed(row.points)) for row in step.rows)
    return replace(step, rows=rows, points=changed(step.points))


def _earned(points: Marks, seen: set[str]) -> tuple[Marks, set[str]]:
    """Marks that have what they need before them, and the kinds of marks seen after them."""
    earned: list[Mark] = []
    for mark in points:
        if mark.dependent and "M" not in seen:
            mark = replace(mark, dependent=False)
        elif mark.kind == "A" and not seen & {"M", "B"}:
            if mark.star:
                earned.append(reasoned(M1))
                seen = seen | {"M"}
            else:
                mark = B1
        earned.append(reasoned(mark))
        seen = seen | {mark.kind}
    return tuple(earned), seen


__all__ = ["again", "in_style", "settled", "without_method"]
