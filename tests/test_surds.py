"""Sums of surds against SymPy and against numbers of many digits."""

from __future__ import annotations

import pytest
import sympy
from hypothesis import given
from strategies import surds
from sympy import Rational, acos, atan, pi, sqrt

from restitution.exact import rationalised, root_is_nested, tidy_angle


@given(surds())
def test_sums_of_surds_are_those_of_sympy(number: sympy.Expr) -> None:
    plain = rationalised(number)
    if plain is None:  # more than four terms stand below a bar somewhere
        return
    assert plain == sympy.expand(sympy.radsimp(number, max_terms=40))
    assert all(power.exp == Rational(1, 2) for power in plain.atoms(sympy.Pow))
    assert abs((plain - number).evalf(40)) < 1e-30 * (1 + abs(number.evalf(40)))


@pytest.mark.parametrize(
    "number",
    [
        sqrt(1 + sqrt(2)),
        sympy.cbrt(2),
        sympy.Symbol("u") * sqrt(2),
        pi / sqrt(2),
        sqrt(-3),
        1 / (1 + sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7)),
        sympy.Add(sqrt(2), -sqrt(2), evaluate=False) ** -1,
    ],
    ids=str,
)
def test_other_numbers_are_left(number: sympy.Expr) -> None:
    assert rationalised(number) is None


@given(surds(), surds())
def test_a_root_that_can_be_undone_is_not_called_nested(a: sympy.Expr, b: sympy.Expr) -> None:
    square = rationalised((a + b) ** 2)
    assert square is None or not root_is_nested(square)


def test_a_nested_root() -> None:
    assert root_is_nested(1 + sqrt(2))
    assert root_is_nested(4 + sqrt(3))
    assert not root_is_nested(3 + 2 * sqrt(2))


@pytest.mark.parametrize("turn", [0, pi / 3, -pi / 4, pi])
@given(number=surds())
def test_an_angle_keeps_its_size(turn: sympy.Expr, number: sympy.Expr) -> None:
    for angle in (turn + atan(number), turn - 2 * atan(number)):
        assert abs((tidy_angle(angle) - angle).evalf(40)) < 1e-30


def test_an_angle_goes_by_what_is_shorter() -> None:
    assert tidy_angle(pi - pi / 3 - atan(6 * (15 + 7 * sqrt(3)) / 13)).has(atan)
    assert tidy_angle(atan(sqrt(5) / 2)) == acos(Rational(2, 3))
    assert tidy_angle(atan(2 + sqrt(3))) == 5 * pi / 12
