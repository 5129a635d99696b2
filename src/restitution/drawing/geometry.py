"""The sides of a point that a direction on paper is nearest to."""

from __future__ import annotations

import math

from restitution.drawing.scene import Side
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


def sides_towards(direction: Vector) -> tuple[Side, ...]:
    """All sides, those nearest to a direction first; of two as near, the first anticlockwise."""
    return tuple(sorted(COMPASS, key=lambda side: -round(COMPASS[side].dot(direction), 9)))
