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
    "from a velocity in a letter, at a wall that is to be found": (
        """
wall W
sphere P: velocity a i + j
P hits W: e = 1/2
given velocity(P) = -i + 3j
find a
""",
        (
            "the normal to W is parallel to (−𝐢 + 3𝐣) − (a𝐢 + 𝐣) = (−a − 1)𝐢 + 2𝐣",
            "a + 1 + 3 × 2 = ½(a(a + 1) − 2)",
            "a = (1 + √65)/2 ≈ 4.53 or a = (1 − √65)/2 ≈ −3.53",
        ),
    ),
    "from a velocity in a letter, of two spheres": (
        """
sphere A: mass m, velocity 3i + k j
sphere B: mass 2m, velocity -i
A hits B: e = 1/3
given velocity(A) = i + j
find k
""",
        (
            "the line of centres is parallel to (3𝐢 + k𝐣) − (𝐢 + 𝐣) = 2𝐢 + (k − 1)𝐣",
            "−2 + ((k − 1)/2 − 1)(k − 1) = ⅓(2(3 + 1) + k(k − 1))",
            "k = 5 + 2√11 ≈ 11.6 or k = 5 − 2√11 ≈ −1.63",
        ),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_change_tells_what_is_after_it(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text
