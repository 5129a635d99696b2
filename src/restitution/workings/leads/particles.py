"""Spheres without radii that meet in one place: said where a line first rests on that."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Fact, Line, Link
from restitution.expression.tree import Quantity


def first_with_particles(derivation: Derivation) -> Line | None:
    """The first line for which two spheres that collide have no size.

    None where it is a distance since that impact, so that its title says so.
    """
    together = {fact.id for fact in derivation.facts if _is_of_one_place(fact)}
    lines = [line for line in derivation.lines if together.intersection(line.premises)]
    return None if not lines or _is_since_an_impact(lines[0]) else lines[0]


def _is_since_an_impact(line: Line) -> bool:
    """Whether a line says how far two bodies are apart that were together in an impact."""
    return line.move.record == "distance" and bool(line.move.event)


def _is_of_one_place(fact: Fact) -> bool:
    """Whether a contact says that two bodies are in one place, so that they have no size."""
    match fact.relation.options:
        case ((Link(Quantity("position", _, one), "=", Quantity("position", _, other)),),):
            return fact.id.startswith("contact ") and one == other
    return False


__all__ = ["first_with_particles"]
