"""Walls that a sphere does not meet between their ends: where it comes to the line of such a wall.

The story is told as far as that, of a wall without ends, and has a solution. In that the place is
written, and a note that it is not between the ends.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from restitution.errors import ImpossibleError, RestitutionError
from restitution.explaining.lines.derivation import Link, Note, Relation
from restitution.explaining.lines.trees import settled
from restitution.expression.tree import Binary, Expression, Name, Quantity, Unit
from restitution.planning.clashes import scene_without, with_what_is_needed
from restitution.planning.inequalities.claims import Claims
from restitution.planning.routes.order import Solver
from restitution.planning.unfinished import require_followed
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import UNPLANNED, Desk
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.problem import Find, Impact, Part, Problem, Step, Value
from restitution.shapes import Segment
from restitution.solving import solve
from restitution.solving.equations.solution import PartSolution, Solution
from restitution.vector import Vector


def write_missed_wall(
    solution: Solution, part: PartSolution, desk: Desk, names: list[str]
) -> Desk | None:
    """The desk with the place where a wall would be met, and a note for each item.

    None where no item has such a reason, and where no lines tell the place.
    """
    errors = [item.error for item in part.items]
    if part.branches or not all(isinstance(error, ImpossibleError) for error in errors):
        return None
    reason = next(error.because or error.message for error in errors if error is not None)
    problem = solution.problem
    for step, number in _impacts(problem, part.part):
        wall = next((wall for wall in problem.walls if wall.name == step.second), None)
        shape = None if wall is None else wall.shape
        if not isinstance(shape, Segment) or not {step.first, step.second} <= set(
            re.findall(r"\w+", reason)
        ):
            continue
        draft = desk.fork()
        try:
            note = _missed(problem, part.part, draft, step, number, shape, names[0])
        except (*UNPLANNED, RestitutionError):
            continue
        if note is not None:
            for name in names:
                plain = reason.partition(":")[0]
                draft.note(name, note.kind, plain, premises=note.premises, claim=note.claim)
            draft.withheld = frozenset()
            return draft
    return None


def _impacts(problem: Problem, part: Part) -> Iterator[tuple[Impact, int]]:
    for step, number, _ in problem.timeline(part):
        if isinstance(step, Impact):
            yield step, number


def _missed(
    problem: Problem,
    part: Part,
    desk: Desk,
    step: Impact,
    number: int,
    shape: Segment,
    name: str,
) -> Note | None:
    """The lines of the place where a sphere comes to the line of a wall, and what that excludes."""
    without = _prolonged(problem, step, shape)
    own = next(other for other in solve(without).parts.values() if other.part.label == part.label)
    if len(own.branches) != 1:
        return None
    scene = scene_without(problem, part, without, own, desk, name)
    start = len(desk.lines)
    place = settled(Quantity("position", (Name(step.first),), number), desk.events)
    assert isinstance(place, Quantity)
    with Claims(scene, Solver(scene)) as claims:
        line = claims.worths.quantity(place)
    require_true(scene.model, desk.lines[start:], desk.lines, desk.facts)
    require_followed(scene, desk.lines[start:])
    for bound in _between(scene, place, shape, scene.value(place)):
        claim = Relation(((bound,),))
        note = replace(desk.new_note(name, "impossible"), premises=(line,), claim=claim)
        if scene.judge.excludes(note):
            return with_what_is_needed(scene, note)
    return None


def _between(scene: Scene, place: Quantity, shape: Segment, there: object) -> Iterator[Link]:
    """What is so between the ends of a wall, coordinate by coordinate."""
    ends = [scene.value(end) for end in (shape.start, shape.end)]
    assert all(isinstance(end, Vector) for end in ends)
    for axis in ("i", "j"):
        low, high = (end.x if axis == "i" else end.y for end in ends)
        if scene.model.sign(expanded(high - low)) < 0:
            low, high = high, low
        subject = Quantity("along", (place, Unit(axis)))
        yield Link(subject, "<", tree_of(high))
        yield Link(subject, ">", tree_of(low))


def _prolonged(problem: Problem, event: Impact, shape: Segment) -> Problem:
    """A problem as far as an impact with a wall, of which the ends are forgotten."""
    assert isinstance(shape.start, Expression)
    assert isinstance(shape.end, Expression)
    along = Binary("-", shape.end, shape.start)
    walls = tuple(
        replace(wall, start=None, end=None, along=along, through=shape.start)
        if wall.name == event.second
        else wall
        for wall in problem.walls
    )
    asked = Find((Value(Quantity("position", (Name(event.first),))),))
    parts: list[Part] = []
    ended = False
    for part in problem.parts:
        steps: list[Step] = []
        for step in () if ended else part.steps:
            steps.append(step)
            if step is event:
                ended = True
                steps.append(asked)
                break
        parts.append(replace(part, steps=tuple(steps)))
    return replace(problem, walls=walls, parts=tuple(parts))


__all__ = ["write_missed_wall"]
