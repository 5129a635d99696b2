"""Tangents that a part has shown are used in the next ones; the tangent of a sum may be given."""

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

SPHERES = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = {e}
let beta = angle(velocity(A), line_of_centres)
"""
WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = {e}
let beta = angle(velocity(P), W)
"""


@cache
def printed(text: str) -> str:
    problem = parse(text)
    solution = solve(problem)
    assert follow(plan(solution), Oracle(roles(problem))) == ()
    return " ".join(to_text(explain(solution)).split())


def test_a_tangent_that_was_shown_is_used_for_a_difference_that_is_given() -> None:
    said = printed(
        SPHERES.format(e="e") + "part a\nshow tan(beta) = 2 tan(alpha)/(1 - e)\n"
        "part b\ngiven e = 1/3, beta - alpha = 30°\nfind alpha\n"
    )
    assert "(b) Since e = ⅓, from (3): tan β = 3 tan α Since β − α = 30°" in said
    assert "(3 tan α − tan α)/(1 + 3 tan²α) = √3/3" in said


def test_a_given_tangent_is_put_in_itself() -> None:
    said = printed(
        WALL.format(e="e") + "part a\nshow tan(beta) = e tan(alpha)\n"
        "part b\ngiven e = 1/2, tan(alpha) = 3/4\nfind deflection(P)\n"
    )
    assert "(b) Since e = ½ and tan α = ¾, from (1): tan β = ½ × ¾ = ⅜" in said


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            WALL.format(e="1/9") + "given tan(alpha - beta) = 4/3\nfind tan(alpha)\n",
            (
                "Since tan(α − β) = 4/3, by the formula for the tangent of a difference:",
                "(tan α − 3)² = 0 tan α = 3",
            ),
        ),
        (
            SPHERES.format(e="1/3") + "given tan(beta - alpha) = 1/2\nfind tan(alpha)\n",
            ("(3 tan α − 1)(tan α − 1) = 0", "tan α = 1 or tan α = ⅓"),
        ),
        (
            WALL.format(e="e") + "given tan(alpha) = 2, tan(alpha + beta) = -7\nfind e\n",
            ("by the formula for the tangent of a sum:", "e = 9/26"),
        ),
    ],
    ids=["difference at a wall", "difference of spheres", "sum"],
)
def test_the_tangent_of_a_sum_may_be_given(text: str, lines: tuple[str, ...]) -> None:
    said = printed(text)
    for line in lines:
        assert line in said


def test_a_double_root_is_that_of_a_square() -> None:
    said = printed(SPHERES.format(e="1/3") + "given beta - alpha = 30°\nfind alpha\n")
    assert "(3 tan α − √3)² = 0 tan α = √3/3" in said
