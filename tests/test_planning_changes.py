"""Changes of a velocity, or of a momentum, that are given.

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
    "of a sphere, along a slanting line of centres": (
        """
sphere A: mass 4, velocity 2i + 3j
sphere B: mass 3, velocity -i - 2j
A hits B: along 3i + j
given velocity(A) - velocity(A, 0) = -3i - j
find e, velocity(B), impulse
""",
        ("Since 𝐯_A − 𝐮_A = −3𝐢 − 𝐣:", "𝐯_A = (2𝐢 + 3𝐣) + (−3𝐢 − 𝐣) = (−𝐢 + 2𝐣) m s⁻¹", "e = ⅔"),
    ),
    "that tells a mass": (
        """
sphere A: mass 3, velocity 4i + 2j
sphere B: mass M, at rest
A hits B: along i + j, e = 1/2
given velocity(A, 0) - velocity(A) = 3i + 3j
find M, velocity(B)
""",
        ("𝐯_A = (4𝐢 + 2𝐣) − (3𝐢 + 3𝐣) = (𝐢 − 𝐣) m s⁻¹", "M = 6"),
    ),
    "that tells where a wall is": (
        """
wall W
sphere P: mass 2, velocity 3i - 4j
P hits W
given velocity(P) - velocity(P, 0) = -i + 6j
find velocity(P), direction(W), e
""",
        ("the normal to W is parallel to (2𝐢 + 2𝐣) − (3𝐢 − 4𝐣)", "W is parallel to 6𝐢 + 𝐣"),
    ),
    "that is added to what was before": (
        """
sphere A: mass 2, velocity 5i + j
sphere B: mass 4, velocity -2i + 3j
A hits B
given velocity(B) = velocity(B, 0) + 3i - j
find velocity(A), line_of_centres, e
""",
        ("𝐯_B = (−2𝐢 + 3𝐣) + 3𝐢 − 𝐣 = (𝐢 + 2𝐣) m s⁻¹", "e = 7/23"),
    ),
    "of a momentum": (
        """
sphere A: mass 2m, velocity 4u i
sphere B: mass m, velocity -u i + u j
A hits B: along i
given momentum(B) - momentum(B, 0) = 6m u i
find e, velocity(A)
""",
        ("6mu𝐢 = m(𝐯_B − (−u𝐢 + u𝐣))", "𝐯_B = 5u𝐢 + u𝐣", "e = ⅘"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_change_tells_what_is_after_it(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text
