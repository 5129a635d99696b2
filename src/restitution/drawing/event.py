"""One event as it is to be drawn, and its shapes as they are made.

Lengths are in millimetres on paper, around the point of contact.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal

from restitution.drawing.geometry import COMPASS, sides_towards
from restitution.drawing.ink import Piece, distance, ink, overlap, stick
from restitution.drawing.sayings import Sayings, VelocityLabels, state_after
from restitution.drawing.scene import Arrow, Label, Shape
from restitution.expression.tree import Expression
from restitution.records import dataclass
from restitution.render.glyphs import Box, outline, union
from restitution.render.layout import Layout
from restitution.staging.values import PartInNumbers, When
from restitution.vector import Vector

RADIUS = 4.2  # of a sphere on paper
WALL = 9.5  # of a wall, to either side of the contact
LINE = RADIUS + 5.5  # of a line of centres, from the centre of a sphere outwards
LONGEST_LABEL = 60  # of any label, in signs on one line
ZERO = 1e-9
_FAR = 3.0  # enough room beside an arrow

RIGHT, UP = Vector(1.0, 0.0), Vector(0.0, 1.0)


@dataclass(frozen=True)
class Body:
    """A sphere in an impact: its place on paper, and the way to what it strikes (None: nothing)."""

    name: str
    centre: Vector
    towards: Vector | None


@dataclass(frozen=True)
class View:
    """One event as it is to be drawn: ``n`` along the line of centres, ``t`` across it."""

    motion: PartInNumbers
    sayings: Sayings
    number: int
    kind: Literal["spheres", "wall", "blow"]
    bodies: tuple[Body, ...]
    n: Vector
    t: Vector
    question: bool = False  # only what the statement gives is to be seen
    letters: Mapping[Expression, str] | None = None  # of the working; None where there is none

    def velocity(self, body: str, when: When) -> Vector:
        get = self.motion.before if when == "before" else self.motion.after
        return get(self.number, body)

    def words(self, body: str, when: When) -> VelocityLabels:
        stage = self.number - 1 if when == "before" else self.number
        return self.sayings.of(body, state_after(self.motion, body, stage))


@dataclass
class Drawing:
    """Shapes and labels of one panel, as they are made."""

    shapes: list[Shape]
    labels: list[Label]

    def box(self) -> Box:
        """What is drawn, and about where the labels beside it will stand."""
        boxes = [expected(label) for label in self.labels if not label.fixed]
        return union([*(piece.box for piece in self.ink()), *boxes])

    def ink(self) -> Iterator[Piece]:
        return (piece for shape in self.shapes for piece in ink(shape))


def is_on_axes(view: View) -> bool:
    """Whether the line of centres is horizontal or vertical on paper."""
    return any(abs(abs(view.n.dot(axis)) - 1) < ZERO for axis in (RIGHT, UP))


def beside(label: Layout, start: Vector, end: Vector, outward: Vector) -> Label:
    """A label beside an arrow: at its middle, or elsewhere along it, on one side if it can be."""
    points = tuple(start + (end - start) * share for share in (0.5, 0.65, 0.35, 0.8, 0.2))
    first, second, third, *_ = sides_towards(outward)
    return Label(
        label,
        points[0],
        (first, second, third, *sides_towards(-outward)[:3]),
        0.9,
        3.0,
        moves=points[1:],
    )


def expected(label: Label) -> Box:
    """About where a label stands if its first wish is granted."""
    left, bottom, right, top = (label.size * x for x in outline(label.content).box)
    half = Vector((right - left) / 2, (top - bottom) / 2)
    side = COMPASS[label.sides[0]]
    x, y = label.at.x + side.x * (label.gap + half.x), label.at.y + side.y * (label.gap + half.y)
    return x - half.x, y - half.y, x + half.x, y + half.y


def room_beside(arrow: Arrow, pieces: Sequence[Piece]) -> float:
    """The distance from an arrow to the nearest ink, no more than ``_FAR``; none in a sphere."""
    points = [arrow.start + (arrow.end - arrow.start) * (k / 6) for k in range(7)]
    extent = stick(arrow.start, arrow.end, _FAR).box
    return min(
        (
            distance(point, piece)
            for piece in pieces
            if overlap(extent, piece.box)
            for point in points
        ),
        default=_FAR,
    )
