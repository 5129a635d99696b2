"""An experiment as a report on paper-ready sheets."""

from __future__ import annotations

from html import escape
from typing import Literal

from restitution.errors import UnsupportedError
from restitution.experiments.results import Experiment


def report(experiment: Experiment, form: Literal["html", "pdf"]) -> bytes:
    """The words of an experiment as a page. Raises UnsupportedError for a PDF."""
    if form == "pdf":
        raise UnsupportedError("a report is not made as PDF yet: take .html, and print it")
    title = "<!doctype html><html lang=en><meta charset=utf-8><title>Experiment</title>"
    return f"{title}<pre>{escape(experiment.text())}</pre></html>\n".encode()
