"""Workings of the planner, each accepted by the follower before a test looks at it."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from laws_of_workings import answers as wrong_answers

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.problem import Problem
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles
from restitution.workings import to_text
from restitution.workings.derived import explanation_of


@cache
def solved(statement: str) -> Solution:
    """The solution of a statement, made once for all tests of a process."""
    return solve(parse(statement))


@cache
def planned(statement: str) -> tuple[Problem, Derivation]:
    """A statement and its working, which the follower accepts and which has its answers."""
    solution = solved(statement)
    problem = solution.problem
    derivation = plan(solution)
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert wrong_answers(solution, derivation) == []
    return problem, derivation


def printed_with(statement: str, parts: Iterable[str]) -> str:
    """A working as it is printed, in one row; these parts of it stand there in their order."""
    problem, derivation = planned(statement)
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    place = -1
    for part in parts:
        start = text.find(part, place + 1)
        assert start > place, (part, text)
        place = start
    assert "not written out" not in text
    return text
