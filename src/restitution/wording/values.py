"""Values in words: numbers with their units, vectors, points and directions."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
)
from restitution.render import layout as lay
from restitution.wording.question import Named, Words
from restitution.wording.units import LENGTH, Dimension, Scale
from restitution.wording.words import words

_VECTORS = frozenset(("velocity", "momentum", "position", "line_of_centres"))
I = lay.Bold("i")


def laid(tree: Expression) -> lay.Layout:
    """The mathematics of an expression; a pair in round brackets is a vector in **i** and **j**."""
    if isinstance(tree, Pair):
        return lay.vector(lay.from_tree(tree.x), lay.from_tree(tree.y))
    return lay.from_tree(tree)


def value(scale: Scale, tree: Any, dimension: Dimension | None) -> Words:
    """A value with its unit: ``2 kg``, ``(3i − 4j) m s⁻¹``, ``ku``."""
    shown = laid(tree)
    unit = "" if is_zero(tree) else scale.unit(dimension)
    if isinstance(tree, Polar):
        return words(
            value(scale, tree.size, dimension), " ", direction(tree.angle, tree.origin, tree.wall)
        )
    several = isinstance(shown, lay.Sum) and len(shown.terms) > 1
    if several and (unit or is_vector(tree)):
        shown = lay.Brackets(shown)
    return words(shown, unit)


def is_zero(tree: Any) -> bool:
    """Whether an expression is the number 0."""
    return isinstance(tree, Number) and tree.value == 0


def is_rest(tree: Any) -> bool:
    """Whether a velocity is none."""
    return isinstance(tree, Pair) and is_zero(tree.x) and is_zero(tree.y)


def is_vector(tree: Any) -> bool:
    """Whether an expression is a vector, as far as its form tells."""
    match tree:
        case Unit() | Pair() | Polar():
            return True
        case Quantity(kind, arguments):
            return kind in _VECTORS or (kind == "impulse" and bool(arguments))
        case Negate(operand):
            return is_vector(operand)
        case Binary(_, left, right):
            return is_vector(left) or is_vector(right)
    return False


def point(tree: Expression) -> Words:
    """A point of the plane, or a wall, as somewhere to be or to get to."""
    match tree:
        case Name(name):
            return (Named(name),)
        case Pair(x, y):
            return words("the point ", lay.Coordinates((lay.from_tree(x), lay.from_tree(y))))
    return words("the point with position vector ", laid(tree))


def length(scale: Scale, tree: Expression) -> Words:
    """A length with its unit."""
    return value(scale, tree, LENGTH)


# --- directions -----------------------------------------------------------------------------------


def angle(tree: Expression) -> Words:
    """``an angle of 60°``, ``an acute angle α``."""
    if isinstance(tree, Letter):
        return words("an acute angle ", lay.from_tree(tree))
    return words("an angle of ", lay.from_tree(tree))


def turned(tree: Expression, origin: Any) -> Words:
    """``at an angle of 60° anticlockwise from i``."""
    sense = "anticlockwise"
    size = tree
    if isinstance(tree, Negate):
        size, sense = tree.operand, "clockwise"
    elif isinstance(tree, Binary) and isinstance(tree.left, Negate) and tree.op in "*/":
        size, sense = replace(tree, left=tree.left.operand), "clockwise"
    start = I if origin is None else direction_of(origin)
    return words("at ", angle(size), f" {sense} from ", start)


def direction(tree: Expression, origin: Any = None, wall: Any = None) -> Words:
    """The direction of a vector that is told by size and direction."""
    if isinstance(wall, Name):
        return words("towards ", Named(wall.name), " at ", angle(tree), " to ", Named(wall.name))
    return turned(tree, origin)


def direction_of(tree: Expression) -> Words:
    """A direction told by a vector, for ``parallel to …`` and ``from …``."""
    if is_vector(tree):
        shown = laid(tree)
        if isinstance(shown, lay.Sum) and len(shown.terms) > 1:
            shown = lay.Brackets(shown)
        return words(shown)
    return words("the direction ", turned(tree, None))


def to_the_left(tree: Expression) -> Words:
    """The direction at a right angle to another, anticlockwise: for **i** it is **j**."""
    match tree:
        case Unit("i"):
            return (lay.Bold("j"),)
        case Unit("j"):
            return (lay.negative(I),)
    return words("the direction at 90° anticlockwise from ", direction_of(tree))


def lies_along(tree: Expression) -> Words:
    """How a wall or a line of centres runs: ``parallel to i``, ``at an angle of 60° …``."""
    if is_vector(tree):
        return words("parallel to ", direction_of(tree))
    return turned(tree, None)


def times(factor: Expression) -> Words:
    """A factor without quantities, in front of a quantity in words."""
    if isinstance(factor, Number):
        if factor.value == 2:
            return ("twice ",)
        percent = 100 * factor.value
        if 0 < percent < 100 and percent.denominator == 1:
            return words(lay.Percent(lay.from_tree(Number(percent))), " of ")
    fraction = as_fraction(factor)
    if fraction is not None and 0 < fraction < 1:
        return words(lay.from_tree(factor), " of ")
    shown = lay.from_tree(factor)
    several = isinstance(shown, lay.Sum) and len(shown.terms) > 1
    return words(lay.Brackets(shown) if several else shown, " times ")


def as_fraction(tree: Expression) -> Fraction | None:
    """The number that a tree of the form p/q is."""
    match tree:
        case Number(found):
            return found
        case Binary("/", Number(above), Number(below)) if below:
            return above / below
    return None
