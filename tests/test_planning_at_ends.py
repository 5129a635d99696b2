"""Bounds at the ends of a letter: of angles that are sums of inverse tangents, and by facts.

Each working is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

import math

import pytest
from workings import planned

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

# A statement, and lines of its working, or parts of them.
CASES = {
    "of a coefficient by its square, at its own end": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given energy_lost = 1/3 energy(0)
find minimum of e over k
""",
        ("e = √((2k − 1)/(3k)), as e ≥ 0", "least value of e = 0, when k = ½"),
    ),
    "of a coefficient by the root of a mass": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given energy(B) = 1/4 energy(0)
find maximum of e over k
""",
        ("e ≤ 1", "greatest value of e = 1, when k = 7 − 4√3 or k = 7 + 4√3"),
    ),
    "of a coefficient that is at most 1 anyway": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given impulse = m u
find maximum of e over k
""",
        ("1 = ek", "e = 1/k", "greatest value of e = 1, when k = 1"),
    ),
    "of an angle of which an equation has the square of the cosine": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = e
given energy_lost = 3/32 m u^2
find maximum of alpha over e
""",
        ("cos²α ≥ ⅜, as e² ≥ 0", "α ≤ arccos(√6/4)", "arccos(√6/4) ≈ 52.2°, when e = 0"),
    ),
    "of an angle of which an equation has the square of the sine": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given energy_lost = 1/3 m u^2
find minimum of alpha over e
""",
        ("sin²α ≥ ⅔, as e² ≥ 0", "least value of α = arcsin(√6/3) ≈ 54.7°, when e = 0"),
    ),
    "at the end of e, and then of the angle": (
        """
wall W: along i
sphere P: velocity u at theta to W
P hits W
given theta < 20°
show deflection(P) < 40°
""",
        ("δ ≤ 2θ", "as θ + arctan(e tan θ) increases with e", "δ < 40°, as θ < 20°"),
    ),
    "at the least e, and then of the angle": (
        """
wall W: along j
sphere P: velocity 5 at beta to W
P hits W
given beta >= 35°
show deflection(P) >= 35°
""",
        ("δ = β + θ", "δ ≥ 35°, as 0° ≤ θ ≤ 90° and β ≥ 35°"),
    ),
    "a deflection at a slanting wall by the angle after": (
        """
wall W: along i - j
sphere P: velocity 3u i
P hits W
find range of deflection(P)
""",
        (
            "δ = 45° + θ = 45° + arctan e",
            "45° ≤ δ ≤ 90°, as 45° + arctan e increases with e and 0 ≤ e ≤ 1",
        ),
    ),
    "a deflection at spheres by the one angle that is not given": (
        """
sphere A: mass m, velocity u at 60°
sphere B: mass m, velocity u at 60° from -i
A hits B: along i
given 1/4 <= e <= 1/2
find range of deflection(A)
""",
        (
            "δ = 180° − 60° − β",
            "= 120° − arctan(√3/e)",
            "as 120° − arctan(√3/e) increases with e and ¼ ≤ e ≤ ½",
            "38.2° ≤ δ ≤ 46.1°",
        ),
    ),
    "a deflection between the ends of e that facts leave": (
        """
wall W: along 3i + 4j
sphere P: mass 0.4, velocity 10i
P hits W
given energy_lost <= 30% of energy(0), energy_lost >= 10% of energy(0)
find range of e
find range of deflection(P)
find maximum of impulse over e
""",
        (
            "arctan(4/3) + arctan(√34/6) ≤ δ ≤ arctan(4/3) + arctan(√6/2)",
            "as arctan(4/3) + arctan(4e/3) increases with e",
            "97.3° ≤ δ ≤ 104°",
            "6.14 N s, when e = 3√6/8",
        ),
    ),
    "a range of e that is not asked": (
        """
wall W: along i
sphere P: velocity u at 60° to W
P hits W
given energy_lost <= 1/4 energy(0)
find range of deflection(P)
""",
        ("√6/3 ≤ e ≤ 1", "60° + arctan(√2) ≤ δ ≤ 120°", "115° ≤ δ ≤ 120°"),
    ),
    "a least speed under a condition": (
        """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 4, at rest
A hits B: along i
given energy_lost <= 2
find minimum of speed(B) over e
""",
        ("√6/3 ≤ e ≤ 1", "speed of B = (3 + √6)/3 ≈ 1.82 m s⁻¹, when e = √6/3"),
    ),
    "a deflection with the angle of a wall": (
        """
wall W: along phi
sphere P: mass m, velocity u i
P hits W
show deflection(P) <= 2 phi
find maximum of deflection(P) over e
""",
        ("≤ 2φ", "greatest value of δ = 2φ, when e = 1"),
    ),
    "a quantity compared with another by what that is worth": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, velocity u at 90°
A hits B: along i
find maximum of energy(B) - energy(B, 0) over k
show energy(A) <= energy(A, 0)
show energy(B) - energy(B, 0) < energy(A, 0)
""",
        ("(1 + e)(2 + k − ek)kmu² cos²α/(2(1 + k)²)", "≤ ½mu² cos²α", "< ½mu², as α is acute"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_it_is_bounded_at_the_ends(name: str) -> None:
    """The working has the bounds, and what shows them."""
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    for line in lines:
        assert line in text, f"{line}\n{text}"


def test_the_ends_of_a_deflection_are_those_of_a_protractor() -> None:
    """The path makes arctan(8/6) with the wall before, and arctan(8e/6) after."""
    ends = [math.degrees(math.atan2(8, 6) + math.atan2(8 * e, 6)) for e in _ENDS_OF_E]
    assert [round(each, 1) for each in ends] == [97.3, 103.9]


# Of 10 m/s the component across is 8, and a loss of 20 × 0.64(1 − e²) J is from 2 to 6.
_ENDS_OF_E = [math.sqrt(1 - loss / 12.8) for loss in (6, 2)]


@pytest.mark.parametrize(
    ("part", "square", "bound"),
    [("1/4", "(3k − 1)/(4k)", "√3/2"), ("1/3", "(2k − 1)/(3k)", "√6/3")],
)
def test_a_coefficient_by_its_square_comes_to_a_bound(part: str, square: str, bound: str) -> None:
    solution = solve(
        parse(
            "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"
            f"given energy_lost = {part} energy(0)\nfind maximum of e over k"
        )
    )
    text = " ".join(to_text(explain(solution, check=True)).split())
    for line in (f"e² = {square}", f"e < {bound}", f"e → {bound}", "there is no greatest value"):
        assert line in text
