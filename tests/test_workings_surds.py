"""Sums of roots that are squared or divided by: what is multiplied out stands on paper."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

# Statement, and what its working says, in this order.
SAYS = {
    # tan 60° = (1 + e)/(1 − e) at 45° to the wall.
    "a quotient of products is multiplied out before it is cancelled": (
        """
        wall W: along i
        sphere P: mass m, velocity u at 45° to W
        P hits W
        let theta = deflection(P)
        part a
        show tan(theta) = (1 + e)/(1 - e)
        part b
        given theta = 60°
        find e
        """,
        ["= (√3 − 1)(√3 − 1)/((1 + √3)(√3 − 1)) = (4 − 2√3)/2 = 2 − √3"],
    ),
    # (√5 − 3/2)² = 29/4 − 3√5 = (1 + e²)/2, so e² = 27/2 − 6√5.
    "the square of a sum of roots is worked out before an equation is solved": (
        """
        wall W: along i
        sphere P: velocity u at 45° to W
        P hits W
        given speed(P) = (sqrt(5) - 3/2) u
        find e
        """,
        ["((√5 − 3/2)u)² =", "(29 − 12√5)u²/4 = e²u²/2 + u²/2", "e² ="],
    ),
}


@pytest.mark.parametrize("case", SAYS)
def test_sums_of_roots_are_multiplied_out(case: str) -> None:
    statement, says = SAYS[case]
    working = explain(solve(parse(statement)), marks="none", check=True)
    text = " ".join(to_text(working).split())
    assert not working.warnings
    for piece in says:
        assert piece in text, piece
        text = text[text.index(piece) :]
