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
from fractions import Fraction
from typing import Any, Literal

from restitution.draw import describe
from restitution.draw.ink import Piece, Ring, ink, overlap, stick, unit
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
from restitution.draw.values import Motion, When, axes, drawn_for
from restitution.exact import tidy
from restitution.expression.tree import Expression, Letter, Number, Pair, Unit, walk
from restitution.problem import Find, Impact, Kick, trees_of_step
from restitution.render import layout as lay
from restitution.render.glyphs import Box, outline, union
from restitution.render.layout import Layout
from restitution.render.text import to_text
from restitution.vector import Vector

RADIUS = 4.2  # of a sphere on paper
LONGEST = 17.0  # of an arrow of velocity
TINY = 1.5  # no arrow is shorter, or it could not be seen
IMPULSE = 9.0  # the length of every arrow of an impulse
GAP = 2.0  # between the panels
FRAME = 0.2  # of room around them for their frames
PANEL = (WIDTH - GAP) / 2 - FRAME
MARGIN = 2.4  # above and below what is drawn
EDGE = 1.2  # between what is drawn and the frame of its panel
SHORTEST = 9.0  # for the longest arrow: what does not fit then has its labels elsewhere
_WIDEST = 5.6  # of a label of a component, in em
# Where an impulse may be drawn: how far off the rim, and how far ahead; the best first.
_NEAR_PLACES = ((2.2, 0.0), (4.2, 0.0), (2.2, 4.0), (6.2, 0.0), (4.2, 4.0))
_FAR_PLACES = ((8.5, 0.0), (11.0, 0.0))
_LONGEST = 60  # of any label, in signs on one line
_FAR = 3.0  # enough room beside an arrow
_ZERO = 1e-9

_I, _J = Vector(1.0, 0.0), Vector(0.0, 1.0)
_DIAGONAL = math.sqrt(0.5)
_COMPASS: tuple[tuple[Side, Vector], ...] = (
    ("e", Vector(1.0, 0.0)),
    ("ne", Vector(_DIAGONAL, _DIAGONAL)),
    ("n", Vector(0.0, 1.0)),
    ("nw", Vector(-_DIAGONAL, _DIAGONAL)),
    ("w", Vector(-1.0, 0.0)),
    ("sw", Vector(-_DIAGONAL, -_DIAGONAL)),
    ("s", Vector(0.0, -1.0)),
    ("se", Vector(_DIAGONAL, -_DIAGONAL)),
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

    def box(self) -> Box:
        """What is drawn, and about where the labels beside it will stand."""
        boxes = [_expected(label) for label in self.labels if not label.fixed]
        return union([*(piece.box for piece in self.ink()), *boxes])

    def ink(self) -> Iterator[Piece]:
        return (piece for shape in self.shapes for piece in ink(shape))


def before_and_after(
    motion: Motion, said: Sayings, number: int, panels: Sequence[When] = ("before", "after")
) -> Scene:
    """The picture of one impact, or of one blow from outside. ``number`` is that of the event."""
    view = _view(motion, said, number)
    scale, drawings = _fitted(view, panels)
    boxes = [each.box() for each in drawings]
    bottom, top = min(box[1] for box in boxes), max(box[3] for box in boxes)
    height = top - bottom + 2 * MARGIN
    edge = (WIDTH - len(panels) * (PANEL + GAP) + GAP) / 2
    shapes: list[Shape] = []
    labels: list[Label] = []
    frames: list[Box] = []
    for index, (drawing, box) in enumerate(zip(drawings, boxes)):
        x = edge + index * (PANEL + GAP)
        shift = Vector(x + PANEL / 2 - (box[0] + box[2]) / 2, MARGIN - bottom)
        shapes += [_moved(shape, shift) for shape in drawing.shapes]
        labels += [
            replace(each, at=each.at + shift, moves=tuple(move + shift for move in each.moves))
            for each in drawing.labels
        ]
        frames.append((x, 0.0, x + PANEL, height))
    lowered = _with_axes(shapes, labels, frames[0]) if _needs_axes(view) else 0.0
    return Scene(
        describe.title(motion, number, panels),
        describe.description(motion, number, panels),
        (0.0, -lowered - FRAME, WIDTH, height + FRAME),
        tuple(shapes),
        tuple(labels),
        tuple(
            Panel(when.capitalize(), (box[0], -lowered, *box[2:]))
            for when, box in zip(panels, frames)
        ),
        _note(view, panels, scale),
    )


def _fitted(view: _View, panels: Sequence[When]) -> tuple[float, list[_Drawing]]:
    """The panels to one scale, the largest at which they fit, with that scale."""
    fastest = max(
        math.hypot(*view.velocity(body.name, when)) for body in view.bodies for when in panels
    )
    longest = LONGEST
    while True:
        scale = longest / fastest if fastest else 1.0
        drawings = [_panel(view, when, scale) for when in panels]
        boxes = [each.box() for each in drawings]
        if max(b[2] - b[0] for b in boxes) <= PANEL - 2 * EDGE or longest < SHORTEST:
            return scale, drawings
        longest *= 0.93


# --- what is drawn, and where ---------------------------------------------------------------------


def _view(motion: Motion, said: Sayings, number: int) -> _View:
    happening = motion.story.happenings[number - 1]
    step = happening.step
    if isinstance(step, Kick):
        body = _Body(step.body, Vector(0.0, 0.0), None)
        return _View(motion, said, number, "blow", (body,), _I, _J)
    assert isinstance(step, Impact)
    n, t = axes(motion, number)
    if motion.told.frames[number].wall is not None:
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
        _impulses(view, drawing)
    _lines(view, drawing)
    for body in view.bodies:
        _names(view, body, drawing)
    drawing.labels = [label for label in drawing.labels if _is_readable(label)]
    return drawing


def _is_readable(label: Label) -> bool:
    """Whether a label is short enough for a panel; the description has what it would say."""
    if len(to_text(label.content)) > _LONGEST:  # before it is set, which takes its time
        return False
    left, _, right, _ = outline(label.content).box
    return (right - left) * label.size < 0.75 * PANEL


def _lines(view: _View, drawing: _Drawing) -> None:
    """The line of centres and its perpendicular, or the normal of a wall: outside the circles."""
    if view.kind == "blow":
        return
    reach = RADIUS + 5.5
    if view.kind == "wall":
        centre = view.bodies[0].centre
        top = centre + view.n * (reach + 1)
        drawing.shapes.append(Line("across", centre + view.n * RADIUS, top))
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
    half = 9.5
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
    return bool(_floats(inwards).dot(view.n) > 0)


def _names(view: _View, body: _Body, drawing: _Drawing) -> None:
    """The name of a sphere and its mass, within its circle if they are short."""
    letter = lay.Letter(body.name) if len(body.name) == 1 else lay.Words(body.name)
    left, _, right, _ = outline(letter).box
    size = min(3.2, 1.15 * RADIUS / (right - left))
    name = Label(letter, body.centre, ("centre",), 0.0, size, fixed=True)
    given = view.motion.told.story.spheres[body.name].mass
    if given is not None:
        laid = lay.as_layout(given)
        left, _, right, _ = outline(laid).box
        size = max(2.1, min(2.6, 1.2 * RADIUS / (right - left)))
        mass = Label(laid, body.centre, ("centre",), 0.0, size, fixed=True)
        if _fits(mass):
            name = replace(name, at=body.centre + _J * (0.5 + _height(name) / 2))
            mass = replace(mass, at=body.centre - _J * (0.5 + _height(mass) / 2))
        else:
            mass = Label(laid, body.centre, _sides(-_J), RADIUS + 0.8, 2.6)
        drawing.labels.append(mass)
    drawing.labels.append(name)


def _height(label: Label) -> float:
    _, bottom, _, top = outline(label.content).box
    return (top - bottom) * label.size


def _fits(label: Label) -> bool:
    """Whether a label is small enough to stand in a circle, with another one above or below."""
    left, bottom, right, top = (label.size * x for x in outline(label.content).box)
    return right - left < 1.25 * RADIUS and top - bottom < 0.65 * RADIUS


# --- velocities -----------------------------------------------------------------------------------


def arrives(body_towards: Vector | None, velocity: Vector, when: When) -> bool:
    """Whether an arrow is drawn as ending at the circle rather than as starting from it.

    Before an impact it is, where it would run through what the sphere strikes.
    """
    if when == "after" or body_towards is None:
        return False
    return bool(velocity.dot(body_towards) > _ZERO * math.hypot(*velocity))


def _velocity(view: _View, body: _Body, when: When, scale: float, drawing: _Drawing) -> None:
    v = view.velocity(body.name, when)
    words = view.words(body.name, when)
    size = math.hypot(*v)
    if size * scale < 1e-6:
        drawing.labels.append(
            Label(lay.Words("at rest"), body.centre, _sides(-_J), RADIUS + 0.8, 2.6)
        )
        _sense_of_nothing(view, body, when, body.centre + _J * RADIUS, drawing)
        return
    way, length = v / size, max(TINY, size * scale)
    arriving = arrives(body.towards, v, when)
    tail = body.centre - way * (RADIUS + length) if arriving else body.centre + way * RADIUS
    lifted = None if arriving else _lifted(view, body, way, length)
    tail = tail if lifted is None else lifted
    tip = tail + way * length
    drawing.shapes.append(Arrow("velocity", tail, tip))
    along, across = v.dot(view.n) * scale, v.dot(view.t) * scale
    if abs(along) < 1e-6 or abs(across) < 1e-6 or size * scale < TINY:
        _in_one_direction(view, body, when, tail, tip, drawing)
        if abs(along) < 1e-6 and size * scale >= TINY:
            end = tail if arriving else tip
            _sense_of_nothing(view, body, when, end, drawing)
    else:
        _triangle(view, body, when, tail, tip, Vector(along, across), drawing)
    for index, angle in enumerate(words.angles):
        _angle(view, body, angle, (tail, tip), arriving, abs(across), index, drawing)
    if when == "after":
        _deflection(view, body, tail, length, len(words.angles), drawing)


def _in_one_direction(
    view: _View, body: _Body, when: When, tail: Vector, tip: Vector, drawing: _Drawing
) -> None:
    """The label of a velocity along the line of centres, or across it."""
    words = view.words(body.name, when)
    parts = _components(view, body, when)
    way = unit(tip - tail)
    along = abs(way.dot(view.n)) > abs(way.dot(view.t))
    axis, part = (view.n, parts[0]) if along else (view.t, parts[1])
    if abs(way.dot(axis)) < 1 - 1e-9:  # too short for its components to be seen
        part = None
    outward = _clear_side(body, way)
    label = words.size
    if label is None and view.kind == "blow":
        label = words.vector
    if label is None and part is not None:
        value = (tip - tail).dot(axis)
        label = _directed(part, axis, value, (tail + tip) / 2, outward, drawing)
    elif label is None:
        label = words.vector
    if label is not None:
        drawing.labels.append(_beside(label, tail, tip, outward))


def _triangle(
    view: _View,
    body: _Body,
    when: When,
    tail: Vector,
    tip: Vector,
    parts: Vector,
    drawing: _Drawing,
) -> None:
    """The components of a velocity, from its tail to its tip, with their labels and its own.

    Next to the sphere stands the component across, so that no other lies on the line of centres.
    """
    along, across = parts
    labels = _components(view, body, when)
    legs = [(view.t, across, labels[1]), (view.n, along, labels[0])]
    if math.hypot(*(tip - body.centre)) < math.hypot(*(tail - body.centre)):
        legs.reverse()
    corner = tail + legs[0][0] * legs[0][1]
    ends = (tail, corner), (corner, tip)
    drawing.shapes += [Arrow("component", start, end) for start, end in ends]
    inside = (tail + tip + corner) / 3
    for (start, end), (axis, value, part) in zip(ends, legs):
        middle = (start + end) / 2
        outward = axis.turned_left()
        outward = outward if outward.dot(middle - inside) > 0 else -outward
        label = None if part is None else _directed(part, axis, value, middle, outward, drawing)
        if label is not None:
            drawing.labels.append(_beside(label, start, end, outward))
    if min(abs(along), abs(across)) > 2.5:
        sides = unit(tail - corner), unit(tip - corner)
        drawing.shapes.append(RightAngle(corner, *sides, 1.3))
    words = view.words(body.name, when)
    label = words.size
    if label is None and not _on_axes(view):
        label = words.vector
    if label is None and view.kind == "blow":
        label = words.vector or lay.Bold("u" if when == "before" else "v")
    if label is not None:
        drawing.labels.append(_beside(label, tail, tip, unit((tail + tip) / 2 - corner)))


def _on_axes(view: _View) -> bool:
    return any(abs(abs(view.n.dot(axis)) - 1) < _ZERO for axis in (_I, _J))


def _clear_side(body: _Body, way: Vector) -> Vector:
    """The side of an arrow on which its label has room: above, or away from what is struck."""
    left = way.turned_left()
    if body.towards is not None and abs(left.dot(body.towards)) > 0.3:
        return left if left.dot(body.towards) < 0 else -left
    return left if left.y > 0 or (abs(left.y) < _ZERO and left.x < 0) else -left


def _lifted(view: _View, body: _Body, way: Vector, length: float) -> Vector | None:
    """Where an arrow starts that would else run over the other sphere: beside its own."""
    if view.kind != "spheres" or body.towards is None:
        return None
    start, other = body.centre + way * RADIUS, body.centre + body.towards * (2 * RADIUS)
    share = min(length, max(0.0, (other - start).dot(way)))
    if math.hypot(*(start + way * share - other)) > RADIUS + 0.5:
        return None
    side = body.towards.turned_left()
    if abs(side.dot(way)) > 1e-6:
        side = side if side.dot(way) > 0 else -side
    else:
        side = side if side.y > 0 or (abs(side.y) < _ZERO and side.x < 0) else -side
    return body.centre + side * (RADIUS + 1.5)


def _components(view: _View, body: _Body, when: When) -> tuple[Any, Any]:
    """The components along and across in the letters of the working; None where it has none.

    A velocity that the statement gives has components as given.
    """
    told, number, name = view.motion.told, view.number, body.name
    given = _given(view, body, when)
    if view.kind == "blow":
        v = told.happening(number).before[name] if given is None else given
        return (None, None) if given is None and when == "after" else (v.x, v.y)
    frame = told.frames[number]
    along, across = told.before(number, name)
    if given is not None and (when == "after" or _is_hidden(view, along)):
        along = tidy(given.dot(frame.n))
        across = tidy(given.dot(frame.t)) if _is_hidden(view, across) else across
    elif when == "after":
        step = told.happening(number).step
        assert isinstance(step, Impact)
        rebound = -told.happening(number).e * along
        along = told.components[number, name].symbol
        if view.kind == "wall" and (step.e is None or isinstance(step.e, Letter)):
            e = told.happening(number).e
            along = rebound if e.free_symbols and _laid(rebound) is not None else along
    return _by_now(view, along), _by_now(view, across)


def _by_now(view: _View, x: Any) -> Any:
    """What letters of earlier impacts add up to; one that stands alone is still the clearest."""
    found = {
        component.symbol: component.value
        for (number, _), component in view.motion.told.components.items()
        if number < view.number
    }
    earlier = x.free_symbols & set(found)
    if not earlier or x in earlier or -x in earlier:
        return x
    value = tidy(x.xreplace(found))
    return x if _laid(value) is None else value


def _given(view: _View, body: _Body, when: When) -> Vector | None:
    """A velocity in letters, if the statement gives it."""
    given = view.words(body.name, when).given
    if given is None:
        return None
    tree, now = given
    v = view.motion.told.story.evaluator(now).vector(tree)
    return Vector(tidy(v.x), tidy(v.y))


def _is_hidden(view: _View, x: Any) -> bool:
    """Whether this is a letter for what the statement does not name: a component at the start."""
    return getattr(x, "name", "") in view.motion.told.unknowns.names.values()


def _laid(x: Any) -> Layout | None:
    laid = lay.from_sympy(x)
    if len(to_text(laid)) > _LONGEST:
        return None
    left, _, right, _ = outline(laid).box
    return laid if right - left <= _WIDEST else None


def _directed(
    part: Any, axis: Vector, value: float, at: Vector, outward: Vector, drawing: _Drawing
) -> Layout | None:
    """The label of a component whose arrow is drawn: its size, if that is short.

    A letter counted positive the other way gets a small arrow for its sense instead.
    """
    sign, size = lay.split_sign(lay.from_sympy(part))
    sense = axis if sign == "+" else -axis
    if sense.dot(axis * value) >= 0:
        return size if _laid(part) is not None else None
    if isinstance(size, lay.Letter):
        _sense(size, sense, at, outward, drawing)
        return None
    return _laid(tidy(-part) if sign == "+" else part)


def _sense(label: Layout, sense: Vector, at: Vector, outward: Vector, drawing: _Drawing) -> None:
    """A small arrow for the sense in which a letter is positive, beside a point."""
    best: tuple[float, Arrow] | None = None
    pieces = list(drawing.ink())
    for off in (1.6, 3.2, -1.6, 4.8, -3.2):
        for along in (0.0, 3.0, -3.0):
            middle = at + outward * off + sense * along
            arrow = Arrow("sense", middle - sense * 2.2, middle + sense * 2.2)
            room = min(_room(arrow, pieces), 1.4)
            if best is None or room > best[0] + 0.1:
                best = room, arrow
    assert best is not None
    _, arrow = best
    drawing.shapes.append(arrow)
    drawing.labels.append(_beside(label, arrow.start, arrow.end, outward))


def _sense_of_nothing(view: _View, body: _Body, when: When, at: Vector, drawing: _Drawing) -> None:
    """The letter of a component that is found to be zero, with its sense."""
    if when == "before" or view.kind == "blow" or view.words(body.name, when).given is not None:
        return
    part = _components(view, body, when)[0]
    sign, size = lay.split_sign(lay.from_sympy(part))
    if isinstance(size, lay.Letter):
        _sense(size, view.n if sign == "+" else -view.n, at, unit(at - body.centre), drawing)


def _angle(
    view: _View,
    body: _Body,
    angle: Angle,
    arrow: tuple[Vector, Vector],
    arriving: bool,
    leg: float,
    index: int,
    drawing: _Drawing,
) -> None:
    """An angle of a velocity: around the centre of its sphere, or where the arrow meets the rim.

    It is around the centre where it is with a line of centres that is drawn there. ``leg`` is the
    length of the component across, which starts or ends at the rim; ``index`` counts the angles.
    """
    tail, tip = arrow
    way = unit(tip - tail)
    line = _reference(angle, way)[0] * (-1.0 if arriving else 1.0)
    beside = math.hypot(*((tip if arriving else tail) - body.centre)) > RADIUS + 1e-6
    inwards = 1.0 if body.towards is None else line.dot(body.towards)
    if view.kind == "spheres" and not beside and inwards < 1e-6:
        radius, drawn = RADIUS + 2.6 + 2.4 * index, inwards < -1 + 1e-6
        _arc(body.centre, RADIUS, radius, angle, way, arriving, drawn, drawing)
        return
    between = abs(math.atan2(line.cross(way), abs(line.dot(way))))
    length = math.hypot(*(tip - tail))
    radius = max(5.0, 1.5 / math.tan(between / 2)) if between > 0.02 else 5.0
    radius = max(3.4, min(radius, 0.6 * length)) + 2.4 * index
    drawn = leg >= radius and abs(line.dot(view.t)) > 1 - 1e-6
    _arc(tip if arriving else tail, 0.0, radius, angle, way, arriving, drawn, drawing)


def _reference(angle: Angle, way: Vector) -> tuple[Vector, Layout]:
    """The unit vector from which an angle is drawn, and its label: no obtuse ones."""
    reference = unit(angle.reference)
    if angle.line and reference.dot(way) < 0:
        return -reference, angle.label
    if not angle.line and reference.dot(way) < -0.03:
        return -reference, supplement(angle.label)
    return reference, angle.label


def _arc(
    vertex: Vector,
    clear: float,
    radius: float,
    angle: Angle,
    way: Vector,
    arriving: bool,
    drawn: bool,
    drawing: _Drawing,
) -> None:
    """An arc from the reference to an arrow, its label, and the reference line unless ``drawn``.

    The reference line starts at the distance ``clear`` from the vertex.
    """
    reference, label = _reference(angle, way)
    between = math.atan2(reference.cross(way), reference.dot(way))
    right = abs(abs(between) - math.pi / 2) < 1e-6 and label == lay.Degrees(lay.Number("90"))
    if abs(between) < 0.02 or right:
        return
    line, arrow = (-reference, -way) if arriving else (reference, way)
    if not drawn:
        drawing.shapes.append(Line("across", vertex + line * clear, vertex + line * (radius + 2.5)))
    a, b = math.atan2(line.y, line.x), math.atan2(arrow.y, arrow.x)
    drawing.shapes.append(Arc("angle", vertex, radius, *((a, b) if between > 0 else (b, a))))
    middle = unit(line + arrow)
    # A narrow angle has room for its label farther out.
    at, *moves = (vertex + middle * (radius + out) for out in (0.0, 1.2, 2.4))
    drawing.labels.append(Label(label, at, _sides(middle), 0.8, 2.8, moves=tuple(moves)))


def _deflection(
    view: _View, body: _Body, tail: Vector, length: float, index: int, drawing: _Drawing
) -> None:
    """The angle between the first direction, continued and dotted, and the direction after.

    An acute one is drawn where the arrow starts, one larger around the centre. ``index`` counts
    the angles that are drawn already.
    """
    label = view.said.deflections.get((view.number, body.name))
    u, v = view.velocity(body.name, "before"), view.velocity(body.name, "after")
    if label is None or not math.hypot(*u):
        return
    first, second = unit(u), unit(v)
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
    drawing.labels.append(Label(label, vertex + middle * radius, _sides(middle), 0.8, 2.8))


def _impulses(view: _View, drawing: _Drawing) -> None:
    """The impulse on each sphere, beside it, along the line of centres.

    Its label stands beside it where the impulse is given or asked for.
    """
    happening = view.motion.story.happenings[view.number - 1]
    if happening.impulse is None or not math.hypot(*_floats(happening.impulse)):
        return
    ways = [
        unit(_floats(happening.impulse)) if body.towards is None else -body.towards
        for body in view.bodies
    ]
    angle = view.said.blows.get(view.number)
    side = ways[0].turned_left()
    sides = [side, -side]
    if angle is not None:  # whose arc is to be on the far side of the arrow
        sides = [each for each in sides if each.dot(angle.reference) > 0] or sides
    room, placed = _beside_all(view.bodies, ways, sides, drawing)
    if room < 1.0:
        placed = [
            arrow
            for body, way in zip(view.bodies, ways)
            for arrow in _beside_all((body,), (way,), sides, drawing)[1]
        ]
    drawing.shapes += [arrow for arrow, _ in placed]
    label = view.said.impulses.get(view.number)
    for arrow, outward in placed:
        if label is not None:
            drawing.labels.append(_beside(label, arrow.start, arrow.end, outward))
    if angle is not None:
        _arc(placed[0][0].start, 0.0, 5.0, angle, ways[0], False, False, drawing)


def _beside_all(
    bodies: Sequence[_Body], ways: Sequence[Vector], sides: Sequence[Vector], drawing: _Drawing
) -> tuple[float, list[tuple[Arrow, Vector]]]:
    """Arrows of impulses beside spheres, all on the side and at the distance with room for them."""
    best: tuple[float, list[tuple[Arrow, Vector]]] = (-1.0, [])
    pieces = list(drawing.ink())
    for off, ahead in _NEAR_PLACES if len(sides) > 1 else (*_NEAR_PLACES, *_FAR_PLACES):
        for side in sides:
            arrows = [
                _impulse(body, way, side * (RADIUS + off) + way * ahead)
                for body, way in zip(bodies, ways)
            ]
            room = min(_room(arrow, pieces) for arrow in arrows)
            if room > best[0] + 0.2:
                best = room, [(arrow, side) for arrow in arrows]
        if best[0] >= 1.3:
            break
    return best


def _impulse(body: _Body, way: Vector, offset: Vector) -> Arrow:
    back = IMPULSE / 2 if body.towards is None else RADIUS - 2.0
    start = body.centre + offset - way * back
    return Arrow("impulse", start, start + way * IMPULSE)


def _room(arrow: Arrow, pieces: Sequence[Piece]) -> float:
    """The distance from an arrow to the nearest ink, no more than ``_FAR``; none in a sphere."""
    points = [arrow.start + (arrow.end - arrow.start) * (k / 6) for k in range(7)]
    extent = stick(arrow.start, arrow.end, _FAR).box
    return min(
        (
            _distance(point, piece)
            for piece in pieces
            if overlap(extent, piece.box)
            for point in points
        ),
        default=_FAR,
    )


def _distance(point: Vector, piece: Piece) -> float:
    if isinstance(piece, Ring):
        return max(0.0, math.hypot(*(point - piece.centre)) - piece.radius)
    way = piece.end - piece.start
    size = way.dot(way)
    share = min(1.0, max(0.0, (point - piece.start).dot(way) / size)) if size else 0.0
    return math.hypot(*(point - piece.start - way * share))


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


def _expected(label: Label) -> Box:
    """Where a label stands if its first wish is granted."""
    left, bottom, right, top = (label.size * x for x in outline(label.content).box)
    way = dict(_COMPASS)[label.sides[0]]
    centre = label.at + Vector(
        way.x * (label.gap + (right - left) / 2), way.y * (label.gap + (top - bottom) / 2)
    )
    half = Vector((right - left) / 2, (top - bottom) / 2)
    return centre.x - half.x, centre.y - half.y, centre.x + half.x, centre.y + half.y


# --- axes, note -----------------------------------------------------------------------------------


def _needs_axes(view: _View) -> bool:
    """Whether the picture is to show **i** and **j**.

    Not where they only say how the line of centres lies, which is drawn horizontally.
    """
    problem = view.motion.told.problem
    if view.kind == "blow" or not _on_axes(view):
        return True
    rest = Pair(Number(Fraction(0)), Number(Fraction(0)))
    trees: list[Any] = [s.velocity for s in problem.spheres if s.velocity != rest]
    for _, step in problem.steps():
        if not isinstance(step, Impact):
            trees += trees_of_step(step)
        if isinstance(step, Find) and any(
            getattr(item.expression, "kind", "") in ("velocity", "direction", "momentum")
            for item in step.items
        ):
            return True
    nodes = [n for tree in trees if isinstance(tree, Expression) for n in walk(tree)]
    return any(isinstance(node, Pair) or node == Unit("j") for node in nodes)


def _with_axes(shapes: list[Shape], labels: list[Label], panel: Box) -> float:
    """Adds **i** and **j** in a free corner of a panel; returns how much it has to grow."""
    size, edge = 5.5, 2.2
    taken = [piece.box for shape in shapes for piece in ink(shape)]
    taken += [_expected(label) for label in labels if not label.fixed]
    lowered = 0.0
    room = size + 3.5
    left, _, right, top = panel
    corners = [
        Vector(x, y) for x in (left + edge, right - edge - room) for y in (edge, top - edge - room)
    ]
    for corner in corners:
        box = (corner.x, corner.y, corner.x + room, corner.y + room)
        if not any(overlap(box, each, 0.5) for each in taken):
            break
    else:
        lowered = size + 2.0
        corner = Vector(left + edge, edge - lowered)
    origin = corner + Vector(0.5, 0.5)
    for axis, name, side in ((_I, "i", "e"), (_J, "j", "n")):
        tip = origin + axis * size
        shapes.append(Arrow("axis", origin, tip))
        labels.append(Label(lay.Bold(name), tip, (side,), 0.7, 2.8))  # type: ignore[arg-type]
    return lowered


def _note(view: _View, panels: Sequence[When], scale: float) -> Layout | None:
    """The values by which letters are drawn, and whether an arrow is longer than to scale."""
    words: list[Layout] = []
    chosen = drawn_for(view.motion, (view.number,), panels)
    if chosen:
        words.append(lay.Words("Drawn for"))
        for index, each in enumerate(chosen, 1):
            relation = lay.Relation((lay.letter(each.name), describe.value_of(each)), ("=",))
            left = len(chosen) - index
            end = "." if left == 0 else " and" if left == 1 else ","
            words.append(lay.Phrase((relation, lay.Words(end)), ""))
    sizes = [math.hypot(*view.velocity(body.name, when)) for body in view.bodies for when in panels]
    if any(1e-6 < size * scale < TINY for size in sizes):
        words.append(lay.Words("The shortest arrows are longer than to scale."))
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
