"""A picture as PNG or PDF, which typst makes of its SVG."""

from __future__ import annotations

from typing import Literal

from restitution.render.typst import compiled, literal

SHARPNESS = 300.0
"""Pixels to an inch, for print."""


def converted(svg: str, form: Literal["png", "pdf"], sharpness: float = SHARPNESS) -> bytes:
    """A picture as PNG on white, or as PDF; the same bytes for the same picture.

    ``sharpness`` is in pixels to an inch. Raises UnsupportedError where typst is not installed.
    """
    source = (
        "#set document(date: none)\n"
        "#set page(width: auto, height: auto, margin: 2mm, fill: white)\n"
        f'#image(bytes({literal(svg)}), format: "svg")\n'
    )
    return compiled(source, form, "SVG", sharpness)
