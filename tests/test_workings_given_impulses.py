"""An impulse that is given tells the velocity after an impact: the coefficient comes of that."""

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


def test_the_component_after_a_wall_comes_of_the_impulse_and_the_coefficient_of_both() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass 3, velocity 2i - 4j\nP hits W\ngiven impulse = 18\n"
        "part a\nfind velocity(P)\npart b\nfind e"
    )
    assert "18 = 3(v + 4) M1 A1 v = 2 m s⁻¹" in text
    assert "2 = 4e M1 A1ft e = ½" in text


def test_an_impulse_of_a_given_size_is_along_the_line_and_changes_the_velocity() -> None:
    text = printed(
        "wall W: along 3i - 4j\nsphere P: mass 3, velocity 4i + 5j\nP hits W\n"
        "given impulse = 30\nfind impulse(P), velocity(P)"
    )
    assert "The impulse on P is perpendicular to W, away from it:" in text
    assert "= (−24𝐢 − 18𝐣) N s" in text
    assert "3(𝐯_P − (4𝐢 + 5𝐣))" in text
    assert "31" not in text


def test_the_impulse_on_the_other_sphere_is_opposite_and_decimals_stay_decimals() -> None:
    text = printed(
        "sphere A: mass 2, velocity 5i + 2j\nsphere B: mass 4, velocity -i + j\n"
        "A hits B: along 3i - 4j\ngiven impulse = 4\n"
        "find impulse(B), impulse(A), velocity(A), velocity(B)"
    )
    assert "The impulse on B is along the line of centres, away from the other sphere:" in text
    assert "The impulses on the two spheres are equal and opposite:" in text
    assert "𝐯_A = (3.8𝐢 + 3.6𝐣) m s⁻¹" in text
    assert "𝐯_B = (−0.4𝐢 + 0.2𝐣) m s⁻¹" in text


def test_where_the_coefficient_is_asked_first_it_comes_first() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "given impulse = 3/2 m u sin(alpha)\nfind e, velocity(P)"
    )
    assert "eu sin α" in text
    assert "e = ½" in text


def test_the_component_that_is_used_later_is_named_and_not_the_vector_made_of_it() -> None:
    text = printed(
        "sphere A: mass 2, velocity 5i + 2j\nsphere B: mass 4, velocity -i + j\n"
        "A hits B: along 3i - 4j\ngiven impulse = 6\npart a\nfind velocity(A), velocity(B)\n"
        "part b\nfind e"
    )
    assert "Newton's experimental law, with 𝐮_A · 𝐧 and v = −8/5 m s⁻¹ from part (a):" in text


def test_a_line_that_is_typed_against_the_approach_turns_no_impulse() -> None:
    text = printed(
        "sphere A: mass 2, velocity 5i + 2j\nsphere B: mass 4, velocity -i + j\n"
        "A hits B: along -3i + 4j\ngiven impulse = 5\nfind impulse(A)"
    )
    assert "= (−3𝐢 + 4𝐣) N s" in text
