"""The working of a part whose places of contact are roots of roots: from the end, in decimals.

Nobody would write such roots down, and each line that puts them in has longer ones. So the places
are given as they follow from each other, the last first, and the answers as they are.
"""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explain.steps import Step, Words
from restitution.problem import Impact
from restitution.solve.solution import Branch, PartSolution
from restitution.solve.stages import by_nested_roots
from restitution.vector import Vector


def is_told_backwards(part: PartSolution) -> bool:
    """Whether a part is better told from its end."""
    return any(by_nested_roots(branch.values) for branch in part.branches)


def steps_backwards(part: PartSolution, answers: tuple[str, ...]) -> tuple[Step, ...]:
    """Where each contact has to be, the last first; then the answers."""
    steps: list[Step] = []
    several = len(part.branches) > 1
    for branch in part.branches:
        if several:
            steps.append(_note(f"Solution {branch.number}."))
        steps += [_note(text) for text in _contacts(branch)]
    return (*steps, *(_note(f"{answer}.") for answer in answers))


def _note(text: str) -> Step:
    words: Words = (text,)
    return Step("note", words=words)


def _contacts(branch: Branch) -> Iterator[str]:
    for event in reversed(branch.numbers.happenings):
        values = [branch.values.get(f"_c_{event.number}{axis}") for axis in "xy"]
        if any(value is None for value in values) or not isinstance(event.step, Impact):
            continue
        fixed = not any(value is not None and value.free_symbols for value in values)
        first, second = event.step.first, event.step.second
        known = branch.numbers.place(first, event.number)
        at = f" at {_point(known[0])}" if fixed and known is not None else ""
        if second in branch.numbers.walls:
            yield f"For what follows, {first} has to strike {second}{at}."
            continue
        along = f", along {_vector(event.oriented())}" if fixed else ""
        yield (
            f"{second} is at rest when {first} strikes it, and moves off along the line of "
            f"centres{along}: so {first} has to be{at or ' on that line, in contact'} then."
        )


def _number(x: float) -> str:
    return f"{float(x):.3g}".replace("-", "\N{MINUS SIGN}")


def _point(v: Vector) -> str:
    return f"({_number(v.x)}, {_number(v.y)})"


def _vector(v: Vector) -> str:
    size = (float(v.x) ** 2 + float(v.y) ** 2) ** 0.5
    return _point(Vector(float(v.x) / size, float(v.y) / size))
