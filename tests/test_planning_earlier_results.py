"""A later part goes on from what an earlier one has: it is not worked out a second time."""

from __future__ import annotations

from functools import cache

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

STRUCK = """
sphere A: mass 2m, velocity u at theta
sphere B: mass m, at rest
A hits B: along i, e = 1/2
"""
NUMBERS = """
sphere A: mass 4, velocity 5i + j
sphere B: mass 2, velocity -i + 4j
A hits B: along i
given energy_lost = 18
"""
BESIDE = """
sphere A: mass m, velocity 2u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset r, e = 1/2
"""


@cache
def worked(text: str) -> dict[str, str]:
    """What is printed of each part, of a working of which the follower accepts each line."""
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    printed = to_text(explanation, 100)
    assert "not written out" not in printed
    parts = printed.split("\n(")
    return {part.lstrip("(")[0]: " ".join(part.split()) for part in parts}


def test_the_tangent_of_a_direction_is_that_of_the_angle_with_the_line_of_centres() -> None:
    parts = worked(
        STRUCK + "part a\nshow tan(direction(A)) = 2 tan(theta)\n"
        "part b\nshow tan(deflection(A)) = tan(theta)/(1 + 2tan^2(theta))\n"
    )
    assert "no component of 𝐯_A is negative, so it is the same angle" in parts["b"]
    assert "u sin θ" not in parts["b"]
    assert "tan δ = (2 tan θ − tan θ)/(1 + 2 tan²θ)" in parts["b"]


def test_a_given_tangent_takes_the_form_that_was_shown() -> None:
    for delta in ("delta", "deflection(A)"):
        let = "let delta = deflection(A)\n" if delta == "delta" else ""
        parts = worked(
            STRUCK.replace("theta", "alpha")
            + f"{let}part a\nshow tan({delta}) = tan(alpha)/(1 + 2tan^2(alpha))\n"
            + f"part b\nfind maximum of {delta} over alpha\n"
            + f"part c\ngiven tan({delta}) = 1/3\nfind tan(alpha)\n"
        )
        assert "⅓ = tan α/(1 + 2 tan²α) M1" in parts["c"]
        assert "tan β" not in parts["c"]


def test_a_loss_that_is_given_is_not_worked_out() -> None:
    parts = worked(
        NUMBERS + "part a\nfind e\npart b\nfind total_energy_lost/energy(0) as a percentage\n"
        "part c\nfind energy\n"
    )
    assert "percentage lost = 18/69 = 6/23 ≈ 26.1% M1 A1" in parts["b"]
    assert "by the components" not in parts["b"]
    assert "= 69 − 18 = 51 J" in parts["c"]


def test_the_energy_of_the_only_sphere_is_what_is_left_of_it() -> None:
    parts = worked(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "part a\nshow energy_lost = 1/2 m u^2 (1 - e^2) sin^2(alpha)\n"
        "part b\ngiven alpha = 60°, e = 1/2\nfind energy_lost/energy(0), energy(P)\n"
    )
    assert "kinetic energy of P = ½mu² − 9mu²/32 = 7mu²/32" in parts["b"]


def test_the_angle_of_the_line_of_centres_with_the_path_comes_of_the_offset() -> None:
    parts = worked(
        BESIDE + "part a\nfind angle(line_of_centres, i)\npart b\nfind speed(B), direction(B)\n"
    )
    assert parts["a"].endswith("sin β = r/(2r) = ½ M1 A1 β = 30° A1")
    lead = "The line of centres makes an angle of 30° with the path of A: "
    assert lead + "unit vector along the line of centres = (√3/2)𝐢 + ½𝐣 Let" in parts["b"]


@pytest.mark.parametrize("delta", ["deflection(P)", "delta"])
def test_an_obtuse_angle_goes_by_the_sign_of_the_tangent_that_was_shown(delta: str) -> None:
    let = "let delta = deflection(P)\n" if delta == "delta" else ""
    parts = worked(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        f"{let}part a\nshow tan({delta}) = (1 + e)tan(alpha)/(1 - e tan^2(alpha))\n"
        f"part b\ngiven tan(alpha) = 2, {delta} > 90°\nfind range of e\n"
        f"part c\ngiven e = 1/3, {delta} < 90°\nfind range of alpha\n"
    )
    assert "tan δ = 2(1 + e)/(1 − 4e)" in parts["b"]
    assert "1 − 4e < 0, as e ≥ 0 e > ¼ ¼ < e ≤ 1" in parts["b"]
    assert "3 − tan²α > 0, as α is acute" in parts["c"]
    assert parts["c"].endswith("0° < α < 60°, as α is acute A1")
    assert "scalar product" not in parts["b"] + parts["c"]
