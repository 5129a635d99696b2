"""Places that are given at an event: the equation of one coordinate.

Each working is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

import pytest
from workings import planned

from restitution import parse, solve
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

# A statement, and lines of its working, or parts of them.
CASES = {
    "on the second of two walls": (
        """
point O: (0, 0)
wall OA: from O to (6, 0)
wall AB: from (6, 0) to (6, 4)
sphere P: mass m, at (0, 3), velocity V i - 2 j
P hits OA: e = 1/2
P hits AB: e = 1/3
given position(P) = (6, 2)
find V
""",
        ("3(4 − V)/(2V) = 2", "V = 12/7"),
    ),
    "of a direction": (
        """
wall W: through (6, 0), along j
wall U: through (0, 8), along i
sphere P: mass m, at (0, 0), velocity 4 at alpha
P hits W: e = 1/2
P hits U: e = 1/3
given position(P) = (5, 8)
find alpha, speed(P)
""",
        ("9 − 4/tan α = 5", "α = 45°", "speed of P = √((2√2/3)² + (√2)²) = √26/3"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_coordinate_tells_what_is_unknown(name: str) -> None:
    """The working has the equation of the coordinate."""
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    for line in lines:
        assert line in text, f"{line}\n{text}"


def test_a_place_may_be_told_twice() -> None:
    """Where two that move meet follows from their ways too: both are routes to V."""
    statement = """
sphere A: mass 1, at (0, 0), velocity V i
sphere B: mass 2, at (3, 4), velocity 2i - j
A hits B: along i, e = 1/2
given position(A) = (11, 0)
find V
"""
    text = to_text(explain(solve(parse(statement))))
    assert "V = 11/4 m s⁻¹" in text
