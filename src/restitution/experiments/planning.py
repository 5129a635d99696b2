r"""A plan of an experiment with a wall: at which angles, how often, and how well e is known then.

One reading at α, with independent errors σ of α and of β (in radians), gives e = tan β / tan α.
With tan β = e tan α,

    ∂e/∂β = sec²β / tan α = (cos²α + e² sin²α) / (sin α cos α),
    ∂e/∂α = −tan β sec²α / tan²α = −e / (sin α cos α),

so that by the propagation of errors (JCGM 100:2008, section 5.1)

    Var e = σ² (e² + (cos²α + e² sin²α)²) / (sin²α cos²α)
          = σ² ((1 + e²)/t + 4e² + e² (1 + e²) t),   t = tan²α.

It is least at t = 1/e, that is tan α tan β = 1: where the ball leaves at right angles to the way on
which it came, α + β = 90°. There the standard error of e is σ (1 + e) √(2e). Readings of a fit
with errors in both angles count by 1/Var e, so that their sum is 1/Var of the fit, to first order.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterator

import numpy as np

from restitution.errors import StatementError
from restitution.experiments.curves import WALL, Array, Readings, nearest, sum_of_squares
from restitution.experiments.patterns import FAMILY
from restitution.experiments.plans import Design
from restitution.experiments.samples import LEVEL
from restitution.experiments.whole import Plan

MAX_TRIALS = 200
MAX_ERROR = 20.0
"""Of an angle, in degrees."""
TARGETS = (0.05, 0.02, 0.01)
"""Half widths of the interval for which trials are counted."""
LOWEST, HIGHEST = 15, 75
"""Angles at which a ball can be sent at a wall, and its path be measured, in degrees."""

_NARROW = 10  # degrees to both sides of the best angle, of a narrow design
_STEP = 5  # between the angles that designs are tried at, in degrees
_POWER = 0.8  # of the experiments in which a pattern that is told is to be seen
_TESTS = 3  # patterns that angles with known errors are tested for: above 1, offset, scatter
_MOST, _FEWEST, _READINGS = 400, 50, 4000  # experiments to simulate, and readings in all


def planned(e: float, angle_error: float, trials: int, seed: int) -> Plan:
    """The plan that `restitution.experiment_plan` gives; it raises as that does."""
    _require(e, angle_error, trials, seed)
    sigma = math.radians(angle_error)
    chosen = list(_designs(e, trials))
    count = max(_FEWEST, min(_MOST, _READINGS // trials))
    rng = np.random.default_rng(seed)
    designs = tuple(
        _judged(name, title, angles, e, sigma, count, rng) for name, title, angles in chosen
    )
    recommended = "even" if any(design.id == "even" for design in designs) else "best"
    plan = Plan(e, angle_error, trials, seed, count, best_angle(e), designs, recommended, ())
    return dataclasses.replace(plan, trials_for=_trials_for(plan.design(recommended)))


def _require(e: float, angle_error: float, trials: int, seed: int) -> None:
    if not 0 <= e <= 1:
        raise StatementError(f"e is {e:g}: a coefficient of restitution lies from 0 to 1")
    if not 0 < angle_error <= MAX_ERROR:
        raise StatementError(
            f"the error of an angle is {angle_error:g}°: it is above 0° and at most {MAX_ERROR:g}°"
        )
    _require_whole("trials", trials, 1, MAX_TRIALS)
    _require_whole("seed", seed, 0, None)


def _require_whole(name: str, value: object, least: int, most: int | None) -> None:
    if not isinstance(value, int) or isinstance(value, bool):
        raise StatementError(f"{name} is {value!r}: it is a whole number")
    if value < least or (most is not None and value > most):
        upto = "" if most is None else f" and at most {most}"
        raise StatementError(f"{name} is {value}: it is at least {least}{upto}")


# --- theory -----------------------------------------------------------------------------------


def reading_error(e: float, alpha: Array | float, sigma: float) -> Array:
    """The standard error of e from one reading at α, in radians as ``sigma`` is.

    By propagation of the errors of both angles; the formula is derived at the top of this module.
    """
    sine, cosine = np.sin(alpha), np.cos(alpha)
    result: Array = sigma * np.hypot(e, cosine**2 + (e * sine) ** 2) / (sine * cosine)
    return result


def best_angle(e: float) -> float:
    """The α in degrees at which one reading tells most of e, between LOWEST and HIGHEST.

    That is where tan²α = 1/e.
    """
    angle = math.degrees(math.atan2(1, math.sqrt(e)))
    return min(max(angle, float(LOWEST)), float(HIGHEST))


def _fit_error(e: float, angles: Array, sigma: float) -> float:
    """The standard error of e from readings at these angles, in radians."""
    return float((reading_error(e, angles, sigma) ** -2).sum() ** -0.5)


def _turn_error(e: float, angles: Array, sigma: float) -> float | None:
    """The standard error of the turn that is fitted beside e, in radians; None if it cannot be.

    It is the second parameter p of β = f(α − p, e) − p, as the check of the model has it; the
    matrix of information is that of both, with errors of α carried over to β by ∂f/∂α.
    """
    if len(angles) < 3 or np.ptp(angles) < math.radians(5):
        return None
    bend = WALL.slope(angles, e)
    by_e = _by_e(angles, e)
    by_turn = -bend - 1
    weights = 1 / (sigma**2 * (1 + bend**2))
    ee, et, tt = (
        (weights * a * b).sum() for a, b in ((by_e, by_e), (by_e, by_turn), (by_turn, by_turn))
    )
    determinant = ee * tt - et**2
    return float(np.sqrt(ee / determinant)) if determinant > 1e-12 * ee * tt else None


def _by_e(alpha: Array, e: Array | float) -> Array:
    """∂β/∂e of the law β = arctan(e tan α)."""
    result: Array = np.sin(alpha) * np.cos(alpha) / (np.cos(alpha) ** 2 + (e * np.sin(alpha)) ** 2)
    return result


def _trials_for(design: Design) -> tuple[tuple[float, int], ...]:
    """The trials for each half width, as errors fall with the square root of their number."""
    one = design.half_width * math.sqrt(len(design.angles))
    return tuple((target, max(1, math.ceil((one / target) ** 2))) for target in TARGETS)


# --- designs ----------------------------------------------------------------------------------


def _designs(e: float, trials: int) -> Iterator[tuple[str, str, Array]]:
    """Ids, titles and angles in degrees of the designs that are compared."""
    best = round(best_angle(e))
    yield "best", f"all at {best}°", np.full(trials, float(best))
    if trials >= 3:
        low, high = _spread(e, trials, even_angles)
        yield "even", f"evenly from {low}° to {high}°", even_angles(low, high, trials)
    if trials >= 4:
        low, high = _spread(e, trials, _clusters)
        yield "clusters", f"half at {low}°, half at {high}°", _clusters(low, high, trials)
    if trials >= 2:
        low, high = max(best - _NARROW, LOWEST), min(best + _NARROW, HIGHEST)
        for name, ends in (("narrow", (low, high)), ("steep", (HIGHEST - 15, HIGHEST))):
            yield name, f"evenly from {ends[0]}° to {ends[1]}°", even_angles(*ends, trials)


def even_angles(low: int, high: int, trials: int) -> Array:
    """Angles evenly from one to the other, in whole degrees."""
    return np.round(np.linspace(low, high, trials))


def _clusters(low: int, high: int, trials: int) -> Array:
    return np.where(np.arange(trials) < trials / 2, float(low), float(high))


def _spread(e: float, trials: int, angles_of: Callable[[int, int, int], Array]) -> tuple[int, int]:
    """The ends between which angles tell most of e and of the turn together.

    The design is D-optimal: the product of the standard error of e and that of the turn beside it,
    to which the area of their common region of confidence is proportional, is least.
    """

    def area(ends: tuple[int, int]) -> float:
        angles = np.radians(angles_of(*ends, trials))
        turn = _turn_error(e, angles, 1.0)
        return math.inf if turn is None else turn * _fit_error(e, angles, 1.0)

    between = range(LOWEST, HIGHEST + 1, _STEP)
    return min(((low, high) for low in between for high in between if low < high), key=area)


def _judged(
    name: str,
    title: str,
    degrees: Array,
    e: float,
    sigma: float,
    count: int,
    rng: np.random.Generator,
) -> Design:
    angles = np.radians(degrees)
    fits, lows, highs = simulated(e, angles, sigma, count, rng)
    turn = _turn_error(e, angles, sigma)
    return Design(
        name,
        title,
        tuple(map(float, degrees)),
        _fit_error(e, angles, sigma),
        float(fits.std(ddof=1)),
        float((highs - lows).mean() / 2),
        None if turn is None else math.degrees(_seen(turn)),
    )


def _seen(error: float) -> float:
    """The size of a pattern that is seen in _POWER of the experiments, from its standard error.

    The check compares the smallest of _TESTS p-values with FAMILY/_TESTS, on both sides.
    """
    from statistics import NormalDist

    normal = NormalDist()
    return error * (normal.inv_cdf(1 - FAMILY / _TESTS / 2) + normal.inv_cdf(_POWER))


# --- simulation -------------------------------------------------------------------------------


def simulated(
    e: float, angles: Array, sigma: float, count: int, rng: np.random.Generator
) -> tuple[Array, Array, Array]:
    """The fitted e and the ends of its interval in simulated experiments, each of shape (count,).

    ``angles`` are the true α in radians, of shape (n,). The fit is that of `experiment`: the e at
    which the sum of squared orthogonal distances is least, and all e at which it is larger by no
    more than the quantile of χ². All experiments are fitted at once.
    """
    shape = count, len(angles)
    variance = np.full(shape, sigma**2)
    readings = Readings(
        angles + rng.normal(0, sigma, shape),
        WALL.value(angles, e) + rng.normal(0, sigma, shape),
        variance,
        variance,
        np.zeros(shape),
    )
    scale = _fit_error(e, angles, sigma)
    fits, least = _minimum(readings, np.full(count, e), scale)
    limit = least + _quantile()
    ends = [_end(readings, fits, side * scale, limit) for side in (-1, 1)]
    return fits, ends[0], ends[1]


def _quantile() -> float:
    """The quantile of χ² with 1 degree of freedom, at LEVEL: the square of a normal deviate's."""
    from statistics import NormalDist

    return NormalDist().inv_cdf((1 + LEVEL) / 2) ** 2


def _minimum(readings: Readings, start: Array, scale: float) -> tuple[Array, Array]:
    """Where the sum of squares is least in each experiment, by the method of Gauss and Newton."""
    e = start
    for _ in range(_ROUNDS):
        column = e[:, np.newaxis]
        x = nearest(readings, WALL, column)
        by_e = _by_e(x, column)
        residual = readings.y - WALL.value(x, column)
        weight = 1 / (1 + WALL.slope(x, column) ** 2)
        move = (residual * by_e).sum(axis=1) / (weight * by_e**2).sum(axis=1)
        move = np.clip(move, -3 * scale, 3 * scale)
        e = e + move
        if np.all(np.abs(move) < _NEAR * scale):
            break
    return e, _squares(readings, e)


def _squares(readings: Readings, e: Array) -> Array:
    return sum_of_squares(readings, WALL, e[:, np.newaxis])


_ROUNDS = 15
_NEAR = 1e-4  # of the standard error of e


def _end(readings: Readings, fits: Array, step: float, limit: Array) -> Array:
    """Where the sum of squares reaches the limit, on the side of the step, by the secant.

    The root of the excess above the minimum is nearly straight in e.
    """
    least = limit - _quantile()
    wanted = math.sqrt(_quantile())
    inner, outer = np.zeros_like(fits), np.full_like(fits, wanted * step)
    inner_root = np.zeros_like(fits)
    for _ in range(_ROUNDS):
        root = np.sqrt(np.maximum(_squares(readings, fits + outer) - least, 0.0))
        rise = root - inner_root
        share = np.where(np.abs(rise) > 1e-12, (wanted - root) / np.where(rise == 0, 1, rise), 0.0)
        change = np.clip(share * (outer - inner), -2 * abs(step), 2 * abs(step))
        inner, inner_root, outer = outer, root, outer + change
        if np.all(np.abs(change) < _NEAR * abs(step)):
            break
    return fits + outer
