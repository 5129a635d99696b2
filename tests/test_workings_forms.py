"""How values, products and places are written in workings."""

from __future__ import annotations

import re

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text


def working(text: str) -> str:
    return " ".join(to_text(explain(solve(parse(text))), 80).split())


@pytest.mark.parametrize(
    ("third", "sum_of", "square", "place"),
    [("4m", "4m²/M + M + 5m", "(2m − M)²/M + 9m", "2m"), ("m", "m²/M + M + 2m", "(m − M)²", "m")],
)
def test_a_number_in_common_stands_before_the_sum(
    third: str, sum_of: str, square: str, place: str
) -> None:
    """Of 16m²/M + 4M + 20m that is 4, and the place is no quotient of roots."""
    shown = working(
        "sphere A: mass m, velocity u i\nsphere B: mass M, at rest\n"
        f"sphere C: mass {third}, at rest\nA hits B: along i, e = 1/2\nB hits C: along i, e = 1/2\n"
        "find maximum of speed(C) over M"
    )
    assert f"Let S = {sum_of}." in shown
    assert f"S = {square}" in shown
    assert f"so M = {place} A1" in shown


def test_an_angle_that_is_put_in_is_in_degrees() -> None:
    shown = working(
        "wall W: along i\nsphere P: velocity u at theta to W\nP hits W\n"
        "given angle(velocity(P), W) = theta/3\ngiven theta = 60°\nfind e"
    )
    assert "π" not in shown
    assert "tan 20°" in shown


@pytest.mark.parametrize("given", ["", "given e = m/M\n"])
def test_a_direction_of_90_degrees_is_shown(given: str) -> None:
    mass, e = ("M", "") if given else ("2m", ", e = 1/2")
    shown = working(
        f"sphere A: mass m, velocity u at alpha\nsphere B: mass {mass}, at rest\n"
        f"A hits B: along i{e}\n{given}show direction(A) = 90°"
    )
    assert shown.endswith("angle from 𝐢 to 𝐯_A = 90° (as required) A1*")


def test_a_letter_that_a_fact_makes_of_quantities() -> None:
    shown = working(
        "sphere A: mass 3, velocity 4i + j\nsphere B: mass 2, velocity -2i + 3j\n"
        "A hits B: along i, e = 1/3\ngiven Q = energy_lost/energy(0)\nfind Q"
    )
    assert "not written" not in shown
    assert "Since Q = (kinetic energy lost)/(total kinetic energy before the impact): Q =" in shown


def test_a_letter_that_comes_twice() -> None:
    shown = working(
        "wall V: along i, through (0, 0)\nwall W: along i, through (0, d)\n"
        "sphere P: at (0, 0), velocity u at alpha\nP hits W\nP hits V\nP hits W\n"
        "find along(velocity(P), j)"
    )
    assert "−e × e²u sin α = −e³u sin α" in shown


def test_a_sum_of_vectors_begins_with_i() -> None:
    shown = working(
        "wall X: along i\nwall Y: along j\nsphere P: mass 2, velocity -3i - 4j\n"
        "P hits X: e = 1/2\nP hits Y: e = 1/3\n"
        "find impulse(P, 1), impulse(P, 2), impulse(P, 1) + impulse(P, 2)"
    )
    assert "= (8𝐢 + 12𝐣) N s" in shown
    assert "12𝐣 + 8𝐢" not in shown


def test_who_is_at_rest_has_no_root_for_a_speed() -> None:
    shown = working(
        "sphere S: mass m, velocity 2u at 30°\nsphere T: mass 2m, velocity u at -90°\n"
        "S hits T: along j, e = 1/2\nfind speed(T)"
    )
    assert "√0" not in shown
    assert "speed of T = 0" in shown


def test_what_only_a_calculator_knows_stands_once() -> None:
    """Lines below v ≈ −2.280 have its figures; what they say is exact."""
    shown = working(
        "sphere A: mass 2, velocity 5 at 20°\nsphere B: mass 3, velocity 4 at 130°\n"
        "A hits B: along i, e = 0.6\nfind speed(A), direction(A), energy_lost"
    )
    assert shown.count("v ≈ −2.280 m s⁻¹") == 1
    assert "speed of A ≈ √(2.280² + (5 sin 20°)²) ≈ 2.85 m s⁻¹" in shown
    assert "tan θ ≈ −(5 sin 20°)/2.280 ≈ −0.7499" in shown
    assert "θ ≈ 180° − 36.87°, as v < 0 ≈ 143°" in shown
    assert "½ × 2((5 cos 20°)² − 2.280²) + ½ × 3((4 cos 50°)² − 2.081²) ≈ 20.3 J" in shown
    assert "9.6 cos² 20°" not in shown


def test_a_vector_of_whole_degrees_has_figures() -> None:
    shown = working(
        "sphere A: mass 0.8, velocity 5 at 70°\nsphere B: mass 1.1, velocity 2 at 150°\n"
        "A hits B: along 35°, e = 0.45\nfind direction(A)"
    )
    assert "≈ (−1.688𝐢 + 2.319𝐣) m s⁻¹" in shown
    assert "tan θ ≈ −2.319/1.688" in shown


def test_an_angle_to_a_wall_is_compared_by_its_tangent() -> None:
    """It is less than 90°: a cotangent would need 0 < e."""
    shown = working(
        "wall W: along j\nsphere P: velocity u at alpha to W\nP hits W\n"
        "let theta = angle(velocity(P), W)\nshow theta <= alpha"
    )
    assert "tan θ ≤ tan α" in shown
    assert "cot" not in shown


def test_a_letter_of_a_mass_and_of_a_speed() -> None:
    shown = working(
        "sphere A: mass 2m, velocity u i\nsphere B: mass k m, velocity -k u i\n"
        "A hits B: along i, e = 1/2\nfind energy_lost"
    )
    assert "2mu − km × ku = 2mv + kmw" in shown


@pytest.mark.parametrize(
    ("velocity", "speed"),
    [("5i", "√(1.824² + 4²) ≈ 4.40 m s⁻¹"), ("5.5i", "√(1.872² + 4.4²) ≈ 4.78 m s⁻¹")],
)
def test_a_long_number_stands_under_no_root_among_decimals(velocity: str, speed: str) -> None:
    shown = working(
        f"sphere A: mass 0.2, velocity {velocity}\nsphere B: mass 0.3, velocity 2j\n"
        "A hits B: along 3i + 4j, e = 0.4\nfind speed(A)"
    )
    assert f"speed of A = {speed}" in shown


def test_nothing_is_parallel_to_a_circle() -> None:
    shown = working(
        "wall C: circle centre (0, 0) radius a\n"
        "sphere P: mass m, at (a, 0), velocity u at theta from -i\nP hits C: e = 1/2\nfind speed(P)"
    )
    assert "Along the tangent to C the velocity does not change" in shown
    assert "arallel to C" not in shown


def test_a_blow_is_no_impact_that_changes_nothing() -> None:
    shown = working(
        "wall W: along i, through (0, 0)\nsphere P: mass 0.4, at (0, 5), at rest\n"
        "P receives 1.2i - 1.6j\nP hits W: e = 0.5\nfind time(2)"
    )
    assert "Time = distance ÷ speed parallel to the y-axis: t₂ = (5 − 0)/4 = 1.25" in shown


@pytest.mark.parametrize(
    ("statement", "title"),
    [
        # (3, -3): both components are 3, and it is across W that P comes to it.
        (
            (
                "wall W: along i, through (0, 0)\nsphere P: at (0, 6), velocity 3i - 3j\n"
                "P hits W: e = 1/2\nfind time(1)"
            ),
            "Time = distance ÷ speed parallel to the y-axis: t = 6/3 = 2 s",
        ),
        (
            (
                "wall W: along i, through (0, 0)\nsphere P: at (0, 6), velocity -3j\n"
                "P hits W: e = 1/2\nfind time(1)"
            ),
            "Time = distance ÷ speed: t = 6/3 = 2 s",
        ),
        (
            (
                "wall L: along j, through (0, 0)\nwall R: along j, through (d, 0)\n"
                "sphere P: at (0, 0), velocity u i + 2u j\nP hits R: e = 1/3\nP hits L: e = 1/2\n"
                "find time(2) - time(1)"
            ),
            "Time = distance ÷ speed parallel to the x-axis: t₂ − t₁ = d/(u/3)",
        ),
    ],
)
def test_the_speed_by_which_a_time_is_worked_out_is_named(statement: str, title: str) -> None:
    assert title in working(statement)


def test_an_answer_has_three_figures_at_once() -> None:
    shown = working(
        "sphere A: mass m, velocity u at arctan(12/5)\n"
        "sphere B: mass m, velocity u at arctan(3/4) from -i\nA hits B: along i, e = 1/2\n"
        "find cos(angle(velocity(A), velocity(B)))"
    )
    assert "≈ −0.938 " in shown
    assert "−0.9383" not in shown


def test_a_fraction_of_letters_has_no_decimal_behind_it() -> None:
    shown = working(
        "sphere A: mass 2m, velocity 4u i\nsphere B: mass 3m, at rest\n"
        "A hits B: along i, e = 1/2\nfind velocity(B)"
    )
    assert "𝐯_B = (12u/5)𝐢 A1" in shown.replace("ft", "")


def test_factors_stand_in_the_order_in_which_they_are_read() -> None:
    """A time behind a speed, a letter before a root of a sum, a tangent by itself as a square."""
    apart = working(
        "sphere A: mass 3m, velocity 2u i + u j\nsphere B: mass m, velocity -2u i + u j\n"
        "A hits B: along i, e = 1/2\nfind distance(A, B, at t), position(A, at t)"
    )
    assert "= 2ut" in apart
    assert "(ut/2)𝐢 + ut𝐣" in apart
    assert "the components in the direction of 𝐣 stay u for each." in apart
    cosine = working(
        "sphere A: mass 2m, velocity u i + 2u j\nsphere B: mass 3m, velocity -2u i - u j\n"
        "A hits B: along i, e = 2/3\nfind cos(angle(velocity(A), velocity(B)))"
    )
    assert "/(u√((2u)² + (2u)²))" in cosine
    squared = working(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/3\nlet phi = angle(velocity(A), i)\ngiven phi = 90° - alpha\n"
        "find tan(alpha)"
    )
    assert "3 tan²α = 1" in squared


def test_a_vector_of_short_decimals_is_not_rounded_in_one_component() -> None:
    shown = working(
        "wall W: along i + 2j\nsphere P: mass 0.25, velocity 8i\nP receives -i + 3j\n"
        "P hits W: e = 0.4\nfind velocity(P)"
    )
    assert "= (6.24𝐢 + 10.88𝐣) m s⁻¹" in shown
    assert "after the impulse." in shown


def test_the_fraction_lost_has_its_name() -> None:
    shown = working(
        "sphere A: mass m, velocity u at 30°\nsphere B: mass m, at rest\nA hits B: along i, e = e\n"
        "find range of energy_lost/energy(0)"
    )
    assert "0 ≤ fraction lost ≤ ⅜" in shown


@pytest.mark.parametrize(
    ("e", "speed"),
    [("1/sqrt(2)", "V√(1 − ½ sin²θ)"), ("1/sqrt(3)", "V√(1 − ⅔ sin²θ)")],
)
def test_a_sum_that_begins_with_its_divisor_is_divided(e: str, speed: str) -> None:
    """And the square of a claim is what it was under its root."""
    shown = working(
        f"wall W: along i\nsphere P: mass m, velocity V at theta to W\nP hits W: e = {e}\n"
        "show speed(P) = V sqrt(1 - sin^2 theta)"
    )
    square = speed.replace("√", "²")
    assert f"it is {speed}, and {square} − V²(1 − sin²θ) = " in shown


def test_a_long_root_of_a_value_in_letters_is_not_written() -> None:
    """35² + 204² is 42 841, and no square."""
    shown = working(
        "sphere A: mass m, velocity 13V at arctan(12/5)\nsphere B: mass m, velocity -V j\n"
        "A hits B: along i, e = 3/17\nfind speed(A)"
    )
    assert "speed of A = √((35V/17)² + (12V)²) ≈ 12.2V" in shown


def test_two_squares_stand_before_the_cosine_is_taken_out() -> None:
    shown = working(
        "wall X: along i\nwall Y: along j\nsphere P: velocity 3V at theta to X\n"
        "P hits X: e = 1/4\nP hits Y: e = 2/3\nfind speed(P)"
    )
    assert (
        "speed of P = √((2V cos θ)² + (¾V sin θ)²) = V√(64 cos²θ + 9 sin²θ)/4 "
        "= V√(9 + 55 cos²θ)/4, as sin²θ + cos²θ = 1 M1 A1"
    ) in shown


def test_a_letter_that_the_question_has_for_a_speed_is_introduced() -> None:
    """And what a letter is since comes of the last line that says it."""
    shown = working(
        "sphere A: mass 3m, velocity p i\nsphere B: mass 2m, velocity -q i\n"
        "A hits B: along i, e = 1/4\nfind range of q/p\ngiven velocity(A) opposite to i\n"
        "part b\ngiven velocity(A) = -1/2 velocity(A, 0)\nfind q/p, speed(B)/q"
    )
    assert "v = −p/2 (4)" in shown
    assert "Substituting in (4): v = −q/4" in shown
    assert "Let V be the speed of B after the impact. V = q/8 (ii) V/q = ⅛" in shown


def test_a_component_by_a_cosine_in_numbers_is_worked_out_once() -> None:
    shown = working(
        "sphere A: mass 2, velocity 10 at alpha\nsphere B: mass 3, velocity 4j\n"
        "given cos(alpha) = 3/5\nA hits B: along i, e = 1/2\nfind velocity(B)"
    )
    assert "component of 𝐮_A along 𝐢 = 10 cos α = 6 m s⁻¹" in shown
    assert "2 × 6 = 2v + 3w (1)" in shown
    assert "w − v = ½ × 6 (2)" in shown


def test_a_component_that_is_minus_another_has_its_value() -> None:
    shown = working(
        "sphere A, B: mass m\nsphere A: velocity u at beta\nsphere B: velocity u at 180° - beta\n"
        "A hits B: along i\ngiven tan(beta) = 1/3\nfind speed(A) in terms of e, u\n"
        "given velocity(A) perpendicular to velocity(B)\nfind e"
    )
    assert "w = −v (3)" in shown
    assert "Substituting for v in (3): w = 3√10 eu/10" in shown


def test_a_multiple_of_a_velocity_told_by_an_angle_has_its_components() -> None:
    shown = working(
        "wall AB: along i\nwall BC: along j\nsphere S: mass 3m, velocity V at theta to AB\n"
        "S hits AB: e = k\nS hits BC: e = k\nshow velocity(S) = -k velocity(S, 0)"
    )
    assert "Let 𝐮 be the velocity of S at the start." in shown
    assert "by its components: 𝐮 = V cos θ 𝐢 − V sin θ 𝐣" in shown
    assert "= −k(V cos θ 𝐢 − V sin θ 𝐣)" in shown


def test_components_beside_an_offset_have_their_sense_and_their_unit() -> None:
    statement = (
        "sphere A: mass m, velocity u i, radius r\nsphere B: mass m, at rest, radius r\n"
        "A hits B: offset d, e = 1\ngiven angle(velocity(A), i) = 60°\nfind d, speed(A)"
    )
    sense = "positive to the left, looking from A to B: component of 𝐮_A along"
    assert f"with those perpendicular to the line of centres {sense}" in working(statement)
    shown = working(
        "sphere A: mass 2m, velocity 3u i, radius 5\nsphere B: mass m, velocity u i, radius 5\n"
        "A hits B: offset d, e = 1/4\ngiven angle(line_of_centres, i) = arcsin(3/5), d > 0\nfind d"
    )
    assert "the centres are 10 m apart, and the centre of B is d m to the left" in shown


def test_the_side_to_which_a_blow_turns_a_velocity_has_its_reason() -> None:
    shown = working(
        "sphere Q: mass 3m, velocity 2V i\nQ receives K at phi\n"
        "given 180° < phi < 270°, deflection(Q) = 60°, speed(Q) = V\nfind K, phi"
    )
    assert "It is given that the speed of Q is V and the angle of deflection of Q is 60°." in shown
    assert (
        "𝐯_Q = V cos 60° 𝐢 − V sin 60° 𝐣 = (V/2)𝐢 − (√3 V/2)𝐣 as the impulse has a component "
        "in the direction of −𝐣, since 180° < φ < 270°"
    ) in shown


def test_a_cosine_is_worked_out_before_it_is_squared() -> None:
    shown = working(
        "sphere A: mass m, velocity u i + 3u j\nsphere B: mass m, velocity -5u i\n"
        "A hits B: along i\ngiven cos(deflection(A)) = 1/sqrt(5)\nfind e"
    )
    cosine = "(9u + v)/(√10√(9u² + v²))"
    assert f"1/√5 = (uv + 3u × 3u)/(√(u² + (3u)²)√(v² + (3u)²)) M1 A1 = {cosine}" in shown


def test_a_time_that_is_asked_stands_before_the_place() -> None:
    shown = working(
        "wall W: along i, through (0, 0)\nwall X: along i, through (0, h)\n"
        "sphere P: at (0, 0), velocity u at alpha\nP hits X\nP hits W\n"
        "find position(P, 2), time(2) in terms of u, alpha, h, e"
    )
    assert "t₂ − t₁ = h/(eu sin α)" in shown
    assert "= (u cos α)((1 + e)h/(eu sin α)) = (1 + e)h/(e tan α)" in shown


def test_what_binds_an_acute_angle_ends_at_90_degrees() -> None:
    shown = working(
        "sphere S: mass 2m, velocity V i\nS receives K at phi\ngiven direction(S) = 30°\n"
        "find K in terms of phi, m, V"
    )
    assert "As K > 0 and φ is acute, this holds for 30° < φ < 90° only." in shown


def test_one_fact_of_a_coefficient_and_a_direction_fixes_neither() -> None:
    shown = working(
        "sphere A: mass 2m, velocity 3u i\nsphere B: mass m, at rest\nA hits B\n"
        "given speed(A) = 2u\nfind e"
    )
    assert "That the speed of A is 2u is one equation for two unknowns." in shown


def test_a_share_of_an_energy_is_a_fraction_among_fractions() -> None:
    text = (
        "sphere A: mass {m}, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i, "
        "e = 1/2\ngiven energy_lost = 25% energy(0)\nfind alpha"
    )
    shown = working(text.format(m="m"))
    assert "25% of the total kinetic energy" in shown
    assert "(3/16)mu² cos²α = ¼ × ½mu²" in shown
    assert "= 0.25 × (3mu²/5)" in working(text.format(m="1.2m"))
    alone = text.format(m="m").replace("e = 1/2", "e = e").replace("find alpha", "find e")
    assert "= 0.25 × ½mu²" in working(alone)


def test_a_direction_has_no_letters_for_its_size() -> None:
    shown = working(
        "wall W\nsphere P: mass m, velocity 3u i + u j\nP hits W\n"
        "given impulse(P) = lambda m u (-2i + j)\nfind direction(W)"
    )
    assert "the normal to W is parallel to −2𝐢 + 𝐣" in shown


def test_two_masses_are_introduced_together() -> None:
    shown = working(
        "sphere A: velocity 3i + j\nsphere B: velocity -2i\nA hits B: along i\n"
        "given velocity(A) = -i + j, velocity(B) = i\nfind mass(A)/mass(B), e"
    )
    assert "Let m_A and m_B be the masses of A and B." in shown


def test_a_speed_that_is_given_beside_a_sense_is_introduced() -> None:
    shown = working(
        "sphere A: mass m, velocity u i\nsphere B: mass 2m, velocity -u i\nA hits B: along i\n"
        "given along(velocity(A), i) < 0, speed(A) = u/2\nfind e"
    )
    assert "It is given that the speed of A is u/2 and v < 0. u/2 = −v" in shown


def test_a_velocity_said_again_is_in_the_decimals_of_its_line() -> None:
    shown = working(
        "wall W1: along i, through (0, 0)\nwall W2: along -4i + 3j, through (4, 0)\n"
        "sphere P: at (1, 1), velocity -j\nP hits W1: e = 1/2\nP hits W2: e = 1/2\n"
        "find velocity(P), time(2)\nP hits W1: e = 1/2\nfind position(P)"
    )
    assert "As 𝐯₂ = −0.36𝐢 + 0.02𝐣, P moves away from W1" in shown


def test_that_bodies_move_along_and_across_the_line_of_centres_is_said_once() -> None:
    shown = working(
        "sphere A, B: mass 2m\nsphere A: velocity 3u at 20°\nsphere B: at rest\n"
        "A hits B: along i, e = 1\nshow velocity(A) perpendicular to velocity(B)\n"
        "find velocity(B), speed(A), speed(B)"
    )
    first = "A moves perpendicular to the line of centres, and B, which was at rest, along it."
    assert first in shown
    assert "moves along the line of centres:" not in shown


def test_a_line_of_centres_that_is_told_by_90_degrees_is_along_j() -> None:
    shown = working(
        "sphere A: mass m, velocity u at 50°\nsphere B: mass 3m, at rest\n"
        "A hits B: along 90°, e = 1/3\nshow velocity(A) perpendicular to velocity(B)"
    )
    assert "A moves perpendicular to the line of centres, and B, which was at rest" in shown


def test_a_reason_is_not_said_again_in_the_next_row() -> None:
    shown = working(
        "wall W: along i\nsphere P: mass m, velocity u at theta to W\nP hits W: e = 1/4\n"
        "given deflection(P) > 90°\nfind range of theta"
    )
    assert shown.count("as θ is acute") == 1


def test_an_answer_that_a_later_part_puts_in_has_its_four_figures() -> None:
    shown = working(
        "wall W: along j\nsphere P: mass 0.3, velocity 11 at 35° to W\nP hits W: e = 0.4\n"
        "part a\nfind speed(P)\npart b\nfind energy_lost/energy(0) as a percentage"
    )
    (figures,) = re.findall(r"\(11² − ([0-9.]+)²\)/11²", shown)
    assert f"≈ {figures} ≈ " in shown.split("(b)")[0]


def test_short_values_with_a_sign_are_named_with_the_numbers_beside_them() -> None:
    shown = working(
        "sphere A: mass m, velocity 3u i + 2u j\nsphere B: mass k m, at rest\n"
        "A hits B: along i, e = 1/2\ngiven velocity(A) in the direction of -i + 4j\n"
        "part a\nfind k\npart b\nfind energy_lost"
    )
    assert "with v = −u/2, w = u and k = 7/2 from part (a)" in shown


def test_the_line_of_centres_is_along_the_velocity_that_stands_of_a_sphere_from_rest() -> None:
    """It was worked out anew, by the change of the other velocity."""
    shown = working(
        "sphere A: mass 3, velocity 6i + 2j\nsphere B: mass 2, at rest\nA hits B\n"
        "given velocity(A) = 2i + 4j\npart a\nfind velocity(B)\npart b\nfind e"
    )
    lead = "B was at rest, so it moves off along the line of centres, with 𝐯_B from part (a):"
    assert f"{lead} the line of centres is parallel to 2𝐢 − 𝐣 M1 A1ft" in shown
    assert "change of velocity" not in shown


def test_what_one_body_gains_has_a_name() -> None:
    shown = working(
        "sphere P: mass 2, velocity 3i - 4j\nP receives 6i + 10j\nfind energy(P) - energy(P, 0)"
    )
    assert "kinetic energy gained by P = 37 − 25 = 12 J" in shown


def test_an_angle_by_its_sine_is_not_a_line_of_its_own_on_the_way_to_a_difference() -> None:
    shown = working(
        "sphere A: mass 2m, velocity 10u at alpha\nsphere B: mass 3m, at rest\n"
        "given sin(alpha) = 5/13\nA hits B: along i, e = 1/2\nfind deflection(A)"
    )
    assert "α = arcsin(5/13)" not in shown
    assert "δ = β − α = arctan(25/6) − arcsin(5/13)" in shown


def test_a_speed_by_its_angle_is_not_led_to_by_a_fact_that_was_said() -> None:
    shown = working(
        "wall W: along i\nsphere P: mass 0.1, velocity 12 at 64° to W\nP hits W\n"
        "given angle(velocity(P), W) = 38°\npart a\nfind e\npart b\nfind speed(P)"
    )
    lead = "Speed of P = component ÷ cosine of its angle:"
    assert f"{lead} speed of P = (12 cos 64°)/cos 38° ≈ 6.68 m s⁻¹ M1 A1" in shown


def test_components_are_seen_before_they_cancel_in_a_tangent() -> None:
    shown = working(
        "wall W: along j\nsphere P: mass 0.4, velocity 15 at 35° to W\nP hits W: e = 0.8\n"
        "find angle(velocity(P), W)"
    )
    assert "tan β = (12 sin 35°)/(15 cos 35°) = 0.8 tan 35°" in shown


def test_letters_have_the_number_of_their_impact_among_all() -> None:
    """Beside the velocity of A after the third impact its component was v₂."""
    shown = working(
        "sphere A: mass 2, velocity 6i\nsphere B: mass 1, at rest\nwall W: along j\n"
        "A hits B: along i, e = 1/2\nB hits W: e = 2/3\nA hits B: along i, e = 1/2\n"
        "find velocity(A)"
    )
    assert "v₁ = 3" in shown
    assert "v₃ = −½" in shown
    assert "v₂" not in shown


def test_a_speed_that_stands_in_letters_has_their_values_before_it_is_squared() -> None:
    shown = working(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "given tan(alpha) = 3/4\npart a\nshow speed(P) = u/5 sqrt(16 + 9 e^2)\npart b\n"
        "given e = 1/3\nfind energy_lost/energy(0)"
    )
    assert "Since e = ⅓, from (1): speed of P = √17 u/5" in shown
    assert "fraction lost = (u² − (√17 u/5)²)/u² = 8/25" in shown


def test_the_method_of_a_tangent_stands_beside_it_and_not_beside_its_degrees() -> None:
    shown = working(
        "wall W: along j\nsphere P: mass 0.4, velocity 15 at 33° to W\nP hits W: e = 0.7\n"
        "part a\nfind speed(P)\npart b\nfind deflection(P)"
    )
    assert re.search(r"= 0\.7 tan 33° M1 β ≈ [0-9.]+° Let δ", shown)


def test_a_sum_of_what_stands_is_led_to_by_a_word() -> None:
    shown = working(
        "wall W: along i\nwall X: along j\nsphere P: velocity u at 40° to W\nP hits W: e = 1/2\n"
        "P hits X: e = 1/3\nfind deflection(P, 1) + deflection(P, 2)"
    )
    assert " Adding: δ₁ + δ₂ ≈ " in shown


def test_an_impulse_that_is_given_is_the_decrease_of_a_momentum() -> None:
    """That it is the change, above 10 = 4(5 − v), left out in which direction."""
    text = (
        "sphere A: mass 3, velocity {}\nsphere B: mass 6, velocity {}\nA hits B: along i\n"
        "given impulse = 15\nfind velocity(A)"
    )
    lead = "Impulse = decrease in the momentum of A along the line of centres:"
    assert f"{lead} 15 = 3(5 − v) M1 A1" in working(text.format("5i", "-2i"))
    lead = "Impulse = change of momentum of A along the line of centres:"
    assert f"{lead} 15 = 3(v + 5) M1 A1" in working(text.format("-5i", "2i"))


def test_a_component_with_a_tangent_put_in_stands_as_it_is_before_an_identity() -> None:
    problem = parse(
        "sphere A, B: mass 2m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
        "A hits B: along i\ngiven speed(A) = speed(B)\npart a\nshow e = tan^2(alpha)\n"
        "part b\nfind energy_lost/energy(0) in terms of alpha"
    )
    solution = solve(problem)
    assert follow(plan(solution), Oracle(roles(problem))) == ()
    shown = " ".join(to_text(explain(solution), 80).split())
    assert "w = ½u(1 + tan²α) cos α = u/(2 cos α), as sin²α + cos²α = 1" in shown
    assert "= (1 − tan²α)/2" in shown


def test_ratios_that_only_show_an_angle_acute_are_not_worked_out() -> None:
    shown = working(
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
        "A hits B: along i\nlet beta = angle(velocity(A), line_of_centres)\npart a\n"
        "show tan(beta) = 2 tan(alpha)/(1 - e)\npart b\n"
        "given tan(alpha) = 1/3, deflection(A) = 45°\nfind e"
    )
    assert "tan β = (⅓ + 1)/(1 − ⅓) = 2" in shown
    assert "√10" not in shown
