"""The equation of the line on which a straight wall lies: as 3x = 4y, or 3x + 4y = 12."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link
from restitution.expression.tree import Expression
from restitution.planning.writing.desk import link
from restitution.planning.writing.forms import product, swept, total, tree_of
from restitution.planning.writing.unit_vectors import plain_direction
from restitution.vector import Vector


def equation_of_line(
    normal: Vector, through: Vector, point: Sequence[Expression], *, by_slope: bool = False
) -> Link:
    """That a point, by its coordinates, is on a line, by a vector across it and a point of it.

    What is taken away stands on the other side, and the constant on the right. A line through the
    origin at an angle is told ``by_slope``, y = x tan θ, if that is wanted.
    """
    plain = plain_direction(normal)
    constant = tidy(plain.dot(through))
    slope = tidy(sp.trigsimp(-plain.x / plain.y)) if by_slope and constant == 0 else sp.S.One
    if isinstance(slope, sp.tan):
        return link(point[1], product(point[0], tree_of(slope)))
    if _is_taken_away(plain.x):
        plain, constant = -plain, -constant
    left: list[Expression] = []
    right: list[Expression] = []
    for factor, tree in zip(plain, point, strict=True):
        minus = _is_taken_away(factor)
        own = product(tree_of(-factor if minus else factor), tree)
        (right if minus else left).append(own)
    if constant != 0:
        right.append(tree_of(constant))
    one, other = swept(total(left)), swept(total(right))
    if len(left) == len(right) == 1 and -plain.y == 1:
        one, other = other, one
    return link(one, other)


def _is_taken_away(factor: Any) -> bool:
    """Whether a factor is written with a minus sign in front."""
    return bool(sp.sympify(factor, strict=True).as_coeff_Mul()[0] < 0)


__all__ = ["equation_of_line"]
