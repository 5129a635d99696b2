"""Components by scalar products with a vector along the line of centres that is no unit vector."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    is_quantity,
    unsigned,
    walk,
)
from restitution.practice.judging.entries import is_numeric
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.script import Claim
from restitution.practice.worlds.world import World
from restitution.vector import Vector

# The greatest number in a vector along a line: 5i - 12j.
_MOST = 13
_TINY = 1e-9


def by_vectors(claim: Claim, meant: Expression | None, world: World) -> Iterator[Claim]:
    """A claim about a component in words, its number divided by the size of such a vector.

    Along i - 2j the speed of approach of 8i and -2i is 10, which is √5 times what it is.
    """
    match claim:
        case Claim(Letter(name), "=", right, ()) if is_phrase(name) and is_numeric(right):
            pass
        case _:
            return
    inside = None if meant is None else unsigned(meant)
    if not is_quantity(inside, "along"):
        return
    lines = {node.stage for node in walk(inside) if is_quantity(node, "line_of_centres")}
    for number in lines:
        square = _square_of_a_vector(number, world) if isinstance(number, int) else None
        if square is not None:
            size = Apply("sqrt", Number(Fraction(square)))
            yield replace(claim, right=Binary("/", right, size))


def _square_of_a_vector(number: int, world: World) -> int | None:
    """The square of the size of the shortest vector of whole numbers along a line of centres."""
    if number not in world.lines:
        return None
    line = Quantity("line_of_centres", (), number)
    try:
        direction = world.value(line)
    except RestitutionError:
        return None
    if not isinstance(direction, Vector):
        return None
    x, y = (np.ravel(world.spread(part)) for part in (direction.x, direction.y))
    if np.ptp(x) > _TINY or np.ptp(y) > _TINY or min(abs(x[0]), abs(y[0])) < _TINY:
        return None
    ratio = Fraction(float(x[0] / y[0])).limit_denominator(_MOST)
    near = abs(float(ratio) - x[0] / y[0]) < _TINY
    return ratio.numerator**2 + ratio.denominator**2 if near else None
