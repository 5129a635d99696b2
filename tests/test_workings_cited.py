"""What a working cites, and the letters that it shares with its question."""

from __future__ import annotations

from functools import cache

from restitution.language import parse
from restitution.solving import solve
from restitution.wording import question
from restitution.wording.document import to_text as to_words
from restitution.workings import explain, to_html, to_latex, to_markdown, to_text

# The speed of B is found in letters first; each part has values of its own.
IN_PARTS = """
sphere A: mass m, velocity 3u at alpha
sphere B: mass 2m, at rest
A hits B: along i
find speed(B)
part a
given energy_lost = 1/8 energy(0), cos(alpha) = 3/5
find e
"""
# v is the component of A in the working; what the question asks for is the speed of B.
A_SPEED_IN_A_RATIO = """
sphere A: mass 3m, velocity u i
sphere B: mass 2m, at rest
A hits B: along i, e = 1/4
find velocity(A), speed(B)/u
"""
A_SECOND_IMPACT = """
sphere A: mass 4m, velocity u i
sphere B: mass m, at rest
wall W: along j
A hits B: along i, e = 3/4
part a
find velocity(A), velocity(B)
part b
B hits W: e = 1/2
A hits B: along i, e = 3/4
find velocity(A)
"""
TURNED_AT_A_WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/2
find maximum of alpha - angle(velocity(P), W) over alpha
"""


@cache
def printed(text: str) -> str:
    return " ".join(to_text(explain(solve(parse(text)))).split())


@cache
def asked(text: str) -> str:
    return " ".join(to_words(question(parse(text))).split())


def test_a_value_of_another_part_is_cited_by_its_number() -> None:
    said = printed(IN_PARTS)
    assert "Since cos α = ⅗, substituting for w in (1): m(3u × ⅗) = mv + 2m(3(1" in said
    assert "From above" not in said


def test_a_letter_of_the_question_denotes_nothing_else_in_the_working() -> None:
    assert "V/u, where V is the speed of B" in asked(A_SPEED_IN_A_RATIO)
    assert "Let v and w be the components of the velocities of A and B" in printed(
        A_SPEED_IN_A_RATIO
    )


def test_an_angle_has_one_letter_in_the_question_and_in_the_working() -> None:
    assert "where β is the angle that the direction of motion of P" in asked(TURNED_AT_A_WALL)
    assert "Let β be the angle between 𝐯_P and W" in printed(TURNED_AT_A_WALL)


def test_a_unit_vector_that_was_found_is_named_and_not_written_again() -> None:
    said = printed(
        """
sphere A: mass 2, velocity 3i + j
sphere B: mass 3, at rest
A hits B
given velocity(A) = i - j
find line_of_centres, e
"""
    )
    assert "unit vector along the line of centres = (𝐢 + 𝐣)/√2" in said
    assert "Let 𝐧 be that unit vector along the line of centres." in said
    assert said.count("(𝐢 + 𝐣)/√2") == 1


def test_what_is_put_in_beside_a_letter_is_named_by_its_letter_too() -> None:
    said = printed(
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 4m, at rest
A hits B: along i
part a
find speed(B)
part b
given direction(A) = 90°
find e
"""
    )
    assert "Substituting for w from part (a) and v in (1): mu cos α = 4m(⅕(1 + e)u cos α)" in said


def test_values_of_another_part_are_named_where_they_are_put_in() -> None:
    said = printed(
        """
sphere A: mass m, velocity 4u i
sphere B: mass k m, velocity -u i
A hits B: along i, e = 1/5
part a
given velocity(A) in the direction of -i
find range of k
part b
given velocity(B) in the direction of -i
find range of k
part c
find velocity(A), velocity(B), energy(A)
"""
    )
    assert said.count("v = 2(2 − k)u/(1 + k)") == 1
    assert "(b) Substituting for v from part (a) in (2): w − 2(2 − k)u/(1 + k) =" in said
    assert "With v from part (a): 𝐯_A = (2(2 − k)u/(1" in said
    assert "With w from part (b): 𝐯_B = ((5 − k)u/(1" in said
    assert "From part" not in said and said.count("from part (a)") == 2


def test_a_source_stands_in_each_form_behind_the_name_of_the_law() -> None:
    working = explain(solve(parse(A_SECOND_IMPACT)))
    named = "Conservation of momentum along the line of centres"
    assert f"{named}, with v₁ from part (a):" in " ".join(to_text(working).split())
    assert f"*{named}*, with $v_{{1}}$ from part (a):" in to_markdown(working)
    assert rf"\emph{{{named}}}, with $v_{{1}}$ from part (a):" in to_latex(working)
    assert f"<i>{named}</i>, with" in to_html(working)
    steps = [each for part in working.parts for each in part.steps if each.source is not None]
    assert [(each.principle, each.sign) for each in steps] == [
        ("Newton's experimental law", ","),
        (named, ","),
    ]


def test_both_components_of_a_velocity_are_named_together() -> None:
    said = printed(
        """
wall X: along i
wall Y: along 45°
sphere P: mass m, velocity u at alpha to X
given tan(alpha) = 4/3
part a
P hits X: e = 1/2
find speed(P)
part b
P hits Y: e = 1/2
find speed(P)
"""
    )
    assert "Components before the impact, with the components of 𝐯₁ from part (a):" in said


def test_a_speed_in_letters_takes_the_values_that_are_found() -> None:
    said = printed(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "given tan(alpha) = 2\npart a\nfind speed(P)\n"
        "part b\ngiven energy_lost = 1/2 energy(0)\nfind e, speed(P)\n"
    )
    assert "Substituting in (1): speed of P = √2 u/2 ≈ 0.707u" in said


def test_an_angle_to_a_wall_whose_tangent_is_given_is_not_found_again() -> None:
    said = printed(
        "wall W: along i\nsphere P: mass m, velocity 3 at alpha to W\nP hits W: e = 4/5\n"
        "given tan(angle(velocity(P), W)) = 3/2\nfind deflection(P)\n"
    )
    assert "It is given that the tangent of the angle between 𝐯_P and W is 3/2:" in said
    assert "δ = arctan(15/8) + arctan(3/2)" in said
    assert "It is given that tan β = 3/2 Let δ" in said  # what is quoted earns nothing


def test_a_ratio_that_is_given_is_said_where_its_number_is_first_used() -> None:
    said = printed(
        """
sphere A: mass m, velocity 5u at alpha
sphere B: mass 2m, at rest
A hits B: along i
given cos(alpha) = 3/5, direction(A) = 90°
find e, energy_lost
"""
    )
    first = "e = ½ A1 It is given that cos α = ⅗: component of 𝐮_A along 𝐢 = 5u cos α = 3u"
    assert first in said  # below the laws, which keep it
    assert "Since cos α = ⅗, from (1): w = 3u/2" in said


def test_a_unit_vector_to_a_wall_that_was_found_is_not_written_again() -> None:
    said = printed(
        "wall W\nsphere P: mass 2, velocity 7i + j\nP hits W\ngiven velocity(P) = 3i + 5j\n"
        "find line_of_centres, e, impulse\n"
    )
    assert "𝐮_P · (𝐢 − 𝐣) = 7 − 1 = 6" in said
    assert said.count("(𝐢 − 𝐣)/√2") == 1


def test_a_negative_loss_is_said_to_be_a_gain() -> None:
    blow = "sphere P: mass 2, velocity i\nP receives 6i\nfind energy_lost\n"
    assert "= −15 J (kinetic energy is gained)" in printed(blow)
    assert "gained" not in printed(blow.replace("6i", "-3i"))


def test_two_equal_quantities_cite_both_their_lines_and_what_makes_them_one() -> None:
    text = """
    sphere A, B: mass m
    sphere A: velocity u at alpha
    sphere B: velocity u at alpha from -i
    A hits B: along i, e = 1/2
    show deflection(A) = deflection(B)
    """
    working = to_text(explain(solve(parse(text)), marks="none"))
    assert "φ = 180° − α − θ   (5)" in working
    assert "From (4), (5) and (6):\n    δ = φ" in working
