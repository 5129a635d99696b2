"""Spheres with radii that touch: when, along which line, and where their centres are."""

from __future__ import annotations

from dataclasses import replace

from workings import planned

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.problem import Problem
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

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
    assert "= 8𝐢 + 6𝐣 = 2(4𝐢 + 3𝐣)" in text
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


def test_an_offset_tells_the_side_of_the_path() -> None:
    problem, derivation = planned(
        """
        sphere A: mass 2m, velocity 3w i, radius b
        sphere B: mass m, velocity 4w j, radius b
        A hits B: offset -b, e = 1/2
        find velocity(A)
        """
    )
    text = " ".join(printed(problem, derivation).split())
    assert "the centre of B is b to the right of the path of A relative to B" in text
    assert "which is in the direction of 3w𝐢 − 4w𝐣" in text
    assert "has sine b/(2b) = ½, and is 30°:" in text


def test_a_ball_touches_a_wall_before_its_centre_is_there() -> None:
    problem, derivation = planned(
        """
        wall W: along j, through (7, 0)
        sphere P: mass 2, at (1, 1), velocity 5i + 2j, radius 1
        P hits W: e = 1/5
        find time(1), position(P)
        """
    )
    text = " ".join(printed(problem, derivation).split())
    assert "the centre of P is 1 m from W, so its x-coordinate is 7 − 1 = 6 m" in text
    assert "t = (6 − 1)/5 = 1 s" in text


def test_a_slanting_wall_is_met_on_its_line() -> None:
    problem, derivation = planned(
        """
        wall W: from (6, 0) to (0, 8)
        sphere P: at (1, 0), velocity i + j
        P hits W: e = 1/2
        find time(1), position(P)
        """
    )
    text = printed(problem, derivation)
    assert "P is then on the line of W, 4x + 3y = 24:\n    4(1 + t) + 3t = 24" in text


def test_who_rests_stays_where_it_is() -> None:
    problem, derivation = planned(
        """
        wall W: along j, through (9, 0)
        sphere A: mass 1, at (1, 0), velocity 4i
        sphere B: mass 2, at (3, 0), at rest
        A hits B: along i, e = 1/2
        B hits W: e = 1/4
        find distance(A, B), position(B, at 6)
        """
    )
    text = printed(problem, derivation)
    assert "A is at rest, so it stays where it is:\n" in text


def in_one_line(text: str) -> str:
    """The working of a statement as text."""
    return " ".join(to_text(explain(solve(parse(text)), check=True)).split())


def test_a_ball_that_reaches_a_wall_or_another_one_at_0_has_its_centre_said() -> None:
    text = in_one_line("""
        sphere A: mass m, velocity 2u j, at (0, -4a), radius 2a
        sphere B: mass 2m, at rest, at (0, 0)
        wall W: along i, through (0, 9a)
        A hits B: e = 1/2
        find velocity(A), velocity(B)
        B hits W: e = 1/2
        A hits B
        find time(3) - time(1)
        """)
    assert "the centre of B is 2a from W, so its y-coordinate is 9a − 2a = 7a." in text
    assert "their centres are 4a apart, so the y-coordinate of B is then −4a + 4a = 0." in text
    assert "t₃ − t₂ = 7a/(u/2) = 14a/u" in text
    text = in_one_line("""
        wall V: along j, through (12, 0)
        sphere P: at (1, 1), velocity 5i + 2j, radius 2
        P reaches V
        find time(1)
        """)
    assert "When P reaches V, its centre is 2 m from V, so its x-coordinate is 12 − 2" in text
