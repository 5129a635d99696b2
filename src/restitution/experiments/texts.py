"""An experiment as text for a terminal."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator

from restitution.counting import counted
from restitution.experiments.numbers import decimals, fixed, with_error
from restitution.experiments.records import Kind
from restitution.experiments.results import ExperimentContent, Interval, Point, StraightLine

TITLES: dict[Kind, str] = {
    "wall": "Impacts with a wall",
    "spheres": "Impacts of two spheres",
    "tracks": "Impacts from tracks",
}
MAX_POINTS = 30
"""Rows of the table of readings; more are counted."""
MAX_FAULTS = 10
MAX_NOTES = 20


def written(experiment: ExperimentContent, width: int) -> str:
    """The value of e, the readings, what a class computes, and the check of the model."""
    blocks = [
        _heading(experiment),
        _result(experiment, width),
        _tracks(experiment),
        _readings(experiment),
        _class(experiment, width),
        _checks(experiment, width),
        _notes(experiment, width),
    ]
    return "\n\n".join("\n".join(block) for block in map(list, blocks) if block) + "\n"


def _heading(experiment: ExperimentContent) -> Iterator[str]:
    yield f"{TITLES[experiment.kind]}: {counted(len(experiment.points), 'trial')}"


def _result(experiment: ExperimentContent, width: int) -> Iterator[str]:
    yield f"  e = {with_error(experiment.e, experiment.standard_error)}"
    yield from _wrapped(interval_sentence(experiment.interval, experiment.standard_error), width)
    yield from _wrapped(error_sentence(experiment), width)


def interval_sentence(interval: Interval, error: float) -> str:
    """Where e lies, in words."""
    places = decimals(error)
    level = f"{100 * interval.level:.0f}%"
    if interval.possible is None:
        return f"The interval of {level} lies outside 0 to 1: see the check of the model."
    low, high = (fixed(number, places) for number in interval.possible)
    return f"With {level} confidence e lies from {low} to {high}."


def error_sentence(experiment: ExperimentContent) -> str:
    """From where the errors of the readings are."""
    if experiment.kind == "tracks":
        return "The errors are from the scatter of the positions about straight lines."
    size = _size_of_error(experiment)
    if experiment.error_source == "scatter":
        return f"The errors are estimated from the scatter about the law{size}."
    return f"The errors are those that were given{size}."


def _size_of_error(experiment: ExperimentContent) -> str:
    if experiment.angle_error is not None:
        return f": {experiment.angle_error:.2g}° for an angle"
    if experiment.speed_error is not None:
        error, unit = experiment.speed_error, experiment.speed_unit
        return f": {error:.2g} {unit} for a component of a velocity"
    return ""


# --- readings ---------------------------------------------------------------------------------


def _readings(experiment: ExperimentContent) -> Iterator[str]:
    points = experiment.points
    name, width = _place_column([point.label for point in points])
    unit = experiment.speed_unit
    if points[0].alpha is None:
        yield f"  {name}   approach  separation   ratio   distance from the law"
    else:
        yield f"  {name}       α        β     tan α    tan β   tan β/tan α   distance from the law"
    for point in points[:MAX_POINTS]:
        yield _row(point, width)
    if len(points) > MAX_POINTS:
        yield f"  … and {len(points) - MAX_POINTS} more"
    if points[0].alpha is None:
        yield f"  (speeds along the line of the impulse, in {unit})"
    yield "  (distance from the law: in standard errors; more than 3 is rare)"


def _place_column(labels: list[str]) -> tuple[str, int]:
    """The head of the column that names readings, and its width."""
    if not any(labels):
        return "line", 4
    width = max(len("trial"), *(len(label[:MAX_LABEL]) for label in labels))
    return f"{'trial':>{width}}", width


MAX_LABEL = 12


def _row(point: Point, width: int) -> str:
    place = point.label[:MAX_LABEL] or str(point.line)
    ratio = _number(point.y / point.x, 3) if point.x else "–"
    distance = f"{fixed(point.residual, 1):>6}"
    if point.alpha is None or point.beta is None:
        shown = f"{point.x:>9.4g}  {point.y:>10.4g}   {ratio:>5}"
        return f"  {place:>{width}}  {shown}   {distance}"
    angles = f"{fixed(point.alpha, 1):>6}°  {fixed(point.beta, 1):>6}°"
    tangents = f"{_number(point.x, 3):>8} {_number(point.y, 3):>8}"
    return f"  {place:>{width}}  {angles}  {tangents}   {ratio:>11}   {distance}"


def _tracks(experiment: ExperimentContent) -> Iterator[str]:
    """The time of the impact in each track, and the speeds before and after."""
    tracks = experiment.tracks
    if not tracks:
        return
    unit = experiment.speed_unit
    yield f"Straight lines, uniform in time (speeds in {unit}, directions in degrees from x)"
    name, width = _place_column([track.trial for track in tracks])
    names = [track.body[:MAX_LABEL] for track in tracks]
    bodies = max(len("body"), *map(len, names)) + 2 if any(names) else 0
    head = f"  {name}  {'body' if bodies else '':<{bodies}}impact at"
    yield f"{head}      speed before   →      speed after   →"
    for track, body in zip(tracks[:MAX_POINTS], names):
        sides = "  ".join(_side(line) for line in (track.before, track.after))
        place = f"  {track.trial[:MAX_LABEL] or '–':>{width}}  {body:<{bodies}}"
        yield f"{place}{track.t:>7.4g} s  {sides}"
    if len(tracks) > MAX_POINTS:
        yield f"  … and {len(tracks) - MAX_POINTS} more"


def _side(line: StraightLine) -> str:
    speed = math.hypot(line.velocity_x, line.velocity_y)
    size = with_error(speed, line.velocity_error)
    if speed < 3 * line.velocity_error:
        return f"{size:>16} {'–':>5}"
    direction = math.degrees(math.atan2(line.velocity_y, line.velocity_x))
    return f"{size:>16} {fixed(direction, 0) + '°':>5}"


def _number(value: float, places: int) -> str:
    return fixed(value, places) if abs(value) < 1000 else "large"


# --- what stands beside -----------------------------------------------------------------------


def class_words(experiment: ExperimentContent) -> tuple[str, str, str]:
    """The mean of the ratios, the slope of the line, and e of the fit, as they are printed."""
    values = experiment.class_values
    return (
        with_error(values.mean_ratio, values.mean_ratio_error),
        with_error(values.slope, None),
        with_error(experiment.e, experiment.standard_error),
    )


def _class(experiment: ExperimentContent, width: int) -> Iterator[str]:
    walls = experiment.points[0].alpha is not None
    mean, slope, fit = class_words(experiment)
    ratio = "tan β / tan α" if walls else "separation / approach"
    yield "What a class computes"
    rows = {
        f"mean of {ratio}": mean,
        "slope of the line through the origin": slope,
        "fit with errors in both (above)": fit,
    }
    longest = max(map(len, rows))
    for name, value in rows.items():
        yield f"  {name:<{longest}}   {value}"
    yield from _wrapped(experiment.class_values.why, width)


def _checks(experiment: ExperimentContent, width: int) -> Iterator[str]:
    yield "Check of the model"
    for check in experiment.checks:
        sign = {"seen": "!", "not seen": " ", "untested": "?"}[check.verdict]
        verdict = check.verdict.upper() if check.verdict == "seen" else check.verdict
        yield f"{sign} {check.title}: {verdict}"
        yield from _wrapped(check.sentence.removeprefix("Untested: "), width, "      ")


def _notes(experiment: ExperimentContent, width: int) -> Iterator[str]:
    faults = experiment.table.faults
    if faults:
        yield f"Left out: {counted(len(faults), 'row')}"
        for fault in faults[:MAX_FAULTS]:
            yield from _wrapped(str(fault), width)
        if len(faults) > MAX_FAULTS:
            yield f"  … and {len(faults) - MAX_FAULTS} more"
    if experiment.notes:
        yield "Notes"
        for note in experiment.notes[:MAX_NOTES]:
            yield from _wrapped(note, width, "  ")
        if len(experiment.notes) > MAX_NOTES:
            yield f"  … and {len(experiment.notes) - MAX_NOTES} more"


def _wrapped(text: str, width: int, indent: str = "  ") -> list[str]:
    return textwrap.wrap(text, width, initial_indent=indent, subsequent_indent=indent)
