"""A picture as PNG or PDF, which typst makes of its SVG."""

from __future__ import annotations

from typing import Literal

from restitution.errors import UnsupportedError
from restitution.render.typst import literal

MISSING_TYPST = "{form} needs typst: pip install 'restitution[pdf]', or take SVG"
SHARPNESS = 300.0
"""Pixels to an inch, for print."""


def converted(svg: str, form: Literal["png", "pdf"], sharpness: float = SHARPNESS) -> bytes:
    """A picture as PNG on white, or as PDF; the same bytes for the same picture.

    ``sharpness`` is in pixels to an inch. Raises UnsupportedError where typst is not installed.
    """
    try:
        import typst
    except ImportError:
        raise UnsupportedError(MISSING_TYPST.format(form=form.upper())) from None
    source = (
        "#set document(date: none)\n"
        "#set page(width: auto, height: auto, margin: 2mm, fill: white)\n"
        f'#image(bytes({literal(svg)}), format: "svg")\n'
    )
    made = typst.compile(source.encode(), format=form, ppi=sharpness, ignore_system_fonts=True)
    return bytes(made)
