"""Vectors in floats, and the sides of a point that a direction on paper is nearest to."""

from __future__ import annotations

import math
from typing import Any

from restitution.draw.scene import Side
from restitution.vector import Vector

_DIAGONAL = math.sqrt(0.5)
COMPASS: dict[Side, Vector] = {
    "e": Vector(1.0, 0.0),
    "ne": Vector(_DIAGONAL, _DIAGONAL),
    "n": Vector(0.0, 1.0),
    "nw": Vector(-_DIAGONAL, _DIAGONAL),
    "w": Vector(-1.0, 0.0),
    "sw": Vector(-_DIAGONAL, -_DIAGONAL),
    "s": Vector(0.0, -1.0),
    "se": Vector(_DIAGONAL, -_DIAGONAL),
}


def floats(v: Any) -> Vector:
    """A vector of any numbers in floats."""
    return Vector(float(v[0]), float(v[1]))


def length(v: Vector) -> float:
    """The size of a vector."""
    return math.hypot(v.x, v.y)


def unit(v: Vector) -> Vector:
    """The vector of size 1 in this direction; the zero vector stays."""
    return v / (length(v) or 1.0)


def direction(v: Vector) -> Vector:
    """The unit vector along a vector; to the right for the zero vector."""
    return unit(v) if length(v) else Vector(1.0, 0.0)


def still(v: Vector) -> bool:
    """Whether a velocity is zero."""
    return length(v) < 1e-12


def sides_towards(way: Vector) -> tuple[Side, ...]:
    """All sides, those nearest to a direction first; of two as near, the first anticlockwise."""
    return tuple(sorted(COMPASS, key=lambda side: -round(COMPASS[side].dot(way), 9)))
