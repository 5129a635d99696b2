"""Kinds of questions of which the answers stood alone: what each working now says.

Each is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

import pytest
from workings import planned

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

# A statement, and what its working says: lines, or parts of them.
CASES = {
    "the greatest tangent of an angle that an equation of places ties to e": (
        """
wall Y: along j, through (3b, 0)
sphere P: at (0, 0), velocity u at theta
P hits Y
P reaches (b, 4b)
given b > 0
find maximum of tan(theta) over e
""",
        ("tan θ = 4e/(2 + 3e)", "greatest value of tan θ = ⅘, when e = 1"),
    ),
    "a range of an angle by the end of a wall and by a coefficient": (
        """
wall X: from (2d, 0) to (2d, d)
wall Y: from (2d, d) to (0, d)
sphere Q: at (d, 0), velocity w at phi
Q hits X: e = k
Q hits Y: e = k
Q reaches (0, 0)
given d > 0
find range of phi
""",
        (
            "½ < tan φ (3)",
            "tan φ ≤ ⅔, as 0 ≤ k ≤ 1 (4)",
            "From (3) and (4): ½ < tan φ ≤ ⅔",
        ),
    ),
    "a quantity as a multiple of one at the start, in a letter that is tied": (
        """
wall W: along j
sphere Q: mass 2m, velocity w at beta to W
Q hits W: e = k
given deflection(Q) = 90°
show energy(Q) = k energy(Q, 0)
""",
        (
            "Q before the impact",
            "= k × kinetic energy of Q before the impact (as required)",
        ),
    ),
    "two angles that are equal, both right angles": (
        """
wall W: along i
wall X: along j
sphere P: velocity 3u at theta to W
P hits W: e = k
P hits X: e = k
given deflection(P, 1) = deflection(P, 2)
find theta
""",
        ("cos δ = ", "cos φ = ", "δ = φ", "tan²θ = 1/k"),
    ),
    "who can only strike a round wall from inside": (
        """
wall R: circle centre (0, 0) radius b
sphere Q: mass 2, at (0, h), velocity 3w i
Q hits R: e = 1/2
given energy_lost = 1/4 energy(0)
find h
""",
        ("x = √(b² − h²), as Q is moving", "h² = 2b²/3"),
    ),
    "items in letters of which one tells the other": (
        """
wall V: along j
sphere Q: mass 2m, velocity w at phi
Q hits V: e = k
given velocity(Q) perpendicular to velocity(Q, 0)
show tan^2(phi) = k
find energy_lost in terms of m, w, k
find speed(Q)/w in terms of k
find energy_lost/energy(0) in terms of phi
""",
        ("= (1 − k)mw²", "U/w = √k", "= 1 − tan²φ"),
    ),
    "an offset for which there is an impact": (
        """
sphere P: mass m, velocity w i, radius b
sphere Q: mass m, at rest, radius b
P hits Q: offset h, e = 1/3
find range of h
find maximum of deflection(P) over h
""",
        ("0 < h < 2b, as 2b sin φ increases with φ and φ is acute", "tan δ > 0", "h = b"),
    ),
    "an angle and a coefficient by a deflection and a loss": (
        """
sphere P: mass m, velocity w at theta
sphere Q: mass m, at rest
P hits Q: along i
given deflection(P) = arctan(1/3), energy_lost = 1/4 energy(0)
find theta, e
""",
        ("tan θ = 1 or tan θ = 1/17",),
    ),
    "a quadratic in a tangent with one root by sin² + cos² = 1": (
        """
wall V: along i
wall W: along 180° - phi
sphere Q: velocity w at theta to V
Q hits V: e = 1
Q hits W: e = 1
given velocity(Q) parallel to i
find phi in terms of theta
""",
        ("sin(θ + 2φ) = 0", "φ = 90° − θ/2"),
    ),
    "an angle that is made of two by the statement": (
        """
sphere P: mass 2m, velocity w at theta
sphere Q: mass m, at rest
P hits Q: along i, e = 1/2
let phi = direction(P)
let psi = phi - theta
find tan(psi) in terms of theta
given psi = arctan(1/3), tan(theta) > 3/4
find theta
""",
        (
            "tan ψ = (tan φ − tan θ)/(1 + tan φ tan θ)",
            "= tan θ/(1 + 2 tan²θ)",
            "tan ψ = (tan φ − tan θ)/(1 + tan φ tan θ)",
            "θ = 45°",
        ),
    ),
    "a way to a point that is told in letters": (
        """
point N: (c, 12)
sphere P: mass 1, at (0, 0), velocity w at theta, radius 1
sphere Q: mass 1, at (6, 7), at rest
P hits Q: e = 1/2
Q reaches N
find theta
""",
        ("parallel to (c𝐢 + 12𝐣) − (6𝐢 + 7𝐣)", "tan θ = "),
    ),
    "offsets for which a sphere is turned enough": (
        """
sphere P: mass m, velocity w i, radius b
sphere Q: mass m, at rest, radius b
P hits Q: offset h, e = 1
given deflection(P) >= 30°
find range of h
""",
        ("√(4b² − h²)/h ≥ √3/3", "(4b² − h²)/h² ≥ ⅓", "0 < h ≤ √3 b"),
    ),
    "an angle of 0° between velocities": (
        """
sphere P: mass m, velocity w i + 2w j
sphere Q: mass 3m, velocity -w i + w j
P hits Q: along i
given angle(velocity(P), velocity(Q)) = 0°
find e
""",
        ("so their components are in", "e = "),
    ),
    "a path to a round wall that is to be found": (
        """
wall R: circle centre (0, 0) radius b
sphere Q: at (-3b, h), velocity w i
Q hits R: e = 1/3
given deflection(Q) = 90°
find h
""",
        ("h² = b²/4",),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_working_has_a_plan(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    plain = " ".join(text.split())
    missing = [each for each in lines if " ".join(each.split()) not in plain]
    assert not missing, text


def test_a_bound_is_no_reason_for_a_condition_of_its_own_letter() -> None:
    statement, _ = CASES["items in letters of which one tells the other"]
    text = to_text(explain(solve(parse(statement))))
    assert "\nAs φ is acute, this holds for k > 0 only." in text
    assert "As k ≤ 1, this holds for φ ≤ 45° only." in text
