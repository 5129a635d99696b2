"""An experiment as a page asks for it: the result as data, in words, and in pictures."""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree as ET

from restitution.errors import StatementError, UnsupportedError
from restitution.experiments import experiment
from restitution.experiments.numbers import with_error
from restitution.experiments.records import KINDS, Kind
from restitution.experiments.results import Experiment
from restitution.experiments.texts import error_sentence, interval_sentence

Object = dict[str, Any]


def experiment_of(
    data: str,
    kind: str | None,
    angle_error: float | None,
    speed_error: float | None,
    from_normal: bool,
) -> Experiment:
    """The result of a table in CSV, or as it is copied from a spreadsheet.

    Raises StatementError, MissingError and UnsupportedError, as `restitution.experiment` does.
    """
    return experiment(
        data,
        kind=_kind(kind),
        angle_error=_error(angle_error, "angle_error"),
        speed_error=_error(speed_error, "speed_error"),
        from_normal=from_normal,
    )


def shown(result: Experiment) -> Object:
    """The result as a page shows it.

    The keys of `Experiment.data`, and beside them::

        {"words": ["e = 0.70 ± 0.02", "With 95% confidence …", "The errors are …"],
         "pictures": [{"title", "description", "svg"}], "pictures_error": null or a sentence}
    """
    words = [
        f"e = {with_error(result.e, result.standard_error)}",
        interval_sentence(result.interval, result.standard_error),
        error_sentence(result),
    ]
    return {**result.data(), "words": words, **_pictures(result)}


def _kind(name: str | None) -> Kind | None:
    for kind in KINDS:
        if kind == name:
            return kind
    if name is not None:
        raise StatementError(f"kind {name[:40]!r}: it is one of {', '.join(KINDS)}")
    return None


def _error(value: float | None, name: str) -> float | None:
    try:
        return None if value is None else float(value)
    except OverflowError:
        raise StatementError(f"{name}: an error is more than 0, and finite") from None


def _pictures(result: Experiment) -> Object:
    """The pictures; or why there are none, which leaves the rest as it is."""
    from restitution.drawing.svg import to_svg
    from restitution.experiments.plots import law_plot, residual_plot, speed_plot
    from restitution.experiments.track_scenes import track_scenes

    try:
        plots = [law_plot(result), residual_plot(result), speed_plot(result)]
        tracks = [to_svg(scene) for scene in track_scenes(result)[:MOST_TRACKS]]
    except UnsupportedError as error:
        return {"pictures": [], "pictures_error": error.message}
    return {
        "pictures": [_picture(each) for each in (*plots, *tracks) if each],
        "pictures_error": None,
    }


MOST_TRACKS = 12
"""Trials whose tracks are drawn."""


def _picture(svg: str) -> Object:
    """A picture with the title and the description that stand in it."""
    root = ET.fromstring(svg)
    words = {name: root.findtext(f"{_SVG}{name}", "") for name in ("title", "desc")}
    return {"title": words["title"], "description": words["desc"], "svg": svg}


_SVG = "{http://www.w3.org/2000/svg}"
