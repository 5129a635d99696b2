"""Walls as examination questions have them: what a working says of them, and what it does not.

Each working is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

import pytest
import sympy as sp
from workings import planned, solved

from restitution.workings import to_text
from restitution.workings.derived import explanation_of

# A statement, what its working says (lines, or parts of them), and what it does not.
CASES = {
    "three walls of a table: the angle that is to be shown is the unknown of the last equation": (
        """
point M: (a/2, 0)
wall BC: from (a, 0) to (a, b)
wall CD: from (a, b) to (0, b)
wall DA: from (0, b) to (0, 0)
sphere P: at M, velocity u at theta
P hits BC
P hits CD
P hits DA
P reaches M
show tan(theta) = 2 b e/(a(1+e))
""",
        (
            "2(1 + e)eb − (2 + e)ea tan θ = a tan θ",
            "tan θ = 2be/(a(1 + e))   (as required)",
        ),
        ("e + 1", "= 0"),
    ),
    "a number for a letter in a tangent that was shown goes into that first": (
        """
point D: (0, a)
wall BC: from (2a, 0) to (2a, a)
sphere P: at (0, 0), velocity u at theta
P hits BC
P reaches D
part a
show tan(theta) = e/(2(1+e))
part b
find range of tan(theta)
part c
given e = 3/5
find time(2)
""",
        (
            "e − 2e tan θ = 2 tan θ",
            "tan θ = e/(2(1 + e))   (as required)   (2)",
            "Since e = ⅗, from (2):\n    tan θ = 3/16\n    sin θ = 3/√265",
            "t = a/(3u/√265) = √265 a/(3u)",
        ),
        ("√(4 + 8e + 5e²)",),
    ),
    "a component away from a wall is positive as a decimal too": (
        """
wall OA: along i
wall OB: along 50°
sphere P: mass m, velocity u at alpha from -i
P hits OA: e = 1/2
given tan(alpha) = 2/tan(50°)
P hits OB: e = 1/3
find speed(P) in terms of u, alpha
""",
        ("= u/((3 cos 50°)√(4 + tan² 50°))", "≈ 0.2227u", "≈ 0.223u"),
        ("≈ −0.2227u",),
    ),
    "a wall that is struck at right angles takes the speed": (
        """
wall OA: along i
wall OB: along theta
sphere P: velocity u at alpha from -i
P hits OA
P hits OB: e = e
given velocity(P, 1) perpendicular to OB
show tan(alpha) tan(theta) = 1/e
find speed(P) in terms of u, e, alpha
""",
        (
            "P strikes OB at right angles, so its component before the impact is its speed:",
            "component of 𝐯₁ towards OB = u√(cos²α + e² sin²α)",
            "speed of P after the second impact = eu√(cos²α + e² sin²α)",
        ),
        ("sin θ =", "scalar product is zero:\n     𝐯₁ · 𝐭"),
    ),
    "an angle in degrees goes into the ratio that another part has for it": (
        """
wall W: along i
sphere S: mass m, velocity u at alpha to W
S hits W
given impulse = m u
part a
find sin(alpha) in terms of e
part b
given alpha = 45°
find e
""",
        ("√2/2 = 1/(1 + e)\n    1 + e = √2\n        e = √2 − 1",),
        ("arcsin", "π"),
    ),
    "no formula joins the degrees of two angles: their sum has its decimal": (
        """
wall W: along i
sphere B: mass 0.16, velocity 5 at 40° to W
B hits W
given deflection(B) = 70°
find e, impulse
""",
        ("magnitude of the impulse = 0.16((5√3/3) cos 40° + 5 sin 40°)", "≈ 0.868 N s"),
        ("cos 20°",),
    ),
    "a place that is given at a wall closes for the angle of projection": (
        """
wall S: from (2a, 0) to (2a, 2a)
wall L: from (2a, 2a) to (-2a, 2a)
sphere P: at (0, 0), velocity u at alpha
P hits S: e = 2/3
P hits L
given position(P, 2) = (0, 2a)
find tan(alpha), time(2)
""",
        ("2a(5 tan α − 2)/(3 tan α) = 0", "tan α = ⅖"),
        ("not written out", "arctan"),
    ),
    "a coordinate that is given at a time closes for the time": (
        """
wall W: along i, through (0, 0)
sphere B: at (0, 2), velocity 3i - 4j
B hits W: e = 1/2
given along(position(B, at t), j) = 2
find t
""",
        ("2t − 1 = 2", "t = 3/2"),
        ("not written out",),
    ),
    "the squares of sine and cosine in letters have one denominator": (
        """
wall W1: along i
wall W2: along i
sphere P: velocity u at alpha to W1
P hits W1
P hits W2
P hits W1
given velocity(P) perpendicular to velocity(P, 0)
part a
show tan^2 alpha = 1/e^3
part b
find speed(P)/u in terms of e
""",
        ("sin²α = 1/(1 + e³)\n    cos²α = e³/(1 + e³)", "V/u = e√e"),
        (),
    ),
    "a complement and a double angle have a line each": (
        """
wall W: along j
sphere P: velocity u at 2alpha to W
P hits W
given angle(velocity(P), W) = 90° - alpha
show e = (1 - tan^2 alpha)/(2 tan^2 alpha)
""",
        ("1/tan α = e tan 2α", "1/tan α = e(2 tan α/(1 − tan²α))"),
        (),
    ),
    "a component along a wall is not worked out again below the velocity": (
        """
wall W: along 4i + 3j
sphere B: mass 1/2, velocity 7i - j
B hits W: e = 1/2
find velocity(B), energy_lost
show deflection(B) = arctan 3
""",
        ("stays 5 m s⁻¹.",),
        ("𝐯_B · 𝐭 = (4",),
    ),
    "a deflection in degrees leaves the angle to a wall afterwards, of a velocity by components": (
        """
wall W: along 3i + 4j
sphere P: velocity 5i
P hits W
given deflection(P) = 75°
find e
""",
        ("β ≈ 53.13°", "θ ≈ 75° − 53.13° ≈ 21.87°", "4e/3 ≈ tan 21.87° ≈ 0.4014", "e ≈ 0.301"),
        ("tan 75°", "formula"),
    ),
    "in letters the angle to a wall afterwards has the tangent of a difference": (
        """
wall V: along j
sphere S: velocity 2a i + 3a j
S hits V
given deflection(S) = 60°
find e
""",
        (
            "θ = 60° − β",
            "tan θ = (tan 60° − tan β)/(1 + tan 60° tan β)",
            "tan θ = (√3 − ⅔)/(1 + ⅔√3)",
        ),
        ("tan 60° = (", "2a × 2ea"),
    ),
    "a deflection that is a letter is the sum of the angles to a wall": (
        """
wall W: along i
sphere P: velocity 7i - 5j
P hits W: e = 1/2
given deflection(P) = d
find d
""",
        ("β + θ = d", "tan d = (5/7 + 5/14)/(1 − (5/7) × (5/14)) = 105/73"),
        ("7 × (5/2)",),
    ),
    "the unit vector along a wall has the sense of the wall": (
        """
wall V: along i - 2j
wall W: along -2i - j
sphere Q: velocity 5i + 2j
Q hits V: e = 1/2
Q hits W: e = 1/3
find velocity(Q)
""",
        (
            "𝐭₁ = (𝐢 − 2𝐣)/√5 the one parallel to V",
            "𝐮 · 𝐭₁ = (5 − 2 × 2)/√5 = √5/5 m s⁻¹",
            "stays √5/5 m s⁻¹.",
            "𝐭₂ = (−2𝐢 − 𝐣)/√5 the one\n",
            "𝐯₁ · 𝐭₂ = −𝐯₁ · 𝐧₁ = 6√5/5 m s⁻¹",
            "(6√5/5)((−2𝐢 − 𝐣)/√5)",
        ),
        ("−𝐢 + 2𝐣", "2𝐢 + 𝐣)/√5 the one parallel"),
    ),
    "what stays along a wall is an equation in the sense of the wall": (
        """
wall W: along -4i + 3j
sphere P: velocity 3i - 5j
P hits W
given velocity(P) parallel to i
find speed(P)
""",
        ("𝐯_P · 𝐭 = −4V/5", "−4V/5 = −27/5\n"),
        ("4𝐢 − 3𝐣",),
    ),
    "the sense along a wall that nothing tells is that in which the body goes": (
        """
wall W: along 3i + 4j
sphere P: mass 2
P hits W: e = 0.4
given speed(P) = 10, tan(angle(velocity(P), W)) = 3/4
find speed(P, 0)
""",
        ("stays 10 × 0.8 = 8 m s⁻¹",),
        ("−8",),
    ),
    "a ratio that is given goes into the shortest side": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/k
given tan(alpha) = 2, tan(angle(velocity(P), W)) = 1
find k
""",
        ("1 = (1/k)u sin α/(u cos α) = (tan α)/k", "Since tan α = 2:\n    1 = 2/k\n    k = 2"),
        ("√5",),
    ),
    "speeds of one component each are compared as they are": (
        """
wall W: along i
sphere P: mass m, velocity u at 90° to W
P hits W: e = 1/3
given speed(P, 0) = k speed(P)
find k
""",
        ("k(u/3) = u\n         k = 3",),
        ("k²",),
    ),
    "a letter for a ratio is worked out in one line": (
        """
wall W: along i
sphere P: mass m, velocity -3 j
P hits W: e = 1/2
let k = speed(P, 0)/speed(P)
find k
""",
        ("k = 3/(3/2) = 2",),
        ("Taking the ratio",),
    ),
    "a ratio of tangents comes of one of them": (
        """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 2/3
let beta = angle(velocity(P), W)
find tan(alpha)/tan(beta)
""",
        ("tan β = ⅔u sin α/(u cos α) = ⅔ tan α", "(tan α)/tan β = 3/2"),
        ("arctan",),
    ),
    "the greatest tangent of a difference of two letters": (
        """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/4
let beta = angle(velocity(P), W)
show tan(alpha - beta) = 3 tan(alpha)/(4 + tan^2 alpha)
find maximum of tan(alpha - beta) over alpha
""",
        (
            "Let S = 4/tan α + tan α.",
            "when 2 − tan α = 0, so tan α = 2 and α ≈ 63.4°",
        ),
        ("not written out",),
    ),
    "a path that is turned from the wall by more than 90° makes the acute angle with it": (
        """
wall W: along j
sphere P: mass m, velocity -u at alpha to W
P hits W
find deflection(P)
""",
        ("the component stays −u cos α.", "= α + β = α + arctan(e tan α)"),
        ("not written out",),
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_the_working_says_what_a_teacher_says(case: str) -> None:
    statement, says, leaves_out = CASES[case]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    for line in says:
        assert line in text, f"{line} is not in\n{text}"
    for line in leaves_out:
        assert line not in text, f"{line} is in\n{text}"


def test_a_turn_through_a_multiple_of_an_angle_of_the_motion_fixes_the_coefficient() -> None:
    """Equations that would have a sine and a cosine both zero are no solution."""
    solution = solved(
        """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
let beta = angle(velocity(P), W)
given deflection(P) = 3 beta
find e in terms of beta
"""
    )
    (answer,) = solution["e"].distinct
    b = sp.Symbol("beta")
    for size in (0.3, 0.6):
        worth = sp.N(answer.value.subs(dict.fromkeys(answer.value.free_symbols, size)))
        assert abs(worth - sp.N((sp.tan(b) / sp.tan(2 * b)).subs(b, size))) < 1e-9


def test_the_angle_of_a_path_along_an_axis_with_a_wall_in_letters_is_that_letter() -> None:
    problem, derivation = planned("""
wall W: along theta
sphere P: mass m, velocity u i
P hits W
find tan(deflection(P))
""")
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert "P moves at θ to W." in text
    assert "δ = θ + β" in text
    assert "u sin θ/(u cos θ) = tan θ" not in text.replace("eu sin θ/(u cos θ) = e tan θ", "")
