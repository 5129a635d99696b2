"""Table → experiment: the fit of its kind, with all that stands beside it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from restitution.errors import MissingError
from restitution.experiments import spheres, tracks, walls
from restitution.experiments.numbers import fixed, percent
from restitution.experiments.patterns import (
    TITLES_OF_SPHERES,
    TITLES_OF_TRACKS,
    TITLES_OF_TWO_TRACKS,
    Pattern,
    Untested,
    decided,
)
from restitution.experiments.records import Fault, Table
from restitution.experiments.results import Interval
from restitution.experiments.samples import LEVEL, Sample
from restitution.experiments.spheres import Spheres
from restitution.experiments.tracks import Tracks
from restitution.experiments.walls import Wall
from restitution.experiments.whole import Experiment


def analysed(table: Table) -> Experiment:
    """The experiment of a table.

    Raises MissingError where the data do not determine e, with the rows that were left out, and
    UnsupportedError where the extra "experiment" is not installed.
    """
    try:
        return _of_kind(table)
    except MissingError as error:
        raise _with_faults(error, table.faults) from None


def _with_faults(error: MissingError, faults: tuple[Fault, ...]) -> MissingError:
    if not faults:
        return error
    first = str(faults[0])
    rest = f", and {len(faults) - 1} more" if len(faults) > 1 else ""
    return MissingError(f"{error.message} (left out: {first}{rest})", error.line)


def _of_kind(table: Table) -> Experiment:
    if table.kind == "wall":
        return _of_wall(table, walls.wall_of(table.readings, table.units.get("u", "m/s")))
    if table.kind == "spheres":
        unit = table.units.get("u_A", table.units.get("u_A_x", "m/s"))
        return _of_spheres(table, spheres.spheres_of(table.trials, unit))
    return _of_tracks(table, tracks.tracks_of(table))


def _of_wall(table: Table, wall: Wall) -> Experiment:
    sample = wall.sample
    interval = interval_of(sample, _BETTER_ANGLES)
    return Experiment(
        table.kind,
        table,
        sample.e,
        sample.standard_error,
        interval,
        "given" if sample.known else "scatter",
        _angle_error(sample),
        walls.class_values(wall),
        walls.points(wall),
        decided(walls.patterns(wall)),
        notes=(*table.notes, *wall.notes, *notes_on(sample, interval)),
    )


def _of_spheres(
    table: Table,
    measured: Spheres,
    titles: Mapping[str, str] = TITLES_OF_SPHERES,
    more: tuple[Pattern | Untested, ...] = (),
) -> Experiment:
    sample = measured.sample
    interval = interval_of(sample, _BETTER_SPEEDS)
    return Experiment(
        table.kind,
        replace(table, faults=(*table.faults, *measured.faults)),
        sample.e,
        sample.standard_error,
        interval,
        "given" if sample.known else "scatter",
        None,
        spheres.class_values(measured),
        spheres.points(measured),
        decided([*spheres.patterns(measured), *more], titles),
        notes=(*table.notes, *measured.notes, *notes_on(sample, interval)),
        speed_error=spheres.component_error(measured),
    )


def _of_tracks(table: Table, measured: Tracks) -> Experiment:
    impacts = measured.spheres
    titles = TITLES_OF_TWO_TRACKS if impacts.words.masses else TITLES_OF_TRACKS
    table = replace(table, faults=(*table.faults, *measured.faults))
    experiment = _of_spheres(table, impacts, titles, (measured.slowing,))
    notes = (*measured.notes, *experiment.notes)
    return replace(experiment, tracks=measured.fitted, notes=notes)


_BETTER_ANGLES = "measure more of them, more exactly, or at angles nearer to 45°"
_BETTER_SPEEDS = "measure more of them, more exactly, or more nearly head-on"


def interval_of(sample: Sample, advice: str) -> Interval:
    """The interval of e. Raises MissingError, with advice, where all of 0 to 1 is left."""
    low, high = sample.interval
    least, most = max(low, 0.0), min(high, 1.0)
    if most - least > _NOTHING:
        raise MissingError(
            f"these readings do not determine e: anything from {fixed(least, 2)} to "
            f"{fixed(most, 2)} fits them; {advice}"
        )
    return Interval(low, high, LEVEL, _method(sample))


_NOTHING = 0.95
"""An interval of this width, within 0 to 1, is no value of e."""


def _method(sample: Sample) -> str:
    if sample.known and sample.freedom is None:
        return "profile likelihood, with the errors that were given"
    freedom = sample.freedom if sample.known else sample.fit.degrees_of_freedom
    source = "the tracks" if sample.known else "the scatter"
    return f"profile likelihood, with errors from {source} ({freedom} degrees of freedom)"


def _angle_error(sample: Sample) -> float | None:
    variances = [*sample.readings.x_variance, *sample.readings.y_variance]
    if max(variances) > min(variances) * (1 + 1e-9):
        return None
    return math.degrees(math.sqrt(variances[0])) * sample.factor


def notes_on(sample: Sample, interval: Interval) -> list[str]:
    """What is to be said where e is near 0 or 1, or where there is no scatter."""
    notes = []
    if sample.exact:
        notes.append(
            "the readings lie on the law exactly, as measured ones hardly do; so their scatter "
            "gives no error: give the error of a reading"
        )
    if sample.e > 1:
        notes.append(
            f"e comes out as {fixed(sample.e, 3)}, above 1, which no impact has; the value is not "
            "moved to 1, so that it can be compared"
        )
    if sample.e < 0:
        notes.append(f"e comes out as {fixed(sample.e, 3)}, below 0, which no impact has")
    if interval.possible is None:
        notes.append(f"the whole interval of {percent(LEVEL)} lies outside 0 to 1")
    elif interval.low < 0 or interval.high > 1:
        notes.append(
            f"the calculation gives {_end(interval.low)} to {_end(interval.high)}; e itself is "
            "never outside 0 to 1, and only that part of the interval is shown"
        )
    return notes


def _end(value: float) -> str:
    return fixed(value, 3) if math.isfinite(value) else "any value"
