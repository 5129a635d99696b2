"""Ranges of letters over lines of centres that nothing fixes: any along which spheres approach."""

from __future__ import annotations

import pytest

import restitution
from restitution.errors import MissingError

BACK_FROM_A_WALL = """sphere A: mass 3, velocity 2i
sphere B: mass 1, at rest
wall W: along j
A hits B: e = e1
B hits W: e = e2
A hits B: e = e3
show e1 < 1
find range of e1, range of e3
"""
AFTER_A_BLOW = """sphere A, B: mass 1
sphere A: velocity 2i
sphere B: at rest
A hits B: e = 1/2
B receives i + 2j
A hits B
find range of e
"""
# B may be struck along its edge, so that A keeps almost all of its velocity, and no more.
OVERTAKEN = """sphere A, B, C: mass 1
sphere A: velocity 2i
sphere B: at rest
sphere C: velocity c i
A hits B: e = 1/2
A hits C: along i, e = 1
find range of c
"""
# Along V the spheres move opposite ways, and neither passes through it.
BOTH_SIDES = """sphere A, B: mass 1
sphere A: velocity 2i
sphere B: at rest
wall V: along i
A hits B: e = 1/2
B hits V: e = 1/2
A hits V
find range of e
"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            BACK_FROM_A_WALL,
            "e1 < 1: false\nrange of e1 = 0 ≤ e₁ ≤ 1\nrange of e3 = 0 ≤ e₃ ≤ 1",
        ),
        (AFTER_A_BLOW, "range of e = 0 ≤ e ≤ 1"),
        (OVERTAKEN, "range of c = 0 < c < 2"),
        (BOTH_SIDES, "range of e = no answer: no value of e is possible"),
    ],
    ids=["back from a wall", "after a blow", "overtaken", "both sides of a wall"],
)
def test_a_range_is_over_all_lines_of_centres(text: str, expected: str) -> None:
    assert str(restitution.solve(restitution.parse(text))) == expected


def test_a_letter_that_is_open_beside_a_line_of_centres_asks_for_that() -> None:
    text = "sphere A, B: mass 1\nsphere A: velocity 2i\nsphere B: at rest\nA hits B\nfind e\n"
    (part,) = restitution.solve(restitution.parse(text)).parts.values()
    error = part.items[0].error
    assert isinstance(error, MissingError)
    assert "while the line of centres of A and B is open too" in error.message
