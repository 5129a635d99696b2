"""The impact in tracks: straight lines, uniform in time, that meet in a kink at one time.

Each body of a trial moves with one velocity before the impact and another after it, and where it
was is continuous: x(t) = X + u min(t − τ, 0) + v max(t − τ, 0), with one τ for all bodies. For a τ
that is given this is linear in X, u and v; by how much the sum of squares falls against one
straight line needs sums over the positions behind τ alone, so that all τ are tried.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from restitution.experiments.curves import Array
from restitution.experiments.distributions import upper_tail_of_squares
from restitution.experiments.needs import needed
from restitution.records import dataclass

LEAST = 3
"""Positions on either side of an impact."""


@dataclass(frozen=True)
class Path:
    """The positions of one body: times (n,), places (n, 2), and their lines in the table (n,)."""

    t: Array
    xy: Array
    lines: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.t)

    def only(self, chosen: NDArray[np.bool_]) -> Path:
        return Path(self.t[chosen], self.xy[chosen], self.lines[chosen])

    def between(self, begin: float, end: float) -> Path:
        return self.only((self.t >= begin) & (self.t <= end))


Paths = tuple[Path, ...]


@dataclass(frozen=True)
class Kink:
    """Lines before and after one time for each of b bodies; their arrays are of shape (b, 2).

    ``design``, of shape (2N, p), is the derivative of all places with respect to all parameters,
    and ``residuals``, of shape (2N,), what the lines leave. ``meeting`` is False where the lines
    before and after do not meet, as in a long contact; then ``places`` lie half-way.
    """

    paths: Paths
    t: float
    places: Array
    before: Array
    after: Array
    design: Array
    residuals: Array
    meeting: bool = True

    @property
    def sum_of_squares(self) -> float:
        return float(self.residuals @ self.residuals)

    @property
    def freedom(self) -> int:
        return int(self.residuals.size - self.design.shape[1])

    @property
    def velocities(self) -> Array:
        """The velocities u and v of every body, of shape (4b,)."""
        pairs: Array = np.hstack([self.before, self.after]).reshape(-1)
        return pairs

    def covariance(self) -> Array:
        """The covariance of `velocities`, for errors of 1 in each coordinate; shape (4b, 4b)."""
        inverse = np.asarray(np.linalg.pinv(self.design.T @ self.design), dtype=np.float64)
        chosen = _velocity_columns(len(self.paths), meeting=self.meeting)
        return inverse[chosen][:, chosen]


def _velocity_columns(bodies: int, *, meeting: bool) -> list[int]:
    size, first = (6, 2) if meeting else (8, 4)
    return [size * body + first + index for body in range(bodies) for index in range(4)]


# --- the search for the time ------------------------------------------------------------------


class _Sums:
    """By how much a kink at each time lets the sum of squares of one path fall."""

    def __init__(self, path: Path) -> None:
        self.middle = float(path.t.mean())
        s = path.t - self.middle
        self.times, self.square = s, float(s @ s)
        line = path.xy.mean(axis=0) + np.outer(s, s @ path.xy) / self.square
        self.rest = path.xy - line
        columns = np.column_stack([np.ones_like(s), s, s**2, self.rest, s[:, None] * self.rest])
        later = np.cumsum(columns[::-1], axis=0)[::-1]
        self.later = np.vstack([later, np.zeros(columns.shape[1])])

    @property
    def of_line(self) -> float:
        """The sum of squares about one straight line."""
        return float((self.rest**2).sum())

    def of_curve(self) -> float:
        """The sum of squares about a path with one acceleration all the way."""
        s = self.times
        bend = s**2 - (s**2).mean() - s * float(s**2 @ s) / self.square
        return self.of_line - float(((bend @ self.rest) ** 2).sum() / (bend @ bend))

    def fall(self, tau: Array) -> Array:
        """The fall of the sum of squares, for times of shape (k,)."""
        at = tau - self.middle
        n, s1, s2, *rest = self.later[np.searchsorted(self.times, at, side="right")].T
        h1, hs = s1 - at * n, s2 - at * s1
        own = s2 - 2 * at * s1 + at**2 * n - h1**2 / len(self.times) - hs**2 / self.square
        along = [rest[2 + i] - at * rest[i] for i in (0, 1)]
        result: Array = (along[0] ** 2 + along[1] ** 2) / np.maximum(own, _ROUNDING * self.square)
        return result


def _best_time(paths: Paths) -> float | None:
    """The time at which a kink of all paths leaves the least; None where it has too few points."""
    begin = max(float(path.t[LEAST - 1]) for path in paths)
    end = min(float(path.t[-LEAST]) for path in paths)
    if not begin < end:
        return begin if begin == end else None
    sums = [_Sums(path) for path in paths]
    times = np.unique(np.concatenate([path.t for path in paths]))
    times = np.concatenate([[begin], times[(times > begin) & (times < end)], [end]])
    steps = (times[:-1, None] + np.diff(times)[:, None] * np.arange(_PARTS) / _PARTS).ravel()
    grid = np.append(steps, end)
    top = int(np.argmax(sum(path_sums.fall(grid) for path_sums in sums)))
    low, high = grid[max(top - 1, 0)], grid[min(top + 1, len(grid) - 1)]
    optimize = needed("scipy.optimize", "the search for an impact")
    least = optimize.minimize_scalar(
        lambda tau: -sum(float(path_sums.fall(np.array([tau]))[0]) for path_sums in sums),
        bounds=(low, high),
        method="bounded",
        options={"xatol": 1e-9 * (end - begin)},
    )
    return float(least.x)


_PARTS = 6
"""Of the time between two frames, each of which is tried."""


def breaks(paths: Paths) -> tuple[float, ...]:
    """The times at which paths have a kink, in order.

    They are sought in halves, and then each once more between its neighbours, because the best
    single kink of a path with two may be neither.
    """
    begin, end = min(path.t[0] for path in paths), max(path.t[-1] for path in paths)
    times = _halved(paths, float(begin), float(end), _DEPTH)
    for _ in range(_ROUNDS):
        ends = [float(begin), *_merged(paths, times), float(end)]
        again = [_kink_between(paths, low, high) for low, high in zip(ends, ends[2:])]
        kept = sorted({time for time in again if time is not None})
        if len(kept) == len(times) and np.allclose(kept, times, rtol=0, atol=1e-6 * (end - begin)):
            break
        times = kept
    return tuple(times)


def _merged(paths: Paths, times: list[float]) -> list[float]:
    """The times with one in place of two that are too near for a line between them.

    Two such are a kink that was sought from either side, in halves that part beside it.
    """
    result: list[float] = []
    for time in times:
        if result and any(len(path.between(result[-1], time)) < _APART for path in paths):
            result[-1] = (result[-1] + time) / 2
        else:
            result.append(time)
    return result


_DEPTH, _ROUNDS = 3, 4
_APART = 5
"""Positions from one kink to the next."""


def _halved(paths: Paths, begin: float, end: float, depth: int) -> list[float]:
    tau = _kink_between(paths, begin, end, bending=False)
    if tau is None or depth == 0:
        return []
    early, late = (_halved(paths, *interval, depth - 1) for interval in ((begin, tau), (tau, end)))
    return [*early, tau, *late]


def _kink_between(paths: Paths, begin: float, end: float, *, bending: bool = True) -> float | None:
    """The time of a kink, or None where one line, or one that bends all the way, does as well.

    Whether a path bends is not asked of one that may have two kinks, which is like it.
    """
    paths = tuple(path.between(begin, end) for path in paths)
    if any(len(path) < 2 * LEAST for path in paths):
        return None
    tau = _best_time(paths)
    if tau is None:
        return None
    sums = [_Sums(path) for path in paths]
    straight = sum(path_sums.of_line for path_sums in sums)
    fall = sum(float(path_sums.fall(np.array([tau]))[0]) for path_sums in sums)
    size = sum(map(_size, paths))
    if fall <= _ROUNDING * size:
        return None
    if bending and straight - fall > sum(path_sums.of_curve() for path_sums in sums):
        return None
    more = 2 * len(paths) + 1
    freedom = 2 * sum(map(len, paths)) - 4 * len(paths) - more
    left = max(straight - fall, _ROUNDING * size)
    p = upper_tail_of_squares(fall / (left / freedom), more, freedom)
    return tau if p < _CLEAR else None


def _size(path: Path) -> float:
    """The sum of the squared distances of all positions from their mean."""
    return float(((path.xy - path.xy.mean(axis=0)) ** 2).sum())


_CLEAR = 1e-4
"""The level at which a kink is seen, lower than others since every time is tried."""
_ROUNDING = 1e-14
"""Of the square of the size of a path: what rounding leaves."""


# --- the lines --------------------------------------------------------------------------------


def kink_at(paths: Paths, tau: float, *, meeting: bool = True) -> Kink:
    """The lines with a kink at a time, or, if they need not meet, of the positions around it."""
    makers = [_meeting_columns if meeting else _free_columns for _ in paths]
    solved = [
        np.linalg.lstsq(make(path.t - tau), path.xy, rcond=None)[0]
        for make, path in zip(makers, paths)
    ]
    residuals = np.concatenate(
        [
            (path.xy - make(path.t - tau) @ values).ravel()
            for make, path, values in zip(makers, paths, solved)
        ]
    )
    values = np.array(solved)  # (b, 3, 2), or (b, 4, 2) where the lines need not meet
    places = values[:, 0] if meeting else values[:, :2].mean(axis=1)
    before, after = values[:, -2], values[:, -1]
    design = _design(paths, tau, before, after, meeting=meeting)
    return Kink(paths, tau, places, before, after, design, residuals, meeting)


def best_kink(paths: Paths) -> Kink | None:
    """The kink at the time that leaves the least; None where there are too few positions."""
    if any(len(path) < 2 * LEAST for path in paths):
        return None
    tau = _best_time(paths)
    return None if tau is None else _sharpened(kink_at(paths, tau))


def _sharpened(kink: Kink) -> Kink:
    """The kink after a step by the method of Gauss and Newton: the search has half the digits."""
    step = float(np.linalg.lstsq(kink.design, kink.residuals, rcond=None)[0][-1])
    other = kink_at(kink.paths, kink.t + step)
    return other if other.sum_of_squares < kink.sum_of_squares else kink


def _meeting_columns(s: Array) -> Array:
    return np.column_stack([np.ones_like(s), np.minimum(s, 0), np.maximum(s, 0)])


def _free_columns(s: Array) -> Array:
    early = (s < 0).astype(float)
    return np.column_stack([early, 1 - early, np.minimum(s, 0), np.maximum(s, 0)])


def _design(paths: Paths, tau: float, before: Array, after: Array, *, meeting: bool) -> Array:
    """The derivative of all coordinates with respect to the parameters of all bodies, and τ."""
    columns = [(_meeting_columns if meeting else _free_columns)(path.t - tau) for path in paths]
    width = 2 * columns[0].shape[1]
    rows = 2 * sum(map(len, paths))
    result = np.zeros((rows, width * len(paths) + meeting))
    row = 0
    for body, (path, array) in enumerate(zip(paths, columns)):
        end = row + 2 * len(path)
        result[row:end, body * width : (body + 1) * width] = np.kron(array, np.eye(2))
        if meeting:
            early = (path.t < tau)[:, None]
            result[row:end, -1] = -np.where(early, before[body], after[body]).ravel()
        row = end
    return result


def without_outliers(kink: Kink) -> tuple[Kink, Paths]:
    """The kink without the positions far from the lines, and those positions.

    How far is far is measured by the median distance; a path of which more than a fifth is far does
    not move on straight lines, and is left as it is.
    """
    outliers = tuple(path.only(np.zeros(len(path), bool)) for path in kink.paths)
    for _ in range(_ROUNDS):
        far = _far(kink)
        if not any(array.any() for array in far):
            return kink, outliers
        if sum(array.sum() for array in far) + sum(map(len, outliers)) > _SHARE * sum(
            map(len, kink.paths)
        ):
            return kink, outliers
        kept = tuple(path.only(~array) for path, array in zip(kink.paths, far))
        again = best_kink(kept)
        if again is None:
            return kink, outliers
        outliers = tuple(
            _joined(outlying, path.only(mask))
            for outlying, path, mask in zip(outliers, kink.paths, far)
        )  # fmt: skip
        kink = again
    return kink, outliers


_SHARE = 0.2
_FAR = 4.5
"""Errors of a coordinate; of 25 000 positions, one is as far by chance."""


def _far(kink: Kink) -> list[NDArray[np.bool_]]:
    """The positions far from lines on which the bodies may slow down."""
    residuals = kink.residuals
    slowing = slowing_column(kink)
    if slowing is not None:
        across = _across(slowing, kink.design)
        residuals = residuals - across * float(across @ residuals) / float(across @ across)
    distances = np.linalg.norm(residuals.reshape(-1, 2), axis=1)
    sigma = float(np.median(distances)) / 1.1774  # of Rayleigh's distribution
    size = max(float(np.ptp(path.xy, axis=0).max()) for path in kink.paths)
    far = distances > _FAR * max(sigma, 1e-9 * size)
    return np.split(far, np.cumsum([len(path) for path in kink.paths])[:-1])


def _joined(first: Path, second: Path) -> Path:
    return Path(
        np.concatenate([first.t, second.t]),
        np.concatenate([first.xy, second.xy]),
        np.concatenate([first.lines, second.lines]),
    )


def without_jumps(path: Path) -> tuple[Path, Path]:
    """The path without single positions that fit neither what is before them nor what is after.

    A position is compared with the lines through the two before it, through the two after it, and
    through its neighbours: at a kink one of them still fits. The others are given second.
    """
    t, xy, n = path.t, path.xy, len(path)
    if n < 2 * LEAST:
        return path, path.only(np.zeros(n, bool))
    distances = np.full(n, np.inf)
    for a, b in ((-2, -1), (1, 2), (-1, 1)):
        index = np.arange(max(0, -a), n - max(0, b))
        share = ((t[index] - t[index + a]) / (t[index + b] - t[index + a]))[:, None]
        line = xy[index + a] + share * (xy[index + b] - xy[index + a])
        distances[index] = np.minimum(distances[index], np.linalg.norm(xy[index] - line, axis=1))
    size = float(np.ptp(xy, axis=0).max())
    far = distances > max(_JUMP * float(np.median(distances)), 0.01 * size)
    if far.sum() > _SHARE * n:
        far[:] = False
    return path.only(~far), path.only(far)


_JUMP = 12


# --- lines that do not meet, and slowing down -------------------------------------------------


def opened(kink: Kink) -> Kink:
    """The lines each for itself, where these leave much less than lines that meet."""
    early = [int((path.t < kink.t).sum()) for path in kink.paths]
    if any(min(k, len(path) - k) < LEAST + 1 for k, path in zip(early, kink.paths)):
        return kink
    free = kink_at(kink.paths, kink.t, meeting=False)
    more = kink.freedom - free.freedom
    scale = free.sum_of_squares / free.freedom
    if kink.sum_of_squares <= _ROUNDING * sum(_size(path) for path in kink.paths):
        return kink
    fall = kink.sum_of_squares - free.sum_of_squares
    p = upper_tail_of_squares(fall / scale, more, free.freedom)
    return free if p < _GAP else kink


_GAP = 1e-3


def slowing_column(kink: Kink) -> Array | None:
    """The derivative of all coordinates with respect to a deceleration along the motion; (2N,).

    None where nothing moves. A body that hardly moves has no direction, and is left out.
    """
    error = np.sqrt(np.maximum(np.diag(kink.covariance()), 0)).reshape(-1, 2, 2).max(axis=2)
    error *= np.sqrt(kink.sum_of_squares / max(kink.freedom, 1))
    columns = []
    for body, path in enumerate(kink.paths):
        s = path.t - kink.t
        units = [
            velocity / size if (size := float(np.linalg.norm(velocity))) > _MOVING * spread else
            np.zeros(2)
            for velocity, spread in zip((kink.before[body], kink.after[body]), error[body])
        ]  # fmt: skip
        columns.append((-0.5 * s[:, None] ** 2 * np.where(s[:, None] < 0, *units)).ravel())
    column = np.concatenate(columns)
    return column if column.any() else None


_MOVING = 5
"""Errors of a velocity from which it has a direction."""


def _across(column: Array, design: Array) -> Array:
    """The part of a column that the parameters do not make up for."""
    made_up = np.linalg.lstsq(design, column, rcond=None)[0]
    result: Array = column - design @ made_up
    return result


def deceleration(kink: Kink) -> tuple[float, float] | None:
    """The deceleration along the motion, and its variance for positions with errors of 1."""
    column = slowing_column(kink)
    if column is None:
        return None
    across = _across(column, kink.design)
    square = float(across @ across)
    if square <= _ROUNDING * float(column @ column):
        return None
    return float(across @ kink.residuals) / square, 1 / square


def decelerated(kink: Kink, rate: float) -> tuple[Kink, Array]:
    """The kink of bodies that slow down at a rate, and the derivative of its velocities by it."""
    original = kink.paths
    for _ in range(3):
        column = slowing_column(kink)
        if column is None:
            break
        shifts = np.split(
            rate * column.reshape(-1, 2), np.cumsum([len(path) for path in original])[:-1]
        )
        paths = tuple(replace(path, xy=path.xy - array) for path, array in zip(original, shifts))
        tau = _best_time(paths) if kink.meeting else kink.t
        kink = kink_at(paths, kink.t if tau is None else tau, meeting=kink.meeting)
    column = slowing_column(kink)
    chosen = _velocity_columns(len(kink.paths), meeting=kink.meeting)
    if column is None:
        return kink, np.zeros(len(chosen))
    slope = np.linalg.lstsq(kink.design, column, rcond=None)[0][chosen]
    return kink, -np.asarray(slope, dtype=np.float64)


def first_impact(paths: Paths, times: Sequence[float]) -> tuple[float, float, float] | None:
    """The time of the first kink that may be the impact, and where its lines begin and end.

    All bodies take part in it: what changes least of their velocities changes at least a fifth as
    much as in the clearest kink. A single body is not much faster after it, as it would be where it
    is pushed or let go. None where no kink is like that.
    """
    windows = _windows(paths, times)
    kinks = [
        kink_at(tuple(path.between(low, high) for path in paths), tau)
        for (low, high), tau in zip(windows, times)
    ]
    chosen = [
        (float(np.linalg.norm(kink.after - kink.before, axis=1).min()), index)
        for index, kink in enumerate(kinks)
        if len(paths) > 1 or not _pushed(kink)
    ]
    if not chosen:
        return None
    clear = max(chosen)[0]
    first = next(index for change, index in chosen if change >= _CLEARLY * clear)
    return times[first], *windows[first]


def _windows(paths: Paths, times: Sequence[float]) -> list[tuple[float, float]]:
    """From when to when each kink is alone: without a frame next to its neighbours.

    Where a body was at another impact may be on the other side of it, by the error of its time.
    """
    frame = max(float(np.median(np.diff(path.t))) for path in paths)
    ends = [-np.inf, *times, np.inf]
    result = []
    for low, tau, high in zip(ends, times, ends[2:]):
        wide, narrow = (low, high), (low + frame, high - frame)
        enough = all(
            len(path.between(narrow[0], tau)) >= LEAST
            and len(path.between(tau, narrow[1])) >= LEAST
            for path in paths
        )
        result.append(narrow if enough else wide)
    return result


_CLEARLY = 0.2


def _pushed(kink: Kink) -> bool:
    before, after = (float(np.linalg.norm(array)) for array in (kink.before, kink.after))
    return after > 1.2 * before
