"""Lines of centres that another direction tells: that of an impulse, or of a velocity found first.

Each working is followed line by line, its answers are those of the solver, and it says what a
teacher says.
"""

from __future__ import annotations

import pytest
from workings import planned

from restitution.workings import to_text
from restitution.workings.derived import explanation_of

# A statement, and lines of its working, or parts of them.
CASES = {
    "the impulse on the second sphere": (
        """
sphere A: mass 2, velocity 4i
sphere B: mass M, at rest
A hits B: e = 1
given angle(impulse(B), i) = 30°, deflection(A) = 60°
find M, speed(A), speed(B)
""",
        ("angle between the line of centres and 𝐢 = 30°", "M = 2", "speed of A = 2 m s⁻¹"),
    ),
    "the impulse on the first sphere": (
        """
sphere A: mass 3, velocity 5i
sphere B: mass 2, velocity -2i
A hits B: e = 1/2
given angle(i, impulse(A)) = 120°
find speed(A), impulse
""",
        ("line of centres and 𝐢 = 180° − 120° = 60°", "impulse = 3(5/2 − ⅖) = 63/10"),
    ),
    "parallel to who was struck before": (
        """
sphere A: mass 2m, velocity 6u i
sphere B: mass m, at rest
sphere C: mass 3m, at rest
A hits B: along 60°, e = 1/2
B hits C: e = 1/2
given velocity(C) parallel to velocity(A)
find line_of_centres, speed(C), velocity(B)
""",
        (
            "= (21u/4)𝐢 − (3√3 u/4)𝐣",
            "C was at rest, so it moves off along the line of centres",
            "parallel to 7𝐢 − √3 𝐣",
            "speed of C = 9√13 u/104",
        ),
    ),
    "perpendicular to who was struck before": (
        """
sphere A: mass 2, velocity 3i + 2j
sphere B: mass 4, velocity -i
sphere C: mass 1, at rest
A hits B: along i, e = 1/3
A hits C: e = 1/2
given velocity(C) perpendicular to velocity(B)
find velocity(A), velocity(C)
""",
        (
            "C was at rest, so it moves off along the line of centres",
            "perpendicular to 𝐢",
            "𝐯_A = (−(5/9)𝐢 + 𝐣) m s⁻¹",
        ),
    ),
    "perpendicular to a direction of the data": (
        """
sphere A: mass 2, velocity 5i
sphere B: mass 1, at rest
A hits B: e = 1/2
given velocity(B) perpendicular to 4i - 3j
find velocity(A), velocity(B)
""",
        ("B was at rest, so it moves off along the line of centres", "parallel to 3𝐢 + 4𝐣"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_line_of_centres_is_worked_out(name: str) -> None:
    """The working says which line it is, and comes to the answers."""
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    for line in lines:
        assert line in text, f"{line}\n{text}"
