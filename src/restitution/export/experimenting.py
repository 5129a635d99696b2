"""An experiment as a page asks for it: the result as data, in words, and in pictures."""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree as ET

from restitution.errors import UnsupportedError
from restitution.experiments import experiment
from restitution.experiments.numbers import with_error
from restitution.experiments.records import Kind
from restitution.experiments.texts import class_words, error_sentence, interval_sentence
from restitution.experiments.whole import Experiment

Object = dict[str, Any]


def experiment_of(
    data: str,
    kind: Kind | None,
    angle_error: float | None,
    speed_error: float | None,
    from_normal: bool,
) -> Experiment:
    """The result of a table in CSV, or as it is copied from a spreadsheet.

    Raises StatementError, MissingError and UnsupportedError, as `restitution.experiment` does.
    """
    return experiment(
        data,
        kind=kind,
        angle_error=angle_error,
        speed_error=speed_error,
        from_normal=from_normal,
    )


def shown(result: Experiment) -> Object:
    """The result as a page shows it.

    The keys of `Experiment.data`, and beside them::

        {"words": ["e = 0.70 ± 0.02", "With 95% confidence …", "The errors are …"],
         "class_words": [the mean of the ratios, the slope, e of the fit],
         "pictures": [{"title", "description", "svg"}], "pictures_error": null or a sentence}
    """
    words = [
        f"e = {with_error(result.e, result.standard_error)}",
        interval_sentence(result.interval, result.standard_error),
        error_sentence(result),
    ]
    beside = {"words": words, "class_words": class_words(result)}
    return {**result.data(), **beside, **_pictures(result)}


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
        "pictures": [_picture(picture) for picture in (*plots, *tracks) if picture],
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
