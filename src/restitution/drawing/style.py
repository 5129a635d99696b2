"""How wide, how dashed and how pointed: what a role looks like on paper, in millimetres.

Everything is told by line style alone, so that a picture is the same in black and white.
"""

from __future__ import annotations

from restitution.drawing.scene import LineRole
from restitution.records import dataclass


@dataclass(frozen=True, slots=True)
class Stroke:
    """A line: its width, its dashes, and how strong its ink is.

    Ink of strength 0.65 keeps a contrast above 4.5:1 on white and on the usual dark backgrounds.
    A dash of no length with ``round`` ends is a dot.
    """

    width: float
    dashes: tuple[float, ...] = ()
    strength: float = 1.0
    round: bool = False


@dataclass(frozen=True, slots=True)
class Head:
    """The head of an arrow, from tip to base and half across."""

    length: float
    half: float


STROKES: dict[LineRole, Stroke] = {
    "line_of_centres": Stroke(0.2, (2.2, 0.9), 0.65),
    "across": Stroke(0.2, (1.1, 0.9), 0.65),
    "component": Stroke(0.28, (1.0, 0.7), 0.72),
    "velocity": Stroke(0.5),
    "impulse": Stroke(0.28),
    "onward": Stroke(0.4, (0.0, 1.0), round=True),
    "path": Stroke(0.35),
    "axis": Stroke(0.3),
    "sense": Stroke(0.25),
    "measure": Stroke(0.18),
    "angle": Stroke(0.25),
    "leader": Stroke(0.13, strength=0.72),
    "frame": Stroke(0.13, strength=0.35),
}
HEADS: dict[LineRole, Head] = {
    "velocity": Head(2.7, 0.85),
    "impulse": Head(2.3, 1.35),
    "component": Head(1.9, 0.6),
    "path": Head(2.2, 0.7),
    "axis": Head(1.6, 0.5),
    "sense": Head(1.4, 0.5),
    "measure": Head(1.5, 0.4),
}
ANGLE_HEAD = Head(1.5, 0.5)  # of any other line that is drawn as an arrow

DISC = Stroke(0.35)
GHOST = Stroke(0.22, (0.8, 0.6), 0.72)
RIGHT_ANGLE = Stroke(0.2)
RING = Stroke(0.2)
WALL = Stroke(0.55)
HATCH = Stroke(0.18)
HATCH_SPACING = 1.5
HATCH_DEPTH = 1.3
SHAFT_GAP = 1.0  # between the two lines of an impulse


def head(role: LineRole, length: float) -> Head:
    """The head of an arrow of this length: smaller where the arrow is hardly longer than it."""
    full = HEADS.get(role, ANGLE_HEAD)
    share = min(1.0, 0.7 * length / full.length)
    return Head(full.length * share, full.half * share)
