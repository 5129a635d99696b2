"""Vectors in numbers that a student worked out wrongly and goes on with: ``v - u = -3i - 2j``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import permutations

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Number,
    has_unit_vector,
    is_quantity,
    letters,
    walk,
)
from restitution.practice.judging.entries import Entry, is_numeric
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.world import World
from restitution.vector import Vector

_SIMPLE = 60
_NEAR, _EXACT = 1e-9, 1e-6
# Values that a letter may have.
_VALUES = (0.37, 0.71)


def with_vectors_put_back(
    claim: Claim, entries: Sequence[Entry], world: World
) -> Iterator[tuple[Claim, int]]:
    """A claim with what a wrong vector in it, or a multiple, stands for; and that vector's line."""
    if claim.others:
        return
    for entry in reversed(entries):
        if entry.right or entry.claim.sign != "=" or is_numeric(entry.claim.left):
            continue
        own = _vector(entry.claim.right, world)
        meant = exchanged(entry.claim.left, {Letter(x): y for x, y in entry.meanings.items()})
        for node in dict.fromkeys((*walk(claim.left), *walk(claim.right))) if own else ():
            factor = _ratio(_vector(node, world), own)
            if factor is None:
                continue
            put: dict[Expression, Expression] = {node: Binary("*", Number(factor), meant)}
            left, right = exchanged(claim.left, put), exchanged(claim.right, put)
            yield replace(claim, left=left, right=right), entry.number


def square_of_own(claim: Claim, entries: Sequence[Entry], world: World) -> int | None:
    """The line of a wrong velocity with a letter in it, of which a claim is the square of the size.

    So ``16e² + 36 = 25`` follows from ``4ei + 6j`` where the speed is 5, whatever e comes out.
    """
    if claim.sign != "=" or claim.others:
        return None
    for entry in reversed(entries):
        left = entry.claim.left
        meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
        unknown = letters(entry.claim.right) & world.letters.keys()
        if entry.right or not is_quantity(meant, "velocity") or len(unknown) != 1:
            continue
        (letter,) = unknown
        for one, other in permutations((claim.left, claim.right)):
            if letters(one) == unknown and not letters(other):
                first, second = (
                    _ratio_at(x, letter, one, entry.claim.right, world) for x in _VALUES
                )
                if first is None or second is None or not np.allclose(first, second, rtol=_EXACT):
                    continue
                size = world.scalar(replace(meant, kind="speed"))
                if np.allclose(first * size**2, world.scalar(other), rtol=_EXACT):
                    return entry.number
    return None


def _ratio_at(
    value: float, letter: str, square: Expression, vector: Expression, world: World
) -> Array | None:
    """The ratio of a tree to the square of the size of a vector, for a value of its letter."""
    other = world.replaced(letters={**world.letters, letter: np.full(world.samples, value)})
    try:
        own, size = other.value(vector), other.scalar(square)
    except RestitutionError:
        return None
    return size / (own.x**2 + own.y**2) if isinstance(own, Vector) else None


def _vector(tree: Expression, world: World) -> tuple[float, float] | None:
    """The components of a vector in numbers; None for any other tree."""
    if not has_unit_vector(tree) or not is_numeric(tree):
        return None
    try:
        value = world.value(tree)
    except RestitutionError:
        return None
    if not isinstance(value, Vector):
        return None
    return float(np.ravel(value.x)[0]), float(np.ravel(value.y)[0])


def _ratio(one: tuple[float, float] | None, other: tuple[float, float] | None) -> Fraction | None:
    """The ratio of two vectors along one line."""
    if one is None or other is None or not all(other) or not np.all(np.isfinite([one, other])):
        return None
    if abs(one[0] * other[1] - one[1] * other[0]) > _NEAR:
        return None
    ratio = Fraction(one[0] / other[0]).limit_denominator(_SIMPLE)
    return ratio or None
