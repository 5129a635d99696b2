"""Numbers between two ends: what is exact stays so, and what is rounded takes its rounding in."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from operator import add, mul, sub

import pytest

from restitution.expression.enclosed import Enclosed

LONG = Fraction(3**1700, 2**5)
NUMBERS = (
    *(
        Fraction(0),
        Fraction(1),
        Fraction(-6),
        Fraction(5, 8),
        Fraction(-3, 2**60),
        Fraction(10**40),
    ),
    *(Fraction(1, 3), Fraction(-22, 7), Fraction(1, 2**2000), Fraction(2**2000), LONG, -LONG),
)


@pytest.mark.parametrize("act", [add, sub, mul])
def test_what_is_worked_out_lies_between_the_ends(act) -> None:
    for one, other in product(NUMBERS, repeat=2):
        whole = act(one, other)
        low, high = act(Enclosed.of(one), Enclosed.of(other)).between
        assert low <= whole <= high
        assert high - low <= abs(one * other if act is mul else abs(one) + abs(other)) / 10**390


@pytest.mark.parametrize("act", [add, sub, mul])
def test_short_numbers_stay_exact(act) -> None:
    for one, other in product(NUMBERS[:6], repeat=2):
        low, high = act(Enclosed.of(one), Enclosed.of(other)).between
        assert low == high == act(one, other)


def test_what_cancels_is_nothing() -> None:
    for number in NUMBERS[:6]:
        assert (Enclosed.of(number) - Enclosed.of(number)).between == (0, 0)
        assert (Enclosed.of(number) + Enclosed.of(-number)).sign == 0
