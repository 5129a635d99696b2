"""Experiments with tracks: the impact found, the lines, what is told of bad tracks."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import restitution as r
from restitution.errors import MissingError, StatementError
from restitution.experiments import kinks
from restitution.experiments.kinks import Path

Columns = dict[str, list]
FRAMES, FPS = 30, 30.0


def path(s: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Places with an impact at s = 0, of shape (n, 2)."""
    return np.where((s < 0)[:, None], s[:, None] * u, s[:, None] * v)


def slowed(s: np.ndarray, u: np.ndarray, v: np.ndarray, rate: float) -> np.ndarray:
    """What a deceleration along the motion takes from the places."""
    units = [each / max(np.linalg.norm(each), 1e-12) for each in (u, v)]
    return 0.5 * rate * s[:, None] ** 2 * np.where((s < 0)[:, None], *units)


def wall_tracks(
    rng: np.random.Generator,
    e: float = 0.7,
    n: int = 10,
    noise: float = 0.002,
    *,
    frames: int = FRAMES,
    angles: tuple[float, float] = (15, 75),
    given: bool = False,
    turn: float = 0.0,
    kept: float = 1.0,
    slow: float = 0.0,
) -> Columns:
    """Trials at walls of any direction, with speeds from 0.6 to 1.5 and errors of each place."""
    columns: Columns = {name: [] for name in ("trial", "t", "x", "y", "wall")}
    for trial, alpha in enumerate(np.radians(np.linspace(*angles, n)), 1):
        wall = rng.uniform(0, 2 * math.pi)
        along = np.array([math.cos(wall), math.sin(wall)])
        away = np.array([-along[1], along[0]])
        speed = rng.uniform(0.6, 1.5)
        u = speed * (math.cos(alpha) * along - math.sin(alpha) * away)
        v = speed * (kept * math.cos(alpha) * along + e * math.sin(alpha) * away)
        t = np.arange(frames) / FPS
        s = t - rng.uniform(0.4, 0.6) * frames / FPS
        xy = path(s, u, v) - slowed(s, u, v, slow) + rng.normal(0, 1, (frames, 2)) * noise
        columns["trial"] += [trial] * frames
        columns["t"] += [*t]
        columns["x"] += [*xy[:, 0]]
        columns["y"] += [*xy[:, 1]]
        columns["wall"] += [math.degrees(wall) + turn] * frames
    if not given:
        del columns["wall"]
    return columns


def pair_tracks(
    rng: np.random.Generator,
    e: float = 0.7,
    n: int = 8,
    noise: float = 0.002,
    masses: tuple[float, float] = (0.5, 0.3),
) -> Columns:
    """Trials of A with B at rest."""
    columns: Columns = {name: [] for name in ("trial", "body", "t", "x", "y", "m")}
    for trial in range(1, n + 1):
        angle = math.radians(rng.uniform(15, 50) * (-1) ** trial)
        line = np.array([math.cos(angle), math.sin(angle)])
        u = np.array([rng.uniform(0.6, 1.5), 0])
        impulse = (1 + e) * (u @ line) * masses[0] * masses[1] / sum(masses) * line
        t = np.arange(FRAMES) / FPS
        s = t - rng.uniform(0.4, 0.6)
        still = np.zeros(2)
        for body, mass, velocities, start in (
            ("A", masses[0], (u, u - impulse / masses[0]), still),
            ("B", masses[1], (still, impulse / masses[1]), 0.05 * line),
        ):
            xy = start + path(s, *velocities) + rng.normal(0, 1, (FRAMES, 2)) * noise
            columns["trial"] += [trial] * FRAMES
            columns["body"] += [body] * FRAMES
            columns["t"] += [*t]
            columns["x"] += [*xy[:, 0]]
            columns["y"] += [*xy[:, 1]]
            columns["m"] += [mass] * FRAMES
    return columns


def one_track(
    s: np.ndarray, u: tuple[float, float] = (1, -0.8), v: tuple[float, float] = (1, 0.6)
) -> Columns:
    xy = path(s, np.array(u), np.array(v))
    rng = np.random.default_rng(0)
    xy = xy + rng.normal(0, 0.001, xy.shape)
    return {"t": [*(s + 1)], "x": [*xy[:, 0]], "y": [*xy[:, 1]]}


REGULAR = np.arange(-0.52, 0.5, 1 / 30)


@pytest.mark.parametrize("e", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("given", [False, True])
def test_exact_tracks_give_e_exactly(e, given):
    result = r.experiment(wall_tracks(np.random.default_rng(1), e, noise=0, given=given))
    assert result.e == pytest.approx(e, abs=1e-6)
    assert any("exactly" in note for note in result.notes)
    assert not any(check.verdict == "seen" for check in result.checks)


def test_exact_tracks_of_two_bodies():
    result = r.experiment(pair_tracks(np.random.default_rng(2), noise=0))
    assert result.e == pytest.approx(0.7, abs=1e-6)
    assert len(result.tracks) == 2 * len(result.points) == 16


@pytest.mark.parametrize("tracks", [wall_tracks, pair_tracks])
def test_noisy_tracks(tracks):
    """Errors are the spread of repeated experiments, and next to nothing is seen."""
    rng = np.random.default_rng(3)
    results = [r.experiment(tracks(rng)) for _ in range(25)]
    z = [(each.e - 0.7) / each.standard_error for each in results]
    assert np.std(z) == pytest.approx(1, abs=0.35)
    assert all(0.001 < each.standard_error < 0.006 for each in results)
    false = sum(any(check.verdict == "seen" for check in each.checks) for each in results)
    assert false <= 4  # of 25 where 5% are expected, more has a probability of 1%
    assert results[0].error_source == "given"
    assert results[0].check("speed").verdict != "untested"


def test_fitted_tracks_by_hand():
    s = np.arange(-0.5, 0.5, 0.04) + 0.011
    result = r.experiment(one_track(s))
    (track,) = result.tracks
    assert track.t == pytest.approx(1, abs=0.01)
    assert (track.x, track.y) == (pytest.approx(0, abs=0.01), pytest.approx(0, abs=0.01))
    assert track.before.velocity_x == pytest.approx(1, abs=0.01)
    assert track.after.velocity_y == pytest.approx(0.6, abs=0.01)
    assert track.position_error == pytest.approx(0.001, rel=0.4)
    assert min(track.wall, 180 - track.wall) == pytest.approx(0, abs=2)
    assert result.e == pytest.approx(0.75, abs=0.02)


@pytest.mark.parametrize("unit", ["cm", "mm", "px"])
def test_e_does_not_depend_on_units(unit):
    data = wall_tracks(np.random.default_rng(4), n=5)
    scale = {"cm": 100, "mm": 1000, "px": 734}[unit]
    other = {"trial": data["trial"], "t (ms)": [1000 * each for each in data["t"]]}
    other |= {f"{name} ({unit})": [scale * each for each in data[name]] for name in "xy"}
    expected, result = r.experiment(data), r.experiment(other)
    assert result.e == pytest.approx(expected.e, abs=1e-6)
    assert result.standard_error == pytest.approx(expected.standard_error, rel=1e-4)
    assert result.speed_unit == ("px/s" if unit == "px" else "m/s")


def test_direct_impact_counts_though_its_angles_say_nothing():
    result = r.experiment(one_track(REGULAR, (0, -1), (0, 0.6)))
    assert result.e == pytest.approx(0.6, abs=0.01)


def test_unequal_frame_times():
    rng = np.random.default_rng(5)
    s = np.sort(rng.uniform(-0.5, 0.5, 25))
    assert r.experiment(one_track(s)).e == pytest.approx(0.75, abs=0.02)


def test_three_positions_on_either_side_are_enough():
    s = np.array([-0.5, -0.3, -0.1, 0.15, 0.35, 0.5])
    assert r.experiment(one_track(s)).e == pytest.approx(0.75, abs=0.05)


# --- bad tracks -------------------------------------------------------------------------------


def test_stray_positions_are_left_out_and_told():
    data = one_track(REGULAR)
    data["x"][5] += 0.3
    data["y"][20] -= 0.2
    result = r.experiment(data)
    assert result.e == pytest.approx(0.75, abs=0.01)
    assert any("lie far from the path (line 7, 22)" in note for note in result.notes)


def test_contact_that_lasts():
    """A soft ball goes on into the wall for 0.04 s before it turns."""
    s = np.arange(-0.5, 0.5, 0.01)
    data = one_track(s)
    touching = np.abs(s) < 0.02
    data["y"] = [*np.where(touching, 0.012, data["y"])]
    result = r.experiment(data)
    assert result.e == pytest.approx(0.75, abs=0.01)
    assert any("the bodies touch there" in note for note in result.notes)


@pytest.mark.parametrize("before", ["still", "pushed"])
def test_start_of_the_motion_is_no_impact(before):
    data = one_track(np.arange(-1.2, 0.6, 1 / 30))
    t = np.array(data["t"])
    x, y = np.array(data["x"]), np.array(data["y"])
    early = t < 0.4
    first = int(early.sum())
    share = 0.0 if before == "still" else 0.4
    x[early] = x[first] + share * (x[early] - x[first]) + (1 - share) * 0.001
    y[early] = y[first] + share * (y[early] - y[first])
    result = r.experiment({"t": t, "x": x, "y": y})
    (track,) = result.tracks
    assert track.t == pytest.approx(1, abs=0.01)
    assert result.e == pytest.approx(0.75, abs=0.02)
    assert any("changes 2 times" in note for note in result.notes)


def test_first_of_two_impacts():
    s = np.arange(-0.5, 1.0, 1 / 30)
    data = one_track(s)
    late = s > 0.5
    data["x"] = [*np.where(late, 1 - np.array(data["x"]), data["x"])]
    result = r.experiment(data)
    assert result.tracks[0].t == pytest.approx(1, abs=0.01)
    assert result.tracks[0].after.t < 1.55
    assert result.e == pytest.approx(0.75, abs=0.02)
    assert any("changes 2 times" in note for note in result.notes)


GOOD = one_track(REGULAR)


def with_other(trial: Columns, body: str = "") -> Columns:
    """A good trial, and another one."""
    columns = {"trial": ["good"] * len(GOOD["t"]) + ["bad"] * len(trial["t"])}
    columns |= {name: GOOD[name] + trial[name] for name in "txy"}
    if "body" in trial:
        columns["body"] = [""] * len(GOOD["t"]) + trial["body"]
    return columns


STRAIGHT = one_track(REGULAR, (1, -0.8), (1, -0.8))
STILL = {"t": GOOD["t"], "x": [0.3] * len(REGULAR), "y": [0.1] * len(REGULAR)}
FASTER = one_track(REGULAR, (0.2, -0.1), (1, 0.7))
CURVED = {
    "t": [*REGULAR],
    "x": [*(REGULAR + np.random.default_rng(1).normal(0, 0.001, len(REGULAR)))],
    "y": [*(REGULAR**2 + np.random.default_rng(2).normal(0, 0.001, len(REGULAR)))],
}
FEW = {name: GOOD[name][13:18] for name in "txy"}
THREE = {name: 3 * GOOD[name] for name in "txy"} | {
    "body": [each for each in "ABC" for _ in REGULAR]
}
APART = {
    name: GOOD[name] + one_track(REGULAR + 0.2, (0.5, 0.5), (-0.8, 0.3))[name] for name in "xy"
} | {"t": 2 * GOOD["t"], "body": [each for each in "AB" for _ in REGULAR]}


@pytest.mark.parametrize(
    ("other", "rule"),
    [
        (STRAIGHT, "the body moves on without a kink: no impact is seen"),
        (CURVED, "the body moves on without a kink"),
        (STILL, "the body stands still"),
        (FASTER, "as where it is pushed or let go"),
        (FEW, "the body has 5 positions: it takes three before the impact and three after"),
        (THREE, "3 bodies, A, B, C: an impact has one, or two"),
        (APART, "does not change its velocity"),
        (one_track(REGULAR - 0.52), "the body moves on without a kink"),
    ],
)
def test_trial_without_an_impact_is_told_and_the_rest_goes_on(other, rule):
    result = r.experiment(with_other(other))
    assert [each.label for each in result.points] == ["good"]
    (fault,) = result.table.faults
    assert str(fault).startswith(f"line {len(REGULAR) + 2}: trial bad: ")
    assert rule in fault.rule
    with pytest.raises(MissingError, match="no impact is seen in any track"):
        r.experiment({key: each for key, each in other.items() if key != "trial"})


def test_trials_of_one_body_among_those_of_two():
    data = pair_tracks(np.random.default_rng(6), n=2)
    columns = {name: data[name] + GOOD[name] for name in "txy"}
    columns["trial"] = data["trial"] + ["alone"] * len(REGULAR)
    columns["body"] = data["body"] + ["A"] * len(REGULAR)
    result = r.experiment(columns)
    assert len(result.points) == 2
    assert "one body, and most trials have two" in result.table.faults[0].rule


def test_walls_and_masses_that_change_in_a_trial():
    rows = "\n".join(f"{i},{i},{i},{30 + i}" for i in range(8))
    with pytest.raises(StatementError, match="wall 30 and 37: a wall has one direction"):
        r.experiment(f"t,x,y,wall\n{rows}\n")
    with pytest.raises(StatementError, match="m 30 and 37: a body has one mass"):
        r.experiment(f"t,x,y,m (kg)\n{rows}\n")


def test_a_time_that_is_wrong():
    data = one_track(REGULAR)
    data["t"][-1] = 9e8
    result = r.experiment(data)
    assert result.e == pytest.approx(0.75, abs=0.01)
    assert any(f"(line {len(REGULAR) + 1})" in note for note in result.notes)
    stopped = {"t": data["t"], "x": [0.0] * len(REGULAR), "y": [*np.minimum(REGULAR, 0)]}
    with pytest.raises(MissingError, match="much longer than its frames"):
        r.experiment(stopped)


def test_names_cannot_command_a_terminal():
    data = one_track(REGULAR)
    data["trial"] = ["\x1b[31mred"] * len(REGULAR)
    assert "\x1b" not in r.experiment(data).text()


# --- the check of the model -------------------------------------------------------------------


@pytest.mark.parametrize(
    ("pattern", "change"),
    [
        ("offset", {"given": True, "turn": 5.0}),
        ("friction", {"given": True, "kept": 0.9}),
        ("above-one", {"e": 1.1}),
        ("slowing", {"slow": 0.1}),
    ],
)
def test_pattern_is_seen_in_data_made_with_it(pattern, change):
    rng = np.random.default_rng(7)
    results = [r.experiment(wall_tracks(rng, **change)) for _ in range(10)]
    assert sum(each.check(pattern).verdict == "seen" for each in results) >= 9


def test_slowing_down_is_put_right():
    """Mean velocities before and after would give an e that is too small by 0.07."""
    rng = np.random.default_rng(8)
    results = [r.experiment(wall_tracks(rng, slow=0.2)) for _ in range(10)]
    assert np.mean([each.e for each in results]) == pytest.approx(0.7, abs=0.005)
    check = results[0].check("slowing")
    assert check.estimate == pytest.approx(0.2, abs=0.04)
    assert "rolling friction" in check.sentence
    assert "taken at the impact" in check.sentence


def test_momentum_of_two_bodies():
    data = pair_tracks(np.random.default_rng(9))
    assert r.experiment(data).check("momentum").verdict == "not seen"
    wrong = {**data, "m": [0.5 if body == "A" else 0.4 for body in data["body"]]}
    assert r.experiment(wrong).check("momentum").verdict == "seen"
    del data["m"]
    assert r.experiment(data).check("momentum").verdict == "untested"


# --- the search for the impact ----------------------------------------------------------------


def test_search_is_that_of_a_brute_least_squares():
    rng = np.random.default_rng(10)
    t = np.sort(rng.uniform(0, 1, 24))
    xy = path(t - 0.47, np.array([1, -1]), np.array([0.8, 0.5])) + rng.normal(0, 0.02, (24, 2))
    kink = kinks.best_kink((Path(t, xy, np.arange(24)),))
    assert kink is not None

    def square(tau: float) -> float:
        columns = np.column_stack([np.ones(24), np.minimum(t - tau, 0), np.maximum(t - tau, 0)])
        return float(np.linalg.lstsq(columns, xy, rcond=None)[1].sum())

    grid = np.linspace(t[2], t[-3], 4001)
    least = grid[int(np.argmin([square(each) for each in grid]))]
    assert kink.t == pytest.approx(least, abs=2 * (grid[1] - grid[0]))
    assert kink.sum_of_squares == pytest.approx(square(kink.t), rel=1e-9)


def test_covariance_of_velocities_by_monte_carlo():
    rng = np.random.default_rng(11)
    t = np.arange(20) / 20
    exact = path(t - 0.52, np.array([1, -1]), np.array([0.8, 0.5]))
    drawn = []
    for _ in range(1500):
        kink = kinks.best_kink((Path(t, exact + rng.normal(0, 0.005, (20, 2)), np.arange(20)),))
        assert kink is not None
        drawn.append(kink.velocities)
    expected = kink.covariance() * 0.005**2
    np.testing.assert_allclose(
        np.sqrt(np.diag(np.cov(np.array(drawn).T))), np.sqrt(np.diag(expected)), rtol=0.1
    )


def test_text_and_json():
    result = r.experiment(pair_tracks(np.random.default_rng(12)))
    text = result.text(80)
    assert max(map(len, text.splitlines())) <= 80
    assert "impact at" in text and "speed before" in text
    assert "Momentum stays" in text.replace("\n      ", " ")
    data = json.loads(result.json())
    assert data["kind"] == "tracks"
    assert len(data["tracks"]) == 16
    assert data["tracks"][0]["body"] == "A"
