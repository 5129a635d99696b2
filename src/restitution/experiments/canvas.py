"""A canvas for plots: Matplotlib in the house's style, and its SVG as the house writes it.

Matplotlib knows no colour that follows the page, so everything is drawn in one ink. Its SVG is then
written anew: styles become presentation attributes, ids begin with a hash of the picture, lengths
are in millimetres, and nothing in it tells of time or place.
"""

from __future__ import annotations

import hashlib
import io
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from html import escape
from typing import Any
from xml.etree import ElementTree as ET

from restitution.drawing.svg import INK, INK_ON_DARK, PAPER_OF_DARK
from restitution.experiments.needs import needed
from restitution.records import dataclass

POINT = 25.4 / 72
"""Of Matplotlib's units, in millimetres."""
TEXT, SMALL = 9.0, 8.0
"""Sizes of letters, in points."""

_LOCK = threading.Lock()  # Matplotlib's settings are shared by the threads of a process
_SETTINGS = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "axes.unicode_minus": True,
    "font.size": TEXT,
    "svg.fonttype": "path",
    "svg.hashsalt": "restitution",
    "path.simplify": False,
    **dict.fromkeys(
        ("text.color", "axes.edgecolor", "axes.labelcolor", "xtick.color", "ytick.color"), INK
    ),
    **dict.fromkeys(("axes.linewidth", "xtick.major.width", "ytick.major.width"), 0.6),
    **dict.fromkeys(("xtick.major.size", "ytick.major.size"), 3.0),
    **dict.fromkeys(("xtick.labelsize", "ytick.labelsize", "legend.fontsize"), SMALL),
}


@dataclass(frozen=True)
class Canvas:
    """A figure of Matplotlib with one pair of axes."""

    figure: Any
    axes: Any


@contextmanager
def canvas(width: float, height: float) -> Iterator[Canvas]:
    """A canvas whose axes have this width and height in millimetres.

    Within the context Matplotlib's settings are those of the house, whatever its user has chosen;
    they are put back at its end. Raises UnsupportedError where Matplotlib is not installed.
    """
    matplotlib = needed("matplotlib", "a plot")
    figure_type = needed("matplotlib.figure", "a plot").Figure
    style = needed("matplotlib.style", "a plot")
    needed("matplotlib.backends.backend_svg", "a plot")
    with _LOCK, style.context(["default", _SETTINGS]), matplotlib.rc_context():
        figure = figure_type(figsize=(width / 25.4, height / 25.4))
        axes = figure.add_axes((0, 0, 1, 1))
        axes.patch.set_visible(False)
        figure.patch.set_visible(False)
        yield Canvas(figure, axes)


def svg_of(drawn: Canvas, title: str, description: str) -> str:
    """What is drawn as the text of an SVG file, the same for the same drawing."""
    backend = needed("matplotlib.backends.backend_svg", "a plot")
    raw = io.BytesIO()
    backend.FigureCanvasSVG(drawn.figure).print_figure(
        raw, format="svg", bbox_inches="tight", pad_inches=0.03, metadata={"Date": None}
    )
    root = ET.fromstring(raw.getvalue())
    x, y, width, height = (float(word) * POINT for word in root.get("viewBox", "").split())
    view = " ".join(f"{number / POINT:.2f}" for number in (x, y, width, height))
    body = "".join(_written(element) for element in root if element.tag not in (_METADATA,))
    text = (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
        f' id="{_ID}" role="img" aria-labelledby="{_ID}-t {_ID}-d"'
        f' width="{width:.2f}mm" height="{height:.2f}mm" viewBox="{view}" color="{INK}"'
        ' fill="none" stroke="none" stroke-linejoin="round" stroke-linecap="butt">\n'
        f'<title id="{_ID}-t">{escape(title, quote=False)}</title>\n'
        f'<desc id="{_ID}-d">{escape(description, quote=False)}</desc>\n'
        f"<style>{_STYLE}</style>\n{body}\n</svg>\n"
    )
    return text.replace(_ID, "r" + hashlib.sha256(text.encode()).hexdigest()[:10])


_ID = "{id}"  # stands for the picture's id until its hash is known
_STYLE = (
    f"#{_ID} [stroke='{INK}']{{stroke:currentColor}}#{_ID} [fill='{INK}']{{fill:currentColor}}"
    f"#{_ID}:not(:root){{color:inherit}}"
    "@media (prefers-color-scheme:dark){"
    f"#{_ID}:root{{color-scheme:dark;color:{INK_ON_DARK};background:{PAPER_OF_DARK}}}"
    "}"
)
_SVG = "{http://www.w3.org/2000/svg}"
_LINK = "{http://www.w3.org/1999/xlink}href"
_METADATA = f"{_SVG}metadata"


def _written(element: ET.Element) -> str:
    """An element with all in it: no ids but those that are used, no styles, no empty groups."""
    name = element.tag.removeprefix(_SVG)
    if name == "style":
        return ""
    inside = "".join(_written(child) for child in element)
    if name in ("g", "defs") and not inside:
        return ""
    attributes = dict(_attributes(element, name))
    if name == "g" and not attributes:
        return inside
    written = "".join(f' {key}="{escape(value)}"' for key, value in attributes.items())
    return f"<{name}{written}>{inside}</{name}>" if inside else f"<{name}{written}/>"


_WITH_IDS = ("path", "clipPath")


def _attributes(element: ET.Element, name: str) -> Iterator[tuple[str, str]]:
    for key, value in element.attrib.items():
        value = " ".join(value.split())
        if key == "style":
            for declaration in value.split(";"):
                prop, _, setting = declaration.partition(":")
                if setting and setting.strip() != "none":
                    yield prop.strip(), setting.strip()
        elif key == "id":
            if name in _WITH_IDS:
                yield "id", f"{_ID}-{value}"
        elif key == _LINK:
            yield "xlink:href", value.replace("#", f"#{_ID}-")
        elif key == "clip-path":
            yield key, value.replace("#", f"#{_ID}-")
        else:
            yield key, value
