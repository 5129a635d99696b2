"""Plans of experiments: theory against simulation, and the fit of plans against that of data."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
import sympy as sp
from commands import run
from hypothesis import given, settings
from hypothesis import strategies as st

import restitution as r
from restitution.errors import StatementError
from restitution.experiments.curves import WALL
from restitution.experiments.planning import (
    HIGHEST,
    LOWEST,
    MAX_TRIALS,
    best_angle,
    reading_error,
    simulated,
)


def test_the_error_of_one_reading_by_symbols():
    """Propagation of both errors through e = tan β / tan α, and its least value."""
    alpha, beta, e, sigma, t = sp.symbols("alpha beta e sigma t", positive=True)
    law = sp.tan(beta) / sp.tan(alpha)
    variance = sigma**2 * (law.diff(alpha) ** 2 + law.diff(beta) ** 2)
    at = variance.subs(beta, sp.atan(e * sp.tan(alpha))).subs(alpha, sp.atan(sp.sqrt(t)))
    stated = sigma**2 * ((1 + e**2) / t + 4 * e**2 + e**2 * (1 + e**2) * t)
    assert sp.simplify(at - stated) == 0
    assert sp.solve(stated.diff(t), t) == [1 / e]
    least = sigma**2 * (1 + e) ** 2 * 2 * e
    assert sp.simplify(stated.subs(t, 1 / e) - least) == 0
    number = reading_error(0.6, math.radians(35), 0.02)
    wanted = sp.sqrt(stated.subs({e: 0.6, sigma: 0.02, t: math.tan(math.radians(35)) ** 2}))
    assert number == pytest.approx(float(wanted))


@given(st.floats(0.1, 1), st.floats(LOWEST, HIGHEST))
@settings(max_examples=200)
def test_no_angle_tells_more_than_the_best(e, other):
    best = math.radians(best_angle(e))
    least = reading_error(e, best, 1.0)
    assert reading_error(e, math.radians(other), 1.0) >= least * (1 - 1e-12)
    assert least == pytest.approx((1 + e) * math.sqrt(2 * e))
    beta = math.atan(e * math.tan(best))
    assert math.degrees(best + beta) == pytest.approx(90)


@pytest.mark.parametrize(("e", "angle"), [(0.3, 40), (0.7, 50), (1.0, 45), (0.7, 70)])
def test_one_angle_simulated_is_as_by_propagation(e, angle):
    rng = np.random.default_rng(1)
    angles = np.full(10, math.radians(angle))
    fits, lows, highs = simulated(e, angles, math.radians(0.5), 2000, rng)
    theory = float(reading_error(e, angles[0], math.radians(0.5))) / math.sqrt(10)
    assert fits.std(ddof=1) == pytest.approx(theory, rel=0.06)
    assert fits.mean() == pytest.approx(e, abs=4 * theory / math.sqrt(2000) + 1e-4)
    inside = np.mean((lows <= e) & (e <= highs))
    assert inside == pytest.approx(0.95, abs=0.02)


@pytest.mark.parametrize(("e", "sigma"), [(0.05, 0.5), (0.5, 1.0), (0.95, 2.0)])
def test_simulated_experiments_are_fitted_as_those_that_were_measured(e, sigma):
    angles = np.radians([20.0, 35, 50, 65, 72])
    fits, lows, highs = simulated(e, angles, math.radians(sigma), 5, np.random.default_rng(3))
    again = np.random.default_rng(3)
    alpha = angles + again.normal(0, math.radians(sigma), (5, 5))
    beta = WALL.value(angles, e) + again.normal(0, math.radians(sigma), (5, 5))
    for k in range(5):
        columns = {"alpha": np.degrees(alpha[k]), "beta": np.degrees(beta[k])}
        if min(columns["beta"]) < 0:
            continue  # no protractor reads it
        result = r.experiment(columns, angle_error=sigma)
        assert fits[k] == pytest.approx(result.e, abs=1e-4 * result.standard_error)
        for end, wanted in ((lows[k], result.interval.low), (highs[k], result.interval.high)):
            assert end == pytest.approx(wanted, abs=1e-3 * result.standard_error)


@pytest.mark.parametrize("e", [0.0, 0.3, 0.7, 1.0])
def test_designs_simulated_are_as_by_theory(e):
    plan = r.experiment_plan(e, angle_error=1, trials=12)
    for design in plan.designs:
        assert len(design.angles) == 12
        assert design.simulated_error == pytest.approx(design.standard_error, rel=0.15)
        assert design.half_width == pytest.approx(1.96 * design.standard_error, rel=0.05)
    errors = [design.standard_error for design in plan.designs]
    assert errors[0] == min(errors) and plan.designs[0].id == "best"


def test_the_turn_is_seen_in_eight_of_ten():
    """By the whole check of the model, in tables as a class would write them."""
    plan = r.experiment_plan(0.7, angle_error=1, trials=10)
    design = plan.design("even")
    rng = np.random.default_rng(4)
    alpha = np.array(design.angles)
    beta = np.degrees(np.arctan(0.7 * np.tan(np.radians(alpha))))
    seen = 0
    for _ in range(80):
        noise = rng.normal(0, 1, (2, 10))
        columns = {
            "alpha": alpha + design.smallest_turn + noise[0],
            "beta": np.maximum(beta - design.smallest_turn + noise[1], 0.01),
        }
        seen += r.experiment(columns, angle_error=1).check("offset").verdict == "seen"
    assert 0.65 < seen / 80 < 0.95


def test_one_angle_gives_no_check():
    plan = r.experiment_plan(0.6, trials=10)
    assert plan.design("best").smallest_turn is None
    columns = {"alpha": plan.design("best").angles, "beta": [40.0, 41, 42, 39, 40] * 2}
    check = r.experiment(columns, angle_error=1).check("offset")
    assert check.verdict == "untested"
    assert plan.design("even").smallest_turn < plan.design("narrow").smallest_turn


def test_trials_for_a_width_are_enough_and_no_more():
    plan = r.experiment_plan(0.7, angle_error=2, trials=8)
    for width, trials in plan.trials_for:
        if not 3 <= trials <= MAX_TRIALS:
            continue
        ends = [plan.design("even").angles[k] for k in (0, -1)]
        angles = np.radians(np.linspace(*ends, trials))
        _, lows, highs = simulated(0.7, angles, math.radians(2), 200, np.random.default_rng(5))
        assert (highs - lows).mean() / 2 == pytest.approx(width, rel=0.25)


def test_errors_fall_with_the_square_root_of_the_trials():
    few, many = (r.experiment_plan(0.5, trials=n).design("best") for n in (10, 40))
    assert few.standard_error == pytest.approx(2 * many.standard_error)


def test_a_plan_is_the_same_for_the_same_seed():
    first, again, other = (r.experiment_plan(0.5, seed=seed) for seed in (1, 1, 2))
    assert first == again != other


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"e": 1.2}, "e is 1.2"),
        ({"e": -0.1}, "e is -0.1"),
        ({"e": math.nan}, "e is nan"),
        ({"e": 0.5, "angle_error": 0}, "above 0°"),
        ({"e": 0.5, "angle_error": math.inf}, "at most 20°"),
        ({"e": 0.5, "trials": 0}, "trials is 0: it is at least 1"),
        ({"e": 0.5, "trials": 100_000}, f"at most {MAX_TRIALS}"),
        ({"e": 0.5, "trials": 2.5}, "whole number"),
        ({"e": 0.5, "trials": True}, "whole number"),
        ({"e": 0.5, "seed": -1}, "seed is -1"),
    ],
)
def test_what_no_experiment_has_is_refused(arguments, words):
    with pytest.raises(StatementError, match=words):
        r.experiment_plan(**arguments)


@pytest.mark.parametrize("trials", [1, 2, 3, 5, 30])
@pytest.mark.parametrize("e", [0, 0.5, 1])
def test_plans_in_words_are_narrow(e, trials):
    text = r.experiment_plan(e, trials=trials).text(80)
    assert max(map(len, text.splitlines())) <= 80
    assert ("check of the model possible" in text) == (trials >= 3)
    assert "nan" not in text and "inf" not in text.replace("information", "")


# --- the command ------------------------------------------------------------------------------


def test_the_command_prints_a_plan():
    usual = ("experiment", "--plan", "--e", "0.7", "--angle-error", "2", "--trials", "6")
    status, text, _ = run(*usual)
    plan = r.experiment_plan(0.7, angle_error=2, trials=6)
    assert (status, text) == (0, plan.text(80))
    status, text, _ = run(*usual, "--format", "json", "--seed", "1")
    assert status == 0
    data = json.loads(text)
    assert [each["id"] for each in data["designs"]] == [each.id for each in plan.designs]
    assert data["trials_for"][0] == {"half_width": 0.05, "trials": plan.trials_for[0][1]}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--plan",), "--e 0.7"),
        (("--plan", "--e", "2"), "from 0 to 1"),
        (("--plan", "--e", "0.5", "--trials", "0"), "at least 1"),
        (("--plan", "--e", "0.5", "angles.csv"), "no table"),
        (("--plan", "--e", "0.5", "-o", "plan.html"), "--format alone"),
        (("angles.csv", "--e", "0.5"), "--plan"),
        ((), "DATA.csv"),
    ],
)
def test_the_command_refuses_what_has_no_meaning(arguments, words):
    status, _, messages = run("experiment", *arguments)
    assert status == 2 and words in " ".join(messages.split())
