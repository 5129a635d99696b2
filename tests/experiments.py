"""Experiments that are made up, with a known e, and how often what is said of them holds.

``python tests/experiments.py`` prints the tables of figures that docs/experiment.md has; with a
number, from so many experiments for each figure.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable

import numpy as np
import scipy

import restitution as r
from restitution.experiments.curves import SPHERES, WALL, Law, Readings, sum_of_squares
from restitution.experiments.rows import rows_of
from restitution.experiments.spheres import spheres_of
from restitution.experiments.tables import LEAST_BETA, Options, table_of

Columns = dict[str, np.ndarray]
COEFFICIENTS = (0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 1.0)
ANGLE_ERRORS = (0.3, 1.0, 3.0)
SPEED_ERRORS = (0.005, 0.02, 0.05)


def wall_columns(
    rng: np.random.Generator,
    e: float = 0.7,
    n: int = 10,
    error: float = 1.0,
    between: tuple[float, float] = (20, 70),
    *,
    turn: float = 0.0,
    kept: float = 1.0,
    fall: float = 0.0,
    speeds: bool = True,
) -> Columns:
    """What a class measures: angles with errors, and speeds to 2%, half of them slow."""
    alpha = np.radians(np.linspace(*between, n))
    u = np.where(np.arange(n) % 2, 1.0, 2.0)
    beta = np.arctan((e - fall * (u - 1.5)) * np.tan(alpha) / kept)
    v = kept * u * np.cos(alpha) / np.cos(beta)
    noise = rng.normal(0, error, (2, n))
    columns = {
        "alpha": np.degrees(alpha) + turn + noise[0],
        "beta": np.degrees(beta) - turn + noise[1],
    }
    if speeds:
        columns["u"] = u * rng.normal(1, 0.02, n)
        columns["v"] = v * rng.normal(1, 0.02, n)
    return columns


def _turned(angles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Unit vectors along and across directions in degrees, of shape (n, 2)."""
    a = np.radians(angles)
    n = np.column_stack([np.cos(a), np.sin(a)])
    return n, np.column_stack([-n[:, 1], n[:, 0]])


def sphere_columns(
    rng: np.random.Generator,
    e: float = 0.7,
    n: int = 10,
    error: float = 0.02,
    *,
    masses: tuple[float, float] = (0.5, 0.3),
    between: tuple[float, float] = (20, 60),
    rest: bool = False,
    line: bool = False,
    turn: float = 0.0,
    kept: float = 1.0,
    fall: float = 0.0,
    slow: float = 0.0,
    weighed: bool = True,
) -> Columns:
    """What pucks on an air table do, with errors of every component; speeds from 0.4 to 1.2."""
    m_A, m_B = masses
    angles = rng.uniform(*between, n) * np.where(np.arange(n) % 2, 1, -1)
    along, across = _turned(angles)
    u = rng.permutation(np.linspace(0.4, 1.2, n))
    u_A = np.column_stack([u, 0 * u])
    u_B = np.zeros((n, 2)) if rest else np.column_stack([-0.3 * u, 0.2 * u])
    approach = ((u_A - u_B) * along).sum(axis=1)
    passing = ((u_A - u_B) * across).sum(axis=1)
    each = e - fall * ((approach - approach.mean()) / max(np.ptp(approach), 1e-9))
    reduced = m_A * m_B / (m_A + m_B)
    impulse = reduced * (
        -along * ((1 + each) * approach)[:, None] - across * ((1 - kept) * passing)[:, None]
    )
    after = (1 - slow) * (u_A + impulse / m_A), (1 - slow) * (u_B - impulse / m_B)
    vectors = {"u_A": u_A, "v_A": after[0], "v_B": after[1]}
    if not rest:
        vectors["u_B"] = u_B
    columns = {
        f"{name}_{part}": values + rng.normal(0, error, n) if error else values
        for name, pair in vectors.items()
        for part, values in zip("xy", pair.T)
    }
    if weighed:
        columns |= {"m_A": np.full(n, m_A), "m_B": np.full(n, m_B)}
    if line:
        columns["line"] = angles + turn + rng.normal(0, 0.5, n) * (error > 0)
    return columns


# --- how often ----------------------------------------------------------------------------------


def coverage_of_walls(
    e: float, error: float, *, known: bool, trials: int, seed: int, n: int = 10
) -> float:
    """The share of intervals of 95% that have e in them, of readings from 20° to 70°."""
    rng = np.random.default_rng(seed)
    columns = [wall_columns(rng, e, n, error, speeds=False) for _ in range(trials)]
    alpha, beta = (np.array([each[name] for each in columns]) for name in ("alpha", "beta"))
    # A reading that the table would refuse has no weight.
    variance = np.where(beta < LEAST_BETA, 1e12, np.radians(error) ** 2)
    readings = Readings(np.radians(alpha), np.radians(beta), variance, variance, 0 * variance)
    return float(holds(readings, WALL, e, known=known).mean())


def coverage_of_spheres(
    e: float, error: float, *, known: bool, line: bool, trials: int, seed: int
) -> float:
    """The share of intervals of 95% that have e in them, of pucks with B at rest."""
    rng = np.random.default_rng(seed)
    options = Options(speed_error=error if known else None, angle_error=0.5 if known else None)
    samples = []
    for _ in range(trials):
        columns = sphere_columns(rng, e, error=error, line=line, rest=True, weighed=False)
        samples.append(spheres_of(table_of(rows_of(columns), options).trials, "").sample.readings)
    readings = Readings(*(np.array(values) for values in _rows(samples)))
    return float(holds(readings, SPHERES, e, known=known).mean())


def _rows(samples: list[Readings]) -> list[list[np.ndarray]]:
    """The readings of all samples in rows of one length; those that are made up have no weight."""
    most = max(map(len, samples))
    blank = {"x": 1.0, "y": 0.0, "x_variance": 1e12, "y_variance": 1e12, "covariance": 0.0}
    return [
        [np.pad(getattr(s, name), (0, most - len(s)), constant_values=value) for s in samples]
        for name, value in blank.items()
    ]


def holds(readings: Readings, law: Law, e: float, *, known: bool) -> np.ndarray:
    """Whether the interval of each of N experiments of n readings has e in it; arrays (N, n).

    By its definition: the sum of squares at e is above the least by no more than a quantile. The
    least is sought by golden section, so that the fit itself is not asked.
    """
    trials = len(readings)
    grid = np.array([-0.2, 0.0, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.3, 2.0, 4.0])
    sums = np.array([sum_of_squares(readings, law, np.full((trials, 1), each)) for each in grid])
    best = sums.argmin(axis=0).clip(1, len(grid) - 2)
    low, high = grid[best - 1], grid[best + 1]
    share = (np.sqrt(5) - 1) / 2

    def at(values: np.ndarray) -> np.ndarray:
        return sum_of_squares(readings, law, values[:, None])

    inner, outer = high - share * (high - low), low + share * (high - low)
    s_inner, s_outer = at(inner), at(outer)
    for _ in range(26):
        left = s_inner < s_outer
        low, high = np.where(left, low, inner), np.where(left, outer, high)
        again = np.where(left, high - share * (high - low), low + share * (high - low))
        s_again = at(again)
        inner, outer = np.where(left, again, outer), np.where(left, inner, again)
        s_inner, s_outer = np.where(left, s_again, s_outer), np.where(left, s_inner, s_again)
    least = np.minimum(s_inner, s_outer)
    excess = at(np.full(trials, e)) - least
    if known:
        return excess <= scipy.stats.chi2.ppf(0.95, 1)
    freedom = (readings.x_variance < 1e6).sum(axis=1) - 1
    return excess <= scipy.stats.f.ppf(0.95, 1, freedom) * least / freedom


def seen(
    columns: Callable[[np.random.Generator], Columns],
    options: dict[str, float],
    *,
    trials: int,
    seed: int,
) -> Counter[str]:
    """How often each pattern is seen, and under "any" how often any is."""
    rng = np.random.default_rng(seed)
    counts: Counter[str] = Counter()
    for _ in range(trials):
        checks = r.experiment(columns(rng), **options).checks
        patterns = [check.id for check in checks if check.verdict == "seen"]
        counts.update([*patterns, *(["any"] if patterns else [])])
    return counts


WALL_PATTERNS = {
    "friction": {"kept": 0.9},
    "offset": {"turn": 5.0},
    "speed": {"fall": 0.1},
    "above-one": {"e": 1.1},
}
SPHERE_PATTERNS = {
    "friction": {"kept": 0.85, "line": True},
    "offset": {"turn": 5.0, "line": True},
    "speed": {"fall": 0.25},
    "above-one": {"e": 1.1},
    "momentum": {"slow": 0.1},
}


# --- the tables of the documentation ------------------------------------------------------------


def _line(e: float, shares: list[float]) -> str:
    return f"| {e} | " + " | ".join(f"{100 * each:.1f}" for each in shares) + " |"


def _coverage_tables(trials: int) -> None:
    for known in (True, False):
        print(f"\nwall, errors {'given' if known else 'from the scatter'}")
        print("| e | " + " | ".join(f"{error}°" for error in ANGLE_ERRORS) + " |")
        for i, e in enumerate(COEFFICIENTS):
            shares = [
                coverage_of_walls(e, error, known=known, trials=trials, seed=100 * i + j)
                for j, error in enumerate(ANGLE_ERRORS)
            ]
            print(_line(e, shares), flush=True)


def _sphere_tables(trials: int) -> None:
    for line in (False, True):
        for known in (True, False):
            print(f"\nspheres, line {'given' if line else 'found'}, errors {known=}")
            print("| e | " + " | ".join(f"{error} m/s" for error in SPEED_ERRORS) + " |")
            for i, e in enumerate(COEFFICIENTS):
                shares = [
                    coverage_of_spheres(
                        e, error, known=known, line=line, trials=trials, seed=100 * i + j
                    )
                    for j, error in enumerate(SPEED_ERRORS)
                ]
                print(_line(e, shares), flush=True)


def _pattern_tables(trials: int) -> None:
    walls = {True: {"angle_error": 1.0}, False: {}}
    spheres = {True: {"speed_error": 0.02, "angle_error": 0.5}, False: {}}
    for known in (True, False):
        for name, change in {"none": {}, "e = 1": {"e": 1.0}, "e = 0.2": {"e": 0.2}}.items():
            counts = seen(
                lambda rng: wall_columns(rng, between=(15, 75), **change),  # noqa: B023
                walls[known],
                trials=trials,
                seed=1,
            )
            print("wall", f"{known=}", name, dict(counts), trials, flush=True)
        for name, change in WALL_PATTERNS.items():
            for between in ((15, 75), (20, 70), (35, 55)):
                counts = seen(
                    lambda rng: wall_columns(rng, between=between, **change),  # noqa: B023
                    walls[known],
                    trials=trials // 2,
                    seed=2,
                )
                print("wall", f"{known=}", name, between, dict(counts), trials // 2, flush=True)
        for line in (False, True):
            counts = seen(
                lambda rng: sphere_columns(rng, line=line),  # noqa: B023
                spheres[known],
                trials=trials,
                seed=3,
            )
            print("spheres", f"{known=} {line=}", "none", dict(counts), trials, flush=True)
        for name, change in SPHERE_PATTERNS.items():
            counts = seen(
                lambda rng: sphere_columns(rng, **change),  # noqa: B023
                spheres[known],
                trials=trials // 2,
                seed=4,
            )
            print("spheres", f"{known=}", name, dict(counts), trials // 2, flush=True)


if __name__ == "__main__":
    size = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    tables = {"walls": _coverage_tables, "spheres": _sphere_tables, "patterns": _pattern_tables}
    for name in sys.argv[2:] or tables:
        tables[name](size)
