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
    text = text_of(SPHERES.format(body="A", after="3i - 9j"))
    assert "is parallel to −3𝐢 − 4𝐣\nThe impulse on A is away from B, so in the sense from" in text
    assert "from A to B:\n    the line of centres is parallel to 3𝐢 + 4𝐣" in text


def test_the_second_sphere_is_pushed_in_the_sense_of_the_line() -> None:
    text = text_of(SPHERES.format(body="B", after="1/2 i - 4j"))
    assert "The impulse on B is away from A, so in the sense from A to B:" in text
    assert "−3𝐢 − 4𝐣" not in text


def test_a_wall_pushes_away_from_it() -> None:
    text = text_of(WALL)
    assert "is parallel to −7𝐢 + 𝐣\nThe impulse on P is away from W, so in the sense tow" in text
