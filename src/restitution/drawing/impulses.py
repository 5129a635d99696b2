"""The impulses at an event as arrows beside the spheres."""

from __future__ import annotations

import math
from collections.abc import Sequence

from restitution.drawing.angles import put_arc
from restitution.drawing.event import RADIUS, Body, Drawing, View, beside, room_beside
from restitution.drawing.scene import Arrow
from restitution.staging.geometry import direction, floats
from restitution.vector import Vector

LENGTH = 9.0  # of every arrow
# Where an impulse may be drawn: how far off the rim, and how far ahead; the best first.
_NEAR_PLACES = ((2.2, 0.0), (4.2, 0.0), (2.2, 4.0), (6.2, 0.0), (4.2, 4.0))
_FAR_PLACES = ((8.5, 0.0), (11.0, 0.0))


def put_impulses(view: View, drawing: Drawing) -> None:
    """The impulse on each sphere, beside it, along the line of centres.

    Its label stands beside it where the impulse is given or asked for.
    """
    happening = view.motion.story.happenings[view.number - 1]
    if happening.altered:
        return  # the impulses are not equal and opposite, or not along the line
    if happening.impulse is None or not math.hypot(*floats(happening.impulse)):
        return
    directions = [
        direction(floats(happening.impulse)) if body.towards is None else -body.towards
        for body in view.bodies
    ]
    angle = view.sayings.blows.get(view.number)
    side = directions[0].turned_left()
    sides = [side, -side]
    if angle is not None:  # whose arc is to be on the far side of the arrow
        sides = [side for side in sides if side.dot(angle.reference) > 0] or sides
    room, placed = _beside_all(view.bodies, directions, sides, drawing)
    if room < 1.0:
        placed = [
            arrow
            for body, line_of_action in zip(view.bodies, directions)
            for arrow in _beside_all((body,), (line_of_action,), sides, drawing)[1]
        ]
    drawing.shapes += [arrow for arrow, _ in placed]
    label = view.sayings.impulses.get(view.number)
    for arrow, outward in placed:
        if label is not None:
            drawing.labels.append(beside(label, arrow.start, arrow.end, outward))
    if angle is not None:
        put_arc(placed[0][0].start, 0.0, 5.0, angle, directions[0], False, False, drawing)


def _beside_all(
    bodies: Sequence[Body], directions: Sequence[Vector], sides: Sequence[Vector], drawing: Drawing
) -> tuple[float, list[tuple[Arrow, Vector]]]:
    """Arrows of impulses beside spheres, all on the side and at the distance with room for them."""
    best: tuple[float, list[tuple[Arrow, Vector]]] = (-1.0, [])
    pieces = list(drawing.ink())
    for off, ahead in _NEAR_PLACES if len(sides) > 1 else (*_NEAR_PLACES, *_FAR_PLACES):
        for side in sides:
            arrows = [
                _impulse(body, direction, side * (RADIUS + off) + direction * ahead)
                for body, direction in zip(bodies, directions)
            ]
            room = min(room_beside(arrow, pieces) for arrow in arrows)
            if room > best[0] + 0.2:
                best = room, [(arrow, side) for arrow in arrows]
        if best[0] >= 1.3:
            break
    return best


def _impulse(body: Body, direction: Vector, offset: Vector) -> Arrow:
    back = LENGTH / 2 if body.towards is None else RADIUS - 2.0
    start = body.centre + offset - direction * back
    return Arrow("impulse", start, start + direction * LENGTH)
