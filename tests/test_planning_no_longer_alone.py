"""Kinds of questions of which the answers stood alone: what each working now says.

Each is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

import pytest
from laws_of_workings import answers, complaints

from restitution.language import parse
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.workings import to_text
from restitution.workings.derived import explanation_of

# A statement, and what its working says: lines, or parts of them.
CASES = {
    "two angles that are equal, both right angles": (
        """
wall W: along i
wall X: along j
sphere P: velocity 3u at theta to W
P hits W: e = k
P hits X: e = k
given deflection(P, 1) = deflection(P, 2)
find theta
""",
        ("cos δ = ", "cos φ = ", "δ = φ", "tan²θ = 1/k"),
    ),
    "who can only strike a round wall from inside": (
        """
wall R: circle centre (0, 0) radius b
sphere Q: mass 2, at (0, h), velocity 3w i
Q hits R: e = 1/2
given energy_lost = 1/4 energy(0)
find h
""",
        ("t = √(b² − h²)/(3w), as t > 0", "h² = 2b²/3"),
    ),
    "a path to a round wall that is to be found": (
        """
wall R: circle centre (0, 0) radius b
sphere Q: at (-3b, h), velocity w i
Q hits R: e = 1/3
given deflection(Q) = 90°
find h
""",
        ("h² = b²/4",),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_working_has_a_plan(name: str) -> None:
    statement, lines = CASES[name]
    problem = parse(statement)
    solution = solve(problem)
    derivation = plan(solution)
    assert complaints(solution, derivation) == []
    assert answers(solution, derivation) == []
    text = to_text(explanation_of(derivation, problem))
    missing = [each for each in lines if each not in text]
    assert not missing, text
