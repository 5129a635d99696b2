"""What comes of an experiment: e with its uncertainty, what a class computes, and the checks."""

from __future__ import annotations

import dataclasses
import json
import math
from typing import Any, Literal

from restitution.experiments.records import Kind, Table
from restitution.records import dataclass

Verdict = Literal["seen", "not seen", "untested"]


@dataclass(frozen=True)
class Interval:
    """Where e lies, at a level of confidence.

    ``low`` and ``high`` are what the calculation gives, which may lie outside [0, 1], and be
    infinite where the readings set no bound. ``method`` is a sentence.
    """

    low: float
    high: float
    level: float
    method: str

    @property
    def possible(self) -> tuple[float, float] | None:
        """The part that lies within [0, 1], or None where there is none."""
        low, high = max(self.low, 0.0), min(self.high, 1.0)
        return (low, high) if low <= high else None


@dataclass(frozen=True)
class Point:
    """One trial in the picture of the law y = e x, with the point of the fit nearest to it.

    For walls x is tan α and y is tan β, ``alpha`` and ``beta`` are the angles in degrees; for two
    spheres x is the speed of approach and y the speed of separation, and the angles are None.
    Errors are standard errors, propagated to x and y; ``residual`` is the distance from the fit in
    standard errors, positive above it. ``speed`` is that before the impact, if known.
    """

    line: int
    x: float
    y: float
    x_error: float
    y_error: float
    x_fitted: float
    y_fitted: float
    residual: float
    alpha: float | None = None
    beta: float | None = None
    alpha_error: float | None = None
    beta_error: float | None = None
    speed: float | None = None
    label: str = ""


@dataclass(frozen=True)
class ClassValues:
    """What a class computes: without weights, and without a look at the errors.

    ``mean_ratio`` is the mean of y/x (tan β / tan α), ``mean_ratio_error`` the standard error of
    that mean, None for one point. ``slope`` is that of the line through the origin by least squares
    of y on x, which stands for the line that is drawn by eye. ``why`` says why they differ from e.
    """

    mean_ratio: float
    mean_ratio_error: float | None
    slope: float
    why: str


@dataclass(frozen=True)
class Check:
    """One pattern that the model does not have, and whether the data have it.

    ``id`` is one of "above-one", "speed", "offset", "friction", "momentum", "scatter", "slowing".
    ``estimate`` is the size of the pattern with its standard error, in ``unit``. ``threshold`` is
    what ``p_value`` was compared with; all of these are None where the pattern is untested.
    """

    id: str
    title: str
    verdict: Verdict
    sentence: str
    statistic: float | None = None
    p_value: float | None = None
    threshold: float | None = None
    estimate: float | None = None
    estimate_error: float | None = None
    unit: str = ""


@dataclass(frozen=True)
class StraightLine:
    """A straight line through positions: where the body was at a time, and its velocity."""

    t: float
    x: float
    y: float
    velocity_x: float
    velocity_y: float
    velocity_error: float


@dataclass(frozen=True)
class FittedTrack:
    """A track with the straight lines before and after its impact, and when and where that was.

    ``wall`` is the direction of the wall, or of the common tangent, in degrees from x.
    """

    trial: str
    body: str
    before: StraightLine
    after: StraightLine
    t: float
    x: float
    y: float
    position_error: float
    wall: float


@dataclass(frozen=True)
class ExperimentContent:
    """What an experiment holds: the coefficient of restitution from what was measured.

    ``error_source`` says where the errors of the readings are from; ``angle_error`` is the error of
    one angle in degrees where it is the same for all, else None, and ``speed_error`` that of one
    component of a velocity.
    """

    kind: Kind
    table: Table
    e: float
    standard_error: float
    interval: Interval
    error_source: Literal["given", "scatter"]
    angle_error: float | None
    class_values: ClassValues
    points: tuple[Point, ...]
    checks: tuple[Check, ...]
    tracks: tuple[FittedTrack, ...] = ()
    notes: tuple[str, ...] = ()
    speed_error: float | None = None

    @property
    def speed_unit(self) -> str:
        """The unit of speeds: that of the columns, or of positions and times."""
        units = self.table.units
        if self.kind == "tracks":
            return f"{units.get('x', 'm')}/s"
        return next((units[name] for name in ("u", "u_A", "u_A_x") if name in units), "m/s")

    def check(self, pattern: str) -> Check:
        """The check of a pattern by its id. Raises KeyError where there is none of it."""
        for check in self.checks:
            if check.id == pattern:
                return check
        raise KeyError(pattern)

    def data(self) -> dict[str, Any]:
        """The result as JSON knows it; what is infinite is null."""
        fields: dict[str, Any] = _plain(dataclasses.asdict(self))
        fields["interval"]["possible"] = _plain(self.interval.possible)
        fields["table"]["faults"] = [
            {**fault, "message": str(entry)}
            for fault, entry in zip(fields["table"]["faults"], self.table.faults)
        ]
        return fields

    def json(self) -> str:
        """`data` as one line."""
        return json.dumps(self.data(), ensure_ascii=False)


def _plain(value: object) -> Any:
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
