"""A scene as SVG: paths only, with no font, no script and nothing from elsewhere.

Colours and lines are presentation attributes, so that every viewer shows them, typst and Inkscape
among them. A short style follows the page: within a page lines take the colour of its text, and a
picture of its own turns light where the reader prefers dark. Every outline of a glyph is stored
once. Ids begin with a hash of the picture, so that several may stand on one page.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from typing import assert_never

from restitution.drawing import style
from restitution.drawing.ink import Segment, arc_span, hatch, right_angle_points, round_hatch
from restitution.drawing.labels import Placed, PlacedLabel, captioned, place
from restitution.drawing.scene import (
    Arc,
    Arrow,
    Disc,
    Dot,
    Line,
    Panel,
    Polyline,
    RightAngle,
    RoundWall,
    Scene,
    Shape,
    StraightWall,
)
from restitution.render.glyphs import UNITS, outline
from restitution.staging.geometry import direction
from restitution.vector import Vector

INK, INK_ON_DARK = "#1a1a1a", "#ededed"
PAPER_OF_DARK = "#161616"
ACCENT, ACCENT_ON_DARK = "#a3161c", "#ff9c8f"  # of an impulse
GAP = 8.0  # between pictures that stand in one file, in millimetres
_ID = "{id}"  # stands for the picture's id until its hash is known


def to_svg(scene: Scene) -> str:
    """The scene as the text of an SVG file, the same for the same scene."""
    return render(place(scene))


def stacked(scenes: Sequence[Scene]) -> str:
    """Scenes below one another as the text of one SVG file, each beneath its title."""
    if len(scenes) == 1:
        return to_svg(scenes[0])
    placed = [captioned(place(scene), scene.title) for scene in scenes]
    return _file(placed, [scene.title for scene in scenes])


def abreast(scenes: Sequence[Scene], titles: Sequence[str]) -> str:
    """Scenes beside one another as the text of one SVG file, each beneath a title."""
    placed = [captioned(place(scene), title) for scene, title in zip(scenes, titles, strict=True)]
    return _file(placed, titles, in_a_row=True)


def render(placed: Placed) -> str:
    """A placed scene as the text of an SVG file."""
    return _file([placed], [placed.scene.title])


def _file(pictures: Sequence[Placed], titles: Sequence[str], in_a_row: bool = False) -> str:
    """Pictures below one another, or beside, which share their outlines of glyphs."""
    glyphs: dict[str, str] = {}
    body: list[str] = []
    down = across = 0.0
    for placed in pictures:
        left, _, _, top = placed.box
        drawn = filter(None, _picture(placed, glyphs))
        if len(pictures) == 1:
            body += drawn
        else:
            at = f"{_number(across - left)} {_number(down + top)}"
            body += [f'<g transform="translate({at})">', *drawn, "</g>"]
        if in_a_row:
            across += placed.box[2] - left + GAP
        else:
            down += top - placed.box[1] + GAP
    left, top = (pictures[0].box[0], pictures[0].box[3]) if len(pictures) == 1 else (0.0, 0.0)
    width = _number(max(picture.box[2] - picture.box[0] for picture in pictures))
    height = _number(down - GAP)
    if in_a_row:
        width = _number(across - GAP)
        height = _number(max(picture.box[3] - picture.box[1] for picture in pictures))
    outlines = "".join(f'<path id="{_ID}-{name}" d="{d}"/>' for d, name in glyphs.items())
    description = " ".join(
        placed.scene.description if len(pictures) == 1 else f"{title}. {placed.scene.description}"
        for title, placed in zip(titles, pictures)
    )
    root = (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
        f' id="{_ID}" role="img"'
        f' aria-labelledby="{_ID}-t {_ID}-d" width="{width}mm" height="{height}mm"'
        f' viewBox="{_number(left)} {_number(-top)} {width} {height}"'
        f' color="{INK}" fill="none" stroke="none" stroke-linejoin="round">'
    )
    lines = [
        root,
        f'<title id="{_ID}-t">{escape("; ".join(titles), quote=False)}</title>',
        f'<desc id="{_ID}-d">{escape(description, quote=False)}</desc>',
        f"<style>{_STYLE}</style>",
        *([f"<defs>{outlines}</defs>"] if outlines else []),
        *body,
        "</svg>",
        "",
    ]
    text = "\n".join(lines)
    return text.replace(_ID, "r" + hashlib.sha256(text.encode()).hexdigest()[:10])


def _picture(placed: Placed, glyphs: dict[str, str]) -> Iterator[str]:
    """What is drawn and written in a picture; ``glyphs`` grows by the outlines that it uses."""
    yield from _shapes(placed.scene)
    for label in placed.labels:
        if label.leader is not None:
            data = _polyline(label.leader)
            yield f'<path class="leader" d="{data}"{_stroke(style.STROKES["leader"])}/>'
    for placed_label in (*placed.labels, *placed.words):
        yield _label(placed_label, glyphs)


# In a page, lines have the colour of its text; alone or as an image, that of the reader's choice,
# with a ground of its own, as a page that shows the image may be light all the same.
_STYLE = (
    f"#{_ID} [stroke]{{stroke:currentColor}}#{_ID} [fill]{{fill:currentColor}}"
    f"#{_ID} .impulse{{color:{ACCENT}}}"
    f"#{_ID}:not(:root){{color:inherit}}"
    f"#{_ID}:not(:root) .impulse{{color:light-dark({ACCENT},{ACCENT_ON_DARK})}}"
    "@media (prefers-color-scheme:dark){"
    f"#{_ID}:root{{color-scheme:dark;color:{INK_ON_DARK};background:{PAPER_OF_DARK}}}"
    f"#{_ID}:root .impulse{{color:{ACCENT_ON_DARK}}}"
    "}"
)


# --- shapes ---------------------------------------------------------------------------------------


def _shapes(scene: Scene) -> Iterator[str]:
    frames = [_frame(panel) for panel in scene.panels]
    yield from _group("frame", frames, style.STROKES["frame"])
    # What lies beneath comes first: walls and reference lines, then spheres, then arrows.
    for shape in sorted(scene.shapes, key=_depth):
        yield _shape(shape)


def _group(name: str, paths: Iterable[str], stroke: style.Stroke) -> Iterator[str]:
    data = "".join(paths)
    if data:
        yield f'<path class="{name}" d="{data}"{_stroke(stroke)}/>'


def _depth(shape: Shape) -> int:
    if isinstance(shape, StraightWall | RoundWall):
        return 0
    if isinstance(shape, Arrow | Dot):
        return 3
    return 2 if isinstance(shape, Disc) else 1


def _shape(shape: Shape) -> str:
    match shape:
        case Line(role, start, end):
            return _path(role, _polyline((start, end)), style.STROKES[role])
        case Polyline(role, points):
            return _path(role, _polyline(points), style.STROKES[role])
        case Arc(role, centre, radius, start, end):
            return _path(role, _arc(centre, radius, start, end), style.STROKES[role])
        case Arrow():
            return _arrow(shape)
        case Disc(_, centre, radius, ghost):
            stroke = style.GHOST if ghost else style.DISC
            kind = "ghost" if ghost else "disc"
            return f'<circle class="{kind}"{_circle(centre, radius)}{_stroke(stroke)}/>'
        case Dot(_, centre, radius):
            return f'<circle class="dot"{_circle(centre, radius)} fill="{INK}"/>'
        case RightAngle():
            data = _polyline(right_angle_points(shape))
            return _path("right-angle", data, style.RIGHT_ANGLE)
        case StraightWall(_, start, end):
            return _wall(_polyline((start, end)), hatch(shape))
        case RoundWall(_, centre, radius, start, end):
            return _wall(_arc(centre, radius, start, end), round_hatch(shape))
    assert_never(shape)


def _path(name: str, data: str, stroke: style.Stroke, colour: str = INK) -> str:
    return f'<path class="{name}" d="{data}"{_stroke(stroke, colour)}/>'


def _wall(edge: str, strokes: Iterable[Segment]) -> str:
    hatching = "".join(map(_polyline, strokes))
    return _path("hatch", hatching, style.HATCH) + _path("wall", edge, style.WALL)


def _frame(panel: Panel) -> str:
    left, bottom, right, top = panel.box
    return (
        _polyline(
            (Vector(left, bottom), Vector(right, bottom), Vector(right, top), Vector(left, top))
        )
        + "Z"
    )


def _arrow(arrow: Arrow) -> str:
    length = math.hypot(*(arrow.end - arrow.start))
    if length < 0.05:
        return ""
    stroke = style.STROKES[arrow.role]
    head = style.head(arrow.role, length)
    along = direction(arrow.end - arrow.start)
    if arrow.role == "impulse":
        data = _double_arrow(arrow.start, arrow.end, head)
        return _path("impulse", data, stroke, ACCENT)
    # A shaft ends within its head, short of the tip, so that the tip alone marks the end.
    back = along * (0.6 * head.length)
    shaft = _polyline((arrow.start + back if arrow.both else arrow.start, arrow.end - back))
    tips = [(arrow.end, along), (arrow.start, -along)][: 1 + arrow.both]
    heads = "".join(_head(tip, direction, head) for tip, direction in tips)
    ink = f' fill="{INK}"{_opacity("fill", stroke.strength)}'
    return _path(arrow.role, shaft, stroke) + f'<path class="head" d="{heads}"{ink}/>'


def _head(tip: Vector, along: Vector, head: style.Head) -> str:
    base = tip - along * head.length
    side = along.turned_left() * head.half
    notch = tip - along * (0.82 * head.length)
    return _polyline((base + side, tip, base - side, notch)) + "Z"


def _double_arrow(start: Vector, end: Vector, head: style.Head) -> str:
    """Two shafts that run into an open head."""
    along = direction(end - start)
    side = along.turned_left()
    half = min(style.SHAFT_GAP / 2, 0.6 * head.half)
    neck = end - along * head.length
    return _polyline(
        (
            start + side * half,
            neck + side * half,
            neck + side * head.half,
            end,
            neck - side * head.half,
            neck - side * half,
            start - side * half,
        )
    )


# --- words ----------------------------------------------------------------------------------------


def _label(placed: PlacedLabel, glyphs: dict[str, str]) -> str:
    """A label's outlines, each stored in ``glyphs`` under its path and used from there."""
    shape = outline(placed.label.content)
    unit_size = placed.size / UNITS
    uses = []
    for mark in shape.marks:
        name = glyphs.setdefault(mark.path, f"g{len(glyphs)}")
        x, y = _number(mark.x * UNITS), _number(-mark.y * UNITS)
        if mark.scale == 1:
            uses.append(f'<use xlink:href="#{_ID}-{name}" x="{x}" y="{y}"/>')
        else:
            moved = f"translate({x} {y}) scale({mark.scale:g})"
            uses.append(f'<use xlink:href="#{_ID}-{name}" transform="{moved}"/>')
    bars = "".join(
        f"M{_number(left * UNITS)} {_number(-top * UNITS)}h{_number((right - left) * UNITS)}"
        f"v{_number((top - bottom) * UNITS)}h{_number((left - right) * UNITS)}Z"
        for left, bottom, right, top in (bar.box for bar in shape.bars)
    )
    if bars:
        uses.append(f'<path d="{bars}"/>')
    moved = f"translate({_point(placed.baseline)}) scale({unit_size:.5g})"
    group = f'<g class="label" fill="{INK}" transform="{moved}">{"".join(uses)}</g>'
    if not placed.label.ringed:
        return group
    left, bottom, right, top = placed.box
    centre = Vector((left + right) / 2, (bottom + top) / 2)
    radius = (right - left - style.RING.width) / 2
    return f'<circle class="ring"{_circle(centre, radius)}{_stroke(style.RING)}/>{group}'


# --- attributes -----------------------------------------------------------------------------------


def _stroke(stroke: style.Stroke, colour: str = INK) -> str:
    text = f' stroke="{colour}" stroke-width="{_number(stroke.width)}"'
    if stroke.dashes:
        text += f' stroke-dasharray="{" ".join(_number(dash) for dash in stroke.dashes)}"'
    if stroke.round:
        text += ' stroke-linecap="round"'
    return text + _opacity("stroke", stroke.strength)


def _opacity(kind: str, strength: float) -> str:
    return f' {kind}-opacity="{_number(strength)}"' if strength < 1 else ""


def _circle(centre: Vector, radius: float) -> str:
    return f' cx="{_number(centre.x)}" cy="{_number(-centre.y)}" r="{_number(radius)}"'


def _polyline(points: Iterable[Vector]) -> str:
    return "M" + "L".join(_point(point) for point in points)


def _arc(centre: Vector, radius: float, start: float, end: float) -> str:
    """An arc anticlockwise as seen (y up), in at most two pieces of half a turn or less."""
    span = arc_span(start, end)
    angles = [start, start + span / 2, start + span]
    points = [centre + Vector(math.cos(a), math.sin(a)) * radius for a in angles]
    r = _number(radius)
    return "M" + f"A{r} {r} 0 0 0 ".join(_point(point) for point in points)


def _point(point: Vector) -> str:
    return f"{_number(point.x)} {_number(-point.y)}"


def _number(value: float) -> str:
    """A number to two decimals, as short as it can be written."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
