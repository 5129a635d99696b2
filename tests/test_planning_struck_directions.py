"""Where spheres with radii touch, by the direction that is given of the one that was at rest.

Each working is followed line by line, its answers are those of the solver, and it says what a
teacher says.
"""

from __future__ import annotations

import pytest
from workings import planned

from restitution.workings import to_text
from restitution.workings.derived import explanation_of

# A statement, and what its working says: lines, or parts of them.
CASES = {
    "where the other one is": (
        """
sphere A, B: mass m, radius 2
sphere A: at (0, 0), velocity 5i
sphere B: at (12, h), at rest
A hits B: e = 1/3
given direction(B) = 45°
find h, time(1), speed(B), speed(A)
""",
        (
            "B was at rest, so it moves off along the line of centres:",
            "The centres are two radii apart, along the line of centres:",
            "= 2(6 − √2)𝐢 + (h − 2√2)𝐣",
            "t = 2(6 − √2)/5",
            "h = 2√2",
        ),
    ),
    "from where it is struck": (
        """
sphere P: mass 2, radius 1/2, at (0, k), velocity 3i
sphere Q: mass 3, radius 1/2, at (6, 0), at rest
P hits Q: e = 1/2
given direction(Q) = -30°
find k, speed(Q), velocity(P)
""",
        ("the line of centres is parallel to √3 𝐢 − 𝐣", "0 = 3(½ − k)", "k = ½"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_direction_tells_where_spheres_touch(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text
