"""Tracks: positions with times → straight lines → impacts with a wall, or of two bodies.

An impact with a wall is one with a body B that rests and stays at rest, whose line of centres is
the normal of the wall; so both kinds go the way of two spheres. The errors of the velocities follow
from the scatter of the positions about the lines, which is one for all tracks unless they differ by
more than chance. Where the bodies slow down, they do so at one rate in all trials, and velocities
are those at the impact.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from restitution.counting import counted
from restitution.errors import MissingError
from restitution.experiments.curves import Array
from restitution.experiments.distributions import upper_tail, upper_tail_of_squares
from restitution.experiments.kinks import (
    LEAST,
    Kink,
    Path,
    Paths,
    best_kink,
    breaks,
    decelerated,
    deceleration,
    first_impact,
    opened,
    without_jumps,
    without_outliers,
)
from restitution.experiments.numbers import probability, with_error
from restitution.experiments.patterns import Pattern, Untested
from restitution.experiments.records import (
    Fault,
    Measured,
    MeasuredSphere,
    SpheresTrial,
    Table,
    Track,
    Velocity,
)
from restitution.experiments.results import FittedTrack, StraightLine
from restitution.experiments.spheres import OF_TWO_TRACKS, OF_WALL, Spheres, impacts_of
from restitution.records import dataclass


@dataclass(frozen=True)
class Trial:
    """The tracks of one trial with their kink; one track is of a wall, two are of two bodies."""

    tracks: tuple[Track, ...]
    kink: Kink

    @property
    def name(self) -> str:
        return f"trial {self.tracks[0].trial}" if self.tracks[0].trial else "the track"

    def body(self, index: int) -> str:
        return _named(self.tracks[index])


@dataclass(frozen=True)
class Tracks:
    """The impacts that were seen in tracks, the lines fitted, and how the bodies slow down."""

    spheres: Spheres
    fitted: tuple[FittedTrack, ...]
    slowing: Pattern | Untested
    faults: tuple[Fault, ...]
    notes: tuple[str, ...]


class _NoImpactError(Exception):
    """Why no impact is to be seen in a trial."""


def tracks_of(table: Table) -> Tracks:
    """The impacts in the tracks of a table.

    Raises MissingError where there is none.
    """
    trials, faults, notes = _trials(table.tracks)
    if not trials:
        raise MissingError(f"no impact is seen in any track: {faults[0]}")
    unit = table.units["x"]
    slowing, rate, rate_variance = _slowing(trials, unit)
    slopes = [np.zeros(4 * len(trial.tracks)) for trial in trials]
    if rate:
        pairs = [decelerated(trial.kink, rate) for trial in trials]
        trials = [replace(trial, kink=kink) for trial, (kink, _) in zip(trials, pairs)]
        slopes = [slope for _, slope in pairs]
    variances, freedom, more = _variances(trials)
    notes += more
    # All trials share the error of the rate, so that it does not become less in their mean: n-fold
    # in each, as if they did not share it, it is as large there.
    rate_variance *= len(trials)
    covariances = [
        _of_two(variance * trial.kink.covariance() + rate_variance * np.outer(slope, slope))
        for trial, variance, slope in zip(trials, variances, slopes)
    ]
    spheres = impacts_of(
        tuple(_impact(trial) for trial in trials),
        f"{unit}/s",
        covariances,
        known=freedom > 0,
        freedom=freedom or None,
        words=OF_TWO_TRACKS if len(trials[0].tracks) == 2 else OF_WALL,
    )
    fitted = _fitted(trials, spheres, variances, covariances)
    return Tracks(spheres, fitted, slowing, tuple(faults), tuple(notes))


# --- which impacts there are ------------------------------------------------------------------


def _trials(tracks: tuple[Track, ...]) -> tuple[list[Trial], list[Fault], list[str]]:
    """The trials with an impact; as many bodies in each, since e is of one pair of materials."""
    together: dict[str, list[Track]] = {}
    for track in tracks:
        together.setdefault(track.trial, []).append(track)
    trials, faults = [], []
    notes: list[str] = []
    for group in together.values():
        try:
            trials.append(_trial(tuple(group), notes))
        except _NoImpactError as error:
            faults.append(_fault(group[0], str(error)))
    pairs = sum(len(trial.tracks) == 2 for trial in trials)
    usual = 2 if 2 * pairs >= len(trials) else 1
    for trial in trials:
        if len(trial.tracks) != usual:
            number = ("one body", "two bodies")[len(trial.tracks) - 1]
            other = ("one", "two")[usual - 1]
            rule = f"{number}, and most trials have {other}; put them into a table of their own"
            faults.append(_fault(trial.tracks[0], rule))
    return [trial for trial in trials if len(trial.tracks) == usual], faults, notes


def _fault(track: Track, rule: str) -> Fault:
    name = f"trial {track.trial}: " if track.trial else ""
    return Fault(track.positions[0].line, "", "", f"{name}{rule}")


def _named(track: Track) -> str:
    return track.body or "the body"


def _trial(group: tuple[Track, ...], notes: list[str]) -> Trial:
    """The first impact of one trial. Raises _NoImpactError."""
    if len(group) > 2:
        names = ", ".join(_named(track) for track in group[:6])
        raise _NoImpactError(f"{len(group)} bodies, {names}: an impact has one, or two")
    parted = [without_jumps(_path(track)) for track in group]
    paths, jumps = tuple(path for path, _ in parted), tuple(path for _, path in parted)
    for track, path in zip(group, paths):
        if len(path) < 2 * LEAST:
            raise _NoImpactError(
                f"{_named(track)} has {counted(len(path), 'position')}: it takes three before the "
                "impact and three after"
            )
        if float(np.ptp(path.t)) > _LONGEST * float(np.median(np.diff(path.t))):
            raise _NoImpactError(
                f"the times of {_named(track)} go from {path.t[0]:.4g} s to {path.t[-1]:.4g} s, "
                "much longer than its frames: one of them is wrong"
            )
        if float(np.ptp(path.xy, axis=0).max()) <= 1e-12 * float(np.abs(path.xy).max()):
            raise _NoImpactError(f"{_named(track)} stands still")
    kink, outliers, others = _kink(group, paths)
    name = f"trial {group[0].trial}" if group[0].trial else "the track"
    if others:
        notes.append(
            f"{name}: the velocity changes {others + 1} times; used is the first time that may be "
            f"the impact, t = {kink.t:.4g} s, with what lies between its neighbours"
        )
    notes += _left_out(name, kink, jumps, outliers)
    if not kink.meeting:
        notes.append(
            f"{name}: the lines before and after do not meet, so each is fitted alone; the contact "
            "lasted, or frames are missing"
        )
    return Trial(group, kink)


_LONGEST = 1e6
"""Frames from the first position to the last."""


def _path(track: Track) -> Path:
    rows = np.array([(position.t, position.x, position.y) for position in track.positions])
    lines = np.array([position.line for position in track.positions], dtype=np.int64)
    return Path(rows[:, 0], rows[:, 1:], lines)


def _kink(group: tuple[Track, ...], paths: Paths) -> tuple[Kink, Paths, int]:
    """The kink, the positions left out, and how many other kinks there are."""
    for _ in range(3):
        times = breaks(paths)
        if not times:
            raise _NoImpactError(_no_kink(group))
        chosen = first_impact(paths, times)
        if chosen is None:
            raise _NoImpactError(
                f"{_named(group[0])} is faster after t = {times[0]:.4g} s than before, as where it "
                "is pushed or let go: no impact is seen"
            )
        tau, begin, end = chosen
        first = best_kink(tuple(path.between(begin, end) for path in paths))
        if first is None:
            raise _NoImpactError(f"too few positions on one side of the impact at t = {tau:.4g} s")
        kink, outliers = without_outliers(first)
        if len(times) == 1 or not any(map(len, outliers)):
            break
        # What is far off may have been taken for a kink: look again without it.
        paths = tuple(_without(path, outlying) for path, outlying in zip(paths, outliers))
    kink = opened(kink)
    _require_change(group, kink)
    return kink, outliers, _others(paths, times, kink)


def _without(path: Path, outliers: Path) -> Path:
    return path.only(~np.isin(path.lines, outliers.lines))


def _others(paths: Paths, times: tuple[float, ...], kink: Kink) -> int:
    """How many other kinks are impacts: those that change a velocity by a fifth as much or more."""
    size = float(np.linalg.norm(kink.after - kink.before, axis=1).max())
    ends = [-math.inf, *times, math.inf]
    number = 0
    for low, high in zip(ends[:-2], ends[2:]):
        other = best_kink(tuple(path.between(low, high) for path in paths))
        if other is not None:
            change = float(np.linalg.norm(other.after - other.before, axis=1).max())
            number += change > 0.2 * size
    return max(number - 1, 0)


def _no_kink(group: tuple[Track, ...]) -> str:
    names = " and ".join(_named(track) for track in group)
    verb = "moves" if len(group) == 1 else "move"
    return f"{names} {verb} on without a kink: no impact is seen"


def _require_change(group: tuple[Track, ...], kink: Kink) -> None:
    """Raises _NoImpactError where a body does not take part."""
    sigma = math.sqrt(kink.sum_of_squares / max(kink.freedom, 1))
    covariance = kink.covariance()
    for body, track in enumerate(group):
        change = kink.after[body] - kink.before[body]
        block = covariance[4 * body : 4 * body + 4, 4 * body : 4 * body + 4]
        own = block[:2, :2] + block[2:, 2:] - block[:2, 2:] - block[2:, :2]
        error = sigma * math.sqrt(float(np.linalg.eigvalsh(own)[-1]))
        if float(np.linalg.norm(change)) <= max(_CHANGED * error, 1e-9):
            raise _NoImpactError(
                f"{_named(track)} does not change its velocity at t = {kink.t:.4g} s, when the "
                "other does: no impact of the two is seen"
                if len(group) == 2
                else f"{_named(track)} moves on without a kink: no impact is seen"
            )


_CHANGED = 4


def _left_out(name: str, kink: Kink, jumps: Paths, outliers: Paths) -> list[str]:
    notes = []
    for path, jumped, other in zip(kink.paths, jumps, outliers):
        frame = float(np.median(np.diff(path.t)))
        near = np.abs(other.t - kink.t) <= 2 * frame
        touching = sorted(map(int, other.lines[near]))
        far = sorted(map(int, [*jumped.lines, *other.lines[~near]]))
        for lines, why in (
            (touching, "next to the impact, lie on neither line: the bodies touch there"),
            (far, "lie far from the path"),
        ):
            if lines:
                shown = ", ".join(map(str, lines[:5])) + (", …" if len(lines) > 5 else "")
                notes.append(f"{name}: left out are positions that {why} (line {shown})")
    return notes


# --- errors, and slowing down -----------------------------------------------------------------


def _slowing(trials: list[Trial], unit: str) -> tuple[Pattern | Untested, float, float]:
    """The test of a deceleration; the rate to be used, and its variance, 0 where none is seen."""
    rates = [deceleration(trial.kink) for trial in trials]
    variances, freedom, _ = _variances(trials, more=1)
    rows = [(*rate, variance) for rate, variance in zip(rates, variances) if rate is not None]
    if not rows or not freedom:
        reason = "Untested: the positions lie on straight lines exactly."
        return Untested("slowing", reason), 0.0, 0.0
    values, variances_of_rates = np.array([(rate, own * number) for rate, own, number in rows]).T
    weights = 1 / variances_of_rates
    mean, error = float(weights @ values / weights.sum()), float(weights.sum() ** -0.5)
    p = 2 * upper_tail(abs(mean) / error, freedom)
    used = p < _SLOWING
    unit = f" {unit}/s²"
    corrected = (
        "The velocities are taken at the impact, with it."
        if used
        else "The velocities are taken without it."
    )
    size = with_error(abs(mean), error, unit)
    why = (
        "rolling friction, or a table that is not level"
        if mean > 0
        else "a table that is not level, or a scale that changes across the picture"
    )
    seen = (
        f"The bodies {'slow down' if mean > 0 else 'speed up'} on their way, by {size} "
        f"({probability(p)}): {why}. {corrected}"
    )
    not_seen = (
        f"The bodies do not slow down on their way: {with_error(mean, error, unit)} "
        f"({probability(p)})." + (f" {corrected}" if used else "")
    )
    pattern = Pattern("slowing", mean / error, p, seen, not_seen, mean, error, unit.strip())
    return pattern, mean if used else 0.0, error**2 if used else 0.0


_SLOWING = 0.01
"""The level at which a deceleration is used."""


def _variances(trials: list[Trial], more: int = 0) -> tuple[list[float], int, list[str]]:
    """The variance of one coordinate in each trial, its degrees of freedom, and notes.

    ``more`` are parameters in each trial beside those of the kink. The degrees of freedom are 0
    where the positions lie on the lines exactly.
    """
    squares = np.array([trial.kink.sum_of_squares for trial in trials])
    freedoms = np.array([max(trial.kink.freedom - more, 1) for trial in trials])
    sizes = [float(np.ptp(path.xy, axis=0).max()) for trial in trials for path in trial.kink.paths]
    pooled = float(squares.sum() / freedoms.sum())
    if pooled <= (1e-8 * max(sizes)) ** 2:
        return [1.0] * len(trials), 0, []
    own = np.maximum(squares / freedoms, 1e-4 * pooled)
    if _alike(own, freedoms, pooled):
        return [pooled] * len(trials), int(freedoms.sum()), []
    note = "the positions scatter more in some trials than in others, so each has its own error"
    return [*map(float, own)], int(freedoms.min()), [note]


def _alike(own: Array, freedoms: Array, pooled: float) -> bool:
    """Whether variances are the same but for chance (M. S. Bartlett, 1937)."""
    if len(own) < 2:
        return True
    total = float(freedoms.sum())
    excess = float((1 / freedoms).sum()) - 1 / total
    statistic = total * math.log(pooled) - float(freedoms @ np.log(own))
    scaled = statistic / (1 + excess / (3 * (len(own) - 1)))
    return upper_tail_of_squares(scaled, len(own) - 1, None) > _UNLIKE


_UNLIKE = 1e-3


# --- impacts and lines ------------------------------------------------------------------------


def _of_two(covariance: Array) -> Array:
    """The covariance of two bodies, of which B has none where it is a wall."""
    result = np.zeros((8, 8))
    result[: len(covariance), : len(covariance)] = covariance
    return result


_AT_REST = Velocity(Measured(0.0, 0.0), Measured(0.0, 0.0))


def _impact(trial: Trial) -> SpheresTrial:
    """The impact of two bodies; a wall is B, with its normal as the line of centres."""
    bodies = [
        MeasuredSphere(_velocity(before), _velocity(after), track.m)
        for before, after, track in zip(trial.kink.before, trial.kink.after, trial.tracks)
    ]
    if len(bodies) == 1:
        bodies.append(MeasuredSphere(_AT_REST, _AT_REST))
    walls = [track.wall for track in trial.tracks if track.wall is not None]
    line = Measured(walls[0] + 90) if walls else None
    first = trial.tracks[0]
    return SpheresTrial(first.positions[0].line, bodies[0], bodies[1], line, first.trial)


def _velocity(components: Array) -> Velocity:
    return Velocity(Measured(float(components[0])), Measured(float(components[1])))


def _fitted(
    trials: list[Trial], spheres: Spheres, variances: list[float], covariances: list[Array]
) -> tuple[FittedTrack, ...]:
    normals = {impact.trial.line: impact.n for impact in spheres.impacts}
    result = []
    for trial, variance, covariance in zip(trials, variances, covariances):
        n = normals.get(trial.tracks[0].positions[0].line)
        if n is None:
            continue
        wall = math.degrees(math.atan2(n[1], n[0]) + math.pi / 2) % 180
        kink = trial.kink
        for body, track in enumerate(trial.tracks):
            blocks = [covariance[i : i + 2, i : i + 2] for i in (4 * body, 4 * body + 2)]
            errors = [math.sqrt(float(np.trace(block)) / 2) for block in blocks]
            times = kink.paths[body].t
            result.append(
                FittedTrack(
                    track.trial,
                    track.body,
                    _line(kink, body, float(times[0]), kink.before[body], errors[0]),
                    _line(kink, body, float(times[-1]), kink.after[body], errors[1]),
                    kink.t,
                    float(kink.places[body, 0]),
                    float(kink.places[body, 1]),
                    math.sqrt(variance),
                    wall,
                )
            )
    return tuple(result)


def _line(kink: Kink, body: int, t: float, velocity: Array, error: float) -> StraightLine:
    x, y = kink.places[body] + (t - kink.t) * velocity
    return StraightLine(t, float(x), float(y), float(velocity[0]), float(velocity[1]), error)
