"""Workings of the planner, each accepted by the follower before a test looks at it."""

from __future__ import annotations

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
