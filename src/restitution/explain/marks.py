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

from restitution.explain.steps import Step

_FOLLOWED = frozenset({"impact", "part", "item"})
_HERE = frozenset({"method", "impact", "item"})


def settled(steps: Sequence[Step]) -> tuple[Step, ...]:
    """The steps of a part with marks that agree with each other."""
    seen: set[str] = set()
    out = []
    for step in steps:
        step = _followed(step)
        mark, seen = _earned(step.mark, seen)
        rows = []
        for row in step.rows:
            own, seen = _earned(row.mark, seen)
            rows.append(replace(row, mark=own))
        out.append(replace(step, rows=tuple(rows), mark=mark))
    return tuple(out)


def again(steps: Sequence[Step]) -> list[Step]:
    """The steps of a further solution: of each item only the last A1 counts."""
    last: dict[int | None, tuple[int, int]] = {}
    for index, step in enumerate(steps):
        for line, row in enumerate(step.rows):
            if "A1" in row.mark:
                last[step.item] = (index, line)
    kept = set(last.values())
    return [
        replace(
            step,
            mark="",
            rows=tuple(
                replace(row, mark="A1" if (index, line) in kept else "")
                for line, row in enumerate(step.rows)
            ),
        )
        for index, step in enumerate(steps)
    ]


def _followed(step: Step) -> Step:
    """DM1 and A1ft, by where the values come from that are put in."""
    origins = set(step.uses.values())
    proposed = {
        each for mark in (step.mark, *(row.mark for row in step.rows)) for each in mark.split()
    }
    depends = step.principle is None and bool(origins & _HERE)
    follows = "M1" in proposed and bool(origins & _FOLLOWED)

    def changed(mark: str) -> str:
        words = mark.split()
        if depends:
            words = ["DM1" if each == "M1" else each for each in words]
        if follows:
            words = ["A1ft" if each == "A1" else each for each in words]
        return " ".join(words)

    rows = tuple(replace(row, mark=changed(row.mark)) for row in step.rows)
    return replace(step, rows=rows, mark=changed(step.mark))


def _earned(mark: str, seen: set[str]) -> tuple[str, set[str]]:
    """A mark that has what it needs before it, and the kinds of marks seen after it."""
    words: list[str] = []
    for each in mark.split():
        kind = each
        if each == "DM1" and "M" not in seen:
            kind = "M1"
        elif each.startswith("A1") and not seen & {"M", "B"}:
            if each == "A1*":
                words.append("M1")
                seen = seen | {"M"}
            else:
                kind = "B1"
        words.append(kind)
        seen = seen | {kind.lstrip("D")[0]}
    return " ".join(words), seen


__all__ = ["again", "settled"]
