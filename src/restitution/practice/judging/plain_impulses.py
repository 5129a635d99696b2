"""Impulses, and velocities after them, that a line shows by itself to be wrong in a usual way."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import permutations

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    COMPONENTS,
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Quantity,
    is_quantity,
    unsigned,
    walk,
)
from restitution.practice.judging.claimed import has_value, meant_by
from restitution.practice.judging.entries import Entry
from restitution.practice.script import Claim
from restitution.practice.worlds.world import World
from restitution.problem import trees

_NEAR = 0.006
"""What a student's own rounding may move a speed by: 2 for 2.003."""


def is_impulse_of_speeds(entry: Entry, world: World) -> bool:
    """Whether an impulse is a mass times the difference, or the sum, of whole speeds.

    They are those of one body before and after, rounded as the student has them.
    """
    meant = meant_by(entry)
    meant = unsigned(meant)
    if not is_quantity(meant, "impulse"):
        return False
    number = meant.stage if isinstance(meant.stage, int) else len(world.events)
    for body in world.start:
        mass = Quantity("mass", (Name(body),))
        speeds = (Quantity("speed", (Name(body),), stage) for stage in (number - 1, number))
        wanted = [Binary("*", mass, speed) for speed in speeds]
        changes = (Binary(op, *wanted) for op in ("+", "-"))
        if any(_are_near(change, meant, entry, world) for change in changes):
            continue  # along one line speeds are components, and a sign is wrong
        for terms in _two_terms(entry.claim.right):
            for one, other in permutations(terms):
                if _are_near(one, wanted[0], entry, world) and _are_near(
                    other, wanted[1], entry, world
                ):
                    return True
    return False


def is_change_of_momentum(impulse: Expression, value: Expression, world: World) -> bool:
    """Whether numbers add or subtract the momenta of one body before and after an impulse.

    So do ``2 × 4 - 2 × 2`` and ``2(4 - 2)``, whatever the components are taken for.
    """
    if not is_quantity(impulse, "impulse"):
        return False
    number = impulse.stage if isinstance(impulse.stage, int) else len(world.events)
    if number not in world.lines:
        return False
    entry = Entry(0, Claim(impulse, "=", value))
    line = Quantity("line_of_centres", (), number)
    for body in world.start:
        mass = Quantity("mass", (Name(body),))
        velocities = [Quantity("velocity", (Name(body),), n) for n in (number - 1, number)]
        momenta = [
            [Binary("*", mass, Quantity(kind, (v, line))) for kind in COMPONENTS]
            for v in velocities
        ]
        for terms in _two_terms(value):
            for one, other in permutations(terms):
                before = any(_are_near(one, momentum, entry, world) for momentum in momenta[0])
                if before and any(
                    _are_near(other, momentum, entry, world) for momentum in momenta[1]
                ):
                    return True
    return False


def _two_terms(tree: Expression) -> Iterator[tuple[Expression, Expression]]:
    """The two terms of a change of momentum: of ``m(v - u)`` and of ``mv - mu``."""
    match tree:
        case Negate(operand):
            yield from _two_terms(operand)
        case Binary("+" | "-", left, right):
            yield left, right
        case Binary("*", left, right):
            for factor, inside in ((left, right), (right, left)):
                for one, other in _two_terms(inside):
                    yield Binary("*", factor, one), Binary("*", factor, other)


def _are_near(own: Expression, wanted: Expression, entry: Entry, world: World) -> bool:
    """Whether a term has the size of another, but for the student's rounding."""
    try:
        size = np.abs(world.spread(world.scalar(own, entry.meanings, scope=entry.scope)))
        other = np.abs(world.spread(world.scalar(wanted)))
    except RestitutionError:
        return False
    return bool(np.all(other > 0) and np.all(np.abs(size - other) <= _NEAR * other))


def is_impulse_reversed(entry: Entry, world: World) -> bool:
    """Whether a velocity after an impulse is worked out with the impulse in the other sense."""
    given = (node for tree in trees(world.problem) for node in walk(tree))
    if not any(is_quantity(quantity, "impulse") for quantity in given):
        return False
    meant = meant_by(entry)
    inside = unsigned(meant)
    match inside:
        case Quantity("velocity", _, int(stage)) if stage:
            after: Expression = inside
        case Quantity("along", (Quantity("velocity", _, int(stage)), _)) if stage:
            after = inside
        case _:
            return False
    twice = Binary("*", Number(Fraction(2)), _at_stage(after, stage - 1))
    value: Expression = Binary("-", twice, after)
    value = Negate(value) if inside is not meant else value
    return has_value(value, entry.claim.right, entry, world)


def _at_stage(tree: Expression, stage: int) -> Expression:
    match tree:
        case Quantity("velocity", arguments):
            return Quantity("velocity", arguments, stage)
        case Quantity("along", (velocity, axis)):
            return Quantity("along", (_at_stage(velocity, stage), axis))
    return tree
