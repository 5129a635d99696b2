"""Times, places and distances as trees, and which expressions are about them."""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

from restitution.explaining.lines.derivation import Link
from restitution.expression.quantities import PLACED
from restitution.expression.tree import Binary, Expression, Name, Quantity, Unit, walk

Axis = Literal["i", "j"]
AXES: tuple[Axis, Axis] = ("i", "j")

# Such trees are kept, to be found by what they are and not by what is in them.


@lru_cache(maxsize=256)
def time_tree(number: int) -> Quantity:
    """The time of an event; of event 0, the start."""
    return Quantity("time", (), number)


@lru_cache(maxsize=256)
def duration_tree(late: int, early: int) -> Binary:
    """The time from one event to another."""
    return Binary("-", time_tree(late), time_tree(early))


@lru_cache(maxsize=256)
def place_tree(body: str, stage: int) -> Quantity:
    """Where a body is at an event."""
    return Quantity("position", (Name(body),), stage)


@lru_cache(maxsize=256)
def coordinate_tree(body: str, stage: int, axis: Axis) -> Quantity:
    """A coordinate of the place of a body at an event."""
    return Quantity("along", (place_tree(body, stage), Unit(axis)))


def serves(tree: Expression) -> bool:
    """Whether a quantity is a time, a place, a coordinate or a distance."""
    match tree:
        case Quantity("along" | "across", (Quantity("position"), _)):
            return True
        case Quantity(kind):
            return kind in PLACED
    return False


def is_duration(tree: Expression) -> bool:
    """Whether an expression is the time between two events."""
    match tree:
        case Binary("-", Quantity("time", (), int()), Quantity("time", (), int())):
            return True
    return False


def is_about_times(own: Link) -> bool:
    """Whether an equation is one between times, and perhaps letters."""
    nodes = [node for side in (own.left, own.right) for node in walk(side)]
    kinds = {node.kind for node in nodes if isinstance(node, Quantity)}
    return kinds == {"time"}
