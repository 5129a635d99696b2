"""What is to be shown and is a law is that law: one line, for which nothing is solved."""

from __future__ import annotations

import pytest
from workings import planned, printed_with

from restitution.explaining.lines.derivation import Meaning

SPHERES = """
sphere A: mass 2m, velocity p i + q j
sphere B: mass m, velocity r i + s j
A hits B: along i
"""
SLANTING = """
sphere A: mass m, velocity 3i + 4j
sphere B: mass 3m, at rest
A hits B: along 3i + j, e = 1/2
"""
WALL = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
"""
# A statement, what is to be shown, and the record of the law that it is.
CLAIMS = {
    "the law of restitution by relative velocities": (
        SPHERES,
        "dot(velocity(A) - velocity(B), i) = -e dot(velocity(A, 0) - velocity(B, 0), i)",
        "restitution",
    ),
    "multiplied, and along a vector that is no unit vector": (
        SLANTING,
        "2 dot(velocity(B) - velocity(A), 3i + j) = dot(velocity(A, 0) - velocity(B, 0), 3i + j)",
        "restitution",
    ),
    "by components, at a wall": (
        WALL,
        "along(velocity(P), j) = -e along(velocity(P, 0), j)",
        "restitution-wall",
    ),
    "a component that stays": (
        SLANTING,
        "dot(velocity(A), i - 3j) = dot(velocity(A, 0), i - 3j)",
        "unchanged",
    ),
    "momentum, without its mass": (
        SPHERES,
        "2 velocity(A) + velocity(B) = 2 velocity(A, 0) + velocity(B, 0)",
        "momentum-vector",
    ),
    "momentum, by its name": (
        SPHERES,
        "momentum(A) + momentum(B) = momentum(A, 0) + momentum(B, 0)",
        "momentum-vector",
    ),
    "impulses": (SPHERES, "impulse(A) = -impulse(B)", "opposite-impulses"),
}


@pytest.mark.parametrize("name", CLAIMS)
def test_a_law_is_shown_in_one_line(name: str) -> None:
    statement, claim, record = CLAIMS[name]
    _, derivation = planned(f"{statement}show {claim}\n")
    (line,) = derivation.lines
    assert not isinstance(line.relation, Meaning)
    assert (line.move.id, line.move.record) == ("law", record)


def test_what_is_no_law_is_worked_out() -> None:
    claim = "dot(velocity(A) - velocity(B), j) = dot(velocity(A, 0) - velocity(B, 0), j)"
    _, derivation = planned(f"{SPHERES}show {claim}\n")
    assert len(derivation.lines) > 1


def test_a_component_that_stays_is_shown_where_it_is_asked() -> None:
    printed_with(
        f"{WALL}find velocity(P)\nshow along(velocity(P), i) = along(velocity(P, 0), i)\n",
        ("component in the direction of 𝐢 stays u cos α.", "(i) 𝐯_P", "not change: (ii) component"),
    )
