"""Worked solutions: Solution → steps → text, Markdown, LaTeX, HTML."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from restitution.workings.explanation import Explanation
from restitution.workings.route import explain
from restitution.workings.steps import PartExplanation, Row, Step
from restitution.workings.text import to_text

if TYPE_CHECKING:
    from restitution.workings.html import to_html as to_html
    from restitution.workings.illustrate import illustrated as illustrated
    from restitution.workings.markup import to_latex as to_latex
    from restitution.workings.markup import to_markdown as to_markdown

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

_MODULES = {
    "illustrated": "illustrate",
    "to_html": "html",
    "to_latex": "markup",
    "to_markdown": "markup",
}


def __getattr__(name: str) -> Any:
    # A working as text needs neither pictures nor their glyphs: only when they are wanted.
    if name in _MODULES:
        from importlib import import_module

        return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
