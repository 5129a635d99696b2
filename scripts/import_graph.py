"""Draws which package imports which: ``uv run python scripts/import_graph.py``.

Packages stand in the layers of ``pyproject.toml``, from top to bottom, each with its lines of
code. An arrow says that one imports the other; it is left out where a chain of arrows says so, and
to the lowest rows, which anyone may import.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

import grimp

ROOT = Path(__file__).parent.parent
PACKAGE = "restitution"
PICTURE = ROOT / "docs/images/layers.svg"
WIDTH, ROW, BOX, GAP = 820, 52, (112, 34), 14
FOR_ALL = 3  # so many of the lowest layers get no arrows
STYLE = """<style>
rect { fill: #f4f6fa; stroke: #3b4a6b }
text { font: 13px sans-serif; fill: #1c2333; text-anchor: middle }
.lines { font-size: 10px; fill: #5a6580 }
path { fill: none; stroke: #8a94ad; stroke-width: 1 }
</style>"""

Place = tuple[float, float]


def layers() -> list[list[str]]:
    """The packages of each layer, as the contract has them, without those that are not there."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contract = settings["tool"]["importlinter"]["contracts"][0]
    rows = ([name.strip(" ()") for name in row.split("|")] for row in contract["layers"])
    separated = ([name for part in row for name in part.split(":")] for row in rows)
    return [[name.strip() for name in row if _source(name.strip()).exists()] for row in separated]


def _source(name: str) -> Path:
    package = ROOT / "src" / PACKAGE / name
    return package if package.is_dir() else package.with_suffix(".py")


def lines_of(name: str) -> int:
    """The lines of Python of a package, or of a module."""
    source = _source(name)
    files = source.rglob("*.py") if source.is_dir() else [source]
    return sum(len(file.read_text(encoding="utf-8").splitlines()) for file in files)


def imports() -> dict[str, set[str]]:
    """For each package those that it imports, in any of its modules."""
    graph = grimp.build_graph(PACKAGE)
    names = {name for row in layers() for name in row}
    targets_of: dict[str, set[str]] = {name: set() for name in names}
    for module in graph.modules:
        importer = module.removeprefix(f"{PACKAGE}.").split(".")[0]
        for target in graph.find_modules_directly_imported_by(module):
            imported = target.removeprefix(f"{PACKAGE}.").split(".")[0]
            if importer in names and imported in names and importer != imported:
                targets_of[importer].add(imported)
    return targets_of


def reduced(edges: dict[str, set[str]]) -> dict[str, set[str]]:
    """The arrows that no chain of others replaces."""

    def reach(name: str) -> set[str]:
        below = set(edges[name])
        return below.union(*(reach(target) for target in below)) if below else below

    return {
        name: {one for one in targets if not any(one in reach(other) for other in targets - {one})}
        for name, targets in edges.items()
    }


def drawn() -> str:
    """The picture, as SVG."""
    rows = layers()
    places: dict[str, Place] = {}
    for number, row in enumerate(rows):
        wide = len(row) * BOX[0] + (len(row) - 1) * GAP
        # Rows step to either side, so that arrows between distant rows pass beside the boxes.
        middle = WIDTH / 2 + (number % 3 - 1) * 200 * (len(row) < 4)
        for index, name in enumerate(row):
            places[name] = (
                middle - wide / 2 + index * (BOX[0] + GAP) + BOX[0] / 2,
                24 + number * ROW,
            )
    for_all = {name for row in rows[-FOR_ALL:] for name in row}
    arrows = [
        _arrow(places[name], places[target])
        for name, targets in sorted(reduced(imports()).items())
        for target in sorted(targets - for_all)
        if name not in for_all
    ]
    boxes = [_box(name, place) for name, place in places.items()]
    height = len(rows) * ROW
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" role="img" '
        f'aria-label="Packages in layers, with arrows to what each imports">'
    )
    tip = (
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" '
        'markerHeight="7" orient="auto"><path d="M0 0L8 4L0 8z" style="fill:#8a94ad"/>'
        "</marker></defs>"
    )
    return "\n".join([head, STYLE, tip, *arrows, *boxes, "</svg>", ""])


def _arrow(start: Place, end: Place) -> str:
    (x, y), (u, v) = start, end
    top, bottom = y + BOX[1] / 2, v - BOX[1] / 2
    bend = max(14.0, (bottom - top) * 0.45)
    return (
        f'<path marker-end="url(#tip)" d="M{x:.0f} {top:.0f}'
        f'C{x:.0f} {top + bend:.0f} {u:.0f} {bottom - bend:.0f} {u:.0f} {bottom:.0f}"/>'
    )


def _box(name: str, place: Place) -> str:
    x, y = place
    return (
        f'<rect x="{x - BOX[0] / 2:.0f}" y="{y - BOX[1] / 2:.0f}" width="{BOX[0]}" '
        f'height="{BOX[1]}" rx="5"/><text x="{x:.0f}" y="{y:.0f}">{name}</text>'
        f'<text class="lines" x="{x:.0f}" y="{y + 13:.0f}">{lines_of(name):,} lines</text>'
    )


if __name__ == "__main__":
    PICTURE.write_text(drawn(), encoding="utf-8")
    print(f"{PICTURE.relative_to(ROOT)}: {len(reduced(imports()))} packages")
