"""What stands is not said again: a law, a given fact of a component, a coordinate."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.data.restated import axis_restated
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Relation,
    numbers_in,
)
from restitution.expression.tree import Expression, Letter


def with_facts_once(derivation: Derivation) -> Derivation:
    """The same working without ``w = 9`` on paper, where ``9 = 9√2u/16`` stands for a given speed.

    What a velocity is assembled of stays.
    """
    ends = {end.line for end in derivation.items}
    given = {fact.id for fact in derivation.facts if fact.kind == "given"}
    used = {ref for line in derivation.lines if line.move.id != "put" for ref in line.premises}
    lines = {line.number: line for line in derivation.lines}
    equations = [
        (own.left, own.right, line)
        for line in derivation.lines
        if line.move.record == "speed"
        and given & set(line.premises)
        and (own := _equation(line)) is not None
    ]
    kept: list[Line] = []
    for line in derivation.lines:
        own = _equation(line)
        if line.move.id == "put" and own is not None and isinstance(own.left, Letter):
            bases = [_equation(lines[ref]) for ref in line.premises if isinstance(ref, int)]
            formulas = [base.right for base in bases if base and base.left == own.left]
            if line.number not in ends | used and _stands(equations, line, own.right, formulas):
                line = replace(line, shown="silent")
        kept.append(line)
    return replace(derivation, lines=tuple(kept))


def with_laws_once(derivation: Derivation) -> Derivation:
    """The same working, in which a later part cites what a law says above, on the same premises.

    That may have had values put in at first, which nothing needed.
    """
    fixed = {end.line for end in derivation.items} | {n for e in derivation.cases for n in e.lines}
    first: dict[tuple[object, ...], int] = {}
    instead: dict[int, int] = {line.number: line.number for line in derivation.lines}
    for line in derivation.lines:
        if line.move.id == "law" and line.shown == "line":
            above = first.setdefault((line.move, line.relation, line.premises), line.number)
            instead[line.number] = line.number if line.number in fixed else above
    if all(number == above for number, above in instead.items()):
        return derivation
    return replace(
        derivation,
        lines=tuple(
            replace(line, premises=tuple(instead.get(e, e) for e in line.premises))  # type: ignore[arg-type]
            for line in derivation.lines
        ),
        notes=tuple(note.renumbered(instead) for note in derivation.notes),
    )


def with_distances_once(derivation: Derivation) -> Derivation:
    """The same working without distances that are coordinates of lines above.

    Where such a distance is only put into what is given, the coordinate stands there.
    """
    ends = {end.line for end in derivation.items}
    given = {fact.id for fact in derivation.facts if fact.kind == "given"}
    taken: dict[int, list[Line]] = {}
    for line in derivation.lines:
        for ref in numbers_in(line.premises):
            taken.setdefault(ref, []).append(line)
    hidden = {
        line.number
        for line in derivation.lines
        if line.number not in ends
        and axis_restated(derivation, line) is not None
        and all(e.move.id == "put" and given & {*e.premises} for e in taken.get(line.number, ()))
    }
    return replace(
        derivation,
        lines=tuple(
            replace(line, shown="silent") if line.number in hidden else line
            for line in derivation.lines
        ),
    )


def _stands(
    equations: list[tuple[Expression, Expression, Line]],
    line: Line,
    value: Expression,
    formulas: list[Expression],
) -> bool:
    """Whether a line above says that a value is what one of some formulas comes to."""
    return any(
        left == value and right in formulas and above.number < line.number
        for left, right, above in equations
    )


def _equation(line: Line) -> Link | None:
    """A line as one equation; None for a chain, for several, and for a `let`."""
    if not isinstance(line.relation, Relation) or len(line.relation.options) > 1:
        return None
    links = line.relation.only
    return links[0] if len(links) == 1 and links[0].sign == "=" else None


__all__ = ["with_distances_once", "with_facts_once", "with_laws_once"]
