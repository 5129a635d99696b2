"""A break shot: where the cue ball goes after n impacts with other balls, against its aim.

    uv run python docs/examples/break_shot.py

prints by how much each impact multiplies a small change of the aim, and draws it in
docs/images/break-shot.svg. An ensemble of some hundred shots runs on all processors.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median, quantiles

from restitution import Sphere, Table, ensemble, simulate
from restitution.drawing.scene import Dot, Label, Line, Panel, Polyline, Scene, Shape, Side
from restitution.drawing.svg import stacked
from restitution.render import layout as lay
from restitution.vector import Vector

LENGTH, WIDTH = 2.54, 1.27  # of the table, in m
RADIUS, MASS = 0.0286, 0.17  # m, kg
SPEED = 8.0  # of the break, in m/s
GAP = 0.001  # between balls of the rack, in m
E = 0.95

AIMS = 601
WIDEST = math.radians(2)  # to either side of the foremost ball
NEARBY = 1e-12  # rad, between two shots that are compared
HITS = 5  # of the cue ball with other balls
IMPACTS = 200  # of all balls, with walls too

IMAGE = Path(__file__).resolve().parent.parent / "images" / "break-shot.svg"


# --- one shot ----------------------------------------------------------------------------------


def rack(aim: float) -> Table:
    """Fifteen balls in a triangle, and the cue ball on its way at an angle (rad) to the length."""
    apart = 2 * RADIUS + GAP
    foremost = Vector(3 * LENGTH / 4, WIDTH / 2)
    cue = Sphere(
        "cue",
        mass=MASS,
        radius=RADIUS,
        position=(LENGTH / 4, WIDTH / 2),
        velocity=(SPEED * math.cos(aim), SPEED * math.sin(aim)),
    )
    others = [
        Sphere(
            f"ball {row * (row + 1) // 2 + place + 1}",
            mass=MASS,
            radius=RADIUS,
            position=foremost + Vector(row * math.sqrt(0.75), place - row / 2) * apart,
            velocity=(0, 0),
        )
        for row in range(5)
        for place in range(row + 1)
    ]
    return Table.box(LENGTH, WIDTH, [cue, *others], e=E)


def hits(aim: float) -> list[tuple[str, int, float]]:
    """What the cue ball hits: which ball, the number of the impact, its direction (rad) after."""
    found = []
    for number, each in enumerate(simulate(rack(aim), impacts=IMPACTS).impacts, start=1):
        bodies = each.first, each.second
        if "cue" in bodies and any(name.startswith("ball") for name in bodies):
            velocity = each.after[bodies.index("cue")]
            other = bodies[1 - bodies.index("cue")]
            found.append((other, number, math.atan2(velocity.y, velocity.x)))
    return found[:HITS]


@dataclass(frozen=True)
class Hit:
    """The direction of the cue ball after a hit (rad), and how fast it turns as the aim does.

    ``number`` counts the impacts of all balls so far.
    """

    angle: float
    slope: float
    number: int


def shot(aim: float) -> list[Hit]:
    """The hits of a shot, as long as the shot beside it hits the same balls."""
    results = []
    for (ball, number, angle), (other, _, beside) in zip(hits(aim), hits(aim + NEARBY)):
        if ball != other:
            break
        slope = abs(math.remainder(beside - angle, math.tau)) / NEARBY
        results.append(Hit(angle, slope, number))
    return results


# --- many shots --------------------------------------------------------------------------------


def main() -> None:
    aims = [WIDEST * (2 * k / (AIMS - 1) - 1) for k in range(AIMS)]
    shots = ensemble(shot, aims).all_values()
    columns = [[each[n] for each in shots if len(each) > n] for n in range(HITS)]
    slopes = [quantiles(hit.slope for hit in column) for column in columns]
    numbers = [median(hit.number for hit in column) for column in columns]
    print("hits   impacts of all balls   a small change of the aim, multiplied by")
    for n, (number, (_, middle, _)) in enumerate(zip(numbers, slopes), start=1):
        print(f"{n:4}   {number:20.0f}   {middle:.2g}")
    doublings = math.log2(slopes[-1][1] / slopes[0][1])
    print(f"Each hit multiplies it by {2 ** (doublings / (HITS - 1)):.0f};", end=" ")
    print(f"it doubles with every {(numbers[-1] - numbers[0]) / doublings:.1f} impacts.")
    IMAGE.write_text(stacked([*directions(aims, shots), growth(slopes)]), encoding="utf-8")


# --- the picture -------------------------------------------------------------------------------

LEFT, RIGHT, HEIGHT = 10.0, 80.0, 24.0  # of a diagram, in mm
TICK = 1.2
JUMP = math.radians(20)  # between neighbours; a line is broken there


@dataclass(frozen=True)
class Diagram:
    """A frame, and the values at its sides: left, bottom, right, top."""

    sides: tuple[float, float, float, float]

    def at(self, x: float, y: float) -> Vector:
        left, bottom, right, top = self.sides
        across = LEFT + (x - left) / (right - left) * (RIGHT - LEFT)
        return Vector(across, (y - bottom) / (top - bottom) * HEIGHT)

    def scene(
        self,
        title: str,
        description: str,
        curves: Sequence[Shape],
        across: dict[float, lay.Layout],
        up: dict[float, lay.Layout],
    ) -> Scene:
        """The picture, with what is said at places along the bottom and up the left side."""
        left, bottom, _, _ = self.sides
        marks: list[tuple[Vector, Vector, lay.Layout, Side]] = []
        marks += [(self.at(x, bottom), Vector(0, -TICK), said, "s") for x, said in across.items()]
        marks += [(self.at(left, y), Vector(-TICK, 0), said, "w") for y, said in up.items()]
        return Scene(
            title,
            description,
            box=(0, -4.5, RIGHT + 4, HEIGHT + 1),
            shapes=(*curves, *(Line("measure", at, at + way) for at, way, _, _ in marks)),
            labels=tuple(
                Label(said, at + way, (side,), 0.6, 2.5, fixed=True)
                for at, way, said, side in marks
            ),
            panels=(Panel("", (LEFT, 0, RIGHT, HEIGHT)),),
        )


def directions(aims: Sequence[float], shots: Sequence[Sequence[Hit]]) -> Iterator[Scene]:
    """The direction of the cue ball after its first hits, against its aim."""
    diagram = Diagram((-WIDEST, -math.pi, WIDEST, math.pi))
    across = {math.radians(x): degrees(x) for x in (-2, -1, 0, 1, 2)}
    up = {math.radians(y): degrees(y) for y in (-180, -90, 0, 90, 180)}
    for n, (title, description) in enumerate(
        (
            (
                "Direction of the cue ball after its first hit, against its aim",
                "One smooth curve, steep in the middle.",
            ),
            ("After its second hit", "Pieces of curves, in some ranges scattered points."),
            ("After its third hit", "Scattered points almost everywhere."),
        )
    ):
        found = [(aim, hits[n].angle) for aim, hits in zip(aims, shots) if len(hits) > n]
        yield diagram.scene(title, description, curves(found, diagram), across, up)


def growth(slopes: Sequence[Sequence[float]]) -> Scene:
    """What a small change of the aim is multiplied by: medians and quartiles."""
    decades = math.ceil(math.log10(max(high for _, _, high in slopes)))
    diagram = Diagram((0.5, 0, HITS + 0.5, decades))
    bars: list[Shape] = []
    for n, quarters in enumerate(slopes, start=1):
        low, middle, high = (diagram.at(n, math.log10(each)) for each in quarters)
        bars += [Line("velocity", low, high), Dot("median", middle)]
    return diagram.scene(
        "What a small change of the aim is multiplied by, after 1 to 5 hits",
        "Medians and quartiles: on a scale of powers of ten they rise along a straight line.",
        bars,
        {n: lay.Number(str(n)) for n in range(1, HITS + 1)},
        {d: lay.power(lay.Number("10"), lay.Number(str(d))) for d in range(0, decades + 1, 3)},
    )


def degrees(number: float) -> lay.Layout:
    size = lay.Degrees(lay.Number(f"{abs(number):g}"))
    return lay.negative(size) if number < 0 else size


def curves(points: Sequence[tuple[float, float]], diagram: Diagram) -> list[Shape]:
    """Neighbours joined by lines, where they are near each other; others as dots."""
    parts: list[list[Vector]] = []
    before = -math.inf
    for aim, angle in points:
        if abs(angle - before) > JUMP:
            parts.append([])
        parts[-1].append(diagram.at(aim, angle))
        before = angle
    return [
        Polyline("path", tuple(part)) if len(part) > 1 else Dot("shot", part[0], 0.22)
        for part in parts
    ]


if __name__ == "__main__":
    main()
