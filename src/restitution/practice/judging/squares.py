"""Squares that a student may have left out: of what has one in a story, a speed or a component."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import product

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Expression,
    Name,
    Number,
    Quantity,
    Unit,
    is_binary,
    is_function,
    walk,
)
from restitution.practice.judging.claimed import has_value
from restitution.practice.judging.entries import Entry
from restitution.practice.judging.slips import Correction
from restitution.practice.worlds.arrays import Array, is_bare
from restitution.practice.worlds.world import World
from restitution.problem import Impact


def is_worth(tree: Expression, entry: Entry, world: World, sizes: Iterable[Array]) -> bool:
    """Whether a term has the size of one of some quantities, to three figures."""
    try:
        size = np.abs(world.spread(world.scalar(tree, entry.meanings, scope=entry.scope)))
    except RestitutionError:
        return False
    return any(bool(np.all(np.abs(size - other) <= 0.005 * other)) for other in sizes)


def _is_square_put(correction: Correction) -> bool:
    """Whether a correction squares a number or a letter."""
    square = is_binary(correction.put, "^")
    return correction.change == "square" or (correction.change == "power" and square)


def is_square_of_a_size(
    correction: Correction, mended: Sequence[Correction], entry: Entry, world: World
) -> bool:
    """Whether a correction squares what has a square: a speed, a component, a coefficient.

    That the square of a mass, or the 2 of a half, makes a line true is a coincidence.
    """
    part = correction.part
    if not _is_square_put(correction):
        return False
    alone = all(other.part == part for other in mended)
    return alone or not is_bare(part) or is_worth(part, entry, world, _sizes(world))


def _sizes(world: World) -> Iterator[Array]:
    """The sizes of all speeds, components and coefficients of a story."""
    events = (step for step in world.events if isinstance(step, Impact))
    trees: list[Expression] = [step.e for step in events if step.e is not None]
    lines = [Quantity("line_of_centres", (), number) for number in world.lines]
    for body, stage in product(world.start, range(len(world.events) + 1)):
        velocity = Quantity("velocity", (Name(body),), stage)
        trees.append(Quantity("speed", (Name(body),), stage))
        trees += [Quantity(kind, (velocity, line)) for kind in COMPONENTS for line in lines]
        trees += [Quantity("along", (velocity, unit)) for unit in (Unit("i"), Unit("j"))]
    for tree in trees:
        with suppress(RestitutionError):
            yield np.abs(world.spread(world.scalar(tree)))


def is_root_without_squares(entry: Entry, world: World) -> bool:
    """Whether a speed is the root of the components, where it is that of their squares.

    In ``√(8 + 2)`` both squares are missing, and so none is by a slip.
    """
    root = entry.claim.right
    if not (is_function(root, "sqrt") and is_binary(root.argument, "+")):
        return False
    terms = (root.argument.left, root.argument.right)
    if any(is_binary(node, "^") for term in terms for node in walk(term)):
        return False
    left, right = (Binary("^", term, Number(Fraction(2))) for term in terms)
    squared = Apply("sqrt", Binary("+", left, right))
    return has_value(entry.claim.left, squared, entry, world)
