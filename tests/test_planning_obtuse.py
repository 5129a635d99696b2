"""Angles between velocities that may be obtuse: their ranges and extremes, by the cosine."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles

HEAVIER = """
sphere A: mass m, velocity u at {angle}
sphere B: mass {mass}, at rest
A hits B: along i
"""


def working(text: str) -> tuple[Derivation, list[str]]:
    """The working of a statement, which the follower accepts, and what its lines say."""
    problem = parse(text)
    derivation = plan(solve(problem))
    assert [str(each) for each in follow(derivation, Oracle(roles(problem)))] == []
    return derivation, [
        write_relation(each.relation)
        for each in derivation.lines
        if isinstance(each.relation, Relation)
    ]


def test_the_range_of_a_deflection_past_a_right_angle() -> None:
    # A keeps (1 - 5e)/6 of its component: it leaves at 73.9° to 139.1° from i, and came at 30°.
    _, lines = working(HEAVIER.format(angle="30°", mass="5m") + "find range of deflection(A)\n")
    assert not any("tan(delta)" in each or "cot(delta)" in each for each in lines)
    (low, high) = "60° - arctan(sqrt(3)/6)", "60° + arctan(2sqrt(3)/3)"
    assert lines[-1] == f"{low} <= deflection(A, 1) <= {high}"
    assert round(60 - math.degrees(math.atan(3**0.5 / 6)), 1) == 43.9
    assert round(60 + math.degrees(math.atan(2 / 3**0.5)), 1) == 109.1


ANGLE = "angle(velocity(A), velocity(B)) over e"
EXTREMES = (
    HEAVIER.format(angle="45°", mass="3m") + f"find maximum of {ANGLE}\nfind minimum of {ANGLE}\n"
)


def test_the_greatest_and_the_least_angle_between_velocities() -> None:
    derivation, _ = working(EXTREMES)
    assert [write_relation(each.answer) for each in derivation.items] == [
        "angle(velocity(A, 1), velocity(B, 1)) <= 180° - arctan(2)",
        "angle(velocity(A, 1), velocity(B, 1)) >= arctan(4)",
    ]


def test_an_obtuse_angle_has_no_least_value_where_it_is_only_approached() -> None:
    text = HEAVIER.format(angle="alpha", mass="3m").replace("along i", "along i, e = 1/2")
    _, lines = working(text + "find minimum of angle(velocity(A), velocity(B)) over alpha\n")
    assert lines[-1] == "angle(velocity(A, 1), velocity(B, 1)) > 90°"


@pytest.mark.parametrize("wrong", ["180° - arctan(3)", "90°", "arccos(-2/sqrt(5))"])
def test_a_greatest_angle_that_is_another_is_refused(wrong: str) -> None:
    problem = parse(EXTREMES)
    derivation, _ = working(EXTREMES)
    end = derivation.items[0]
    line = derivation.line(end.line)
    names = {"A": "sphere", "B": "sphere"}
    relation = read_relation(f"angle(velocity(A, 1), velocity(B, 1)) <= {wrong}", names)
    lines = tuple(
        replace(each, relation=relation)
        if each.number in (line.number, *line.premises[:1])
        else each
        for each in derivation.lines
    )
    items = (replace(end, answer=relation), *derivation.items[1:])
    other = replace(derivation, lines=lines, items=items)
    assert follow(other, Oracle(roles(problem)))
