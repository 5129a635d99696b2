"""A wall: readings of angles → sample, points, what a class computes, and the patterns."""

from __future__ import annotations

import math
import statistics
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from restitution.experiments import common
from restitution.experiments.common import STRICT, Reasons, above_one, place_of, scatter, speed
from restitution.experiments.curves import WALL, Array, Readings, reflected
from restitution.experiments.distributions import upper_tail
from restitution.experiments.fitting import Fit
from restitution.experiments.numbers import percent, probability, with_error
from restitution.experiments.patterns import Pattern, Untested
from restitution.experiments.records import Measured, WallReading
from restitution.experiments.results import ClassValues, Point
from restitution.experiments.samples import Sample
from restitution.records import dataclass


@dataclass(frozen=True)
class Wall:
    """The readings of a wall and their sample, with notes on what was assumed.

    ``wall_known`` is False where the direction of the wall was estimated from the velocities, as
    if nothing changed along it.
    """

    readings: tuple[WallReading, ...]
    sample: Sample
    unit: str = "m/s"
    wall_known: bool = True
    notes: tuple[str, ...] = ()


def wall_of(readings: tuple[WallReading, ...], unit: str) -> Wall:
    """The sample of readings: with their errors, or with 1° each where none has any."""
    errors, notes = _errors(readings)
    known = errors is not None
    pairs = errors or [(1.0, 1.0)] * len(readings)
    return Wall(readings, sample_of(readings, pairs, known=known), unit, notes=notes)


def sample_of(
    readings: tuple[WallReading, ...],
    errors: list[tuple[float, float]],
    *,
    known: bool,
    freedom: int | None = None,
) -> Sample:
    """The sample of readings in degrees, with errors of α and β in degrees."""
    alpha, beta = np.radians([[reading.alpha.value, reading.beta.value] for reading in readings]).T
    variances = np.radians(np.array(errors)).T ** 2
    covariance = np.array([reading.covariance for reading in readings]) * math.radians(1) ** 2
    arrays = Readings(alpha, beta, variances[0], variances[1], covariance)
    return Sample(arrays, WALL, known, freedom)


def _errors(
    readings: tuple[WallReading, ...],
) -> tuple[list[tuple[float, float]] | None, tuple[str, ...]]:
    """The errors of α and β; where some are missing, what stands in for them."""
    given = [
        error
        for reading in readings
        for error in (reading.alpha.error, reading.beta.error)
        if error
    ]
    if not given:
        return None, ()
    middle = statistics.median(given)
    pairs, shared, missing = [], 0, 0
    for reading in readings:
        alpha, beta = reading.alpha.error, reading.beta.error
        shared += (alpha is None) != (beta is None)
        missing += alpha is None and beta is None
        pairs.append((alpha or beta or middle, beta or alpha or middle))
    notes = []
    if shared:
        notes.append("where only one of α and β has an error, the other is taken to have the same")
    if missing:
        notes.append(
            f"rows without errors ({missing}) are taken to have {middle:.3g}°, the middle one"
        )
    return pairs, tuple(notes)


# --- points, and what a class computes --------------------------------------------------------


def points(wall: Wall) -> tuple[Point, ...]:
    """The readings in the picture of tan β against tan α."""
    sample = wall.sample
    arrays = sample.readings.scaled(sample.factor)
    rows = zip(
        wall.readings,
        arrays.x,
        arrays.y,
        np.sqrt(arrays.x_variance),
        np.sqrt(arrays.y_variance),
        sample.x_fitted,
        sample.residuals,
    )
    return tuple(
        Point(
            line=reading.line,
            x=math.tan(alpha),
            y=math.tan(beta),
            x_error=float(alpha_error / math.cos(alpha) ** 2),
            y_error=float(beta_error / math.cos(beta) ** 2),
            x_fitted=math.tan(x),
            y_fitted=sample.e * math.tan(x),
            residual=float(residual),
            alpha=reading.alpha.value,
            beta=reading.beta.value,
            alpha_error=math.degrees(alpha_error),
            beta_error=math.degrees(beta_error),
            speed=reading.u.value if reading.u else None,
            label=reading.label,
        )
        for reading, alpha, beta, alpha_error, beta_error, x, residual in rows
    )


_STEEP = math.radians(89.5)


def class_values(wall: Wall) -> ClassValues:
    """The mean of tan β/tan α, the slope of the line through the origin, and why they differ."""
    arrays = wall.sample.readings.scaled(wall.sample.factor)
    usable = (arrays.x < _STEEP) & (arrays.y < _STEEP)
    if not usable.any():
        return ClassValues(math.nan, None, math.nan, "All angles are nearly 90°.")
    alpha, beta = arrays.x[usable], arrays.y[usable]
    x, y = np.tan(alpha), np.tan(beta)
    errors = np.hypot(
        np.sqrt(arrays.y_variance[usable]) / np.cos(beta) ** 2 / x,
        y / x * np.sqrt(arrays.x_variance[usable]) / (np.sin(alpha) * np.cos(alpha)),
    )
    places = [_degrees(angle) for angle in alpha]
    return common.class_values(wall.sample, x, y, errors, places, _REASONS)


_REASONS = Reasons(
    alone="With one reading all of these are the same number.",
    mean=(
        "The mean lets every ratio count the same, though the ratio at {worst} is known to "
        "±{worst_error:.2g} and that at {best} to ±{best_error:.2g}."
    ),
    line=(
        "The line leans on the steepest impact: the one at {top} alone has {share} of its weight, "
        "and there a small error of the angle is a large one of the tangent."
    ),
    fit="The fit lets each reading count by its own error, in α as well as in β.",
)


def _degrees(angle: float) -> str:
    return f"α = {math.degrees(angle):.3g}°"


# --- patterns ---------------------------------------------------------------------------------


def patterns(wall: Wall) -> list[Pattern | Untested]:
    """The patterns of a wall."""
    sample = wall.sample
    places = tuple(place_of(reading) for reading in wall.readings)
    turned = _turned(wall, sample)
    trend, trend_fit = _trend(wall, sample, turned)
    spread = scatter(sample, [fit for fit in (trend_fit, turned) if fit], places, "readings")
    if isinstance(spread, Pattern) and spread.p_value < STRICT:
        # The errors given are too small, so they are no measure for the other patterns.
        sample = sample.with_scatter()
        turned = _turned(wall, sample)
        trend, _ = _trend(wall, sample, turned)
    return [
        above_one(sample, wall.sample, places, "β is larger than α", _COLUMNS),
        trend,
        _offset(wall, sample, turned),
        _friction(wall, _turn_of(sample, turned)),
        spread,
    ]


def _turn_of(sample: Sample, turned: Fit | None) -> Measured:
    """By how much the line of reference is seen to be turned, in radians; exactly 0 if it is not.

    Friction and e with speed are tested with the angles put right by it, so that a line that is
    turned is not seen as these too.
    """
    if turned is None or sample.p_value(turned) >= STRICT:
        return Measured(0.0, 0.0)
    return Measured(turned.parameters[1], sample.error_of(turned, 1))


def _trend(wall: Wall, sample: Sample, turned: Fit | None) -> tuple[Pattern | Untested, Fit | None]:
    turn = _turn_of(sample, turned).value
    arrays = sample.readings
    right = replace(sample, readings=replace(arrays, x=arrays.x - turn, y=arrays.y + turn))
    return speed(right, _speeds(wall), wall.unit, _NO_SPEEDS)


_COLUMNS = "Look for angles in the wrong columns, or measured from the normal."
_NO_SPEEDS = "Untested: no column u has the speed before each impact."


def _speeds(wall: Wall) -> Array | None:
    if any(reading.u is None for reading in wall.readings):
        return None
    return np.array([reading.u.value for reading in wall.readings if reading.u])


def _turned(wall: Wall, sample: Sample) -> Fit | None:
    """The fit with angles measured from a line that is turned by p[1] against the wall.

    Then α is read larger by that angle, and β on the other side smaller.
    """
    if not wall.wall_known or np.ptp(sample.readings.x) < math.radians(5):
        return None
    return sample.wider(lambda x, p: reflected(x - p[1], p[0]) - p[1], 1)


def _offset(wall: Wall, sample: Sample, turned: Fit | None) -> Pattern | Untested:
    if not wall.wall_known:
        reason = "Untested: the direction of the wall was not measured; give it as wall."
        return Untested("offset", reason)
    if turned is None:
        reason = "Untested: it takes three angles α or more, spread over 5° or more."
        return Untested("offset", reason)
    p = sample.p_value(turned)
    angle = math.degrees(turned.parameters[1])
    error = math.degrees(sample.error_of(turned, 1))
    size = with_error(abs(angle), error, "°")
    sizes = ("large", "small") if angle > 0 else ("small", "large")
    seen = (
        f"The line misses the origin. The readings fit if the line from which the angles were "
        f"measured is turned by {size} against the wall ({probability(p)}), so that α is read "
        f"too {sizes[0]} and β too {sizes[1]}. With that put right e is "
        f"{with_error(turned.parameters[0], sample.error_of(turned, 0))}."
    )
    not_seen = (
        f"The line goes through the origin: a turn of the line from which angles were measured "
        f"comes out as {with_error(angle, error, '°')} ({probability(p)})."
    )
    statistic = angle / error if error else 0.0
    return Pattern("offset", statistic, p, seen, not_seen, angle, error, "degrees")


_TOO_STEEP = math.radians(85)


def _friction(wall: Wall, turn: Measured) -> Pattern | Untested:
    """The test of v cos β against u cos α, by the mean of the logarithm of their quotient.

    The angles are put right by a ``turn`` of the line of reference, in radians.
    """
    if not wall.wall_known:
        reason = "Untested: the wall was taken along what does not change; give it as wall."
        return Untested("friction", reason)
    if any(reading.u is None or reading.v is None for reading in wall.readings):
        reason = "Untested: it takes the speeds before and after, columns u and v."
        return Untested("friction", reason)
    arrays = wall.sample.readings
    steep = (arrays.x > _TOO_STEEP) | (arrays.y > _TOO_STEEP)
    logs, variances = _losses(wall, ~steep, turn.value)
    if len(logs) < (3 if variances is None else 1):
        reason = "Untested: it takes three readings or more below 85°, or errors of all of them."
        return Untested("friction", reason)
    slope = float((np.tan(arrays.x) + np.tan(arrays.y))[~steep].mean())
    mean, error, p = mean_test(logs, variances, slope * (turn.error or 0.0))
    kept = math.exp(mean)
    size = f"{percent(abs(1 - kept))} ± {percent(kept * error)}"
    comparison = "less" if kept < 1 else "more"
    seen = (
        f"The component along the wall changes: v cos β is {size} {comparison} than u cos α "
        f"({probability(p)}), though a smooth wall leaves it as it is. Then tan β / tan α is not "
        f"e{_by_components(wall, math.degrees(turn.value))}."
    )
    not_seen = (
        f"The component along the wall stays: v cos β and u cos α differ by {size} "
        f"({probability(p)})."
    )
    statistic = mean / error if error else 0.0
    return Pattern("friction", statistic, p, seen, not_seen, kept - 1, kept * error)


def _by_components(wall: Wall, turn: float) -> str:
    """The value of e from the speeds at right angles to the wall, turned by degrees."""
    ratios = [
        reading.v.value * math.sin(math.radians(reading.beta.value + turn))
        / (reading.u.value * math.sin(math.radians(reading.alpha.value - turn)))
        for reading in wall.readings
        if reading.u and reading.v
    ]  # fmt: skip
    mean = statistics.fmean(ratios)
    error = statistics.stdev(ratios) / math.sqrt(len(ratios)) if len(ratios) > 1 else None
    return f"; v sin β / u sin α gives {with_error(mean, error)}"


def _losses(wall: Wall, usable: NDArray[np.bool_], turn: float) -> tuple[Array, Array | None]:
    """ln(v cos β / u cos α), with variances where all errors are known."""
    arrays = wall.sample.readings
    u = np.array([_pair(reading.u) for reading in wall.readings])[usable]
    v = np.array([_pair(reading.v) for reading in wall.readings])[usable]
    alpha, beta = arrays.x[usable] - turn, arrays.y[usable] + turn
    logs = np.log(v[:, 0] * np.cos(beta)) - np.log(u[:, 0] * np.cos(alpha))
    ta, tb = np.tan(alpha), np.tan(beta)
    variances = (
        (u[:, 1] / u[:, 0]) ** 2
        + (v[:, 1] / v[:, 0]) ** 2
        + ta**2 * arrays.x_variance[usable]
        + tb**2 * arrays.y_variance[usable]
        - 2 * ta * tb * arrays.covariance[usable]
    )
    known = wall.sample.known and bool(np.all(np.isfinite(variances)))
    return logs, variances if known else None


def _pair(measured: Measured | None) -> tuple[float, float]:
    if measured is None:
        return math.nan, math.nan
    return measured.value, math.nan if measured.error is None else measured.error


def mean_test(values: Array, variances: Array | None, shared: float) -> tuple[float, float, float]:
    """The mean of values that should be 0, its standard error, and its two-sided p-value.

    Weighted by the variances where these are known; else with the error of the scatter. An error
    that all values share is added.
    """
    if variances is not None:
        weights = 1 / variances
        mean = float((weights * values).sum() / weights.sum())
        error = math.hypot(float(weights.sum()) ** -0.5, shared)
        return mean, error, 2 * upper_tail(abs(mean) / error, None)
    own = float(values.std(ddof=1) / math.sqrt(len(values)))
    mean, error = float(values.mean()), math.hypot(own, shared)
    if error < 1e-12:
        return mean, error, 1.0 if abs(mean) < 1e-9 else 0.0
    return mean, error, 2 * upper_tail(abs(mean) / error, len(values) - 1)
