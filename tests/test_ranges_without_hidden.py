"""Ranges and extrema that no unknown of the motion limits, and where a quantity has no value."""

from __future__ import annotations

import pytest

import restitution
from restitution.errors import MissingError

DIRECT = """sphere A: mass {m}, velocity 2i
sphere B: mass 1, at rest
A hits B
find range of e
"""


@pytest.mark.parametrize("mass", ["1", "3"])
def test_a_coefficient_is_free_on_any_line_of_centres(mass: str) -> None:
    solution = restitution.solve(restitution.parse(DIRECT.format(m=mass)))
    assert str(solution) == "range of e = 0 ≤ e ≤ 1"


def test_a_range_that_rests_on_the_line_of_centres_asks_for_it() -> None:
    text = DIRECT.format(m=1).replace("range of e", "range of speed(B)")
    (part,) = restitution.solve(restitution.parse(text)).parts.values()
    assert isinstance(part.items[0].error, MissingError)


CORNER = """wall V: along i
wall W: along j
sphere P: velocity u cos(alpha) i - u sin(alpha) j
P hits V{e}
P hits W{e}
find maximum of deflection(P) over alpha
"""


@pytest.mark.parametrize(
    ("e", "expected"),
    [
        ("", "180° approached as α → 0°, for e > 0"),
        (": e = 1/2", "180° approached as α → 0°"),
    ],
)
def test_a_ball_at_rest_in_a_corner_has_no_deflection(e: str, expected: str) -> None:
    solution = restitution.solve(restitution.parse(CORNER.format(e=e)))
    assert str(solution).split(" = ", 1)[1] == expected
