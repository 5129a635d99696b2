"""How often intervals hold e, and how often patterns are seen, in experiments that are made up.

The nightly tests are of the size of the figures in docs/experiment.md; a sample of them, with a
fixed seed, runs each time. The bounds of a sample are those that hold 99.9% of samples of what the
documentation says.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
import scipy
from experiments import (
    ANGLE_ERRORS,
    COEFFICIENTS,
    SPEED_ERRORS,
    SPHERE_PATTERNS,
    WALL_PATTERNS,
    coverage_of_spheres,
    coverage_of_walls,
    holds,
    seen,
    sphere_columns,
    wall_columns,
)

import restitution as r
from restitution.experiments.curves import WALL, Readings

GIVEN = {"wall": {"angle_error": 1.0}, "spheres": {"speed_error": 0.02, "angle_error": 0.5}}


def bounds(low: float, high: float, trials: int) -> tuple[float, float]:
    """What shares of so many trials may be, if the probability is from low to high."""
    ends = scipy.stats.binom.ppf(0.0005, trials, low), scipy.stats.binom.ppf(0.9995, trials, high)
    return ends[0] / trials, ends[1] / trials


@pytest.mark.parametrize("known", [True, False])
def test_shares_are_those_of_intervals(known):
    """What is counted below is whether e lies between the ends that `experiment` gives."""
    rng = np.random.default_rng(0)
    columns = [wall_columns(rng, 0.7, speeds=False) for _ in range(40)]
    alpha, beta = (np.radians([each[name] for each in columns]) for name in ("alpha", "beta"))
    variance = np.full_like(alpha, math.radians(1) ** 2)
    inside = holds(Readings(alpha, beta, variance, variance, 0 * variance), WALL, 0.7, known=known)
    for each, expected in zip(columns, inside):
        interval = r.experiment(each, angle_error=1 if known else None).interval
        assert (interval.low <= 0.7 <= interval.high) == expected


@pytest.mark.parametrize(("e", "error"), [(0.1, 1.0), (0.7, 1.0), (1.0, 3.0)])
@pytest.mark.parametrize("known", [True, False])
def test_interval_of_a_wall_holds_e(e, error, known):
    low, high = bounds(0.93, 0.97, 400)
    assert low <= coverage_of_walls(e, error, known=known, trials=400, seed=1) <= high


@pytest.mark.parametrize("line", [True, False])
@pytest.mark.parametrize("known", [True, False])
def test_interval_of_spheres_holds_e(known, line):
    low, high = bounds(0.93, 0.97, 100)
    share = coverage_of_spheres(0.7, 0.02, known=known, line=line, trials=100, seed=1)
    assert low <= share <= high


# --- every night --------------------------------------------------------------------------------


@pytest.mark.nightly
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("e", COEFFICIENTS)
@pytest.mark.parametrize("error", ANGLE_ERRORS)
@pytest.mark.parametrize("known", [True, False])
def test_intervals_of_a_wall_hold_e(e, error, known):
    low, high = (0.93, 0.97)
    assert low <= coverage_of_walls(e, error, known=known, trials=2000, seed=7) <= high


@pytest.mark.nightly
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("e", COEFFICIENTS)
@pytest.mark.parametrize("error", SPEED_ERRORS)
@pytest.mark.parametrize("known", [True, False])
@pytest.mark.parametrize("line", [True, False])
def test_intervals_of_spheres_hold_e(e, error, known, line):
    low, high = (0.93, 0.97)
    share = coverage_of_spheres(e, error, known=known, line=line, trials=2000, seed=8)
    assert low <= share <= high


@pytest.mark.nightly
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("pattern", WALL_PATTERNS)
def test_patterns_of_a_wall_are_seen(pattern):
    change = WALL_PATTERNS[pattern]
    counts = seen(
        lambda rng: wall_columns(rng, between=(15, 75), **change),
        GIVEN["wall"],
        trials=500,
        seed=9,
    )
    assert counts[pattern] >= 0.8 * 500


@pytest.mark.nightly
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("pattern", SPHERE_PATTERNS)
def test_patterns_of_spheres_are_seen(pattern):
    change = SPHERE_PATTERNS[pattern]
    counts = seen(lambda rng: sphere_columns(rng, **change), GIVEN["spheres"], trials=500, seed=10)
    assert counts[pattern] >= 0.8 * 500


@pytest.mark.nightly
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("known", [True, False])
@pytest.mark.parametrize("e", [0.2, 0.7, 1.0])
def test_patterns_are_not_seen_where_there_are_none(e, known):
    high = bounds(0, 0.05, 1000)[1] * 1000
    walls = seen(
        lambda rng: wall_columns(rng, e, between=(15, 75)),
        GIVEN["wall"] if known else {},
        trials=1000,
        seed=11,
    )
    assert walls["any"] <= high
    for line in (False, True):
        spheres = seen(
            lambda rng: sphere_columns(rng, e, line=line),  # noqa: B023
            GIVEN["spheres"] if known else {},
            trials=1000,
            seed=12,
        )
        assert spheres["any"] <= high
