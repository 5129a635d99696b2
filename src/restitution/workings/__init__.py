"""Worked solutions: Solution → steps → a document, and that as text, Markdown, LaTeX, HTML."""

from __future__ import annotations

from restitution.workings.rendering.document import to_html, to_latex, to_markdown, to_text
from restitution.workings.rendering.explanation import Explanation
from restitution.workings.rendering.illustrate import illustrated
from restitution.workings.rendering.steps import PartExplanation, Row, Step
from restitution.workings.route import explain

__all__ = [
    "Explanation",
    "PartExplanation",
    "Row",
    "Step",
    "explain",
    "illustrated",
    "to_html",
    "to_latex",
    "to_markdown",
    "to_text",
]
