"""A fact that has one unknown letter by another: it is put in, and one equation is left."""

from __future__ import annotations

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

SPHERES = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at 180° - beta
A hits B: along i
given {tie}, energy_lost = 1/2 energy(0)
find cos({angle})
"""


def test_of_two_equal_angles_that_which_is_asked_stays() -> None:
    text = to_text(explain(solve(parse(SPHERES.format(tie="alpha = beta", angle="beta")))), 80)
    words = " ".join(text.split())
    assert "not written out" not in words
    assert "cos β = 1/√(2(1 − e²)), as β is acute" in words
