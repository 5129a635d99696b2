"""A question in the world of a mistake, written down: its answers there, beside the true ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from textwrap import wrap
from typing import TYPE_CHECKING

from restitution.explaining.mistakes.consequences import AlteredWorld, ChangedItem, altered_worlds
from restitution.explaining.mistakes.misconceptions import Misconception, misconception
from restitution.export import contract
from restitution.export.units import Units
from restitution.render.text import NO_BREAK, width
from restitution.solving.equations.solution import ItemResult, Solution

if TYPE_CHECKING:
    from restitution.export.objects import AlteredObject, MistakeObject, SolvedObject

_SHARE = 0.5
_LABEL = "These are answers in an altered world, and not of the question."


def written(
    reply: SolvedObject,
    solution: Solution,
    mistake: str,
    limit: float | None,
    *,
    part: str | None,
    columns: int | None,
) -> str:
    """The answers that a mistake, or one variant, changes: as JSON, or as text with ``columns``.

    Raises what `altered_worlds` raises.
    """
    seconds = None if limit is None else limit * _SHARE
    worlds = altered_worlds(solution, mistake, time_limit=seconds, part=part)
    about = misconception(mistake)
    if columns is None:
        content: AlteredObject = {**reply, "as": _object(mistake, about, solution, worlds)}
        return contract.to_json(content) + "\n"
    return "\n".join(_lines(about, solution, worlds, columns)) + "\n"


def _object(
    mistake: str, about: Misconception, solution: Solution, worlds: Iterable[AlteredWorld]
) -> MistakeObject:
    units = Units(solution)
    return {
        "id": mistake,
        "title": about.title,
        "sentence": about.sentence,
        "consequence": about.consequence,
        "worlds": [
            {
                "id": world.id,
                "words": world.words,
                "events": list(world.events),
                "items": [
                    {"part": item.part, **contract.item(item.altered, units.of(item.true))}
                    for item in world.items
                ],
            }
            for world in worlds
        ],
    }


# --- text -----------------------------------------------------------------------------------------


def _lines(
    about: Misconception, solution: Solution, worlds: tuple[AlteredWorld, ...], columns: int
) -> Iterator[str]:
    if solution.problem.title:
        yield from (solution.problem.title, "")
    yield from wrap(f"{about.title} ({about.id}). {about.sentence}", columns)
    yield _LABEL
    units = Units(solution)
    for world, *others in _alike(worlds):
        yield ""
        ids = ", ".join([world.id, *(f"/{twin.id.partition('/')[2]}" for twin in others)])
        yield from wrap(f"{ids}: {world.words}", columns, subsequent_indent="  ")
        yield from _table(world.items, units, columns)


def _alike(worlds: Iterable[AlteredWorld]) -> list[list[AlteredWorld]]:
    """Worlds with the same answers together."""
    groups: dict[tuple[tuple[str, str], ...], list[AlteredWorld]] = {}
    for world in worlds:
        key = tuple((item.text, _value(item.altered)) for item in world.items)
        groups.setdefault(key, []).append(world)
    return list(groups.values())


def _table(items: Iterable[ChangedItem], units: Units, columns: int) -> Iterator[str]:
    """A line for each item: what was asked, its value in the altered world, the true value."""
    rows = []
    for item in items:
        label = f"({item.part}) " if item.part else ""
        if item.true.kind == "show":
            yield f"  {label}{item.text}: {_value(item.altered)}"
            continue
        unit = units.of(item.true)
        altered_, true = (_with_unit(result, unit) for result in (item.altered, item.true))
        rows.append((f"{label}{item.text}", altered_, true))
    first = max((width(row[0]) for row in rows), default=0)
    second = max((width(row[1]) for row in rows), default=0)
    for asked, value, true in rows:
        line = f"  {_padded(asked, first)} = {_padded(value, second)}  not {true}"
        if width(line) <= columns:
            yield line
        else:
            yield f"  {asked} = {value}"
            yield f"      not {true}"


def _padded(text: str, columns: int) -> str:
    return text + " " * max(0, columns - width(text))


def _with_unit(item: ItemResult, unit: str) -> str:
    value = _value(item)
    text = f"{value} {unit.strip()}" if unit and item.error is None else value
    return text.replace(NO_BREAK, " ")


def _value(item: ItemResult) -> str:
    """An item's answers as people see them; what was rejected where there are none."""
    if item.error is not None:
        first = item.rejected[0]
        return f"{first.display} (impossible)"
    if item.holds is not None:
        return "true" if item.holds else "not true"
    return " or ".join(answer.display for answer in item.distinct) or "no answer"
