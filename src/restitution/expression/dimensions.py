"""Dimensions: what a value is measured in, by its powers of mass, length and time."""

from __future__ import annotations

from typing import TypeAlias

Dimension: TypeAlias = tuple[int, int, int]

NONE: Dimension = (0, 0, 0)
MASS: Dimension = (1, 0, 0)
LENGTH: Dimension = (0, 1, 0)
TIME: Dimension = (0, 0, 1)
SPEED: Dimension = (0, 1, -1)
IMPULSE: Dimension = (1, 1, -1)
ENERGY: Dimension = (1, 2, -2)


def times(left: Dimension | None, right: Dimension | None, power: int) -> Dimension | None:
    """The dimension of a product (power 1) or of a quotient (-1)."""
    if left is None or right is None:
        return None
    a, b = left, right
    return (a[0] + power * b[0], a[1] + power * b[1], a[2] + power * b[2])
