"""Experiments that are made up, with a known e, and how often what is said of them holds.

``python tests/experiments.py`` prints the tables of figures that docs/experiment.md has; with a
number, from so many experiments for each figure.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable

import numpy as np

import restitution as r
from restitution.experiments.analysis import interval_of
from restitution.experiments.rows import rows_of
from restitution.experiments.spheres import spheres_of
from restitution.experiments.tables import Options, table_of
from restitution.experiments.walls import wall_of

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
    options = Options(angle_error=error if known else None)
    inside = 0
    for _ in range(trials):
        columns = wall_columns(rng, e, n, error, speeds=False)
        readings = table_of(rows_of(columns), options).readings
        interval = interval_of(wall_of(readings, "").sample, "")
        inside += interval.low <= e <= interval.high
    return inside / trials


def coverage_of_spheres(
    e: float, error: float, *, known: bool, line: bool, trials: int, seed: int
) -> float:
    """The share of intervals of 95% that have e in them, of pucks with B at rest."""
    rng = np.random.default_rng(seed)
    options = Options(speed_error=error if known else None, angle_error=0.5 if known else None)
    inside = 0
    for _ in range(trials):
        columns = sphere_columns(rng, e, error=error, line=line, rest=True, weighed=False)
        measured = table_of(rows_of(columns), options).trials
        interval = interval_of(spheres_of(measured, "").sample, "")
        inside += interval.low <= e <= interval.high
    return inside / trials


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
