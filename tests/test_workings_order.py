"""The order in which a printed working says things: a reason before what rests on it."""

from __future__ import annotations

from workings import printed_with

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text


def printed(text: str) -> str:
    return " ".join(to_text(explain(solve(parse(text))), 100).split())


def test_a_velocity_that_is_given_by_another_is_said_before_the_law_that_takes_it() -> None:
    text = """
sphere A: mass 3, velocity 4i + 2j
sphere B: mass 1, velocity -8i - 4j
A hits B
given velocity(A) = -1/2 velocity(A, 0)
find line_of_centres, e
"""
    words = printed(text)
    assert words.count("Since 𝐯_A = −½𝐮_A: 𝐯_A =") == 1
    assert words.index("Since 𝐯_A") < words.index("the line of centres is parallel to")


def test_that_a_body_moves_through_the_centre_has_its_reason_once() -> None:
    text = """
wall C: circle centre (0, 0) radius 10
sphere P: at (6, 8), velocity -3i - 4j
P hits C: e = 1/2
P hits C: e = 1/2
find time(2), velocity(P)
"""
    words = printed(text)
    reason = "P moves along the radius, so it passes through the centre of C:"
    assert words.count(reason) == 1
    assert words.count("A chord makes equal angles with the radii at its ends:") == 1
    assert words.index(reason) < words.index(" P moves through the centre: ")


def test_a_chord_is_introduced_once() -> None:
    text = """
wall C: circle centre (0, 0) radius a
sphere P: at (-a, 0), velocity u at alpha
P hits C
find time(1), speed(P)
"""
    words = printed(text)
    assert words.count("A chord makes equal angles with the radii at its ends") == 1
    assert "The component along the tangent before the impact, taken anticlockwise:" in words


def test_the_side_that_is_worked_out_is_said_before_it_is_taken() -> None:
    text = """
sphere A, B: mass m
sphere A: velocity 8i
sphere B: at rest
A hits B: e = 1/2
given angle(line_of_centres, i) = 30°
find velocity(A)
"""
    words = printed(text)
    side = "Take the line of centres to be at 30° anticlockwise from 𝐢."
    assert words.count(side) == 1
    assert "Let 𝐧 = (√3/2)𝐢 + ½𝐣 be the unit vector along the line of centres" in words
    assert words.index(side) < words.index("8 cos 30°")


def test_the_side_of_a_wall_is_said_before_it_is_taken() -> None:
    text = """
wall W
sphere P: velocity 6i
P hits W: e = 1/2
given angle(i, W) = 30°
find velocity(P)
"""
    words = printed(text)
    assert "Then ½𝐢 − (√3/2)𝐣 is the unit vector perpendicular to W, towards it" in words
    assert words.index("Take W to be at 30° anticlockwise from 𝐢.") < words.index("6 sin 30°")
    assert "and the other figure is the reflection in 𝐢" in words


def test_a_place_that_was_worked_out_as_a_vector_stays_one() -> None:
    text = """
wall C: circle centre (0, 0) radius a
sphere P: at (a/2, 0), velocity u at 90°
P hits C: e = 1/2
find time(1), position(P)
"""
    assert "position of P at the impact = (a/2)𝐢 + (√3 a/2)𝐣" in printed(text)


def test_what_an_item_has_found_of_two_letters_is_cited_in_that_form() -> None:
    text = """
wall W1: along i
wall W2: along i
sphere P: velocity u at 60° to W1
P hits W1: e = e1
P hits W2: e = e2
given angle(velocity(P), W2) = 30°
part a
find e1 e2
part b
unknown e2
find range of e1
"""
    assert "e₁e₂ = ⅓ (1)" in printed(text)


def test_where_a_body_is_at_a_wall_is_said_before_a_distance_to_it() -> None:
    text = """
wall W: along j, through (6, 0)
sphere A: mass 1, at (-4, -3), velocity 4i + 3j
sphere B: mass 3, at (0, 0), at rest
A hits B: along i, e = 2/3
B reaches W
find position(A), distance(A, B)
"""
    words = printed(text)
    place = "The position of B when B reaches W is 6𝐢 m."
    assert words.index(place) < words.index("distance between A and B when B reaches W")


def test_a_component_that_has_a_letter_is_not_said_once_more() -> None:
    text = """
sphere A: mass m, velocity u i + j
sphere B: mass m, velocity 2i - j
A hits B: along i, e = 1/2
given u > 0
show along(velocity(B), i) > 2
"""
    words = printed(text)
    assert words.count("w = (3u + 2)/4") == 1
    assert "Components along the axes" not in words
    assert "From (3) and (4): w > 2" in words
    words = printed(text.replace("i) > 2", "i) > along(velocity(A), i)"))
    assert words.count("w − v = ") == 1
    assert "Components along the axes" not in words
    assert "From (1) and (2): w > v" in words


def test_what_is_given_of_a_difference_of_angles_is_opened_by_its_formula() -> None:
    text = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
given speed(P) = 3/4 u, deflection(P) = 60°
find alpha, e
"""
    words = printed(text)
    assert "by the formulae for a difference of angles" in words
    assert "by the formulae for a sum of angles" not in words


def test_the_tangent_of_a_difference_that_the_statement_names() -> None:
    text = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
let beta = direction(A)
let delta = beta - alpha
show tan(beta) = 2 tan(alpha)
find tan(delta) in terms of alpha
"""
    words = printed(text)
    assert "By the formula for the tangent of a difference: tan δ = (tan β − tan α)" in words


def test_an_equation_of_times_between_impacts_has_no_times_from_the_start() -> None:
    """Across the walls P moves at e u sin α, and then at e² u sin α."""
    words = printed(
        "wall L: along i, through (0, 0)\nwall M: along i, through (0, d)\n"
        "sphere P: at (0, b), velocity u at alpha to L\ngiven 0 < b < d, 0 < e <= 1\n"
        "P hits L\nP hits M\nP hits L\nshow time(3) - time(2) = (time(2) - time(1))/e"
    )
    assert "t₃ − t₂ = (t₂ − t₁)/e = T/e, as T = t₂ − t₁ (as required)" in words
    assert "Putting the times together" not in words
    assert "b/(u sin α)" not in words


def test_a_bound_of_letters_stands_above_the_line_that_rests_on_it() -> None:
    words = printed(
        "wall L: along i\nwall M: along i\nsphere P: velocity u at alpha to L\n"
        "P hits L: e = e1\nP hits M: e = e2\ngiven e1 > 0, e2 > 0\n"
        "show P hits L again\nfind range of speed(P) in terms of u, alpha"
    )
    assert words.index("e₁e₂ > 0, as e₁ > 0") < words.index("So P will hit L again")
    assert words.index("u² − (speed of P)²") < words.index("e₁e₂ ≤ 1, as 0 < e₁ ≤ 1 and e₂ ≤ 1")


def test_the_product_of_a_fraction_of_a_speed_and_a_cosine_is_worked_out_once() -> None:
    words = printed(
        "sphere A: mass k m, velocity 5/4 u at alpha\nsphere B: mass m, at rest\n"
        "given cos(alpha) = 4/5\nA hits B: along i, e = 1/2\n"
        "given speed(B) = 2u/3\nfind k"
    )
    assert "component of 𝐮_A along 𝐢 = (5/4)u cos α = u" in words
    assert "kmu = km(u/6) + m(2u/3)" in words


def test_why_a_sine_less_a_cosine_is_less_than_1() -> None:
    words = printed(
        "sphere P: mass m, velocity u i\nP receives J at theta\ngiven direction(P) = 60°\n"
        "find minimum of J over theta"
    )
    assert "J > √3 mu, as sin θ − √3 cos θ < sin θ < 1 and θ is acute" in words


def test_an_answer_that_an_item_above_has_too_is_said_once_more() -> None:
    text = """
sphere P: mass 2, velocity 3i
wall W: along i
P receives 2i - 8j
find velocity(P)
P hits W: e = 1/2
find velocity(P), velocity(P, before), impulse(P)
"""
    words = printed(text)
    assert "From above: (iii) 𝐯₁ = (4𝐢 − 4𝐣) m s⁻¹ Impulse = change of momentum" in words
    # Below the line itself it is not said again.
    twice = "wall W: along i\nsphere P: mass 1, velocity 4i - 4j\nP hits W: e = 1/2\n"
    assert "From above" not in printed(twice + "find speed(P), speed(P)")


def test_what_a_later_part_asks_is_not_found_in_an_earlier_one() -> None:
    """The mass needs no line of centres, though the impulse gives that."""
    text = """
sphere A: mass 2, velocity 5i + 2j
sphere B: mass m, velocity -2i + j
A hits B
given velocity(A) = i - j, velocity(B) = 2/3 i + 3j
part a
find m
part b
find line_of_centres
"""
    words = printed(text)
    assert words.index("m = 3") < words.index("(b)") < words.index("the line of centres is")
    assert "From part (a)" not in words


def test_a_speed_of_an_earlier_part_stands_above_both_energies() -> None:
    statement = """
wall OX: along i
wall OY: along j
sphere P: mass m, velocity u at alpha to OX
P hits OX
P hits OY
part a
show velocity(P) = -e velocity(P, 0)
part b
given total_energy_lost = 7/16 energy(0)
find e
"""
    text = str(explain(solve(parse(statement))))
    _, later = text.split("(b)")
    assert later.startswith("\n\nWith 𝐯₂ from part (a):\n    speed of P = eu\nKinetic energy:"), (
        text
    )
    assert later.count("Kinetic energy:") == 1


CUSHION = """
wall W: along i
sphere A: mass m, velocity 3i - 4j
sphere B: mass 2m, at rest
A hits W: e = 1/2
A hits B: along i, e = 1/3
"""


def test_an_item_about_the_first_impact_stands_under_its_heading() -> None:
    printed_with(
        f"{CUSHION}find velocity(A), velocity(A, 1), velocity(A, before), speed(A)\n"
        "find energy_lost(1), deflection(A, 1)\n",
        (
            "First impact: A hits W",
            "(ii), (iii) 𝐯_A1 = (3𝐢 + 2𝐣) m s⁻¹",
            "(v) kinetic energy lost = ½m(4² − 2²) = 6m",
            "(vi) δ =",
            "Second impact: A hits B",
            "(i) 𝐯_A2 =",
            "(iv) speed of A",
        ),
    )


def test_what_rests_on_both_impacts_stands_below_both() -> None:
    printed_with(
        f"{CUSHION}find velocity(A), impulse(A, 2), total_energy_lost, impulse(1)\n",
        ("(iv) magnitude of the impulse =", "Second impact", "(i)", "(ii)", "(iii)"),
    )


def test_the_energy_of_all_is_that_of_the_one_who_moves() -> None:
    text = printed_with(
        f"{CUSHION}find energy(1), energy(A, 1), energy(A)\n",
        (
            "total kinetic energy after the first impact = ½m(2² + 3²) = 13m/2",
            "As B is then at rest, the total kinetic energy is that of A:",
            "kinetic energy of A after the first impact = 13m/2",
            "kinetic energy of A after the second impact = ½m((1/3)² + 2²)",
        ),
    )
    assert text.count("½m(2² + 3²)") == 1


def test_what_a_later_part_puts_in_stands_above_all_energies() -> None:
    words = printed("""
sphere A: mass 2m, velocity 2u i
sphere B: mass m, velocity -3u i
A hits B: along i
part a
find velocity(A)
part b
given e = 1/2
find energy_lost/energy(0)
""")
    whole = words.index("total kinetic energy before the impact")
    assert words.index("w = 2u") < whole < words.index("kinetic energy lost =")
    assert words.count("Kinetic energy:") == 1


def test_what_a_perfectly_elastic_wall_leaves_stands_under_the_heading_of_its_impact() -> None:
    text = """
wall AB: along i
wall BC: along 70 deg
sphere P: mass m, velocity u at 40° to AB
P hits AB: e = 1
P hits BC: e = 1
show speed(P) = u
find angle(velocity(P), AB), deflection(P, 1)
"""
    words = printed(text)
    first, second = (words.index(f"{order} impact: P hits") for order in ("First", "Second"))
    assert first < words.index("AB is perfectly elastic, so P keeps its speed") < second
    assert first < words.index("makes the same angle with it after the impact as before") < second
    assert first < words.index("(iii) angle of deflection of P at the first impact") < second
    assert second < words.index("BC is perfectly elastic, so P keeps its speed")
    assert "(i) speed of P after the second impact = u (as required) M1 A1*" in words


def test_the_time_of_an_impact_stands_under_its_heading() -> None:
    text = """
wall W: along j, through (d, 0)
sphere A, B: mass m
sphere A: at (-2d, 0), velocity 3u i
sphere B: at (0, 0), at rest
A hits B: along i, e = 1/2
B hits W: e = 1
find velocity(A), time(2)
"""
    words = printed(text)
    second = words.index("Second impact: B hits W")
    assert words.index("First impact: A hits B") < words.index("t₁ = 2d/(3u)") < second


def test_a_place_that_the_data_tell_stands_under_the_heading_of_its_impact() -> None:
    text = """
wall W: along j, through (b, 0)
sphere A: mass 2m, at (-c, 0), velocity u i
sphere B: mass m, at (0, 0), at rest
given c > 0
A hits B: along i
B hits W: e = f
B hits A: along i
find time(1), position(B, 2), position(A, 3)
"""
    words = printed(text)
    place = words.index("(ii) position of B at the second impact = b𝐢 B1")
    assert words.index("Second impact: B hits W") < place
    assert words.index("(1)") < place < words.index("Third impact")


def test_a_law_that_a_later_item_needs_does_not_stand_in_the_middle_of_another_item() -> None:
    text = """
wall W: along i, through (0, -2)
point N: (4, 3)
sphere A: mass 1, at (-6, 0), velocity 12i
sphere B: mass 1, at (0, 0), at rest
A hits B: along 4i + 3j, e = 1/3
A hits W: e = 1/2
find time(2), position(A), distance(A, B)
B reaches N
find time(3), velocity(A)
"""
    words = printed(text)
    assert words.index("(iii) distance between A and B") < words.index("component of 𝐯_A2 along 𝐣")
    assert words.index("component of 𝐯_A2 along 𝐣") < words.index("Let t₃ be the time")


def test_a_component_of_the_data_stands_above_the_impulse_that_takes_it() -> None:
    text = """
sphere A: mass 0.5, velocity 10 at theta
sphere B: mass 0.6, velocity 1 at 180°
given tan(theta) = 3/4
A hits B: along i
given impulse = 2
find e
"""
    words = printed(text)
    assert words.index("= 10 cos θ = 8 m s⁻¹") < words.index("2 = 0.5(8 − v)")


def test_an_impulse_as_a_vector_stands_where_it_is_first_used() -> None:
    text = """
sphere A: mass 2, velocity 5i + 3j
sphere B: mass 1, velocity -6i + 5j
A hits B
given velocity(A) = i + 6j
part a
find velocity(B), impulse
part b
find e
"""
    printed_with(text, ("𝐯_B = (2𝐢 − 𝐣) m s⁻¹", "impulse on A =", "magnitude of the impulse ="))


def test_a_component_that_stays_stands_behind_what_is_asked_before_it() -> None:
    # And that a sum is positive by which a product of both components is divided.
    text = """
sphere P: mass 2m, velocity u at theta
sphere Q: mass k m, at rest
P hits Q: along i
part a
find along(velocity(P), i), across(velocity(P), i), velocity(Q)
part b
given k > 2, angle(velocity(P), velocity(Q)) > 90°
find range of e
"""
    words = printed(text)
    assert words.index("(i) v =") < words.index("(ii) component of 𝐯_P along 𝐣 = u sin θ")
    assert "2 − ek < 0, as 1 + e > 0" in words


def test_the_letter_of_a_component_takes_its_value_where_that_is_put_in() -> None:
    """v = u/6 stood above tan β, which is found without it."""
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i, e = 1/3
part a
show tan(angle(velocity(A), i)) = 3(1 + k)/(3 - k) tan(alpha)
part b
given k = 1, alpha = 60°
find angle(velocity(A), i), energy(A)
"""
    words = printed(text)
    assert words.index("β = arctan(3√3)") < words.index("v = u/6") < words.index("energy of A =")
