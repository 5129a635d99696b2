"""Among decimals: roots and fractions that nobody reads are figures, and so are the equations."""

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


def test_an_equation_between_decimals_keeps_them() -> None:
    text = printed(
        "wall W: along i\nsphere P: velocity 5.2 at theta to W\nP hits W: e = 0.45\n"
        "given speed(P) = 4.1\nfind theta, angle(velocity(P), W)"
    )
    assert "16.81 = 5.4756(1 − cos²θ) + 27.04 cos²θ" in text
    assert "cos²θ ≈ 0.5256 cos θ ≈ 0.7250, as θ is acute" in text
    assert "tan β ≈ 0.4275" in text
    assert "√" not in text


def test_an_equation_without_an_end_has_figures() -> None:
    text = printed(
        "sphere A: mass 0.3, velocity 3.7 at theta\nsphere B: mass 0.4, at rest\n"
        "A hits B: along i, e = 0.65\ngiven speed(B) = 1.9\nfind theta, speed(A)"
    )
    assert "4.433 ≈ 6.105 cos θ cos θ ≈ 0.7262" in text
    assert "speed of A ≈ √(0.1535² + 2.544²) ≈ 2.55 m s⁻¹" in text


def test_what_is_put_in_is_shown_in_figures_first() -> None:
    text = printed(
        "sphere A: mass 0.45, velocity 2.7i + 1.3j\nsphere B: mass 0.65, velocity -1.1i\n"
        "A hits B: along i\ngiven speed(A) = 1.7\nfind e, angle(velocity(A), velocity(B))"
    )
    assert "1.528 + 1.095 ≈ e(2.7 + 1.1)" in text
    assert "tan β ≈ 1.3/(−1.095) ≈ −1.187" in text


def test_short_roots_stay_among_decimals() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass 0.5, velocity 2.5 at 60° to W\nP hits W: e = 0.4\n"
        "find speed(P)"
    )
    assert "√3/2" in text


def test_the_direction_from_a_wall_at_an_angle_is_by_the_wall_for_a_path_along_an_axis() -> None:
    text = printed(
        "wall W: along 23°\nsphere P: mass 0.4, velocity 6.5i\nP hits W: e = 0.3\n"
        "find speed(P), direction(P)"
    )
    assert "tan β = (1.95 sin 23°)/(6.5 cos 23°) = 0.3 tan 23° M1 β ≈ 7.257°" in text
    assert "angle from 𝐢 to 𝐯_P ≈ 23° + 7.257°" in text


def test_roots_stay_where_a_mass_alone_is_a_decimal() -> None:
    text = printed(
        "wall W: along i + 2j\nsphere S: mass 0.5, velocity 3i - 7j\nS hits W: e = 3/5\n"
        "find velocity(S), energy_lost(S)"
    )
    assert "√5" in text
    assert "≈ ½" not in text


def test_a_cosine_of_figures_is_one_number() -> None:
    text = printed(
        "sphere P: mass 0.5, velocity 2.4i - 1.8j\nwall W: along 4i + 3j\nP hits W: e = 0.4\n"
        "find angle(velocity(P), velocity(P, 0))"
    )
    assert "(√(4² + 297²)√(4² + 3²)) ≈ −0.6107" in text
    assert "/1485" not in text


def test_multiples_of_roots_are_figures_beside_angles_for_a_calculator_too() -> None:
    text = printed(
        "sphere A: mass 0.15, velocity 3.2 at 30°\nsphere B: mass 0.19, at rest\n"
        "sphere C: mass 0.15, at rest\nA hits B: along i, e = 0.86\nB hits C: along 35°, e = 0.86\n"
        "find speed(B, 1), speed(C)"
    )
    assert "w₁ ≈ 2.274 m s⁻¹" in text
    assert "≈ 2.274 cos 35°" in text
    assert "√3" not in text


def test_a_place_with_a_sum_of_a_root_is_figures_among_decimals() -> None:
    text = printed(
        "wall W: along j, through (1.1, 0)\nwall V: along i, through (0, 0.7)\n"
        "sphere P: mass 0.2, velocity 1.6 at 30°, at (0, 0)\nP hits W: e = 0.9\nP hits V: e = 0.9\n"
        "find position(P)"
    )
    assert "position of P at the second impact ≈ (" in text
    assert "√3" not in text


def test_a_vector_that_comes_out_exactly_is_worked_out_exactly_among_decimals() -> None:
    """And a component is a decimal below it, though that fraction was typed as the coefficient."""
    text = printed(
        "wall W: along i + j\nsphere S: mass 0.4, velocity 5i - j\nS hits W: e = 1/2\n"
        "part a\nfind velocity(S)\npart b\nfind deflection(S)"
    )
    assert "≈" not in text.partition("(b)")[0]
    assert "= (0.5𝐢 + 3.5𝐣) m s⁻¹" in text
    assert "(5 × 0.5 − 3.5)/(√(5² + 1²)√(0.5² + 3.5²))" in text


def test_a_vector_of_fifths_stays_in_fifths_below_such_components() -> None:
    text = printed(
        "sphere A: mass 2, velocity 5i + 2j\nsphere B: mass 4, velocity -i + j\n"
        "A hits B: along 3i - 4j\ngiven impulse = 6\nfind velocity(A), velocity(B)"
    )
    assert "= (5𝐢 + 2𝐣) − ⅗(3𝐢 − 4𝐣) = ((16/5)𝐢 + (22/5)𝐣) m s⁻¹" in text
    assert "= 2((16/5)𝐢 + (22/5)𝐣) + 4𝐯_B" in text
