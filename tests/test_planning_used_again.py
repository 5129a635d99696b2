"""What a working has already is used: a tangent, the square of a speed, a component."""

from __future__ import annotations

from dataclasses import replace

import pytest
from workings import printed_with

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

TURNED = """
sphere A: mass m, velocity u at 45°
sphere B: mass 3m, at rest
A hits B: along i
part a
find range of deflection(A)
part b
given deflection(A) = 60°
find e
"""

SQUARED = """
wall W: along i
sphere P: mass m, velocity u at α to W
P hits W: e = 1/√2
show speed(P)^2 = 1/4 u^2 (3 + cos 2α)
find speed(P)
"""

ONE_LINE = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given energy_lost = 1/4 energy(0)
find e in terms of k
find speed(B) in terms of k, u
find range of k
find range of e
find minimum of k over e
"""

EARLY = """
wall W: along 3i + 4j
sphere P: mass m, velocity u i
P hits W
find velocity(P) in terms of u, e
find energy_lost
given velocity(P) perpendicular to i
find e
"""

TWICE = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given deflection(A) = alpha
find k in terms of e, alpha
"""

EQUAL = """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, velocity u at 30° from -i
A hits B: along i
given deflection(A) = deflection(B)
find e
"""


CHORDS = """
wall C: circle centre (0, 0) radius a
point S: (-a, 0)
sphere P: at (-a, 0), velocity u at alpha
P hits C
P hits C
P reaches S
given e = {}
find alpha, time(3)
"""


def worked(text: str) -> str:
    """The working of a statement, which the follower accepts."""
    solution = solve(parse(text))
    assert follow(plan(solution), Oracle(roles(solution.problem))) == ()
    return to_text(explain(solution), 80)


def test_a_tangent_that_stands_takes_the_angle_that_is_given() -> None:
    last = worked(TURNED).partition("(b)")[2]
    assert "3(1 + e)/(5 − 3e) = tan 60° = √3" in last
    assert "β" not in last


def test_a_speed_comes_of_the_line_of_its_square() -> None:
    printed = worked(SQUARED)
    assert "From (1), as sin²α + cos²α = 1:\n(ii) speed of P = u√(1 − ½ sin²α)" in printed
    assert printed.count("Speed, from its components") == 1


def test_a_speed_in_one_line_is_its_component_though_that_has_roots() -> None:
    printed = worked(ONE_LINE)
    assert "speed of B = (2√k + √(3k − 1))u/(2(1 + k)√k)" in printed
    assert "7k" not in printed


def test_a_least_value_far_below_its_bound_has_that_for_its_reason() -> None:
    assert "least value of k = ⅓, when e = 0, as k ≥ ⅓" in worked(ONE_LINE)


def test_an_energy_does_not_stand_before_the_fact_that_closes_without_it() -> None:
    before, _, after = worked(EARLY).partition("It is given that")
    assert "𝐯_P = " in before and "kinetic energy lost" not in before
    assert "½mu² − ½m(3u/4)² = 7mu²/32" in after


def test_a_right_angle_that_is_opened_is_closed_by_the_equation_without_quotients() -> None:
    printed = worked(TWICE)
    assert "β = 90°" not in printed  # it is said once, below
    assert "(1 + k)(1 − tan²α) = 2(1 − ek)\n" in printed
    assert "which holds if ek = 1 too, where α = 45°" in printed
    assert printed.count("which holds if") == 1


def test_equal_deflections_go_by_angles_to_one_line_and_surds_are_multiplied_across() -> None:
    printed = to_text(explain(solve(parse(EQUAL))), 80)
    assert "vector product" not in printed
    assert "tan φ = (tan θ − tan ψ)/(1 + tan θ tan ψ)" in printed
    assert "√3(3 + √3)(5 − 2√3 − e) = 5 − √3 − (1 + √3)e" in printed


def test_a_chord_of_the_same_components_takes_as_long_as_the_one_before() -> None:
    printed = worked(CHORDS.format("1"))
    assert printed.count("length of the chord =") == 1
    assert "t₂ − t₁ = t₁ = √3 a/u\n" in printed
    assert "t₃ − t₂ = t₂ − t₁ = √3 a/u\n" in printed
    assert "all three make the same angle with the radii at their ends: " in printed.replace(
        "\n", " "
    )


def test_chords_of_other_components_are_worked_out_one_by_one() -> None:
    printed = worked(CHORDS.format("1/2"))
    assert "as long" not in printed
    assert printed.count("length of the chord =") == 3


def test_a_component_comes_of_the_other_one_by_the_shorter_law() -> None:
    printed = worked(
        "sphere A: mass m, velocity 4u i\nsphere B: mass k m, velocity -u i\n"
        "A hits B: along i, e = 1/5\n"
        "part a\ngiven velocity(A) opposite to i\nfind range of k\n"
        "part b\ngiven velocity(B) opposite to i\nfind range of k\n"
    )
    lead = "Substituting for v from part (a) in (2):\n"
    assert lead + "    w − 2(2 − k)u/(1 + k) = ⅕(4u + u)  " in printed


def test_a_value_of_an_earlier_part_is_put_in_as_an_equation() -> None:
    text = (
        "wall W: along i\nsphere P: mass m, velocity 10 at alpha to W\ngiven tan(alpha) = 4/3\n"
        "P hits W\ngiven energy_lost = 48% of energy(0)\n"
        "part a\nfind e\npart b\nfind deflection(P)\n"
    )
    assert "Substituting e = ½ from part (a) in (1):\n" in worked(text)


def test_a_letter_comes_to_its_bound_where_its_equation_has_a_solution() -> None:
    """e² = (k − 1)/(2k) comes to ½ as k grows; at k = 0 the equation says nothing."""
    text = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given energy_lost = 1/4 m u^2
find maximum of e over k
"""
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "k → 0" not in shown
    assert "e → √2/2 ≈ 0.707, as k → ∞" in shown


def test_the_least_value_of_an_angle_is_in_degrees() -> None:
    text = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given speed(P) = 1/2 u
find minimum of alpha over e
"""
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "tan α ≥ √3, as α is acute α ≥ 60°" in shown
    assert "least value of α = 60°, when e = 0" in shown


AT_ITS_LEAST = """
sphere A: mass m, velocity u at 60°
sphere B: mass m, at rest
A hits B: along i
let v = speed(A)
{}
part a
given e = 1
find v
"""


def test_a_line_that_stands_takes_a_letter_at_which_it_is_least() -> None:
    """At e = 1 the slope of v against e is 0: what is put in is seen in the line itself."""
    for asked, line in (
        ("find v", "v = √3 u/2 ≈ 0.866u"),
        ("find range of v", "w = 0 M1 A moves perpendicular to the line of centres: v = √3 u/2"),
    ):
        explanation = explain(solve(parse(AT_ITS_LEAST.format(asked))), check=True)
        assert f"Since e = 1, from (3): {line}" in " ".join(to_text(explanation).split())
        assert explanation.followed


def test_what_is_given_of_a_coefficient_alone_bounds_no_other_letter() -> None:
    text = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given e = 1/2
find range of k
"""
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "e ≤ 1" not in shown
    assert "k > 0 B1" in shown


GREATEST_TURN = """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
given e < 1/3
part a
find maximum of {} over alpha
part b
given e = 1/5
find maximum of {} over alpha
"""


@pytest.mark.parametrize("asked", ["deflection(A)", "tan(deflection(A))"])
def test_a_greatest_value_in_letters_takes_the_values_of_a_later_part(asked: str) -> None:
    explanation = explain(solve(parse(GREATEST_TURN.format(asked, asked))), check=True)
    shown = " ".join(to_text(explanation).split()).partition(" (b) Since ")[2]
    assert shown.startswith("e = ⅕, from (5): tan δ ≤ 9√10/20 ")
    assert shown.endswith("when tan α = √10/10, so α ≈ 17.5° A1 A1")
    assert "√10 tan α" not in shown
    assert explanation.followed


SHOWN_IN_LETTERS = "show energy_lost = m M (1 - e^2)(u cos(alpha) + v cos(beta))^2/(2(m + M))"
LOST_BY_TWO_IN_LETTERS = """
sphere A: mass m, velocity u at alpha
sphere B: mass M, velocity v at beta from -i
A hits B: along i
{}
"""


@pytest.mark.parametrize(
    "asked",
    [
        SHOWN_IN_LETTERS,
        f"find impulse\n{SHOWN_IN_LETTERS}",
        "find maximum of energy_lost over e",
    ],
)
def test_squares_of_long_components_are_products_where_the_loss_is_shown_or_greatest(
    asked: str,
) -> None:
    text = LOST_BY_TWO_IN_LETTERS.format(asked)
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation).split())
    assert "= ½m(u cos α − w)(u cos α + w) − ½M(x + v cos β)(x − v cos β)" in shown
    assert "= ½(1 − e)M(x + v cos β)(u cos α + v cos β)" in shown
    assert "(m + M)²" not in shown
    assert explanation.followed


DEFLECTED = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
"""


def test_the_greatest_tangent_of_an_angle_that_let_names_has_its_printed_form() -> None:
    form = "k(1 + e)/(2 sqrt((1 - k e)(1 + k)))"
    text = DEFLECTED.replace("mass m,", "mass k m,").replace("mass 2m,", "mass m,")
    let = "given k e < 1\nlet delta = deflection(A)\n"
    shown = worked(f"{text}{let}show maximum of tan(delta) over alpha = {form}\n")
    assert "greatest value of tan δ = k(1 + e)/(2√((1 − ke)(1 + k)))\n" in shown
    assert "not written out" not in shown
    asked = worked(f"{text}{let}find maximum of tan(delta) over alpha\n")
    assert "greatest value of tan δ = (1 + e)k/(2√(1 − ek)√(1 + k))" in asked


def test_a_greatest_tangent_that_stands_bounds_the_angle() -> None:
    form = "(1 + e)/(2 sqrt(3(2 - e)))"
    for first in (
        f"show maximum of tan(deflection(A)) over alpha = {form}",
        f"show tan(deflection(A)) <= {form}",
    ):
        told = worked(f"{DEFLECTED}part a\n{first}\npart b\nshow deflection(A) <= 30°\n")
        (_, after) = told.split("(b)\n")
        assert after.count("tan δ ≤") == 1
        assert "tan δ ≤ √3/3, as (1 + e)/(2√(3(2 − e))) increases with e and e ≤ 1" in after
        assert "tan δ > 0, as α is acute and 0 ≤ e ≤ 1, so δ is acute" in after


def test_an_equation_that_a_part_shows_ties_the_letters_in_the_next() -> None:
    text = DEFLECTED.replace("2m", "m") + "given speed(A) = speed(B)\n"
    for second in ("find range of alpha", "show alpha <= 45°"):
        told = worked(f"{text}part a\nshow tan^2(alpha) = e\npart b\n{second}\n")
        (_, after) = told.split("(b)\n")
        assert "speed" not in after
        assert "tan²α ≤ 1, as e ≤ 1" in after


def test_a_given_loss_of_long_components_goes_by_products() -> None:
    text = (
        "sphere A: mass 3m, velocity 2u at 60°\nsphere B: mass 2m, velocity u at 30° from -i\n"
        "A hits B: along i\ngiven energy_lost = 1/3 m u^2\nfind e\n"
    )
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation).split())
    assert "= ½(1 − e) × 2m(w + √3 u/2)((2 + √3)u/2)" in shown
    assert "is ⅓mu²: ⅓mu² = 3(7 + 4√3)mu²(1 − e²)/20" in shown
    assert explanation.followed


AT_THE_SECOND_WALL = """
wall V: along i
wall W: along j
sphere P: mass m, velocity u at alpha to V
P hits V: e = 1/2
P hits W: e = 1/3
"""


def test_a_share_of_the_energy_between_impacts_goes_by_squares_of_speeds() -> None:
    for asked, line in (
        (
            "find energy_lost(2)/energy(1)",
            "= ((u cos α)² − (⅓u cos α)²)/((½u sin α)² + (u cos α)²) = 32/(9(4 + tan²α))",
        ),
        (
            "given energy_lost(2) = 1/2 energy(1)\nfind alpha",
            "(u cos α)² − (⅓u cos α)² = ½((½u sin α)² + (u cos α)²) M1 A1",
        ),
    ):
        explanation = explain(solve(parse(AT_THE_SECOND_WALL + asked)), check=True)
        shown = " ".join(to_text(explanation).split())
        assert line in shown
        assert "½m" not in shown
        assert explanation.followed


def test_what_an_earlier_part_shows_takes_a_value_before_the_laws_do() -> None:
    text = (
        "sphere A: mass m, velocity u at 30°\nsphere B: mass k m, at rest\nA hits B: along i\n"
        "given velocity(A) perpendicular to velocity(A, 0)\n"
        "part a\nshow e = (k + 4)/(3k)\npart b\nshow k >= 2\n"
        "part c\ngiven k = 4\nfind energy_lost/energy(0)\n"
    )
    own, after = worked(text).split("(b)\n")
    assert "k = 4/(3e − 1)" not in own
    second, third = after.split("(c)\n")
    assert "(k + 4)/(3k) ≤ 1, as e ≤ 1" in second
    assert third.index("e = (4 + 4)/(3 × 4)") < third.index("v = −√3 u/6")
    assert "mu cos 30°" not in third


def test_a_bound_comes_of_the_equation_of_squares_that_is_shown() -> None:
    text = (
        "sphere A: mass m, velocity p i + q j\nsphere B: mass 2m, at rest\nA hits B: along i\n"
        "given p > 0, q > 0, deflection(A) = 90°\n"
        "part a\nshow 3q^2 = (2e - 1)p^2\npart b\nshow e > 1/2\n"
    )
    (_, after) = worked(text).split("(b)\n")
    assert "2e − 1 > 0, as q > 0" in after
    assert "increases" not in after


def test_an_equation_in_one_ratio_has_the_other_square_as_1_less_that() -> None:
    told = worked(
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: velocity u at 180° - alpha\n"
        "A hits B: along i\ngiven speed(A) = u/2\nshow e^2 = 1 - 3/4 sec^2(alpha)\n"
    )
    assert "(u/2)² = (eu cos α)² + u²(1 − cos²α)" in told
    assert "tan" not in told


def test_the_ratio_of_the_energies_of_one_body_is_that_of_the_squares_of_its_speeds() -> None:
    text = AT_THE_SECOND_WALL + "find energy(P)/energy(P, 0)"
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation).split())
    assert "Ratio of kinetic energies, in which the mass cancels:" in shown
    assert "= ((⅓u cos α)² + (½u sin α)²)/u² = (4 + 5 sin²α)/36" in shown
    assert "as sin²α + cos²α = 1" in shown
    assert "½m" not in shown
    assert explanation.followed
    both = AT_THE_SECOND_WALL + "find energy(P)/energy(P, 0), energy(P)"
    assert "½m" in to_text(explain(solve(parse(both))))


def test_a_condition_that_is_shown_takes_values_and_bounds_another_letter() -> None:
    told = worked(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, at rest\nA hits B: along i\n"
        "given deflection(A) > 90°\npart a\nshow tan^2(alpha) < (2e - 1)/3\n"
        "part b\nshow e > 1/2\npart c\ngiven e = 7/8\nfind range of alpha\n"
    )
    (_, after) = told.split("(b)\n")
    second, third = after.split("(c)\n")
    assert "2e − 1 > 0" in second
    assert "Since e = ⅞, from (3):\n    tan²α < ¼" in third
    assert "cos α" not in third


def test_what_shows_how_a_square_goes_is_not_said_to_be_itself() -> None:
    told = " ".join(
        worked(
            "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
            "A hits B: along i\nfind range of speed(A) in terms of u, alpha\n"
        ).split()
    )
    assert "as (1 − e)² cos²α + 4 sin²α decreases with increasing e" in told


def test_a_multiple_by_the_square_of_a_ratio_rests_on_its_angle() -> None:
    told = worked(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i\n"
        "show energy_lost <= 1/2 energy(0) cos^2(alpha)\n"
    )
    assert "½ cos²α × total kinetic energy before the impact = ¼mu² cos²α" in told


ACUTE_TURN = """
sphere A: mass m, velocity u i + 2u j
sphere B: mass 2m, at rest
A hits B: along i
given e < 1/2
show deflection(A) < 90°
"""


def test_a_turn_of_less_than_a_right_angle_is_shown_by_the_sign_of_the_product() -> None:
    told = " ".join(worked(ACUTE_TURN).split())
    assert "𝐮_A · 𝐯_A > 0, as e < ½ DM1 So angle of deflection of A < 90° (as required)" in told
    solution = solve(parse(ACUTE_TURN))
    derivation = plan(solution)
    oracle = Oracle(roles(solution.problem))
    last = derivation.lines[-1]
    assert isinstance(last.relation, Relation)
    wide = Relation(((replace(last.relation.only[0], sign=">"),),))
    lines = (*derivation.lines[:-1], replace(last, relation=wide))
    reasons = {each.reason for each in follow(replace(derivation, lines=lines), oracle)}
    assert "does-not-follow" in reasons


def test_a_component_by_a_law_with_a_squared_tangent_is_followed() -> None:
    told = worked(
        "sphere A: mass m, velocity 2u at alpha\nsphere B: mass m, velocity u at 180° - beta\n"
        "A hits B: along i\ngiven deflection(B) = 90°, alpha = 60°\nfind e in terms of beta\n"
    )
    assert "As sin²β + cos²β = 1:\n    v = −u(1 − cos β)/cos β" in told


def test_a_fact_that_a_part_has_closed_is_not_worked_out_again() -> None:
    told = worked(
        "sphere A: mass m, velocity p i + q j\nsphere B: mass 2m, at rest\nA hits B: along i\n"
        "given p > 0, q > 0, speed(A) = 2 speed(B)\npart a\nfind q^2/p^2\n"
        "part b\nfind energy_lost/energy(0) in terms of e\n"
    )
    (_, after) = told.split("(b)\n")
    assert "q² = (1 + 4e)p²/3" in after
    assert "speed of A" not in after


def test_the_complement_of_a_later_part_goes_into_what_an_earlier_part_has() -> None:
    printed_with(
        """
        sphere A: mass 2m, velocity u at alpha
        sphere B: mass m, at rest
        A hits B: along i
        given angle(velocity(A), line_of_centres) = beta
        part a
        find e in terms of alpha, beta
        part b
        given alpha + beta = 90°
        show tan^2(alpha) <= 2/3
        """,
        (
            "(b) Since α + β = 90°: tan β = 1/tan α",
            "e = 2 − 3 tan²α 2 − 3 tan²α ≥ 0, as e ≥ 0",
            "tan²α ≤ ⅔ (as required)",
        ),
    )


def test_a_quadratic_that_is_shown_is_solved_in_the_part_that_asks_for_both_roots() -> None:
    printed_with(
        """
        sphere A: mass m, velocity u at alpha
        sphere B: mass m, at rest
        A hits B: along i, e = 1/2
        given tan(deflection(A)) = 1/2
        part a
        show 4 tan^2(alpha) - 6 tan(alpha) + 1 = 0
        part b
        find alpha
        """,
        (
            "4 tan²α − 6 tan α + 1 = 0 (as required) (3)",
            "(b) From (3): tan α = (3 + √5)/4 or tan α = (3 − √5)/4",
            "α = arctan((3 + √5)/4)",
            "α = arctan((3 − √5)/4)",
        ),
    )


def test_a_product_with_terms_of_both_signs_stands_in_factors() -> None:
    told = worked(
        "sphere A: mass m, velocity 2u i + u j\nsphere B: mass 2m, velocity -u i + 3u j\n"
        "A hits B: along i\nshow deflection(B) < 90°\n"
    )
    assert "𝐮_B · 𝐯_B = −ue × u + 3u × 3u = (9 − e)u²" in told
    assert "𝐮_B · 𝐯_B > 0, as e ≤ 1" in told
