"""A picture as data: what is drawn, where, and what stands beside it.

Places are in millimetres on paper at the picture's natural width, x to the right and y up.
Nothing here knows of SVG, fonts or colours: a role says what a shape is, and the renderer
chooses the line that goes with it.
"""

from __future__ import annotations

from dataclasses import field
from typing import Literal, TypeAlias

from restitution.records import dataclass
from restitution.render.layout import Layout
from restitution.vector import Vector

#: Natural width of a picture on paper, in millimetres: legible in one column of a printed page.
WIDTH = 84.0

LineRole = Literal[
    "line_of_centres",  # dashed
    "across",  # the perpendicular of the line of centres, or the normal of a wall: dashed
    "component",  # thin, dashed, with a head where it is an arrow
    "velocity",  # solid, single head
    "impulse",  # double shaft, open head
    "onward",  # the first direction, continued: dotted
    "path",  # where a centre goes: solid, thin
    "axis",  # i and j in a corner: solid, thin, small head
    "sense",  # which way a letter is counted positive: short, thin, small head
    "measure",  # a dimension line
    "angle",  # an arc with its reference
    "leader",  # from a label to what it names: very thin
    "frame",  # around a panel
]

Side = Literal["e", "ne", "n", "nw", "w", "sw", "s", "se", "centre"]


@dataclass(frozen=True, slots=True)
class Line:
    """A straight line without a head."""

    role: LineRole
    start: Vector
    end: Vector


@dataclass(frozen=True, slots=True)
class Arrow:
    """A straight line with one head at its end; ``both`` puts one at its start too."""

    role: LineRole
    start: Vector
    end: Vector
    both: bool = False


@dataclass(frozen=True, slots=True)
class Polyline:
    """Straight pieces from point to point."""

    role: LineRole
    points: tuple[Vector, ...]


@dataclass(frozen=True, slots=True)
class Disc:
    """A sphere from above. A ``ghost`` is where it also is at some time: drawn thinly, dashed."""

    name: str
    centre: Vector
    radius: float
    ghost: bool = False


@dataclass(frozen=True, slots=True)
class Dot:
    """A point: a named one, a place of impact, a sphere whose radius is negligible."""

    name: str
    centre: Vector
    radius: float = 0.7


@dataclass(frozen=True, slots=True)
class Arc:
    """Part of a circle, anticlockwise from one angle to the other (radians, from the x axis)."""

    role: LineRole
    centre: Vector
    radius: float
    start: float
    end: float


@dataclass(frozen=True, slots=True)
class RightAngle:
    """The small square of a right angle at a corner, between two unit vectors."""

    corner: Vector
    first: Vector
    second: Vector
    size: float = 2.0


@dataclass(frozen=True, slots=True)
class StraightWall:
    """A wall as a solid line, hatched on its far side: the side that ``far`` points to."""

    name: str
    start: Vector
    end: Vector
    far: Vector


@dataclass(frozen=True, slots=True)
class RoundWall:
    """An arc of a circular wall, hatched on the side that no sphere is on."""

    name: str
    centre: Vector
    radius: float
    start: float
    end: float
    hatched: Literal["inside", "outside"]


Shape: TypeAlias = (
    Line | Arrow | Polyline | Disc | Dot | Arc | RightAngle | StraightWall | RoundWall
)


@dataclass(frozen=True, slots=True)
class Label:
    """Words or mathematics that name something, and where they would like to stand.

    ``at`` is the point named, and ``sides`` where the label may stand beside it, best first;
    ``gap`` is the distance to keep from that point. A ``fixed`` label stands at its first side (a
    letter in its disc) and nowhere else, unless a line runs there. A ``ringed`` one is a number in
    a small circle. ``moves`` are other points that the label may name as well, such as other
    places along an arrow.
    """

    content: Layout
    at: Vector
    sides: tuple[Side, ...] = ("ne", "nw", "se", "sw", "n", "s", "e", "w")
    gap: float = 1.0
    size: float = 3.0
    fixed: bool = False
    ringed: bool = False
    moves: tuple[Vector, ...] = ()


@dataclass(frozen=True, slots=True)
class Panel:
    """A part of a picture; its box is left, bottom, right, top, and its heading stands above it."""

    name: str
    box: tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class Scene:
    """A picture.

    ``title`` and ``description`` say it in words, for those who do not see it; ``note`` is printed
    beneath, and says at which values letters are drawn. ``box`` is left, bottom, right, top.
    ``part`` is the label of the part that the picture belongs to, ``event`` the number of the one
    event that it shows.
    """

    title: str
    description: str
    box: tuple[float, float, float, float]
    shapes: tuple[Shape, ...] = ()
    labels: tuple[Label, ...] = ()
    panels: tuple[Panel, ...] = ()
    note: Layout | None = field(default=None)
    part: str | None = None
    event: int | None = None
