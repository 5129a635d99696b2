"""One impact as a picture of two equal panels, before and after it, to one scale.

The circles touch. A velocity is an arrow from the centre; where it would run through the other
body it is drawn as arriving at the centre instead. Its components, thin and dashed, complete a
right-angled triangle. Everything is computed in millimetres around the point of contact, and the
two panels are then laid side by side.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from restitution.draw import describe
from restitution.draw.labels import Ring, Stick, ink, overlap, unit
from restitution.draw.said import Angle, Sayings, Words, state_after, supplement
from restitution.draw.scene import (
    WIDTH,
    Arc,
    Arrow,
    Disc,
    Label,
    Line,
    Panel,
    RightAngle,
    RoundWall,
    Scene,
    Shape,
    Side,
    StraightWall,
)
from restitution.draw.values import Motion, drawn_for
from restitution.expression.tree import Letter, Pair, Unit, walk
from restitution.problem import Find, Impact, Kick
from restitution.render import layout as lay
from restitution.render.glyphs import outline, union
from restitution.render.layout import Layout
from restitution.solve.letters import trees_of_step
from restitution.solve.numbers import UndefinedError
from restitution.vector import Vector

When = Literal["before", "after"]

RADIUS = 4.2  # of a sphere on paper
LONGEST = 15.0  # of an arrow of velocity
IMPULSE = 9.0  # the length of every arrow of an impulse
GAP = 2.0  # between the panels
PANEL = (WIDTH - GAP) / 2
ROOM = 5.0  # around what is drawn, for labels
_WIDEST = 5.6  # of a label of a component, in em
_ZERO = 1e-9

_I, _J = Vector(1.0, 0.0), Vector(0.0, 1.0)
_COMPASS: tuple[tuple[Side, Vector], ...] = tuple(
    (side, Vector(math.cos(k * math.pi / 4), math.sin(k * math.pi / 4)))
    for k, side in enumerate(("e", "ne", "n", "nw", "w", "sw", "s", "se"))  # type: ignore[arg-type]
)


@dataclass(frozen=True)
class _Body:
    """A sphere in an impact: its place on paper, and the way to what it strikes (None: nothing)."""

    name: str
    centre: Vector
    towards: Vector | None


@dataclass(frozen=True)
class _View:
    """One event as it is to be drawn: ``n`` along the line of centres, ``t`` across it."""

    motion: Motion
    said: Sayings
    number: int
    kind: Literal["spheres", "wall", "blow"]
    bodies: tuple[_Body, ...]
    n: Vector
    t: Vector

    def velocity(self, body: str, when: When) -> Vector:
        get = self.motion.before if when == "before" else self.motion.after
        return get(self.number, body)

    def words(self, body: str, when: When) -> Words:
        stage = self.number - 1 if when == "before" else self.number
        return self.said.of(body, state_after(self.motion, body, stage))


@dataclass
class _Drawing:
    """Shapes and labels of one panel, as they are made."""

    shapes: list[Shape]
    labels: list[Label]

    def box(self) -> tuple[float, float, float, float]:
        return union(piece.box for piece in self.ink())

    def ink(self) -> Iterator[Stick | Ring]:
        return (piece for shape in self.shapes for piece in ink(shape))


def before_and_after(motion: Motion, said: Sayings, number: int) -> Scene:
    """The picture of one impact, or of one blow from outside. ``number`` is that of the event."""
    view = _view(motion, said, number)
    speeds = [
        math.hypot(*view.velocity(body.name, when))
        for body in view.bodies
        for when in ("before", "after")
    ]
    fastest = max(speeds)
    longest = LONGEST
    while True:
        scale = longest / fastest if fastest else 1.0
        drawings = {when: _panel(view, when, scale) for when in ("before", "after")}
        left, bottom, right, top = union(each.box() for each in drawings.values())
        if right - left <= PANEL - ROOM or longest < LONGEST / 3:
            break
        longest *= 0.93
    height = top - bottom + 2 * ROOM
    panels = []
    shapes: list[Shape] = []
    labels: list[Label] = []
    for index, (name, drawing) in enumerate(zip(("Before", "After"), drawings.values())):
        x = index * (PANEL + GAP)
        shift = Vector(x + PANEL / 2 - (left + right) / 2, ROOM - bottom)
        moved = [_moved(shape, shift) for shape in drawing.shapes]
        shapes += moved
        labels += [
            replace(
                each,
                at=each.at + shift,
                moves=tuple(move + shift for move in each.moves),
            )
            for each in drawing.labels
        ]
        panels.append(Panel(name, (x, 0.0, x + PANEL, height)))
    if _needs_axes(view):
        lowered = _with_axes(shapes, labels, height)
        panels = [replace(p, box=(p.box[0], -lowered, p.box[2], p.box[3])) for p in panels]
    else:
        lowered = 0.0
    return Scene(
        describe.title(motion, number),
        describe.description(motion, number),
        (0.0, -lowered, WIDTH, height),
        tuple(shapes),
        tuple(labels),
        tuple(panels),
        _note(view),
    )


# --- what is drawn, and where ---------------------------------------------------------------------


def _view(motion: Motion, said: Sayings, number: int) -> _View:
    happening = motion.story.happenings[number - 1]
    step = happening.step
    if isinstance(step, Kick):
        body = _Body(step.body, Vector(0.0, 0.0), None)
        return _View(motion, said, number, "blow", (body,), _I, _J)
    frame = motion.told.frames[number]
    n, t = unit(motion.vector(frame.n)), unit(motion.vector(frame.t))
    assert isinstance(step, Impact)
    if frame.wall is not None:
        body = _Body(step.first, n * RADIUS, -n)
        return _View(motion, said, number, "wall", (body,), n, t)
    assert happening.centres is not None
    c = unit(_floats(happening.oriented()))
    bodies = _Body(step.first, -c * RADIUS, c), _Body(step.second, c * RADIUS, -c)
    return _View(motion, said, number, "spheres", bodies, n, t)


def _floats(v: Vector) -> Vector:
    return Vector(float(v.x), float(v.y))


def _panel(view: _View, when: When, scale: float) -> _Drawing:
    drawing = _Drawing([], [])
    if view.kind == "wall":
        _wall(view, drawing)
    for body in view.bodies:
        drawing.shapes.append(Disc(body.name, body.centre, RADIUS))
    for body in view.bodies:
        _velocity(view, body, when, scale, drawing)
    if when == "after":
        for body in view.bodies:
            _deflection(view, body, scale, drawing)
        _impulses(view, drawing)
    _lines(view, drawing)
    for body in view.bodies:
        _names(view, body, drawing)
    return drawing


def _lines(view: _View, drawing: _Drawing) -> None:
    """The line of centres and its perpendicular, or the normal of a wall: outside the circles."""
    if view.kind == "blow":
        return
    reach = RADIUS + 5.5
    if view.kind == "wall":
        foot, centre = Vector(0.0, 0.0), view.bodies[0].centre
        top = centre + view.n * (reach + 1)
        drawing.shapes.append(Line("across", centre + view.n * RADIUS, top))
        del foot
        return
    first, second = view.bodies
    for body in (first, second):
        assert body.towards is not None
        out = -body.towards
        edge = body.centre + out * RADIUS
        drawing.shapes.append(Line("line_of_centres", edge, body.centre + out * reach))
    across = second.centre.turned_left() / RADIUS
    drawing.shapes.append(Line("across", -across * (RADIUS + 2.5), across * (RADIUS + 2.5)))


def _wall(view: _View, drawing: _Drawing) -> None:
    """The wall at the place of impact; of a round one, an arc."""
    name = view.motion.told.frames[view.number].wall or ""
    wall = view.motion.story.walls[name]
    half = 13.0
    if wall.centre is None:
        ends = view.t * half
        drawing.shapes.append(StraightWall(name, -ends, ends, -view.n))
        at = ends * 0.9
    else:
        inside = _inside(view, name)
        bend = 24.0
        centre = view.n * (bend if inside else -bend)
        middle = math.atan2(-centre.y, -centre.x)
        spread = half / bend
        drawing.shapes.append(
            RoundWall(
                name,
                centre,
                bend,
                middle - spread,
                middle + spread,
                "outside" if inside else "inside",
            )
        )
        drawing.shapes.append(Line("across", -view.t * half * 0.8, view.t * half * 0.8))
        at = centre + Vector(math.cos(middle + spread), math.sin(middle + spread)) * bend
    if len(view.motion.story.walls) > 1:
        drawing.labels.append(Label(lay.Words(name), at, _sides(-view.n), 2.2))


def _inside(view: _View, name: str) -> bool:
    """Whether a round wall is struck from inside."""
    story = view.motion.story
    centre = story.read_vector(story.walls[name].centre, "the centre")
    known = story.place(view.bodies[0].name, view.number)
    if known is None:
        return True
    inwards = centre - known[0]
    return _floats(inwards).dot(view.n) > 0


def _names(view: _View, body: _Body, drawing: _Drawing) -> None:
    """The letter of a sphere within its circle, and its mass."""
    told = view.motion.told
    name = Label(lay.Letter(body.name), body.centre, ("centre",), 0.0, 3.2, fixed=True)
    mass = told.story.spheres[body.name].mass
    if mass is None:
        drawing.labels.append(name)
        return
    laid = lay.as_layout(mass) if not isinstance(mass, float) else lay.decimal_number(mass)
    left, bottom, right, top = outline(laid).box
    if (right - left) * 2.6 < 1.45 * RADIUS and (top - bottom) * 2.6 < 0.65 * RADIUS:
        drawing.labels.append(replace(name, at=body.centre + _J * 1.4))
        at = body.centre - _J * 1.6
        drawing.labels.append(Label(laid, at, ("centre",), 0.0, 2.6, fixed=True))
    else:
        drawing.labels.append(name)
        drawing.labels.append(Label(laid, body.centre, _sides(-_J), RADIUS + 0.8, 2.6))


# --- velocities -----------------------------------------------------------------------------------


def arrives(body_towards: Vector | None, velocity: Vector, when: When) -> bool:
    """Whether an arrow is drawn as ending at the circle rather than as starting from it.

    Before an impact it is, where it would run through what the sphere strikes.
    """
    if when == "after" or body_towards is None:
        return False
    return velocity.dot(body_towards) > _ZERO * math.hypot(*velocity)


def _velocity(view: _View, body: _Body, when: When, scale: float, drawing: _Drawing) -> None:
    v = view.velocity(body.name, when)
    words = view.words(body.name, when)
    size = math.hypot(*v)
    if size * scale < 1e-6:
        drawing.labels.append(
            Label(lay.Words("at rest"), body.centre, _sides(-_J), RADIUS + 0.8, 2.6)
        )
        _sense_at_rest(view, body, when, drawing)
        return
    way, length = v / size, size * scale
    arriving = arrives(body.towards, v, when)
    if arriving:
        tip = body.centre - way * RADIUS
        tail = tip - way * length
    else:
        tail = body.centre + way * RADIUS
        tip = tail + way * length
    lifted = _lift(view, body, way, when, length)
    tail, tip = tail + lifted, tip + lifted
    drawing.shapes.append(Arrow("velocity", tail, tip))
    along, across = v.dot(view.n) * scale, v.dot(view.t) * scale
    parts = _components(view, body, when)
    if abs(along) < 1e-6 or abs(across) < 1e-6:
        axis, part = (view.t, parts[1]) if abs(along) < 1e-6 else (view.n, parts[0])
        value = across if abs(along) < 1e-6 else along
        label = words.size if words.size is not None else words.vector
        outward = _clear_side(view, body, way)
        if label is None and part is not None:
            label = _directed(part, axis, value, (tail + tip) / 2, outward, drawing)
        if label is not None:
            drawing.labels.append(_beside(label, tail, tip, outward))
        if abs(along) < 1e-6:
            _sense_at_rest(view, body, when, drawing)
    else:
        corner = tail + view.n * along if arriving else tail + view.t * across
        legs = (
            ((tail, corner, view.n, along, parts[0]), (corner, tip, view.t, across, parts[1]))
            if arriving
            else ((tail, corner, view.t, across, parts[1]), (corner, tip, view.n, along, parts[0]))
        )
        inside = (tail + tip + corner) / 3
        for start, end, axis, value, part in legs:
            drawing.shapes.append(Arrow("component", start, end))
            outward = unit((start + end) / 2 - inside)
            across_leg = axis.turned_left()
            outward = across_leg if across_leg.dot(outward) > 0 else -across_leg
            label = None
            if part is not None:
                label = _directed(part, axis, value, (start + end) / 2, outward, drawing)
            if label is not None:
                drawing.labels.append(_beside(label, start, end, outward))
        drawing.shapes.append(
            RightAngle(corner, unit(tail - corner), unit(tip - corner), min(1.6, abs(along) / 2, abs(across) / 2))
        )
        label = words.size
        if label is None and words.vector is not None and not _on_axes(view):
            label = words.vector
        if label is None and view.kind == "blow" and when == "after":
            label = lay.Bold("v")
        if label is not None:
            drawing.labels.append(_beside(label, tail, tip, unit((tail + tip) / 2 - corner)))
    for index, angle in enumerate(words.angles):
        _angle(view, body, angle, way, arriving, RADIUS + 2.6 + 2.4 * index, drawing)


def _on_axes(view: _View) -> bool:
    return any(abs(abs(view.n.dot(axis)) - 1) < _ZERO for axis in (_I, _J))


def _clear_side(view: _View, body: _Body, way: Vector) -> Vector:
    """The side of an arrow on which its label has room: above, or away from what is struck."""
    left = way.turned_left()
    if body.towards is not None and abs(left.dot(body.towards)) > 0.3:
        return left if left.dot(body.towards) < 0 else -left
    return left if left.y > 0 or (abs(left.y) < _ZERO and left.x < 0) else -left


def _lift(view: _View, body: _Body, way: Vector, when: When, length: float) -> Vector:
    """An arrow along the line of centres, towards the other body: moved to run beside the circles."""
    if body.towards is None or when == "before" or way.dot(body.towards) < 0.97:
        return Vector(0.0, 0.0)
    side = way.turned_left()
    side = side if side.y > 0 or (abs(side.y) < _ZERO and side.x < 0) else -side
    return side * (RADIUS + 1.6) - way * RADIUS


def _components(view: _View, body: _Body, when: When) -> tuple[Layout | None, Layout | None]:
    """The labels of the components along and across, signed; None where too long to write."""
    told, number, name = view.motion.told, view.number, body.name
    known = view.words(name, when).known
    if view.kind == "blow":
        happening = told.happening(number)
        v = happening.before[name] if when == "before" else happening.after[name]
        if when == "after" and not known:
            return None, None
        return _laid(told.presentable(v.x)), _laid(told.presentable(v.y))
    along, across = told.before(number, name)
    if when == "after":
        component = told.components[number, name]
        along = component.value if known else component.symbol
        step = told.happening(number).step
        assert isinstance(step, Impact)
        if not known and view.kind == "wall" and (step.e is None or isinstance(step.e, Letter)):
            e = told.happening(number).e
            product = _laid(-e * told.before(number, name)[0])
            if product is not None and e.free_symbols:
                return product, _laid(across)
    elif known:
        along, across = (_final(view, x) for x in (along, across))
    return _laid(along), _laid(across)


def _final(view: _View, x: Any) -> Any:
    """The value of a hidden letter where the statement gives the velocity itself."""
    return view.motion.told.final.get(x, x)


def _laid(x: Any) -> Layout | None:
    laid = lay.from_sympy(x)
    left, _, right, _ = outline(laid).box
    return laid if right - left <= _WIDEST else None


def _directed(
    part: Layout, axis: Vector, value: float, at: Vector, outward: Vector, drawing: _Drawing
) -> Layout | None:
    """The label of a component whose arrow is drawn: its size.

    A letter counted positive the other way gets a small arrow for its sense instead.
    """
    sign, size = lay.split_sign(part)
    sense = axis if sign == "+" else -axis
    if sense.dot(axis * value) >= 0:
        return size
    if isinstance(size, lay.Letter):
        _sense(size, sense, at + outward * 1.6, outward, drawing)
        return None
    return lay.negative(part) if sign == "+" else size


def _sense(label: Layout, sense: Vector, at: Vector, outward: Vector, drawing: _Drawing) -> None:
    start, end = at - sense * 2.2, at + sense * 2.2
    drawing.shapes.append(Arrow("sense", start, end))
    drawing.labels.append(_beside(label, start, end, outward))


def _sense_at_rest(view: _View, body: _Body, when: When, drawing: _Drawing) -> None:
    """The letter of a component that is zero, with its sense."""
    if when == "before" or view.kind == "blow" or view.words(body.name, when).known:
        return
    part = _components(view, body, when)[0]
    sign, size = lay.split_sign(part) if part is not None else ("+", lay.Number("0"))
    if not isinstance(size, lay.Letter):
        return
    sense = view.n if sign == "+" else -view.n
    side = view.n.turned_left()
    side = side if side.y > 0 or (abs(side.y) < _ZERO and side.x > 0) else -side
    v = view.velocity(body.name, when)
    side = -side if v.dot(side) > 0 else side
    _sense(size, sense, body.centre + side * (RADIUS + 1.4), side, drawing)


def _angle(
    view: _View,
    body: _Body,
    angle: Angle,
    way: Vector,
    arriving: bool,
    radius: float,
    drawing: _Drawing,
) -> None:
    """An arc from the reference to the arrow, with the reference line where none is drawn."""
    reference, label = unit(angle.reference), angle.label
    if angle.line and reference.dot(way) < 0:
        reference = -reference
    elif not angle.line and reference.dot(way) < -0.03:
        reference, label = -reference, supplement(label)
    between = math.atan2(reference.cross(way), reference.dot(way))
    if abs(between) < 0.02:
        return
    side = -1.0 if arriving else 1.0
    line, arrow = reference * side, way * side
    if not _is_drawn(view, body, line):
        start, end = body.centre + line * RADIUS, body.centre + line * (radius + 3.0)
        drawing.shapes.append(Line("across", start, end))
    if abs(abs(between) - math.pi / 2) < 1e-6 and label == lay.Degrees(lay.Number("90")):
        return
    a, b = math.atan2(line.y, line.x), math.atan2(arrow.y, arrow.x)
    start_angle, end_angle = (a, b) if between > 0 else (b, a)
    drawing.shapes.append(Arc("angle", body.centre, radius, start_angle, end_angle))
    middle = unit(line + arrow)
    drawing.labels.append(
        Label(label, body.centre + middle * radius, _sides(middle), 0.8, 2.8)
    )


def _is_drawn(view: _View, body: _Body, line: Vector) -> bool:
    """Whether the picture already has this line outwards from the centre."""
    if view.kind == "wall":
        return line.dot(view.n) > 1 - 1e-6
    if view.kind == "spheres" and body.towards is not None:
        return abs(line.dot(body.towards)) > 1 - 1e-6
    return False


def _deflection(view: _View, body: _Body, scale: float, drawing: _Drawing) -> None:
    """The angle between the first direction, continued and dotted, and the direction after."""
    label = view.said.deflections.get((view.number, body.name))
    u, v = view.velocity(body.name, "before"), view.velocity(body.name, "after")
    if label is None or not math.hypot(*u) or not math.hypot(*v):
        return
    first, second = unit(u), unit(v)
    between = math.atan2(first.cross(second), first.dot(second))
    if abs(between) < 0.02 or math.pi - abs(between) < 0.02:
        return
    radius = RADIUS + 5.0
    start = body.centre + first * RADIUS
    drawing.shapes.append(Line("onward", start, body.centre + first * (radius + 4.0)))
    a, b = math.atan2(first.y, first.x), math.atan2(second.y, second.x)
    drawing.shapes.append(
        Arc("angle", body.centre, radius, *((a, b) if between > 0 else (b, a)))
    )
    middle = Vector(math.cos(a + between / 2), math.sin(a + between / 2))
    drawing.labels.append(
        Label(label, body.centre + middle * radius, _sides(middle), 0.8, 2.8)
    )


def _impulses(view: _View, drawing: _Drawing) -> None:
    """The impulse on each sphere, beside it, along the line of centres."""
    label = view.said.impulses.get(view.number)
    if label is None:
        return
    if view.kind == "blow":
        body = view.bodies[0]
        happening = view.motion.story.happenings[view.number - 1]
        assert happening.impulse is not None
        way = unit(_floats(happening.impulse))
        offset = way.turned_left() * _free_side(way.turned_left(), body, drawing, RADIUS + 2.0)
        start = body.centre + offset * (RADIUS + 2.0) - way * IMPULSE / 2
        _impulse(label, start, way, offset, drawing)
        return
    side = view.n.turned_left()
    sums = sum(_free_side(side, body, drawing, RADIUS + 2.2) for body in view.bodies)
    side = side if sums >= 0 else -side
    for body in view.bodies:
        assert body.towards is not None
        way = -body.towards
        start = body.centre + side * (RADIUS + 2.2) - way * (RADIUS - 1.0 if view.kind == "spheres" else RADIUS)
        _impulse(label, start, way, side, drawing)


def _free_side(side: Vector, body: _Body, drawing: _Drawing, off: float) -> float:
    """1 where there is more room on this side of a sphere than on the other, −1 where less."""
    spots = [body.centre + side * (off * sign) for sign in (1.0, -1.0)]
    rooms = [
        min(
            (_distance(spot, shape) for shape in drawing.shapes if not isinstance(shape, Disc)),
            default=99.0,
        )
        for spot in spots
    ]
    return 1.0 if rooms[0] > rooms[1] + 0.1 else -1.0


def _distance(point: Vector, shape: Shape) -> float:
    """From a point to a shape, by its ink."""
    found = 99.0
    for piece in ink(shape):
        if isinstance(piece, Ring):
            found = min(found, abs(math.hypot(*(point - piece.centre)) - piece.radius))
            continue
        way = piece.end - piece.start
        size = way.dot(way)
        share = min(1.0, max(0.0, (point - piece.start).dot(way) / size)) if size else 0.0
        found = min(found, math.hypot(*(point - piece.start - way * share)))
    return found


def _impulse(label: Layout, start: Vector, way: Vector, side: Vector, drawing: _Drawing) -> None:
    end = start + way * IMPULSE
    drawing.shapes.append(Arrow("impulse", start, end))
    drawing.labels.append(_beside(label, start, end, side))


# --- labels ---------------------------------------------------------------------------------------


def _sides(outward: Vector) -> tuple[Side, ...]:
    """All sides, those nearest to a direction first."""
    return tuple(side for side, _ in sorted(_COMPASS, key=lambda each: -each[1].dot(outward)))


def _beside(label: Layout, start: Vector, end: Vector, outward: Vector) -> Label:
    """A label beside an arrow: at its middle, or elsewhere along it, on one side if it can be."""
    points = tuple(start + (end - start) * share for share in (0.5, 0.65, 0.35, 0.8, 0.2))
    first, second, third, *_ = _sides(outward)
    return Label(
        label, points[0], (first, second, third, *_sides(-outward)[:3]), 0.9, 3.0, moves=points[1:]
    )


# --- axes, note -----------------------------------------------------------------------------------


def _needs_axes(view: _View) -> bool:
    """Whether **i** and **j** are spoken of, other than to say how a line or a wall lies."""
    problem = view.motion.told.problem
    if view.kind != "blow" and not _on_axes(view):
        return True
    trees = [sphere.velocity for sphere in problem.spheres]
    for _, step in problem.steps():
        if not isinstance(step, Impact):
            trees += list(trees_of_step(step))
        if isinstance(step, Find) and any(
            getattr(node, "kind", "") in ("velocity", "direction", "momentum")
            for item in step.items
            for node in walk(item.expression)
        ):
            return True
    return any(
        isinstance(node, Unit | Pair)
        for tree in trees
        if hasattr(tree, "__dataclass_fields__")
        for node in walk(tree)
    )


def _with_axes(shapes: list[Shape], labels: list[Label], height: float) -> float:
    """Adds **i** and **j** in a free corner of the first panel; what the panel grows below for it."""
    size, edge = 5.5, 2.2
    pieces = [piece for shape in shapes for piece in ink(shape)]
    lowered = 0.0
    room = size + 3.5
    corners = [
        Vector(edge, edge),
        Vector(edge, height - edge - room),
        Vector(PANEL - edge - room, edge),
        Vector(PANEL - edge - room, height - edge - room),
    ]
    for corner in corners:
        box = (corner.x, corner.y, corner.x + room, corner.y + room)
        if not any(overlap(box, piece.box, 0.5) for piece in pieces):
            break
    else:
        lowered = size + 2.0
        corner = Vector(edge, edge - lowered)
    origin = corner + Vector(0.5, 0.5)
    for axis, name, side in ((_I, "i", "e"), (_J, "j", "n")):
        tip = origin + axis * size
        shapes.append(Arrow("axis", origin, tip))
        labels.append(Label(lay.Bold(name), tip, (side,), 0.7, 2.8))  # type: ignore[arg-type]
    return lowered


def _note(view: _View) -> Layout | None:
    """The values by which letters are drawn."""
    chosen = drawn_for(view.motion, (view.number,))
    words: list[Layout] = []
    if chosen:
        words.append(lay.Words("Drawn for"))
        for index, each in enumerate(chosen):
            value = describe.value_of(each)
            relation = lay.Relation((lay.letter(each.name), value), ("=",))
            last = index == len(chosen) - 1
            end = "." if last else " and" if index == len(chosen) - 2 else ","
            words.append(lay.Phrase((relation, lay.Words(end)), ""))
    used = {label.content for label in ()}
    del used
    return lay.Phrase(tuple(words)) if words else None


# --- moving ---------------------------------------------------------------------------------------


def _moved(shape: Shape, by: Vector) -> Shape:
    match shape:
        case Line() | Arrow() | StraightWall():
            return replace(shape, start=shape.start + by, end=shape.end + by)
        case RightAngle():
            return replace(shape, corner=shape.corner + by)
        case Disc() | Arc() | RoundWall():
            return replace(shape, centre=shape.centre + by)
    message = f"no such shape in this picture: {shape!r}"
    raise TypeError(message)


def labels_of(drawing: Sequence[Label]) -> list[Layout]:
    return [each.content for each in drawing]
