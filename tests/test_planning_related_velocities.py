"""Velocities that are given by others: what is asked of them is worked out from the other one."""

from __future__ import annotations

import pytest
from workings import planned

from restitution.explaining.lines.derivation import Relation
from restitution.explaining.lines.notation import write_relation

TWICE = """
sphere A: mass 1, velocity 5i + 2j
sphere B: mass 12, velocity -i + j
A hits B: along i
given velocity(A) = 2 velocity(B)
find {0}
"""


@pytest.mark.parametrize(
    ("asked", "answer"),
    [
        ("velocity(A)", "velocity(A, 1) = -i + 2j"),
        ("momentum(A)", "momentum(A, 1) = -i + 2j"),
        ("speed(A)", "speed(A, 1) = sqrt(5)"),
        ("energy(A)", "energy(A, 1) = 5/2"),
        ("impulse", "impulse(1) = 6"),  # 12(-1/2 + 1)
        ("direction(A)", "theta = 117°"),  # to the nearest degree
    ],
)
def test_twice_the_velocity_of_the_other(asked: str, answer: str) -> None:
    _, derivation = planned(TWICE.format(asked))
    assert [write_relation(each.answer).replace(" ≈ ", " = ") for each in derivation.items] == [
        answer
    ]
    said = [
        write_relation(e.relation) for e in derivation.lines if isinstance(e.relation, Relation)
    ]
    assert any(each.startswith("velocity(A, 1) = 2(-1/2 i + j)") for each in said)
