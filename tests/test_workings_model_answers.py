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
        [
            "the component of P to the left, looking from P to Q, stays −u sin θ.",
            "Q was at rest, so it moves along the line of centres",
        ],
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
        ["(b)", "𝐯_Q. By the scalar product, with 𝐯_P and 𝐯_Q from part (a):", "= 2√5/5"],
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
            "position of P at the third impact is (r, 0). At the centre a chord subtends",
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


def test_a_factor_is_cancelled_under_the_condition_of_the_answer() -> None:
    text = printed_with(
        """
        wall V: along i
        wall W: along j
        sphere Q: mass 2m, velocity v at alpha to V
        Q hits V: e = f
        Q hits W: e = f
        given energy_lost(1) = 3 energy_lost(2)
        find alpha
        """,
        [
            "mv²(1 − f²) sin²α = 3mv²(1 − f²) cos²α",
            "mv² sin²α = 3mv² cos²α, as 0 ≤ f < 1",
            "tan²α = 3",
            "tan α = √3",
        ],
    )
    assert "Solving" not in text


def test_a_cosine_that_is_none_is_rejected_by_its_range() -> None:
    printed_with(
        """
        wall W: along i
        sphere P: mass m, velocity u at beta to W
        P hits W
        given 8 cos(beta)^2 + 4 sqrt(2) cos(beta) = 7
        find cos(beta)
        """,
        [
            "cos β = (−2√2 + 8)/8 or cos β = (−2√2 − 8)/8",
            "cos β = (−2√2 + 8)/8, as cos β ≥ −1",
            "= (4 − √2)/4 ≈ 0.646",
        ],
    )


def test_figures_that_would_be_rounded_otherwise_are_one_more() -> None:
    """3.9 cos 35° is 3.1947, and 3.19."""
    printed_with(
        """
        sphere A, B: mass 0.18
        sphere A: velocity 4 at 35°
        sphere B: at rest
        A hits B: along i, e = 0.95
        find speed(B), impulse
        """,
        ["w = 3.9 cos 35° ≈ 3.1947 m s⁻¹", "speed of B = 3.9 cos 35° ≈ 3.19 m s⁻¹"],
    )


def test_an_angle_that_has_its_words_just_above_is_by_the_scalar_product() -> None:
    printed_with(
        """
        sphere A: mass 2, velocity 3i + 4j
        sphere B: mass 4, velocity i - 2j
        A hits B: along j, e = 1/2
        find angle(velocity(A), velocity(B))
        """,
        ["Let β be the angle between 𝐯_A and 𝐯_B. By the scalar product: cos β = (3 − 2)/("],
    )


def test_among_decimals_a_measured_value_is_one_too() -> None:
    text = printed_with(
        """
        sphere A: mass 2, velocity i + 5j
        sphere B: mass 5, velocity 2i + j
        A hits B
        given velocity(A) = 4i + j
        find velocity(B), e
        """,
        [
            "𝐯_B = (0.8𝐢 + 2.6𝐣) m s⁻¹",
            "= 3.4 m s⁻¹",
            "= −0.4 m s⁻¹",
            "1.6 + 1.6 = e(3.4 + 0.4)",
            "e = 16/19",
        ],
    )
    assert "17/5" not in text
    printed_with(
        """
        sphere A: mass 1, velocity 7i + j
        sphere B: mass 2, at rest
        A hits B: along 3i + 4j, e = 4/5
        find velocity(A)
        """,
        ["= (7𝐢 + 𝐣) − 1.2(3𝐢 + 4𝐣) = (3.4𝐢 − 3.8𝐣) m s⁻¹"],
    )


def test_a_value_put_in_brings_no_heading_back() -> None:
    text = printed_with(
        """
        wall X: along i
        wall Y: along j
        sphere Q: velocity -4i - 6j
        Q hits X: e = e1
        Q hits Y: e = e2
        given velocity(Q) = i + 2j
        find e1, e2, velocity(Q, 1)
        """,
        ["e₁ = ⅓", "e₂ = ¼", "Substituting for e₁ in (1):", "𝐯₁ = (−4𝐢 + 2𝐣) m s⁻¹"],
    )
    assert text.count("First impact") == 1


def test_the_sense_along_a_wall_stands_before_the_first_coordinate() -> None:
    printed_with(
        """
        point N: (9, 1)
        wall W: along i, through (0, 0)
        sphere P: at (0, h), velocity u at 45° to W
        P hits W: e = 1/3
        P reaches N
        find h
        """,
        [
            "Parallel to W, P first moves in the direction of 𝐢",
            "x-coordinate of P at the impact = h",
        ],
    )


def test_an_answer_that_a_later_item_needs_stands_where_that_has_it() -> None:
    problem = parse("""
        point T: (8, 4)
        wall W: along i, through (0, 0)
        sphere P: at (0, 2), velocity u at alpha to W
        P hits W: e = 1/2
        P reaches T
        given time(2) = 2
        find time(1), position(P, 1)
        """)
    text = to_text(explain(solve(problem), check=True))
    assert text.count("t₁ = ⅖ s") == 1
    assert "= (8/5, 0) m" in text
    assert "1.6" not in text
    assert "not written out" not in text


def test_a_path_makes_an_angle_with_a_line_of_centres_by_an_offset() -> None:
    text = printed_with(
        """
        sphere P: mass 2, velocity 4 j, radius 3
        sphere Q: mass 2, at rest, radius 3
        P hits Q: offset -s
        given direction(Q) = 60°, direction(P) = 120°
        find s, e
        """,
        [
            "so 𝐯_P makes 120° − 60° = 60° with the line of centres: tan 60° = 2/v",
            "v = 2√3/3 m s⁻¹",
            "e = ⅓",
        ],
    )
    assert "𝐧" not in text


def test_a_speed_has_the_figures_with_which_an_energy_goes_on() -> None:
    printed_with(
        """
        wall V: along i
        wall W: along j
        sphere P: mass 0.4, velocity 5 at 40° to V
        P hits V: e = 0.6
        P hits W: e = 0.5
        find speed(P), total_energy_lost/energy(0)
        """,
        ["≈ 2.7178 ≈ 2.72 m s⁻¹", "(5² − 2.7178²)/5² ≈ 0.705"],
    )


def test_no_root_of_a_long_number_is_the_size_of_a_velocity() -> None:
    text = printed_with(
        """
        sphere A: mass 2, velocity 3i - j
        sphere B: mass 3, velocity -i
        A hits B: along 3i - 4j, e = 1/5
        find speed(A), speed(B), angle(velocity(A), velocity(B))
        """,
        ["speed of A", "≈ 1.82 m s⁻¹", "≈ 1.23 m s⁻¹", "≈ −0.5178", "≈ 121°"],
    )
    assert "√51994" not in text


def test_a_printed_component_has_the_line_in_which_the_other_is_put_in() -> None:
    printed_with(
        """
        sphere A: mass 3m, velocity u at alpha
        sphere B: mass k m, at rest
        A hits B: along i, e = 1/3
        part a
        show along(velocity(A), i) = u(9 - k)cos(alpha)/(3(3 + k))
        part b
        find speed(B)
        """,
        [
            "Eliminating w from (1) and (2):",
            "3mu cos α = 3mv + km(v + ⅓u cos α)",
            "v = u(9 − k) cos α/(3(3 + k)) (as required)",
        ],
    )


def test_a_vector_beside_fractions_has_fractions() -> None:
    printed_with(
        """
        sphere A: mass 3
        sphere B: mass 2
        A hits B: along i, e = 1/2
        given velocity(A) = 2i + j, velocity(B) = 3i - 4j
        find velocity(A, 0)
        find impulse(B)
        """,
        ["a = 16/5 m s⁻¹", "impulse on B = 2((3𝐢 − 4𝐣) − ((6/5)𝐢 − 4𝐣)) = (18/5)𝐢 N s"],
    )


def test_roots_of_long_numbers_are_figures_beside_decimal_masses() -> None:
    text = printed_with(
        """
        sphere A: mass 0.4, velocity 6i
        sphere B: mass 0.5, velocity -3i
        A hits B: along i
        given energy_lost = 35% of energy(0)
        find e
        find velocity(A)
        """,
        ["e ≈ 0.795, as e ≥ 0"],
    )
    assert "√" not in text


def test_a_unit_vector_that_is_asked_is_said_once() -> None:
    printed_with(
        """
        sphere A: mass 2, velocity 5i, radius 1
        sphere B: mass 3, velocity -12j, radius 1
        A hits B: offset 1, e = 1/3
        find line_of_centres, velocity(A)
        """,
        ["Let 𝐧 be that unit vector along the line of centres."],
    )


def test_what_comes_from_an_earlier_part_stands_at_the_line_that_takes_it() -> None:
    printed_with(
        """
        sphere P: mass 2, velocity 5i
        wall W
        P hits W
        given impulse(P) = -6i + 8j
        part a
        find velocity(P)
        part b
        find direction(W), e
        """,
        [
            "Component before the impact: 𝐮_P · 𝐧 = (3 × 5)/5 = 3 m s⁻¹",
            "Component after the impact, with 𝐯_P from part (a): 𝐯_P · 𝐧",
        ],
    )


def test_a_sum_of_values_of_an_earlier_part_has_one_sentence() -> None:
    text = printed_with(
        """
        wall X: along i
        wall Y: along j
        sphere P: mass 0.5, velocity 6i - 2j
        P hits X: e = 1/2
        P hits Y: e = 1/3
        part a
        find impulse(P, 1), impulse(P, 2)
        part b
        find abs(impulse(P, 1) + impulse(P, 2))
        """,
        ["(b) Adding, with the impulse on P at the first impact"],
    )
    assert "With these values" not in text


def test_an_angle_in_whole_degrees_has_no_figures_behind_it() -> None:
    text = printed_with(
        """
        wall X: along i
        wall Y: along j
        sphere P: velocity u at 30° to X
        P hits X: e = 1/3
        P hits Y: e = 1/3
        find deflection(P, 1), deflection(P, 2)
        """,
        ["θ = 60°"],
    )
    assert "60.00°" not in text


def test_what_is_required_is_the_result_and_not_the_case_that_it_leaves_out() -> None:
    printed_with(
        """
        sphere A, B: mass m
        sphere A: velocity u at alpha
        sphere B: at rest
        A hits B: along i
        show tan(angle(velocity(A), i)) = 2 tan(alpha)/(1 - e)
        """,
        ["2 tan α/(1 − e) (as required), and ", " = 90° if e = 1"],
    )


def test_what_comes_of_figures_is_in_figures() -> None:
    text = printed_with(
        """
        wall W: along i
        sphere P: mass 0.3, velocity 8 at 50° to W
        P hits W
        given angle(velocity(P), W) = 35°
        part a
        find e
        part b
        find impulse
        """,
        ["Substituting e ≈ 0.5875 from part (a) in (1): component of 𝐯_P away from W ≈ 3.601"],
    )
    assert "8 cos 50° tan 35°" not in text
