"""The stages of a statement, as `restitution trace` prints them."""

from __future__ import annotations

import re

import pytest

from restitution.explaining.following.follower import follow
from restitution.export.trace import trace
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.planning.writing.desk import NotPlannedError
from restitution.solving import solve
from restitution.solving.story.letters import roles

STATEMENT = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
part a
given deflection(P) = 90°
find e in terms of alpha
part b
show speed(P) <= u
"""


def test_the_tree_has_every_body_and_step_with_the_events_before_it() -> None:
    lines = trace(parse(STATEMENT), "tree").splitlines()
    assert lines[:2] == ["Sphere P", "    mass: Letter m"]
    assert "    Impact P W" in lines
    assert "part a, events so far: 1" in lines
    assert "    Find in_terms_of alpha" in lines


def test_the_equations_of_a_part_hold_its_facts_and_those_before_the_parts() -> None:
    whole = trace(parse(STATEMENT), "equations")
    shared, first, second = re.split(r"^part [ab]:$", whole, flags=re.MULTILINE)
    assert "e ≥ 0" in shared and "e ≥ 0" in first
    fact = "eu² sin²α − u² cos²α = 0   (a fact, line 6)"
    assert fact in first and fact not in second
    assert "e: restitution; unknown" in first
    assert "velocity of P after event 1: (u cos α, eu sin α)" in second


def test_the_derivation_has_each_line_with_its_move_and_premises() -> None:
    problem = parse(STATEMENT)
    derivation = plan(solve(problem))
    assert not follow(derivation, Oracle(roles(problem)))
    lines = trace(problem, "derivation").splitlines()
    numbered = [each for each in lines if re.match(r"\d+\. ", each)]
    assert len(numbered) == len(derivation.lines)
    assert numbered[0].endswith("[law unchanged 1 P; from velocity P, wall W, axis 1]")
    assert any(each.startswith("a1: e = ") for each in lines)


def test_an_item_without_a_plan_has_its_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    def unplanned(solution: object) -> None:
        raise NotPlannedError("a story of many events")

    monkeypatch.setattr("restitution.planning.planner._require_plain", unplanned)
    last = trace(parse(STATEMENT), "derivation").splitlines()[-1]
    assert last.endswith("(unwritten)")
