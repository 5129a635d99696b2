"""What is said in one breath stands together: the components that an impact does not change."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from restitution.explaining.derivation import Derivation, Line

_LAWS = frozenset({"unchanged", "momentum", "restitution", "restitution-wall"})


def gathered(derivation: Derivation) -> Derivation:
    """The same working with the components that stay before the other laws of their impact.

    A line goes up only within its part and its case, and never above what it rests on.
    """
    parts = derivation.asked
    cases = {n: each.number for each in derivation.cases for n in each.lines}

    def place(line: Line) -> object:
        return parts.get(line.item or ""), cases.get(line.number), line.move.event

    order = list(derivation.lines)
    for line in derivation.lines:
        if line.move.id != "law" or line.move.record != "unchanged" or line.item not in parts:
            continue
        at = order.index(line)
        first = _first(order[:at], line, place(line), {e.number: place(e) for e in order[:at]})
        if first is not None:
            order.insert(first, order.pop(at))
    return _numbered(derivation, order)


def _first(
    above: list[Line], line: Line, place: object, places: Mapping[int, object]
) -> int | None:
    """Before which line above a component that stays is to be written; None where it stands."""
    for index, each in enumerate(above):
        law = each.move.id == "law" and each.move.record in _LAWS
        if not law or places[each.number] != place:
            continue
        if each.move.record == "unchanged":
            continue
        written = {own.number for own in above[:index]}
        if all(ref in written for ref in line.premises if isinstance(ref, int)):
            return index
        return None
    return None


def _numbered(derivation: Derivation, order: list[Line]) -> Derivation:
    numbers = {line.number: n for n, line in enumerate(order, 1)}

    def renumbered(line: Line) -> Line:
        premises = tuple(numbers[e] if isinstance(e, int) else e for e in line.premises)
        return replace(line, number=numbers[line.number], premises=premises)

    return replace(
        derivation,
        lines=tuple(map(renumbered, order)),
        items=tuple(replace(each, line=numbers[each.line]) for each in derivation.items),
        notes=tuple(each.renumbered(numbers) for each in derivation.notes),
        cases=tuple(
            replace(each, line=numbers[each.line], lines=tuple(numbers[n] for n in each.lines))
            for each in derivation.cases
        ),
    )
