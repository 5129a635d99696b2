"""Patterns that data of the model do not have, and how they are decided together.

Each pattern is a test of the model against a wider one. All patterns of one experiment share a
false alarm of FAMILY: the p-values are compared by the method of Holm (S. Holm, "A simple
sequentially rejective multiple test procedure", Scandinavian Journal of Statistics 6, 1979).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from restitution.experiments.results import Check
from restitution.records import dataclass

FAMILY = 0.05
"""The probability that any pattern is seen in data that have none."""

TITLES = {
    "above-one": "e above 1",
    "speed": "e that depends on speed",
    "offset": "a line that misses the origin",
    "friction": "friction along the surface",
    "momentum": "momentum that changes",
    "scatter": "more scatter than the errors explain",
}
"""The patterns by id, in the order in which they are told."""
TITLES_OF_SPHERES = TITLES | {
    "offset": "a line of centres that is turned",
    "friction": "friction between the spheres",
}
TITLES_OF_TRACKS = TITLES | {
    "offset": "a wall that is turned",
    "slowing": "bodies that slow down on their way",
}
TITLES_OF_TWO_TRACKS = TITLES_OF_SPHERES | {"slowing": TITLES_OF_TRACKS["slowing"]}


@dataclass(frozen=True)
class Pattern:
    """A test of one pattern, and what is said if it is seen and if it is not."""

    id: str
    statistic: float
    p_value: float
    seen: str
    not_seen: str
    estimate: float | None = None
    estimate_error: float | None = None
    unit: str = ""


@dataclass(frozen=True)
class Untested:
    """A pattern that these data cannot show, and why."""

    id: str
    reason: str


def decided(
    patterns: Sequence[Pattern | Untested], titles: Mapping[str, str] = TITLES
) -> tuple[Check, ...]:
    """The verdicts on all patterns, in the order of their titles."""
    tested = sorted(
        (pattern for pattern in patterns if isinstance(pattern, Pattern)),
        key=lambda pattern: pattern.p_value,
    )
    checks = {}
    seeing = True
    for rank, pattern in enumerate(tested):
        threshold = FAMILY / (len(tested) - rank)
        seeing = seeing and pattern.p_value < threshold
        checks[pattern.id] = Check(
            pattern.id,
            titles[pattern.id],
            "seen" if seeing else "not seen",
            pattern.seen if seeing else pattern.not_seen,
            pattern.statistic,
            pattern.p_value,
            threshold,
            pattern.estimate,
            pattern.estimate_error,
            pattern.unit,
        )
    for other in patterns:
        if isinstance(other, Untested):
            checks[other.id] = Check(other.id, titles[other.id], "untested", other.reason)
    return tuple(checks[title] for title in titles if title in checks)
