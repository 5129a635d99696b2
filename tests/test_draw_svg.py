"""Pictures: what the SVG of a scene holds, read back from its text, not from what made it."""

from __future__ import annotations

import hashlib
import math
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from itertools import combinations, pairwise, permutations
from pathlib import Path

import pytest
from hypothesis import given, settings
from strategies import CONTENTS, pictures

import restitution as r
from restitution import examples
from restitution.drawing import scenes, style, svg
from restitution.drawing.ink import crosses, padded
from restitution.drawing.labels import Placed, place
from restitution.drawing.scene import (
    Arc,
    Arrow,
    Disc,
    Dot,
    Label,
    Line,
    Panel,
    RightAngle,
    RoundWall,
    Scene,
    StraightWall,
)
from restitution.drawing.svg import render, to_svg
from restitution.render import layout as l
from restitution.render.glyphs import Box, outline
from restitution.vector import Vector

NS = "{http://www.w3.org/2000/svg}"
HREF = "{http://www.w3.org/1999/xlink}href"
ALPHA, U = l.Letter("alpha"), l.Letter("u")
U_COS = l.Product((U, l.Function("cos", ALPHA)))

# --- reading SVG back -----------------------------------------------------------------------------

TOKEN = re.compile(r"[A-Za-z]|-?(?:\d+\.?\d*|\.\d+)(?:e-?\d+)?")


def pieces(data: str) -> list[list[tuple[float, float]]]:
    """The subpaths of path data (M L l q c h v A Z) as points close together."""
    tokens = TOKEN.findall(data)
    paths: list[list[tuple[float, float]]] = []
    command = ""
    x = y = 0.0
    at = 0

    def take(count: int) -> list[float]:
        nonlocal at
        at += count
        return [float(each) for each in tokens[at - count : at]]

    while at < len(tokens):
        if tokens[at].isalpha():
            command = tokens[at]
            at += 1
        match command:
            case "M":
                x, y = take(2)
                paths.append([(x, y)])
                command = "L"
                continue
            case "Z":
                x, y = paths[-1][0]
                paths[-1].append((x, y))
                continue
            case "L":
                end = take(2)
                paths[-1].append((end[0], end[1]))
            case "l":
                dx, dy = take(2)
                paths[-1].append((x + dx, y + dy))
            case "h":
                paths[-1].append((x + take(1)[0], y))
            case "v":
                paths[-1].append((x, y + take(1)[0]))
            case "q":
                a, b, c, d = take(4)
                for k in range(1, 41):
                    t = k / 40
                    paths[-1].append(
                        (
                            x + 2 * t * (1 - t) * a + t * t * c,
                            y + 2 * t * (1 - t) * b + t * t * d,
                        )
                    )
            case "A":
                r, _, _, large, sweep, c, d = take(7)
                assert large == sweep == 0
                paths[-1].extend(small_arc((x, y), (c, d), r))
            case _:
                raise AssertionError(command)
        x, y = paths[-1][-1]
    return paths


def small_arc(
    start: tuple[float, float], end: tuple[float, float], r: float
) -> list[tuple[float, float]]:
    """Points on the arc of at most half a turn that is anticlockwise on the screen."""
    chord = math.dist(start, end)
    r = max(r, chord / 2)
    half = math.asin(min(1.0, chord / 2 / r)) if chord else 0.0
    mid = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    if not chord:
        return [end]
    # The centre lies to the left of the way from start to end, as seen with y down.
    ux, uy = (end[0] - start[0]) / chord, (end[1] - start[1]) / chord
    away = r * math.cos(half)
    centre = (mid[0] + uy * away, mid[1] - ux * away)
    first = math.atan2(start[1] - centre[1], start[0] - centre[0])
    angles = [first - 2 * half * k / 30 for k in range(31)]
    made = [(centre[0] + r * math.cos(a), centre[1] + r * math.sin(a)) for a in angles]
    assert math.dist(made[-1], end) < 0.02 + 0.05 * (half > 1.5)
    return made


def lines_of(root: ET.Element) -> list[tuple[str, float, list[tuple[float, float]]]]:
    """Every line that is drawn, but the letters: class, width, points (y up)."""
    found = []
    for element in root.iter():
        name = element.get("class", "")
        if element.tag == NS + "path" and name and element.get("id") is None:
            for path in pieces(element.attrib["d"]):
                width = float(element.get("stroke-width", 0))
                found.append((name, width, [(x, -y) for x, y in path]))
        elif element.tag == NS + "circle":
            x, y, r = (float(element.attrib[each]) for each in ("cx", "cy", "r"))
            turn = [k * math.tau / 90 for k in range(91)]
            circle = [(x + r * math.cos(a), -y + r * math.sin(a)) for a in turn]
            found.append((name, float(element.get("stroke-width", 0)), circle))
    return found


def inked(root: ET.Element) -> list[Box]:
    """The true extent of the letters of every label, from their outlines."""
    store = {
        element.attrib["id"]: pieces(element.attrib["d"])
        for element in root.iter(NS + "path")
        if element.get("id")
    }
    boxes = []
    for group in root.iter(NS + "g"):
        if group.get("class") != "label":
            continue
        numbers = [float(n) for n in re.findall(r"-?[\d.]+", group.attrib["transform"])]
        dx, dy, scale = numbers
        xs: list[float] = []
        ys: list[float] = []
        for child in group:
            if child.tag == NS + "use":
                moved = child.get("transform")
                if moved:
                    x, y, s = (float(n) for n in re.findall(r"-?[\d.]+", moved))
                else:
                    x, y, s = float(child.attrib["x"]), float(child.attrib["y"]), 1.0
                points = [p for path in store[child.attrib[HREF][1:]] for p in path]
            else:
                x, y, s = 0.0, 0.0, 1.0
                points = [p for path in pieces(child.attrib["d"]) for p in path]
            xs += [dx + scale * (x + s * a) for a, _ in points]
            ys += [-(dy + scale * (y + s * b)) for _, b in points]
        boxes.append((min(xs), min(ys), max(xs), max(ys)))
    return boxes


def within(inner: Box, outer: Box, by: float = 0.0) -> bool:
    return (
        outer[0] + by <= inner[0]
        and outer[1] + by <= inner[1]
        and inner[2] <= outer[2] - by
        and inner[3] <= outer[3] - by
    )


def apart(one: Box, two: Box) -> float:
    """The space between two boxes, negative if they overlap."""
    return max(two[0] - one[2], one[0] - two[2], two[1] - one[3], one[1] - two[3])


def densely(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    found = [points[0]]
    for (a, b), (c, d) in pairwise(points):
        count = max(1, math.ceil(math.hypot(c - a, d - b) / 0.1))
        found += [(a + (c - a) * k / count, b + (d - b) * k / count) for k in range(1, count + 1)]
    return found


def check(placed: Placed) -> ET.Element:
    """What holds for every picture."""
    text = render(placed)
    root = ET.fromstring(text)
    assert root.tag == NS + "svg"

    ids = [each.attrib["id"] for each in root.iter() if "id" in each.attrib]
    assert len(ids) == len(set(ids))
    used = {each.attrib[HREF] for each in root.iter() if HREF in each.attrib}
    assert used <= {f"#{each}" for each in ids}
    assert set(root.attrib["aria-labelledby"].split()) <= set(ids)
    assert root.attrib["role"] == "img"
    title, description = root.find(NS + "title"), root.find(NS + "desc")
    assert title is not None and (title.text or "") == placed.scene.title
    assert description is not None
    assert (description.text or "") == placed.scene.description
    tags = {each.tag.removeprefix(NS) for each in root.iter()}
    assert tags <= {"svg", "title", "desc", "style", "defs", "path", "use", "g", "circle"}
    assert "url(" not in text and "font" not in text
    for each in root.iter(NS + "path"):
        assert not re.search(r"\.\d{3}|e-|nan|inf", each.attrib["d"])

    left, top, width, height = (float(each) for each in root.attrib["viewBox"].split())
    page = (left - 0.01, -top - height - 0.01, left + width + 0.01, -top + 0.01)  # as rounded
    words = [*placed.labels, *placed.words]
    boxes = [each.box for each in words]
    for box in boxes:
        assert within(box, page)
    for one, two in combinations(boxes, 2):
        assert apart(one, two) > 0.1
    for box, true, word in zip(boxes, inked(root), words, strict=True):
        if not word.label.ringed:
            assert box == pytest.approx(true, abs=0.02)
        else:
            assert within(true, box, 0.2)
    for name, line_width, line in lines_of(root):
        if name == "ring":
            continue
        for x, y in densely(line):
            assert within((x, y, x, y), page), (name, x, y)
            for box in boxes:
                assert apart((x, y, x, y), box) > line_width / 2, (name, box)
    return root


# --- every picture --------------------------------------------------------------------------------


@given(pictures())
@settings(max_examples=100, deadline=None)
def test_labels_keep_off_everything_in_any_picture(scene: Scene) -> None:
    check(place(scene))


@pytest.mark.parametrize("content", CONTENTS)
def test_the_box_of_an_outline_is_the_extent_of_its_ink(content: l.Layout) -> None:
    drawn = outline(content)
    xs: list[float] = []
    ys: list[float] = []
    for mark in drawn.marks:
        points = [point for path in pieces(mark.path) for point in path]
        xs += [mark.x + mark.scale * x / 1000 for x, _ in points]
        ys += [mark.y - mark.scale * y / 1000 for _, y in points]
    for bar in drawn.bars:
        xs += [bar.box[0], bar.box[2]]
        ys += [bar.box[1], bar.box[3]]
    assert drawn.box == pytest.approx((min(xs), min(ys), max(xs), max(ys)), abs=1e-3)


def test_nothing_to_see_has_no_outline() -> None:
    assert outline(l.Words("")).marks == outline(l.Words(" ")).marks == ()


def test_outlines_are_set_as_mathematics_is() -> None:
    italic, upright = outline(U), outline(l.Words("u"))
    assert italic.marks[0].path != upright.marks[0].path
    product, sine = outline(l.Product((U, U))), outline(U_COS)
    assert [mark.path for mark in product.marks] == [italic.marks[0].path] * 2
    assert sine.box[2] > product.box[2]
    squared = outline(l.Power(U, l.Number("2")))
    assert squared.marks[1].y > 0.2 and squared.marks[1].scale < 1
    half = outline(l.Fraction(l.Number("1"), l.Number("2")))
    assert len(half.bars) == 1
    above, below = half.marks
    assert above.y > half.bars[0].box[3] > half.bars[0].box[1] > below.y


def test_very_tall_roots_are_put_together() -> None:
    inside: l.Layout = U
    for _ in range(6):
        inside = l.Fraction(U, l.Power(inside, inside) if inside is U else inside)
    drawn = outline(l.Root(l.Fraction(inside, inside)))
    assert drawn.box[3] - drawn.box[1] > 2


# --- one picture ----------------------------------------------------------------------------------


def impact() -> Scene:
    """Two spheres touching, with arrows, components, an angle and an impulse."""
    shapes: list[object] = []
    labels: list[Label] = []
    for left in (0.0, 43.0):
        a, b = Vector(left + 13.5, 22.0), Vector(left + 27.5, 22.0)
        tip = a + Vector(-9.0, 8.0)
        foot = Vector(tip.x, a.y)
        shapes += [
            Line("line_of_centres", Vector(left + 2, 22), Vector(left + 39, 22)),
            Line("across", Vector(left + 20.5, 8), Vector(left + 20.5, 37)),
            Disc("A", a, 7.0),
            Disc("B", b, 7.0),
            Arrow("velocity", a, tip),
            Arrow("component", a, foot),
            Arrow("component", foot, tip),
            RightAngle(foot, Vector(1, 0), Vector(0, 1)),
            Arc("angle", a, 4.0, math.pi - math.atan2(8, 9), math.pi),
            Line("onward", b, b + Vector(9, -9)),
            Arrow("velocity", b, b + Vector(9, 9)),
            Arrow("impulse", Vector(left + 18, 5), Vector(left + 4, 5)),
            Arrow("impulse", Vector(left + 22, 5), Vector(left + 36, 5)),
        ]
        labels += [
            Label(U, (a + tip) / 2, ("ne", "n")),
            Label(U_COS, (a + foot) / 2, ("s", "sw")),
            Label(l.Product((U, l.Function("sin", ALPHA))), (foot + tip) / 2, ("w", "nw", "e")),
            Label(ALPHA, a + Vector(-4, 1.5), ("w", "nw"), 0.6),
            Label(l.Words("A"), a, ("centre",), fixed=True),
            Label(l.Words("B"), b, ("centre",), fixed=True),
            Label(l.Letter("I"), Vector(left + 11, 5), ("s", "n"), 1.6),
            Label(l.Letter("I"), Vector(left + 29, 5), ("s", "n"), 1.6),
        ]
    return Scene(
        "One impact",
        "Before: A moves at u & B at w.",
        (0, 0, 84, 42),
        tuple(shapes),
        tuple(labels),
        (Panel("Before", (0, 0, 41, 42)), Panel("After", (43, 0, 84, 42))),
        l.Phrase((l.Words("Drawn for"), l.equation(U, l.Number("1")))),
    )


def test_a_whole_impact() -> None:
    placed = place(impact())
    root = check(placed)
    assert len(render(placed).encode()) < 60_000
    assert placed.box[2] - placed.box[0] == pytest.approx(84, abs=0.2)
    assert {each.size for each in placed.labels} == {3.0}
    # Each outline is stored once.
    store = [each.attrib["d"] for each in root.iter(NS + "path") if each.get("id")]
    assert len(store) == len(set(store))
    assert len(list(root.iter(NS + "use"))) > 2 * len(store)


def test_the_same_scene_is_the_same_text_in_every_process() -> None:
    code = (
        "import hashlib, test_draw_svg as t;"
        "print(hashlib.sha256(t.to_svg(t.impact()).encode()).hexdigest())"
    )
    here = to_svg(impact())
    outline.cache_clear()
    assert to_svg(impact()) == here
    there = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONHASHSEED": "1"},
        cwd=Path(__file__).parent,
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert there.strip() == hashlib.sha256(here.encode()).hexdigest()


def test_two_pictures_share_no_id() -> None:
    one = Scene("One", "", (0, 0, 9, 9), labels=(Label(U, Vector(4, 4)),))
    two = Scene("Two", "", (0, 0, 9, 9), labels=(Label(U, Vector(4, 4)),))
    ids = [set(re.findall(r'id="(\w+)', to_svg(each))) for each in (one, two)]
    assert ids[0].isdisjoint(ids[1])


def luminance(colour: str, strength: float, ground: str) -> float:
    """Relative luminance, as WCAG defines it, of ink of a strength on a ground."""
    total = 0.0
    for at, weight in ((1, 0.2126), (3, 0.7152), (5, 0.0722)):
        over, under = int(colour[at : at + 2], 16), int(ground[at : at + 2], 16)
        part = (strength * over + (1 - strength) * under) / 255
        total += weight * (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4)
    return total


def test_lines_are_seen_on_light_and_dark_grounds() -> None:
    strokes = [stroke for role, stroke in style.STROKES.items() if role != "frame"]
    weakest = min(each.strength for each in [*strokes, style.GHOST, style.DISC, style.WALL])
    for ink, accent, ground in (
        (svg.INK, svg.ACCENT, "#ffffff"),
        (svg.INK_ON_DARK, svg.ACCENT_ON_DARK, svg.PAPER_OF_DARK),
        (svg.INK_ON_DARK, svg.ACCENT_ON_DARK, "#000000"),
    ):
        for colour, strength in ((ink, weakest), (accent, 1.0)):
            pair = [luminance(colour, strength, ground), luminance(ground, 1, ground)]
            assert (max(pair) + 0.05) / (min(pair) + 0.05) >= 4.5


def test_the_style_of_a_picture_touches_nothing_else_on_its_page() -> None:
    root = ET.fromstring(to_svg(impact()))
    css = root.find(NS + "style")
    assert css is not None and css.text is not None
    assert "@media (prefers-color-scheme:dark)" in css.text
    selectors = re.findall(r"([^{}]+)\{(?=[^{}]*\})", css.text)
    assert len(selectors) >= 5
    assert all(each.startswith("#" + root.attrib["id"]) for each in selectors)
    # Viewers that read no style find plain colours.
    for each in root.iter():
        assert each.get("stroke") in (None, "none", svg.INK, svg.ACCENT)
        assert each.get("fill") in (None, "none", svg.INK)


def classes(root: ET.Element, name: str) -> list[ET.Element]:
    return [each for each in root.iter() if each.get("class") == name]


def drawn(*shapes: object) -> ET.Element:
    return ET.fromstring(to_svg(Scene("", "", (0, 0, 40, 40), tuple(shapes))))


def test_an_arrow_ends_with_its_tip() -> None:
    root = drawn(Arrow("velocity", Vector(3, 4), Vector(33, 14)))
    head, shaft = classes(root, "head")[0], classes(root, "velocity")[0]
    (outline_of_head,) = pieces(head.attrib["d"])
    assert (33, -14) in outline_of_head
    (line,) = pieces(shaft.attrib["d"])
    assert line[0] == (3, -4)
    # The blunt end of the shaft is hidden in the head.
    assert 0.9 < math.dist(line[1], (33, -14)) < style.HEADS["velocity"].length
    assert "marker" not in ET.tostring(root, encoding="unicode")


@pytest.mark.parametrize("length", [0.3, 1.0, 2.5, 6.0])
def test_the_head_of_a_short_arrow_is_not_longer_than_the_arrow(length: float) -> None:
    root = drawn(Arrow("velocity", Vector(5, 5), Vector(5 + length, 5)))
    (corners,) = pieces(classes(root, "head")[0].attrib["d"])
    assert min(x for x, _ in corners) >= 5
    assert max(x for x, _ in corners) == pytest.approx(5 + length)


def test_an_arrow_of_no_length_is_not_drawn() -> None:
    root = drawn(
        Arrow("velocity", Vector(5, 5), Vector(5, 5)), Arrow("impulse", Vector(5, 5), Vector(5, 5))
    )
    assert not classes(root, "head") and not classes(root, "impulse")


def test_a_dimension_line_has_two_heads() -> None:
    root = drawn(Arrow("measure", Vector(3, 4), Vector(33, 4), both=True))
    heads = pieces(classes(root, "head")[0].attrib["d"])
    assert len(heads) == 2
    assert any((3, -4) in each for each in heads) and any((33, -4) in each for each in heads)


def test_an_impulse_has_two_shafts_and_a_hollow_head() -> None:
    root = drawn(Arrow("impulse", Vector(5, 5), Vector(25, 5)))
    shaft = classes(root, "impulse")[0]
    assert shaft.get("fill") is None and root.attrib["fill"] == "none"
    (line,) = pieces(shaft.attrib["d"])
    tails = sorted(y for x, y in line if x == 5)
    assert tails[1] - tails[0] == pytest.approx(style.SHAFT_GAP)
    assert (25, -5) in line


def test_a_wall_is_hatched_evenly_at_45_degrees_on_its_far_side() -> None:
    for far in (Vector(0, -1), Vector(0, 1), Vector(0.5, -2)):
        root = drawn(StraightWall("W", Vector(2, 20), Vector(38, 20), far))
        strokes = pieces(classes(root, "hatch")[0].attrib["d"])
        feet = [stroke[0][0] for stroke in strokes]
        steps = [b - a for a, b in pairwise(feet)]
        assert max(steps) - min(steps) < 0.03
        assert all(2 <= x <= 38 for stroke in strokes for x, _ in stroke)
        for (x1, y1), (x2, y2) in strokes:
            assert y1 == -20
            assert (y2 > y1) == (far.y < 0)
            assert abs(x2 - x1) == pytest.approx(abs(y2 - y1), abs=0.02)


@pytest.mark.parametrize("hatched", ["inside", "outside"])
def test_a_round_wall_is_hatched_on_the_side_that_is_said(hatched: str) -> None:
    for start, end in ((0.3, 2.8), (0.0, math.tau), (-2.0, 1.0), (3.0, 4.0)):
        wall = RoundWall("W", Vector(20, 20), 12, start, end, hatched)
        root = drawn(wall)
        strokes = pieces(classes(root, "hatch")[0].attrib["d"])
        ends = [math.dist(stroke[1], (20, -20)) for stroke in strokes]
        assert all((each > 12) == (hatched == "outside") for each in ends)
        turns = [math.atan2(-20 - y, x - 20) for (x, y), _ in strokes]
        steps = [(b - a) % math.tau for a, b in pairwise(turns)]
        assert max(steps) - min(steps) < 0.01
        (edge,) = pieces(classes(root, "wall")[0].attrib["d"])
        assert all(math.dist(p, (20, -20)) == pytest.approx(12, abs=0.05) for p in edge)
        for angle, point in ((start, edge[0]), (end, edge[-1])):
            expected = (20 + 12 * math.cos(angle), -20 - 12 * math.sin(angle))
            assert math.dist(point, expected) < 0.03
        middle = edge[len(edge) // 2]
        half = (start + end) / 2
        assert math.dist(middle, (20 + 12 * math.cos(half), -20 - 12 * math.sin(half))) < 1


def test_a_number_in_a_ring_is_in_its_middle() -> None:
    scene = Scene(
        "", "", (0, 0, 20, 20), labels=(Label(l.Number("12"), Vector(9, 9), ringed=True),)
    )
    placed = place(scene)
    root = check(placed)
    ring = classes(root, "ring")[0]
    (box,) = inked(root)
    assert float(ring.attrib["cx"]) == pytest.approx((box[0] + box[2]) / 2, abs=0.02)
    assert -float(ring.attrib["cy"]) == pytest.approx((box[1] + box[3]) / 2, abs=0.02)
    reach = math.hypot(box[2] - box[0], box[3] - box[1]) / 2
    assert float(ring.attrib["r"]) > reach + 0.1


# --- labels ---------------------------------------------------------------------------------------


def test_a_label_stands_on_its_first_side_where_there_is_room() -> None:
    for side, sign in (("n", (0, 1)), ("e", (1, 0)), ("sw", (-1, -1)), ("centre", (0, 0))):
        scene = Scene("", "", (0, 0, 40, 40), labels=(Label(U, Vector(20, 20), (side,), 2.0),))
        left, bottom, right, top = place(scene).labels[0].box
        x, y = (left + right) / 2 - 20, (bottom + top) / 2 - 20
        assert (round(x, 6) > 0) - (round(x, 6) < 0) == sign[0]
        assert (round(y, 6) > 0) - (round(y, 6) < 0) == sign[1]


def test_a_letter_stays_in_its_disc_unless_an_arrow_starts_there() -> None:
    disc, letter = (
        Disc("A", Vector(20, 20), 7),
        Label(l.Words("A"), Vector(20, 20), ("centre",), fixed=True),
    )
    free = place(Scene("", "", (0, 0, 40, 40), (disc,), (letter,)))
    left, bottom, right, top = free.labels[0].box
    assert ((left + right) / 2, (bottom + top) / 2) == pytest.approx((20, 20))
    arrow = Arrow("velocity", Vector(20, 20), Vector(38, 30))
    check(place(Scene("", "", (0, 0, 40, 40), (disc, arrow), (letter,))))


def test_a_label_is_not_parted_from_its_point_by_a_strong_line() -> None:
    bar = Arrow("velocity", Vector(5, 18.4), Vector(35, 18.4))
    label = Label(U, Vector(20, 20), ("s", "n"), 2.0)
    box = place(Scene("", "", (0, 0, 40, 40), (bar,), (label,))).labels[0].box
    assert box[1] > 20


def test_a_leader_line_is_no_bar_beneath_another_label() -> None:
    solution = r.solve(r.parse(examples.text("two-spheres-with-vectors")))
    (scene,) = scenes(solution, letters=r.explain(solution).letters)
    for one, two in permutations(place(scene).labels, 2):
        if one.leader is not None:
            assert not crosses(padded(two.box, 1.3), *one.leader)


def test_a_note_begins_where_the_first_panel_does() -> None:
    panel = Panel("Before", (20.0, 0.0, 60.0, 20.0))
    scene = Scene("", "", (0, 0, 80, 20), panels=(panel,), note=l.Words("Not to scale."))
    note = place(scene).words[-1]
    assert 20 <= note.box[0] < 22


def test_labels_side_by_side_do_not_read_as_one() -> None:
    labels = tuple(Label(U_COS, Vector(20 + 8 * k, 20), ("e", "w")) for k in range(4))
    placed = place(Scene("", "", (0, 0, 80, 40), labels=labels)).labels
    for one, two in combinations([each.box for each in placed], 2):
        aside = max(two[0] - one[2], one[0] - two[2])
        above = max(two[1] - one[3], one[1] - two[3])
        assert aside > 1.2 or above > 0.5


def test_labels_that_want_the_same_place_make_room_for_each_other() -> None:
    # Each may stand on one side only of its own point, but the first may move.
    labels = (
        Label(U_COS, Vector(10, 20), ("e", "w"), 1.0),
        Label(U_COS, Vector(21, 20), ("w",), 1.0),
    )
    one, two = place(Scene("", "", (0, 0, 40, 40), labels=labels)).labels
    assert one.box[2] < 10 and two.box[0] > 10
    assert one.leader is None and two.leader is None


def test_crowded_labels_get_leaders_and_the_frame_grows() -> None:
    spokes = [Vector(math.cos(k), math.sin(k)) for k in range(6)]
    shapes = tuple(Line("velocity", Vector(15, 15), Vector(15, 15) + s * 12) for s in spokes)
    labels = tuple(
        Label(U_COS, Vector(15, 15) + spokes[k % 6] * (4 + k % 5), ("ne", "n")) for k in range(22)
    )
    scene = Scene("", "", (0, 0, 30, 30), shapes, labels, (Panel("Before", (0, 0, 30, 30)),))
    placed = place(scene)
    root = check(placed)
    assert any(each.leader for each in placed.labels)
    assert placed.scene.panels[0].box[1] < 0 == scene.panels[0].box[1]
    assert classes(root, "leader")
    for each in placed.labels:
        assert within(each.box, placed.scene.panels[0].box)


def test_a_label_wider_than_its_panel_is_still_in_the_picture() -> None:
    wide = l.Words("a label that is a good deal wider than its panel")
    scene = Scene(
        "",
        "",
        (0, 0, 20, 20),
        labels=(Label(wide, Vector(10, 10)),),
        panels=(Panel("Before", (0, 0, 20, 20)),),
    )
    check(place(scene))


def test_panels_stay_of_one_height() -> None:
    labels = tuple(Label(U_COS, Vector(10, 10)) for _ in range(20))
    panels = (Panel("Before", (0, 0, 20, 20)), Panel("After", (22, 0, 42, 20)))
    placed = place(Scene("", "", (0, 0, 42, 20), labels=labels, panels=panels))
    check(placed)
    before, after = placed.scene.panels
    assert before.box[1::2] == after.box[1::2] and before.box[1] < 0


def test_a_long_note_is_broken_into_lines() -> None:
    words = l.Words("Drawn for values that satisfy what is given, and not to scale otherwise,")
    note = l.Phrase((words, l.equation(U, l.Number("1")), words))
    placed = place(Scene("", "", (0, 0, 50, 20), (Dot("N", Vector(9, 9)),), note=note))
    check(placed)
    assert len(placed.words) > 2
    assert placed.box[2] - placed.box[0] <= 50 + 1e-9
    lefts = {round(each.box[0], 6) for each in placed.words}
    assert len(lefts) == 1


def test_pictures_in_one_file_share_their_glyphs_and_are_told_at_its_root() -> None:
    several = scenes(r.solve(r.parse(examples.text("corner"))))
    whole = svg.stacked(several)
    root = ET.fromstring(whole)
    assert root.get("role") == "img"
    title, description, *_ = root
    assert title.tag.endswith("title") and description.tag.endswith("desc")
    for scene in several:
        assert scene.title in (title.text or "") and scene.description in (description.text or "")
    outlines = [path.get("d") for path in root.iterfind(f"./{NS}defs/{NS}path")]
    assert len(outlines) == len(set(outlines)) and len(list(root.iter(f"{NS}defs"))) == 1
    ids = [each.get("id") for each in root.iter() if each.get("id")]
    assert len(ids) == len(set(ids))
