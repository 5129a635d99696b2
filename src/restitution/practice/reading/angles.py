"""Bare numbers that are degrees: in a sine, in a sum of angles, beside an angle."""

from __future__ import annotations

from typing import cast

from restitution.explaining.lines.trees import rebuilt
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Measured,
    Negate,
    Number,
    Pair,
    Pi,
    Quantity,
    walk,
)
from restitution.practice.reading.vocabulary import DIRECTIONS, HEADS


def radians(number: Number) -> Expression:
    """A number of radians, marked while the line is read: it never becomes degrees."""
    return cast("Expression", Measured(number, "rad", place=number.place))


def without_marks(tree: Expression) -> Expression:
    """A tree whose numbers of radians are plain numbers."""
    return rebuilt(tree, _without_mark)


def _without_mark(node: Expression | Measured) -> Expression:
    return node.operand if isinstance(node, Measured) else node


def _is_marked(tree: object) -> bool:
    """Whether a tree is a number of radians that is marked."""
    return isinstance(tree, Measured)


def is_angle(tree: Expression, angles: frozenset[str]) -> bool:
    """Whether a tree is an angle; ``angles`` are the letters that are."""
    if _is_marked(tree):
        return True
    match tree:
        case Degrees():
            return True
        case Letter(name):
            return name in angles or _names_angle(name)
        case Apply(function, _):
            return function.startswith("arc")
        case Quantity(kind):
            return kind in ANGLES
        case Negate(operand):
            return is_angle(operand, angles)
        case Binary("+" | "-", left, right):
            return is_angle(left, angles) or is_angle(right, angles)
        case Binary("*", left, right):
            return is_angle(left, angles) != is_angle(right, angles)
        case Binary("/", left, right):
            return is_angle(left, angles) and not is_angle(right, angles)
    return False


def _names_angle(phrase: str) -> bool:
    """Whether a phrase names an angle: ``angle to the wall``, not ``speed in the i direction``."""
    words = phrase.split()
    heads = {HEADS[word] for word in words if word in HEADS}
    if heads & {"angle", "deflection"}:
        return True
    axis = set(words) & {"i", "j", "x", "y", *DIRECTIONS}
    return heads == {"direction"} and not axis


def angular(tree: Expression, angles: frozenset[str]) -> Expression:
    """A tree that is an angle, with its bare numbers as degrees: ``90 - a`` and ``2 × 30``."""
    match tree:
        case Number(value):
            return Degrees(value, place=tree.place)
        case Negate(operand):
            return Negate(angular(operand, angles), place=tree.place)
        case Binary("+" | "-" as op, left, right):
            return Binary(op, angular(left, angles), angular(right, angles), place=tree.place)
        case Binary("*", left, right) if _is_numeric(tree):
            return Binary("*", left, angular(right, angles), place=tree.place)
        case Binary("/", left, right) if _is_numeric(tree):
            return Binary("/", angular(left, angles), right, place=tree.place)
        case Binary("*" | "/" as op, left, right) if is_angle(left, angles):
            return Binary(op, angular(left, angles), right, place=tree.place)
        case Binary("*", left, right) if is_angle(right, angles):
            return Binary("*", left, angular(right, angles), place=tree.place)
    return tree


def _is_numeric(tree: Expression) -> bool:
    """Whether a tree is made of bare numbers alone."""
    return all(isinstance(node, Number | Binary | Negate) for node in walk(tree))


def in_degrees(tree: Expression, angles: frozenset[str]) -> Expression:
    """A tree in which bare numbers in a sum with an angle are degrees."""
    match tree:
        case Binary("+" | "-" as op, left, right):
            if is_angle(tree, angles) and not _has_pi(tree):
                return angular(tree, angles)
            return Binary(op, in_degrees(left, angles), in_degrees(right, angles), place=tree.place)
        case Binary(op, left, right):
            return Binary(op, in_degrees(left, angles), in_degrees(right, angles), place=tree.place)
        case Negate(operand):
            return Negate(in_degrees(operand, angles), place=tree.place)
        case Apply(function, argument):
            return Apply(function, in_degrees(argument, angles), place=tree.place)
        case Pair(x, y):
            return Pair(in_degrees(x, angles), in_degrees(y, angles), place=tree.place)
    return tree


def _has_pi(tree: Expression) -> bool:
    return any(isinstance(node, Pi) for node in walk(tree))
