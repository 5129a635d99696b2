"""Directions that facts give to walls and lines of centres, as data of these.

``given W parallel to 3i + 4j`` says of a wall what ``wall W: along 3i + 4j`` says, and so for a
line of centres, also where places would tell another. Only directions in numbers are taken so, and
velocities before the impact: where letters are sought by a direction, it stays a fact.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Negate,
    Quantity,
    has_quantity,
    is_quantity,
    is_vector,
    letters,
    walk,
)
from restitution.problem import (
    Aligned,
    Compare,
    Given,
    Impact,
    Part,
    Problem,
    Relation,
    Step,
    Wall,
)


def with_given_directions(problem: Problem) -> Problem:
    """The problem with such facts as data, where no direction was given otherwise.

    A fact of a part does not hold in the others, in which there is the wall, and in which the
    impact has happened, too.
    """
    walls = {wall.name: wall for wall in problem.walls}
    impacts: dict[int, Impact] = {}
    givens: dict[int, Given] = {}
    last = problem.parts[-1]
    for part, step, number in _facts(problem):
        alone = part.label is None
        kept: list[Relation] = []
        for relation in step.relations:
            wall = _given_wall(relation, walls)
            line = _given_line(problem, relation, number)
            if wall is not None and alone:
                name, along = wall
                walls[name] = replace(walls[name], along=along)
                continue
            if (
                line is None
                or id(line[0]) in impacts
                or not (alone or (part is last and line[0] in part.events))
            ):
                kept.append(relation)
                continue
            impact, along = line
            impacts[id(impact)] = replace(impact, along=along)
            if not isinstance(relation, Aligned) or relation.relation != "parallel to":
                kept.append(relation)  # it tells the sense too
        givens[id(step)] = replace(step, relations=tuple(kept))
    if not impacts and tuple(walls.values()) == problem.walls:
        return problem
    steps: dict[int, Step] = {**givens, **impacts}
    parts = tuple(
        replace(part, steps=tuple(_without_empty(steps.get(id(e), e) for e in part.steps)))
        for part in problem.parts
    )
    return replace(problem, walls=tuple(walls.values()), parts=parts)


def _facts(problem: Problem) -> Iterator[tuple[Part, Given, int]]:
    """The facts with their part, and the number of the event after which they stand."""
    for step, number, part in problem.timeline():
        if isinstance(step, Given):
            yield part, step, number


def _given_wall(relation: Relation, walls: dict[str, Wall]) -> tuple[str, Expression] | None:
    """The wall to which a fact gives a direction, and that; None of another fact."""
    match relation:
        case Aligned(one, "parallel to", other) | Compare((one, other), ("=",), None):
            pass
        case _:
            return None
    for subject, along in ((one, other), (other, one)):
        match subject:
            case Quantity("direction", (Name(name),)):
                pass
            case Name(name) if isinstance(relation, Aligned):
                pass
            case _:
                continue
        if name in walls and _is_open(walls[name]) and _is_in_numbers(along):
            return name, _without_size(along)
    return None


def _given_line(
    problem: Problem, relation: Relation, latest: int
) -> tuple[Impact, Expression] | None:
    """The impact of which a fact gives the line of centres, and that; None of another fact."""
    match relation:
        case Aligned(left, "parallel to" | "in the direction of" | "opposite to", right):
            pass
        case Compare((left, right), ("=",), None):
            pass
        case _:
            return None
    if is_quantity(right, "line_of_centres"):
        left, right = right, left
    match left:
        case Quantity("line_of_centres", (), stage):
            number = latest if stage is None else stage
        case _:
            return None
    if not isinstance(number, int) or not 0 < number <= len(problem.events):
        return None
    event = problem.events[number - 1]
    if not isinstance(event, Impact) or event.along is not None or event.offset is not None:
        return None
    spheres = {sphere.name for sphere in problem.spheres}
    if not {event.first, event.second} <= spheres:
        return None
    if _is_in_numbers(right):
        return event, _without_size(right)
    parallel = isinstance(relation, Aligned) and relation.relation == "parallel to"
    return (event, right) if parallel and _is_met_with(problem, right, number) else None


def _is_met_with(problem: Problem, tree: Expression, number: int) -> bool:
    """Whether a tree is a velocity before an impact by which no letter of the data is sought."""
    match tree:
        case Quantity("velocity", (Name(body),), int(stage)) if stage < number:
            pass
        case _:
            return False
    sought = {letter.name for letter in problem.letters_asked()}
    given = next((sphere.velocity for sphere in problem.spheres if sphere.name == body), None)
    return isinstance(given, Expression) and not sought & letters(given)


def _is_open(wall: Wall) -> bool:
    """Whether nothing else gives the direction of a wall."""
    return wall.along is None and wall.start is None and wall.centre is None


def _is_in_numbers(along: Expression) -> bool:
    return not (
        has_quantity(along) or letters(along) or any(isinstance(e, Name) for e in walk(along))
    )


def _without_size(vector: Expression) -> Expression:
    """A vector without a number in front of it, or below it: (3i + 4j)/5 goes along 3i + 4j."""
    match vector:
        case Binary("/", whole, size) | Binary("*", size, whole) if is_vector(whole):
            return vector if is_vector(size) or isinstance(size, Negate) else whole
    return vector


def _without_empty(steps: Iterable[Step]) -> Iterator[Step]:
    """The steps without facts of which nothing is left."""
    for step in steps:
        if not isinstance(step, Given) or step.relations:
            yield step


__all__ = ["with_given_directions"]
