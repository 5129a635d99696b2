"""Steps between a formula and what comes of it: sums of angles, half angles, roots below a line."""

from __future__ import annotations

from functools import cache

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

TURNED_AT_A_WALL = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
given speed(P) = 60% u, deflection(P) = 60°
find alpha, e
"""

BLOWN_ALONG_A_WALL = """
wall W: along 60°
sphere P: mass 2, velocity 4i
P receives J at theta
given J = 8, velocity(P) parallel to W, 0 < theta < 180°
find theta
"""

SHARES_WITH_ROOTS = """
sphere A: mass 2m, velocity 3u at 60°
sphere B: mass m, velocity 2u at 30° from -i
A hits B: along i, e = 2/3
find energy(B)/energy
"""

CORNER = """
wall AB: along i
wall BC: along 75°
sphere P: velocity u at 60° to AB
P hits AB: e = 2/5
P hits BC: e = 1/2
find speed(P)
"""


TWO_AT_RIGHT_ANGLES = """
sphere A: mass m, velocity u at theta
sphere B: mass m, velocity u at theta + 90°
A hits B: along i, e = 1/2
show energy_lost = 3/16 m u^2 (1 + sin(2theta))
"""
BACK_FROM_A_WALL = """
wall W: along j
sphere A: mass 2 m, velocity 2 u i
sphere B: mass m, at rest
A hits B: along i, e = e
B hits W: e = f
show A and B collide again
"""


TURNED_BACK_AT_A_WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given deflection(P) = 90°
show tan^2(alpha) = 1/e
show energy_lost/energy(0) = 1 - e
"""
SQUARE_OF_A_SPEED = """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
given deflection(A) = 90°
find speed(A)^2 in terms of u, e
"""


@cache
def working(text: str) -> str:
    """A printed working, every line of which the follower accepts, with single spaces."""
    solution = solve(parse(text))
    assert follow(plan(solution), Oracle(roles(solution.problem))) == ()
    return " ".join(to_text(explain(solution), 80).split())


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (TURNED_AT_A_WALL, "u cos α = 0.6u(½ cos α + (√3/2) sin α) DM1"),
        (TURNED_AT_A_WALL, "eu sin α = 0.6u((√3/2) cos α − ½ sin α) DM1"),
        (BLOWN_ALONG_A_WALL, "By the formula tan(θ/2) = sin θ/(1 + cos θ):"),
        (CORNER, "= (u/2) sin 75° − (√3 u/5) cos 75° ≈ "),
        (TWO_AT_RIGHT_ANGLES, "= 3mu²(cos²θ + 2 sin θ cos θ + sin²θ)/16"),
        (BACK_FROM_A_WALL, "v > 0, as e ≤ 1 (4)"),
        (BACK_FROM_A_WALL, "component of 𝐯_B along 𝐢 ≤ 0, as e ≥ 0 and f ≥ 0 (5)"),
        (TURNED_BACK_AT_A_WALL, "= (u²/(1 + e) − e²u²/(1 + e))/u² = 1 − e (as required)"),
        (SQUARE_OF_A_SPEED, "= (1 − 3e)²u²/(12(1 + e)) + (3e − 1)u²/(3(1 + e)) = (3e − 1)u²/4"),
        (SHARES_WITH_ROOTS, "= 2(103 + 10√3)/(3(361 − 20√3)) ≈ 0.246"),
    ],
)
def test_a_step_is_seen(text: str, line: str) -> None:
    assert line in working(text)
