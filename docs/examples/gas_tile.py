"""A tile of the fast engine with its halo, and both through a window of time.

    uv run python docs/examples/gas_tile.py

draws docs/images/gas-tile.svg, which docs/gas.md explains.
"""

from __future__ import annotations

import random
from pathlib import Path

from restitution.drawing.scene import Arrow, Disc, Label, Line, Panel, Polyline, Scene, Shape
from restitution.drawing.svg import stacked
from restitution.render import layout as lay
from restitution.vector import Vector

CELL = 3.4  # mm
OWN, NEAR, MARGIN = 8, 4, 4  # cells
SIDE = OWN + 2 * (NEAR + MARGIN)
HEIGHT = 34.0  # of the window of time, in mm

IMAGE = Path(__file__).resolve().parent.parent / "images" / "gas-tile.svg"


def square(role: str, inset: float) -> Polyline:
    low, high = inset * CELL, (SIDE - inset) * CELL
    corners = ((low, low), (high, low), (high, high), (low, high), (low, low))
    return Polyline(role, tuple(Vector(x, y) for x, y in corners))


def words(text: str, x: float, y: float) -> Label:
    return Label(lay.Words(text), Vector(x, y), ("centre",), 0, 2.6, fixed=True)


def in_space() -> Scene:
    """The tile from above."""
    end = SIDE * CELL
    shapes: list[Shape] = [square("velocity", NEAR + MARGIN), square("across", MARGIN)]
    for n in range(1, SIDE):
        at = n * CELL
        shapes += [
            Line("leader", Vector(at, 0), Vector(at, end)),
            Line("leader", Vector(0, at), Vector(end, at)),
        ]
    chance = random.Random(2)
    for column in range(0, SIDE, 2):
        for line in range(0, SIDE, 2):
            x, y = ((each + 1 + chance.uniform(-0.45, 0.45)) * CELL for each in (column, line))
            off = max(abs(x - end / 2), abs(y - end / 2)) / CELL - OWN / 2
            shapes.append(Disc("disc", Vector(x, y), 0.4 * CELL, ghost=off > NEAR))
    middle = end / 2
    halo = (NEAR + MARGIN) * CELL
    return Scene(
        "A tile and its halo",
        "A square of cells, the tile; around it those near, whose discs are compared with their "
        "owners', and a margin around these.",
        box=(-1, -4.5, end + 1, end + 1),
        shapes=tuple(shapes),
        labels=(
            words("the tile's own", middle, -2.5),
            words("near", MARGIN * CELL + NEAR * CELL / 2, -2.5),
            words("margin", MARGIN * CELL / 2, -2.5),
            words("near", end - halo + NEAR * CELL / 2, -2.5),
            words("margin", end - MARGIN * CELL / 2, -2.5),
        ),
        panels=(Panel("", (0, 0, end, end)),),
    )


def in_time() -> Scene:
    """One side of it through the window."""
    own, near, edge = 18.0, 52.0, 77.0
    gone, block = 10.0, 14.0
    tooth = ((edge, 0), (73, 6), (74, 9), (66, 16), (67, 20), (63, 26), (64, 30), (62, HEIGHT))
    shapes: tuple[Shape, ...] = (
        Line("velocity", Vector(own, 0), Vector(own, HEIGHT)),
        Arrow("path", Vector(own, 0), Vector(own + gone, HEIGHT)),
        Line("component", Vector(own + block, 0), Vector(own + gone + block, HEIGHT)),
        Arrow("path", Vector(near, 0), Vector(near - gone, HEIGHT)),
        Line("across", Vector(near, 0), Vector(near, HEIGHT)),
        Polyline("onward", tuple(Vector(x, y) for x, y in tooth)),
        Arrow("measure", Vector(own + gone, HEIGHT + 2.5), Vector(near - gone, HEIGHT + 2.5), True),
        Arrow("measure", Vector(own, -2.5), Vector(near, -2.5), True),
        Arrow("measure", Vector(near, -2.5), Vector(edge, -2.5), True),
    )
    return Scene(
        "The halo through a window of time",
        "Time upwards. A disc of the tile goes out by v Δt at most, and looks two cells on; what "
        "it finds there has come from v Δt farther. What goes wrong at the outer edge comes in, "
        "and must not reach the discs near.",
        box=(-4, -8, edge + 5, HEIGHT + 8),
        shapes=shapes,
        labels=(
            words("own", own / 2, HEIGHT / 2),
            words("near", 41, HEIGHT / 3),
            words("2 cells", (own + near) / 2, HEIGHT + 5),
            words("2 v Δt + 2 cells", (own + near) / 2, -5.5),
            words("margin", (near + edge) / 2, -5.5),
            words("wrong", 71.5, HEIGHT - 8),
        ),
        panels=(Panel("", (0, 0, edge, HEIGHT)),),
    )


if __name__ == "__main__":
    IMAGE.write_text(stacked((in_space(), in_time())), encoding="utf-8")
