"""An angle between two velocities that is given, by their scalar product and both speeds."""

from __future__ import annotations

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

MIRRORED = """
sphere A, B: mass m
sphere A: velocity 3i + 4j
sphere B: velocity -3i + 4j
A hits B: along i
given angle(velocity(A), velocity(B)) = {angle}
find e
"""


def text_of(statement: str) -> str:
    problem = parse(statement)
    solution = solve(problem)
    assert follow(plan(solution), Oracle(roles(problem))) == ()
    return to_text(explain(solution), 80)


def test_equal_speeds_are_divided_by_in_the_scalar_product() -> None:
    text = text_of(MIRRORED.format(angle="60°"))
    assert "is 60°. By the scalar product:" in text
    assert "cos 60° = (−3e × 3e + 4 × 4)/((3e)² + 4²) = (16 − 9e²)/(16 + 9e²)" in text
    assert "if e = 0" not in text


def test_the_cosine_of_an_angle_told_by_its_tangent_is_said() -> None:
    text = text_of(MIRRORED.format(angle="arctan(4/3)"))
    assert "is arctan(4/3), of which the\ncosine is ⅗. By the scalar product:" in text
    assert "tan" not in text.partition("By the scalar product:")[2]


OFFSET = """
sphere A: mass m, radius 5, velocity u i
sphere B: mass m, radius 5, at rest
A hits B: offset d, e = 1/2
given angle(line_of_centres, i) = arcsin(3/5)
find d
"""


def test_the_sine_of_an_offset_is_no_cosine_of_that_angle() -> None:
    text = text_of(OFFSET)
    assert "scalar product" not in text
    assert "of which the cosine" not in text
