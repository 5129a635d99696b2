"""Worked solutions: Solution → steps → text, Markdown, LaTeX, HTML."""

from __future__ import annotations

from restitution.explain.html import to_html
from restitution.explain.illustrate import illustrated
from restitution.explain.markup import to_latex, to_markdown
from restitution.explain.route import explain
from restitution.explain.steps import Explanation, PartExplanation, Row, Step
from restitution.explain.text import to_text

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
