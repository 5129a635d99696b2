"""Experiments with a wall: e, its interval, and the check of the model."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
import scipy
from experiments import wall_columns as measured

import restitution as r
from restitution.errors import MissingError, StatementError


@pytest.mark.parametrize("e", [0.0, 0.05, 0.3, 0.6, 1.0])
def test_exact_angles_give_e_exactly(e):
    alpha = np.linspace(15, 75, 8)
    beta = np.degrees(np.arctan(e * np.tan(np.radians(alpha))))
    result = r.experiment({"alpha": alpha, "beta": beta}, angle_error=1)
    assert result.e == pytest.approx(e, abs=1e-8)
    assert result.interval.low < e < result.interval.high


@pytest.mark.parametrize("e", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_fit_is_that_of_the_whole_likelihood(e, seed):
    """Independent: all true angles and e are sought at once by a general least squares."""
    data = measured(np.random.default_rng(seed), e, speeds=False)
    result = r.experiment({**data, "± alpha": np.full(10, 0.5)}, angle_error=2)
    alpha, beta = np.radians(data["alpha"]), np.radians(data["beta"])

    def residuals(unknown: np.ndarray) -> np.ndarray:
        model = np.arctan(unknown[0] * np.tan(unknown[1:]))
        return np.degrees(np.concatenate([(alpha - unknown[1:]) / 0.5, (beta - model) / 2]))

    found = scipy.optimize.least_squares(
        residuals, [0.5, *alpha], xtol=1e-14, ftol=1e-14, gtol=1e-14
    )
    assert result.e == pytest.approx(found.x[0], abs=1e-6)
    covariance = np.linalg.inv(found.jac.T @ found.jac)
    assert result.standard_error == pytest.approx(math.sqrt(covariance[0, 0]), rel=0.03)


def test_interval_is_where_the_likelihood_falls_by_half_a_quantile():
    data = measured(np.random.default_rng(4), speeds=False)
    result = r.experiment(data, angle_error=1)
    alpha, beta = data["alpha"], data["beta"]

    def deviance(e: float) -> float:
        """By a fine grid of the true angle of every reading."""
        grid = np.linspace(0.5, 89.5, 20_001)[:, np.newaxis]
        model = np.degrees(np.arctan(e * np.tan(np.radians(grid))))
        return float(((alpha - grid) ** 2 + (beta - model) ** 2).min(axis=0).sum())

    best = deviance(result.e)
    for end in (result.interval.low, result.interval.high):
        assert deviance(end) - best == pytest.approx(3.8415, abs=0.01)


def test_standard_error_is_the_spread_of_repeated_experiments():
    """Monte Carlo, with a fixed seed."""
    rng = np.random.default_rng(5)
    results = [r.experiment(measured(rng, speeds=False), angle_error=1) for _ in range(200)]
    spread = np.std([each.e for each in results], ddof=1)
    assert np.mean([each.standard_error for each in results]) == pytest.approx(spread, rel=0.15)


def test_scatter_stands_in_for_errors_that_are_not_given():
    rng = np.random.default_rng(6)
    result = r.experiment(measured(rng, n=200, error=1.5, speeds=False))
    assert result.error_source == "scatter"
    assert result.angle_error == pytest.approx(1.5, rel=0.15)


def test_class_values_by_hand():
    result = r.experiment("alpha,beta\n30,21\n45,34\n60,49\n", angle_error=1)
    x, y = (np.tan(np.radians(each)) for each in ([30, 45, 60], [21, 34, 49]))
    assert result.class_values.mean_ratio == pytest.approx(np.mean(y / x))
    assert result.class_values.slope == pytest.approx(np.polyfit(x, y, 1)[0], abs=0.02)
    assert "every ratio count the same" in result.class_values.why


def test_points_lie_on_the_fit():
    result = r.experiment(measured(np.random.default_rng(7)), angle_error=1)
    for point in result.points:
        assert point.y_fitted == pytest.approx(result.e * point.x_fitted)
        assert point.x == pytest.approx(math.tan(math.radians(point.alpha)))
        slope = (math.tan(math.radians(point.alpha + 0.01)) - point.x) / 0.01
        assert point.x_error == pytest.approx(slope, rel=0.01)


# --- the check of the model -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("pattern", "change"),
    [
        ("offset", {"turn": 5.0}),
        ("speed", {"fall": 0.1}),
        ("friction", {"kept": 0.9}),
        ("above-one", {"e": 1.1}),
        ("scatter", {"error": 3.0}),
    ],
)
def test_pattern_is_seen_in_data_made_with_it(pattern, change):
    """At least 80% of experiments, of ten readings from 15° to 75° with 1°."""
    rng = np.random.default_rng(8)
    seen = 0
    for _ in range(25):
        result = r.experiment(measured(rng, between=(15, 75), **change), angle_error=1)
        seen += result.check(pattern).verdict == "seen"
    assert seen >= 20


@pytest.mark.parametrize("angle_error", [1, None])
def test_nothing_is_seen_in_data_of_the_model(angle_error):
    rng = np.random.default_rng(9)
    false = 0
    for _ in range(60):
        result = r.experiment(measured(rng), angle_error=angle_error)
        false += any(check.verdict == "seen" for check in result.checks)
    assert false <= 6  # of 60 where 5% are expected, more has a probability of 4%


def test_pattern_without_its_columns_is_untested():
    result = r.experiment(measured(np.random.default_rng(10), speeds=False))
    verdicts = {check.id: check.verdict for check in result.checks}
    assert verdicts["speed"] == verdicts["friction"] == verdicts["scatter"] == "untested"
    assert verdicts["offset"] == verdicts["above-one"] == "not seen"
    assert "column u" in result.check("speed").sentence


def test_one_reading_above_one_is_seen_though_e_is_below():
    data = measured(np.random.default_rng(11), speeds=False)
    data["beta"][4] = data["alpha"][4] + 8
    check = r.experiment(data, angle_error=1).check("above-one")
    assert check.verdict == "seen"
    assert "line 6" in check.sentence


# --- near the ends, and what cannot be known --------------------------------------------------


def test_beyond_one_is_said():
    result = r.experiment("alpha,beta\n30,30.5\n45,45.4\n60,60.2\n", angle_error=1)
    assert result.e > 1
    assert result.interval.high > 1 > result.interval.low
    assert result.interval.possible == (result.interval.low, 1.0)
    assert any("above 1" in note for note in result.notes)


def test_exact_data_have_no_scatter():
    alpha = np.linspace(20, 70, 5)
    beta = np.degrees(np.arctan(0.5 * np.tan(np.radians(alpha))))
    result = r.experiment({"alpha": alpha, "beta": beta})
    assert result.e == pytest.approx(0.5)
    assert any("exactly" in note for note in result.notes)
    assert not any(check.verdict == "seen" for check in result.checks)


def test_one_reading():
    with pytest.raises(MissingError, match="its error has to be given"):
        r.experiment("alpha,beta\n45,35\n")
    result = r.experiment("alpha,beta\n45,35\n", angle_error=1)
    assert result.e == pytest.approx(math.tan(math.radians(35)))


def test_readings_that_say_nothing():
    with pytest.raises(MissingError, match=r"anything from 0\.00 to 1\.00"):
        r.experiment("alpha,beta\n88,86\n89,88\n", angle_error=3)


@pytest.mark.parametrize("error", [0, -1, math.nan, math.inf])
def test_impossible_error(error):
    with pytest.raises(StatementError, match="angle error"):
        r.experiment("alpha,beta\n45,35\n30,20\n", angle_error=error)


def test_json_has_all_of_it():
    result = r.experiment(measured(np.random.default_rng(12)), angle_error=1)
    data = json.loads(result.json())
    assert data["e"] == result.e
    assert data["interval"]["possible"] == [result.interval.low, result.interval.high]
    assert [check["id"] for check in data["checks"]] == [check.id for check in result.checks]
    assert len(data["points"]) == len(data["table"]["readings"]) == 10


def test_text_fits_the_terminal():
    result = r.experiment(measured(np.random.default_rng(13), turn=6), angle_error=1)
    text = result.text(80)
    assert max(map(len, text.splitlines())) <= 80
    assert "a line that misses the origin: SEEN" in text
