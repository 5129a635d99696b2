"""Workings of stories of several events: accepted by the follower, with the right answers."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Relation
from restitution.explaining.lines.notation import write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles

STORIES: Mapping[str, tuple[str, list[str]]] = {
    "two walls at right angles": (
        """
        wall L: along i
        wall M: along j
        sphere P: mass 2, velocity -6i - 4j
        P hits L: e = 1/2
        P hits M: e = 1/3
        find velocity(P), impulse
        """,
        ["velocity(P, 2) = 2i + 2j", "impulse(2) = 16"],
    ),
    "three walls": (
        """
        wall L: along i
        wall M: along j
        wall N: along i
        sphere P: velocity 8i - 8j
        P hits L: e = 1/2
        P hits M: e = 1/4
        P hits N: e = 1/2
        find velocity(P)
        """,
        ["velocity(P, 3) = -2i - 2j"],
    ),
    "a coefficient by the last of two walls": (
        """
        wall L: along i
        wall M: along j
        sphere P: velocity 4i - 6j
        P hits L: e = 1/2
        P hits M
        given speed(P) = 5
        find e
        """,
        ["e = 1"],
    ),
    "a wall, then a sphere": (
        """
        wall W: along i
        sphere A: mass 1, velocity 4i - 3j
        sphere B: mass 1, velocity 2i - j
        A hits W: e = 2/3
        A hits B: along i, e = 1/2
        find velocity(B)
        """,
        ["velocity(B, 2) = 7/2 i - j"],
    ),
    "three spheres in line": (
        """
        sphere A: mass 1, velocity 8i
        sphere B: mass 1, at rest
        sphere C: mass 2, at rest
        A hits B: along i, e = 1/2
        B hits C: along i, e = 1/2
        find velocity(C)
        """,
        ["velocity(C, 2) = 3i"],
    ),
    "out to a wall and back": (
        """
        wall W: along j
        sphere A: mass 2, velocity 6i
        sphere B: mass 4, at rest
        A hits B: along i, e = 1/2
        B hits W: e = 1/2
        B hits A: along i, e = 1/2
        find velocity(A)
        """,
        ["velocity(A, 3) = -3/2 i"],
    ),
    "a blow between a wall and the end": (
        """
        wall W: along i
        sphere P: mass 2, velocity i - 3j
        P hits W: e = 1/3
        P receives 2i + 4j
        find velocity(P), speed(P), energy(P)
        """,
        ["velocity(P, 2) = 2i + 3j", "speed(P, 2) = sqrt(13)", "energy(P, 2) = 13"],
    ),
    "a blow to a sphere of mass 1 at rest": (
        """
        sphere A: mass 1, at rest
        sphere B: mass 2, at rest
        A receives 3i + 4j
        A hits B: along i, e = 1/3
        find velocity(A), speed(B)
        """,
        ["velocity(A, 2) = 1/3 i + 4j", "speed(B, 2) = 4/3"],
    ),
}


@pytest.mark.parametrize("name", STORIES)
def test_stories_of_several_events(name: str) -> None:
    statement, expected = STORIES[name]
    problem = parse(statement)
    derivation = plan(solve(problem))
    complaints = [str(each) for each in follow(derivation, Oracle(roles(problem)))]
    assert [each for each in complaints if "leads nowhere" not in each] == []
    assert [write_relation(each.answer) for each in derivation.items] == expected


def test_a_component_is_worked_out_when_its_event_comes() -> None:
    problem = parse(STORIES["three walls"][0])
    derivation = plan(solve(problem))
    events = [
        each.move.event
        for each in derivation.lines
        if isinstance(each.relation, Relation) and each.move.record == "restitution-wall"
    ]
    assert events == sorted(events, key=lambda each: each or 0)
