"""Workings as a teacher prints them: what stands once, in one form, under one heading."""

from __future__ import annotations

from workings import printed_with

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text


def test_one_identity_for_two_equations_has_one_heading() -> None:
    printed_with(
        """
        wall V: along i
        wall W: along 180° - phi
        sphere Q: velocity v at beta to V
        Q hits V: e = 1
        Q hits W: e = 1
        given velocity(Q) parallel to i
        find phi in terms of beta
        """,
        [
            "From (1) and (2), by the formulae for a sum of angles: 𝐯₁ · 𝐧 = v sin(β + φ)",
            "𝐯₁ · 𝐭 = −v cos(β + φ)",
            "Parallel to W",
        ],
    )


def test_a_number_that_stands_as_a_fraction_is_one_in_a_vector_too() -> None:
    text = printed_with(
        """
        sphere A: mass 2, velocity 2i + 5j
        sphere B: mass 3, velocity -i - j
        A hits B: along j, e = 1/3
        find velocity(A), velocity(B)
        """,
        ["𝐯_A = (2𝐢 + ⅕𝐣) m s⁻¹", "w = 11/5", "𝐯_B = (−𝐢 + (11/5)𝐣) m s⁻¹"],
    )
    assert "2.2" not in text
    # At a slanting wall no component stands alone, and the vector is in decimals throughout.
    printed_with(
        """
        wall W: along 3i + 4j
        sphere Q: mass 2, velocity 6i - 2j
        Q hits W: e = 1/2
        find velocity(Q), impulse(Q), impulse
        """,
        ["(−1.2𝐢 + 3.4𝐣) m s⁻¹", "(−14.4𝐢 + 10.8𝐣) N s", "√(14.4² + 10.8²) = 18 N s"],
    )


def test_a_speed_of_figures_has_no_line_of_squares() -> None:
    text = printed_with(
        """
        wall V: along i
        wall W: along 75°
        sphere Q: velocity v at 45° to V
        Q hits V: e = 1/2
        Q hits W: e = 1/3
        find speed(Q)
        """,
        ["Second impact", "Speed, from its components: speed of Q ≈ √((", "v)² + ("],
    )
    last = text[text.rindex("speed of Q ≈") :]
    assert last.count("√") == 1


def test_a_coefficient_that_cannot_be_has_its_short_form() -> None:
    printed_with(
        """
        sphere A: mass m, velocity 2u at 30°
        sphere B: mass m, velocity u at 120°
        A hits B: along i
        given velocity(A) parallel to velocity(B, 0)
        find e
        """,
        ["e = (10√3 − 3)/(3 + 6√3) = (63 − 16√3)/33 ≈ 1.07"],
    )


def test_a_component_with_a_minus_sign_has_its_sense() -> None:
    printed_with(
        """
        sphere P: mass m, velocity u i
        sphere Q: mass 2m, at rest
        P hits Q: along theta, e = 1/2
        find speed(P), speed(Q)
        """,
        ["the components to the left, looking from P to Q, stay −u sin θ for P and 0 for Q."],
    )


def test_the_energy_before_is_put_into_what_is_lost() -> None:
    printed_with(
        """
        sphere A: mass 3m, velocity u at 45°
        sphere B: mass m, at rest
        A hits B: along i, e = 1/3
        part a
        find speed(A), speed(B)
        part b
        find energy_lost/energy(0)
        """,
        [
            "Kinetic energy: total kinetic energy before the impact = 3mu²/2",
            "With the speed of A and the speed of B from part (a):",
            "kinetic energy lost = 3mu²/2 − ½ × 3m(√26 u/6)² − ½m(√2 u/2)²",
        ],
    )


def test_the_first_impact_is_finished_before_the_second() -> None:
    text = printed_with(
        """
        wall X: along i
        wall Y: along j
        sphere P: mass m, velocity u at alpha from -i
        P hits X: e = 1/3
        P hits Y: e = 1/2
        part a
        find tan(angle(velocity(P, 1), X))
        part b
        given tan(alpha) = 2
        find velocity(P)
        """,
        ["(b)", "component of 𝐯₁ along 𝐢 = −", "component of 𝐯₁ along 𝐣 = ", "Second impact"],
    )
    assert "First impact" not in text[text.index("(b)") :]


def test_a_least_speed_is_seen_from_its_components() -> None:
    text = printed_with(
        """
        sphere P: mass m, velocity v at 60°
        sphere Q: mass k m, velocity v at 120°
        P hits Q: along i, e = 1/3
        part a
        find speed(P)
        part b
        find minimum of speed(P) over k
        """,
        ["(b)", "(speed of P)² = (", "speed of P ≥ √3 v/2, as (", "²", "≥ 0", "least speed of P"],
    )
    assert "difference" not in text


def test_forms_of_a_range_without_steps_stand_one_below_the_other() -> None:
    problem = parse("""
        sphere A: mass m, velocity u at 60°
        sphere B: mass k m, velocity u at 120°
        A hits B: along i
        find range of speed(A) in terms of u, k
        """)
    rows = to_text(explain(solve(problem))).splitlines()
    cases = [row.strip() for row in rows if ", for " in row]
    assert len(cases) == 4
    assert all("speed of A ≤" in case and ";" not in case for case in cases)


def test_two_velocities_that_stand_as_vectors_have_their_angle_at_once() -> None:
    text = printed_with(
        """
        sphere P: mass 3m, velocity 2v i
        sphere Q: mass m, velocity -2v j
        P hits Q: along 45°, e = 1/3
        part a
        find velocity(P), velocity(Q)
        part b
        find angle(velocity(P), velocity(Q))
        """,
        ["(b)", "by the scalar product, with 𝐯_P and 𝐯_Q from part (a):", "= 2√5/5"],
    )
    assert "component" not in text[text.index("(b)") :]


def test_a_deflection_to_a_given_velocity_is_its_angle_to_the_axis() -> None:
    text = printed_with(
        """
        wall W: along theta
        sphere P: mass 2, velocity 6i
        P hits W
        given velocity(P) = 3i + 2sqrt(3) j
        part a
        find theta, e
        part b
        find deflection(P)
        """,
        ["(b)", "P came in the direction of 𝐢", "tan δ = 2√3/3"],
    )
    assert "β" not in text[text.index("(b)") :]


def test_three_chords_of_a_ring_close_at_a_third_impact_too() -> None:
    printed_with(
        """
        wall C: circle centre (0, 0) radius r
        sphere P: mass m, at (r, 0), velocity v at 180° - beta
        P hits C: e = 1/2
        P hits C: e = 1/2
        P hits C: e = 1/2
        given position(P, 3) = (r, 0)
        find tan(beta)
        """,
        [
            "It is given that the position of P at the third impact is (r, 0). A chord subtends",
            "β + φ = 90° − ψ",
            "tan²β = 1/14",
            "tan β = √14/14",
        ],
    )


def test_a_time_that_is_given_is_the_whole_way_at_one_pace() -> None:
    text = printed_with(
        """
        wall W: along j, through (3, 0)
        point N: (0, 10)
        sphere P: mass m, at (0, 0), velocity u at alpha
        P hits W: e = 1/2
        P reaches N
        part a
        find tan(alpha)
        part b
        given time(2) = 5
        find u
        """,
        [
            "(b)",
            "Time = distance ÷ speed parallel to the y-axis, which no impact changes:",
            "t = 10/(",
        ],
    )
    assert "t₂" not in text


def test_a_component_of_the_data_by_an_angle_is_worked_out() -> None:
    printed_with(
        """
        sphere A: mass 4, velocity 10 at arctan(3/4)
        sphere B: mass 1, velocity 13 at arctan(5/12) from -i
        A hits B: along i, e = 1/2
        find speed(A)
        """,
        ["component of 𝐮_A along 𝐢 = 10 × ⅘ = 8 m s⁻¹", "along 𝐢 = −13 × (12/13) = −12 m s⁻¹"],
    )
