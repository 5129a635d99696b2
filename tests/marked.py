"""Scripts of a few lines, and the verdicts that the marker gives them."""

from __future__ import annotations

from functools import cache

import restitution
from restitution.solving.equations.solution import Solution


@cache
def solution_of(statement: str) -> Solution:
    """The solution of a statement, once for all its scripts."""
    return restitution.solve(restitution.parse(statement))


def verdicts(statement: str, *lines: str) -> list[str]:
    """The verdict on each line of a script."""
    marking = restitution.mark(solution_of(statement), "\n".join(lines))
    return [line["verdict"] for line in marking.json()["lines"]]
