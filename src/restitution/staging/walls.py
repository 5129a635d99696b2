"""How far walls go on paper: to the corners where they meet, and never across a path."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from dataclasses import field
from typing import Any

from restitution.records import dataclass
from restitution.staging.plan import Leg
from restitution.vector import Vector

_CLOSE = 1e-6
# What is left between a wall and another one that it does not meet.
_SHORT_OF = 1.5


@dataclass
class DrawnWall:
    """A straight wall while it is being drawn: places along it are counted from ``origin``."""

    name: str
    origin: Vector
    along: Vector
    near: Vector
    hits: list[float]
    low: float
    high: float
    placed: bool
    fixed: bool = False
    corners: dict[str, str] = field(default_factory=dict)

    def at(self, distance: float) -> Vector:
        return self.origin + self.along * distance

    def along_it(self, point: Vector) -> float:
        return float((point - self.origin).dot(self.along))

    def side(self, point: Vector) -> float:
        return float((point - self.origin).dot(self.near))


def crossing(a: Vector, b: Vector, line: DrawnWall) -> tuple[float, float] | None:
    """Where a segment meets the line of a wall: its share, and the place along the wall."""
    first, second = line.side(a), line.side(b)
    if abs(first - second) < 1e-9:
        return None
    share = first / (first - second)
    return share, line.along_it(a + (b - a) * share)


def meeting_point(one: DrawnWall, other: DrawnWall) -> tuple[float, float] | None:
    """Where two lines meet, as places along each."""
    turn = one.along.cross(other.along)
    if abs(turn) < 0.05:
        return None
    separation = other.origin - one.origin
    return separation.cross(other.along) / turn, separation.cross(one.along) / turn


def _share_a_letter(one: str, other: str) -> bool:
    return bool(set(corner_letters(one)) & set(corner_letters(other)))


def corner_letters(name: str) -> tuple[str, ...]:
    """The A and B of a wall AB, whose ends they name; nothing for other names."""
    return tuple(name) if len(name) == 2 and name.isalpha() and name.isupper() else ()


def trim(lines: list[DrawnWall], legs: Sequence[Leg], reach: float, successive: set[Any]) -> int:
    """Lets walls end where they meet, and before a path that would cross them.

    Returns how many paths cross a wall all the same.
    """
    meetings: list[tuple[float, DrawnWall, DrawnWall, float, float]] = []
    for one, other in itertools.combinations(lines, 2):
        where = meeting_point(one, other)
        wanted = (
            (one.placed and other.placed)
            or _share_a_letter(one.name, other.name)
            or frozenset((one.name, other.name)) in successive
        )
        if where is None or not wanted:
            continue
        gaps = [_gap(line, place) for line, place in zip((one, other), where, strict=True)]
        far = [gap for gap in gaps if gap is not None]
        if len(far) == 2 and _clear(one, where[0], legs) and _clear(other, where[1], legs):
            meetings.append((max(far), one, other, *where))
    for gap, one, other, first, second in sorted(meetings, key=lambda meeting: meeting[0]):
        sides = _side_of(one, first, other), _side_of(other, second, one)
        if gap > reach or sides[0] in one.corners or sides[1] in other.corners:
            continue
        for line, s, side, beside in (
            (one, first, sides[0], other),
            (other, second, sides[1], one),
        ):
            line.corners[side] = beside.name
            if not line.fixed:
                setattr(line, side, s)
    for line, other in itertools.permutations(lines, 2):
        where = meeting_point(line, other)
        if where is None or line.fixed or other.name in line.corners.values():
            continue
        s, t = where
        if not other.low - _CLOSE < t < other.high + _CLOSE:
            continue
        if not line.hits:
            side = "high" if line.along.dot(other.near) < 0 else "low"
        elif min(line.hits) <= s <= max(line.hits):
            continue
        else:
            side = "high" if s > max(line.hits) else "low"
        if side in line.corners:
            continue
        if side == "high":
            line.high = min(line.high, s - _SHORT_OF)
        else:
            line.low = max(line.low, s + _SHORT_OF)
    bad = 0
    for line in lines:
        for leg in legs:
            met = crossing(leg.start, leg.end, line)
            if met is None or not 0.001 < met[0] < 0.999:
                continue
            s = met[1]
            if line.fixed or not line.low - 2 < s < line.high + 2:
                bad += line.low < s < line.high
            elif line.hits and s > max(line.hits) + 3:
                line.high = s - 2
                line.corners.pop("high", None)
            elif line.hits and s < min(line.hits) - 3:
                line.low = s + 2
                line.corners.pop("low", None)
            else:
                bad += 1
    return bad


def _gap(line: DrawnWall, s: float) -> float | None:
    """How far a corner is from where the wall is struck; None where it lies between."""
    if line.fixed:
        ends = min(abs(s - line.low), abs(s - line.high))
        return 0.0 if ends < 1e-3 else None
    if not line.hits:
        return 0.0
    beyond = max(s - max(line.hits), min(line.hits) - s)
    return max(beyond, 0.0) if beyond > -1e-3 else None


def _side_of(line: DrawnWall, s: float, other: DrawnWall) -> str:
    """Which end of a wall a corner with another one is."""
    if line.fixed or not line.hits:
        return "high" if abs(s - line.high) < abs(s - line.low) else "low"
    if min(abs(s - hit) for hit in line.hits) < 1:  # struck in the corner itself
        return "high" if line.along.dot(other.near) < 0 else "low"
    return "high" if s > max(line.hits) else "low"


def _clear(line: DrawnWall, s: float, legs: Iterable[Leg]) -> bool:
    """Whether no path crosses a wall between where it is struck and a corner."""
    if line.fixed or not line.hits:
        return True
    near = min(line.hits, key=lambda h: abs(h - s))
    for leg in legs:
        met = crossing(leg.start, leg.end, line)
        if met is not None and 0.001 < met[0] < 0.999 and (met[1] - near) * (met[1] - s) < 0:
            return False
    return True
