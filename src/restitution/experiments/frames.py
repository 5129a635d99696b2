"""Which part of the plane a plot of the law shows, so that a few far readings do not squeeze it."""

from __future__ import annotations

import math
import statistics
from collections.abc import Sequence

from restitution.experiments.whole import Experiment
from restitution.records import dataclass

_SQUEEZED = 5.0
"""A reading so many times farther out than the middle one squeezes the others."""
_FEW = 0.4
"""The share of readings that may be left outside."""
_BOUNDLESS = 1e6
"""A tangent beyond this is that of a right angle."""


@dataclass(frozen=True)
class Frame:
    """The limits of a plot in its own units."""

    left: float
    right: float
    bottom: float
    top: float

    def holds(self, x: float, y: float) -> bool:
        return self.left <= x <= self.right and self.bottom <= y <= self.top

    def at_edge(self, x: float, y: float) -> tuple[float, float]:
        """The point of the edge on the way from the origin to a point outside."""
        limits = [
            (value, limit)
            for value, limit in (
                (x, self.right if x > 0 else self.left),
                (y, self.top if y > 0 else self.bottom),
            )
            if abs(value) > abs(limit)
        ]
        share = min((limit / value for value, limit in limits), default=1.0)
        return (
            min(max(x * share, self.left), self.right),
            min(max(y * share, self.bottom), self.top),
        )


def frame_of(experiment: Experiment) -> Frame:
    """The frame of the law: all readings, but for a few that would squeeze the others."""
    points = experiment.points
    right = 1.07 * outlying([point.x for point in points], _SQUEEZED, least=1e-3)
    along = [point for point in points if point.x <= right]
    ends = [point.y + min(point.y_error, 0.5 * abs(point.y) + 0.1 * right) for point in along]
    usual = max(1.6 * experiment.e * right, 1.2 * right)
    ends = [end for end in ends if end <= usual] or [usual]
    top = 1.07 * max(*ends, experiment.e * right, 0.03 * right)
    lowest = min((point.y for point in along), default=0.0)
    bottom = 0.0 if lowest >= 0 else 1.1 * max(lowest, min(-top, 1.6 * experiment.e * right))
    left = min(0.0, *(1.1 * max(point.x, -right) for point in points))
    return Frame(left, right, bottom, top)


def outlying(values: Sequence[float], times: float, least: float = 0.0) -> float:
    """The largest value to be shown: without the few that squeeze the others.

    That is the largest of all, unless it is so many ``times`` the middle one, and leaving out no
    more than two fifths helps.
    """
    ordered = sorted(value for value in values if math.isfinite(value) and value < _BOUNDLESS)
    if not ordered:
        return 1.0
    kept = list(ordered)
    while len(kept) > 1 and kept[-1] > times * max(statistics.median(kept), least):
        kept.pop()
    allowed = math.floor(_FEW * len(ordered))
    shown = kept if len(ordered) - len(kept) <= allowed else ordered
    return max(shown[-1], least)
