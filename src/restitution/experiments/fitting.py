"""Fits by orthogonal distance regression, and the interval of e by its profile.

odrpack finds the parameters (P. T. Boggs and J. E. Rogers, "Orthogonal distance regression",
Contemporary Mathematics 112, 1990). The interval is that of the profile likelihood: all e whose sum
of squares exceeds the least one by no more than a quantile, of χ² where the errors are given, and
of F where they are estimated from the same scatter.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from restitution.errors import MissingError
from restitution.experiments.curves import Array, Law, Readings, sum_of_squares
from restitution.experiments.distributions import limit_of_square
from restitution.experiments.needs import needed
from restitution.records import dataclass

Model = Callable[[Array, Array], Array]
"""y from x, an array of shape (n,), and from the parameters."""


@dataclass(frozen=True)
class Fit:
    """Parameters with their standard errors, for errors of the readings as they were given."""

    parameters: tuple[float, ...]
    errors: tuple[float, ...]
    sum_of_squares: float
    degrees_of_freedom: int

    @property
    def scatter(self) -> float:
        """The errors that the scatter shows, as a multiple of those that were given."""
        if self.degrees_of_freedom < 1:
            return float("nan")
        return float(np.sqrt(self.sum_of_squares / self.degrees_of_freedom))


def fitted(readings: Readings, model: Model, start: Array) -> Fit:
    """The parameters at which the model is nearest to the readings.

    Raises MissingError where the readings do not determine them, and UnsupportedError where odrpack
    is not installed.
    """
    odrpack = needed("odrpack", "a fit")
    # With x and y' = y − rx, r = covariance / variance of x, the errors are independent.
    r = readings.covariance / readings.x_variance
    unlike = readings.y_variance - r * readings.covariance
    done = odrpack.odr_fit(
        lambda x, p: model(x, p - _SHIFT) - r * x,
        readings.x,
        readings.y - r * readings.x,
        np.asarray(start, dtype=np.float64) + _SHIFT,
        weight_x=1 / readings.x_variance,
        weight_y=1 / unlike,
        diff_scheme="central",
        maxit=200,
    )
    if not (done.success and np.all(np.isfinite(done.beta))):
        raise MissingError("the fit has no end: the readings do not determine e")
    freedom = len(readings) - len(start)
    variance = np.diag(done.cov_beta)  # for errors as given: odrpack scales by the scatter apart
    return Fit(
        tuple(map(float, done.beta - _SHIFT)),
        tuple(map(float, np.sqrt(np.maximum(variance, 0)))),
        float(done.sum_square),
        freedom,
    )


_SHIFT = 2.0
"""odrpack takes its steps relative to a parameter, so none may be near 0 where it looks."""


def profile(
    readings: Readings, law: Law, fit: Fit, level: float, factor: float, freedom: int | None
) -> tuple[float, float]:
    """The ends of the interval of e; infinite where the readings set no bound.

    ``factor`` multiplies the errors of the readings, and ``freedom`` are the degrees of freedom
    with which they were estimated, None where they are known.
    """
    rise = limit_of_square(level, freedom) * factor**2
    best = fit.parameters[0]
    limit = float(sum_of_squares(readings, law, best)) + rise
    width = max(fit.errors[0] * np.sqrt(rise), 1e-9)
    return (
        _end(readings, law, best, -width, limit),
        _end(readings, law, best, width, limit),
    )


_FARTHEST = 1e3


def _end(readings: Readings, law: Law, best: float, step: float, limit: float) -> float:
    """Where the sum of squares reaches the limit, on the side of the step."""
    optimize = needed("scipy.optimize", "an interval")

    def excess(e: float) -> float:
        return float(sum_of_squares(readings, law, e)) - limit

    inner, outer = best, best + step
    while excess(outer) < 0:
        inner, step = outer, 2 * step
        outer += step
        if abs(outer) > _FARTHEST:
            return float(np.copysign(np.inf, step))
    return float(optimize.brentq(excess, inner, outer, xtol=1e-9, rtol=1e-9))
