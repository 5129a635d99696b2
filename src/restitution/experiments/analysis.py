"""Table → experiment: the fit of its kind, with all that stands beside it."""

from __future__ import annotations

import numpy as np

from restitution.errors import UnsupportedError
from restitution.experiments.curves import WALL, Array, Readings, nearest, squared_distance
from restitution.experiments.fitting import fitted, profile
from restitution.experiments.records import Table
from restitution.experiments.results import ClassValues, Experiment, Interval, Point


def analysed(table: Table, angle_error: float | None) -> Experiment:
    """The experiment of a table."""
    if table.kind != "wall":
        raise UnsupportedError(f"{table.kind}: not yet")
    alpha = np.radians([each.alpha.value for each in table.readings])
    beta = np.radians([each.beta.value for each in table.readings])
    one = np.full(len(alpha), np.radians(angle_error or 1) ** 2)
    readings = Readings(alpha, beta, one, one, 0 * one)
    fit = fitted(readings, lambda x, p: WALL.value(x, p[0]), np.array([0.5]))
    known = angle_error is not None
    low, high = profile(readings, WALL, fit, 0.95, known=known)
    factor = 1 if known else fit.scatter
    ratio = np.tan(beta) / np.tan(alpha)
    x, y = np.tan(alpha), np.tan(beta)
    values = ClassValues(
        float(ratio.mean()),
        float(ratio.std(ddof=1) / np.sqrt(len(ratio))),
        float((x * y).sum() / (x * x).sum()),
        "",
    )
    return Experiment(
        "wall",
        table,
        fit.parameters[0],
        fit.errors[0] * factor,
        Interval(low, high, 0.95, "profile likelihood"),
        "given" if known else "scatter",
        float(np.degrees(np.sqrt(one[0])) * factor),
        values,
        _points(table, readings, fit.parameters[0], factor),
        (),
    )


def _points(table: Table, readings: Readings, e: float, factor: float) -> tuple[Point, ...]:
    at: Array = nearest(readings, WALL, e)
    distance = np.sqrt(squared_distance(readings, WALL, at, e)) / factor
    above = np.where(readings.y > WALL.value(readings.x, e), distance, -distance)
    error = np.sqrt(readings.x_variance) * factor
    return tuple(
        Point(
            line=reading.line,
            x=float(np.tan(a)),
            y=float(np.tan(b)),
            x_error=float(s / np.cos(a) ** 2),
            y_error=float(s / np.cos(b) ** 2),
            x_fitted=float(np.tan(x)),
            y_fitted=float(e * np.tan(x)),
            residual=float(r),
            alpha=float(np.degrees(a)),
            beta=float(np.degrees(b)),
            alpha_error=float(np.degrees(s)),
            beta_error=float(np.degrees(s)),
        )
        for reading, a, b, s, x, r in zip(table.readings, readings.x, readings.y, error, at, above)
    )
