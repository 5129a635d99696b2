"""Published data: the fit agrees with general least squares, and its error with a Monte Carlo.

Collision-Study: github.com/MestreHq5/Collision-Study, disk_tracks.csv at 51efd3c, frames 135 to 157
of two rigid discs on an air table, in mm. Hockey puck: Emily Williams, "Hockey Puck Collision Lab",
tables 1 and 2, coursehero.com/file/51751141, two pucks head on. Air table: "Physics Collisions
115H", coursehero.com/file/105646, velocities of two pucks and their masses.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
import scipy

import restitution as r

PUCKS = {
    "t": [0.53, 0.56, 0.60, 0.63, 0.70, 0.76, 0.80, 0.83, 0.86, 0.90],
    "left": [0.51, 0.535, 0.555, 0.57, 0.61, 0.55, 0.52, 0.488, 0.46, 0.435],
    "right": [0.83, 0.80, 0.755, 0.71, 0.61, 0.62, 0.625, 0.63, 0.635, 0.64],
}
DISCS = {
    "0": """851.0 37.5 843.8 52.7 836.6 68.0 829.0 83.5 820.9 101.0 813.8 116.7 806.5 132.2
        799.3 147.3 791.2 164.2 783.6 180.5 776.4 196.4 775.8 213.6 780.4 231.4 785.3 250.1
        790.3 269.3 795.0 286.7 799.3 303.7 804.1 321.2 809.0 339.9 814.0 358.4""",
    "1": """627.7 15.6 633.4 31.6 639.3 47.8 645.5 64.9 651.9 82.1 657.7 97.8 663.5 113.9
        669.3 130.4 675.7 148.2 682.1 165.7 688.3 182.2 687.0 196.6 679.3 211.6 671.3 227.5
        664.1 242.1 656.9 256.5 650.4 269.6 642.4 285.1 634.4 301.2 627.2 315.6""",
}


def discs() -> dict[str, list]:
    columns: dict[str, list] = {"body": [], "t": [], "x (mm)": [], "y (mm)": []}
    for body, text in DISCS.items():
        places = np.array(text.split(), dtype=float).reshape(-1, 2)
        columns["body"] += [body] * len(places)
        columns["t"] += [frame / 60 for frame in range(len(places))]
        columns["x (mm)"] += [*places[:, 0]]
        columns["y (mm)"] += [*places[:, 1]]
    return columns


def pucks() -> dict[str, list]:
    return {
        "body": ["left"] * 10 + ["right"] * 10,
        "t": PUCKS["t"] * 2,
        "x": PUCKS["left"] + PUCKS["right"],
        "y": [0.0] * 20,
    }


def straight(t: np.ndarray, places: np.ndarray, tau: float, velocities: np.ndarray) -> np.ndarray:
    """Places that the lines give: their common point, then u and v, from (3, 2) unknowns."""
    point, u, v = velocities
    s = (t - tau)[:, None]
    return point + np.minimum(s, 0) * u + np.maximum(s, 0) * v - places


def general_fit(columns: dict[str, list], x: str, y: str) -> tuple[np.ndarray, np.ndarray, float]:
    """Both bodies' u and v, (2, 2, 2), their covariance (8, 8), and σ, by scipy.optimize."""
    bodies = np.array(columns["body"])
    names = sorted(set(bodies))
    t = [np.array(columns["t"])[bodies == each] for each in names]
    xy = [np.column_stack([columns[x], columns[y]])[bodies == each] for each in names]

    def residuals(unknown: np.ndarray) -> np.ndarray:
        lines = unknown[1:].reshape(2, 3, 2)
        return np.concatenate(
            [straight(*each, unknown[0], line).ravel() for *each, line in zip(t, xy, lines)]
        )

    best = None
    for tau in np.linspace(t[0][2], t[0][-3], 25):
        start = [tau]
        for times, places in zip(t, xy):
            slopes = [
                np.polyfit(times[side], places[side], 1)[0]
                for side in (times <= tau + 1e-9, times >= tau - 1e-9)
            ]
            start += [*places[np.argmin(abs(times - tau))], *slopes[0], *slopes[1]]
        found = scipy.optimize.least_squares(
            residuals, start, x_scale="jac", xtol=1e-14, ftol=1e-14
        )
        if best is None or found.cost < best.cost:
            best = found
    assert best is not None
    sigma = math.sqrt(2 * best.cost / (best.fun.size - best.x.size))
    chosen = [3, 4, 5, 6, 9, 10, 11, 12]
    covariance = np.linalg.inv(best.jac.T @ best.jac)[np.ix_(chosen, chosen)] * sigma**2
    return best.x[chosen].reshape(2, 2, 2), covariance, sigma


def e_of(velocities: np.ndarray) -> float:
    """From u and v of both bodies, along the line along which both velocities change."""
    (u_A, v_A), (u_B, v_B) = velocities
    changes = np.array([v_A - u_A, v_B - u_B])
    n = np.linalg.svd(changes)[2][0]
    return float((v_B - v_A) @ n / ((u_A - u_B) @ n))


def test_discs_on_an_air_table():
    """e, its error and the time agree with a general fit and a Monte Carlo of its velocities."""
    result = r.experiment(discs())
    velocities, covariance, sigma = general_fit(discs(), "x (mm)", "y (mm)")
    assert result.e == pytest.approx(e_of(velocities), abs=1e-3)
    assert result.tracks[0].position_error == pytest.approx(sigma / 1000, rel=0.05)
    rng = np.random.default_rng(1)
    drawn = rng.multivariate_normal(velocities.ravel(), covariance, 4000)
    spread = np.std([e_of(each.reshape(2, 2, 2)) for each in drawn])
    assert result.standard_error == pytest.approx(spread, rel=0.1)
    assert 0.4 < result.e < 1


def test_pucks_head_on():
    """The report has e = (0.1506 + 0.8872)/(0.5704 + 1.306) = 0.553."""
    result = r.experiment(pucks())
    velocities, _, _ = general_fit(pucks(), "x", "y")
    assert result.e == pytest.approx(e_of(velocities), abs=0.01)
    assert result.e == pytest.approx(0.553, abs=2 * result.standard_error)
    assert result.tracks[0].t == pytest.approx(0.69, abs=0.02)


def test_velocities_from_a_report():
    """One impact with masses: momentum holds, and e is that of the law by hand."""
    data = (
        "m_A (g),m_B (g),u_A_x,u_A_y,u_B_x,u_B_y,v_A_x,v_A_y,v_B_x,v_B_y\n"
        "33.1,33.8,0,0,0.951,-0.069,0.613,0.099,0.363,-0.166\n"
    )
    result = r.experiment(data, speed_error=0.01)
    velocities = np.array([[[0, 0], [0.613, 0.099]], [[0.951, -0.069], [0.363, -0.166]]])
    assert result.e == pytest.approx(e_of(velocities), abs=1e-6)
    assert result.e == pytest.approx(0.31, abs=0.01)
    rng = np.random.default_rng(2)
    drawn = [e_of(velocities + rng.normal(0, 0.01, (2, 2, 2))) for _ in range(4000)]
    assert result.standard_error == pytest.approx(np.std(drawn), rel=0.06)
    assert result.check("momentum").verdict == "not seen"
