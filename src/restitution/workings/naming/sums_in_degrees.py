"""Sums of angles with the degrees of inverses of ratios: ``35° + 22.78°``."""

from __future__ import annotations

from functools import partial

import sympy as sp

from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Negate,
    Number,
    RoundedDegrees,
    functions_in,
    has_root,
    is_binary,
    letters,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import swept
from restitution.workings.naming.measured import FIGURES_BETWEEN, number_carried, scalar_worth

FIGURES_OF_ANSWERS = 3
FIGURES_BEFORE_A_ROUNDING = range(FIGURES_BETWEEN, 7)
RATIOS = frozenset({"sin", "cos", "tan", "cot"})
_INVERSES = frozenset({"arcsin", "arccos", "arctan"})


def is_sum_with_inverse(tree: Expression) -> bool:
    """Whether a tree is a sum of numbers of degrees with the inverse of a ratio among them."""
    return (
        is_binary(tree, "+", "-") and _is_sum_of_angles(tree) and any(map(is_inverse, walk(tree)))
    )


def is_sum_of_inverses_of_roots(tree: Expression) -> bool:
    """Whether a sum of angles has several inverses, with roots among them, that nobody reads."""
    if _INVERSES.isdisjoint(functions_in(tree)):
        return False
    inverses = [node for node in walk(tree) if is_inverse(node)]
    return is_sum_with_inverse(tree) and len(inverses) > 1 and any(map(has_root, inverses))


def _is_sum_of_angles(tree: Expression) -> bool:
    match unsigned(tree):
        case Binary("+" | "-", left, right):
            return _is_sum_of_angles(left) and _is_sum_of_angles(right)
        case own:
            return isinstance(own, Degrees) or is_inverse(own)


def is_figures(tree: Expression) -> bool:
    """Whether a side is a number, or a sum of numbers of degrees that has some in figures."""
    own = unsigned(tree)
    inside = walk(own)
    return isinstance(own, Number) or (
        _is_sum_of_angles(own)
        and any(isinstance(node, RoundedDegrees) for node in inside)
        and not any(map(is_inverse, inside))
    )


def is_inverse(tree: Expression) -> bool:
    """Whether a tree is the inverse of a ratio that is a number: arctan 0.45."""
    return isinstance(tree, Apply) and tree.function in _INVERSES and not letters(tree)


def angles_in_figures(tree: Expression) -> Expression:
    """A sum of angles with the degrees of each inverse of a ratio: 35° + 22.78°.

    The tree itself where they lead to another answer.
    """
    answer = degrees_of(tree, FIGURES_OF_ANSWERS)
    for figures in FIGURES_BEFORE_A_ROUNDING:
        put = swept(rebuilt(tree, partial(_in_degrees, figures=figures)))
        if degrees_of(put, FIGURES_OF_ANSWERS) == answer:
            return put
    return tree


def bound_in_figures(tree: Expression) -> Expression:
    """A bound with the degrees of each sum of angles: 70° − 53.13°, and below it tan 16.87°."""

    def change(own: Expression) -> Expression:
        match own:
            case Apply(name, angle) if name in RATIOS and is_sum_with_inverse(angle):
                return Apply(name, degrees_of(angle) or angle)
        return own

    if is_sum_with_inverse(tree):
        return angles_in_figures(tree)
    return swept(rebuilt(tree, change)) if any(map(is_inverse, walk(tree))) else tree


def _in_degrees(tree: Expression, figures: int) -> Expression:
    """The degrees of the inverse of a ratio; any other tree as it is."""
    return (degrees_of(tree, figures) or tree) if is_inverse(tree) else tree


def degrees_of(tree: Expression, figures: int = FIGURES_BETWEEN) -> Expression | None:
    """An angle in degrees to so many figures; None of one that is very small."""
    value = scalar_worth(tree)
    number = None if value is None else number_carried(value * 180 / sp.pi, figures)
    if number is None:
        return None
    size = RoundedDegrees(abs(number), figures)
    return Negate(size) if number < 0 else size
