"""Directions that facts give to walls and lines of centres, as data of these.

``given W parallel to 3i + 4j`` says of a wall what ``wall W: along 3i + 4j`` says, and so for a
line of centres. Only facts in force from the beginning are taken so, and only directions in
numbers: where letters are sought by a direction, it stays a fact.
"""

from __future__ import annotations

from dataclasses import replace

from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Negate,
    Pair,
    Quantity,
    Unit,
    has_quantity,
    letters,
    walk,
)
from restitution.problem import (
    Aligned,
    Compare,
    Event,
    Find,
    Given,
    Impact,
    Problem,
    Relation,
    Show,
    Step,
    Wall,
)


def with_directions(problem: Problem) -> Problem:
    """The problem with such facts as data, where no direction was given otherwise."""
    (first, *others) = problem.parts
    alone = not others
    walls = {wall.name: wall for wall in problem.walls}
    # Where spheres have places, these give the line of centres.
    loose = {sphere.name for sphere in problem.spheres if sphere.position is None}
    steps: list[Step] = list(first.steps)
    impacts = [n for n, step in enumerate(steps) if isinstance(step, Event)]
    for n, step in enumerate(steps):
        if alone and isinstance(step, Find | Show):
            break
        if not isinstance(step, Given):
            continue
        events = [m for m in impacts if m < n]
        kept: list[Relation] = []
        for relation in step.relations:
            pair = _direction_of(relation)
            match pair:
                case (Name(wall), along) if wall in walls and _is_open(walls[wall]):
                    walls[wall] = replace(walls[wall], along=along)
                case (Quantity("line_of_centres", _, int() | None as stage), along) if (
                    at := _impact_of(steps, events, stage)
                ) is not None and {at[1].first, at[1].second} <= loose:
                    steps[at[0]] = replace(at[1], along=along)
                    if not isinstance(relation, Aligned):
                        kept.append(relation)  # its sense is not that of a line
                case _:
                    kept.append(relation)
        if tuple(kept) != step.relations:
            steps[n] = replace(step, relations=tuple(kept))
    changed = [step for step in steps if not (isinstance(step, Given) and not step.relations)]
    if tuple(changed) == first.steps:
        return problem
    return replace(
        problem,
        walls=tuple(walls[wall.name] for wall in problem.walls),
        parts=(replace(first, steps=tuple(changed)), *others),
    )


def _direction_of(relation: Relation) -> tuple[Expression, Expression] | None:
    """What a fact gives a direction to, and the direction in numbers; None of other facts."""
    match relation:
        case Aligned(left, "parallel to", right):
            pairs = [(left, right), (right, left)]
        case Compare((left, right), ("=",)):
            pairs = [
                (one, other)
                for one, other in ((left, right), (right, left))
                if isinstance(one, Quantity) and one.kind in ("direction", "line_of_centres")
            ]
        case _:
            return None
    for subject, along in pairs:
        if has_quantity(along) or letters(along) or isinstance(along, Name):
            continue
        match subject:
            case Quantity("direction", (Name() as wall,)) | (Name() as wall):
                return wall, _without_size(along)
            case Quantity("line_of_centres"):
                return subject, _without_size(along)
    return None


def _without_size(vector: Expression) -> Expression:
    """A vector without a number in front of it, or below it: (3i + 4j)/5 goes along 3i + 4j."""
    match vector:
        case Binary("/", whole, size) | Binary("*", size, whole) if _is_vector(whole):
            return vector if _is_vector(size) or isinstance(size, Negate) else whole
    return vector


def _is_vector(tree: Expression) -> bool:
    return any(isinstance(each, Unit | Pair) for each in walk(tree))


def _is_open(wall: Wall) -> bool:
    """Whether nothing else gives the direction of a wall."""
    return wall.along is None and wall.start is None and wall.centre is None


def _impact_of(
    steps: list[Step], events: list[int], stage: int | None
) -> tuple[int, Impact] | None:
    """The impact of two spheres to which a line of centres belongs, if its direction is open."""
    number = len(events) if stage is None else stage
    if not 0 < number <= len(events):
        return None
    at = events[number - 1]
    impact = steps[at]
    if not isinstance(impact, Impact) or impact.along is not None or impact.offset is not None:
        return None
    return at, impact


__all__ = ["with_directions"]
