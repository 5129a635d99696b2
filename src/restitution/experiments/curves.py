"""How far readings are from a law y = f(x, e), where both x and y have errors.

The law of a wall is a curve in the plane of the angles, β = arctan(e tan α). Errors of a
protractor are the same at every angle, so distances are measured there, and not in the plane of
the tangents: there the same error of 1° is 0.02 at 30° and 0.6 at 80°, and its distribution is
skew. To first order the two distances are the same. The law of two spheres is a straight line, on
which speed of separation = e × speed of approach.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from restitution.records import dataclass

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Readings:
    """Two quantities as arrays of shape (n,), with the covariances of their errors."""

    x: Array
    y: Array
    x_variance: Array
    y_variance: Array
    covariance: Array

    def __len__(self) -> int:
        return len(self.x)

    def scaled(self, factor: float) -> Readings:
        """The same readings with all errors multiplied by a factor."""
        square = factor**2
        errors = (self.x_variance, self.y_variance, self.covariance)
        return Readings(self.x, self.y, *(error * square for error in errors))


@dataclass(frozen=True)
class Law:
    """y as a function of x and e, and dy/dx; both take arrays."""

    value: Callable[[Array, Array | float], Array]
    slope: Callable[[Array, Array | float], Array]


def reflected(alpha: Array, e: Array | float) -> Array:
    """The angle β of the law, arctan(e tan α), in radians; it goes on beyond 90°."""
    result: Array = np.arctan2(e * np.sin(alpha), np.cos(alpha))
    return result


def _bend(alpha: Array, e: Array | float) -> Array:
    result: Array = e / (np.cos(alpha) ** 2 + (e * np.sin(alpha)) ** 2)
    return result


def _constant(x: Array, e: Array | float) -> Array:
    return e + np.zeros_like(x)


WALL = Law(reflected, _bend)
SPHERES = Law(lambda x, e: e * x, _constant)


def nearest(readings: Readings, law: Law, e: Array | float) -> Array:
    """The x of the point of the curve that is nearest to each reading, in standard errors.

    ``e`` is a number, or of shape (k, 1) for the law at k values; then the result is (k, n). By
    the method of Gauss and Newton, from the reading itself, in steps that are halved while they
    lead away.
    """
    shape = np.broadcast_shapes(np.shape(e), readings.x.shape)
    parts = (readings.x, readings.y, *_weights(readings), np.asarray(e, dtype=np.float64))
    rows = np.stack([np.broadcast_to(part, shape).ravel() for part in parts])
    x = rows[0].copy()
    here = _distances(rows, law, x)
    active = np.arange(x.size)  # those that are not there yet
    for _ in range(_STEPS):
        some = rows[:, active]
        step, there, worse = _step(some, law, x[active], here[active])
        ahead = active[~worse]
        x[ahead] += step[~worse]
        here[ahead] = there[~worse]
        active = ahead[np.abs(step[~worse]) > _NEAR * (1 + np.abs(x[ahead]))]
        if not active.size:
            break
    result: Array = x.reshape(shape)
    return result


def _step(rows: Array, law: Law, x: Array, here: Array) -> tuple[Array, Array, NDArray[np.bool_]]:
    """The steps of Gauss and Newton, the squared distances after them, and which lead away."""
    x0, y0, xx, xy, yy, e = rows
    bend = law.slope(x, e)
    dx, dy = x0 - x, y0 - law.value(x, e)
    gradient = (xx + xy * bend) * dx + (xy + yy * bend) * dy
    step = gradient / (xx + 2 * xy * bend + yy * bend**2)
    there = _distances(rows, law, x + step)
    worse = there > here * (1 + _ROUNDING)
    for _ in range(_HALVINGS):
        if not worse.any():
            break
        step[worse] /= 2
        there[worse] = _distances(rows[:, worse], law, (x + step)[worse])
        worse = there > here * (1 + _ROUNDING)
    return step, there, worse


def _distances(rows: Array, law: Law, x: Array) -> Array:
    x0, y0, xx, xy, yy, e = rows
    dx, dy = x0 - x, y0 - law.value(x, e)
    result: Array = xx * dx**2 + 2 * xy * dx * dy + yy * dy**2
    return result


_STEPS, _HALVINGS = 30, 8
_NEAR = 1e-8  # the square of it is what the distance misses
_ROUNDING = 1e-13


def squared_distance(readings: Readings, law: Law, x: Array, e: Array | float) -> Array:
    """The squared distance of each reading from the point of the curve at ``x``."""
    xx, xy, yy = _weights(readings)
    dx, dy = readings.x - x, readings.y - law.value(x, e)
    result: Array = xx * dx**2 + 2 * xy * dx * dy + yy * dy**2
    return result


def sum_of_squares(readings: Readings, law: Law, e: Array | float) -> Array:
    """The sum over the readings of their squared distances from the law; (k,) for e of (k, 1).

    It is −2 log likelihood of normal errors, up to a constant, with the true x of every reading at
    its likeliest.
    """
    x = nearest(readings, law, e)
    result: Array = squared_distance(readings, law, x, e).sum(axis=-1)
    return result


def _weights(readings: Readings) -> tuple[Array, Array, Array]:
    """The inverse of the covariance of each reading: xx, xy, yy."""
    a, b, c = readings.x_variance, readings.y_variance, readings.covariance
    determinant = a * b - c**2
    return b / determinant, -c / determinant, a / determinant
