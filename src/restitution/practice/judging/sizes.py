"""The sizes that a quantity has in the samples of a world."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.evaluate import Angle
from restitution.expression.tree import Expression
from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.world import World
from restitution.vector import Vector

_TINY = 1e-6


def numbers_in(world: World, tree: Expression) -> Iterator[float]:
    """The size of a quantity that is the same in all samples; of an angle in degrees too."""
    try:
        value = world.value(tree)
    except RestitutionError:
        return
    if isinstance(value, Vector):
        return
    angular = isinstance(value, Angle)
    numbers = np.abs(world.spread(value.measure() if isinstance(value, Angle) else value))
    if np.ptp(numbers) < 1e-9 * (1 + numbers[0]):
        yield float(np.degrees(numbers[0]) if angular else numbers[0])


def varying_size(tree: Expression, world: World) -> Array | None:
    """The size of a component in every sample, where these differ and none is zero."""
    try:
        size = np.abs(world.spread(world.scalar(tree)))
    except RestitutionError:
        return None
    return size if size.min() > 0 and np.ptp(size) > _TINY * size.max() else None
