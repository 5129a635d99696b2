"""Spheres without radii that meet in one place: said where a line first rests on that."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Fact, Line, Link
from restitution.expression.tree import Quantity

_CONTACT = "contact "


def first_with_particles(derivation: Derivation) -> Line | None:
    """The first line for which spheres have no size, where two of them collide in one place.

    A line above it that rests on the place of another contact, as one with a wall, is one too.
    None where it is a distance since that impact, so that its title says so.
    """
    together = {fact.id for fact in derivation.facts if _is_of_one_place(fact)}
    lines = [line for line in derivation.lines if together.intersection(line.premises)]
    if not lines or _is_since_an_impact(lines[0]):
        return None
    contacts = {fact.id for fact in derivation.facts if fact.id.startswith(_CONTACT)}
    for line in derivation.lines[: derivation.lines.index(lines[0])]:
        if contacts.intersection(line.premises) and line.shown != "silent":
            return line
    return lines[0]


def _is_since_an_impact(line: Line) -> bool:
    """Whether a line says how far two bodies are apart that were together in an impact."""
    return line.move.record == "distance" and bool(line.move.event)


def _is_of_one_place(fact: Fact) -> bool:
    """Whether a contact says that two bodies are in one place, so that they have no size."""
    match fact.relation.options:
        case ((Link(Quantity("position", _, one), "=", Quantity("position", _, other)),),):
            return fact.id.startswith(_CONTACT) and one == other
    return False


__all__ = ["first_with_particles"]
