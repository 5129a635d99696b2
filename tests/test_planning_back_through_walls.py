"""Walls that slant, gone through from the end: the velocity behind the last of them is given."""

from __future__ import annotations

import pytest
from workings import planned

from restitution.workings import to_text
from restitution.workings.derived import explanation_of

# A statement, what its working says, and the answers at its end.
CASES = {
    "two that slant": (
        """
wall W: along i + 3j
wall X: along 2i - j
sphere P: mass 1, velocity a i + b j
P hits W: e = 1/2
P hits X: e = 1/3
given velocity(P) = 2i + 4j
find a, b, velocity(P, 1)
""",
        (
            "2√5 = −⅓(𝐯₁ · 𝐧₂)",
            "𝐯₁ = −6√5((𝐢 + 2𝐣)/√5)",
            "𝐯₁ · 𝐧₁ = (−3 × 6 + 12)/√10",
            "−3√10/5 = −½(𝐮 · 𝐧₁)",
            "a𝐢 + b𝐣 = −⅗𝐢 − (69/5)𝐣",
            "b = −69/5 = −13.8",
        ),
    ),
    "one along an axis": (
        """
wall W: along i + 2j
wall X: along j
sphere P: velocity a i + b j
P hits W: e = 1/2
P hits X: e = 1/3
given velocity(P) = 3i - j
find a, b
""",
        (
            "It is given that 𝐯₂ = (3𝐢 − 𝐣) m s⁻¹.",
            "𝐯₁ = (−9𝐢 − 𝐣) m s⁻¹",
            "−17√5/5 = −½(𝐮 · 𝐧)",
            "a = 57/5 = 11.4",
        ),
    ),
    "one wall twice": (
        """
wall W: along i + j
wall X: along j
sphere P: mass 2, velocity p i + q j
P hits W: e = 1/2
P hits X: e = 2/3
P hits W: e = 1/2
given velocity(P) = 2i + 3j
find p, q, impulse(P, 2)
""",
        ("√2/2 = −½(𝐯₂ · 𝐧₃)", "p𝐢 + q𝐣 = (39/8)𝐢 − (69/8)𝐣", "= (35/2)𝐢 N s"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_velocity_before_each_wall_comes_of_the_one_after_it(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text
