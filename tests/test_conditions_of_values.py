"""Conditions of several values that one line gives, and solutions that part above it."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

AT_REST = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given {fact}
find e
"""


@pytest.mark.parametrize(
    ("fact", "lines"),
    [
        (
            "speed(A) = 1/4 u",
            [
                "e = (5 + k)/(4k) or e = (3 − k)/(4k) A1 A1",
                "As e ≤ 1, e = (5 + k)/(4k) holds for k ≥ 5/3 only.",
                "As 0 ≤ e ≤ 1, e = (3 − k)/(4k) holds for ⅗ ≤ k ≤ 3 only.",
            ],
        ),
        (
            "speed(A) = speed(B)",
            [
                "((1 + e)u/(1 + k))² = ((1 − ek)u/(1 + k))²",
                "e = 0 or e = 2/(k − 1)",
                "As 0 ≤ e ≤ 1, e = 2/(k − 1) holds for k ≥ 3 only.",
            ],
        ),
    ],
)
def test_each_value_has_its_condition(fact: str, lines: list[str]) -> None:
    working = " ".join(to_text(explain(solve(parse(AT_REST.format(fact=fact)))), 100).split())
    for line in lines:
        assert line in working
