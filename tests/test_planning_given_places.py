"""Places that are given at an event: the equation of one coordinate.

Each working is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

import pytest
from workings import planned

from restitution import parse, solve
from restitution.explaining.lines.notation import read_tree
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
    "at a time after the impact": (
        """
wall W: along i, through (0, 5)
sphere P: at (0, 1), velocity i + 2j
P hits W
given position(P, at 6) = (6, 2)
find e
""",
        ("= (2𝐢 + 5𝐣) + (6 − 2)(𝐢 − 2e𝐣)", "5 − 8e = 2", "e = ⅜"),
    ),
    "at a time that is sought": (
        """
wall W: along i, through (0, 5)
sphere P: at (0, 1), velocity i + 2j
P hits W: e = 1/4
given position(P, at t) = (8, 2), t > 0
find t
""",
        ("Comparing components:", "t = 8"),
    ),
    "of a sphere after it was struck": (
        """
sphere A: mass 1, velocity 3i + j
sphere B: mass 2, at rest
A hits B: along i
given position(A, at 4) = 2i + 4j
find e
""",
        ("4 − 8e = 2", "e = ¼"),
    ),
}


@pytest.mark.parametrize("bound", ["t > 0", "t > time(1)", "0 < t"])
def test_a_time_that_is_only_positive_is_after_all_events(bound: str) -> None:
    """The place is on the way back from the wall, and not on the way to it."""
    text = (
        "wall W: along j, through (3, 0)\nsphere P: at (0, 0), velocity i + j\nP hits W: e = 1/2\n"
        f"given position(P, at t) = (2, 5), {bound}\nfind t"
    )
    assert solve(parse(text))["t"].exact == 5


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
    assert "V = 11/4" in text


def test_a_coordinate_that_the_wall_tells_is_not_worked_out_for_the_place() -> None:
    _, derivation = planned("""
wall F: along i, through (0, 0)
wall V: along j, through (4a, 0)
sphere P: at (a, a), velocity 4k u i - 2u j
P hits F: e = 1/2
P hits V: e = 1/3
part a
given position(P, 2) = (4a, 1/4 a)
find k
part b
given k = 1
find time(2)
""")
    there = read_tree("along(position(P, 2), i)", {})
    assert there not in [tree for line in derivation.lines for tree in line.relation.trees]
