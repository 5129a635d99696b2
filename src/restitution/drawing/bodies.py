"""The bodies of an impact, with their names and masses; the wall; the line of centres."""

from __future__ import annotations

import math
from dataclasses import replace

from restitution.drawing.event import LINE, RADIUS, UP, WALL, Body, Drawing, View
from restitution.drawing.geometry import sides_towards
from restitution.drawing.scene import Label, Line, RoundWall, StraightWall
from restitution.render import layout as lay
from restitution.render.glyphs import outline
from restitution.render.layout import Layout
from restitution.shapes import Circle
from restitution.staging.geometry import floats
from restitution.vector import Vector

_TALLEST = 0.65 * RADIUS  # is a mass below a name
_LEAST = 1.5  # of the letters of a name within a circle


def name_of(name: str) -> Layout:
    """The name of a body, a wall or a point, as the statement writes it."""
    return lay.Letter(name) if len(name) == 1 else lay.Words(name)


def put_lines(view: View, drawing: Drawing) -> None:
    """The line of centres and its perpendicular, or the normal of a wall: outside the circles."""
    if view.kind == "blow":
        return
    reach = LINE
    if view.kind == "wall":
        centre = view.bodies[0].centre
        top = centre + view.n * (reach + 1)
        drawing.shapes.append(Line("across", centre + view.n * RADIUS, top))
        return
    first, second = view.bodies
    for body in (first, second):
        assert body.towards is not None
        out = -body.towards
        edge = body.centre + out * RADIUS
        drawing.shapes.append(Line("line_of_centres", edge, body.centre + out * reach))
    across = second.centre.turned_left() / RADIUS
    drawing.shapes.append(Line("across", -across * (RADIUS + 2.5), across * (RADIUS + 2.5)))


def put_wall(view: View, drawing: Drawing) -> None:
    """The wall at the place of impact; of a round one, an arc."""
    name = view.motion.model.frames[view.number].wall or ""
    wall = view.motion.story.walls[name]
    half = WALL
    if not isinstance(wall.shape, Circle):
        ends = view.t * half
        drawing.shapes.append(StraightWall(name, -ends, ends, -view.n))
        at = ends * 0.9
    else:
        inside = _inside(view, name)
        bend = 24.0
        centre = view.n * (bend if inside else -bend)
        middle = math.atan2(-centre.y, -centre.x)
        spread = half / bend
        drawing.shapes.append(
            RoundWall(
                name,
                centre,
                bend,
                middle - spread,
                middle + spread,
                "outside" if inside else "inside",
            )
        )
        drawing.shapes.append(Line("across", -view.t * half * 0.8, view.t * half * 0.8))
        at = centre + Vector(math.cos(middle + spread), math.sin(middle + spread)) * bend
    if len(view.motion.story.walls) > 1:
        drawing.labels.append(Label(name_of(name), at, sides_towards(-view.n), 2.2))


def _inside(view: View, name: str) -> bool:
    """Whether a round wall is struck from inside."""
    story = view.motion.story
    centre = story.read_vector(story.walls[name].centre, "the centre")
    known = story.place(view.bodies[0].name, view.number)
    if known is None:
        return True
    inwards = centre - known[0]
    return bool(floats(inwards).dot(view.n) > 0)


def put_names(view: View, body: Body, drawing: Drawing) -> None:
    """The name of a sphere and its mass, within its circle if they are short."""
    written = name_of(body.name)
    left, _, right, _ = outline(written).box
    size = min(3.2, 1.15 * RADIUS / (right - left))
    if size < _LEAST:
        name = Label(written, body.centre, sides_towards(UP), RADIUS + 0.8, 3.0)
    else:
        name = Label(written, body.centre, ("centre",), 0.0, size, fixed=True)
    mass = _mass(view, body)
    if mass is not None:
        masses = [label for other in view.bodies if (label := _mass(view, other)) is not None]
        if not all(map(_fits, masses)):  # then none is within: outside it could be a speed
            words = lay.Phrase((lay.Words("mass"), mass.content))
            mass = Label(words, body.centre, sides_towards(-UP), RADIUS + 0.8, 2.6)
        elif name.fixed:
            name = replace(name, at=body.centre + UP * (0.5 + _height(name) / 2))
            mass = replace(mass, at=body.centre - UP * (0.5 + _height(mass) / 2))
        drawing.labels.append(mass)
    drawing.labels.append(name)


def _mass(view: View, body: Body) -> Label | None:
    """The mass of a sphere, if it is given, as large as it may be within its circle."""
    given = view.motion.model.story.spheres[body.name].mass
    if given is None:
        return None
    layout = lay.as_layout(given)
    left, bottom, right, top = outline(layout).box
    size = min(2.6, 1.2 * RADIUS / (right - left), _TALLEST / (top - bottom))
    return Label(layout, body.centre, ("centre",), 0.0, max(2.1, size), fixed=True)


def _height(label: Label) -> float:
    _, bottom, _, top = outline(label.content).box
    return (top - bottom) * label.size


def _fits(label: Label) -> bool:
    """Whether a label is small enough to stand in a circle, with another one above or below."""
    left, bottom, right, top = (label.size * x for x in outline(label.content).box)
    return right - left < 1.25 * RADIUS and top - bottom < _TALLEST + 1e-9
