"""One impact as a picture of two equal panels, before and after it, to one scale.

The circles touch. A velocity is an arrow from the centre; where it would run through the other
body it is drawn as arriving at the centre instead. Its components, thin and dashed, complete a
right-angled triangle. Everything is computed in millimetres around the point of contact, and the
two panels are then laid side by side.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from restitution.drawing import describe
from restitution.drawing.angles import put_inclination
from restitution.drawing.bodies import put_lines, put_names, put_wall
from restitution.drawing.event import (
    LONGEST_LABEL,
    RADIUS,
    RIGHT,
    UP,
    Body,
    Drawing,
    View,
    expected,
    is_on_axes,
)
from restitution.drawing.impulses import put_impulses
from restitution.drawing.ink import ink, overlap
from restitution.drawing.sayings import Sayings, speaks_of_vectors
from restitution.drawing.scene import (
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
from restitution.drawing.velocities import TINY, has_numbers, put_velocity
from restitution.expression.tree import Expression
from restitution.problem import Impact, Kick
from restitution.render import layout as lay
from restitution.render.glyphs import Box, outline
from restitution.render.layout import Layout
from restitution.render.text import to_text
from restitution.staging.geometry import direction, floats
from restitution.staging.values import PartInNumbers, When, axes, drawn_for
from restitution.vector import Vector

LONGEST = 17.0  # of an arrow of velocity
GAP = 2.0  # between the panels
FRAME = 0.2  # of room around them for their frames
PANEL = (WIDTH - GAP) / 2 - FRAME
MARGIN = 2.4  # above and below what is drawn
EDGE = 1.2  # between what is drawn and the frame of its panel
SHORTEST = 9.0  # for the longest arrow: what does not fit then has its labels elsewhere


def before_and_after(
    motion: PartInNumbers,
    sayings: Sayings,
    number: int,
    panels: Sequence[When] = ("before", "after"),
    *,
    question: bool = False,
    to_scale: bool = True,
    letters: Mapping[Expression, str] | None = None,
) -> Scene:
    """The picture of one impact, or of one blow from outside. ``number`` is that of the event.

    That of a ``question`` has velocities as the statement gives them, and no values by which it is
    drawn; it says so where it is not ``to_scale``. ``letters`` are those of the working.
    """
    view = replace(_view(motion, sayings, number), question=question, letters=letters)
    to_scale &= set(drawn_for(motion, (number,), panels)) <= set(motion.solved)
    scale, drawings = _fitted(view, panels)
    boxes = [drawing.box() for drawing in drawings]
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
            replace(label, at=label.at + shift, moves=tuple(move + shift for move in label.moves))
            for label in drawing.labels
        ]
        frames.append((x, 0.0, x + PANEL, height))
    lowered = _with_axes(shapes, labels, frames[0]) if _needs_axes(view) else 0.0
    return Scene(
        describe.title(motion, number, panels),
        describe.question(motion, number, sayings, to_scale=to_scale)
        if question
        else describe.description(motion, number, panels),
        (0.0, -lowered - FRAME, WIDTH, height + FRAME),
        tuple(shapes),
        tuple(labels),
        tuple(
            Panel(when.capitalize(), (box[0], -lowered, *box[2:]))
            for when, box in zip(panels, frames)
        ),
        _note(view, panels, scale, to_scale=to_scale),
    )


def _fitted(view: View, panels: Sequence[When]) -> tuple[float, list[Drawing]]:
    """The panels to one scale, the largest at which they fit, with that scale."""
    fastest = max(
        math.hypot(*view.velocity(body.name, when)) for body in view.bodies for when in panels
    )
    longest = LONGEST
    while True:
        scale = longest / fastest if fastest else 1.0
        drawings = [_panel(view, when, scale) for when in panels]
        boxes = [drawing.box() for drawing in drawings]
        if max(b[2] - b[0] for b in boxes) <= PANEL - 2 * EDGE or longest < SHORTEST:
            return scale, drawings
        longest *= 0.93


def _view(motion: PartInNumbers, sayings: Sayings, number: int) -> View:
    happening = motion.story.happenings[number - 1]
    step = happening.step
    if isinstance(step, Kick):
        body = Body(step.body, Vector(0.0, 0.0), None)
        return View(motion, sayings, number, "blow", (body,), RIGHT, UP)
    assert isinstance(step, Impact)
    n, t = axes(motion, number)
    if motion.model.frames[number].wall is not None:
        body = Body(step.first, n * RADIUS, -n)
        return View(motion, sayings, number, "wall", (body,), n, t)
    assert happening.centres is not None
    c = direction(floats(happening.oriented()))
    bodies = Body(step.first, -c * RADIUS, c), Body(step.second, c * RADIUS, -c)
    return View(motion, sayings, number, "spheres", bodies, n, t)


def _panel(view: View, when: When, scale: float) -> Drawing:
    drawing = Drawing([], [])
    if view.kind == "wall":
        put_wall(view, drawing)
    for body in view.bodies:
        drawing.shapes.append(Disc(body.name, body.centre, RADIUS))
    for body in view.bodies:
        put_velocity(view, body, when, scale, drawing)
    if when == "after":
        put_impulses(view, drawing)
    put_lines(view, drawing)
    if when == "before":
        put_inclination(view, drawing)
    for body in view.bodies:
        put_names(view, body, drawing)
    drawing.labels = [label for label in drawing.labels if _is_readable(label)]
    return drawing


def _is_readable(label: Label) -> bool:
    """Whether a label is short enough for a panel; the description has what it would say."""
    if len(to_text(label.content)) > LONGEST_LABEL:  # before it is set, which takes its time
        return False
    left, _, right, _ = outline(label.content).box
    return (right - left) * label.size < 0.75 * PANEL


def _needs_axes(view: View) -> bool:
    """Whether the picture is to show **i** and **j**.

    Not where they only say how the line of centres lies, which is drawn horizontally.
    """
    if view.kind == "blow" or not is_on_axes(view):
        return True
    return speaks_of_vectors(view.motion.model.problem, apart_from=(Impact,))


def _with_axes(shapes: list[Shape], labels: list[Label], panel: Box) -> float:
    """Adds **i** and **j** in a free corner of a panel; returns how much it has to grow."""
    size, edge = 5.5, 2.2
    taken = [piece.box for shape in shapes for piece in ink(shape)]
    taken += [expected(label) for label in labels if not label.fixed]
    lowered = 0.0
    room = size + 3.5
    left, _, right, top = panel
    corners = [
        Vector(x, y) for x in (left + edge, right - edge - room) for y in (edge, top - edge - room)
    ]
    for corner in corners:
        box = (corner.x, corner.y, corner.x + room, corner.y + room)
        if not any(overlap(box, place, 0.5) for place in taken):
            break
    else:
        lowered = size + 4.5  # with the letter above
        corner = Vector(left + edge, edge - lowered)
    origin = corner + Vector(0.5, 0.5)
    named: tuple[tuple[Vector, str, Side], ...] = (RIGHT, "i", "e"), (UP, "j", "n")
    for axis, name, side in named:
        tip = origin + axis * size
        shapes.append(Arrow("axis", origin, tip))
        labels.append(Label(lay.Bold(name), tip, (side,), 0.7, 2.8))
    return lowered


def _note(view: View, panels: Sequence[When], scale: float, *, to_scale: bool) -> Layout | None:
    """The values by which letters are drawn, and whether an arrow is longer than to scale."""
    if view.question:
        return None if to_scale else lay.Words("Not to scale.")
    if not describe.is_possible(view.motion, view.number):
        return lay.Words(describe.IMPOSSIBLE)
    words = describe.values_of(drawn_for(view.motion, (view.number,), panels))
    sizes = [math.hypot(*view.velocity(body.name, when)) for body in view.bodies for when in panels]
    if any(1e-6 < size * scale < TINY for size in sizes):
        words += (lay.Words("The shortest arrows are longer than to scale."),)
    if has_numbers(view, panels):
        words += (lay.Words("Speeds are in m s⁻¹."),)
    return lay.Phrase(words) if words else None


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
