"""Velocities before an impulse that is given as a vector: a difference of vectors."""

from __future__ import annotations

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text


def printed(text: str) -> str:
    """What is printed of a working of which the follower accepts each line."""
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    assert not explanation.warnings
    return " ".join(to_text(explanation, 100).split())


def test_a_velocity_before_an_unknown_wall_comes_first_and_serves_later_parts() -> None:
    text = printed(
        "wall W\nsphere P: mass 2\nP hits W\n"
        "given impulse(P) = -6i + 8j, velocity(P) = 2i + 3j\n"
        "part a\nfind velocity(P, 0)\npart b\nfind e\npart c\nfind energy_lost"
    )
    law = "Impulse = change of momentum of P: −6𝐢 + 8𝐣 = 2(2𝐢 + 3𝐣 − 𝐮_P) M1 A1"
    assert f"{law} 𝐮_P = (5𝐢 − 𝐣) m s⁻¹ A1" in text
    assert text.index(law) < text.index("the normal to W")
    assert "e = 6/19" in text
    assert "kinetic energy lost = ½ × 2((19/5)² − (6/5)²) = 13 J" in text
    assert "not written out" not in text


def test_letters_of_a_velocity_before_an_impulse_are_found_at_once() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass 0.4, velocity a i + b j\nP hits W\n"
        "given impulse(P) = 6j, velocity(P) = 3i + 5j\nfind a, b, e"
    )
    assert "6𝐣 = 0.4(3𝐢 + 5𝐣 − 𝐮_P) M1 A1 𝐮_P = (3𝐢 − 10𝐣) m s⁻¹" in text
    assert "5 = 10e" in text


def test_both_spheres_go_by_the_impulse_on_one_of_them() -> None:
    text = printed(
        "sphere A: mass 2\nsphere B: mass 3, velocity i - j\nA hits B\n"
        "given impulse(A) = -6i + 3j, velocity(A) = 2i + j\nfind velocity(A, 0), velocity(B)"
    )
    assert "−6𝐢 + 3𝐣 = 2(2𝐢 + 𝐣 − 𝐮_A) M1 A1 𝐮_A = (5𝐢 − ½𝐣) m s⁻¹ A1" in text
    assert "impulse on B = (6𝐢 − 3𝐣) N s" in text
    assert "6𝐢 − 3𝐣 = 3(𝐯_B − (𝐢 − 𝐣)) M1 A1 𝐯_B = (3𝐢 − 2𝐣) m s⁻¹ A1" in text


def test_the_impulse_on_the_other_sphere_tells_it_too() -> None:
    text = printed(
        "sphere A: mass 2\nsphere B: mass 1, at rest\nA hits B\n"
        "given impulse(B) = 6i + 8j, velocity(A) = 4i + 3j\nfind velocity(A, 0)"
    )
    assert "impulse on A = (−6𝐢 − 8𝐣) N s" in text
    assert "−6𝐢 − 8𝐣 = 2(4𝐢 + 3𝐣 − 𝐮_A) M1 A1 𝐮_A = (7𝐢 + 7𝐣) m s⁻¹ A1" in text
