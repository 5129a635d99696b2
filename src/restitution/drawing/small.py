"""A picture made small: without words, and with what is left of it in stronger lines.

Lines keep the width that they have on paper while everything else shrinks, so that they stay
visible at the size of a stamp.
"""

from __future__ import annotations

from dataclasses import replace
from typing import assert_never

from restitution.drawing.ink import ink
from restitution.drawing.scene import (
    Arc,
    Arrow,
    Disc,
    Dot,
    Line,
    Polyline,
    RightAngle,
    RoundWall,
    Scene,
    Shape,
    StraightWall,
)
from restitution.vector import Vector

WIDTH, HEIGHT = 40.0, 26.0
EDGE = 1.5
LARGEST = 0.8  # of the natural size: a sphere alone is not to fill the picture
_SHOWN_ROLES = {"velocity", "path", "line_of_centres"}


def small(scene: Scene) -> Scene:
    """The walls, spheres, paths and velocities of a picture, in a box of one size for all."""
    shapes = [shape for shape in scene.shapes if _is_shown(shape)]
    shapes += [
        Line(
            "frame", Vector(right.box[0] - 1, right.box[1]), Vector(right.box[0] - 1, right.box[3])
        )
        for right in scene.panels[1:]
    ]
    boxes = [piece.box for shape in shapes for piece in ink(shape)]
    left, bottom = min(box[0] for box in boxes), min(box[1] for box in boxes)
    right, top = max(box[2] for box in boxes), max(box[3] for box in boxes)
    scale = min(
        LARGEST,
        (WIDTH - 2 * EDGE) / max(right - left, 1e-9),
        (HEIGHT - 2 * EDGE) / max(top - bottom, 1e-9),
    )
    shift = Vector(WIDTH / 2, HEIGHT / 2) - Vector((left + right) / 2, (bottom + top) / 2) * scale
    return Scene(
        scene.title,
        scene.title,
        (0.0, 0.0, WIDTH, HEIGHT),
        tuple(_put(shape, scale, shift) for shape in shapes),
    )


def _is_shown(shape: Shape) -> bool:
    match shape:
        case Line(role) | Arrow(role) | Polyline(role):
            return role in _SHOWN_ROLES
        case Arc() | RightAngle():
            return False
        case Disc() | Dot() | StraightWall() | RoundWall():
            return True
    assert_never(shape)


def _put(shape: Shape, scale: float, shift: Vector) -> Shape:
    """The shape made smaller and moved; a dot keeps its size."""

    def at(point: Vector) -> Vector:
        return point * scale + shift

    match shape:
        case Line() | Arrow() | StraightWall():
            return replace(shape, start=at(shape.start), end=at(shape.end))
        case Polyline():
            return replace(shape, points=tuple(map(at, shape.points)))
        case Disc() | RoundWall() | Arc():
            return replace(shape, centre=at(shape.centre), radius=shape.radius * scale)
        case Dot():
            return replace(shape, centre=at(shape.centre))
        case RightAngle():
            return replace(shape, corner=at(shape.corner), size=shape.size * scale)
    assert_never(shape)
