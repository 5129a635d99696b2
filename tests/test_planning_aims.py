"""Workings from their end: where a sphere has to be struck so that it comes to a point."""

from __future__ import annotations

from dataclasses import replace

from laws_of_workings import answers as wrong_answers

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.problem import Problem
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

DIRECT = """
point N: (10, 10)
sphere A: mass 1, at (-2, 0), velocity u at alpha, radius 1
sphere B: mass 3, at (6, 7), at rest
A hits B: e = 2/3
B reaches N
find alpha
"""
BY_A_CUSHION = """
point N: (9, 12)
wall W: along i, through (0, -2)
sphere A: mass 1, at (-6, 0), velocity u at -alpha, radius 1
sphere B: mass 1, at (3, 4), at rest
A hits W: e = 1/3
A hits B: e = 1/2
B reaches N
find alpha
"""


def planned(statement: str) -> tuple[Problem, Derivation]:
    """A statement and its working, which the follower accepts and which has its answers."""
    problem = parse(statement)
    solution = solve(problem)
    derivation = plan(solution)
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert wrong_answers(solution, derivation) == []
    return problem, derivation


def test_the_path_to_the_pocket_gives_the_line_of_centres_and_the_place() -> None:
    problem, derivation = planned(DIRECT)
    text = to_text(explanation_of(awarded(derivation), problem))
    assert "B was at rest, so it moves off along the line of centres:" in text
    assert "the line of centres is parallel to (10𝐢 + 10𝐣) − (6𝐢 + 7𝐣) = 4𝐢 + 3𝐣" in text
    assert "(6𝐢 + 7𝐣) − 2((4𝐢 + 3𝐣)/5)" in text


def test_by_a_cushion() -> None:
    planned(BY_A_CUSHION)


def test_a_sense_or_a_side_that_is_wrong_is_refused() -> None:
    problem, derivation = planned(DIRECT)
    oracle = Oracle(roles(problem))
    spoiled = 0
    for line in derivation.lines:
        text = write_relation(line.relation) if isinstance(line.relation, Relation) else ""
        text = text.partition(" [")[0]
        changes = {
            "moves-off": ("10i + 10j - (6i + 7j)", "6i + 7j - (10i + 10j)"),
            "beside": ("7j - 2", "7j + 2"),
        }
        if line.move.record in changes:
            old, new = changes[line.move.record]
            assert old in text
            first = text.replace(old, new).rpartition(" = ")[0] or text.replace(old, new)
            other = read_relation(first, {"A": "sphere", "B": "sphere"})
            lines = tuple(
                replace(each, relation=other) if each is line else each for each in derivation.lines
            )
            assert follow(replace(derivation, lines=lines), oracle) != ()
            spoiled += 1
    assert spoiled == 2


def test_a_velocity_of_known_size_is_along_the_way_to_a_known_place() -> None:
    problem, derivation = planned(
        """
        point N: (4, 6)
        sphere P: mass 1, at (1, 2)
        P reaches N
        given speed(P, 0) = 10
        find velocity(P, 0)
        """
    )
    text = to_text(explanation_of(awarded(derivation), problem))
    assert "The velocity is in the\ndirection of the path:" in text
    assert "𝐮_P = 10(((4𝐢 + 6𝐣) − (𝐢 + 2𝐣))/5) = 10((3𝐢 + 4𝐣)/5)" in text
    assert "a𝐢 + b𝐣" not in text


def test_the_velocity_of_who_strikes_serves_the_laws_of_the_impact() -> None:
    problem, derivation = planned(
        """
        sphere A: mass 1, at (0, 0), radius 5
        sphere B: mass 1, at (30, 40), at rest
        A hits B: e = 1/2
        B reaches (60, 80)
        given speed(A, 0) = 20
        find velocity(A, 0), velocity(B)
        """
    )
    text = to_text(explanation_of(awarded(derivation), problem))
    assert "𝐮_A = 20((24𝐢 + 32𝐣)/40)" in text
    assert "w = 15 m s⁻¹" in text


def test_a_component_of_who_meets_nothing_is_not_said_to_be_after_an_impact() -> None:
    problem, derivation = planned(
        """
        point N: (4, 6)
        sphere P: mass 1, at (1, 2)
        P reaches N
        given time(1) = 2
        find velocity(P, 0)
        """
    )
    text = to_text(explanation_of(awarded(derivation), problem))
    assert "Let 𝐮_P = a𝐢 + b𝐣." in text
    assert "after the impact" not in text
