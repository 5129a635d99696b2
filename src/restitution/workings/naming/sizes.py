"""Sizes of values: many figures, by which a value of a working is known again."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import sympy as sp

from restitution.expression.tree import Expression, Negate, has_quantity, letters
from restitution.planning.writing.forms import swept
from restitution.workings.naming.figure_multiples import number_and_letters
from restitution.workings.naming.measured import scalar_worth
from restitution.workings.naming.plain_angles import has_plain_angles

# Two values of a working that agree in so many figures are one.
_FIGURES_THAT_TELL, _FIGURES_TOLD = 30, 20


class Size(NamedTuple):
    """A value without its sign: many figures, with its letters."""

    is_positive: bool
    figures: str


@lru_cache(maxsize=4096)
def size_of(tree: Expression) -> Size | None:
    """The size of a value of plain angles; None of another.

    It tells which value of a working is meant, and decides nothing.
    """
    if not has_plain_angles(tree) or has_quantity(tree):
        return None
    if letters(tree):
        number, rest = number_and_letters(tree) or (None, sp.S.One)
    else:
        number, rest = scalar_worth(tree), sp.S.One
    size = None if number is None else number.evalf(_FIGURES_THAT_TELL)
    if not isinstance(size, sp.Float):
        return None
    return Size(bool(size > 0), f"{sp.Float(abs(size), _FIGURES_TOLD)} {rest}")


def with_sign(tree: Expression, is_positive: bool) -> Expression:
    """A side as it is, or with the other sign."""
    return tree if is_positive else swept(Negate(tree))


def digits_of(tree: Expression) -> str:
    """Many figures of the size of a number, which tell it from others on paper."""
    value = scalar_worth(tree)
    return "" if value is None else str(sp.Abs(value).evalf(_FIGURES_TOLD))
