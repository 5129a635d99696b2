"""Ends of ranges over which other letters vary: those that one value of these reaches alone."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution.language import parse
from restitution.solving import solve

TURNED = """
    sphere A, B: mass m
    sphere A: velocity u at alpha
    sphere B: at rest
    A hits B: along i
    unknown {free}
    given deflection(A) {bound}
    find range of {letter}
    """


@pytest.mark.parametrize(
    ("text", "values", "proof"),
    [
        # The component is (1 + e)u sin θ cos θ, which is greatest at θ = 45°.
        (
            """
            wall W: along theta
            sphere P: velocity u i
            P hits W
            unknown theta
            given along(velocity(P), j) >= 3u/4
            find range of e
            """,
            sp.Interval(sp.Rational(1, 2), 1),
            "decision",
        ),
        # sin δ = (1 + e)/(3 − e) where δ is greatest.
        (
            TURNED.format(free="alpha", bound=">= 30°", letter="e"),
            sp.Interval(sp.Rational(1, 3), 1),
            "decision",
        ),
        (
            TURNED.format(free="alpha", bound="> 30°", letter="e"),
            sp.Interval.Lopen(sp.Rational(1, 3), 1),
            "undecided",
        ),
        # With e = 1 it is turned by 90° − α, with less by less.
        (
            TURNED.format(free="e", bound=">= 50°", letter="alpha"),
            sp.Interval.Lopen(0, sp.pi * 2 / 9),
            "decision",
        ),
        # They part where k(1 + f(1 + e)) ≤ e: with f = 0 and e = 1 at the latest.
        (
            """
            sphere A: mass k m, velocity u i
            sphere B: mass m, at rest
            wall W: along j
            A hits B: along i
            B hits W: e = f
            unknown e, f
            given A and B do not collide again
            find range of k
            """,
            sp.Interval.Lopen(0, 1),
            "decision",
        ),
    ],
    ids=["a wall", "a deflection", "a deflection beyond", "a coefficient", "two coefficients"],
)
def test_an_end_that_one_value_of_a_free_letter_reaches(
    text: str, values: sp.Set, proof: str
) -> None:
    item = solve(parse(text)).parts[None].items[0]
    assert [answer.value for answer in item.answers] == [values]
    assert item.proof == proof
