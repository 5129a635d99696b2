"""The velocity of one sphere by momentum in vectors, with the student's own of the other."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.errors import RestitutionError
from restitution.expression.tree import Binary, Expression, Letter, Name, Quantity, Unit, walk
from restitution.practice.judging.entries import Entry, Meanings
from restitution.practice.script import Claim
from restitution.practice.worlds.telling import Telling
from restitution.practice.worlds.world import World
from restitution.problem import Impact
from restitution.vector import Vector


def spheres_that_meet(world: World) -> Iterator[tuple[int, str, str]]:
    """The impacts of two spheres, each with its number."""
    for number, step in enumerate(world.events, 1):
        if isinstance(step, Impact) and {step.first, step.second} <= world.start.keys():
            yield number, step.first, step.second


def velocity_after(body: str, event: int) -> Quantity:
    """The velocity of a body after an event, as a tree."""
    return Quantity("velocity", (Name(body),), event)


def with_momentum_kept(
    world: World, event: int, bodies: tuple[str, str], own: Entry
) -> World | None:
    """The world in which the first of two spheres has a value given to its velocity after an event.

    The other has what is left of their momentum. None where there is no such value.
    """
    body, other = bodies
    telling = Telling(world)
    try:
        velocity = world.value(own.claim.right, own.meanings, own.scope)
        if not isinstance(velocity, Vector):
            return None
        change = (velocity - telling.velocity(body, event - 1)) * telling.mass(body)
        rest = telling.velocity(other, event - 1) - change * (1 / telling.mass(other))
    except RestitutionError:
        return None
    return world.replaced(after={(event, body): velocity, (event, other): rest})


def momentum_of(event: int, *bodies: str) -> Claim:
    """That the momentum of two spheres is kept in an impact, as vectors."""

    def total(stage: int) -> Expression:
        one, other = (
            Binary("*", Quantity("mass", (Name(body),)), velocity_after(body, stage))
            for body in bodies
        )
        return Binary("+", one, other)

    return Claim(total(event - 1), "=", total(event))


def is_plain_vector(tree: Expression) -> bool:
    """Whether a tree is a vector with at most one term along i and one along j: ``7i - 4j``."""
    return sum(isinstance(node, Unit) for node in walk(tree)) <= 2 and not any(
        isinstance(node, Letter | Name | Quantity) for node in walk(tree)
    )


def are_vectors(claim: Claim, world: World, meanings: Meanings) -> bool:
    """Whether both sides of an equation are vectors."""
    if claim.sign != "=" or claim.others:
        return False
    try:
        sides = [world.value(side, meanings) for side in (claim.left, claim.right)]
    except RestitutionError:
        return False
    return all(isinstance(side, Vector) for side in sides)
