"""Of the forms of an equation that stand, a later line starts from the last one that tells it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from restitution.explaining.derivation import Derivation, Line, Relation
from restitution.explaining.follower import reader_of
from restitution.oracle import Oracle

_FORMS = frozenset({"rearrange", "cancel", "identity"})
_STARTING = frozenset({"rearrange", "put"})


def with_latest_forms(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which no line goes back behind a form of its equation for that form."""
    if derivation.cases:
        return derivation
    for line in derivation.lines:
        first = line.premises[0] if line.premises else None
        if line.move.id in _STARTING and isinstance(first, int) and first < line.number - 1:
            derivation = _from_a_form(derivation, line, first, oracle)
    return derivation


def _from_a_form(derivation: Derivation, line: Line, first: int, oracle: Oracle) -> Derivation:
    """The working in which a line starts from the last form of its equation, if it follows."""
    for form in reversed(list(_forms(derivation, first, line.number))):
        if form in line.premises:
            return derivation
        direct = replace(line, premises=(form, *line.premises[1:]))
        lines = tuple(direct if each == line else each for each in derivation.lines)
        whole = replace(derivation, lines=lines)
        read = reader_of(whole, oracle)
        if read.accepts(read.lines[line.number]):
            return whole
    return derivation


def _forms(derivation: Derivation, first: int, end: int) -> Iterator[int]:
    """The lines between two that say what the first one says, each made of one before it."""
    own = {first}
    for line in derivation.lines:
        if not first < line.number < end or line.move.id not in _FORMS:
            continue
        above = [ref for ref in line.premises if isinstance(ref, int)]
        if len(above) == 1 and above[0] in own and _is_equation(line):
            own.add(line.number)
            yield line.number


def _is_equation(line: Line) -> bool:
    """Whether a line is one equation, in one solution."""
    match line.relation:
        case Relation((links,)):
            return all(link.sign == "=" for link in links)
    return False


__all__ = ["with_latest_forms"]
