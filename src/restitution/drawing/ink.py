"""What the shapes of a scene cover on paper, and whether a box is free of it.

Lengths are in millimetres, y up; a box is left, bottom, right, top.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TypeAlias

from restitution.drawing import style
from restitution.drawing.scene import (
    Arc,
    Arrow,
    Disc,
    Dot,
    Line,
    LineRole,
    Polyline,
    RightAngle,
    RoundWall,
    Shape,
    StraightWall,
)
from restitution.records import dataclass
from restitution.render.glyphs import Box
from restitution.staging.geometry import direction
from restitution.vector import Vector

Segment: TypeAlias = tuple[Vector, Vector]


@dataclass(frozen=True, slots=True)
class Stick:
    """A straight piece of ink with half its width."""

    start: Vector
    end: Vector
    half: float
    box: Box


@dataclass(frozen=True, slots=True)
class Ring:
    """A circle of ink with half its width."""

    centre: Vector
    radius: float
    half: float
    box: Box


Piece: TypeAlias = Stick | Ring


def stick(start: Vector, end: Vector, half: float) -> Stick:
    """A straight piece of ink with its box."""
    return Stick(
        start,
        end,
        half,
        (
            min(start.x, end.x) - half,
            min(start.y, end.y) - half,
            max(start.x, end.x) + half,
            max(start.y, end.y) + half,
        ),
    )


def ring(centre: Vector, radius: float, half: float) -> Ring:
    """A circle of ink with its box."""
    r = radius + half
    return Ring(centre, radius, half, (centre.x - r, centre.y - r, centre.x + r, centre.y + r))


def ink(shape: Shape) -> list[Piece]:
    """What a shape covers on paper."""
    match shape:
        case Line(role, start, end):
            return [stick(start, end, style.STROKES[role].width / 2)]
        case Polyline(role, points):
            half = style.STROKES[role].width / 2
            return [stick(a, b, half) for a, b in pairwise(points)]
        case Arrow(role, start, end, both):
            return _ink_of_arrow(role, start, end, both)
        case Disc(_, centre, radius, ghost):
            return [ring(centre, radius, (style.GHOST if ghost else style.DISC).width / 2)]
        case Dot(_, centre, radius):
            return [stick(centre, centre, radius)]
        case Arc(role, centre, radius, start, end):
            return _sticks(arc_points(centre, radius, start, end), style.STROKES[role].width / 2)
        case RightAngle():
            return _sticks(right_angle_points(shape), style.RIGHT_ANGLE.width / 2)
        case StraightWall(_, start, end, far):
            half = style.HATCH_DEPTH / 2
            across = direction(end - start).turned_left()
            shift = (across if across.dot(far) > 0 else -across) * half
            edge = style.WALL.width / 2
            return [stick(start, end, edge), stick(start + shift, end + shift, half)]
        case RoundWall(_, centre, radius, start, end):
            curve = _sticks(arc_points(centre, radius, start, end), style.WALL.width / 2)
            half = style.HATCH.width / 2
            return [*curve, *(stick(a, b, half) for a, b in round_hatch(shape))]


def _ink_of_arrow(role: LineRole, start: Vector, end: Vector, both: bool) -> list[Piece]:
    length = math.hypot(*(end - start))
    half = style.STROKES[role].width / 2
    if role == "impulse":
        half += style.SHAFT_GAP / 2
    pieces: list[Piece] = [stick(start, end, half)]
    head = style.head(role, length)
    for tip, tail in ((end, start), (start, end))[: 1 + both]:
        along = direction(tip - tail)
        base = tip - along * head.length
        side = along.turned_left() * head.half
        corners = (base + side, tip, base - side)
        pieces.extend(_sticks((*corners, corners[0]), style.STROKES[role].width / 2))
    return pieces


def _sticks(points: Iterable[Vector], half: float) -> list[Piece]:
    return [stick(a, b, half) for a, b in pairwise(points)]


def arc_span(start: float, end: float) -> float:
    """How far an arc goes, anticlockwise: at most a whole turn."""
    span = (end - start) % math.tau
    return math.tau if span < 1e-9 and end != start else span


def arc_points(centre: Vector, radius: float, start: float, end: float) -> list[Vector]:
    """Points along an arc, some 10° apart."""
    span = arc_span(start, end)
    count = max(2, math.ceil(span / 0.17))
    angles = (start + span * k / count for k in range(count + 1))
    return [centre + Vector(math.cos(a), math.sin(a)) * radius for a in angles]


def hatch(wall: StraightWall) -> Iterator[Segment]:
    """Strokes at 45° on the far side, evenly spaced, none beyond the ends of the wall."""
    length = math.hypot(*(wall.end - wall.start))
    along = direction(wall.end - wall.start)
    across = along.turned_left()
    into = across if across.dot(wall.far) > 0 else -across
    depth = min(style.HATCH_DEPTH, length)
    count = max(1, round((length - depth) / style.HATCH_SPACING))
    for k in range(count + 1):
        foot = wall.start + along * (depth + (length - depth) * k / count)
        yield foot, foot + (into - along) * depth


def round_hatch(wall: RoundWall) -> Iterator[Segment]:
    """Strokes at 45° to the radius on the hatched side, evenly spaced from end to end."""
    span = arc_span(wall.start, wall.end)
    outward = 1.0 if wall.hatched == "outside" else -1.0
    depth = min(style.HATCH_DEPTH, 0.4 * wall.radius)
    count = max(1, round(span * wall.radius / style.HATCH_SPACING))
    for k in range(count + (span < math.tau)):
        angle = wall.start + span * k / count
        radial = Vector(math.cos(angle), math.sin(angle))
        foot = wall.centre + radial * wall.radius
        yield foot, foot + (radial * outward - radial.turned_left()) * depth


def right_angle_points(shape: RightAngle) -> tuple[Vector, Vector, Vector]:
    """The two sides of the small square that are not on the lines themselves."""
    first, second = shape.first * shape.size, shape.second * shape.size
    return shape.corner + first, shape.corner + first + second, shape.corner + second


def touched(box: Box, pieces: Sequence[Piece], clearance: float) -> bool:
    """Whether any ink comes nearer to a box than a distance (at corners: than 1.42 of it)."""
    left, bottom, right, top = padded(box, clearance)
    for piece in pieces:
        p_left, p_bottom, p_right, p_top = piece.box
        if p_left > right or p_right < left or p_bottom > top or p_top < bottom:
            continue
        if _meets(box, piece, piece.half + clearance):
            return True
    return False


def _meets(box: Box, piece: Piece, room: float) -> bool:
    if isinstance(piece, Stick):
        return crosses(padded(box, room), piece.start, piece.end)
    left, bottom, right, top = box
    x, y = piece.centre
    near = math.hypot(max(left - x, x - right, 0.0), max(bottom - y, y - top, 0.0))
    far = math.hypot(max(x - left, right - x), max(y - bottom, top - y))
    return near <= piece.radius + room and far >= piece.radius - room


def crosses(box: Box, start: Vector, end: Vector) -> bool:
    """Whether a straight line from point to point has a part within a box."""
    low, high = 0.0, 1.0
    for at, to, least, most in (
        (start[0], end[0], box[0], box[2]),
        (start[1], end[1], box[1], box[3]),
    ):
        extent = to - at
        if extent == 0:
            if not least <= at <= most:
                return False
            continue
        one, two = (least - at) / extent, (most - at) / extent
        low, high = max(low, min(one, two)), min(high, max(one, two))
        if low > high:
            return False
    return True


def parted(start: Vector, end: Vector, piece: Piece) -> bool:
    """Whether ink lies between two points, across the straight line from one to the other."""
    ax, ay = start
    bx, by = end
    if isinstance(piece, Ring):
        x, y = piece.centre
        inside = math.hypot(ax - x, ay - y) < piece.radius
        return inside != (math.hypot(bx - x, by - y) < piece.radius)
    cx, cy = piece.start
    dx, dy = piece.end
    side_c = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    side_d = (bx - ax) * (dy - ay) - (by - ay) * (dx - ax)
    if side_c * side_d >= 0:
        return False
    side_a = (dx - cx) * (ay - cy) - (dy - cy) * (ax - cx)
    side_b = (dx - cx) * (by - cy) - (dy - cy) * (bx - cx)
    return bool(side_a * side_b < 0)


def distance(point: Vector, piece: Piece) -> float:
    """From a point to a piece of ink; nothing within a circle."""
    if isinstance(piece, Ring):
        return max(0.0, math.hypot(*(point - piece.centre)) - piece.radius)
    segment = piece.end - piece.start
    size = segment.dot(segment)
    share = min(1.0, max(0.0, (point - piece.start).dot(segment) / size)) if size else 0.0
    return math.hypot(*(point - piece.start - segment * share))


def overlap(one: Box, two: Box, apart: float = 0.0) -> bool:
    """Whether two boxes come nearer to each other than a distance, in both directions."""
    return (
        one[0] < two[2] + apart
        and two[0] < one[2] + apart
        and one[1] < two[3] + apart
        and two[1] < one[3] + apart
    )


def padded(box: Box, by: float) -> Box:
    """The box with a margin all around."""
    return box[0] - by, box[1] - by, box[2] + by, box[3] + by
