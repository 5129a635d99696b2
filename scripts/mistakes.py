"""Makes docs/mistakes.md and its pictures from the table of mistakes.

    uv run python scripts/mistakes.py           # chooses the questions, in some minutes
    uv run python scripts/mistakes.py --kept    # keeps those that the page has

For each mistake it takes, among the examples of the package, the question in which an answer
changes most, and draws it as it is and as the mistake has it.
"""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import restitution
from restitution import examples
from restitution.drawing import scenes
from restitution.drawing.scene import Arc, Arrow, Label, Line, Polyline, Scene
from restitution.drawing.svg import abreast
from restitution.errors import RestitutionError
from restitution.explaining.mistakes.consequences import AlteredWorld, ChangedItem, altered_worlds
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS, SLIPS, Misconception
from restitution.export.units import Units
from restitution.problem import Given, Impact
from restitution.render.layout import Words
from restitution.shapes import Circle
from restitution.solving.equations.solution import ItemResult, Solution
from restitution.vector import Vector

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "mistakes.md"
PICTURES = ROOT / "docs" / "images" / "mistakes"
SECONDS = 1.0
ENOUGH = 0.8  # a difference that nobody overlooks; among such, the shortest question is taken
LONGEST = 340  # characters of a question

MADE = "<!-- what follows is made by scripts/mistakes.py -->\n\n"

AFTER = """## Slips

| slip | what happened |
|---|---|
"""


@dataclass(frozen=True)
class Best:
    """The question in which a mistake shows best, and how much the answer changes."""

    example: str
    solution: Solution
    world: AlteredWorld
    item: ChangedItem
    difference: float

    @property
    def rank(self) -> tuple[float, int, int]:
        """Smaller is better: enough of a difference, then a usual variant, then few words."""
        variant = int(self.world.id.partition("/")[2])
        return (-min(self.difference, ENOUGH), variant, len(examples.text(self.example)))


def main() -> None:
    """Writes the page and all pictures."""
    best = kept() if "--kept" in sys.argv else chosen()
    PICTURES.mkdir(parents=True, exist_ok=True)
    for old in PICTURES.glob("*.svg"):
        old.unlink()
    for name, each in best.items():
        (PICTURES / f"{name}.svg").write_text(picture(each), encoding="utf-8")
    PAGE.write_text(page(best), encoding="utf-8")


def kept() -> dict[str, Best]:
    """The questions and variants that stand on the page."""
    best: dict[str, Best] = {}
    for name, variant in re.findall(
        r'with_mistake\("([\w-]+)", "([\w/-]+)"\)', PAGE.read_text("utf-8")
    ):
        solution = restitution.solve(restitution.parse(examples.text(name)))
        (world,) = altered_worlds(solution, variant)
        sized = [(difference(each), each) for each in world.items]
        size, item = max(((a, b) for a, b in sized if a is not None), key=lambda each: each[0])
        best[variant.partition("/")[0]] = Best(name, solution, world, item, size)
    return best


# --- choosing -------------------------------------------------------------------------------------


def chosen() -> dict[str, Best]:
    """For each mistake with a world, the question in which it shows best."""
    best: dict[str, Best] = {}
    for name in examples.names():
        problem = restitution.parse(examples.text(name))
        walls = len({each.second for each in problem.events if isinstance(each, Impact)})
        two_walls = len(problem.events) == 2 and len(problem.walls) == walls == 2
        if len(statement(name)) > LONGEST or not (len(problem.events) == 1 or two_walls):
            continue
        backward = any(isinstance(step, Given) for _, step in problem.steps())
        if any(isinstance(wall.shape, Circle) for wall in problem.walls):
            continue
        solution = restitution.solve(problem, 10)
        if any(item.error for _, item in solution.items()):
            continue
        print(name, file=sys.stderr, flush=True)
        for mistake, row in MISCONCEPTIONS.items():
            if two_walls != (mistake == "second-wall-angle"):
                continue
            if backward != (mistake == "energy-ratio-as-speed"):
                continue
            for each in candidates(name, solution, row):
                if mistake not in best or each.rank < best[mistake].rank:
                    best[mistake] = each
    return {name: best[name] for name in MISCONCEPTIONS if name in best}


def candidates(example: str, solution: Solution, row: Misconception) -> Iterator[Best]:
    """What a mistake leads to in a question, with each item that it changes."""
    try:
        worlds = altered_worlds(solution, row.id, time_limit=SECONDS) if row.variants else ()
    except RestitutionError:
        return
    for world in worlds:
        if any(item.error for _, item in world.solution.items()):
            continue
        for item in world.items:
            size = difference(item)
            if size is not None:
                yield Best(example, solution, world, item, size)


def difference(item: ChangedItem) -> float | None:
    """By how much an answer changes, as a share of the larger one; None where letters are left."""
    true, other = (numbers(each) for each in (item.true, item.altered))
    if true is None or other is None or len(true) != len(other) or not comparable(item):
        return None
    sizes = math.hypot(*true), math.hypot(*other)
    return math.dist(true, other) / max(sizes) if min(sizes) > 0 else None


def comparable(item: ChangedItem) -> bool:
    """Whether letters are but a common factor of the two answers."""
    values = [each.distinct[0].value for each in (item.true, item.altered)]
    parts = [each for value in values for each in (value if isinstance(value, tuple) else (value,))]
    first = next((each for each in parts if each != 0), None)
    return first is not None and not any((each / first).simplify().free_symbols for each in parts)


def numbers(item: ItemResult) -> tuple[float, ...] | None:
    """The components of the only answer to an item; None where there are several, or letters."""
    if len(item.distinct) != 1 or item.kind not in ("value", "vector"):
        return None
    value = item.distinct[0].value
    parts = value if isinstance(value, tuple) else (value,)
    letters = sorted({s for part in parts for s in part.free_symbols}, key=str)
    ones = dict.fromkeys(letters, 1)
    try:
        return tuple(float(part.subs(ones)) for part in parts)
    except TypeError:
        return None


# --- pictures -------------------------------------------------------------------------------------


def picture(best: Best) -> str:
    """The true picture and that of the mistake, beside each other, as SVG."""
    title = f"With the mistake {best.world.id}"
    if best.world.alteration.laws:
        pair = [scenes(each)[0] for each in (best.solution, best.world.solution)]
    else:
        make = fan if best.item.true.distinct[0].angle else bar
        pair = [make(best, each) for each in (best.item.true, best.item.altered)]
    return abreast(pair, ["True", title])


def shown(best: Best, item: ItemResult) -> str:
    """A value with its unit."""
    unit = Units(best.solution).of(best.item.true).replace("\u00a0", " ").strip()
    return f"{item.distinct[0].display} {unit}".strip()


def fan(best: Best, item: ItemResult) -> Scene:
    """An angle of deflection: the way before, continued, and the way after."""
    (turned,) = numbers(item) or (0.0,)
    at, size, radius = Vector(20.0, 16.0), 15.0, 8.0
    start = math.radians(-40)
    onward, after = (Vector(math.cos(a), math.sin(a)) for a in (start, start + turned))
    middle = start + turned / 2
    beside = at + Vector(math.cos(middle), math.sin(middle)) * radius
    return Scene(
        f"{best.item.text} = {item.distinct[0].display}",
        f"The direction of motion is turned by {item.distinct[0].display}.",
        (0.0, 0.0, 70.0, 33.0),
        (
            Arrow("velocity", at - onward * size, at),
            Line("onward", at, at + onward * size),
            Arrow("velocity", at, at + after * size),
            Arc("angle", at, radius, start, start + turned),
        ),
        (Label(Words(shown(best, item)), beside, ("e", "ne", "n", "se", "s"), 1.5),),
    )


def bar(best: Best, item: ItemResult) -> Scene:
    """A value as a bar, to the scale of the larger of the two."""
    sizes = [math.hypot(*(numbers(each) or (0.0,))) for each in (best.item.true, best.item.altered)]
    (own,) = (math.hypot(*(numbers(item) or (0.0,))),)
    length = max(44.0 * own / max(sizes), 0.3)
    low, high, left = 2.0, 8.0, 1.0
    corners = [(left, low), (left + length, low), (left + length, high), (left, high), (left, low)]
    outline = tuple(Vector(*each) for each in corners)
    return Scene(
        f"{best.item.text} = {item.distinct[0].display}",
        f"{best.item.text} is {item.distinct[0].display}, as a bar.",
        (0.0, 0.0, 84.0, 10.0),
        (Polyline("velocity", outline),),
        (Label(Words(shown(best, item)), Vector(left + length, 5.0), ("e",), 2.0),),
    )


# --- the page -------------------------------------------------------------------------------------


def page(best: dict[str, Best]) -> str:
    """The text of docs/mistakes.md."""
    table = ["| mistake | what happens | usual line | marks |", "|---|---|---|---|"]
    for row in MISCONCEPTIONS.values():
        marks = "; ".join(f"{mark} ({principle})" for principle, mark in row.marks)
        link = f"[`{row.id}`](#{anchor(row.title)})"
        table.append(
            f"| {link} | {row.sentence} | {row.line.replace('|', chr(92) + '|')} | {marks} |"
        )
    slips = [f"| `{each.id}` | {each.sentence} |" for each in SLIPS.values()]
    sections = [section(row, best.get(row.id)) for row in MISCONCEPTIONS.values()]
    return (
        PAGE.read_text(encoding="utf-8").partition(MADE)[0]
        + MADE
        + "\n".join(table)
        + "\n\n"
        + "\n".join(sections)
        + "\n"
        + AFTER
        + "\n".join(slips)
        + "\n"
    )


def anchor(title: str) -> str:
    """The anchor of a heading."""
    kept = "".join(each for each in title.lower() if each.isalnum() or each in " -_")
    return kept.replace(" ", "-")


def section(row: Misconception, best: Best | None) -> str:
    """What is told of one mistake."""
    lines = [f"## {row.title}", "", f"`{row.id}`: {row.sentence} {row.consequence}", ""]
    lines += [f"A usual line: {row.line}."] + ([f"{row.rule}"] if row.rule else []) + [""]
    if best is None:
        return "\n".join(lines)
    words = f"({best.world.words}): {best.item.text} ="
    item, true, other = best.item, best.item.true, best.item.altered
    lines += [
        f"![{item.text} as it is, and with the mistake](images/mistakes/{row.id}.svg)",
        "",
        f"It shows best in the example `{best.example}`:",
        "",
        "```impact",
        statement(best.example),
        "```",
        "",
        f"`{best.world.id}` {words} {shown(best, other)}, not {shown(best, true)}.",
        "",
        "```python",
        f'>>> with_mistake("{best.example}", "{best.world.id}")',
        str(best.world.solution),
        "",
        "```",
        "",
    ]
    return "\n".join(lines)


def statement(name: str) -> str:
    """The text of an example without its remarks."""
    lines = examples.text(name).splitlines()
    return "\n".join(each for each in lines if each.strip() and not each.startswith("#"))


if __name__ == "__main__":
    main()
