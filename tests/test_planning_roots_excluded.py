"""A root goes with its reason, and a condition with the value on which it rests."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

BY_ANOTHER_SPEED = """
sphere P: mass m, velocity u i
sphere Q: mass 2m, at rest
P hits Q: along i
given speed(P) = 1/6 u, speed(Q) > 1/2 u
find e
"""
BY_BOTH_SENSES = """
sphere A: mass 2m, velocity 4u i
sphere B: mass 3m, velocity -u i
A hits B: along i
given speed(B) = 2 speed(A), velocity(A) opposite to velocity(B)
find e
"""
OF_A_COEFFICIENT = """
sphere A: mass 2, velocity 5i
sphere B: mass M, velocity i + j
A hits B: along i
given velocity(A) = 2i
find velocity(B)
find e
"""
OF_A_RATIO = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
given angle(velocity(P), W) < 30°
find range of tan(alpha)
"""


def printed(text: str) -> str:
    return re.sub(r"\s+", " ", to_text(explain(solve(parse(text))), 200))


def test_a_given_speed_excludes_a_root() -> None:
    working = printed(BY_ANOTHER_SPEED)
    assert "e = ¾ or e = ¼" in working
    assert "e = ¾, as the speed of Q is more than ½u and speed of Q = (1 + e)u/3" in working


def test_two_senses_exclude_a_root() -> None:
    working = printed(BY_BOTH_SENSES)
    assert "e = ¾ or e = ⅛" in working
    assert "as A moves in the direction of −𝐯_B, v = (1 − 3e)u and w = (1 + 2e)u" in working


@pytest.mark.parametrize("asked", [OF_A_COEFFICIENT, OF_A_COEFFICIENT.replace("find e\n", "")])
def test_a_condition_has_the_coefficient_on_which_it_rests(asked: str) -> None:
    working = printed(asked)
    assert "As 0 ≤ e = (6 − M)/(4M) ≤ 1, this holds for 6/5 ≤ M ≤ 6 only." in working
    assert working.count("this holds") == 1


def test_the_range_of_a_ratio_has_a_form_where_its_end_has_no_value() -> None:
    ((_, item),) = solve(parse(OF_A_RATIO)).items()
    assert [each.display for each in item.answers] == [
        "tan α > 0, for e = 0",
        "0 < tan α < 1/(√3 e), for e > 0",
    ]


OFF_FROM_REST = """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, at rest
A hits B: along i
given energy(B) = 1/9 m u^2
find e
"""
FROM_ACROSS = """
sphere A: mass 2, velocity 5i + 3j
sphere B: mass 1, velocity 2j
A hits B: along i
given speed(B) = 2 sqrt(5)
find e
"""


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (OFF_FROM_REST, "w = u/3, as B was at rest and is pushed away from A"),
        (
            FROM_ACROSS,
            "w = 4 m s⁻¹, as B had no component along the line of centres and is pushed away from",
        ),
    ],
)
def test_who_had_no_component_is_pushed_away(text: str, reason: str) -> None:
    assert reason in printed(text)
    solution = solve(parse(text))
    derivation, oracle = plan(solution), Oracle(roles(solution.problem))
    assert follow(derivation, oracle) == ()
    (rejection,) = (each for each in derivation.lines if each.move.id == "reject")
    base = derivation.line(rejection.premises[0])  # type: ignore[arg-type]
    assert base is not None
    (other,) = (each for each in base.relation.options if each not in rejection.relation.options)  # type: ignore[union-attr]
    turned = replace(rejection, relation=Relation((other,)))
    lines = tuple(turned if each is rejection else each for each in derivation.lines)
    complaints = follow(replace(derivation, lines=lines), oracle)
    assert any(each.line == rejection.number for each in complaints)
