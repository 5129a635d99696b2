"""Ratios that are zero, or of squares, and speeds with roots in roots: each has a line."""

from __future__ import annotations

from dataclasses import replace

import pytest
from workings import planned

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.oracle import Oracle
from restitution.solving.story.letters import roles

STOPPED = """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along i, e = 1
find {0}
"""


@pytest.mark.parametrize(
    "asked", ["energy(A)/energy(A, 0)", "speed(A)/speed(B)", "energy_lost/energy(0)"]
)
def test_a_ratio_that_is_zero(asked: str) -> None:
    _, derivation = planned(STOPPED.format(asked))
    (end,) = derivation.items
    assert write_relation(end.answer).endswith(" = 0")


def test_what_moves_along_the_line_of_centres_has_its_component_as_speed() -> None:
    _, derivation = planned(
        """
        sphere A: mass m, velocity u i, radius a
        sphere B: mass 2m, at rest, radius a
        A hits B: offset d, e = 3/4
        given deflection(A) = 45°
        find d, speed(B)
        """
    )
    assert write_relation(derivation.items[1].answer) == (
        "speed(B, 1) = u sqrt(7(19 - sqrt(73)))/24"
    )


SQUARES = """
sphere A: mass 2m, velocity 3u i + 4u j
sphere B: mass 3m, velocity -2u i + u j
A hits B: along i, e = 1/3
find speed(A)^2/speed(A, 0)^2
"""


def test_a_ratio_of_squares() -> None:
    problem, derivation = planned(SQUARES)
    assert write_relation(derivation.items[0].answer) == "speed(A, 1)^2/speed(A, 0)^2 = 17/25"
    *above, last = derivation.lines
    false = read_relation("speed(A, 1)^2/speed(A, 0)^2 = 16/25", {"A": "sphere"})
    wrong = replace(derivation, lines=(*above, replace(last, relation=false)))
    assert "does-not-follow" in {
        each.reason for each in follow(wrong, Oracle(roles(problem))) if each.line == last.number
    }
