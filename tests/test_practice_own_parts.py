"""Whose values a line goes on with: his own velocity of the other sphere, and those of its part."""

from __future__ import annotations

import pytest
from marked import solution_of, verdicts

import restitution

# By hand: A has 32/5 along the line before. With 3v + w = 96/5 and w - v = 64/15, w = 8.
_SLANTED = """
sphere A: mass 3, velocity 8i
sphere B: mass 1, at rest
A hits B: along 4i + 3j, e = 2/3
find velocity(B), velocity(A)
"""


@pytest.mark.parametrize(
    "line",
    [
        "velocity of A = (24i - 4.8i - 6.4j)/3",
        "24i = 3(velocity of A) + 4.8i + 6.4j",
        "velocity of A = 6.4i - 32/15 j",
    ],
)
def test_momentum_in_vectors_goes_on_with_his_own_velocity_of_the_other_sphere(line: str) -> None:
    # The velocity of B is 8(4i + 3j)/5.
    first = "velocity of B = 8(3i + 4j)/5 = 4.8i + 6.4j"
    assert verdicts(_SLANTED, first, line) == ["false", "follows"]


def test_what_keeps_no_momentum_does_not_follow() -> None:
    first = "velocity of B = 8(3i + 4j)/5 = 4.8i + 6.4j"
    for line in ("velocity of A = (24i - 4.8i + 6.4j)/3", "velocity of A = 24i - 4.8i - 6.4j"):
        assert verdicts(_SLANTED, first, line) == ["false", "false"]


def _parted(statement: str, part: str, *lines: str) -> list[str]:
    marking = restitution.mark(solution_of(statement), "\n".join(lines), part=part)
    return [line["verdict"] for line in marking.json()["lines"]]


_BLOW = """
wall W: along i
sphere P: mass 3, velocity 2i
P receives 6i - 12j
part a
find speed(P)
part b
P hits W: e = 1/2
find impulse
"""


def test_an_impulse_is_that_for_which_its_part_asks() -> None:
    # P comes with 4i - 4j and leaves with 4i + 2j; the blow has 3(4 - 2) = 6 along i.
    assert _parted(_BLOW, "b", "I = 3(4 + 2) = 18") == ["true"]
    assert _parted(_BLOW, "b", "I = 3(4 - 2) = 6") == ["false"]


_CORNER = """
wall AB: along i
wall BC: along 60°
sphere P: velocity 6 at 60° to AB
part a
P hits AB: e = 1/3
find speed(P)
part b
P hits BC: e = 1/4
find {}
"""


def test_an_angle_to_a_wall_is_one_of_its_part() -> None:
    # Behind AB it moves at 30° to AB, and so at 30° to BC; at the start the lines meet at 60°.
    asked = _CORNER.format("speed(P)")
    assert _parted(asked, "b", "angle to BC = 30") == ["true"]
    assert _parted(asked, "b", "angle to BC = 60") == ["false"]


def test_an_angle_at_the_start_counts_where_all_of_the_way_is_asked() -> None:
    asked = _CORNER.format("angle(velocity(P, 0), velocity(P))")
    assert _parted(asked, "b", "angle to BC = 60") == ["true"]
