"""Paths at twice an angle to a wall: ratios of 2θ come of those of θ, and so do deflections.

Each working is followed line by line.
"""

from __future__ import annotations

import pytest
from workings import printed_with

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

CASES = {
    "the tangent of the angle afterwards tells the components before": (
        """
wall W: along i
sphere P: mass m, velocity u at 2theta to W
P hits W: e = 4/9
given angle(velocity(P), W) = theta
part a
find tan(theta)
part b
find speed(P) in terms of u
part c
find impulse
""",
        (
            "tan θ = ⅓, as θ is acute (3)",
            "sin θ = √10/10 cos θ = 3√10/10",
            "sin 2θ = 2 sin θ cos θ = 2(√10/10) × (3√10/10) = ⅗",
            "cos 2θ = cos²θ − sin²θ = (3√10/10)² − (√10/10)² = ⅘",
            "√((4u/15)² + (4u/5)²) = 4√10 u/15",
            "m(4u/15 + 3u/5) = 13mu/15",
        ),
    ),
    "the supplement of twice an angle": (
        """
sphere A: mass m, velocity 2u at alpha
sphere B: mass 3m, velocity 3u at 180° - 2 alpha
A hits B: along i, e = 1/3
given tan(alpha) = 1/2
find velocity(A)
""",
        (
            "cos 2α = cos²α − sin²α = (2√5/5)² − (√5/5)² = ⅗",
            "m(4√5 u/5) − 3m(9u/5) = mv + 3mw",
            "𝐯_A = −(9u/5)𝐢 + (2√5 u/5)𝐣",
        ),
    ),
    "half of the angle before, beside a coefficient in letters": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = e
given angle(velocity(P), W) = 1/2 alpha
find alpha, tan(alpha)
""",
        (
            "t = (e × 2t)/(1 − t²)",
            "1 − t² = 2e t = √(1 − 2e), as α is acute",
            "tan α = √(1 − 2e)/e",
            "α = 2 arctan(√(1 − 2e))",
        ),
    ),
    "twice the angle before, beside a mass in letters": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i, e = 1
given angle(velocity(A), i) = 2 alpha
find tan(alpha)
""",
        (
            "2 tan α/(1 − tan²α) = ((1 + k)/(1 − k)) tan α",
            "Dividing by tan α, which is not zero as α is acute: 1 − tan²α = 2(1 − k)/(1 + k)",
        ),
    ),
    "a deflection less the angle before is the angle afterwards": (
        """
wall W: along j
sphere B: mass m, velocity 10 at 2beta to W
B hits W: e = 3/8
given deflection(B) = 3 beta
find cos(2 beta), speed(B)
""",
        (
            "θ = 3β − 2β = β",
            "tan β = ((15/4) sin 2β)/(10 cos 2β)",
            "cos 2β = cos²β − sin²β = (2√5/5)² − (√5/5)² = ⅗",
            "speed of B = √(3² + 6²) = 3√5",
        ),
    ),
    "a deflection is the sum of both angles": (
        """
wall V: along i
sphere S: mass m, velocity u at 2alpha to V
S hits V: e = 1/2
given sin(alpha) = 1/3
find deflection(S)
""",
        (
            "sin 2α = 2 sin α cos α = 2 × ⅓ × (2√2/3) = 4√2/9",
            "cos 2α = cos²α − sin²α = (2√2/3)² − (1/3)² = 7/9",
            "δ = 2α + β = 2 arcsin(1/3) + arctan(2√2/7)",
            "60.9°",
        ),
    ),
    "the tangent of a deflection stays in that of twice the angle": (
        """
wall V: along j
sphere S: velocity u at 2phi to V
S hits V: e = 1/3
find tan(deflection(S)) in terms of phi
""",
        (
            "tan β = (⅓u sin 2φ)/(u cos 2φ) = ⅓ tan 2φ",
            "δ = 2φ + β",
            "tan δ = (tan 2φ + tan β)/(1 − tan 2φ tan β)",
            "= (4 tan 2φ)/(3 − tan² 2φ)",
        ),
    ),
    "a deflection that leaves the complement of twice an angle": (
        """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 3/8
given deflection(P) = 90° - alpha
find alpha
""",
        (
            "β = 90° − α − α = 90° − 2α",
            "tan(90° − 2α) = ⅜u sin α/(u cos α)",
            "1/tan 2α = ⅜u sin α/(u cos α)",
            "tan α tan 2α = 8/3",
            "(tan α)(2 tan α/(1 − tan²α)) = 8/3",
            "tan²α = 4/7",
        ),
    ),
    "a complement of an angle afterwards, of a path at twice the angle": (
        """
wall W: along j
sphere P: velocity u at 2theta to W
P hits W: e = 1/2
given deflection(P) = 90° + theta
find theta
""",
        ("β = 90° + θ − 2θ = 90° − θ", "tan θ tan 2θ = 2", "tan²θ = ½"),
    ),
    "a cosine of a deflection at a wall along an axis": (
        """
wall W: along j
sphere P: mass m, velocity u at alpha to W
P hits W
given cos(alpha) = 3/5, cos(deflection(P)) = 1/sqrt(5)
find e
""",
        ("= (9 − 16e)/(5√(9 + 16e²))", "e = 3/22"),
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_no_inverse_stands_in_a_ratio(case: str) -> None:
    statement, parts = CASES[case]
    text = printed_with(statement, parts)
    assert "sin(2 arc" not in text


@pytest.mark.parametrize(
    ("given", "lines"),
    [
        ("sin(alpha/2) = 3/5", ("cos α = 1 − 2 sin²(α/2) = 1 − 2(3/5)² = 7/25", "sin α = 24/25")),
        ("cos(alpha/2) = 4/5", ("cos α = 2 cos²(α/2) − 1 = 2(4/5)² − 1 = 7/25", "sin α = 24/25")),
        ("tan(1/2 alpha) = 3/4", ("tan α = 2 tan(½α)/(1 − tan²(½α))", "= 24/7", "sin α = 24/25")),
    ],
)
def test_a_ratio_of_half_an_angle_of_the_data(given: str, lines: tuple[str, ...]) -> None:
    """P leaves at 7u/25 along the wall and 8u/25 from it."""
    wall = f"""
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/3
given {given}
"""
    printed_with(f"{wall}find velocity(P)\n", (*lines, "𝐯_P = (7u/25)𝐢 + (8u/25)𝐣"))
    printed_with(f"{wall}find alpha\n", (lines[0], "α = arc"))
    printed_with(f"{wall}find deflection(P)\n", (lines[0], "+ arctan(8/7)", "≈ 123°"))


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (
            (
                "sphere A: mass 4m, velocity 3u at alpha\n"
                "sphere B: mass 2m, velocity 3u at -2 alpha\n"
                "A hits B: along j, e = 0.25\nfind energy(A)"
            ),
            (
                "4m × 3u sin α − 2m(3u × 2 sin α cos α) = 4mv + 2mw (3)",
                "v = 0.25u(7 − 10 cos α) sin α",
            ),
        ),
        (
            (
                "sphere A: mass m, velocity 2u at theta\n"
                "sphere B: mass m, velocity u at 180° - 2 theta\nA hits B: along i, e = 1/2\n"
                "find speed(B)"
            ),
            ("w − v = ½(2u cos θ + u(1 − 2 sin²θ)) (4)", "Eliminating v from (3) and (4)"),
        ),
    ],
)
def test_the_laws_with_an_angle_and_its_double_are_in_the_angle_first(
    text: str, says: tuple[str, ...]
) -> None:
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation, 120).split())
    assert explanation.followed
    assert "From (1) and (2), by the formulae for the double angle:" in shown
    for line in says:
        assert line in shown
