"""The order in which a printed working says things: a reason before what rests on it."""

from __future__ import annotations

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
    assert words.count("It is given that 𝐯_A = −½𝐮_A.") == 1
    assert words.index("It is given that") < words.index("the line of centres is parallel to")


def test_that_a_body_moves_through_the_centre_has_its_reason_once() -> None:
    text = """
wall C: circle centre (0, 0) radius 10
sphere P: at (6, 8), velocity -3i - 4j
P hits C: e = 1/2
P hits C: e = 1/2
find time(2), velocity(P)
"""
    words = printed(text)
    reason = "The component towards C is the whole speed, so P moves through the centre:"
    assert words.count(reason) == 1
    assert words.count("A chord makes equal angles with the radii at its ends:") == 1
    assert words.index(reason) < words.index(" P moves through the centre: ")
