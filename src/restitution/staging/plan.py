"""The plan of a story on paper, as data: what a picture of paths is drawn from.

Lengths and places are in millimetres on paper, x to the right and y up.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from restitution.records import dataclass
from restitution.staging.geometry import unit
from restitution.vector import Vector


@dataclass(frozen=True, slots=True)
class Leg:
    """A straight piece of the path of a centre: the one after event ``after`` (0 is the start).

    ``lane`` says how far it is drawn to the left of where it is, as other pieces lie there too.
    """

    body: str
    after: int
    kind: Literal["approach", "flight", "exit"]
    start: Vector
    end: Vector
    lane: float = 0.0

    @property
    def direction(self) -> Vector:
        """The unit vector along it."""
        return unit(self.end - self.start)

    @property
    def shift(self) -> Vector:
        """How far it is drawn from where it is."""
        return self.direction.turned_left() * self.lane


@dataclass(frozen=True, slots=True)
class Stop:
    """An event and where it happens.

    ``normal`` is the unit vector from the first body to the second, or into the wall; ``contact``
    where they touch.
    """

    number: int
    kind: Literal["wall", "circle", "spheres", "kick", "arrival"]
    centres: Mapping[str, Vector]
    contact: Vector
    wall: str | None = None
    normal: Vector | None = None


@dataclass(frozen=True, slots=True)
class Straight:
    """A straight wall as drawn; ``corners`` are the walls that it meets at its start and end."""

    name: str
    start: Vector
    end: Vector
    far: Vector
    corners: tuple[str | None, str | None] = (None, None)
    fixed: bool = False


@dataclass(frozen=True, slots=True)
class Round:
    """A circular wall."""

    name: str
    centre: Vector
    radius: float
    inside: bool


@dataclass(frozen=True, slots=True)
class Plan:
    """A story on paper.

    ``scale`` is millimetres for a unit of length, or None where the statement gives no places.
    ``radius`` is that of the spheres, 0 where it is negligible.
    """

    legs: tuple[Leg, ...]
    stops: tuple[Stop, ...]
    starts: Mapping[str, Vector]
    walls: tuple[Straight, ...]
    rounds: tuple[Round, ...]
    points: Mapping[str, Vector]
    radius: float
    scale: float | None
    side_by_side: bool = False
    in_line: bool = False  # everything moves along one line
