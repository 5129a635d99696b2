"""What the facts give is taken from them, and is not found again."""

from __future__ import annotations

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

WALL = """
wall W: along i
sphere P: mass 0.3, velocity 6 at 70° to W
P hits W
given angle(velocity(P), W) = 55°
find e, deflection(P)
"""

DOUBLE = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given angle(velocity(A), {line}) = 2*alpha
show tan^2(alpha) = e
find deflection(A)
"""

DEGREES = """
sphere A: mass 3, velocity 8 at 30°
sphere B: mass 2, at rest
A hits B: along i
given angle(velocity(A), {line}) = 50°
find e, deflection(A)
"""

RATIO = """
wall W: along j
sphere P: mass m, velocity u at theta to W
P hits W: e = 2/3
find energy(P)/energy(P, 0)
given energy(P) = 3/4 energy(P, 0)
find sin(theta)
"""

SPEED = """
wall W: along j
sphere P: mass m, velocity u at theta to W
P hits W: e = 2/3
find speed(P)
given speed(P) = 3/4 u
find sin(theta)
"""

COMPONENT = """
sphere A: mass 3m, velocity u at 45°
sphere B: mass m, at rest
A hits B: along i, e = 1/2
given speed(B) = 9
find u, speed(A)
"""


def worked(text: str) -> str:
    """The working of a statement, which the follower accepts."""
    solution = solve(parse(text))
    assert follow(plan(solution), Oracle(roles(solution.problem))) == ()
    return to_text(explain(solution), 80)


def test_a_given_angle_to_a_wall_is_a_term_of_the_deflection() -> None:
    printed = worked(WALL)
    assert "= 70° + 55° = 125°" in printed
    assert "tan β" not in printed


@pytest.mark.parametrize("line", ["line_of_centres", "i"])
def test_a_given_angle_in_letters_is_a_term_of_the_deflection(line: str) -> None:
    printed = worked(DOUBLE.format(line=line))
    assert "δ = 2α − α = α" in printed
    assert "tan δ" not in printed


@pytest.mark.parametrize("line", ["line_of_centres", "i"])
def test_a_given_angle_in_degrees_is_a_term_of_the_deflection(line: str) -> None:
    printed = worked(DEGREES.format(line=line))
    assert "δ = 50° − 30° = 20°" in printed
    assert "tan β" not in printed


@pytest.mark.parametrize(
    ("text", "in_letters"),
    [
        (RATIO, "= 1 − (5/9) sin²θ"),
        (SPEED, "= u√(9 − 5 sin²θ)/3"),
    ],
)
def test_what_is_asked_above_the_fact_that_gives_it_is_not_worked_out_from_it(
    text: str, in_letters: str
) -> None:
    above, below = worked(text).split("It is given that")
    (line,) = (each for each in above.splitlines() if in_letters in each)
    assert line.endswith("A1")
    assert "Substituting in (1)" not in below


def test_a_component_that_a_fact_gives_is_not_worked_out_again() -> None:
    printed = worked(COMPONENT)
    assert printed.count("w = 9 m") == 1
    assert "9 − v = ½u cos 45°" in printed
    assert "v = 5 m" in printed


@pytest.mark.parametrize(
    ("data", "tangent"),
    [
        ("velocity 10 at 30° to W\nP hits W\ngiven speed(P) = 9", "tan β = √6/(5√3) = √2/5"),
        (
            "velocity 6 at 60° to W\nP hits W\ngiven angle(velocity(P), j) = 60°",
            "tan 60° = 3/(3√3 e)",
        ),
    ],
)
def test_a_tangent_is_a_quotient_of_components_before_it_is_cancelled(
    data: str, tangent: str
) -> None:
    asked = "find e, angle(velocity(P), W)"
    assert tangent in worked(f"wall W: along i\nsphere P: mass 2, {data}\n{asked}\n")
