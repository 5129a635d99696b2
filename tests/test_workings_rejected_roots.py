"""A root that is rejected by way of another letter: what it would make of that."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

SAME_SPEED = """
sphere A: mass m, velocity 2u i + u j
sphere B: mass 2m, velocity -3u i
A hits B: along i
given speed(A) = speed(A, 0)
find e
"""

SEVERAL_MASSES = """
sphere A: mass m, velocity 2u i + u j
sphere B: mass 3m, velocity -3u i
A hits B: along i
given speed(A) = speed(A, 0)
find e
"""


@pytest.mark.parametrize(
    ("statement", "reason"),
    [
        (SAME_SPEED, "v = −2u, as v = 2u would give w = −3u and e = −1 by (2) and (3)"),
        (SEVERAL_MASSES, "v = −2u, as v = 2u would give w = −3u and e = −1 by (2) and (3)"),
    ],
)
def test_the_values_stand_there(statement: str, reason: str) -> None:
    assert reason in to_text(explain(solve(parse(statement))), 100)
