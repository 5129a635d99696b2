"""When bodies of a motion would be within one another: what must not be, outside of its impacts.

The centre of a sphere moves along a straight line relative to another one, or to a wall. The
places where it is too near are a disc or a strip with round ends, both convex, so each piece of
motion is within them for one interval of time.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

from restitution.motion.pieces import Motion, Piece, Track, WallCircle, WallLine
from restitution.records import dataclass
from restitution.vector import Vector

#: How much nearer than in contact is too near, as a share of the extent of a motion; far more than
#: rounding, as places come from a system of equations, and less than anybody sees.
TOO_NEAR = 1e-7
#: Times that differ by less than this share of the whole are those of one contact.
AT_ONCE = 1e-6

_Interval = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Overlap:
    """Two bodies, by name, that would be within one another, or at one place, for a time (s)."""

    start: float
    end: float
    first: str
    second: str


def overlaps(motion: Motion, extent: float) -> list[Overlap]:
    """Where bodies overlap, impacts that are told apart, in the order of time.

    ``extent`` is the size of the whole, in m. Spheres of no size overlap while they pass through
    one point or through a wall.
    """
    tolerance = TOO_NEAR * extent
    overlaps_ = [
        *_of_spheres(motion.tracks, tolerance),
        *_with_walls(motion.tracks, motion.walls, tolerance),
    ]
    contacts = [(hit.time, {hit.first, hit.second}) for hit in motion.impacts]
    contacts += [(at.time, {at.body, at.target}) for at in motion.reached if at.target]
    moment = AT_ONCE * (motion.end - motion.start)
    pairs = [
        overlap
        for overlap in overlaps_
        if overlap.end > motion.start + moment  # what begins in contact may part
        and not any(
            names == {overlap.first, overlap.second}
            and overlap.start - moment <= time <= overlap.end + moment
            for time, names in contacts
        )
    ]
    return sorted(pairs, key=lambda pair: pair.start)


def _of_spheres(tracks: Sequence[Track], tolerance: float) -> Iterator[Overlap]:
    for one, other in itertools.combinations(tracks, 2):
        reach = _reach(one.radius + other.radius, tolerance)
        for a, b in itertools.product(one.pieces, other.pieces):
            start, end = max(a.start, b.start), min(a.end, b.end)
            if end <= start:
                continue
            gap = a.at(start) - b.at(start)
            within = _in_disc(gap, a.velocity - b.velocity, Vector(0.0, 0.0), reach)
            yield from _overlap(within, start, end, one.name, other.name)


def _with_walls(
    tracks: Sequence[Track], walls: Sequence[WallLine | WallCircle], tolerance: float
) -> Iterator[Overlap]:
    for track, wall in itertools.product(tracks, walls):
        for piece in track.pieces:
            if piece.end <= piece.start:
                continue
            intervals = (
                _round(track, piece, wall, tolerance)
                if isinstance(wall, WallCircle)
                else _straight(piece, wall, _reach(track.radius, tolerance))
            )
            for within in intervals:
                yield from _overlap(within, piece.start, piece.end, track.name, wall.name)


def _reach(distance: float, tolerance: float) -> float:
    """How near is too near, where contact is at a distance."""
    return distance - tolerance if distance > 2 * tolerance else tolerance


def _overlap(
    within: _Interval | None, start: float, end: float, first: str, second: str
) -> Iterator[Overlap]:
    if within is None:
        return
    low, high = max(0.0, within[0]), min(end - start, within[1])
    if high > low:
        yield Overlap(start + low, start + high, first, second)


def _in_disc(place: Vector, velocity: Vector, centre: Vector, radius: float) -> _Interval | None:
    """From when until when a point in uniform motion is within a disc."""
    gap = place - centre
    a, b, c = velocity.dot(velocity), gap.dot(velocity), gap.dot(gap) - radius * radius
    if a == 0.0:
        return (-math.inf, math.inf) if c < 0 else None
    under = b * b - a * c
    if under <= 0:
        return None
    root = math.sqrt(under)
    return (-b - root) / a, (-b + root) / a


def _straight(piece: Piece, wall: WallLine, reach: float) -> Iterator[_Interval | None]:
    points = [*wall.points, *wall.points[:1]] if wall.closed else list(wall.points)
    for a, b in itertools.pairwise(points):
        yield _in_strip(piece.place, piece.velocity, a, b, reach)


def _in_strip(
    place: Vector, velocity: Vector, a: Vector, b: Vector, reach: float
) -> _Interval | None:
    """From when until when a point in uniform motion is within reach of a segment."""
    parts = [_in_disc(place, velocity, end, reach) for end in (a, b)]
    size = math.hypot(*(b - a))
    if size > 0:
        along = (b - a) / size
        across = _between(along.cross(place - a), along.cross(velocity), -reach, reach)
        beside = _between(along.dot(place - a), along.dot(velocity), 0.0, size)
        if across is not None and beside is not None:
            both = max(across[0], beside[0]), min(across[1], beside[1])
            parts.append(both if both[1] > both[0] else None)
    met = [part for part in parts if part is not None]
    return (min(low for low, _ in met), max(high for _, high in met)) if met else None


def _between(x: float, rate: float, low: float, high: float) -> _Interval | None:
    """From when until when a number that grows evenly lies between two."""
    if abs(rate) < 1e-300:
        return (-math.inf, math.inf) if low < x < high else None
    first, second = (low - x) / rate, (high - x) / rate
    return min(first, second), max(first, second)


def _round(
    track: Track, piece: Piece, wall: WallCircle, tolerance: float
) -> Iterator[_Interval | None]:
    first = track.pieces[0]
    middle = first.at((first.start + first.end) / 2)  # on the rim at either end, perhaps
    if math.hypot(*(middle - wall.centre)) > wall.radius:
        reach = _reach(wall.radius + track.radius, tolerance)
        yield _in_disc(piece.place, piece.velocity, wall.centre, reach)
        return
    room = wall.radius - track.radius + tolerance
    free = _in_disc(piece.place, piece.velocity, wall.centre, room)
    if free is None:
        yield -math.inf, math.inf
    else:
        yield -math.inf, free[0]
        yield free[1], math.inf
