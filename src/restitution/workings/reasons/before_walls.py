"""To which walls a body comes: to none before a time that is asked, or from one to another."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation, Sign
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    AtTime,
    Binary,
    Expression,
    Name,
    Number,
    Quantity,
)
from restitution.planning.writing.forms import coordinates, tree_of
from restitution.problem import Problem, bodies_of
from restitution.solving.passed import level_of
from restitution.vector import Vector


def walls_ahead(
    derivation: Derivation, problem: Problem, line: Line
) -> Iterator[tuple[str, str, Relation]]:
    """The walls to which a body moves at a time in numbers, and has not come by then.

    Each with the body, and with the bound that its coordinate keeps. Nothing of a body that has a
    radius, and of walls that are not along **i** or **j**.
    """
    place = _place_at(line)
    above = None if place is None else _flight(derivation, line)
    if place is None or above is None or any(sphere.radius for sphere in problem.spheres):
        return
    body, end = place
    start, stage = above
    after = [
        n for n, event in enumerate(problem.events, 1) if n > stage and body in bodies_of(event)
    ]
    for wall in () if after else problem.walls:
        level = level_of(wall)
        if level is None:
            continue
        axis, at = level
        first, last = start[axis], end[axis]
        if not all(value.is_number for value in (first, last, at)) or first == last:
            continue
        ahead = bool(at > first) if last > first else bool(at < first)
        if ahead and (last < at if last > first else last > at):
            sign: Sign = "<" if last > first else ">"
            yield body, wall.name, Relation(((Link(tree_of(last), sign, tree_of(at)),),))


def wall_reached(derivation: Derivation, letter: Expression) -> tuple[str, str] | None:
    """The body that leaves a wall by a coefficient, and the parallel wall opposite, which it hits.

    Then that coefficient is not zero. None where no such wall comes next.
    """
    events = {event.number: event for event in derivation.events}
    for number, event in events.items():
        own = derivation.fact(f"e {number}")
        if not event.wall or own is None or own.relation.only[-1].right != letter:
            continue
        body = event.bodies[0]
        after = (
            event for n, event in sorted(events.items()) if n > number and body in event.bodies
        )
        other = next(after, None)
        if other is None or not other.wall:
            continue
        axes = [derivation.fact(f"axis {n}") for n in (number, other.number)]
        normals = [coordinates(axis.relation.only[-1].right) for axis in axes if axis is not None]
        if len(normals) == 2 and None not in normals and _are_opposite(*normals):
            return body, other.bodies[1]
    return None


def _are_opposite(
    one: tuple[Expression, Expression] | None, other: tuple[Expression, Expression] | None
) -> bool:
    """Whether two normals are each the other's opposite."""
    if one is None or other is None:
        return False
    try:
        sums = [in_letters(Binary("+", *pair)) for pair in zip(one, other, strict=True)]
    except RestitutionError:
        return False
    return all(total == 0 for total in sums)


def _place_at(line: Line) -> tuple[str, Vector] | None:
    """The body and its place, of a line that gives the coordinates at a time in numbers."""
    match line.relation:
        case Relation(((Link(Quantity("position", (Name(body),), AtTime(Number())), "="), *_),)):
            parts = coordinates(line.relation.only[-1].right)
        case _:
            return None
    if parts is None:
        return None
    try:
        x, y = (sp.sympify(in_letters(part), strict=True) for part in parts)
    except RestitutionError:
        return None
    return body, Vector(x, y)


def _flight(derivation: Derivation, line: Line) -> tuple[Vector, int] | None:
    """From where a body comes to a place, and after which event."""
    for own in (line, *derivation.lines_in(line.premises)):
        if own.move.record != "straight-line" or own.move.event is None:
            continue
        match own.relation:
            case Relation(((Link(_, "=", right), *_),)):
                first: Expression | None = None
                match right:
                    case Binary("+" | "-", left, _):
                        first = left
                try:
                    start = None if first is None else in_letters(first)
                except RestitutionError:
                    return None
                if isinstance(start, Vector):
                    x, y = (sp.sympify(value, strict=True) for value in start)
                    return Vector(x, y), own.move.event
    return None


__all__ = ["wall_reached", "walls_ahead"]
