"""What stands in a working is taken from there, and is not found a second time."""

from __future__ import annotations

from functools import cache

import pytest

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text


@cache
def solved(text: str) -> Solution:
    return solve(parse(text))


@cache
def planned(text: str) -> Derivation:
    """The working of a statement, which the follower accepts."""
    solution = solved(text)
    derivation = plan(solution)
    oracle = Oracle(roles(solution.problem))
    assert [str(each) for each in follow(derivation, oracle)] == []
    return derivation


def said(text: str) -> list[str]:
    """What the lines of a working say, but for those that introduce a letter."""
    lines = planned(text).lines
    return [write_relation(e.relation) for e in lines if e.move.id != "let"]  # type: ignore[arg-type]


def printed(text: str) -> str:
    return " ".join(to_text(explain(solved(text)), 100).split())


def test_an_angle_takes_the_scalar_product_that_a_line_gives() -> None:
    text = """
sphere A: mass 3, velocity 3i + j
sphere B: mass 2, velocity -2i - j
A hits B: along i, e = 1/2
find velocity(A), velocity(B), dot(velocity(A), velocity(B)), angle(velocity(A), velocity(B))
"""
    lines = planned(text).lines
    (product,) = (e for e in lines if e.move.record == "product")
    (cosine,) = (e for e in lines if e.move.record == "scalar-angle")
    assert product.number in cosine.premises


def test_a_quotient_by_two_roots_is_printed_as_it_stands() -> None:
    text = """
sphere A: mass 3, velocity 3i + 2j
sphere B: mass 2, velocity -3i - 2j
A hits B: along i, e = 2/3
find dot(velocity(A), velocity(B)), angle(velocity(A), velocity(B))
"""
    assert "cos β = −7/(√5√13) = −7√65/65" in printed(text)


def test_a_range_that_stands_in_the_letter_of_an_angle_is_the_answer() -> None:
    text = """
sphere A: mass m, velocity u at 45°
sphere B: mass 2m, at rest
A hits B: along i
unknown e
find range of deflection(A)
find range of tan(deflection(A))
"""
    derivation = planned(text)
    first, second = (each.line for each in derivation.items)
    assert second < first
    assert sum("tan(delta) <= 2" in each for each in said(text)) == 1


def test_a_range_in_letters_has_their_values_put_in() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given along(velocity(A), i) < 0
part a
find range of k
part b
given e = 1/3
find range of k
"""
    derivation = planned(text)
    first, second = (derivation.line(each.line) for each in derivation.items)
    assert second.move.id == "put"
    assert first.number in second.premises
    assert write_relation(second.relation) == "k > 3"  # type: ignore[arg-type]


def test_a_tangent_that_is_known_is_put_in_as_it_is() -> None:
    text = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
given speed(P) = 3/4 u, deflection(P) = 60°
find alpha, e
"""
    lines = said(text)
    assert "(3 + 8e) tan(alpha) = 3sqrt(3)" in lines
    assert not any(each.startswith("sin(alpha) =") for each in lines)


def test_what_has_come_to_a_number_is_put_into_the_law() -> None:
    text = """
sphere A: mass 2, velocity 4i + 3j
sphere B: mass 1, velocity 2j
A hits B: along i
given energy_lost = 4
find e, velocity(A)
"""
    lines = [each for each in planned(text).lines if isinstance(each.relation, Relation)]
    (line,) = (each for each in lines if write_relation(each.relation) == "v = 2")
    assert line.move.id == "put"


def test_what_ties_two_letters_in_another_part_is_an_equation_once_one_is_known() -> None:
    text = """
sphere A: mass m, velocity 3u i + 4u j
sphere B: mass k m, velocity -2u i + u j
A hits B: along i
given velocity(A) = -u i + 4u j
find velocity(B) in terms of u, k
part a
show 4/9 <= k
part b
given velocity(B) in the direction of j
find k, e
"""
    lines = said(text)
    assert "k = 2" in lines
    assert lines.index("k = 2") < lines.index("e = 1/5")


def test_a_direction_is_not_said_twice_in_another_order_of_terms() -> None:
    text = """
wall W
sphere P: velocity 3i
P hits W: e = 1/4
given direction(P) = 90°
find direction(W), speed(P)
"""
    normals = [each for each in said(text) if each.startswith("line_of_centres(1) parallel to")]
    assert "line_of_centres(1) parallel to -3i + s j" in normals
    assert "line_of_centres(1) parallel to s j - 3i" not in normals


def test_the_square_of_a_speed_is_taken_of_the_speed_that_stands() -> None:
    text = """
wall L: along i
wall M: along i
sphere P: velocity u at alpha to L
P hits L: e = e1
P hits M: e = e2
given e1 > 0, e2 > 0
find range of speed(P) in terms of u, alpha
"""
    lines = [each for each in planned(text).lines if isinstance(each.relation, Relation)]
    (square,) = (e for e in lines if write_relation(e.relation).startswith("speed(P, 2)^2 ="))
    assert square.move.id == "rearrange"


@pytest.mark.parametrize(
    ("given", "cosine"), [("cot(alpha) = 4/3", "4/5"), ("sec(alpha) = 5/3", "3/5")]
)
def test_a_reciprocal_that_is_given_is_turned_over_before_it_is_used(
    given: str, cosine: str
) -> None:
    text = f"""
wall W: along i
sphere P: velocity u at alpha to W
given {given}
P hits W: e = 1/2
find speed(P), tan(angle(velocity(P), W))
"""
    lines = planned(text).lines
    said = [write_relation(e.relation) if isinstance(e.relation, Relation) else "" for e in lines]
    ratio = next(n for n, each in enumerate(said) if f"cos(alpha) = {cosine}" in each)
    law = next(n for n, each in enumerate(lines) if each.move.id == "law")
    assert ratio < law


def test_a_letter_by_another_is_asked_in_either_after_a_reciprocal() -> None:
    text = """
wall W: along i
sphere P: velocity u at alpha to W
given cosec(alpha) = 5/4
P hits W: e = 1/2
find deflection(P)
"""
    assert "alpha = arcsin(4/5)" in said(text)


def test_energies_that_stand_are_added_and_taken_from_each_other() -> None:
    text = """
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
find energy(A), energy(A, 0), energy(B), energy(1), energy(0), energy_lost, total_energy_lost
"""
    own = said(text)
    assert "energy(1) = 13 + 15/2 = 41/2 [rearrange]" in own
    assert "energy(0) = 25 + 1/2*3 (2^2 + 3^2) = 89/2 [rearrange]" in own
    assert "energy_lost(1) = 89/2 - 41/2 = 24 [rearrange]" in own
    assert "total_energy_lost(1) = 89/2 - 41/2 = 24 [rearrange]" in own
    assert "by the components that change" not in printed(text)


def test_what_is_lost_is_taken_of_the_energies_of_each_sphere() -> None:
    text = """
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
find energy(A), energy(A, 0), energy(B), energy(B, 0), energy_lost
"""
    assert "energy_lost(1) = 25 - 13 + (39/2 - 15/2) = 24 [rearrange]" in said(text)


def test_a_component_that_does_not_change_is_not_resolved_again() -> None:
    text = """
sphere A: mass 1, velocity 3i + j
sphere B: mass 2, at rest
A hits B: along i, e = 1/2
find across(velocity(A), i)
"""
    assert said(text) == ["across(velocity(A, 1), line_of_centres(1)) = 1"]


def test_what_is_lost_is_what_the_energies_of_the_spheres_change_by() -> None:
    text = """
sphere A: mass 4, velocity 3i + j
sphere B: mass 1, velocity -i + 2j
A hits B: along i, e = 1/2
find energy(A) - energy(A, 0), energy(B) - energy(B, 0), energy_lost
"""
    assert said(text)[-1] == "energy_lost(1) = 288/25 - 168/25 = 24/5 [rearrange]"


def test_the_energy_left_is_that_before_without_what_is_lost() -> None:
    text = """
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
find energy(0), energy_lost, energy
"""
    assert said(text)[-1] == "energy(1) = 89/2 - 24 = 41/2 [rearrange]"


def test_what_two_impacts_take_is_added() -> None:
    text = """
wall W: along i
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 4, at rest
A hits W: e = 1/2
A hits B: along i, e = 1/3
find energy_lost(1), energy_lost(2), total_energy_lost
"""
    assert said(text)[-1] == "total_energy_lost(2) = 12 + 16/3 = 52/3 [rearrange]"


def test_a_component_that_is_known_is_put_in_as_it_is() -> None:
    text = """
sphere A: mass 3m, velocity v at theta
sphere B: mass m, velocity -2u i
A hits B: along i, e = 1/2
given velocity(A) = u j
find v, theta, velocity(B)
"""
    own = said(text)
    assert own[-2] == "x = 8u/5"
    assert not any(each.startswith("cos(theta) =") for each in own)
    assert "Substituting for v cos θ in (2)" in printed(text)


def test_a_time_is_that_of_the_whole_way_where_no_impact_changes_a_component() -> None:
    text = """
point N: (8, 2)
wall W: along i, through (0, 0)
sphere P: at (0, 2), velocity u at -alpha
P hits W: e = 1/2
P reaches N
find alpha, time(2)
"""
    assert said(text)[-1] == "time(2) = 8/(4u/5) = 10/u [rearrange]"
    assert "which no impact changes: t = 8/(4u/5)" in printed(text)


def test_ways_on_which_a_component_is_the_same_are_taken_together() -> None:
    """Also where no component is the same from the start on, and where a first time stands."""
    text = """
point S: (0, 7/4)
wall W1: along i, through (0, 0)
wall W2: along j, through (4, 0)
wall W3: along i, through (0, 3)
sphere P: at (0, 1), velocity 2i - 2j
P hits W1: e = 1/2
P hits W2: e = 1/2
P hits W3: e = 1/2
P reaches S
find time(4)
"""
    own = said(text)
    assert own[-2:] == [
        "time(4) - time(2) = 4/1 = 4 [rearrange]",
        "time(4) = 2 + 4 = 6 [rearrange]",
    ]
    assert "which no impact in between changes: t₄ − t₂ = 4/1 = 4 s" in printed(text)
    corner = """
point O: (0, 0)
wall OX: from O to (3a, 0)
wall OY: from O to (0, 2a)
sphere P: at (2a, a), velocity -k u i - u j
P hits OX: e = 1/2
P hits OY: e = 1/2
find range of k, time(2)
"""
    assert said(corner)[-1] == "time(2) = 2a/(k u)"


def test_a_time_is_added_of_ways_of_which_one_is_asked() -> None:
    text = """
point N: (8, 2)
wall W: along i, through (0, 0)
sphere P: at (0, 2), velocity u at -alpha
P hits W: e = 1/2
P reaches N
find alpha, time(1), time(2)
"""
    assert said(text)[-1] == "time(2) = 10/(3u) + 20/(3u) = 10/u [rearrange]"


def test_squares_on_both_sides_are_not_multiplied_out() -> None:
    text = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
given speed(A) = u/3
find k
"""
    own = said(text)
    assert own[-2:] == ["2(1 + k) = -3(2 - k) or 2(1 + k) = 3(2 - k)", "k = 8 or k = 4/5"]


def test_a_square_below_a_line_is_made_the_subject() -> None:
    text = """
sphere A: mass m, velocity u at 45°
sphere B: mass 2m, at rest
A hits B: along i
find velocity(A) in terms of u, e
given angle(velocity(A), line_of_centres) = arctan(4)
find e
"""
    assert "(1 - 2e)^2 = 9/16" in said(text)


def test_a_factor_that_both_parts_of_a_quotient_have_goes_before_roots_are_sought() -> None:
    text = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given deflection(P) = 90°, energy_lost = 1/4 energy(0)
find e
"""
    own = said(text)
    assert own[-4:] == [
        "sin^2(alpha) = 1/(1 + e)",
        "(1 - e^2)/(1 + e) = 1/4",
        "1 - e = 1/4",
        "e = 3/4",
    ]


def test_a_speed_that_was_asked_is_what_is_given_of_it_later() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, velocity -u i
A hits B: along i
given cos(alpha) = 4/5
part a
find speed(A) in terms of u, e
part b
given speed(A) = sqrt(13)/5 u
find e
"""
    assert "It is given that the speed of A is (√13/5)u: ((√13/5)u)² = u²(13 + 24e" in printed(text)


def test_the_angle_of_the_data_with_a_radius_has_no_other_letter() -> None:
    text = """
wall C: circle centre (0, 0) radius a
sphere P: mass m, at (a, 0), velocity u at 180° - theta
P hits C: e = e
P hits C: e = e
P reaches (a, 0)
find tan(theta)
"""
    told = printed(text)
    assert "θ + φ = 90° − ψ" in told
    assert "Let β" not in told


def test_a_decimal_that_is_the_exact_value_is_shown_to_be_equal() -> None:
    text = """
sphere A: mass 2m, velocity u i
sphere B: mass 3m, at rest
A hits B: along i, e = 1/2
show impulse = 1.8m u to 3 s.f.
"""
    assert "magnitude of the impulse = 1.8mu (as required)" in printed(text)
    assert "≈" not in printed(text)


def test_the_direction_of_who_moves_along_the_line_of_centres_tells_that_line_first() -> None:
    text = """
sphere A: mass m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset d
given direction(B) = 30°
find d, {asked}
"""
    for asked in ("speed(B)", "velocity(B)"):
        own = said(text.format(asked=asked))
        assert own.index("d = r") < own.index("m (sqrt(3) u/2) = m v + m w")
    whole = printed(text.format(asked="speed(B)"))
    assert "component of 𝐮_A along the line of centres = u cos 30° = √3 u/2" in whole
    assert "unit vector" not in whole
    whole = printed(text.format(asked="velocity(B)"))
    assert "𝐮_A · 𝐧 = u cos 30° = √3 u/2" in whole
    assert "𝐯_B = (√3(1 + e)u/4)((√3/2)𝐢 + ½𝐣)" in whole


def test_a_coefficient_that_divides_is_positive() -> None:
    """Where e is 0 the ball stays at the first wall."""
    text = """
wall W1: along i, through (0, 0)
wall W2: along i, through (0, d)
sphere P: at (0, 0), velocity u at alpha
P hits W2: e = e
P hits W1: e = e
find minimum of time(2) over alpha
"""
    assert "α is acute and e > 0" in printed(text)


def test_a_letter_in_letters_that_are_known_by_now_comes_of_its_line() -> None:
    text = """
sphere A: mass m, velocity u at 30°
sphere B: mass k m, at rest
A hits B: along i
given speed(A) = speed(B)
find range of k
part b
given e = 1
find k
"""
    lines = said(text)
    assert "3(1 + e)^2 = 3(1 - e k)^2 + (1 + k)^2" in lines
    assert lines[-1] == "k = 2"
    assert not any("(1 - k)" in each for each in lines)


def test_a_range_begins_with_the_bound_that_was_shown() -> None:
    text = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: velocity u at alpha from -i
A hits B: along i, e = 1/3
given deflection(B) > 90°
show tan(alpha) < 1/sqrt(3)
show alpha < 30°
find range of alpha
"""
    lines, derivation = said(text), planned(text)
    assert lines[-1] == "0° < alpha < 30°"
    (before,) = (each for each in derivation.lines[-1].premises if isinstance(each, int))
    assert before == derivation.lines[-2].number


def test_an_end_of_a_range_that_was_shown_is_not_derived_again() -> None:
    lines = said("""
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
show u cos(alpha) <= speed(P) <= u
show e u <= speed(P) <= u
""")
    assert "speed(P, 1) <= u" not in lines
    assert lines[-1] == "e u <= speed(P, 1) <= u"


@pytest.mark.parametrize("before", [30, 75])
def test_energy_lost_at_a_wall_takes_the_speed_that_stands(before: int) -> None:
    text = printed(
        f"wall W: along i\nsphere P: mass m, velocity u at {before}° to W\nP hits W\n"
        f"given angle(velocity(P), W) = {before - 15}°\nfind e, speed(P), energy_lost"
    )
    assert "(iii) kinetic energy lost = ½mu² − ½m(" in text
    assert "Substituting for e" not in text


def test_an_energy_lost_by_given_speeds_is_not_by_components() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass m, velocity 5u at alpha to W\nP hits W\n"
        "given speed(P) = 4u\nfind energy_lost"
    )
    assert "the speed of P is 4u: kinetic energy lost = ½m(5u)² − ½m(4u)²" in text
    assert "component" not in text


BETWEEN_SLANTS = """
sphere A: mass m, velocity u (i + 2j)
sphere B: mass m, at rest
A hits B: along i + j, e = 1/2
find velocity(A), deflection(A)
"""

AT_A_SLANTING_WALL = """
wall W
sphere P: velocity 5i - 3j
P hits W
given velocity(P) = i + 3j
find e, deflection(P)
"""

ALONG_AN_AXIS = """
sphere A: mass m, velocity 2u i
sphere B: mass m, at rest
A hits B: along i + j, e = 1/3
find velocity(A), deflection(A)
"""


@pytest.mark.parametrize("text", [BETWEEN_SLANTS, AT_A_SLANTING_WALL])
def test_of_two_velocities_that_stand_as_vectors_an_angle_comes_by_the_scalar_product(
    text: str,
) -> None:
    assert [e.move.record for e in planned(text).lines].count("scalar-angle") == 1
    assert "arctan" not in printed(text)


def test_of_one_along_an_axis_it_comes_by_a_tangent() -> None:
    assert "scalar-angle" not in [e.move.record for e in planned(ALONG_AN_AXIS).lines]


def test_two_roots_are_not_multiplied_to_a_root_of_a_long_number() -> None:
    text = """
sphere A: mass 5, velocity 2i - 7j
sphere B: mass 1, velocity -4i + 5j
A hits B: along -j, e = 3/4
find deflection(B)
"""
    assert "√(4² + (25/2)²)) ≈ −0.5533 M1 A1" in printed(text)
    assert "≈ −0.5533 M1 A1 δ ≈ 124°" in printed(text)


DIRECTIONS = """
sphere A: mass m, velocity u i, radius r
sphere B: mass 2m, at rest, radius r
A hits B: offset -r, e = 1/2
find direction(B), speed(A)
"""

REACHED = """
wall W: along j, through (6, 0)
sphere A: mass 1, at (-4, -3), velocity 4i + 3j
sphere B: mass 3, at (0, 0), at rest
A hits B: along i, e = 2/3
B reaches W
find distance(A, B), position(B)
"""


def test_two_equations_are_solved_for_the_letter_that_is_wanted() -> None:
    combined = [e for e in planned(DIRECTIONS).lines if e.move.id == "combine"]
    assert [write_relation(each.relation) for each in combined] == ["v = 0"]


def test_a_place_that_is_asked_stands_once() -> None:
    text = printed(REACHED)
    assert text.count("6𝐢") == 1
    assert text.index("= 6𝐢 m B1") < text.index("Distance, from the coordinates")


def test_a_component_that_is_given_as_zero_is_zero_in_a_later_part() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given direction(A) = 90°
part a
show e = 1/k
part b
given energy_lost = 1/4 energy(0), k = 2
find alpha
"""
    told = said(text)
    assert (
        told.index("v = 0") < told.index("w = u cos(alpha)/k") < told.index("w = 1/2 u cos(alpha)")
    )
    assert "the angle from 𝐢 to 𝐯_A is 90°, so 𝐯_A has no component" in printed(text)


def test_a_speed_that_is_given_is_compared_with_what_standing_laws_make_of_it() -> None:
    text = """
sphere A: mass 3m, velocity 2u i
sphere B: mass m, at rest
sphere C: mass 2m, at rest
A hits B: along i
B hits C: along i
part a
show A hits B again
part b
given speed(C) = u
find e
"""
    told = said(text)
    assert "w_2 = (1 + e)^2 u/2" in told
    assert "u = (1 + e)^2 u/2" in told


def test_an_energy_is_that_of_a_speed_that_an_earlier_part_has_found() -> None:
    text = """
wall W: along i
wall X: along j
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/2
P hits X: e = 2/3
part a
find speed(P) in terms of u, alpha
part b
given total_energy_lost = 2/3 energy(0)
find tan(alpha)
"""
    told = said(text)
    energy = "energy(2) = 1/2 m (u^2 (9 + 7cos^2(alpha))/36) = m u^2 (9 + 7cos^2(alpha))/72"
    assert any(each.startswith(energy) for each in told)
    # The square of the tangent is a number without a root, and the cosine is none.
    assert told.index("cos^2(alpha) = 3/7") < told.index("tan^2(alpha) = 4/3")
    assert not any("sin(alpha) = " in each for each in told)


def test_an_energy_is_that_of_a_velocity_that_is_shown_to_be_a_multiple() -> None:
    text = """
wall W: along i
wall X: along j
sphere P: mass m, velocity u at alpha to W
P hits W
P hits X
part a
show velocity(P) = -e velocity(P, 0)
part b
given total_energy_lost = 7/16 energy(0)
find e
"""
    assert any(each.startswith("energy(2) = 1/2 m (e u)^2") for each in said(text))


def test_a_greatest_tangent_is_found_below_a_part_that_has_the_angle_by_its_letter() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/3
part a
given tan(alpha) = 1/2
find deflection(A)
part b
find maximum of tan(deflection(A)) over alpha
"""
    assert "greatest value of tan δ = √3/3 ≈ 0.577, when 1 − √3 tan α = 0, so α = 30°" in printed(
        text
    )


def test_a_claim_and_a_value_that_cannot_be_have_a_sentence_each() -> None:
    text = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/2
given deflection(P) = beta
show tan(beta) = 3 tan(alpha)/(2 - tan^2(alpha))
given beta = 90°
find alpha
"""
    words = printed(text)
    assert "It cannot be shown that tan β = 3 tan α/(2 − tan²α), as it cannot be" in words
    assert "and α, as" not in words


def test_a_tangent_to_i_that_an_earlier_part_has_is_that_of_a_deflection() -> None:
    text = """
sphere A: mass m, velocity u at 60°
sphere B: mass m, at rest
A hits B: along i
part a
show tan(angle(velocity(A), i)) = 2 sqrt(3)/(1 - e)
part b
find range of deflection(A)
"""
    assert sum("sqrt(3) u/2/((1 - e) u/4)" in each for each in said(text)) == 1


TO_A_SLANTING_WALL = """
wall AB: along i
wall BC: along 135°
sphere P: velocity u at alpha to AB
P hits AB
P hits BC
given e = 1/3, velocity(P, 1) perpendicular to BC
find tan(alpha), speed(P, 1), speed(P)
"""


def test_what_strikes_a_wall_at_right_angles_has_its_speed_as_its_component() -> None:
    # tan α = 3, so that the speed is u√(1/10 + 1/10).
    lines = planned(TO_A_SLANTING_WALL).lines
    speed = next(e.number for e in lines if e.move.record == "speed")
    (component,) = (e for e in lines if e.move.record == "component" and speed in e.premises)
    assert write_relation(component.relation).endswith("= u/sqrt(5)")  # type: ignore[arg-type]
    said = printed(TO_A_SLANTING_WALL)
    assert "P strikes BC at right angles, so its component before the impact is its speed:" in said


def test_a_right_angle_to_a_wall_says_along_which_vector_it_lies() -> None:
    said = printed(TO_A_SLANTING_WALL)
    assert "BC is parallel to −𝐢 + 𝐣, so the scalar product is zero: −u cos α + ⅓u sin α" in said


def test_the_tangent_of_what_moves_along_a_vector_is_that_of_the_vector() -> None:
    text = """
sphere A: mass m, velocity 4u i
sphere B: mass m, at rest
A hits B: along 3i - j, e = 1/2
find angle(velocity(B), j)
"""
    assert [e.move.record for e in planned(text).lines if e.move.id == "law"] == ["unchanged"]
    said = printed(text)
    assert "B was at rest, so it moves along the line of centres: tan β = 3/(−1) = −3" in said


OFF_FROM_REST = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i
given speed(B) = 1/2 u, tan(alpha) = 3/4
find e, speed(A)
"""


def test_the_speed_given_of_what_was_at_rest_is_its_component_before_the_laws() -> None:
    # 4u/5 = v + 2 × u/2, and u/2 + u/5 = 4eu/5.
    lines = said(OFF_FROM_REST)
    assert lines.index("w = u/2") < lines.index("m (4u/5) = m v + 2m (u/2)")
    assert lines.count("w = u/2") == 1
    assert "e = 7/8" in lines
    assert "B was at rest, so it moves along the line of centres: w = u/2" in printed(OFF_FROM_REST)
    both = """
sphere A: mass M, velocity 6 at 30°
sphere B: mass 2, at rest
A hits B: along i
given speed(A) = sqrt(12), speed(B) = 3 sqrt(3)
find M, e
"""
    assert "B was at rest, so it moves along the line of centres: w = 3√3 m s⁻¹" in printed(both)
    offset = """
sphere A, B: mass m, radius r
sphere A: velocity u i
sphere B: at rest
A hits B: offset d, e = 1/2
given speed(B) = 3/5 u
find d, direction(A)
"""
    assert "w = 3/5 u" in said(offset) or "w = 3u/5" in said(offset)
    assert printed(offset).count("w = 3u/5") == 1


def test_the_speed_given_of_what_was_moving_leaves_its_sense_open() -> None:
    moving = OFF_FROM_REST.replace("at rest", "velocity -u i").replace("2 u,", "4 u,")
    assert "w = u/4" not in said(moving)[:4]


def test_a_speed_given_after_two_impacts_is_a_power_of_the_coefficient() -> None:
    text = """
sphere A: mass 4m, velocity u i
sphere B, C: mass m, at rest
A hits B: along i
B hits C: along i
given speed(C) = 9/10 u
find e
"""
    assert "(1 + e)^2 = 9/4" in said(text)


ALONG_BOTH = """
sphere A: mass 2, velocity 5i + j
sphere B: mass 1, at rest
A hits B: along i + j, e = 1/3
"""


def test_a_velocity_is_that_before_and_its_change_along_a_slanting_line() -> None:
    own = said(ALONG_BOTH + "find velocity(A), energy")
    assert "velocity(A, 1) = 5i + j - (3sqrt(2) - 5sqrt(2)/3) ((i + j)/sqrt(2))" in own
    assert not any(each.startswith("across(velocity(A") for each in own)
    assert own[-1].startswith("energy(1) = 1/2*2 ((11/3)^2 + (1/3)^2) + 1/2 (8sqrt(2)/3)^2")
    wall = "wall W: along 2i + j\nsphere P: mass 3, velocity 4i - 3j\nP hits W: e = 1/3\n"
    told = printed(wall + "find velocity(P), deflection(P), impulse")
    assert "The velocity changes perpendicular to W only:" in told
    assert "𝐯_P = (4𝐢 − 3𝐣) − (2√5 + 2√5/3)((𝐢 − 2𝐣)/√5)" in told
    assert "𝐭" not in told and "magnitude of the impulse = 3(2√5 + 2√5/3) = 8√5" in told
    beside = said(wall + "find velocity(P), angle(velocity(P), W)")
    assert any(each.startswith("across(velocity(P, 1)") for each in beside)


def test_a_component_against_the_line_of_centres_is_asked() -> None:
    text = """
sphere A: mass 2, at rest
sphere B: mass 1, velocity 5j
A hits B: along -i + j, e = 1/2
find velocity(A), along(velocity(A), line_of_centres)
"""
    assert said(text)[-1] == "along(velocity(A, 1), line_of_centres(1)) = -5sqrt(2)/4"


def test_an_energy_is_by_the_speed_that_stands_as_a_root() -> None:
    wall = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
    own = said(wall + "find speed(P), energy(P), energy_lost/energy(0)")
    assert any(each.startswith("energy(P, 1) = 1/2 m u^2 (cos^2(alpha)") for each in own)
    assert "((u sin(alpha))^2 - (e u sin(alpha))^2)/u^2" in own[-1]


def test_a_right_angle_at_a_wall_is_the_sum_of_two_angles_in_degrees() -> None:
    text = """
wall W: along i
sphere P: mass m, velocity u at 60° to W
P hits W: e = 1/3
find angle(velocity(P), W), deflection(P)
"""
    assert said(text)[-1] == "deflection(P, 1) = 60° + 30° = 90° [rearrange]"


def test_the_angle_between_two_spheres_is_by_their_angles_to_i_that_stand() -> None:
    text = """
sphere A: mass m, velocity u at 60°
sphere B: mass m, velocity u at 120°
A hits B: along i, e = 1/2
find angle(velocity(A), i), angle(velocity(B), i), angle(velocity(A), velocity(B))
"""
    own = said(text)
    assert sum(each.startswith("tan(") for each in own) == 2
    assert own[-2] == "phi = beta - theta = 180° - arctan(2sqrt(3)) - arctan(2sqrt(3)) [put]"
    assert "is the difference of those that they make with 𝐢" in printed(text)
    alone = printed(text.replace("find angle(velocity(A), i), angle(velocity(B), i), ", "find "))
    assert "that they make with 𝐢" not in alone


def test_an_angle_of_the_data_by_its_tangent_is_in_degrees() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 0
given tan(alpha) = 1
find deflection(A)
"""
    assert any("45°" in each for each in said(text))
    assert not any("arctan(1)" in each for each in said(text))


def test_a_ratio_of_two_roots_with_letters_is_one_that_follows() -> None:
    text = """
sphere A: mass k m, velocity -u i + 3u j
sphere B: mass m, velocity 3u j
A hits B: along i, e = 1/2
find speed(A)/speed(B)
"""
    assert "= sqrt((40k^2 + 68k + 37)/(5k^2 + 8k + 4))/3" in said(text)[-1]


PAST_A_SPHERE_AT_REST = """
sphere A: mass m, velocity u at 30°
sphere B: mass 2m, at rest
A hits B: along i, e = 1/4
find angle(velocity(A), velocity(B)), deflection(A)
"""


def test_an_angle_to_the_line_of_centres_keeps_its_first_letter() -> None:
    own = said(PAST_A_SPHERE_AT_REST)
    assert "delta = beta - 30° = arctan(2sqrt(3)) - 30° [put]" in own
    assert "θ" not in printed(PAST_A_SPHERE_AT_REST)


def test_an_obtuse_angle_to_who_moves_along_i_gives_the_deflection() -> None:
    text = PAST_A_SPHERE_AT_REST.replace("2m, at rest", "4m, at rest").replace("e = 1/4", "e = 3/4")
    own = said(text)
    put = "delta = beta - 30° = 180° - arctan(5sqrt(3)/6) - 30° [put]"
    assert f"{put} = 150° - arctan(5sqrt(3)/6) [rearrange]" in own
    assert sum(each.startswith("tan(") for each in own) == 1


def test_who_is_sent_back_along_the_line_of_centres_is_not_said_to_go_on() -> None:
    text = PAST_A_SPHERE_AT_REST.replace("2m, at rest", "4m, at rest").replace("e = 1/4", "e = 3/4")
    text = text.replace(
        "find angle(velocity(A), velocity(B)), deflection(A)",
        "find direction(A), angle(velocity(A), velocity(B))",
    )
    told = printed(text)
    assert "B moves along the line of centres, and A the opposite way along it:" in told
    assert "the same way along it" not in told


def test_times_of_all_ways_that_stand_are_added() -> None:
    text = """
wall AB: from (0, 0) to (3, 0)
wall BC: from (3, 0) to (3, 2)
sphere P: at (0, 1), velocity v i - v j
P hits AB: e = 1/2
P hits BC: e = 1/2
find position(P, 2), time(2)
"""
    assert said(text)[-1] == "time(2) = 1/v + 2/v = 3/v [rearrange]"
    assert "no impact changes" not in printed(text)


@pytest.mark.parametrize("fact", ["energy_lost = 1/4 energy(0)", "energy_lost/energy(0) = 1/4"])
def test_a_share_that_stands_in_letters_is_what_is_given(fact: str) -> None:
    lines = said(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, at rest\n"
        "A hits B: along i, e = 1/2\npart a\nfind energy_lost/energy(0)\n"
        f"part b\ngiven {fact}\nfind alpha\n"
    )
    assert "= 1/2 cos^2(alpha)" in lines[-6]
    assert lines[-5:-3] == ["1/2 cos^2(alpha) = 1/4", "cos^2(alpha) = 1/2"]
    assert lines[-1] == "alpha = 45°"


def test_what_is_seen_in_one_bracket_is_not_multiplied_out() -> None:
    lines = said(
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"
        "given impulse = 1/2 m u\nfind k in terms of e\n"
    )
    assert lines[lines.index("1/2 m u = m (u - v)") + 1] == "v = u/2"


def test_the_square_of_a_speed_that_stands_serves_both_bounds() -> None:
    lines = said(
        "wall W: along i\nsphere P: velocity p i - 4j\nP hits W: e = 1/2\n"
        "given 5 <= speed(P, 0) <= 6\nfind range of p\n"
    )
    assert sum(each.startswith("speed(P, 0)^2 = ") for each in lines) == 1
    assert "p^2 + 4^2 <= 36" in lines
