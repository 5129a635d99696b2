"""Energies in a working: by what stands already, and shares without the mass."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

WALL = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\n"
CORNER = "wall AB: along i\nwall BC: along j\n"


def printed(text: str) -> str:
    """What is printed of a working of which the follower accepts each line."""
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    assert not explanation.warnings
    return " ".join(to_text(explanation, 100).split())


@pytest.mark.parametrize(
    ("velocity", "speed", "line"),
    [
        ("3i - 7j", "5", "kinetic energy lost = ½ × 0.4(3² + 7²) − ½ × 0.4 × 5² = 6.6 J M1 A1"),
        ("8 at 50° to W", "6", "kinetic energy lost = ½ × 0.4 × 8² − ½ × 0.4 × 6² = 5.6 J M1 A1"),
    ],
)
def test_what_is_lost_needs_no_coefficient_where_both_speeds_are_known(
    velocity: str, speed: str, line: str
) -> None:
    text = printed(
        f"wall W: along i\nsphere P: mass 0.4, velocity {velocity}\nP hits W\n"
        f"given speed(P) = {speed}\nfind energy_lost"
    )
    assert line in text
    assert "e =" not in text


def test_a_share_that_is_lost_needs_no_coefficient_where_the_speed_is_given() -> None:
    text = printed(
        "wall W: along j\nsphere P: velocity 8i - 6j\nP hits W\n"
        "given speed(P) = 8\nfind energy_lost/energy(0) as a percentage"
    )
    assert "percentage lost = (8² + 6² − 8²)/(8² + 6²) = 9/25 = 36% M1 A1" in text
    assert "e =" not in text


def test_what_is_lost_comes_of_the_speed_that_was_asked() -> None:
    text = printed(
        f"{WALL}part a\nP hits W: e = 1/2\ngiven tan(alpha) = 3/4\nfind speed(P)\n"
        "part b\ngiven tan(alpha) = 3/4\nfind energy_lost"
    )
    assert "Kinetic energy, with the speed of P from part (a)" in text
    assert "kinetic energy lost = ½mu² − ½m(√73 u/10)² = 27mu²/200 M1 A1ft" in text


def test_what_two_spheres_lose_comes_of_their_speeds_where_both_were_asked() -> None:
    text = printed(
        "sphere A: mass 2m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\ngiven cos(alpha) = 3/5\n"
        "part a\nfind speed(A), speed(B)\npart b\nfind energy_lost"
    )
    assert "with the speed of A and the speed of B from part (a)" in text
    assert "= ½ × 2mu² − ½ × 2m(√73 u/10)² − ½m(3u/5)² = 9mu²/100 M1 A1ft" in text


def test_the_mass_of_one_sphere_cancels_in_what_several_walls_take() -> None:
    text = printed(
        f"{CORNER}sphere P: mass m, velocity u at alpha to AB\nP hits AB: e = 1/2\n"
        "P hits BC: e = 1/3\ngiven tan(alpha) = 3/4\n"
        "find total_energy_lost/energy(0) as a percentage"
    )
    assert "that is lost, in which the mass cancels: (total" in text
    assert "= (u² − ((4u/15)² + (3u/10)²))/u² = 151/180 ≈ 83.9% M1 A1" in text


def test_the_mass_cancels_in_what_one_of_two_spheres_keeps() -> None:
    text = printed(
        "sphere A: mass 3m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/3\ngiven tan(alpha) = 1/2\n"
        "find energy(A)/energy(A, 0), energy(B)/energy(0)"
    )
    assert "= ((4√5 u/15)² + (√5 u/5)²)/u² = 5/9 ≈ 0.556 M1 A1" in text


def test_shares_of_the_same_energy_are_added() -> None:
    share = "energy_lost/energy(0) as a percentage"
    text = printed(
        f"{CORNER}sphere P: mass m, velocity u at 30° to AB\n"
        f"part a\nP hits AB: e = 1/2\nfind {share}\n"
        f"part b\nP hits BC: e = 1/2\nfind {share}\nfind total_{share}"
    )
    assert "= ((√3 u/2)² − (√3 u/4)²)/u² = 9/16 = 56.25% M1 A1" in text
    assert "are added, with the fraction lost at the first impact from part (a)" in text
    assert "= 3/16 + 9/16 = ¾ = 75% A1ft" in text


def test_what_is_lost_is_what_is_not_kept() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass m, velocity u at 60° to W\n"
        "part a\nP hits W: e = 1/3\nfind energy(P)/energy(P, 0) as a percentage\n"
        "part b\nfind energy_lost/energy(0) as a percentage"
    )
    assert "not kept, with the ratio of the energies from part (a): " in text
    assert "percentage lost = 1 − ⅓ = ⅔ ≈ 66.7% B1ft" in text


def test_a_given_speed_is_compared_with_that_of_the_energy_that_is_given() -> None:
    text = printed(
        "wall W: along j\nsphere Q: mass 2m, velocity 3v at theta\nQ hits W: e = e\n"
        "given energy(Q) = 4/9 energy(Q, 0), speed(Q) = 4v sin(theta)\n"
        "part a\nfind theta\npart b\nfind e"
    )
    first, _, second = text.partition("(b)")
    assert "4v sin θ = 2v" in first
    assert "Newton" not in first
    assert "e² = 7/27" in second


def test_what_one_sphere_loses_at_a_wall_is_called_that() -> None:
    text = printed(
        "wall W: along i\nsphere S: mass 0.5, velocity 3i - 6j\nS hits W: e = 1/3\n"
        "find energy_lost(S)"
    )
    assert "Kinetic energy lost, by the component that changes: kinetic energy lost by S =" in text
    text = printed(
        "wall W: along i\nwall V: along j\nsphere S: mass 2, velocity 3i - 6j\nS hits W: e = 1/3\n"
        "S hits V: e = 1/3\nfind energy_lost(S)"
    )
    assert "kinetic energy lost by S = ½ × 2(3² − 1²) = 8 J" in text.partition("Second impact")[2]


def test_a_loss_of_given_velocities_cites_no_line_of_centres() -> None:
    statement = """
sphere A: mass 2, velocity 2i + j
sphere B: mass 1.5, velocity -2i + 3j
A hits B: along i
given velocity(A) = -i + j, velocity(B) = 2i + 3j
find energy_lost
"""
    working = explain(solve(parse(statement)), check=True)
    assert not working.warnings
    assert "½ × 2(2² − 1²) + ½ × 1.5(2² − 2²) = 3 J" in str(working)
