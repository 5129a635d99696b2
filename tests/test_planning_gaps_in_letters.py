"""Inequalities in several letters: the difference in factors, each with the reason of its sign."""

from __future__ import annotations

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

TWO = """
sphere A: mass m, velocity {u}
sphere B: mass {mass}, {v}
{more}
A hits B: along i{e}
"""
REST = TWO.replace("{v}", "at rest")
CORNER = """
wall AB: along i
wall BC: along j
sphere P: velocity u at alpha to AB
P hits AB: e = e
P hits BC: e = f
"""
THREE = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
sphere C: mass m, at rest
A hits B: along i, e = {e}
B hits C: along i, e = {e}
"""

SAYS = {
    "what is left is at least a square": (
        REST.format(u="u at alpha", mass="k m", more="", e="") + "show energy(B) <= 1/2 m u^2",
        (
            "= mu²((1 + k)² − (1 + e)²k cos²α)/(2(1 + k)²)",
            "(1 + k)² − (1 + e)²k cos²α ≥ (1 + k)² − 4k = (k − 1)², as 0 ≤ e ≤ 1",
            "kinetic energy of B ≤ ½mu²",
        ),
    ),
    "a square of two masses": (
        REST.format(u="u i", mass="M", more="", e="") + "show energy(B) <= energy(0)",
        ("m² + mM(1 − 2e − e²) + M² ≥ m² − 2mM + M² = (m − M)², as 0 ≤ e ≤ 1",),
    ),
    # For n < 3 the speed of B may be more than u/2.
    "what is left is more than a given bound makes positive": (
        REST.format(u="u at theta", mass="n m", more="given n >= 3", e="")
        + "show speed(B) < 1/2 u",
        (
            "½u − speed of B = u(1 + n − 2(1 + e) cos θ)/(2(n + 1))",
            "1 + n − 2(1 + e) cos θ > 1 + n − 4 = n − 3, as 0 ≤ e ≤ 1 and θ is acute",
            "speed of B < ½u, as n ≥ 3",
        ),
    ),
    "a sign by a bound that is given of a mass": (
        REST.format(u="u at alpha", mass="k m", more="given k > 5/2", e=", e = 2/5")
        + "show along(velocity(A), i) < 0",
        ("v = (5 − 2k)u cos α/(5(1 + k))", "v < 0, as α is acute and k > 5/2"),
    ),
    "the velocity of the one that is caught up": (
        TWO.format(u="u i", mass="M", v="velocity v i", more="given u > v", e="")
        + "show along(velocity(B), i) > v",
        ("x − v = (1 + e)m(u − v)/(m + M)", "x > v, as e ≥ 0 and u > v"),
    ),
    "both squares with a share of each": (
        CORNER + "show speed(P) <= u",
        (
            "u² − (speed of P)² = u²((1 − e²) sin²α + (1 − f²) cos²α)",
            "speed of P ≤ u, as 0 ≤ e ≤ 1 and 0 ≤ f ≤ 1",
        ),
    ),
    "a quadratic by its discriminant": (
        THREE.format(e="1/2") + "show speed(C) < 2/3 u",
        (
            "2u/3 − speed of C = u(8k² − 11k + 8)/(12(1 + k)²)",
            "as the discriminant of 8k² − 11k + 8 is negative: 11² − 4 × 8 × 8 = −135",
        ),
    ),
    "the speed of who moves along one line is a component": (
        THREE.format(e="1/2") + "given speed(C) > 1/2 u\nfind range of k",
        (
            "9ku/(4(1 + k)²) > u/2",
            "2k² − 5k + 2 < 0, as 1 + k > 0 (2k − 1)(k − 2) < 0 ½ < k < 2",
        ),
    ),
    "a quadratic between its roots is said once": (
        REST.format(u="u at alpha", mass="m", more="", e="")
        + "given speed(A) < 1/2 u, tan(alpha) = 1/4\nfind range of e",
        ("(e − 1)² < 13/16 (4 − √13)/4 < e < (4 + √13)/4 (4 − √13)/4 < e ≤ 1",),
    ),
}


@pytest.mark.parametrize("name", SAYS)
def test_each_sign_has_its_reason(name: str) -> None:
    statement, says = SAYS[name]
    solution = solve(parse(statement))
    derivation = plan(solution)
    assert follow(derivation, Oracle(roles(solution.problem))) == ()
    text = " ".join(to_text(explain(solution)).split())
    assert [said for said in says if said not in text] == []
    assert "not written out" not in text
