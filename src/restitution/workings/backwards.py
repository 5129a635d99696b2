"""The working of a part whose places of contact are roots of roots: from the end, in decimals.

Nobody would write such roots down, and each line that puts them in has longer ones. So the places
are given as they follow from each other, the last first.
"""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.saying import Sentence, say
from restitution.problem import Impact
from restitution.solving.equations.solution import Branch, PartSolution
from restitution.solving.equations.stages import by_nested_roots
from restitution.vector import Vector
from restitution.workings.rendering.steps import Step


def is_told_backwards(part: PartSolution) -> bool:
    """Whether a part is better told from its end."""
    return any(by_nested_roots(branch.values) for branch in part.branches)


def steps_backwards(part: PartSolution) -> tuple[Step, ...]:
    """Where each contact has to be, the last first."""
    steps: list[Step] = []
    several = len(part.branches) > 1
    for branch in part.branches:
        if several:
            steps.append(_note(say("backwards.solution", number=branch.number)))
        steps += [_note(contact) for contact in _contacts(branch)]
    return tuple(steps)


def _note(sentence: Sentence) -> Step:
    return Step("note", sentences=(sentence,))


def _contacts(branch: Branch) -> Iterator[Sentence]:
    for event in reversed(branch.numbers.happenings):
        values = [branch.values.get(f"_c_{event.number}{axis}") for axis in "xy"]
        if any(value is None for value in values) or not isinstance(event.step, Impact):
            continue
        fixed = not any(value is not None and value.free_symbols for value in values)
        first, second = event.step.first, event.step.second
        known = branch.numbers.place(first, event.number)
        point = _point(known[0]) if fixed and known is not None else None
        if second in branch.numbers.walls:
            if point is None:
                yield say("backwards.wall", first=first, second=second)
            else:
                yield say("backwards.wall-at", first=first, second=second, point=point)
        elif point is not None:
            centres = _vector(event.oriented())
            yield say("backwards.sphere-at", first=first, second=second, way=centres, point=point)
        elif fixed:
            centres = _vector(event.oriented())
            yield say("backwards.sphere-along", first=first, second=second, way=centres)
        else:
            yield say("backwards.sphere", first=first, second=second)


def _number(x: float) -> str:
    return f"{float(x):.3g}".replace("-", "\N{MINUS SIGN}")


def _point(v: Vector) -> str:
    return f"({_number(v.x)}, {_number(v.y)})"


def _vector(v: Vector) -> str:
    size = (float(v.x) ** 2 + float(v.y) ** 2) ** 0.5
    return _point(Vector(float(v.x) / size, float(v.y) / size))
