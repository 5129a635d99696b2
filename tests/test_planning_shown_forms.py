"""What is to be shown ends in the form in which it is asked, and bounds have reasons to be seen.

Each working is followed line by line, its answers are those of the solver, and it says what a
teacher says; what a teacher does not say is not in it.
"""

from __future__ import annotations

import pytest
import sympy as sp
from workings import planned

from restitution.explaining.lines.derivation import Link
from restitution.explaining.lines.notation import read_relation
from restitution.oracle import Role
from restitution.oracle.roles import ACUTE, COEFFICIENT, POSITIVE
from restitution.workings import to_text
from restitution.workings.derived import explanation_of
from restitution.workings.reasons.seen import shown

# A statement, what its working says, and what it does not say: lines, or parts of them.
CASES = {
    "squares of two speeds, added": (
        """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = 1
show speed(A)^2 + speed(B)^2 = u^2
show energy(A) + energy(B) = m u^2/2
""",
        (
            "V_A² + V_B² = (u sin α)² + (u cos α)²",
            "= u², as sin²α + cos²α = 1 (as required)",
            "= ½mu² sin²α + ½mu² cos²α",
        ),
        ("V_A² + V_B² = u²",),
    ),
    "two spheres in turn that are brought to rest": (
        """
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
sphere C: mass 4m, at rest
A hits B: along i, e = 1/2
show A at rest
B hits C: along i, e = 1/2
show B at rest
""",
        ("mu = mv₁ + 2m(v₁ + u/2)", "2m(u/2) = 2mv₂ + 4m(v₂ + u/4)"),
        (),
    ),
    "a ratio of energies by the speed that was shown": (
        """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
let beta = angle(velocity(P), W)
show speed(P) cos(beta) = u cos(alpha)
show energy(P)/energy(P, 0) = cos^2(alpha)/cos^2(beta)
""",
        ("speed of P = (u cos α)/cos β", "= ((u cos α)/cos β)²/u² = (cos²α)/cos²β"),
        ("m_P", "Newton", "tan β"),
    ),
    "a difference that is positive by a letter": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
show energy_lost < 3/8 m u^2
""",
        ("kinetic energy lost < ⅜mu², as k > 0 (as required)",),
        (),
    ),
    "a bound that differs by a square": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
given tan(alpha) = 4/3
A hits B: along i
show energy_lost/energy(0) <= 27/100
""",
        ("fraction lost ≤ 27/100, as e² ≥ 0 (as required)",),
        ("decreases",),
    ),
    "a speed that is positive as the spheres do not pass by": (
        """
sphere A: mass m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset d, e = e
find range of speed(B) in terms of u
""",
        ("A does not pass by B:\n    speed of B > 0, as e ≥ 0",),
        ("increases with u",),
    ),
    "two speeds multiplied, and one with a root squared": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i
show speed(A)^2 + 2 speed(B)^2 = u^2 (1 - 2(1-e^2) cos(alpha)^2/3)
""",
        (
            "= u²((1 − 2e)² cos²α + 9 sin²α)/9 + 2(⅓(1 + e)u cos α)²",
            "as sin²α + cos²α = 1 (as required)",
        ),
        ("V_A² + 2V_B² = u²(1",),
    ),
    "roots below a line, as they were typed": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given e < 1
show tan(deflection(A)) <= (1+e)/(2sqrt(2)sqrt(1-e))
show speed(A) < u
""",
        (
            "tan δ ≤ (1 + e)/(2√2√(1 − e))",
            "u² − (speed of A)² = ¼(1 + e)(3 − e)u² cos²α",
            "speed of A < u, as α is acute and 0 ≤ e ≤ 1",
        ),
        ("√2(1 + e)/(4√(1 − e))",),
    ),
    "an angle to a wall in degrees": (
        """
wall W: along i
sphere P: velocity u at 60° to W
P hits W: e = 1/3
show angle(velocity(P), W) = 30°
""",
        ("tan β = (√3 u/6)/(u/2) = √3/3", "β = 30°   (as required)"),
        ("not written",),
    ),
    "an angle to a wall by that of the approach": (
        """
wall AB: along i
wall BC: along j
sphere P: velocity u at theta to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
show angle(velocity(P), AB) = theta
show angle(velocity(P), BC) = 90° - theta
""",
        ("= tan θ", "β = θ   (as required)", "= 90° − θ   (as required)"),
        ("not written",),
    ),
    "an angle to a line of centres by that of the approach": (
        """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: velocity u at 180° - alpha
A hits B: along i, e = 1
show angle(velocity(A), line_of_centres) = alpha
""",
        ("tan β = u sin α/(u cos α) = tan α", "β = α   (as required)"),
        ("not written",),
    ),
    "a percentage": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
given tan(alpha) = 3/4
A hits B: along i
show energy_lost/energy(0) <= 48%
""",
        ("≤ 48%",),
        ("≤ 0.48",),
    ),
    "a fraction, and then the decimal": (
        """
wall W: along i
sphere P: mass 0.5, velocity 5i - 4j
P hits W: e = 0.6
show speed(P)^2 = 769/25
show speed(P)^2 = 30.76
show tan(direction(P)) = 0.48
""",
        ("= 2.4² + 5² = 769/25 m² s⁻²", "= 30.76 m² s⁻²", "2.4/5 = 0.48"),
        ("2.4² + 5² = 30.76",),
    ),
    "squares worked out before they are put together": (
        """
sphere A: mass m, velocity 4u i + u j
sphere B: mass 3m, velocity -2u i
A hits B: along i
find energy_lost
""",
        ("= mu²(64 − (1 + 18e + 81e²) + 48 − 3(1 − 6e + 9e²))/8",),
        (),
    ),
    "terms over one denominator before they are put together": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i, e = 1/3
find energy_lost
""",
        ("= mu²(9(1 + k)² − (9 − 6k + k²) − 16k)/(18(1 + k)²)",),
        (),
    ),
    "each square by the formula for the double angle": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/2
show speed(P)^2 = (1/8) u^2 (5 + 3cos(2alpha))
""",
        ("(speed of P)² = ⅛u²(1 − cos 2α) + ½u²(1 + cos 2α)",),
        (),
    ),
    "a speed of roots of letters": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given energy(A) = (1/4) energy(A, 0)
given k > 2
find speed(B)
""",
        (),
        (),
    ),
    "an angle by its tangent, no unit behind letters": (
        """
wall W: along i
sphere P: mass 2, velocity 3i - j
sphere Q: velocity w at beta to W
given tan(beta) = 3/4
P hits W: e = 1/2
find impulse
Q hits W: e = 1/3
find speed(Q)^2
show beta < pi/4
""",
        ("3 N s", "< 1 = tan(π/4) and β is acute"),
        ("w² m² s⁻²",),
    ),
    "both sides expanded, before like terms are collected": (
        """
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
sphere C: mass m, at rest
A hits B: along i, e = e
B hits C: along i, e = e
given A and B collide again
show e < (7 - 3 sqrt(5))/2
""",
        ("3 − 6e > 2 + e − e²",),
        (),
    ),
    "sines and cosines collected, before there is a tangent": (
        """
wall OA: along i
wall OB: along 45°
sphere P: velocity u at 180° - alpha to OA
P hits OA: e = e
P hits OB: e = e
given velocity(P) parallel to OA
show tan(alpha) = (1 + e)/(e (1 - e))
""",
        ("(1 − e)e sin α = (1 + e) cos α",),
        (),
    ),
    "a bound of the square of a cosine, by that alone": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = e
given energy_lost < 1/10 * energy(0)
show cos^2(alpha) < 1/(5 (1 - e^2))
""",
        ("5(1 − e²) cos²α − 1 < 0", "cos²α < 1/(5(1 − e²))"),
        ("tan",),
    ),
    "a greatest angle by its sine": (
        """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
show maximum of deflection(A) over alpha = arcsin(1/3)
""",
        ("so δ is acute", "sin δ ≤ ⅓", "greatest value of δ = arcsin(1/3)"),
        ("arctan", "as 0° ≤ δ"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_shown_ends_as_it_is_asked(name: str) -> None:
    statement, said, unsaid = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    for each in said:
        assert each in text, text
    for each in unsaid:
        assert each not in text, text


ROLES: dict[str, Role] = {"e": COEFFICIENT, "alpha": ACUTE, "k": POSITIVE}
e, k = COEFFICIENT.symbol("e"), POSITIVE.symbol("k")

# A tree, the letter, which way it goes, what is cited; whether it is seen, by a form or a slope.
GROWING = {
    "both places in one sense": ("(1 + e)/(2 - e)", "e", 1, (), "seen"),
    "a square that falls": ("1 - e^2", "e", -1, (), "seen"),
    "above and below against each other": ("3k/(4 + k)", "k", 1, (), 1 - 4 / (k + 4)),
    "the square completed": (
        "(1 + e)/sqrt(57 - 6e + e^2)",
        "e",
        1,
        (),
        (1 + e) / sp.sqrt((3 - e) ** 2 + 48),
    ),
    "a numerator that changes its sign": (
        "(3 - 5e)/sqrt(13 - 10e + 25e^2)",
        "e",
        -1,
        (),
        "derivative",
    ),
    "not beyond what is known": ("e/(1 + e^2)", "e", 1, (), "derivative"),
    "not at all, as it goes both ways": ("k/(1 + k^2)", "k", 1, (), None),
    "up to an end that is cited": ("k/(1 + k^2)", "k", 1, ("k <= 1",), "derivative"),
}


@pytest.mark.parametrize("name", GROWING)
def test_growth_is_seen(name: str) -> None:
    typed, letter, sense, cited, expected = GROWING[name]
    tree = read_relation(f"x = {typed}", {}).only[0].right
    ends: list[Link] = [link for each in cited for link in read_relation(each, {}).only]
    own = shown(tree, letter, sense, ends, ROLES)
    if expected is None:
        assert own is None
        return
    assert own is not None
    assert (own.form is None) == isinstance(expected, str)
    assert (own.derivative is not None) == (expected == "derivative")
    if own.form is not None:
        assert sp.simplify(own.form - own.value) == 0
        assert own.form == expected
    if own.derivative is not None:
        # the slope at a point, by differences
        point = {e: sp.Rational(1, 3), k: sp.Rational(2, 3)}
        symbol, step = (e if letter == "e" else k), sp.Rational(1, 10**6)
        ahead, behind = (own.value.subs(symbol, point[symbol] + sign * step) for sign in (1, -1))
        slope = (ahead - behind) / (2 * step)
        assert abs(float(slope - own.derivative.subs(point))) < 1e-6
