"""Experiments with two spheres: e, the propagation of errors, and the check of the model."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
import scipy
from experiments import sphere_columns as measured

import restitution as r
from restitution.errors import MissingError
from restitution.experiments import spheres
from restitution.experiments.impacts import impact_of
from restitution.experiments.rows import rows_of
from restitution.experiments.tables import Options, table_of


def trials_of(columns: dict[str, np.ndarray]):
    return table_of(rows_of(columns), Options(speed_error=0.02, angle_error=0.5)).trials


@pytest.mark.parametrize("e", [0.0, 0.05, 0.5, 1.0])
@pytest.mark.parametrize("line", [False, True])
@pytest.mark.parametrize("rest", [False, True])
def test_exact_velocities_give_e_exactly(e, line, rest):
    data = measured(np.random.default_rng(1), e, error=0, line=line, rest=rest)
    result = r.experiment(data, speed_error=0.02)
    assert result.e == pytest.approx(e, abs=1e-8)
    assert result.interval.low < e < result.interval.high


def test_example_by_hand():
    """A, 2 kg, 3i − 4j, and B, 3 kg, 2i + 3j, become 3i + 2j and 2i − j: e = 3/7 along j."""
    columns = "m_A,m_B,u_A_x,u_A_y,u_B_x,u_B_y,v_A_x,v_A_y,v_B_x,v_B_y\n"
    result = r.experiment(columns + "2,3,3,-4,2,3,3,2,2,-1\n", speed_error=0.1)
    assert result.e == pytest.approx(3 / 7)
    (point,) = result.points
    assert (point.x, point.y) == (pytest.approx(7), pytest.approx(3))
    assert result.check("momentum").estimate == pytest.approx(0, abs=1e-12)


def test_speeds_and_angles_are_components():
    data = measured(np.random.default_rng(2))
    polar = {key: each for key, each in data.items() if key in ("m_A", "m_B")}
    for name in ("u_A", "u_B", "v_A", "v_B"):
        x, y = data[f"{name}_x"], data[f"{name}_y"]
        polar |= {name: np.hypot(x, y), f"{name}_angle": np.degrees(np.arctan2(y, x))}
    expected, result = r.experiment(data), r.experiment(polar)
    assert result.e == pytest.approx(expected.e)
    assert result.standard_error == pytest.approx(expected.standard_error)


@pytest.mark.parametrize("change", ["turned", "named otherwise", "in another frame", "faster"])
def test_result_does_not_depend_on_how_it_is_described(change):
    data = measured(np.random.default_rng(3), line=True)
    other = dict(data)
    error = 0.02
    if change == "turned":
        for name in ("u_A", "u_B", "v_A", "v_B"):
            x, y = data[f"{name}_x"], data[f"{name}_y"]
            other[f"{name}_x"] = x * math.cos(1) - y * math.sin(1)
            other[f"{name}_y"] = x * math.sin(1) + y * math.cos(1)
        other["line"] = data["line"] + math.degrees(1)
    elif change == "named otherwise":
        swap = {"A": "B", "B": "A"}
        other = {
            f"{key[:2]}{swap[key[2]]}{key[3:]}" if key != "line" else key: each
            for key, each in data.items()
        }
    elif change == "in another frame":
        for name in ("u_A", "u_B", "v_A", "v_B"):
            other[f"{name}_x"] = data[f"{name}_x"] + 3
    else:
        error = 0.06
        for name in ("u_A", "u_B", "v_A", "v_B"):
            for part in "xy":
                other[f"{name}_{part}"] = 3 * data[f"{name}_{part}"]
    expected = r.experiment(data, speed_error=0.02, angle_error=0.5)
    result = r.experiment(other, speed_error=error, angle_error=0.5)
    assert result.e == pytest.approx(expected.e, abs=1e-7)
    assert result.standard_error == pytest.approx(expected.standard_error, rel=1e-5)
    for pattern in ("speed", "offset", "friction", "above-one"):
        assert result.check(pattern).p_value == pytest.approx(
            expected.check(pattern).p_value, rel=1e-4
        )


@pytest.mark.parametrize("line", [False, True])
def test_errors_along_the_line_by_monte_carlo(line):
    """The covariance of approach and separation, where velocities and the line have errors."""
    rng = np.random.default_rng(4)
    (trial,) = trials_of(measured(rng, n=1, line=line))
    impact = impact_of(trial, np.eye(8) * 0.005**2)
    assert impact is not None
    drawn = []
    for _ in range(4000):
        z = impact.z + rng.normal(0, 0.005, 8)
        if line:
            angle = math.atan2(impact.n[1], impact.n[0]) + rng.normal(0, impact.line_error)
            n = np.array([math.cos(angle), math.sin(angle)])
        else:
            changes = z[2:4] - z[:2], z[6:8] - z[4:6]
            _, vectors = np.linalg.eigh(sum(np.outer(d, d) for d in changes))
            n = vectors[:, 1] * np.sign(vectors[:, 1] @ impact.n)
        drawn.append([(z[:2] - z[4:6]) @ n, (z[6:8] - z[2:4]) @ n])
    np.testing.assert_allclose(impact.along(), np.cov(np.array(drawn).T), rtol=0.1, atol=2e-6)


@pytest.mark.parametrize("e", [0.1, 0.5, 0.9])
def test_fit_is_that_of_the_whole_likelihood(e):
    """Independent: e, all lines of centres and all true velocities by one least squares."""
    data = measured(np.random.default_rng(5), e, n=6)
    result = r.experiment(data, speed_error=0.02)
    z = np.column_stack(
        [data[f"{each}_{part}"] for each in ("u_A", "u_B", "v_A", "v_B") for part in "xy"]
    )

    def residuals(unknown: np.ndarray) -> np.ndarray:
        angle, size_A, size_B = unknown[1:19].reshape(3, 6)
        u = unknown[19:].reshape(6, 4)
        n = np.column_stack([np.cos(angle), np.sin(angle)])
        approach = ((u[:, :2] - u[:, 2:]) * n).sum(axis=1)
        total = (1 + unknown[0]) * approach
        share = size_A / (size_A + size_B)
        v_A, v_B = (
            u[:, :2] - n * (share * total)[:, None],
            u[:, 2:] + n * ((1 - share) * total)[:, None],
        )
        return ((np.column_stack([u, v_A, v_B]) - z) / 0.02).ravel()

    impacts = spheres.spheres_of(trials_of(data), "m/s").impacts
    angles = [math.atan2(each.n[1], each.n[0]) for each in impacts]
    start = np.concatenate([[0.5], angles, np.full(6, 0.5), np.full(6, 0.5), z[:, :4].ravel()])
    found = scipy.optimize.least_squares(residuals, start, method="trf", xtol=1e-12, ftol=1e-12)
    assert result.e == pytest.approx(found.x[0], abs=0.1 * result.standard_error)


def test_standard_error_is_the_spread_of_repeated_experiments():
    rng = np.random.default_rng(6)
    results = [r.experiment(measured(rng), speed_error=0.02) for _ in range(200)]
    z = [(each.e - 0.7) / each.standard_error for each in results]
    assert np.std(z) == pytest.approx(1, abs=0.15)
    assert np.mean(z) == pytest.approx(0, abs=0.25)


def test_scatter_stands_in_for_errors_that_are_not_given():
    result = r.experiment(measured(np.random.default_rng(7), n=200))
    assert result.error_source == "scatter"
    assert result.speed_error == pytest.approx(0.02, rel=0.15)
    assert "0.02" in result.text() or "0.019" in result.text() or "0.021" in result.text()


def test_class_values_by_hand():
    columns = "u_A_x,u_A_y,v_A_x,v_A_y,v_B_x,v_B_y\n"
    result = r.experiment(columns + "2,0,0.5,0,1.5,0\n1,0,0.2,0,0.8,0\n", speed_error=0.05)
    assert result.class_values.mean_ratio == pytest.approx(0.55)
    assert result.class_values.slope == pytest.approx((2 * 1 + 1 * 0.6) / 5)
    assert "fastest impact: line 2" in result.class_values.why


# --- the check of the model -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("pattern", "change"),
    [
        ("offset", {"turn": 5.0, "line": True}),
        ("friction", {"kept": 0.85, "line": True}),
        ("speed", {"fall": 0.25}),
        ("above-one", {"e": 1.1}),
        ("momentum", {"slow": 0.1}),
        ("scatter", {"error": 0.06}),
    ],
)
def test_pattern_is_seen_in_data_made_with_it(pattern, change):
    """At least 80% of experiments of ten trials with 0.02 m/s and 0.5°."""
    rng = np.random.default_rng(8)
    seen = 0
    for _ in range(25):
        result = r.experiment(measured(rng, **change), speed_error=0.02, angle_error=0.5)
        seen += result.check(pattern).verdict == "seen"
    assert seen >= 20


@pytest.mark.parametrize("known", [True, False])
@pytest.mark.parametrize("line", [True, False])
def test_nothing_is_seen_in_data_of_the_model(known, line):
    rng = np.random.default_rng(9)
    errors = {"speed_error": 0.02, "angle_error": 0.5} if known else {}
    false = 0
    for _ in range(60):
        result = r.experiment(measured(rng, line=line), **errors)
        false += any(check.verdict == "seen" for check in result.checks)
    assert false <= 7  # of 60 where 5% are expected, more has a probability of 2%


def test_sizes_of_patterns():
    rng = np.random.default_rng(10)
    data = measured(rng, error=0, turn=4, line=True)
    offset = r.experiment(data, speed_error=0.001).check("offset")
    assert offset.estimate == pytest.approx(4, abs=0.1)
    assert "turned anticlockwise by 4" in offset.sentence
    data = measured(rng, error=0, kept=0.8, line=True)
    friction = r.experiment(data, speed_error=0.001).check("friction")
    assert friction.estimate == pytest.approx(
        -0.2 / 0.9, rel=0.1
    )  # of the mean of before and after
    data = measured(rng, error=0, slow=0.1)
    momentum = r.experiment(data, speed_error=0.001).check("momentum")
    assert momentum.estimate == pytest.approx(-0.1 / 0.95, rel=0.02)
    assert "there is 11% ± " in momentum.sentence


def test_pattern_without_its_columns_is_untested():
    result = r.experiment(measured(np.random.default_rng(11), weighed=False))
    untested = {check.id: check.sentence for check in result.checks if check.verdict == "untested"}
    assert set(untested) == {"momentum", "friction", "offset", "scatter"}
    assert "m_A and m_B" in untested["momentum"]
    assert "give a column line" in untested["friction"]


def test_one_side_does_not_tell_friction_from_a_turned_line():
    data = measured(np.random.default_rng(12), n=12, between=(40, 42), rest=True, line=True, turn=6)
    one_side = {key: each[::2] for key, each in data.items()}
    result = r.experiment(one_side, speed_error=0.02, angle_error=0.5)
    seen = [check for check in result.checks if check.verdict == "seen"]
    assert [each.id for each in seen if each.id in ("offset", "friction")]
    assert "do not tell friction from a direction" in " ".join(each.sentence for each in seen)


def test_direct_impacts_have_no_friction_to_show():
    columns = "u_A_x,u_A_y,v_A_x,v_A_y,v_B_x,v_B_y,line\n"
    rows = "2,0.01,0.5,0,1.5,0.01,0\n1,0,0.2,0.01,0.8,0,0\n1.5,0,0.4,0,1.1,0.02,0\n"
    result = r.experiment(columns + rows, speed_error=0.02)
    assert result.check("friction").verdict == "untested"
    assert result.check("offset").verdict == "not seen"


# --- what cannot be used ----------------------------------------------------------------------

HEAD = "u_A_x,u_A_y,v_A_x,v_A_y,v_B_x,v_B_y"


@pytest.mark.parametrize(
    ("row", "rule"),
    [
        ("1,0,1,0,0,0", "no velocity changes"),
        ("1,0,0.99,0.01,0.01,0", "known to ±"),
        ("1,0,1.5,0,-0.3,0", "do not approach each other"),
    ],
)
def test_trial_that_cannot_be_used_is_told(row, rule):
    good = "2,0,0.5,0,1.5,0\n1,0,0.2,0,0.8,0\n"
    result = r.experiment(f"{HEAD}\n{row}\n{good}", speed_error=0.02)
    assert len(result.points) == 2
    (fault,) = result.table.faults
    assert fault.line == 2
    assert rule in fault.rule
    with pytest.raises(MissingError, match="no trial can be used: line 2"):
        r.experiment(f"{HEAD}\n{row}\n", speed_error=0.02)


def test_half_errors_are_told():
    text = "u_A,u_A_angle,v_A,v_A_angle,v_B,v_B_angle\n2,0,0.5,1,1.5,0\n1,0,0.2,0,0.8,0\n"
    result = r.experiment(f"{text}3,0,1,0,2.7,0\n", angle_error=1)
    assert result.error_source == "scatter"
    assert any("none of its speed" in note for note in result.notes)


def test_missing_errors_are_the_middle_ones():
    text = f"{HEAD},v_B_x_error\n2,0,0.5,0,1.5,0,0.03\n1,0,0.2,0,0.8,0,\n"
    result = r.experiment(text)
    assert result.error_source == "given"
    assert any("taken to have 0.03" in note for note in result.notes)


def test_json_and_text():
    result = r.experiment(measured(np.random.default_rng(13)), speed_error=0.02)
    data = json.loads(result.json())
    assert data["kind"] == "spheres"
    assert data["speed_error"] == pytest.approx(0.02)
    assert len(data["points"]) == len(data["table"]["trials"]) == 10
    text = result.text(80)
    assert max(map(len, text.splitlines())) <= 80
    assert "0.02 m/s for a component of a velocity" in text
