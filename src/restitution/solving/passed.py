"""Places asked at a time by which a body would have come to a wall, where no impact is told."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.errors import RestitutionError
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    AtTime,
    Name,
    Number,
    Pair,
    Quantity,
    Unit,
    unsigned,
    walk,
)
from restitution.problem import Problem, Value, Wall, bodies_of
from restitution.solving.equations.solution import ItemResult, PartSolution


def walls_passed(problem: Problem, part: PartSolution) -> Iterator[str]:
    """A warning for each wall that a body would pass on its way to a place that is asked.

    Only numbers are looked at: a time in numbers, and walls along **i** or **j** without ends.
    """
    if len(part.branches) != 1:
        return
    for (_, now), result in zip(problem.asked(part.part), part.items, strict=True):
        if isinstance(result.item, Value) and result.error is None:
            for node in walk(result.item.expression):
                match node:
                    case Quantity("position", (Name(body),), AtTime(Number())):
                        yield from _passed(problem, part, result, node, body, now)


def _passed(
    problem: Problem,
    part: PartSolution,
    result: ItemResult,
    place: Quantity,
    body: str,
    now: int,
) -> Iterator[str]:
    """The walls between the last event of a body, of those told so far, and its place at a time."""
    story = enumerate(problem.events[:now], 1)
    events = [n for n, event in story if body in bodies_of(event)]
    last = max(events, default=0)
    (branch,) = part.branches
    evaluator = branch.story.evaluator(now)
    assert isinstance(place.stage, AtTime)
    try:
        end = evaluator.vector(place)
        velocity = evaluator.vector(Quantity("velocity", (Name(body),), last))
        start_time = evaluator.scalar(Quantity("time", (), last))
        duration = evaluator.scalar(place.stage.time) - start_time
        start = end - velocity * duration
    except RestitutionError:
        return
    numbers = (sp.sympify(value, strict=True) for value in (*start, *end, duration))
    if not all(number.is_number for number in numbers) or bool(duration <= 0):
        return
    sphere = next(sphere for sphere in problem.spheres if sphere.name == body)
    for wall in problem.walls:
        level = level_of(wall) if sphere.radius is None else None
        if level is not None and level[1].is_number:
            axis, at = level
            if bool((start[axis] - at) * (end[axis] - at) < 0):
                yield (
                    f"{body} comes to {wall.name} before the time at which {result.text} is asked, "
                    f"and no impact is told there: write '{body} hits {wall.name}'"
                )


def level_of(wall: Wall) -> tuple[int, sp.Expr] | None:
    """Across which axis a wall stands, 0 for **i**, and at which coordinate.

    None of a wall that is not along **i** or **j**, or of which no point is known.
    """
    along = unsigned(wall.along)
    match along, wall.through:
        case Unit(unit), Pair(x, y):
            axis = 0 if unit == "j" else 1
            return axis, sp.sympify(in_letters((x, y)[axis]), strict=True)
    return None


__all__ = ["level_of", "walls_passed"]
