"""Worked solutions: Solution → steps → text, Markdown, LaTeX, HTML."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from restitution.workings.rendering.explanation import Explanation
from restitution.workings.rendering.steps import PartExplanation, Row, Step
from restitution.workings.rendering.text import to_text
from restitution.workings.route import explain

if TYPE_CHECKING:
    from restitution.workings.rendering.html import to_html as to_html
    from restitution.workings.rendering.illustrate import illustrated as illustrated
    from restitution.workings.rendering.markup import to_latex as to_latex
    from restitution.workings.rendering.markup import to_markdown as to_markdown

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
    "illustrated": "rendering.illustrate",
    "to_html": "rendering.html",
    "to_latex": "rendering.markup",
    "to_markdown": "rendering.markup",
}


def __getattr__(name: str) -> Any:
    # A working as text needs neither pictures nor their glyphs: only when they are wanted.
    if name in _MODULES:
        from importlib import import_module

        return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
