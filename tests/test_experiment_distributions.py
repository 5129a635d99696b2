"""Tails and quantiles of an experiment's tests, against the distributions of SciPy."""

from __future__ import annotations

import numpy as np
import pytest
import scipy

from restitution.experiments.distributions import (
    limit_of_square,
    upper_tail,
    upper_tail_of_squares,
)

FREEDOMS = [None, 1, 2, 9, 40]


@pytest.mark.parametrize("freedom", FREEDOMS)
def test_tails_of_deviations(freedom) -> None:
    own = scipy.stats.norm if freedom is None else scipy.stats.t(freedom)
    deviations = np.array([-40.0, -2.5, 0.0, 0.3, 1.96, 5.0, 12.0])
    np.testing.assert_allclose(upper_tail(deviations, freedom), own.sf(deviations), rtol=1e-9)
    assert upper_tail(1.5, freedom) == pytest.approx(float(own.sf(1.5)))


@pytest.mark.parametrize("freedom", FREEDOMS)
@pytest.mark.parametrize("count", [1, 3, 20])
@pytest.mark.parametrize("total", [0.0, 0.01, 4.0, 90.0])
def test_tails_of_squares(freedom, count, total) -> None:
    true = (
        scipy.stats.chi2.sf(total, count)
        if freedom is None
        else scipy.stats.f.sf(total / count, count, freedom)
    )
    assert upper_tail_of_squares(total, count, freedom) == pytest.approx(float(true), rel=1e-9)


@pytest.mark.parametrize("freedom", FREEDOMS)
@pytest.mark.parametrize("level", [0.5, 0.683, 0.95, 0.999])
def test_a_square_exceeds_its_limit_as_seldom_as_it_is_said(freedom, level) -> None:
    limit = limit_of_square(level, freedom)
    assert upper_tail_of_squares(limit, 1, freedom) == pytest.approx(1 - level, rel=1e-6)
