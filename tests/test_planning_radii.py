"""Spheres with radii that touch: when, along which line, and where their centres are."""

from __future__ import annotations

from dataclasses import replace

from workings import planned

from restitution.explain.derived import explanation_of
from restitution.explain.text import to_text
from restitution.explaining.awarding import awarded
from restitution.explaining.derivation import Derivation, Relation
from restitution.explaining.follower import follow
from restitution.explaining.notation import read_relation, write_relation
from restitution.oracle import Oracle
from restitution.problem import Problem
from restitution.solve.letters import roles

AT_REST = """
sphere A: mass 2, radius 5, at (0, 1), velocity 3i
sphere B: mass 1, radius 5, at (20, 7), at rest
A hits B: e = 1/2
find time(1), line_of_centres, velocity(B), distance(A, B, at 6)
"""


def printed(problem: Problem, derivation: Derivation) -> str:
    """The working as text."""
    return to_text(explanation_of(awarded(derivation), problem))


def test_the_line_of_centres_is_between_the_places_at_the_impact() -> None:
    problem, derivation = planned(AT_REST)
    text = printed(problem, derivation)
    assert "A and B touch when their centres are 10 m apart:" in text
    assert "t = 4 s, as A and B are approaching then" in text
    assert "the line of centres is parallel to 4𝐢 + 3𝐣" in text
    assert "position of B at the impact" not in text  # who rests stays where it is


def test_two_that_move() -> None:
    planned(
        """
        sphere A: mass m, radius 5a, at (0, 0), velocity 2u i
        sphere B: mass m, radius 5a, at (20a, 6a), velocity -2u i
        A hits B: e = 1
        find time(1), velocity(A)
        """
    )


def test_centres_are_two_radii_apart_when_a_distance_is_counted() -> None:
    problem, derivation = planned(
        """
        sphere A, B: radius 2
        sphere A: mass 1, velocity 4i + j
        sphere B: mass 1, velocity -2i + 3j
        A hits B: along i, e = 1/3
        find distance(A, B, at 3)
        """
    )
    assert "4𝐢 + 3(2𝐢 + 3𝐣)" in printed(problem, derivation).replace("\n", "")


def test_a_sense_or_a_radius_that_is_wrong_is_refused() -> None:
    problem, derivation = planned(AT_REST)
    oracle = Oracle(roles(problem))
    spoiled = 0
    for line in derivation.lines:
        text = write_relation(line.relation) if isinstance(line.relation, Relation) else ""
        for old, new in (
            ("parallel to 4i + 3j", "parallel to -4i - 3j"),
            ("parallel to 4i + 3j", "parallel to 4i - 3j"),
            ("= 10^2", "= 5^2"),
        ):
            if old in text:
                other = read_relation(text.replace(old, new), {"A": "sphere", "B": "sphere"})
                lines = tuple(
                    replace(each, relation=other) if each is line else each
                    for each in derivation.lines
                )
                assert follow(replace(derivation, lines=lines), oracle) != ()
                spoiled += 1
    assert spoiled == 3


def test_a_time_says_from_what_it_is_counted() -> None:
    problem, derivation = planned(AT_REST)
    text = printed(problem, derivation)
    assert "6 s after the start" in text
    assert "at time" not in text
    problem, derivation = planned(
        """
        sphere A: mass m, velocity 3u i + u j
        sphere B: mass m, velocity u j
        A hits B: along i, e = 1/2
        find distance(A, B, at time(1) + t)
        """
    )
    assert "t after the impact" in printed(problem, derivation)


def test_the_size_of_a_blow() -> None:
    _, derivation = planned(
        """
        sphere P: mass 2, velocity i
        P receives 3i - 4j
        find impulse, velocity(P)
        """
    )
    assert write_relation(derivation.items[0].answer) == "impulse(1) = 5"
