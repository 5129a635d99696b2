"""Where the labels of a scene stand: none on a line or on another, all inside the frame.

Every label has candidates: beside each point that it may name, on each side that suits it, nearer
and farther. Those that meet a line, a disc or the frame are dropped. Then labels with the fewest
candidates choose first, and exchanges follow that make the whole better. A label far from what it
names gets a leader line. Where there is no room the frame grows downwards. Lengths are in
millimetres, y up.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TypeAlias

from restitution.draw import style
from restitution.draw.scene import (
    Arc,
    Arrow,
    Disc,
    Dot,
    Label,
    Line,
    Panel,
    Polyline,
    RightAngle,
    RoundWall,
    Scene,
    Shape,
    Side,
    StraightWall,
)
from restitution.render.glyphs import Box, outline, union
from restitution.render.layout import Layout, Phrase, Words
from restitution.vector import Vector

Segment: TypeAlias = tuple[Vector, Vector]

CLEARANCE = 0.3  # from the ink of a label to any line, and to the frame
APART = 0.6  # from label to label
MARGIN = 0.6  # from any ink to the edge of the picture
HEADING_SIZE = 3.2
NOTE_SIZE = 2.6
LEADER_FROM = 2.4  # a label this much farther off than it asked for gets a leader line
SMALLEST = 0.8  # of the size asked for
_FARTHER = (0.0, 0.5, 1.1, 1.9, 2.8, 4.0, 5.5, 7.5)
_ENOUGH = 14  # candidates, after which none farther off are looked for
_GRID = 1.6
_GROWTH = 5.0
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
    """A scene with its labels in their places.

    ``scene`` has its panels as large as they have become; ``words`` are the panels' headings and
    the lines of the note, and ``box`` holds everything.
    """

    scene: Scene
    labels: tuple[PlacedLabel, ...]
    words: tuple[PlacedLabel, ...]
    box: Box


# --- ink ------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Stick:
    """A straight piece of ink with half its width."""

    start: Vector
    end: Vector
    half: float
    box: Box


@dataclass(frozen=True, slots=True)
class Ring:
    """A circle of ink with half its width."""

    centre: Vector
    radius: float
    half: float
    box: Box


def stick(start: Vector, end: Vector, half: float) -> Stick:
    """A straight piece of ink with its box."""
    return Stick(
        start,
        end,
        half,
        (
            min(start.x, end.x) - half,
            min(start.y, end.y) - half,
            max(start.x, end.x) + half,
            max(start.y, end.y) + half,
        ),
    )


def ring(centre: Vector, radius: float, half: float) -> Ring:
    """A circle of ink with its box."""
    r = radius + half
    return Ring(centre, radius, half, (centre.x - r, centre.y - r, centre.x + r, centre.y + r))


def ink(shape: Shape) -> list[Stick | Ring]:
    """What a shape covers on paper."""
    match shape:
        case Line(role, start, end):
            return [stick(start, end, style.STROKES[role].width / 2)]
        case Polyline(role, points):
            half = style.STROKES[role].width / 2
            return [stick(a, b, half) for a, b in zip(points, points[1:])]
        case Arrow(role, start, end, both):
            return _ink_of_arrow(role, start, end, both)
        case Disc(_, centre, radius, ghost):
            return [ring(centre, radius, (style.GHOST if ghost else style.DISC).width / 2)]
        case Dot(_, centre, radius):
            return [stick(centre, centre, radius)]
        case Arc(role, centre, radius, start, end):
            return _sticks(arc_points(centre, radius, start, end), style.STROKES[role].width / 2)
        case RightAngle():
            return _sticks(right_angle_points(shape), style.RIGHT_ANGLE.width / 2)
        case StraightWall(_, start, end, far):
            half = style.HATCH_DEPTH / 2
            across = unit(end - start).turned_left()
            shift = (across if across.dot(far) > 0 else -across) * half
            edge = style.WALL.width / 2
            return [stick(start, end, edge), stick(start + shift, end + shift, half)]
        case RoundWall(_, centre, radius, start, end, hatched):
            depth = style.HATCH_DEPTH / 2
            middle = radius + (depth if hatched == "outside" else -depth)
            return [
                *_sticks(arc_points(centre, radius, start, end), style.WALL.width / 2),
                *_sticks(arc_points(centre, middle, start, end), depth),
            ]


def _ink_of_arrow(
    role: style.LineRole, start: Vector, end: Vector, both: bool
) -> list[Stick | Ring]:
    length = math.hypot(*(end - start))
    half = style.STROKES[role].width / 2
    if role == "impulse":
        half += style.SHAFT_GAP / 2
    found: list[Stick | Ring] = [stick(start, end, half)]
    head = style.head(role, length)
    for tip, tail in ((end, start), (start, end))[: 1 + both]:
        way = unit(tip - tail)
        base = tip - way * head.length
        side = way.turned_left() * head.half
        corners = (base + side, tip, base - side)
        found.extend(_sticks((*corners, corners[0]), style.STROKES[role].width / 2))
    return found


def _sticks(points: Iterable[Vector], half: float) -> list[Stick | Ring]:
    listed = list(points)
    return [stick(a, b, half) for a, b in zip(listed, listed[1:])]


def unit(way: Vector) -> Vector:
    """The unit vector along a vector; for none, to the right."""
    size = math.hypot(way.x, way.y)
    return way / size if size else Vector(1.0, 0.0)


def arc_points(centre: Vector, radius: float, start: float, end: float) -> list[Vector]:
    """Points along an arc, some 10° apart."""
    while end < start:
        end += math.tau
    count = max(2, math.ceil((end - start) / 0.17))
    angles = (start + (end - start) * k / count for k in range(count + 1))
    return [centre + Vector(math.cos(a), math.sin(a)) * radius for a in angles]


def right_angle_points(shape: RightAngle) -> tuple[Vector, Vector, Vector]:
    """The two sides of the small square that are not on the lines themselves."""
    first, second = shape.first * shape.size, shape.second * shape.size
    return shape.corner + first, shape.corner + first + second, shape.corner + second


def meets(box: Box, piece: Stick | Ring, clearance: float) -> bool:
    """Whether ink comes nearer to a box than a distance (near corners: nearer than 1.42 of it)."""
    left, bottom, right, top = box
    p_left, p_bottom, p_right, p_top = piece.box
    if (
        p_left > right + clearance
        or p_right < left - clearance
        or p_bottom > top + clearance
        or p_top < bottom - clearance
    ):
        return False
    room = piece.half + clearance
    if isinstance(piece, Ring):
        x, y = piece.centre
        near = math.hypot(max(left - x, x - right, 0.0), max(bottom - y, y - top, 0.0))
        far = math.hypot(max(x - left, right - x), max(y - bottom, top - y))
        return near <= piece.radius + room and far >= piece.radius - room
    return crosses((left - room, bottom - room, right + room, top + room), piece.start, piece.end)


def crosses(box: Box, start: Vector, end: Vector) -> bool:
    """Whether a straight line from point to point has a part within a box."""
    low, high = 0.0, 1.0
    for at, way, least, most in (
        (start.x, end.x - start.x, box[0], box[2]),
        (start.y, end.y - start.y, box[1], box[3]),
    ):
        if way == 0:
            if not least <= at <= most:
                return False
            continue
        one, two = (least - at) / way, (most - at) / way
        low, high = max(low, min(one, two)), min(high, max(one, two))
        if low > high:
            return False
    return True


def overlap(one: Box, two: Box, apart: float = 0.0) -> bool:
    """Whether two boxes come nearer to each other than a distance, in both directions."""
    return (
        one[0] < two[2] + apart
        and two[0] < one[2] + apart
        and one[1] < two[3] + apart
        and two[1] < one[3] + apart
    )


# --- candidates -----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Candidate:
    box: Box
    size: float
    cost: float
    leader: Segment | None


def _extent(label: Label, size: float) -> tuple[float, float]:
    """Width and height of a label's ink."""
    left, bottom, right, top = outline(label.content).box
    width, height = (right - left) * size, (top - bottom) * size
    if label.ringed:
        width = height = max(math.hypot(width, height) + 0.5, 1.25 * size) + style.RING.width
    return width, height


def _beside(at: Vector, side: Side, gap: float, width: float, height: float) -> Box:
    across, up = _SIDES[side]
    slant = gap * (math.sqrt(0.5) if across and up else 1.0)
    x = at.x + across * (slant + width / 2)
    y = at.y + up * (slant + height / 2)
    return x - width / 2, y - height / 2, x + width / 2, y + height / 2


def _candidates(
    label: Label, region: Box, pieces: list[Stick | Ring], solid: list[Box]
) -> list[_Candidate]:
    """Places for a label that meet no ink, best first; near ones, smaller ones, then any."""
    width, height = _extent(label, label.size)
    if label.fixed:
        box = _beside(label.at, label.sides[0], label.gap, width, height)
        return [_Candidate(box, label.size, 0.0, None)]
    reach = _FARTHER[-1] + label.gap + 2
    points = (label.at, *label.moves)
    around = union(
        (p.x - width - reach, p.y - height - reach, p.x + width + reach, p.y + height + reach)
        for p in points
    )
    near = [each for each in pieces if overlap(each.box, around)]
    found: list[_Candidate] = []
    for share in (1.0, SMALLEST):
        size = label.size * share
        width, height = _extent(label, size)
        for farther in _FARTHER:
            for place, point in enumerate(points):
                for rank, side in enumerate(label.sides):
                    if side == "centre" and farther:
                        continue
                    box = _beside(point, side, label.gap + farther, width, height)
                    cost = 0.5 * rank + 0.4 * place + 1.2 * farther + 8 * (1 - share)
                    made = _candidate(label, box, size, cost, point, farther, region, near, solid)
                    if made is not None:
                        found.append(made)
            if len(found) >= _ENOUGH:
                break
        if found:
            break
    return sorted(found, key=lambda each: each.cost)


def _candidate(
    label: Label,
    box: Box,
    size: float,
    cost: float,
    point: Vector,
    farther: float,
    region: Box,
    near: list[Stick | Ring],
    solid: list[Box],
) -> _Candidate | None:
    if (
        box[0] < region[0]
        or box[1] < region[1]
        or box[2] > region[2]
        or box[3] > region[3]
        or any(meets(box, each, CLEARANCE) for each in near)
        or any(overlap(box, each, APART) for each in solid)
    ):
        return None
    cost += sum(0.35 for each in near if meets(box, each, 1.0))
    leader = None
    if farther >= LEADER_FROM:
        leader = _leader(box, point, label.gap)
        line = stick(*leader, style.STROKES["leader"].width / 2)
        if any(overlap(line.box, each) and crosses(each, *leader) for each in solid):
            return None
        cost += 2.0 + sum(0.5 for each in near if _cross(leader, each))
    return _Candidate(box, size, cost, leader)


def _leader(box: Box, point: Vector, gap: float) -> Segment:
    """From the box's nearest point, a little off, to a little before the point."""
    start = Vector(min(max(point.x, box[0]), box[2]), min(max(point.y, box[1]), box[3]))
    way = unit(point - start)
    return start + way * 0.5, point - way * max(0.3, min(gap - 0.4, 0.6 * gap))


def _cross(leader: Segment, piece: Stick | Ring) -> bool:
    start, end = leader
    if isinstance(piece, Ring):
        inside = [math.hypot(*(p - piece.centre)) < piece.radius for p in leader]
        return inside[0] != inside[1]
    one = (end - start).cross(piece.start - start) * (end - start).cross(piece.end - start)
    way = piece.end - piece.start
    two = way.cross(start - piece.start) * way.cross(end - piece.start)
    return bool(one < 0 and two < 0)


def _anywhere(
    label: Label, region: Box, pieces: list[Stick | Ring], solid: list[Box]
) -> list[_Candidate]:
    """Places on a grid over the whole region, nearest first, each with a leader line."""
    width, height = _extent(label, label.size)
    spots: list[tuple[float, Box]] = []
    across = max(0, math.floor((region[2] - region[0] - width) / _GRID))
    up = max(0, math.floor((region[3] - region[1] - height) / _GRID))
    for column in range(across + 1):
        for row in range(up + 1):
            x, y = region[0] + column * _GRID, region[1] + row * _GRID
            box = (x, y, x + width, y + height)
            spots.append((math.hypot(*(Vector(x + width / 2, y + height / 2) - label.at)), box))
    found = []
    for distance, box in sorted(spots):
        cost = 6 + 1.2 * distance
        made = _candidate(label, box, label.size, cost, label.at, 99, region, pieces, solid)
        if made is not None:
            found.append(made)
            if len(found) >= 3 * _ENOUGH:
                break
    return found


# --- choosing -------------------------------------------------------------------------------------


def _clash(one: _Candidate, two: _Candidate) -> bool:
    if overlap(one.box, two.box, APART):
        return True
    return (
        (one.leader is not None and crosses(_padded(two.box, CLEARANCE), *one.leader))
        or (two.leader is not None and crosses(_padded(one.box, CLEARANCE), *two.leader))
        or (
            one.leader is not None
            and two.leader is not None
            and _cross(one.leader, stick(*two.leader, 0.0))
        )
    )


def _padded(box: Box, by: float) -> Box:
    return box[0] - by, box[1] - by, box[2] + by, box[3] + by


def _choose(offers: list[list[_Candidate]]) -> list[_Candidate] | None:
    """One candidate for each label, none clashing; None if no such choice was found."""
    order = sorted(range(len(offers)), key=lambda k: (len(offers[k]), k))
    chosen: dict[int, _Candidate] = {}
    for index in order:
        if not _settle(index, offers, chosen):
            return None
    for _ in range(4):
        if not any([_improve(index, offers, chosen) for index in order]):
            break
    return [chosen[index] for index in range(len(offers))]


def _settle(index: int, offers: list[list[_Candidate]], chosen: dict[int, _Candidate]) -> bool:
    """Choose the best candidate that is free; else one whose rivals can move."""
    for candidate in offers[index]:
        if not any(_clash(candidate, other) for other in chosen.values()):
            chosen[index] = candidate
            return True
    return any(_move(index, candidate, offers, chosen, math.inf) for candidate in offers[index])


def _improve(index: int, offers: list[list[_Candidate]], chosen: dict[int, _Candidate]) -> bool:
    """Give a label a better place, if that makes the sum of the costs less."""
    now = chosen[index].cost
    return any(
        _move(index, candidate, offers, chosen, now - candidate.cost)
        for candidate in offers[index]
        if candidate.cost < now - 1e-9
    )


def _move(
    index: int,
    candidate: _Candidate,
    offers: list[list[_Candidate]],
    chosen: dict[int, _Candidate],
    gain: float,
) -> bool:
    """Choose a candidate, moving at most two rivals, if that costs less than what it gains."""
    rivals = [k for k, other in chosen.items() if k != index and _clash(candidate, other)]
    if len(rivals) > 2:
        return False
    trial = {k: other for k, other in chosen.items() if k not in rivals}
    trial[index] = candidate
    loss = 0.0
    for rival in rivals:
        for other in offers[rival]:
            if loss + other.cost - chosen[rival].cost >= gain - 1e-9:
                continue
            if not any(_clash(other, each) for each in trial.values()):
                loss += other.cost - chosen[rival].cost
                trial[rival] = other
                break
        else:
            return False
    chosen.update(trial)
    return True


# --- the whole ------------------------------------------------------------------------------------


def place(scene: Scene) -> Placed:
    """The scene with its labels placed, the frame grown where it had to."""
    pieces = [piece for shape in scene.shapes for piece in ink(shape)]
    for _ in range(40):
        made = _placed(scene, pieces)
        if made is not None:
            break
        scene = _grown(scene, _GROWTH)
    else:
        message = "no room for the labels of a picture"
        raise AssertionError(message)
    labels = tuple(
        PlacedLabel(label, each.box, _baseline(label, each), each.size, each.leader)
        for label, each in zip(scene.labels, made, strict=True)
    )
    left, bottom, right, top = union(
        [
            scene.box,
            *(panel.box for panel in scene.panels),
            *(_padded(piece.box, MARGIN) for piece in pieces),
            *(_padded(label.box, MARGIN) for label in labels),
        ]
    )
    headings = [_heading(panel) for panel in scene.panels]
    top = max([top, *(each.box[3] + MARGIN for each in headings)])
    note = _note(scene.note, left, right, bottom)
    words = (*headings, *note)
    box = union([(left, bottom, right, top), *(_padded(each.box, MARGIN) for each in words)])
    return Placed(scene, labels, words, box)


def _placed(scene: Scene, pieces: list[Stick | Ring]) -> list[_Candidate] | None:
    frames = [piece for panel in scene.panels for piece in _frame(panel)]
    everything = [*pieces, *frames]
    fixed = [
        _beside(each.at, each.sides[0], each.gap, *_extent(each, each.size))
        for each in scene.labels
        if each.fixed
    ]
    regions = [_region(label, scene) for label in scene.labels]
    offers = [
        _candidates(label, region, everything, [] if label.fixed else fixed)
        for label, region in zip(scene.labels, regions, strict=True)
    ]
    chosen = _choose(offers) if all(offers) else None
    if chosen is not None:
        return chosen
    for index, label in enumerate(scene.labels):
        if not label.fixed:
            offers[index] += _anywhere(label, regions[index], everything, fixed)
    return _choose(offers) if all(offers) else None


def _region(label: Label, scene: Scene) -> Box:
    """Where a label may stand: in its panel, if it fits into that, else in the picture."""
    width, _ = _extent(label, label.size)
    for panel in scene.panels:
        left, bottom, right, top = panel.box
        inside = left <= label.at.x <= right and bottom <= label.at.y <= top
        if inside and width + 2 * MARGIN <= right - left:
            return _padded(panel.box, -MARGIN)
    left, bottom, right, top = _padded(scene.box, -MARGIN)
    return left, bottom, max(right, left + width), top


def _grown(scene: Scene, by: float) -> Scene:
    panels = tuple(
        replace(panel, box=(panel.box[0], panel.box[1] - by, panel.box[2], panel.box[3]))
        for panel in scene.panels
    )
    left, bottom, right, top = scene.box
    return replace(scene, panels=panels, box=(left, bottom - 2 * by, right, top))


def _frame(panel: Panel) -> Iterator[Stick]:
    left, bottom, right, top = panel.box
    corners = [Vector(left, bottom), Vector(right, bottom), Vector(right, top), Vector(left, top)]
    for a, b in zip(corners, (*corners[1:], corners[0])):
        yield stick(a, b, style.STROKES["frame"].width / 2)


def _baseline(label: Label, candidate: _Candidate) -> Vector:
    """Where the outline starts, so that its ink is in the middle of the box."""
    left, bottom, right, top = outline(label.content).box
    x = (candidate.box[0] + candidate.box[2]) / 2 - candidate.size * (left + right) / 2
    y = (candidate.box[1] + candidate.box[3]) / 2 - candidate.size * (bottom + top) / 2
    return Vector(x, y)


def _heading(panel: Panel) -> PlacedLabel:
    left, _, right, top = panel.box
    return _line(
        Words(panel.name), Vector((left + right) / 2, top + 1.6), HEADING_SIZE, middle=True
    )


def _line(content: Layout, at: Vector, size: float, *, middle: bool = False) -> PlacedLabel:
    """Words whose baseline starts at a point, or has its middle there."""
    left, bottom, right, top = (size * each for each in outline(content).box)
    x = at.x - (left + right) / 2 if middle else at.x - left
    label = Label(content, at, ("centre",), 0.0, size, fixed=True)
    box = (x + left, at.y + bottom, x + right, at.y + top)
    return PlacedLabel(label, box, Vector(x, at.y), size)


def _note(note: Layout | None, left: float, right: float, bottom: float) -> Iterator[PlacedLabel]:
    """The note in lines beneath the picture."""
    if note is None:
        return
    for index, content in enumerate(_lines(note, (right - left - 2 * MARGIN) / NOTE_SIZE)):
        y = bottom - (1.5 + 1.35 * index) * NOTE_SIZE
        yield _line(content, Vector(left + MARGIN, y), NOTE_SIZE)


def _lines(note: Layout, width: float) -> list[Layout]:
    """The note broken into lines no wider than so many em, where it has spaces."""
    items = note.items if isinstance(note, Phrase) and note.separator == " " else (note,)
    words: list[Layout] = []
    for item in items:
        words.extend(map(Words, item.text.split()) if isinstance(item, Words) else [item])
    lines: list[list[Layout]] = []
    for word in words:
        if lines and _width(Phrase((*lines[-1], word))) <= width:
            lines[-1].append(word)
        else:
            lines.append([word])
    return [Phrase(tuple(line)) for line in lines]


def _width(layout: Layout) -> float:
    left, _, right, _ = outline(layout).box
    return right - left
