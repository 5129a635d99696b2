"""Planned workings of walls and lines of centres that are along vectors of unknown letters.

No length of a direction stands in an equation, and nothing is squared.
"""

from __future__ import annotations

from functools import cache

import pytest

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles

STATEMENTS = {
    "a wall": """
wall W: along 2i + a j
sphere P: mass 2, velocity 3i + 4j
P hits W
given velocity(P) = 5i
find a, direction(W), e
""",
    "a line of centres": """
sphere A: mass 2, velocity 3i + j
sphere B: mass 4, velocity -i - j
A hits B: along 2i + b j
unknown b
given velocity(B) = i
find b, e
""",
    "a wall, and a velocity after it": """
wall W: along 4i + a j
sphere P: mass 2, velocity 6i + 2j
P hits W
given velocity(P) = 3i + b j, e = 1/2
find a, b
""",
    "a wall of two letters": """
sphere S: mass 3, velocity 4i - 2j
wall W: along a i + b j
unknown a, b
S hits W
given velocity(S) = i + 2j
part a
find impulse(S), direction(W)
part b
find e, energy_lost
""",
    "a line of centres of two letters": """
sphere A: mass 2, velocity 3i + j
sphere B: mass 4, velocity -i - j
A hits B: along a i - b j
given velocity(B) = i
find velocity(A), line_of_centres, e
""",
}


@cache
def planned(name: str) -> tuple[Solution, Derivation]:
    solution = solve(parse(STATEMENTS[name]))
    return solution, plan(solution)


def lines_of(name: str) -> list[str]:
    relations = (each.relation for each in planned(name)[1].lines)
    return [write_relation(each) for each in relations if isinstance(each, Relation)]


@pytest.mark.parametrize("name", STATEMENTS)
def test_each_line_follows(name: str) -> None:
    solution, derivation = planned(name)
    assert not derivation.notes
    assert not follow(derivation, Oracle(roles(solution.problem)))


@pytest.mark.parametrize("name", STATEMENTS)
def test_no_direction_is_squared(name: str) -> None:
    equations = [each for each in lines_of(name) if "^2" in each and "velocity" not in each]
    assert all(each.startswith(("a^2 - 2a", "3a^2", "energy_lost")) for each in equations)


def test_what_stays_is_by_the_vectors() -> None:
    said = lines_of("a wall")
    assert said[:2] == ["3*2 + 4a = 5*2", "a = 1"]
    assert "direction(W) parallel to 2i + j" in said
    assert lines_of("a line of centres")[:2] == ["-b = b - 2", "b = 1"]


def test_both_laws_are_by_the_vectors() -> None:
    said = lines_of("a wall, and a velocity after it")
    assert said[0] == "3*4 + b a = 6*4 + 2a"
    assert said[1] == "3a - 4b = -1/2 (6a - 2*4)"
    assert "a = 4 or a = -2" in said


def test_of_two_letters_the_direction_alone_is_found() -> None:
    """That both are unknown does not make what is given impossible."""
    said = lines_of("a wall of two letters")
    assert "direction(W) parallel to 4i + 3j" in said
    assert "e = 1/4" in said
    said = lines_of("a line of centres of two letters")
    assert "velocity(A, 1) = -i - j" in said
    assert "e = 1/2" in said


def test_letters_that_are_asked_are_kept() -> None:
    solution = solve(parse(STATEMENTS["a wall of two letters"].replace("find e,", "find e, b/a,")))
    answers = [str(item) for part in solution.parts.values() for item in part.items]
    assert not any(item.error for part in solution.parts.values() for item in part.items)
    assert any("3/4" in each for each in answers)
