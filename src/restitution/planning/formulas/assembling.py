"""A velocity as a vector, put together of its components along two directions."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Name, Quantity
from restitution.planning.formulas.definitions import Formula, itself
from restitution.planning.writing.desk import Source, together
from restitution.planning.writing.forms import product, total, tree_of, vector
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.unit_vectors import unit_tree
from restitution.vector import Vector


def put_together(body: str, stage: int, frame: Frame, components: tuple[Source, Source]) -> Formula:
    """A velocity of its components along the axis of a frame, and across it."""
    along, across = components
    value = frame.n * along.value + frame.t * across.value
    refs = together(along.refs, across.refs, frame.unit_free if stage else ())
    aligned = frame.across is not None or frame.n in (Vector(1, 0), Vector(0, 1))
    if aligned:
        right = vector(tree_of(value.x), tree_of(value.y))
    else:
        right = total(
            product(tree_of(own.value), unit_tree(direction))
            for own, direction in ((along, frame.n), (across, frame.t))
        )
    move = Move("define", "assemble", stage or None, (body,))
    quantity = Quantity("velocity", (Name(body),), stage)
    return Formula(move, itself, quantity, right, Vector(*map(tidy, value)), refs)


__all__ = ["put_together"]
