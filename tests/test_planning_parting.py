"""Facts that leave a sense open, and ratios of angles: what several solutions share."""

from __future__ import annotations

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

WALL = """
wall W: along i
sphere P: mass 2, velocity a i - b j
P hits W: e = 3/4
given impulse = 28, speed(P) = 10
find a, b
"""
BOTH_MOVE = """
sphere A: mass 2, velocity u i + 3j
sphere B: mass 4, velocity -v i + 2j
A hits B: along i, e = 1/2
given speed(A) = 5, velocity(B) = i + 2j
find u, v
"""
FOUR = """
sphere A: mass 2, velocity a i + 3j
sphere B: mass 3, velocity b i - j
A hits B: along i, e = 1/2
given impulse = 9, speed(A) = 5
find a, b
"""
OF_TANGENTS = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 3 tan(angle(velocity(P), W)), speed(P) = 1/2 u
find e, alpha
"""


OF_A_SINE = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
let beta = angle(velocity(P), W)
given sin(alpha) = 4/5, sin(beta) = 5/13
find e
"""
OF_A_COSINE = """
wall W: along i
sphere P: velocity 13 at alpha to W
P hits W
given sin(alpha) = 12/13, cos(angle(velocity(P), W)) = 4/5
find e
"""


def printed(text: str) -> str:
    solution = solve(parse(text))
    derivation = plan(solution)  # raises where a line is not written out
    assert [str(each) for each in follow(derivation, Oracle(roles(solution.problem)))] == []
    return " ".join(to_text(explain(solution), 100).split())


def test_the_square_of_an_impulse_leaves_its_sense_open() -> None:
    working = printed(WALL)
    assert "28² = (2(3b/4 + b))² = 49b²/4" in working
    assert "b = 8 or b = −8" in working
    for case in ("If b = 8:", "If b = −8:"):
        assert "a = 8 or a = −8" in working.split(case)[1].split("If ")[0]


def test_a_speed_of_one_open_component_comes_first_where_both_senses_lead_on() -> None:
    working = printed(BOTH_MOVE)
    assert "5² = w² + 3² M1 w² = 16 w = ±4" in working
    first, second = working.split("If w = −4:")[1].split("If w = 4:")
    assert "u = 6" in first
    assert "v = 4" in first
    assert "u = −2" in second
    assert "v = −4" in second


def test_solutions_part_twice() -> None:
    working = printed(FOUR)
    assert working.count("If v = ") == 2
    assert "9² = (2(a − 4))² = 4(a − 4)²" in working
    assert "9² = (2(a + 4))² = 4(a + 4)²" in working


def test_a_relation_of_tangents_takes_a_line_of_each() -> None:
    working = printed(OF_TANGENTS)
    assert "tan β = eu sin α/(u cos α) = e tan α" in working
    assert "Since tan α = 3 tan β: tan α = 3e tan α DM1 e = ⅓" in working


def test_a_sine_or_cosine_of_an_angle_after_gives_its_tangent() -> None:
    assert "sin β = 5/13 tan β = 5/12" in printed(OF_A_SINE)
    assert "5/12 = (4eu/5)/(3u/5) = 4e/3 DM1 e = 5/16" in printed(OF_A_SINE)
    working = printed(OF_A_COSINE)
    assert "Let β be the angle between 𝐯_P and W." in working
    assert "tan β = ¾" in working


def test_cases_end_with_what_they_come_to() -> None:
    assert printed(BOTH_MOVE).endswith("So u = 6 and v = 4, or u = −2 and v = −4.")
    masses = """
sphere A: mass m, velocity 4u at 60°
sphere B: mass n m, velocity -3/2 u i
A hits B: along i
given direction(A) = 120°, speed(B) = 1/2 u
find n, e
"""
    assert printed(masses).endswith(
        "So n = 2 and e = 5/7, or n = 4 and e = 3/7. Both are possible, as 0 ≤ e ≤ 1."
    )
