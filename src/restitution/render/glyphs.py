"""Mathematics as outlines: what a layout looks like, with no font needed to show it.

ziamath sets the MathML of a layout in STIX Two Math, the font that it carries; here its result is
taken apart into marks (outlines of glyphs, placed and scaled) and bars (of fractions and roots).
Lengths are in em, x to the right and y up from the start of the baseline. Outlines are SVG path
data in thousandths of an em with y down, so that each can be stored once and used many times.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Any, TypeAlias
from xml.etree import ElementTree as ET

from restitution.records import dataclass
from restitution.render.layout import Layout
from restitution.render.mathml import to_mathml

Box: TypeAlias = tuple[float, float, float, float]  # left, bottom, right, top

UNITS = 1000  # of a path, in one em
_INVISIBLE = ("", "\u2061", "\u2062")  # function application, multiplication
# ziamath takes an em to be a third larger, and puts a space of its own around names of functions.
_EM_OF_ZIAMATH = 1.333
# ziamath reads its font through one shared buffer, and switches its language while setting words.
_LOCK = threading.Lock()


@dataclass(frozen=True, slots=True)
class Mark:
    """An outline with the start of its baseline at (x, y); ``scale`` is 1 but in scripts."""

    path: str
    x: float
    y: float
    scale: float = 1.0


@dataclass(frozen=True, slots=True)
class Bar:
    """A filled rectangle."""

    box: Box


@dataclass(frozen=True, slots=True)
class Outline:
    """A layout as shapes; ``box`` is the extent of its ink, exactly."""

    marks: tuple[Mark, ...]
    bars: tuple[Bar, ...]
    box: Box


@lru_cache(maxsize=4096)
def outline(layout: Layout) -> Outline:
    """The outlines of a layout, in em; empty, with an empty box, if nothing of it is seen."""
    from ziamath.zmath import Math  # slow to load, and needed for pictures only

    root = _prepared(ET.fromstring(to_mathml(layout)))
    root.attrib["displaystyle"] = "false"
    with _LOCK:
        placed = list(_leaves(Math(root, size=UNITS).node, 0.0, 0.0))
    marks, bars, boxes = [], [], []
    for node, x, y in placed:
        if hasattr(node, "glyph"):
            scale = node.size / UNITS
            for operators, dx, dy in _parts(node.glyph):
                path, extent = _path(operators)
                if not path:
                    continue
                mark = Mark(path, (x + scale * dx) / UNITS, (scale * dy - y) / UNITS, scale)
                marks.append(mark)
                boxes.append(_placed(extent, mark))
        elif hasattr(node, "lw"):  # its y is that of its upper edge
            bar = (x / UNITS, -(y + node.lw) / UNITS, (x + node.length) / UNITS, -y / UNITS)
            bars.append(Bar(bar))
            boxes.append(bar)
    return Outline(tuple(marks), tuple(bars), union(boxes))


def union(boxes: Iterable[Box]) -> Box:
    """The smallest box around boxes; all zero around none."""
    sides = list(zip(*boxes, strict=True))
    if not sides:
        return 0.0, 0.0, 0.0, 0.0
    return min(sides[0]), min(sides[1]), max(sides[2]), max(sides[3])


def _prepared(element: ET.Element) -> ET.Element:
    """The same mathematics, spaced for ziamath and without rows in rows, which slow it down."""
    children: list[ET.Element] = []
    for child in map(_prepared, element):
        if child.tag in ("mo", "mtext") and (child.text or "") in _INVISIBLE:
            continue
        if child.tag == "mrow" and element.tag in ("math", "mrow") and not _stretches(child):
            children.extend(child)
        else:
            children.append(child)
    element[:] = []
    for index, child in enumerate(children):
        if child.tag == "mspace":
            if any(map(_names_function, children[max(index - 1, 0) : index + 2])):
                continue
            width = float(child.attrib["width"].removesuffix("em"))
            child.attrib["width"] = f"{width / _EM_OF_ZIAMATH:.3f}em"
        element.append(child)
    return element


def _stretches(row: ET.Element) -> bool:
    return any(child.get("stretchy") == "true" for child in row)


def _names_function(element: ET.Element) -> bool:
    if element.tag == "msup":
        element = element[0]
    return element.tag == "mi" and len(element.text or "") > 1


def _leaves(node: Any, x: float, y: float) -> Iterator[tuple[Any, float, float]]:
    """The glyphs and bars of a node of ziamath with their places, y down."""
    if not node.nodes:
        yield node, x, y
    for child, (dx, dy) in zip(node.nodes, getattr(node, "nodexy", ()), strict=False):
        yield from _leaves(child, x + dx, y + dy)


def _parts(glyph: Any) -> Iterator[tuple[tuple[Any, ...], float, float]]:
    """The operators of a glyph, or of the parts that a very tall one is assembled from."""
    if not hasattr(glyph, "offsets"):
        yield tuple(glyph.operators), 0.0, 0.0
        return
    for part, offset in zip(glyph.glyphs, glyph.offsets, strict=True):
        yield tuple(part.operators), *((0.0, offset) if glyph.vert else (offset, 0.0))


def _path(operators: tuple[Any, ...]) -> tuple[str, Box]:
    """Path data with steps relative to the point before, and the exact extent with y up."""
    out: list[str] = []
    xs: list[float] = []
    ys: list[float] = []
    x = y = 0.0
    for operator in operators:
        points = [(point.x, point.y) for point in operator.points()[0]]
        if type(operator).__name__ == "Moveto":
            out.append(("Z" if out else "") + "M" + _numbers(points[0][0], -points[0][1]))
        elif len(points) > 1 or points[0] != (x, y):
            letter = " lqc"[len(points)]
            steps = (coordinate for px, py in points for coordinate in (px - x, y - py))
            out.append(letter + _numbers(*steps))
        if len(points) == 2:
            xs.append(_turn(x, points[0][0], points[1][0]))
            ys.append(_turn(y, points[0][1], points[1][1]))
        # Both controls of a cubic are counted, which may be too much and never is too little.
        xs.extend(px for px, _ in (points if len(points) == 3 else points[-1:]))
        ys.extend(py for _, py in (points if len(points) == 3 else points[-1:]))
        x, y = points[-1]
    if not out:
        return "", (0.0, 0.0, 0.0, 0.0)
    return "".join(out) + "Z", (min(xs), min(ys), max(xs), max(ys))


def _turn(start: float, control: float, end: float) -> float:
    """The coordinate at which a quadratic curve turns back, or that of its end."""
    bend = start - 2 * control + end
    at = (start - control) / bend if bend else 0.0
    if not 0 < at < 1:
        return end
    return (1 - at) ** 2 * start + 2 * at * (1 - at) * control + at**2 * end


def _numbers(*values: float) -> str:
    text = " ".join(f"{value:g}" for value in values)
    return text.replace(" -", "-")


def _placed(extent: Box, mark: Mark) -> Box:
    left, bottom, right, top = (mark.scale * number / UNITS for number in extent)
    return mark.x + left, mark.y + bottom, mark.x + right, mark.y + top
