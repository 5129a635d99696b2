"""Bounds of a deflection, or of a direction, that are given: by the cotangent, which falls.

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
    "a deflection that may be obtuse": (
        """
sphere A: mass m, velocity u at 30°
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
given deflection(A) > 30°
find range of k
""",
        (
            "Cotangent of the angle between two velocities = their scalar product ÷ size of their",
            "cot δ < √3, as 30° < δ ≤ 180°",
            "k > ⅘",
        ),
    ),
    "a scalar product that is negative": (
        """
sphere A: mass m, velocity u (cos(alpha) i + sin(alpha) j)
sphere B: mass k m, at rest
A hits B: along i, e = 2/3
given tan(alpha) = 1/3
given dot(velocity(A), velocity(A, 0)) < 0
find range of k
""",
        ("(√10 u/10)(√10 u/10) < 0", "2 − k < 0, as 1 + k > 0", "k > 2"),
    ),
    "a scalar product at a wall": (
        """
wall W: along i
sphere P: mass m, velocity 3u i - 4u j
P hits W
given dot(velocity(P), velocity(P, 0)) > 0
find range of e
""",
        ("3u × 3u − 4eu × 4u > 0", "9 − 16e > 0", "0 ≤ e < 9/16"),
    ),
    "a scalar product of two spheres": (
        """
sphere A: mass 2m, velocity 3u i + u j
sphere B: mass 3m, velocity -u i + 3u j
A hits B: along i
given dot(velocity(A), velocity(B)) < 3u^2
find range of e
""",
        ("(3(1 − 4e)u/5)((3 + 8e)u/5) + u × 3u < 3u²", "e > ¼"),
    ),
    "a scalar product with a vector": (
        """
wall W: along i + 2j
sphere P: mass m, velocity 4i - 3j
P hits W
given dot(velocity(P), 3i + j) <= -7
find range of e
""",
        ("−(2(1 + 11e)/5) × 3 + (11e − 4)/5 ≤ −7", "5/11 ≤ e ≤ 1"),
    ),
    "a direction": (
        """
sphere A: mass 1, velocity 4i + 3j
sphere B: mass k, at rest
A hits B: along i, e = 1/2
given direction(A) > 60°
find range of k
""",
        ("cot θ = 2(2 − k)/(3(1 + k))", "0° < θ < 180°", "cot θ < √3/3, as θ > 60°"),
    ),
    "a direction on either side of a right angle": (
        """
sphere P: mass M, velocity u at 45°
sphere Q: mass m, at rest
P hits Q: along i, e = 2/3
given direction(P) > 60°, direction(P) < 120°
find range of M/m
""",
        ("cot θ < √3/3, as θ > 60°", "cot θ > −√3/3, as θ < 120°"),
    ),
    "a direction below": (
        """
sphere P: mass 3, velocity 4i - 2j
sphere Q: mass M, at rest
P hits Q: along i, e = 1/2
given direction(P) < -45°
find range of M
""",
        ("−180° < θ < 0°", "cot θ > −1, as θ < −45°"),
    ),
    "a tangent of which the divisor may have either sign": (
        """
wall W: along i
sphere P: velocity k i - j
P hits W: e = 1/2
given deflection(P) < 60°, k > 0
find range of k
""",
        ("(2k² − 1)/(3k) > √3/3", "2k² − √3 k − 1 > 0", "k > (√3 + √11)/4"),
    ),
    "a letter for an angle that may be right": (
        """
sphere P: mass M, velocity w at beta
sphere Q: mass M, at rest
P hits Q: along i
let psi = angle(velocity(P), velocity(Q))
show psi > beta
""",
        ("cot ψ = ½(1 − e)w cos β/(w sin β)", "cot ψ < 1/tan β", "ψ > β"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_an_angle_that_is_bounded_bounds_letters(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text
