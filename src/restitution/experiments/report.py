"""An experiment as a report on A4: the value, pictures, the check of the model, all readings."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Literal

from restitution.counting import counted
from restitution.drawing.svg import abreast
from restitution.experiments.formulas import ALPHA, BETA, RATIO, TAN_ALPHA, TAN_BETA, E
from restitution.experiments.numbers import fixed, with_error
from restitution.experiments.plots import is_of_walls, law_plot, residual_plot, speed_plot
from restitution.experiments.results import Check, Point
from restitution.experiments.texts import TITLES, class_words, error_sentence, interval_sentence
from restitution.experiments.track_scenes import track_scenes
from restitution.experiments.whole import Experiment
from restitution.render.document import (
    Block,
    Document,
    Heading,
    Inline,
    Item,
    Listing,
    Paragraph,
    Picture,
    Table,
)

MOST_ROWS = 500
"""Readings that are printed; more are counted."""
MOST_PICTURES = 12
"""Trials of which the tracks are drawn."""

_LAW, _OTHER = 125.0, 120.0  # widths of the plots, in millimetres
_ONE, _TWO = 84.0, 168.0  # of tracks, one or two beside each other


def report(experiment: Experiment, form: Literal["html", "pdf"]) -> bytes:
    """The report as one page of HTML or as a PDF of A4 pages; the same bytes for the same result.

    Raises UnsupportedError where Matplotlib, or typst for a PDF, is not installed.
    """
    document = document_of(experiment)
    if form == "pdf":
        from restitution.render.document.typst import to_pdf

        return to_pdf(document)
    from restitution.render.document.html import to_html

    return to_html(document).encode()


def document_of(experiment: Experiment) -> Document:
    """The report as a document. Raises UnsupportedError where Matplotlib is not installed."""
    blocks = [
        *_result(experiment),
        *_checks(experiment),
        *_class(experiment),
        *_plots(experiment),
        *_tracks(experiment),
        *_readings(experiment),
        *_left_out(experiment),
        *_notes(experiment),
    ]
    return Document(TITLES[experiment.kind], tuple(blocks))


def _result(experiment: Experiment) -> Iterator[Block]:
    interval, error = experiment.interval, experiment.standard_error
    result = with_error(experiment.e, error)
    yield Paragraph(("Coefficient of restitution ", E, f" = {result}"), "result")
    count = counted(len(experiment.points), "reading")
    left_out = len(experiment.table.faults)
    beside = f", {counted(left_out, 'row')} left out" if left_out else ""
    yield Paragraph(
        f"From {count}{beside}. {interval_sentence(interval, error)} {error_sentence(experiment)}"
    )
    yield Picture(law_plot(experiment), _LAW)


def _plots(experiment: Experiment) -> Iterator[Block]:
    yield Heading("Distances from the fit")
    yield Picture(residual_plot(experiment), _OTHER)
    speeds = speed_plot(experiment)
    if speeds is not None:
        yield Heading("e and speed")
        yield Picture(speeds, _OTHER)


def _tracks(experiment: Experiment) -> Iterator[Block]:
    scenes = track_scenes(experiment)
    if scenes:
        yield Heading("Tracks")
    for index in range(0, min(len(scenes), MOST_PICTURES), 2):
        two = scenes[index : index + 2]
        width = _TWO if len(two) == 2 else _ONE
        yield Picture(abreast(two, [scene.title for scene in two]), width)
    if len(scenes) > MOST_PICTURES:
        yield Paragraph(f"{len(scenes) - MOST_PICTURES} more trials are not drawn.", "remark")


# --- words ------------------------------------------------------------------------------------


def _checks(experiment: Experiment) -> Iterator[Block]:
    yield Heading("Check of the model")
    rows = tuple((check.title, _verdict(check), _sentence(check)) for check in experiment.checks)
    yield Table(("pattern", "verdict", "what the readings say"), rows, "lcl")


def _verdict(check: Check) -> str:
    return check.verdict.upper() if check.verdict == "seen" else check.verdict


def _sentence(check: Check) -> str:
    reason = check.sentence.removeprefix("Untested: ")
    return check.sentence if reason == check.sentence else _capital(reason)


def _class(experiment: Experiment) -> Iterator[Block]:
    mean, slope, fit = class_words(experiment)
    ratio: Inline = RATIO if is_of_walls(experiment) else "separation / approach"
    yield Heading("What a class computes")
    yield Table(
        ("", "value"),
        (
            (_joined("mean of ", ratio), mean),
            ("slope of the line through the origin", slope),
            ("fit with errors in both", fit),
        ),
        "lr",
        narrow=True,
    )
    yield Paragraph(experiment.class_values.why)


def _notes(experiment: Experiment) -> Iterator[Block]:
    yield Heading("Notes")
    method = experiment.interval.method
    words = [f"The interval: {method}", *experiment.notes]
    yield Listing(tuple(Item(_full_sentence(word)) for word in words if word))


def _full_sentence(words: str) -> str:
    return _capital(words) + ("" if words.endswith(".") else ".")


def _capital(words: str) -> str:
    """Words as a sentence begins, unless with a letter that stands for a quantity."""
    return words if words[1:2] == " " else words[:1].upper() + words[1:]


# --- tables -----------------------------------------------------------------------------------


def _readings(experiment: Experiment) -> Iterator[Block]:
    yield Heading("Readings")
    points = experiment.points[:MOST_ROWS]
    columns = list(_columns(experiment))
    rows = tuple(tuple(cell(point) for _, cell in columns) for point in points)
    yield Table(tuple(head for head, _ in columns), rows, "r" * len(columns))
    if len(experiment.points) > MOST_ROWS:
        more = len(experiment.points) - MOST_ROWS
        yield Paragraph(f"{more} more are not printed.", "remark")
    far = "The distance is that from the fit, in standard errors; more than 3 is rare."
    yield Paragraph(far, "remark")


_Cell = Callable[[Point], str]


def _columns(experiment: Experiment) -> Iterator[tuple[Inline, _Cell]]:
    """The heads of the table of readings, each with what it says of one."""
    yield "line", lambda point: str(point.line)
    points = experiment.points
    if any(point.label for point in points):
        yield "trial", lambda point: point.label
    if is_of_walls(experiment):
        yield ALPHA, lambda point: _number(point.alpha, 1, "°")
        yield BETA, lambda point: _number(point.beta, 1, "°")
        yield TAN_ALPHA, lambda point: _number(point.x)
        yield TAN_BETA, lambda point: _number(point.y)
        yield RATIO, _ratio
    else:
        yield "approach", lambda point: _number(point.x)
        yield "separation", lambda point: _number(point.y)
        yield "ratio", _ratio
    if any(point.speed is not None for point in points):
        yield "speed", lambda point: _number(point.speed)
    yield "distance", lambda point: _number(point.residual, 1)


def _ratio(point: Point) -> str:
    return _number(point.y / point.x if point.x else None)


def _number(value: float | None, places: int = 3, unit: str = "") -> str:
    if value is None or not math.isfinite(value):
        return "–"
    return "large" if abs(value) >= 1000 else f"{fixed(value, places)}{unit}"


def _left_out(experiment: Experiment) -> Iterator[Block]:
    faults = experiment.table.faults
    if not faults:
        return
    yield Heading("Left out")
    rows = tuple(
        (str(fault.line), fault.column, fault.value, fault.rule) for fault in faults[:MOST_ROWS]
    )
    yield Table(("line", "column", "value", "why"), rows, "rlll")
    if len(faults) > MOST_ROWS:
        yield Paragraph(f"{len(faults) - MOST_ROWS} more are not printed.", "remark")


def _joined(words: str, rest: Inline) -> Inline:
    return (words, *rest) if isinstance(rest, tuple) else (words, rest)
