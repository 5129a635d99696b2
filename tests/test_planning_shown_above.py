"""Results in angles of the motion that were shown: later items put numbers into them."""

from __future__ import annotations

import re

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

WALL = """
wall W: along j
sphere P: mass m, velocity v at theta to W
P hits W
let phi = angle(velocity(P), W)
"""
SPHERES = """
sphere A: mass 2m, velocity u at theta
sphere B: mass m, at rest
A hits B: along i
let phi = angle(velocity(A), line_of_centres)
"""


def worked(text: str) -> dict[str, str]:
    """What is printed of each part, of a working of which the follower accepts each line."""
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    printed = to_text(explanation, 120)
    assert "not written out" not in printed
    _, *parts = re.split(r"^\((\w)\)$", printed, flags=re.MULTILINE)
    return {
        label: " ".join(part.split()) for label, part in zip(parts[::2], parts[1::2], strict=True)
    }


def test_numbers_are_put_into_results_of_spheres() -> None:
    parts = worked(
        SPHERES + "part a\nshow speed(A) = u sin(theta)/sin(phi)\n"
        "part b\nshow e = 2 - 3 tan(theta)/tan(phi)\n"
        "part c\ngiven tan(theta) = 1/2, phi = 45°\nfind e, speed(A)\n"
        "part d\ngiven theta = 30°, speed(A) = u/sqrt(2)\nfind phi\n"
        "part e\ngiven sin(theta) = 5/13, tan(phi) = 3/4\nfind speed(A)\n"
    )
    assert "e = 2 − (3 × ½)/tan 45° = ½" in parts["c"]
    assert "speed of A = u(√5/5)/sin 45° = √10 u/5" in parts["c"]
    assert "momentum" not in parts["c"]
    assert "√2 u/2 = (u sin 30°)/sin φ" in parts["d"]
    assert "φ = 45°" in parts["d"]
    assert "Since tan φ = ¾: sin φ = ⅗" in parts["e"]
    assert "= 25u/39" in parts["e"]


def test_an_angle_is_told_by_a_result_and_tells_the_coefficient() -> None:
    parts = worked(
        WALL + "part a\nshow energy_lost/energy(0) = 1 - cos^2(theta)/cos^2(phi)\n"
        "part b\ngiven theta = 60°, energy_lost = 1/2 energy(0)\nfind phi\nfind e\n"
        "part c\ngiven theta = 60°, phi = 40°\nfind energy_lost/energy(0)\n"
    )
    first = "fraction lost = (v² − ((v cos θ)/cos φ)²)/v² = 1 − (cos²θ)/cos²φ"
    assert first in parts["a"]
    assert "from (1), (2) and (3)" not in parts["a"].lower()
    assert "½ = 1 − (cos² 60°)/cos²φ" in parts["b"]
    assert parts["b"].index("φ = 45°") < parts["b"].index("tan 45° = √3 e")
    assert "fraction lost = 1 − (cos² 60°)/cos² 40° ≈ 0.574" in parts["c"]


def test_what_a_sphere_loses_is_shown_by_its_speed_in_both_angles() -> None:
    loss = "show energy_lost(A)/energy(A, 0) = 1 - sin^2(theta)/sin^2(phi)\n"
    alone = worked(SPHERES + loss.replace("show", "part a\nshow"))["a"]
    assert "(speed of A) sin φ = u sin θ" in alone
    assert "momentum" not in alone
    below = worked(SPHERES + "part a\nshow speed(A) sin(phi) = u sin(theta)\npart b\n" + loss)["b"]
    assert "kinetic energy of A after the impact = ½ × 2m((u sin θ)/sin φ)²" in below
    assert "= 1 − (sin²θ)/sin²φ (as required)" in below
