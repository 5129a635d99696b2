"""Velocities at an impact that all others determine: by momentum as vectors, at once."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

# Statement, what its working says, and what it does not.
SAYS = {
    # A loses 3(2𝐢 + 4𝐣), which is what B gains: 2(3𝐢 + 6𝐣).
    "components that are asked": (
        """
        sphere A: mass 3, velocity 5i + 6j
        sphere B: mass 2, velocity p i + q j
        A hits B
        given velocity(A) = 3i + 2j, velocity(B) = 4i + 7j
        find p, q
        """,
        ["3(5𝐢 + 6𝐣) + 2(p𝐢 + q𝐣) = 3(3𝐢 + 2𝐣) + 2(4𝐢 + 7𝐣)", "p = 1", "q = 1"],
        ["line of centres", "·"],
    ),
    "a velocity of which nothing is said": (
        """
        sphere A: mass m
        sphere B: mass 3m, velocity -2u i
        A hits B
        given velocity(A) = u i - 4u j, velocity(B) = -u i + 2u j
        find velocity(A, 0)
        """,
        ["m(a𝐢 + b𝐣) − 3m × 2u𝐢 = m(u𝐢 − 4u𝐣) + 3m(−u𝐢 + 2u𝐣)", "𝐮_A = 4u𝐢 + 2u𝐣"],
        ["·"],
    ),
    # 2(4𝐢 − 𝐣) − 2(𝐢 + 2𝐣) = 3(2𝐢 − 2𝐣), which B gains.
    "components of a velocity after the impact": (
        """
        sphere A: mass 2, velocity 4i - j
        sphere B: mass 3, velocity -i + j
        A hits B
        given velocity(A) = i + 2j, velocity(B) = x i + y j
        find x, y
        """,
        ["2(4𝐢 − 𝐣) + 3(−𝐢 + 𝐣) = 2(𝐢 + 2𝐣) + 3(x𝐢 + y𝐣)", "x = 1", "y = −1"],
        ["line of centres", "·"],
    ),
    # What A loses is what B has, who was at rest.
    "a velocity from rest beside one that is given": (
        """
        sphere A: mass 2, velocity 5i + 3j
        sphere B: mass 1, at rest
        A hits B
        given velocity(A) = 3i + j
        find velocity(B)
        """,
        ["2(5𝐢 + 3𝐣) = 2(3𝐢 + 𝐣) + 𝐯_B", "𝐯_B = (4𝐢 + 4𝐣) m s⁻¹"],
        ["line of centres", "·"],
    ),
    "a speed and a deflection beside a velocity that is given": (
        """
        sphere A: mass 2, velocity 5i + 3j
        sphere B: mass 1, velocity i - j
        A hits B
        given velocity(A) = 3i + j
        find speed(B), deflection(B)
        """,
        ["2(5𝐢 + 3𝐣) + (𝐢 − 𝐣) = 2(3𝐢 + 𝐣) + 𝐯_B", "√(5² + 3²) = √34"],
        ["line of centres", "𝐧"],
    ),
    # The component across the line is seen to stay there.
    "a line of centres along an axis": (
        """
        sphere A: mass 3, velocity 5i + 6j
        sphere B: mass 2, velocity p i + q j
        A hits B: along i
        given velocity(A) = -i + 6j, velocity(B) = 4i - 2j
        find p, q
        """,
        ["q = −2", "p = −5"],
        ["(p𝐢 + q𝐣)"],
    ),
}


@pytest.mark.parametrize("case", SAYS)
def test_a_velocity_comes_by_momentum_as_vectors(case: str) -> None:
    statement, says, never = SAYS[case]
    working = explain(solve(parse(statement)), marks="none", check=True)
    text = " ".join(to_text(working).split())
    assert not any("follow" in warning for warning in working.warnings)
    for piece in says:
        assert piece in text, text
    for piece in never:
        assert piece not in text
