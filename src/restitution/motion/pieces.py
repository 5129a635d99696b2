"""What a motion is made of: for each body straight pieces, and the impacts between them.

All numbers are floats in SI units. A motion is what the player plays, whoever made it: the
solution of a problem or a simulation.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import field

from restitution.records import dataclass
from restitution.vector import Vector


@dataclass(frozen=True, slots=True)
class Piece:
    """Uniform motion from ``start`` to ``end`` (s): the place at the start (m), the velocity."""

    start: float
    end: float
    place: Vector
    velocity: Vector

    def at(self, time: float) -> Vector:
        """The place at a time, in m; it is not asked whether the time is within the piece."""
        return self.place + self.velocity * (time - self.start)


@dataclass(frozen=True, slots=True)
class Track:
    """One sphere's whole motion: pieces in the order of time, each starting where one ended."""

    name: str
    radius: float
    mass: float
    pieces: tuple[Piece, ...]

    def piece(self, time: float) -> Piece:
        """The piece at a time; at an impact the one after it, outside of all the nearest."""
        after = bisect_right(self.pieces, time, key=lambda piece: piece.start)
        return self.pieces[max(after - 1, 0)]

    def at(self, time: float) -> Vector:
        """The place of the centre at a time, in m."""
        return self.piece(time).at(time)


@dataclass(frozen=True, slots=True)
class Struck:
    """One impact of a motion.

    ``first`` is a sphere, ``second`` a sphere or a wall, by name; ``place`` is the point of
    contact (m), ``line_of_centres`` the unit vector from the first to the second (into a wall),
    ``impulse`` what the second receives (N s). ``before`` and ``after`` hold the velocities of
    both (m/s); a wall's are zero.
    """

    time: float
    first: str
    second: str
    place: Vector
    line_of_centres: Vector
    e: float
    impulse: Vector
    before: tuple[Vector, Vector]
    after: tuple[Vector, Vector]


@dataclass(frozen=True, slots=True)
class Blow:
    """An impulse (N s) given to a sphere from outside; ``place`` is that of its centre (m)."""

    time: float
    body: str
    place: Vector
    impulse: Vector
    before: Vector
    after: Vector


@dataclass(frozen=True, slots=True)
class Reached:
    """A sphere's centre comes to a point, or a sphere to a wall, and nothing changes (s, m)."""

    time: float
    body: str
    place: Vector
    target: str | None
    velocity: Vector


@dataclass(frozen=True, slots=True)
class WallLine:
    """A straight wall, or several joined, through points (m); ``closed`` joins the ends."""

    name: str
    points: tuple[Vector, ...]
    closed: bool = False


@dataclass(frozen=True, slots=True)
class WallCircle:
    """A circular wall: its centre and radius, in m."""

    name: str
    centre: Vector
    radius: float


@dataclass(frozen=True)
class Motion:
    """Bodies that move, what they strike, and when, from time ``start`` to ``end`` (s).

    ``points`` are named places (m), ``notes`` sentences for those who look at it.
    """

    tracks: tuple[Track, ...]
    impacts: tuple[Struck, ...]
    walls: tuple[WallLine | WallCircle, ...] = ()
    start: float = 0.0
    end: float = 0.0
    notes: Sequence[str] = field(default=())
    blows: tuple[Blow, ...] = ()
    reached: tuple[Reached, ...] = ()
    points: Mapping[str, Vector] = field(default_factory=dict)

    def at(self, time: float) -> Mapping[str, tuple[Vector, Vector]]:
        """Place (m) and velocity (m/s) of every sphere at a time, by name."""
        return {track.name: (track.at(time), track.piece(time).velocity) for track in self.tracks}
