"""Values in words: numbers with their units, vectors, points and directions."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from restitution.expression.dimensions import LENGTH, Dimension
from restitution.expression.quantities import is_vector_quantity
from restitution.expression.tree import (
    Binary,
    Degrees,
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
from restitution.wording.structure import Emphasis, Words
from restitution.wording.units import Style
from restitution.wording.words import words

EAST = lay.Bold("i")


def layout_of(tree: Expression) -> lay.Layout:
    """The mathematics of an expression; a pair in round brackets is a vector in **i** and **j**."""
    if isinstance(tree, Pair):
        return lay.vector(lay.from_tree(tree.x), lay.from_tree(tree.y))
    return lay.from_tree(tree)


def value(style: Style, tree: Any, dimension: Dimension | None) -> Words:
    """A value with its unit: ``2 kg``, ``(3i − 4j) m s⁻¹``, ``ku``."""
    shown = layout_of(tree)
    unit = "" if is_zero(tree) else style.unit(dimension)
    if isinstance(tree, Polar):
        return words(value(style, tree.size, dimension), " ", direction(style, tree))
    several = isinstance(shown, lay.Sum) and len(shown.terms) > 1
    if several and (unit or is_vector(tree)):
        shown = lay.Brackets(shown)
    return words(shown, unit)


def with_unit(style: Style, shown: lay.Layout, dimension: Dimension | None) -> Words:
    """Mathematics that stands for a value, with its unit: ``(mv − mw) N s``."""
    unit = style.unit(dimension)
    if unit and isinstance(shown, lay.Sum) and len(shown.terms) > 1:
        shown = lay.Brackets(shown)
    return words(shown, unit)


def is_zero(tree: Any) -> bool:
    """Whether an expression is the number 0."""
    return isinstance(tree, Number) and tree.value == 0


def is_vector(tree: Any) -> bool:
    """Whether an expression is a vector, as far as its form tells."""
    match tree:
        case Unit() | Pair() | Polar():
            return True
        case Quantity():
            return is_vector_quantity(tree)
        case Negate(operand):
            return is_vector(operand)
        case Binary(_, left, right):
            return is_vector(left) or is_vector(right)
    return False


def point(tree: Expression) -> Words:
    """A point of the plane, or a wall, as somewhere to be or to get to."""
    match tree:
        case Name(name):
            return (Emphasis(name),)
        case Pair(x, y):
            return words("the point ", lay.Coordinates((lay.from_tree(x), lay.from_tree(y))))
    return words("the point with position vector ", layout_of(tree))


def spot(tree: Expression) -> Words:
    """A point by its name or coordinates alone: ``(0, 0)``."""
    phrase = point(tree)
    return phrase[1:] if isinstance(tree, Pair) else phrase


def length(style: Style, tree: Expression) -> Words:
    """A length with its unit."""
    return value(style, tree, LENGTH)


# --- directions -----------------------------------------------------------------------------------


def angle(style: Style, tree: Expression) -> Words:
    """``an angle of 60°``, ``an acute angle α``."""
    if isinstance(tree, Letter):
        kind = "an acute angle " if tree.name in style.acute else "an angle "
        return words(kind, lay.from_tree(tree))
    return words("an angle of ", lay.from_tree(tree))


def turned(style: Style, tree: Expression, origin: Any = None) -> Words:
    """``at an angle of 60° anticlockwise from i``."""
    sense = "anticlockwise"
    size = tree
    if isinstance(tree, Negate):
        size, sense = tree.operand, "clockwise"
    elif isinstance(tree, Binary) and isinstance(tree.left, Negate) and tree.op in "*/":
        size, sense = replace(tree, left=tree.left.operand), "clockwise"
    start = EAST if origin is None else direction_of(style, origin)
    return words("at ", angle(style, size), f" {sense} from ", start)


def direction(style: Style, tree: Polar) -> Words:
    """The direction of a vector that is told by size and direction."""
    if isinstance(tree.wall, Name):
        return towards(style, tree.wall.name, tree.angle)
    return turned(style, tree.angle, tree.origin)


def towards(style: Style, wall: str, size: Expression) -> Words:
    """``towards W at an angle of 60° to W``."""
    return words("towards ", Emphasis(wall), " at ", angle(style, size), " to ", Emphasis(wall))


def direction_of(style: Style, tree: Expression) -> Words:
    """A direction told by a vector, for ``parallel to …`` and ``from …``."""
    if is_vector(tree):
        shown = layout_of(tree)
        if isinstance(shown, lay.Sum) and len(shown.terms) > 1:
            shown = lay.Brackets(shown)
        return words(shown)
    return words("the direction ", turned(style, tree))


def to_the_left(style: Style, tree: Expression) -> Words:
    """The direction at a right angle to another, anticlockwise: for **i** it is **j**."""
    match tree:
        case Unit("i"):
            return (lay.Bold("j"),)
        case Unit("j"):
            return (lay.negative(EAST),)
    return words("the direction at 90° anticlockwise from ", direction_of(style, tree))


def lies_along(style: Style, tree: Expression) -> Words:
    """How a wall or a line of centres runs: ``parallel to i``, ``at an angle of 60° …``."""
    match tree:
        case Polar(_, Degrees(value), origin) if origin is not None and is_vector(origin):
            if abs(value) == 90:
                return words("perpendicular to ", direction_of(style, origin))
    if is_vector(tree):
        return words("parallel to ", direction_of(style, tree))
    return turned(style, tree)


def times(factor: Expression) -> Words:
    """A factor without quantities, in front of a quantity in words."""
    fraction = as_fraction(factor)
    if fraction == 1:
        return ()
    if fraction == 2:
        return ("twice ",)
    if fraction == Fraction(1, 2):
        return ("half of ",)
    if (
        isinstance(factor, Number)
        and 0 < factor.value < 1
        and (100 % factor.value.denominator) == 0
    ):
        return words(lay.Percent(lay.from_tree(Number(100 * factor.value))), " of ")
    if fraction is not None and 0 < fraction < 1:
        return words(lay.from_tree(factor), " of ")
    shown = lay.from_tree(factor)
    several = isinstance(shown, lay.Sum) and len(shown.terms) > 1
    return words(lay.Brackets(shown) if several else shown, " times ")


def as_fraction(tree: Expression) -> Fraction | None:
    """The number that a tree of the form p/q is."""
    match tree:
        case Number(value):
            return value
        case Binary("/", Number(above), Number(below)) if below:
            return above / below
    return None
