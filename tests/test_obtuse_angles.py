"""Errors that name the angle which would have to be obtuse, and what they cost."""

from __future__ import annotations

import restitution
from restitution import work

OBTUSE = """
sphere P: mass 1, velocity 5 at alpha
wall W: along j
P hits W: e = 1/2
given along(velocity(P, 0), i) = -3
find alpha
"""
FOUR_IMPACTS = """
wall W: along i
wall V: along 60°
sphere P: mass m, velocity u at alpha to W
P hits W
P hits V
P hits W
P hits V
find deflection(P), speed(P), energy_lost
find maximum of speed(P) over alpha
"""


def test_an_angle_that_would_be_obtuse_is_named() -> None:
    (item,) = restitution.solve(restitution.parse(OBTUSE)).parts[None].items
    assert "α would be 90° or more: write 'given alpha < 180°'" in str(item.error)
    wide = restitution.parse(f"{OBTUSE}given alpha < 180°\n")
    assert restitution.solve(wide).parts[None].items[0].error is None


def test_a_hint_costs_little_more_than_the_answer_that_it_stands_for() -> None:
    with work.limited() as spent:
        solution = restitution.solve(restitution.parse(FOUR_IMPACTS))
    assert all(item.error is not None for item in solution.parts[None].items)
    assert spent.used < 300_000
