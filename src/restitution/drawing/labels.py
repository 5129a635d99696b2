"""Where the labels of a scene stand: none on a line or on another, all inside the frame.

Every label has offers: places beside each point that it may name, on each side that suits it,
nearer and farther. Those that meet a line, a disc or the frame are dropped. Labels with the fewest
offers choose first; then exchanges follow that make the whole better. A label far from what it
names gets a leader line. Where there is no room the frame grows downwards. Lengths are in
millimetres, y up.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from restitution.drawing import style
from restitution.drawing.ink import (
    Piece,
    Segment,
    Stick,
    crosses,
    ink,
    overlap,
    padded,
    parted,
    stick,
    touched,
)
from restitution.drawing.scene import Disc, Label, Panel, Scene, Side
from restitution.records import dataclass
from restitution.render.glyphs import Box, outline, union
from restitution.render.layout import Layout, Phrase, Words
from restitution.staging.geometry import direction
from restitution.vector import Vector

CLEARANCE = 0.3  # from the ink of a label to any line, and to the frame
ASIDE, ABOVE = 1.5, 0.9  # from label to label, so that no two read as one
FROM_LEADER = 1.4  # from a label to the leader line of another, which is no bar of a fraction
MARGIN = 0.6  # from any ink to the edge of the picture
HEADING_SIZE = 3.2
NOTE_SIZE = 2.6
LEADER_FROM = 2.4  # a label this much farther off than it asked for gets a leader line
SHORTEST = 1.6  # way from a label to its point that a leader line can be drawn on
SMALLEST = 0.8  # of the size asked for

_FARTHER = (0.0, 0.5, 1.1, 1.9, 2.8, 4.0, 5.5, 7.5)
_SLIDES = (0.0, 0.25, -0.25, 0.5, -0.5)  # of a label's width or height, along its side
_ENOUGH = 16  # offers, after which none farther off are looked for
_ALL = 60
_STRONG = 0.13  # half the width of a straight line that should not part a label from its point
_GRID = 1.6
_GROWTH = 5.0
_ROUNDS = 10
_SIDES: dict[Side, tuple[int, int]] = {
    "e": (1, 0),
    "ne": (1, 1),
    "n": (0, 1),
    "nw": (-1, 1),
    "w": (-1, 0),
    "sw": (-1, -1),
    "s": (0, -1),
    "se": (1, -1),
    "centre": (0, 0),
}
_ALL_SIDES: tuple[Side, ...] = ("n", "s", "e", "w", "ne", "nw", "se", "sw")


@dataclass(frozen=True, slots=True)
class PlacedLabel:
    """A label where it stands.

    ``box`` is the extent of its ink (of its ring, if it has one), ``baseline`` where its outline
    starts, ``size`` an em of it in millimetres, and ``leader`` the line to what it names.
    """

    label: Label
    box: Box
    baseline: Vector
    size: float
    leader: Segment | None = None


@dataclass(frozen=True, slots=True)
class Placed:
    """A scene with its labels in their places, in the order of the scene.

    ``scene`` has its panels as large as they have become; ``words`` are the panels' headings and
    the lines of the note, and ``box`` holds everything.
    """

    scene: Scene
    labels: tuple[PlacedLabel, ...]
    words: tuple[PlacedLabel, ...]
    box: Box


def place(scene: Scene) -> Placed:
    """The scene with its labels placed, the frame grown where it had to.

    A ``fixed`` label that would stand on a line or on another one is placed like any other.
    """
    pieces = [piece for shape in scene.shapes for piece in ink(shape)]
    headings = [_heading(panel, pieces) for panel in scene.panels]
    for step in range(_ROUNDS):
        grown = _grown(scene, _GROWTH * (2**step - 1))
        chosen = _placed(grown, pieces, headings, lead=step < _ROUNDS // 2)
        if chosen is not None:
            break
    else:
        message = "no room for the labels of a picture"
        raise AssertionError(message)
    labels = tuple(
        PlacedLabel(label, offer.box, _baseline(label, offer), offer.size, offer.leader)
        for label, offer in zip(scene.labels, chosen, strict=True)
    )
    scene = _trimmed(grown, scene, labels)
    drawn = [
        *(padded(piece.box, MARGIN) for piece in pieces),
        *(padded(label.box, MARGIN) for label in labels),
        *(padded(heading.box, MARGIN) for heading in headings),
        *(piece.box for panel in scene.panels for piece in _frame(panel)),
    ]
    box = union([scene.box, *drawn])
    left = min((panel.box[0] for panel in scene.panels), default=box[0])
    words = (*headings, *_note(scene.note, (left, *box[1:])))
    return Placed(scene, labels, words, union([box, *(padded(word.box, MARGIN) for word in words)]))


# --- offers ---------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Offer:
    """A place for a label: its box, the size of its letters, how bad it is, its leader line.

    ``reach`` is the box around it all, with the space that other labels have to leave.
    """

    box: Box
    size: float
    cost: float
    leader: Segment | None
    reach: Box


def _offered(box: Box, size: float, cost: float, leader: Segment | None = None) -> _Offer:
    ends = [(*end, *end) for end in leader or ()]
    return _Offer(box, size, cost, leader, padded(union([box, *ends]), ASIDE / 2))


@dataclass(frozen=True, slots=True)
class _Ground:
    """What an offer must keep off (ink, and boxes that stay), and the region it must be in.

    It should keep out of the ``discs`` too, unless it names one.
    """

    region: Box
    pieces: Sequence[Piece]
    solid: Sequence[Box]
    discs: Sequence[Disc] = ()

    def around(self, box: Box) -> _Ground:
        """The same, without what lies apart from a box."""
        pieces = [piece for piece in self.pieces if overlap(piece.box, box)]
        solid = [mark for mark in self.solid if overlap(mark, box)]
        return _Ground(self.region, pieces, solid, self.discs)

    def is_free(self, box: Box) -> bool:
        """Whether a label may have this box."""
        region = self.region
        return (
            region[0] <= box[0]
            and region[1] <= box[1]
            and box[2] <= region[2]
            and box[3] <= region[3]
            and not touched(box, self.pieces, CLEARANCE)
            and not any(_together(box, mark) for mark in self.solid)
        )


def _extent(label: Label, size: float) -> tuple[float, float]:
    """Width and height of a label's ink."""
    left, bottom, right, top = outline(label.content).box
    width, height = (right - left) * size, (top - bottom) * size
    if label.ringed:
        width = height = max(math.hypot(width, height) + 0.5, 1.25 * size) + style.RING.width
    return width, height


def _beside(at: Vector, side: Side, gap: float, extent: tuple[float, float]) -> Box:
    """The box at a distance from a point on one side of it."""
    width, height = extent
    across, up = _SIDES[side]
    slant = gap * (math.sqrt(0.5) if across and up else 1.0)
    x = at[0] + across * (slant + width / 2)
    y = at[1] + up * (slant + height / 2)
    return x - width / 2, y - height / 2, x + width / 2, y + height / 2


def _fixed(scene: Scene, pieces: Sequence[Piece], solid: Sequence[Box]) -> dict[int, _Offer]:
    """Where fixed labels stand, by their indices: those that stand free."""
    offers: dict[int, _Offer] = {}
    for index, label in enumerate(scene.labels):
        if label.fixed:
            box = _beside(label.at, label.sides[0], label.gap, _extent(label, label.size))
            others = [*solid, *(offer.box for offer in offers.values())]
            if _Ground(box, pieces, others).is_free(box):
                offers[index] = _offered(box, label.size, 0.0)
    return offers


def _offers(label: Label, ground: _Ground, enough: int = _ENOUGH) -> list[_Offer]:
    """Free places for a label, best first.

    They are on the sides it asks for; if none is free there, on any side; then for a smaller label.
    """
    others = tuple(side for side in _ALL_SIDES if side not in label.sides)
    for share, sides in (
        (1.0, dict(enumerate(label.sides))),
        (1.0, dict(enumerate(others, 4))),
        (SMALLEST, dict(enumerate((*label.sides, *others)))),
    ):
        offers = _on_sides(label, ground, label.size * share, sides, enough)
        if offers:
            return sorted(offers, key=lambda offer: offer.cost)
    return []


def _on_sides(
    label: Label, ground: _Ground, size: float, sides: dict[int, Side], enough: int
) -> list[_Offer]:
    """Free places for a label of one size on sides by their ranks, nearer before farther."""
    extent = _extent(label, size)
    offers: list[_Offer] = []
    for farther in _FARTHER:
        gap = label.gap + farther
        for place, point in enumerate((label.at, *label.moves)):
            reach = max(extent) + gap + ASIDE
            x, y = point
            near = ground.around((x - reach, y - reach, x + reach, y + reach))
            for rank, side in sides.items():
                if side == "centre" and farther:
                    continue
                cost = 0.5 * rank + 0.4 * place + 1.2 * farther
                for box, slide in _slid(_beside(point, side, gap, extent), side):
                    if near.is_free(box):
                        offer = _offer(box, size, cost + slide, point, label.gap, farther, near)
                        if offer is not None:
                            offers.append(offer)
        if len(offers) >= enough:
            break
    return offers


def _slid(box: Box, side: Side) -> Iterator[tuple[Box, float]]:
    """A box and the same a little along its side, with what that costs."""
    across, up = _SIDES[side]
    left, bottom, right, top = box
    yield box, 0.0
    if (across == 0) == (up == 0):
        return
    for share in _SLIDES[1:]:
        x = 0.0 if across else share * (right - left)
        y = share * (top - bottom) if across else 0.0
        yield (left + x, bottom + y, right + x, top + y), 0.2 + abs(share)


def _offer(
    box: Box,
    size: float,
    cost: float,
    point: Vector,
    gap: float,
    farther: float,
    near: _Ground,
    *,
    lead: bool = True,
) -> _Offer | None:
    """A free box with its cost and, where it is far off, a leader line; None if that is barred.

    Ink close by, other ink than the point's own before it, and a disc around make a place worse.
    """
    left, bottom, right, top = box
    nearest = Vector(min(max(point[0], left), right), min(max(point[1], bottom), top))
    close, spot = padded(box, 1.0), (*point, *point)
    far, behind = farther >= LEADER_FROM, False
    for piece in near.pieces:
        if overlap(piece.box, close) and touched(box, (piece,), 1.0):
            cost += 0.35
        if parted(nearest, point, piece) and not touched(spot, (piece,), 0.2):
            strong = isinstance(piece, Stick) and piece.half > _STRONG
            cost += 6.0 if strong else 0.8
            behind |= strong
    middle = Vector((left + right) / 2, (bottom + top) / 2)
    for disc in near.discs:
        if point != disc.centre and math.hypot(*(middle - disc.centre)) < disc.radius:
            cost += 2.5
    short = math.hypot(*(point - nearest)) < SHORTEST
    if behind and short:  # it would seem to name the line between
        cost += 4.0
    if not lead or not (far or behind) or short:
        return _offered(box, size, cost)
    outward = direction(point - nearest)
    leader = nearest + outward * 0.5, point - outward * max(0.3, min(gap - 0.4, 0.6 * gap))
    if any(crosses(padded(mark, FROM_LEADER), *leader) for mark in near.solid):
        return None
    return _offered(box, size, cost + 2.0, leader)


def _anywhere(label: Label, ground: _Ground, lead: bool) -> Iterator[_Offer]:
    """Free places on a grid over the whole region, nearest first, with leader lines."""
    width, height = extent = _extent(label, label.size)
    left, bottom, right, top = ground.region
    columns = range(math.floor((right - left - width) / _GRID + 1e-9) + 1)
    rows = range(math.floor((top - bottom - height) / _GRID + 1e-9) + 1)
    x, y = label.at
    spots = [
        (math.hypot(left + column * _GRID + width / 2 - x, bottom + row * _GRID + height / 2 - y),)
        + (left + column * _GRID, bottom + row * _GRID)
        for column in columns
        for row in rows
    ]
    for distance, low_x, low_y in sorted(spots):
        box = (low_x, low_y, low_x + extent[0], low_y + extent[1])
        if ground.is_free(box):
            cost = 6 + 1.2 * distance
            offer = _offer(box, label.size, cost, label.at, 1.0, math.inf, ground, lead=lead)
            if offer is not None:
                yield offer


# --- choosing -------------------------------------------------------------------------------------


def _placed(
    scene: Scene,
    pieces: Sequence[Piece],
    headings: Sequence[PlacedLabel],
    *,
    lead: bool,
) -> list[_Offer] | None:
    """A place for every label, or None if there is none for one of them."""
    everything = [*pieces, *(line for panel in scene.panels for line in _frame(panel))]
    solid = [heading.box for heading in headings]
    fixed = _fixed(scene, everything, solid)
    solid += [offer.box for offer in fixed.values()]
    discs = [shape for shape in scene.shapes if isinstance(shape, Disc) and not shape.ghost]
    grounds = [_Ground(_region(label, scene), everything, solid, discs) for label in scene.labels]
    offers = {
        index: _offers(label, grounds[index])
        for index, label in enumerate(scene.labels)
        if index not in fixed
    }
    chosen: dict[int, _Offer] = {}
    for index in sorted(offers, key=lambda number: (len(offers[number]), number)):
        if _settle(index, offers, chosen):
            continue
        offers[index] = _offers(scene.labels[index], grounds[index], _ALL)
        if not _settle(index, offers, chosen):
            for offer in _anywhere(scene.labels[index], grounds[index], lead):
                if not any(_clash(offer, other) for other in chosen.values()):
                    chosen[index] = offer
                    break
            else:
                return None
    for _ in range(4):
        improved = [_improve(index, offers, chosen) for index in offers]
        if not any(improved):
            break
    chosen |= fixed
    return [chosen[index] for index in range(len(scene.labels))]


def _clash(one: _Offer, two: _Offer) -> bool:
    """Whether two labels cannot both stand so: on each other, or with a leader line on one."""
    if not overlap(one.reach, two.reach):
        return False
    if _together(one.box, two.box):
        return True
    if one.leader is not None and crosses(padded(two.box, FROM_LEADER), *one.leader):
        return True
    if two.leader is None:
        return False
    return crosses(padded(one.box, FROM_LEADER), *two.leader) or (
        one.leader is not None and parted(*one.leader, stick(*two.leader, 0.0))
    )


def _together(one: Box, two: Box) -> bool:
    """Whether two labels stand on each other, or so near that they could be read as one."""
    return (
        one[0] < two[2] + ASIDE
        and two[0] < one[2] + ASIDE
        and one[1] < two[3] + ABOVE
        and two[1] < one[3] + ABOVE
    )


def _settle(index: int, offers: dict[int, list[_Offer]], chosen: dict[int, _Offer]) -> bool:
    """Choose the best offer that is free; else one whose rivals can move."""
    for offer in offers[index]:
        if not any(_clash(offer, other) for other in chosen.values()):
            chosen[index] = offer
            return True
    return any(_move(index, offer, offers, chosen, math.inf) for offer in offers[index])


def _improve(index: int, offers: dict[int, list[_Offer]], chosen: dict[int, _Offer]) -> bool:
    """Gives a label a better place, if that makes the sum of the costs less."""
    now = chosen[index].cost
    return any(
        _move(index, offer, offers, chosen, now - offer.cost)
        for offer in offers[index]
        if offer.cost < now - 1e-9
    )


def _move(
    index: int,
    offer: _Offer,
    offers: dict[int, list[_Offer]],
    chosen: dict[int, _Offer],
    gain: float,
) -> bool:
    """Choose an offer, moving at most two rivals, if they lose less than what is gained."""
    rivals = [k for k, other in chosen.items() if k != index and _clash(offer, other)]
    if len(rivals) > 2:
        return False
    trial = {k: other for k, other in chosen.items() if k not in rivals}
    trial[index] = offer
    loss = 0.0
    for rival in rivals:
        for other in offers[rival]:
            if loss + other.cost - chosen[rival].cost >= gain - 1e-9:
                return False  # offers come best first
            if not any(_clash(other, offer) for offer in trial.values()):
                loss += other.cost - chosen[rival].cost
                trial[rival] = other
                break
        else:
            return False
    chosen.update(trial)
    return True


# --- the frame ------------------------------------------------------------------------------------


def _region(label: Label, scene: Scene) -> Box:
    """Where a label may stand: in its panel, if it fits into that, else in the picture."""
    width, _ = _extent(label, label.size)
    for panel in scene.panels:
        left, bottom, right, top = panel.box
        inside = left <= label.at[0] <= right and bottom <= label.at[1] <= top
        if inside and width + 2 * MARGIN <= right - left:
            return padded(panel.box, -MARGIN)
    left, bottom, right, top = padded(scene.box, -MARGIN)
    return left, bottom, max(right, left + width), top


def _grown(scene: Scene, by: float) -> Scene:
    """The scene with so much more room at the bottom, of the panels and beneath them."""
    panels = tuple(
        replace(panel, box=(panel.box[0], panel.box[1] - by, panel.box[2], panel.box[3]))
        for panel in scene.panels
    )
    left, bottom, right, top = scene.box
    return replace(scene, panels=panels, box=(left, bottom - (1 + bool(panels)) * by, right, top))


def _trimmed(grown: Scene, scene: Scene, labels: Sequence[PlacedLabel]) -> Scene:
    """The grown scene without the room at its bottom that no label has taken."""
    lowest = min((label.box[1] for label in labels), default=math.inf) - 2 * MARGIN

    def bottom(large: Box, small: Box) -> Box:
        return large[0], min(max(large[1], lowest), small[1]), large[2], large[3]

    panels = tuple(
        replace(panel, box=bottom(panel.box, small.box))
        for panel, small in zip(grown.panels, scene.panels, strict=True)
    )
    return replace(grown, panels=panels, box=bottom(grown.box, scene.box))


def _frame(panel: Panel) -> Iterator[Piece]:
    left, bottom, right, top = panel.box
    corners = [Vector(left, bottom), Vector(right, bottom), Vector(right, top), Vector(left, top)]
    for a, b in zip(corners, (*corners[1:], corners[0]), strict=True):
        yield stick(a, b, style.STROKES["frame"].width / 2)


# --- words ----------------------------------------------------------------------------------------


def _baseline(label: Label, offer: _Offer) -> Vector:
    """Where the outline starts, so that its ink is in the middle of the box."""
    left, bottom, right, top = outline(label.content).box
    x = (offer.box[0] + offer.box[2]) / 2 - offer.size * (left + right) / 2
    y = (offer.box[1] + offer.box[3]) / 2 - offer.size * (bottom + top) / 2
    return Vector(x, y)


def _heading(panel: Panel, pieces: Sequence[Piece]) -> PlacedLabel:
    """The name of a panel above it, and above what reaches out of it."""
    left, _, right, top = panel.box
    column = (left, top, right, math.inf)
    top = max([top, *(piece.box[3] for piece in pieces if overlap(piece.box, column))])
    return _line(Words(panel.name), Vector((left + right) / 2, top + 1.6), HEADING_SIZE, 0.5)


def _line(content: Layout, at: Vector, size: float, share: float = 0.0) -> PlacedLabel:
    """Words on a baseline, with the point so far along them: at their start, or in the middle."""
    left, bottom, right, top = (size * number for number in outline(content).box)
    x = at.x - left - share * (right - left)
    label = Label(content, at, ("centre",), 0.0, size, fixed=True)
    box = (x + left, at.y + bottom, x + right, at.y + top)
    return PlacedLabel(label, box, Vector(x, at.y), size)


def captioned(placed: Placed, text: str) -> Placed:
    """The scene with a line of words above it."""
    left, bottom, right, top = placed.box
    line = _line(Words(text), Vector(left + MARGIN, top + MARGIN), HEADING_SIZE)
    box = (left, bottom, max(right, line.box[2] + MARGIN), line.box[3] + MARGIN)
    return replace(placed, words=(*placed.words, line), box=box)


def _note(note: Layout | None, box: Box) -> Iterator[PlacedLabel]:
    """The note in lines beneath the picture."""
    if note is None:
        return
    left, bottom, right, _ = box
    for index, content in enumerate(_lines(note, (right - left - 2 * MARGIN) / NOTE_SIZE)):
        y = bottom - (1.5 + 1.4 * index) * NOTE_SIZE
        yield _line(content, Vector(left + MARGIN, y), NOTE_SIZE)


def _lines(note: Layout, width: float) -> list[Layout]:
    """The note broken at its spaces into lines no wider than so many em, where it can be."""
    items = note.items if isinstance(note, Phrase) and note.separator == " " else (note,)
    words: list[Layout] = []
    for item in items:
        words.extend(map(Words, item.text.split()) if isinstance(item, Words) else [item])
    lines: list[Layout] = []
    for word in words:
        longer = _joined(lines[-1], word) if lines else word
        if lines and _width(longer) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def _joined(line: Layout, word: Layout) -> Layout:
    items = line.items if isinstance(line, Phrase) else (line,)
    last = items[-1]
    if isinstance(last, Words) and isinstance(word, Words):
        items, word = items[:-1], Words(f"{last.text} {word.text}")
    return Phrase((*items, word)) if items else word


def _width(layout: Layout) -> float:
    left, _, right, _ = outline(layout).box
    return right - left
