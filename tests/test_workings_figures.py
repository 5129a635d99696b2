"""Decimals between: those that are put in lead to the figures that are printed."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from restitution.expression.tree import Apply, Binary, Negate, Number
from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text
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


def printed(text: str) -> str:
    return " ".join(to_text(explain(solve(parse(text)))).split())


def test_an_answer_has_its_values_put_in_before_it() -> None:
    text = printed(
        "sphere A: mass 0.2, velocity 3 at 40°\nsphere B: mass 0.3, velocity 2 at 160°\n"
        "A hits B: along i, e = 0.7\nfind speed(A), impulse"
    )
    assert "magnitude of the impulse ≈ 0.2(3 cos 40° + 1.963) ≈ 0.852 N s" in text


def test_the_half_of_an_energy_is_no_decimal() -> None:
    text = printed(
        "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, at rest\n"
        "A hits B: along i, e = 0.5\nfind energy_lost"
    )
    assert "kinetic energy lost = ½m(u/2)² − ½ × 2m(u/4)²" in text
