"""The marks of a working: the points of a scheme, each earned, lost or open."""

from __future__ import annotations

from typing import Literal

from restitution.practice.marking.scheme import MarkPoint, Scheme
from restitution.records import dataclass

State = Literal["earned", "lost", "open"]


@dataclass(frozen=True)
class PointMark:
    """A point with its state, the line that decided, and why, in one clause.

    ``implied`` tells that it was earned by a later value that cannot be had without it.
    """

    point: MarkPoint
    state: State
    line: int | None = None
    why: str = ""
    implied: bool = False


@dataclass(frozen=True)
class Marks:
    """The points of the scheme by which a working has most."""

    scheme: Scheme
    points: tuple[PointMark, ...]

    def count(self, state: State) -> int:
        """How many points are in a state."""
        return sum(point.state == state for point in self.points)

    @property
    def earned(self) -> int:
        return self.count("earned")

    @property
    def lost(self) -> int:
        return self.count("lost")

    @property
    def open(self) -> int:
        return self.count("open")

    @property
    def of(self) -> int:
        return len(self.points)


__all__ = ["Marks", "PointMark", "State"]
