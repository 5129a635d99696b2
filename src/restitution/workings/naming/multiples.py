"""Letters for numbers of which a velocity is a multiple: k in **v** = k(3**i** + 2**j**).

They are introduced by that line, and have no unit.
"""

from __future__ import annotations

from collections.abc import Mapping

from restitution.explaining.lines.derivation import Derivation, Line, Link, Meaning, Relation
from restitution.expression.tree import Binary, Letter, Quantity, Unit, is_binary, walk


def multiple_of(line: Line) -> str | None:
    """The letter by which a line makes a velocity of a vector with both components; None of others.

    Along a unit vector, as of a vector over its length, it is a component.
    """
    match line.relation:
        case Relation(((Link(Quantity("velocity"), "=", Binary("*", letter, along)),),)):
            pass
        case _:
            return None
    if line.move.record != "assemble" or not isinstance(letter, Letter):
        return None
    units = {node.axis for node in walk(along) if isinstance(node, Unit)}
    return letter.name if len(units) == 2 and is_binary(along, "+", "-") else None


def multiples(derivation: Derivation) -> frozenset[str]:
    """The letters of a working by which velocities are multiples of vectors."""
    own = filter(None, map(multiple_of, derivation.lines))
    return frozenset(name for name in own if name in derivation.meanings)


def measured_meanings(derivation: Derivation) -> Mapping[str, Meaning]:
    """What the letters stand for that have units: a number before a vector has none."""
    numbers = multiples(derivation)
    return {name: own for name, own in derivation.meanings.items() if name not in numbers}


__all__ = ["measured_meanings", "multiple_of", "multiples"]
