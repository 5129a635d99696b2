"""Two walls that are neither parallel nor at right angles: between them is an acute angle."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Derivation
from restitution.expression.tree import Degrees, Expression, Name, Negate, Number, Polar
from restitution.workings.naming.measured import vector_worth


def are_slanting(derivation: Derivation, sides: Sequence[Expression]) -> bool:
    """Whether an angle lies between two walls along numbers, at no right angle to each other."""
    vectors = []
    for side in sides:
        fact = derivation.fact(f"wall {side.name}") if isinstance(side, Name) else None
        direction = None if fact is None else fact.relation.only[-1].right
        if isinstance(direction, Degrees | Negate):
            direction = Polar(Number(Fraction(1)), direction)
        along = None if direction is None else vector_worth(direction)
        if along is None:
            return False
        vectors.append(along)
    return len(vectors) == 2 and tidy(vectors[0].dot(vectors[1])).is_zero is False


__all__ = ["are_slanting"]
