"""Decimals between: those that are put in lead to the figures that are printed."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from restitution.expression.tree import Apply, Binary, Negate, Number
from restitution.workings.naming.figures import Figures


def as_number(tree) -> float:
    return -float(tree.operand.value) if isinstance(tree, Negate) else float(tree.value)


@pytest.mark.parametrize("above", [1, 7, 19, -8, -27])
def test_the_angle_of_a_decimal_cosine_is_that_of_the_exact_one(above: int) -> None:
    for square in range(1255, 1271):  # arccos 0.5351 = 57.65°, where arccos(19/√1261) is 57.653°
        root = Apply("sqrt", Number(Fraction(square)))
        cosine = Binary("/", Number(Fraction(abs(above))), root)
        put = as_number(Figures().cosine(Negate(cosine) if above < 0 else cosine))
        exact = math.degrees(math.acos(above / math.sqrt(square)))
        assert f"{math.degrees(math.acos(put)):.3g}" == f"{exact:.3g}", (above, square)
