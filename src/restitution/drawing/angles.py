"""The angles of velocities at an event: with the line of centres, an axis, or the way before."""

from __future__ import annotations

import math
from itertools import product

from restitution.drawing.event import (
    LINE,
    RADIUS,
    RIGHT,
    WALL,
    Body,
    Drawing,
    View,
    is_on_axes,
    room_beside,
)
from restitution.drawing.geometry import sides_towards
from restitution.drawing.ink import parted
from restitution.drawing.sayings import LabelledAngle
from restitution.drawing.scene import Arc, Arrow, Label, Line
from restitution.render import layout as lay
from restitution.render.glyphs import outline
from restitution.render.layout import Layout
from restitution.staging.geometry import direction
from restitution.vector import Vector

_FOOT = 7.5  # of a line that is drawn for an angle to start from
_LABEL = 2.8  # an em of the label of an angle


def put_angle(
    view: View,
    body: Body,
    angle: LabelledAngle,
    arrow: tuple[Vector, Vector],
    arriving: bool,
    leg: float,
    index: int,
    drawing: Drawing,
) -> None:
    """An angle of a velocity: around the centre of its sphere, or where the arrow meets the rim.

    It is around the centre where it is with a line of centres that is drawn there. ``leg`` is the
    length of the component across, which starts or ends at the rim; ``index`` counts the angles.
    """
    tail, tip = arrow
    course = direction(tip - tail)
    line = _reference(angle, course) * (-1.0 if arriving else 1.0)
    beside = math.hypot(*((tip if arriving else tail) - body.centre)) > RADIUS + 1e-6
    inwards = 1.0 if body.towards is None else line.dot(body.towards)
    if view.kind == "spheres" and not beside and inwards < 1e-6:
        radius, drawn = RADIUS + 2.6 + 2.4 * index, inwards < -1 + 1e-6
        put_arc(body.centre, RADIUS, radius, angle, course, arriving, drawn, drawing)
        return
    radius = _rim_radius(line, tail, tip, index)
    drawn = leg >= radius and abs(line.dot(view.t)) > 1 - 1e-6
    put_arc(tip if arriving else tail, 0.0, radius, angle, course, arriving, drawn, drawing)


def has_room(angle: LabelledAngle, vertex: Vector, far: Vector, corner: Vector, index: int) -> bool:
    """Whether the label of an angle fits between its arc and the component across from it.

    The arc is around ``vertex``, from the component that ends in ``corner`` to the velocity that
    ends ``far`` from it. An angle with another line needs no room there.
    """
    course, leg = direction(far - vertex), direction(corner - vertex)
    if abs(direction(angle.reference).dot(leg)) < 1 - 1e-6:
        return True
    label = angle.shown(abs(math.atan2(leg.cross(course), leg.dot(course))))
    if label is None:
        return True
    left, bottom, right, top = (_LABEL * x for x in outline(label).box)
    width, height = right - left + 1.0, top - bottom + 1.0
    radius = _rim_radius(leg, vertex, far, index) + 0.3
    sides = [(vertex, far), (far, corner), (corner, vertex)]
    sense = (far - vertex).cross(corner - vertex)
    for one, two in product(range(1, 12), repeat=2):
        if one + two > 11:
            continue
        x, y = vertex + (far - vertex) * (one / 12) + (corner - vertex) * (two / 12)
        box = (x - width / 2, y - height / 2, x + width / 2, y + height / 2)
        corners = [Vector(a, b) for a in box[::2] for b in box[1::2]]
        nearest = Vector(*(min(max(v, a), b) for v, a, b in zip(vertex, box, box[2:])))
        if math.hypot(*(nearest - vertex)) > radius and all(
            (end - start).cross(point - start) * sense > 0
            for start, end in sides
            for point in corners
        ):
            return True
    return False


def _rim_radius(line: Vector, tail: Vector, tip: Vector, index: int) -> float:
    """The radius of an arc between a line and an arrow, where the arrow meets the rim."""
    course, length = direction(tip - tail), math.hypot(*(tip - tail))
    between = abs(math.atan2(line.cross(course), abs(line.dot(course))))
    radius = max(5.0, 1.5 / math.tan(between / 2)) if between > 0.02 else 5.0
    return float(max(3.4, min(radius, 0.6 * length)) + 2.4 * index)


def _reference(angle: LabelledAngle, course: Vector) -> Vector:
    """The unit vector from which an angle is drawn: no obtuse ones."""
    reference = direction(angle.reference)
    return -reference if reference.dot(course) < (0 if angle.line else -0.03) else reference


def put_arc(
    vertex: Vector,
    clear: float,
    radius: float,
    angle: LabelledAngle,
    course: Vector,
    arriving: bool,
    drawn: bool,
    drawing: Drawing,
) -> None:
    """An arc from the reference to an arrow, its label, and the reference line unless ``drawn``.

    The reference line starts at the distance ``clear`` from the vertex.
    """
    reference = _reference(angle, course)
    between = math.atan2(reference.cross(course), reference.dot(course))
    turned = not angle.line and reference.dot(angle.reference) < 0
    label = angle.shown(abs(between), turned=turned)
    right = abs(abs(between) - math.pi / 2) < 1e-6 and label == lay.Degrees(lay.Number("90"))
    if abs(between) < 0.02 or right:
        return
    line, arrow = (-reference, -course) if arriving else (reference, course)
    if not drawn:
        drawing.shapes.append(Line("across", vertex + line * clear, vertex + line * (radius + 2.5)))
    a, b = math.atan2(line.y, line.x), math.atan2(arrow.y, arrow.x)
    drawing.shapes.append(Arc("angle", vertex, radius, *((a, b) if between > 0 else (b, a))))
    if label is not None:
        drawing.labels.append(
            _label_of_arc(label, vertex, radius, direction(line + arrow), drawing)
        )


def put_inclination(view: View, drawing: Drawing) -> None:
    """The angle that a wall or a line of centres makes with **i**, where it is given.

    It stands at the end of the wall, or of the line, at which there is the most room; at a wall,
    before it rather than among its hatching.
    """
    angle = view.sayings.lines.get(view.number)
    if angle is None or is_on_axes(view):
        return
    if view.kind == "wall":
        ends = [view.t * WALL, -view.t * WALL]
    else:
        ends = [body.centre * (1 + LINE / RADIUS) for body in view.bodies]
    pieces = list(drawing.ink())
    best: tuple[float, Vector, Vector, float] | None = None
    for end in ends:
        course = direction(-end)
        reference = RIGHT if course.x > 0 else -RIGHT
        between = abs(math.atan2(reference.cross(course), reference.dot(course)))
        before_wall = view.kind == "wall" and reference.dot(view.n) > 0
        foot = _radius(between) + 0.5 if before_wall else _FOOT
        start = end + reference * 2 + direction(reference + course) * (0.5 if between > 0.2 else 0)
        room = room_beside(Arrow("across", start, end + reference * foot), pieces)
        if before_wall and room > 0.4:  # where it is not among the hatching
            room += _FOOT
        if best is None or room > best[0] + 0.1:
            best = room, end, course, foot
    assert best is not None
    _, end, course, foot = best
    reference = RIGHT if course.x > 0 else -RIGHT
    between = math.atan2(reference.cross(course), reference.dot(course))
    label = angle.shown(abs(between))
    if label is None or abs(between) < 0.1:
        return
    radius = _radius(abs(between))
    a, b = math.atan2(reference.y, reference.x), math.atan2(course.y, course.x)
    if between < 0:
        a, b = b, a
    drawing.shapes.append(Line("across", end, end + reference * foot))
    drawing.shapes.append(Arc("angle", end, radius, a, b if b > a else b + 2 * math.pi))
    drawing.labels.append(_label_of_arc(label, end, radius, direction(reference + course), drawing))


def _label_of_arc(
    label: Layout, vertex: Vector, radius: float, middle: Vector, drawing: Drawing
) -> Label:
    """The label of an angle, at the middle of its arc.

    A narrow angle has room for it farther out, as far as no other line comes between.
    """
    at, *farther = (vertex + middle * (radius + out) for out in (0.0, 1.2, 2.4))
    start, pieces = at + middle * 0.2, list(drawing.ink())
    moves = [out for out in farther if not any(parted(start, out, piece) for piece in pieces)]
    return Label(label, at, sides_towards(middle), 0.8, _LABEL, moves=tuple(moves))


def _radius(between: float) -> float:
    """Of the arc of an inclination: a narrow angle has a larger one."""
    return min(5.0, max(3.4, 1.5 / math.tan(between / 2)))


def put_deflection(
    view: View, body: Body, tail: Vector, length: float, index: int, drawing: Drawing
) -> None:
    """The angle between the first direction, continued and dotted, and the direction after.

    An acute one is drawn where the arrow starts, one larger around the centre. ``index`` counts
    the angles that are drawn already.
    """
    label = view.sayings.deflections.get((view.number, body.name))
    u, v = view.velocity(body.name, "before"), view.velocity(body.name, "after")
    if label is None or not math.hypot(*u):
        return
    first, second = direction(u), direction(v)
    between = math.atan2(first.cross(second), first.dot(second))
    if abs(between) < 0.02 or math.pi - abs(between) < 0.02:
        return
    if abs(between) < math.radians(85):
        vertex, start, radius = tail, tail, max(4.2, min(6.5, 0.55 * length)) + 2.4 * index
        end = tail + first * (radius + 4.0)
    else:
        over = body.towards is not None and first.dot(body.towards) > 0.6 and view.kind != "wall"
        radius = RADIUS + (1.8 if over else 5.0)
        vertex, start = body.centre, body.centre + first * RADIUS
        end = body.centre + first * (radius + (1.0 if over else 4.0))
    drawing.shapes.append(Line("onward", start, end))
    a, b = math.atan2(first.y, first.x), math.atan2(second.y, second.x)
    drawing.shapes.append(Arc("angle", vertex, radius, *((a, b) if between > 0 else (b, a))))
    middle = Vector(math.cos(a + between / 2), math.sin(a + between / 2))
    drawing.labels.append(
        Label(label, vertex + middle * radius, sides_towards(middle), 0.8, _LABEL)
    )
