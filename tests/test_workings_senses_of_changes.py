"""A line of centres by a change of velocity: what that comes to, and why it has its sense."""

from __future__ import annotations

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

SPHERES = """
sphere A: mass 1, velocity 6i - 5j
sphere B: mass 2, velocity -i - 6j
A hits B
given velocity({body}) = {after}
find line_of_centres, e
"""

WALL = """
wall W
sphere P: mass 2, velocity 5i + 10j
P hits W
given velocity(P) = -2i + 11j
find direction(W), e
"""


def text_of(statement: str) -> str:
    return to_text(explain(solve(parse(statement))), 80)


def test_the_first_sphere_is_pushed_away_from_the_second() -> None:
    text = " ".join(text_of(SPHERES.format(body="A", after="3i - 9j")).split())
    assert (
        "= −3𝐢 − 4𝐣 M1 The impulse on A acts away from B, and the direction from A to B "
        "is opposite to it: the direction from A to B is that of 3𝐢 + 4𝐣"
    ) in text


def test_the_second_sphere_is_pushed_in_the_sense_of_the_line() -> None:
    text = text_of(SPHERES.format(body="B", after="1/2 i - 4j"))
    assert (
        "The impulse on B acts in the direction from A to B:\n    the direction from A to B is"
        in text
    )
    assert "−3𝐢 − 4𝐣" not in text


def test_a_wall_pushes_away_from_it() -> None:
    text = text_of(WALL)
    assert (
        "= −7𝐢 + 𝐣         M1\nThe impulse on P acts away from W, and the normal towards W is"
        in text
    )


def test_a_line_of_centres_stands_in_the_part_that_needs_it() -> None:
    text = text_of(
        "sphere A: mass 4, velocity 3i - j\nsphere B: mass 2, velocity i + 3j\nA hits B\n"
        "given velocity(A) = 2i\npart a\nfind velocity(B)\npart b\nfind e\n"
    )
    first, second = text.split("\n(b)\n")
    assert "𝐯_B = (3𝐢 + 𝐣)" in first
    assert "line of centres" not in first
    assert "The impulse, and so the change of velocity, is along the line of centres:" in second


SLANTING = """
wall W: along 3i + 4j
sphere P: mass 2, velocity 7i + j
P hits W: e = 3/5
find velocity(P), across(velocity(P, before), W), across(velocity(P), W), line_of_centres
"""


def test_a_normal_that_is_asked_stands_before_the_unit_vector_along_it() -> None:
    text = text_of(SLANTING)
    normal = "Since W is parallel to 3𝐢 + 4𝐣:\n      the normal to W is parallel to 4𝐢 − 3𝐣"
    assert text.index(normal) < text.index("Let 𝐧 be that unit vector perpendicular to W")
    assert text.count("the normal to W") == 1


def test_a_component_in_the_other_sense_is_that_with_the_unit_vector() -> None:
    text = " ".join(text_of(SLANTING).split())
    assert "in the direction of −4𝐢 + 3𝐣 = −𝐮_P · 𝐧 = −5 m s⁻¹" in text
    assert "in the direction of −4𝐢 + 3𝐣 = −𝐯_P · 𝐧 = 3 m s⁻¹" in text


def test_a_letter_of_which_the_sign_is_open_leaves_a_change_its_sense() -> None:
    text = text_of(
        "sphere A: mass 3, velocity 2i + 4j\nsphere B: mass 2, velocity -3i - j\n"
        "A hits B: e = 1/2\ngiven velocity(B) parallel to j\nfind velocity(A), line_of_centres\n"
    )
    assert (
        "The impulse on B acts in the direction from A to B:\n"
        "    the direction from A to B is that of 3𝐢 + (s + 1)𝐣"
    ) in text
    assert "approach each other along" not in text


def test_a_direction_that_is_shortened_is_told_by_its_sense_once() -> None:
    text = text_of(
        "sphere P: mass 4, velocity 9i\nsphere Q: mass 2, velocity i + 3j\nP hits Q\n"
        "given velocity(Q) = 7i + 6j\nfind e\n"
    )
    assert "is parallel to (7𝐢 + 6𝐣) − (𝐢 + 3𝐣) = 6𝐢 + 3𝐣" in text
    assert text.count("the direction from P to Q is that of") == 1
    assert "the direction from P to Q is that of 2𝐢 + 𝐣" in text


def test_a_change_of_whole_velocities_is_not_called_one_along_the_line() -> None:
    text = text_of(
        "sphere A: mass 3, velocity 4i + j\nsphere B: mass m, velocity -2i + j\n"
        "A hits B: along i, e = 1/3\ngiven velocity(A) parallel to j\nfind m, impulse(A)\n"
    )
    assert "Impulse = change of momentum of A:\n" in text
    assert "change of momentum of A along" not in text


def test_an_impulse_of_a_later_part_needs_no_line_of_centres() -> None:
    statement = """
wall W
sphere P: mass 2, velocity 4i + 2j
P hits W
given velocity(P) = 4j
part a
find direction(W), e
part b
find impulse(P)
"""
    assert "impulse on P = 2(4𝐣 − (4𝐢 + 2𝐣))" in " ".join(text_of(statement).split())
