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
            "− 30° > 30°",
            "> 60°",
            "= √3(2 − k)/(2(1 + k))",
            "√3(2 − k)/(2(1 + k)) < √3/3",
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
    "a deflection beside an angle in degrees": (
        """
sphere A: mass m, velocity u at 60°
sphere B: mass m, at rest
A hits B: along i
given deflection(A) < 20°
find range of e
""",
        (
            "β − 60° < 20°",
            "β < 80°",
            "tan β < tan 80°, as 0° ≤ β ≤ 90°",
            "2√3/(1 − e) < tan 80°",
            "0 ≤ e < 0.389, as e cannot be negative, to 3 s.f.",
        ),
    ),
    "a deflection at a wall beside an angle in degrees": (
        """
wall W: along i
sphere P: velocity u at 50° to W
P hits W
given deflection(P) > 70°
find range of e
""",
        ("β > 20°", "e tan 50° > tan 20°", "0.305 < e ≤ 1, as e cannot exceed 1, to 3 s.f."),
    ),
    "a deflection at a wall beside an angle by components": (
        """
wall W: along i
sphere P: velocity 3i - 4j
P hits W
given deflection(P) > 70°
find range of e
""",
        (
            "θ > 70° − 53.13°",
            "tan θ > tan 16.87°, as 0° ≤ θ ≤ 90°",
            "4e/3 > 0.3032",
            "0.227 < e ≤ 1, as e cannot exceed 1, to 3 s.f.",
        ),
    ),
    "a deflection of a sphere beside an angle by components": (
        """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 1, at rest
A hits B: along i
given deflection(A) <= 15°
find range of e
""",
        ("β ≤ 15° + 53.13°", "4/(2 − e) ≤ 2.491", "0 ≤ e ≤ 0.394, as e cannot be negative"),
    ),
    "a deflection at a wall beside an angle of a given tangent": (
        """
wall W: along i
sphere P: velocity u at alpha to W
given tan(alpha) = 2
P hits W
given deflection(P) > 80°
find range of e
""",
        ("β > 80° − 63.43°", "2e > 0.2974", "0.149 < e ≤ 1"),
    ),
    "an obtuse deflection": (
        """
sphere A: mass 2, velocity 4i + j
sphere B: mass 3, velocity -i + 2j
A hits B: along i
given deflection(A) > 130°
find range of e
""",
        ("> 130° + 14.04°", "= 1 − 3e", "< cot 144.0°", "1 − 3e < −1.378", "0.793 < e ≤ 1"),
    ),
    "an angle to an axis, after a slanting wall": (
        """
wall W: along 4i + 3j
sphere P: velocity i + 6j
P hits W
given angle(velocity(P), j) > 90°
find range of e
""",
        ("−(21e/5) × ⅘ + (22/5) × ⅗ < 0", "66 − 84e < 0", "11/14 < e ≤ 1"),
    ),
    "an angle that may be obtuse": (
        """
sphere A: mass m, velocity u at 30°
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
given angle(velocity(A), i) > 60°
find range of k
""",
        ("cot β < √3/3, as 60° < β ≤ 180°", "√3(2 − k)/(2(1 + k)) < √3/3", "k > ⅘, as 1 + k > 0"),
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
    "a deflection of which an earlier part has the tangent": (
        """
sphere A: mass 3m, velocity 4u i
sphere B: mass 2m, velocity 5u j
A hits B: along i
part a
find deflection(B)
part b
given deflection(B) >= 40°
find range of e
""",
        ("tan δ ≥ tan 40°, as δ ≥ 40°", "12(1 + e)/25 ≥ tan 40°", "0.748 ≤ e ≤ 1"),
    ),
    "an angle to a wall of which an earlier part has the tangent": (
        """
wall W: along i
sphere P: mass m, velocity u(2i - j)
P hits W
part a
find angle(velocity(P), W)
part b
given angle(velocity(P), W) < 15°
find range of e
""",
        ("tan β < 2 − √3, as β < 15°", "e/2 < 2 − √3", "≈ 0.536"),
    ),
    "a speed of who is given to go back": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, velocity -3u i
A hits B: along i, e = 2/3
given speed(A) > u, velocity(A) in the direction of -i
find range of k
""",
        (
            "A moves in the direction of −𝐢, so v < 0",
            "speed of A = (17k − 3)u/(3(1 + k)), as k > 3/17",
            "(17k − 3)u/(3(1 + k)) > u",
            "k > 3/7, as 1 + k > 0",
        ),
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
    "a deflection at a second wall, at right angles to the first": (
        """
wall AB: along i
wall BC: along j
sphere P: velocity u at alpha to AB
P hits AB: e = 1/2
P hits BC: e = 1/4
given deflection(P) < 120°
find range of tan(alpha)
""",
        (
            "δ = β + θ",
            "cot δ = (1 − tan β tan θ)/(tan β + tan θ)",
            "cot δ > −√3/3, as 0° ≤ δ < 120°",
            "2(tan²α − 1)/(5 tan α) > −√3/3",
            "tan α > (√219 − 5√3)/12",
        ),
    ),
    "a deflection at a second wall that slants": (
        """
point B: (0, 0)
wall AB: from (-9a, 0) to (0, 0)
wall BC: from (0, 0) to (9a, 9a)
sphere P: at (-2a, a), velocity u at alpha to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
given deflection(P) > 45°
find range of tan(alpha)
""",
        (
            "= (4 + 12 tan α + tan²α)/(3(4 − tan²α))",
            "P moves towards BC before the second impact",
            "tan α < 2, as α is acute",
            "tan²α + 3 tan α − 2 < 0, as α is acute",
            "½ < tan α < (√17 − 3)/2",
        ),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_an_angle_that_is_bounded_bounds_letters(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text


def test_the_angle_to_a_wall_that_is_hit_from_an_open_side_has_the_size_of_a_component() -> None:
    problem, derivation = planned("""
wall AB: along i
wall BC: along 60°
sphere P: velocity u at alpha to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
find tan(angle(velocity(P), BC))
""")
    text = to_text(explanation_of(derivation, problem), 120)
    assert "tan β = |u(sin α − 2√3 cos α)/8|/(u(2 cos α + √3 sin α)/4)" in text, text
    assert "= |2√3 − tan α|/(2(2 + √3 tan α))" in text, text
