"""Letters that are positive unless a fact says otherwise, and facts in letters that do."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution.language import parse
from restitution.solving import solve

ALONG_A_LINE = """
    sphere A, B: mass m
    sphere A: velocity u i
    sphere B: velocity -w i
    A hits B: along i, e = 1/2
    given {}
    {}
    """
OFFSET = """
    sphere A, B: mass m, radius r
    sphere A: velocity u i
    sphere B: at rest
    A hits B: offset d, e = 1/3
    given {}
    {}
    """


@pytest.mark.parametrize(
    ("fact", "shown"),
    [("-u < w < u", False), ("w > -u/2", False), ("w > u/2", True), ("w < u", True)],
)
def test_a_letter_may_be_negative_where_its_least_value_is(fact: str, shown: bool) -> None:
    # B moves away from A, and more slowly than A, for −u < w < 0.
    ((_, item),) = solve(parse(ALONG_A_LINE.format(fact, "show w > 0"))).items()
    assert item.holds is shown


def test_an_offset_to_the_other_side_is_among_the_answers() -> None:
    # The line of centres is at arcsin(d/2r), 30° for d = ±r: v = (u cos 30°/3, u sin 30°).
    r = sp.Symbol("r", positive=True)
    text = OFFSET.format("deflection(A) = 30°, -2r < d < 2r", "find d")
    ((_, item),) = solve(parse(text)).items()
    assert {str(answer.value) for answer in item.answers} == {"r", "-r"}
    ((_, item),) = solve(parse(OFFSET.format("-r <= d <= r", "find range of d"))).items()
    assert [answer.value for answer in item.answers] == [sp.Interval(-r, r)]
