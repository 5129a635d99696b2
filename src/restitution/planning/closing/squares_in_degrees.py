"""Squares of an unknown in numbers with ratios of angles such as 37°."""

from __future__ import annotations

import sympy as sp

from restitution.exact.symbols import symbols_in
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.writing.forms import is_in_degrees
from restitution.planning.writing.polynomials import expanded, one_fraction
from restitution.planning.writing.scene import Scene


def square_in_degrees(scene: Scene, number: int, generator: sp.Expr) -> sp.Expr | None:
    """What the square of an unknown is by a line, with ratios of angles such as 37° as they stand.

    None where there are letters beside it, or no such ratios.
    """
    link = scene.desk.last_link(number)
    left, right = (scene_value(scene, side) for side in (link.left, link.right))
    sides = expanded(left - right)
    if not sides.is_polynomial(generator) or symbols_in(sides) != {generator}:
        return None
    value = -sides.coeff(generator, 0) / sides.coeff(generator, 2)
    if sp.degree(sides, generator) != 2 or not is_in_degrees(value):
        return None
    above, below = sp.fraction(one_fraction(value))
    return -above / -below if scene.model.sign(below) < 0 else above / below


__all__ = ["square_in_degrees"]
