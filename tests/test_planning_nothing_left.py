"""Ratios that are zero, and speeds that are a component with roots in roots: each has a line."""

from __future__ import annotations

import pytest
from workings import planned

from restitution.explaining.notation import write_relation

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
