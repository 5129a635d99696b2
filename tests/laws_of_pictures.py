"""Laws of pictures of impacts: their geometry, measured on the scenes, against the mechanics."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest
from laws_of_questions import leaves
from statements import EXAMPLES, explained, law, solved

from restitution.drawing import scenes as pictures
from restitution.drawing.ink import ink
from restitution.drawing.labels import place
from restitution.drawing.scene import (
    WIDTH,
    Arrow,
    Disc,
    Line,
    Panel,
    RoundWall,
    Scene,
    Shape,
    StraightWall,
)
from restitution.drawing.velocities import TINY
from restitution.expression.tree import letters as names_in
from restitution.problem import Let, trees
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.solving import Solution

NEAR = 1e-6


def scenes(solution: Solution, part: str | None = None) -> list[Scene]:
    """The pictures of impacts; the plans of paths have tests of their own."""
    return [scene for scene in pictures(solution, part) if scene.event is not None]


# --- reading a scene back -------------------------------------------------------------------------


def length(v: Sequence[float]) -> float:
    return math.hypot(*v)


def angle_between(a: Sequence[float], b: Sequence[float]) -> float:
    return abs(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]))


@dataclass(frozen=True)
class Shown:
    """What one panel shows."""

    scene: Scene
    panel: Panel

    def of(self, kind: type, role: str | None = None) -> list:
        return [
            shape
            for shape in self.scene.shapes
            if isinstance(shape, kind)
            and (role is None or getattr(shape, "role", None) == role)
            and self.panel.box[0] <= middle(shape) <= self.panel.box[2]
        ]

    @property
    def discs(self) -> dict[str, Disc]:
        return {disc.name: disc for disc in self.of(Disc)}

    def labels(self) -> list[str]:
        left, _, right, _ = self.panel.box
        return [to_text(x.content) for x in self.scene.labels if left <= x.at.x <= right]

    def velocity(self, name: str) -> tuple[float, float]:
        """The arrow of a sphere: along a radius to or from its rim, or beside it from above it."""
        disc = self.discs[name]
        found = [
            (end - start)
            for start, end in ((a.start, a.end) for a in self.of(Arrow, "velocity"))
            if self.starts_or_ends_at(disc, start, end) or self.starts_beside(disc, start)
        ]
        assert len(found) <= 1, (name, found)
        return tuple(found[0]) if found else (0.0, 0.0)

    def starts_or_ends_at(self, disc: Disc, start: Sequence[float], end: Sequence[float]) -> bool:
        outwards = [(near[0] - disc.centre.x, near[1] - disc.centre.y) for near in (start, end)]
        way = (end[0] - start[0], end[1] - start[1])
        radial = all(math.sin(angle_between(each, way)) < NEAR for each in outwards)
        return radial and any(abs(length(each) - disc.radius) < NEAR for each in outwards)

    def starts_beside(self, disc: Disc, start: Sequence[float]) -> bool:
        others = [each for each in self.discs.values() if each is not disc]
        if not others:
            return False
        out = (start[0] - disc.centre.x, start[1] - disc.centre.y)
        line = others[0].centre - disc.centre
        return (
            disc.radius + 0.5 < length(out) < disc.radius + 3
            and abs(math.cos(angle_between(out, line))) < NEAR
        )


def middle(shape: Shape) -> float:
    boxes = [piece.box for piece in ink(shape)]
    return (min(box[0] for box in boxes) + max(box[2] for box in boxes)) / 2


def shown(scene: Scene) -> list[Shown]:
    return [Shown(scene, panel) for panel in scene.panels]


# --- what holds for every picture -----------------------------------------------------------------


def check(scene: Scene) -> None:
    assert [panel.name for panel in scene.panels] == ["Before", "After"]
    boxes = [panel.box for panel in scene.panels]
    sizes = [(box[2] - box[0], box[3] - box[1]) for box in boxes]
    assert sizes[0] == pytest.approx(sizes[1])
    assert scene.box[2] - scene.box[0] == WIDTH
    before, after = shown(scene)
    assert set(before.discs) == set(after.discs)
    for each in (before, after):
        within_its_panel(each)
        touching(each)
        components_add_up(each)
    unchanged_across(before, after)
    impulses(after)
    in_words(scene, before)


def within_its_panel(each: Shown) -> None:
    left, bottom, right, top = each.panel.box
    for shape in each.of(object):
        for piece in ink(shape):
            assert left <= piece.box[0] and piece.box[2] <= right, shape
            assert bottom <= piece.box[1] and piece.box[3] <= top, shape


def touching(each: Shown) -> None:
    discs = list(each.discs.values())
    if len(discs) == 2:
        gap = discs[1].centre - discs[0].centre
        assert length(gap) == pytest.approx(discs[0].radius + discs[1].radius)
        for line in each.of(Line, "line_of_centres"):
            assert math.sin(angle_between(line.end - line.start, gap)) < NEAR
            assert math.sin(angle_between(line.end - discs[0].centre, gap)) < NEAR
    for wall in each.of(StraightWall):
        (disc,) = discs
        along = wall.end - wall.start
        offset = (disc.centre - wall.start).cross(along) / length(along)
        assert abs(offset) == pytest.approx(disc.radius)
        assert wall.far.dot(disc.centre - wall.start) < 0
    for wall in each.of(RoundWall):
        (disc,) = discs
        distance = length(disc.centre - wall.centre)
        inside = wall.hatched == "outside"
        expected = wall.radius + (-disc.radius if inside else disc.radius)
        assert distance == pytest.approx(expected)


def components_add_up(each: Shown) -> None:
    """Two components from the tail of each slanting arrow to its tip, at right angles."""
    parts = each.of(Arrow, "component")
    used = 0
    for arrow in each.of(Arrow, "velocity"):
        first = [p for p in parts if length(p.start - arrow.start) < NEAR]
        second = [p for p in parts if length(p.end - arrow.end) < NEAR]
        if not first:
            continue
        (one,), (two,) = first, second
        used += 2
        assert length(one.end - two.start) < NEAR
        assert abs((one.end - one.start).dot(two.end - two.start)) < NEAR
    assert used == len(parts)


def unchanged_across(before: Shown, after: Shown) -> None:
    """The component along the wall, or across the line of centres: so the scales are equal."""
    for name, disc in before.discs.items():
        others = [each for each in before.discs if each != name]
        walls = before.of(StraightWall)
        if others:
            line = before.discs[others[0]].centre - disc.centre
        elif walls:
            line = (walls[0].end - walls[0].start).turned_left()
        elif before.of(RoundWall):
            line = disc.centre - before.of(RoundWall)[0].centre
        else:
            return
        u, v = before.velocity(name), after.velocity(name)
        if any(0 < length(each) < TINY + NEAR for each in (u, v)):
            continue
        across = line.turned_left() / length(line)
        assert across.dot(u) == pytest.approx(across.dot(v), abs=1e-6)


def impulses(after: Shown) -> None:
    arrows = after.of(Arrow, "impulse")
    discs = list(after.discs.values())
    if len(discs) == 2:
        assert len(arrows) == 2
        gap = discs[1].centre - discs[0].centre
        ways = [arrow.end - arrow.start for arrow in arrows]
        assert length(ways[0] + ways[1]) < NEAR
        assert all(math.sin(angle_between(way, gap)) < NEAR for way in ways)
        for arrow in arrows:  # each beside its own sphere, away from the other
            near = min(discs, key=lambda disc: length(disc.centre - arrow.start))
            other = discs[1] if near is discs[0] else discs[0]
            assert (arrow.end - arrow.start).dot(near.centre - other.centre) > 0
        return
    for wall in after.of(StraightWall):
        (arrow,) = arrows
        way = arrow.end - arrow.start
        assert abs(way.dot(wall.end - wall.start)) < NEAR
        assert way.dot(wall.far) < 0


def in_words(scene: Scene, before: Shown) -> None:
    assert scene.title.startswith("Before and after: ")
    for name in before.discs:
        assert f"{name} " in scene.description
        assert name in before.labels()
    assert "Before: " in scene.description and "After: " in scene.description
    assert scene.description.endswith(".")
    if scene.note is not None:
        assert to_text(scene.note).startswith(("Drawn for ", "The shortest arrows", "Speeds are"))


@law(EXAMPLES)
def pictures_of_impacts_show_what_happens(path: Path) -> None:
    made = scenes(solved(path))
    assert [scene.event for scene in made] == sorted({scene.event for scene in made})
    for scene in made:
        check(scene)
        placed = place(scene)
        for label in placed.labels:
            assert placed.box[0] <= label.box[0] and label.box[2] <= placed.box[2]
            assert placed.box[1] <= label.box[1] and label.box[3] <= placed.box[3]


@law(EXAMPLES)
def letters_of_pictures_are_those_of_the_statement_or_of_the_working(path: Path) -> None:
    solution, working = solved(path), explained(path)
    problem = solution.problem
    known = {name for tree in trees(problem) for name in names_in(tree)}
    known |= {each.name for each in (*problem.spheres, *problem.walls)}
    known |= {step.letter for _, step in problem.steps() if isinstance(step, Let)}
    known |= {"e", *working.letters.values()}
    for scene in pictures(solution, letters=working.letters):
        for label in scene.labels:
            for letter in leaves(label.content, lay.Letter):
                name = f"{letter.name}_{letter.subscript}".rstrip("_")
                if scene.event is not None:
                    assert name in known, (scene.title, to_text(label.content))
