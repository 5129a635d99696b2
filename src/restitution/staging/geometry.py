"""Vectors in floats."""

from __future__ import annotations

import math
from typing import Any

from restitution.vector import Vector


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
