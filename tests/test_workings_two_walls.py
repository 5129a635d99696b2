"""Workings of a ball that strikes two walls at right angles, and of spheres that meet head-on."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

CORNER = """
wall X: along i
wall Y: along j
sphere P: mass m, velocity {velocity}
P hits X: e = {e}
P hits Y: e = {f}
"""
HEAD_ON = """
sphere A: mass 3m, velocity 4u i + 2u j
sphere B: mass 2m, velocity -6u i - 3u j
A hits B: along i, e = 1/4
"""

# Statement, what its working says, and what it does not.
SAYS = {
    # θ = 90° − α and the angle to Y before is 90° − β: they add up to 180° whatever e is.
    "deflections in a corner add up to a straight angle": (
        CORNER.format(velocity="u at alpha to X", e="e", f="e")
        + "given e > 0\nshow deflection(P, 1) + deflection(P, 2) = 180°",
        ["angle between 𝐯₁ and Y = 90° − β", "= 180° (as required)"],
        ["not written out"],
    ),
    # α + β + 90° − β + θ, with tan θ = f/(e tan α).
    "what stands twice goes from a sum of deflections": (
        CORNER.format(velocity="u at alpha to X", e="e", f="f")
        + "given e > 0\nfind deflection(P, 1) + deflection(P, 2)",
        ["= 90° + α + arctan(f/(e tan α))"],
        [],
    ),
    # arctan(8/15) + arctan(15/8) = 90°.
    "two angles of one right-angled triangle": (
        CORNER.format(velocity="-15i - 8j", e="1/3", f="1/3")
        + "show deflection(P, 1) + deflection(P, 2) = 180°",
        ["= 90° + arctan(8/15) + arctan(15/8) = 180° (as required)"],
        ["≈", "not written out"],
    ),
    # tan β is eu sin α/(eu cos α): the path is parallel to the first one.
    "an angle to the first wall after the second, that is to be shown": (
        CORNER.format(velocity="u at alpha to X", e="e", f="e")
        + "given e > 0\nlet beta = angle(velocity(P), X)\nshow beta = alpha",
        ["tan β = eu sin α/(eu cos α) = tan α β = α (as required)"],
        ["meet at", "not written out"],
    ),
    # v = −(2/5)u: no scalar product is needed.
    "an angle between opposite velocities": (
        CORNER.format(velocity="-5i - 9j", e="2/5", f="2/5")
        + "show velocity(P) = -2/5 velocity(P, 0)\nfind angle(velocity(P), velocity(P, 0))",
        ["𝐯₂ is opposite to 𝐮: (ii) angle between 𝐯₂ and 𝐮 = 180°"],
        ["cos"],
    ),
    # The momenta 12mu and −12mu cancel: A leaves with −u i, B with 3u/2 i.
    "an angle between spheres that leave in opposite directions": (
        HEAD_ON + "show velocity(A) parallel to velocity(B)\nfind angle(velocity(A), velocity(B))",
        ["𝐯_A is opposite to 𝐯_B: (ii) angle between 𝐯_A and 𝐯_B = 180°"],
        ["cos"],
    ),
}


@pytest.mark.parametrize("case", SAYS)
def test_what_two_walls_do_together_is_seen(case: str) -> None:
    statement, says, never = SAYS[case]
    working = explain(solve(parse(statement)), marks="none", check=True)
    text = " ".join(to_text(working).split())
    assert not working.warnings
    for piece in says:
        assert piece in text
    for piece in never:
        assert piece not in text
