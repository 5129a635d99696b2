"""What a value behind the name of a sphere may be: its velocity, its speed, or where it is."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.expression.tree import (
    AtTime,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
    is_binary,
    is_quantity,
    walk,
)
from restitution.practice.reading.energy_lines import asks_energy
from restitution.practice.reading.readings import Side
from restitution.problem import Find, Problem, trees_of_step


def vectors_of(body: str, problem: Problem) -> tuple[Side, ...]:
    """What a vector behind the name of a sphere may be: its velocity, momentum or impulse.

    Of one whose place is known it may be where it is.
    """
    phrases = (f"velocity of {body}", f"momentum of {body}", f"impulse on {body}")
    momentum, impulse = (Quantity(kind, (Name(body),)) for kind in ("momentum", "impulse"))
    velocity, *others = map(Letter, phrases)
    trees = (velocity, *places_of(body, problem), *others, momentum, impulse, Negate(impulse))
    return tuple(map(Side, trees))


def _is_signed(tree: Expression) -> bool:
    """Whether a value may be negative as it is typed: ``-2``, ``u(2 - 3e)``."""
    return any(isinstance(node, Negate) or is_binary(node, "-") for node in walk(tree))


def worths_of(body: str, value: Expression, problem: Problem) -> tuple[Side, ...]:
    """What a number behind the name of a sphere may be: its speed, a component, an energy, a place.

    What may be negative is a component first.
    """
    phrases = [f"component of {body} along"] if _is_signed(value) else []
    phrases += [f"speed of {body}"]
    phrases += [f"KE of {body} {when}" for when in ("before", "after") if asks_energy(problem)]
    places = (
        Quantity("along", (place, Unit(axis)))
        for place in (*_places_asked(body, problem), *places_of(body, problem))
        for axis in ("i", "j")
        if is_quantity(place, "position")
    )
    trees: list[Expression] = [*map(Letter, phrases), *places]
    return tuple(map(Side, trees))


def _places_asked(body: str, problem: Problem) -> Iterator[Expression]:
    """The places of a sphere for which the question asks: ``position(A, at 3)``."""
    for _, step in problem.steps():
        for tree in trees_of_step(step) if isinstance(step, Find) else ():
            for node in walk(tree):
                if is_quantity(node, "position") and Name(body) in node.arguments:
                    yield node


def places_of(body: str, problem: Problem) -> tuple[Expression, ...]:
    """Where a sphere is at each event, if its place is known.

    Else it is where it has come to by a moment that is asked for, from where the spheres meet.
    """
    stages = range(len(problem.events) + 1)
    if any(sphere.name == body and sphere.position is not None for sphere in problem.spheres):
        return tuple(Quantity("position", (Name(body),), stage) for stage in stages)
    return tuple(
        Binary("*", time, Quantity("velocity", (Name(body),), stage))
        for time in _times_asked(body, problem)
        for stage in reversed(stages[1:])
    )


def _times_asked(body: str, problem: Problem) -> Iterator[Expression]:
    """The times at which the question asks how far a sphere is from another one."""
    for _, step in problem.steps():
        for tree in trees_of_step(step) if isinstance(step, Find) else ():
            for node in walk(tree):
                match node:
                    case Quantity("distance", arguments, AtTime(time)) if Name(body) in arguments:
                        yield time
