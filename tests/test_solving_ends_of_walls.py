"""A wall that is missed: where the sphere comes to its line instead."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

MISSED = """
wall W: from (4, 0) to (4, {end})
sphere P: at (0, 0), velocity 2i + 3j
P hits W: e = 1/2
find velocity(P)
"""


@pytest.mark.parametrize(
    ("end", "reason"),
    [
        (
            "2",
            "P does not meet W between its ends: it comes to the line of W at (4, 6), beyond them",
        ),
        ("6", "P meets W only at its end (4, 6), and not between its ends"),
    ],
)
def test_the_place_on_its_line_is_said(end: str, reason: str) -> None:
    solution = solve(parse(MISSED.format(end=end)))
    error = solution["velocity(P)"].error
    assert error is not None
    assert reason in error.message
    text = " ".join(to_text(explain(solution), 80).split())
    assert "position of P at the impact = (4𝐢 + 6𝐣) m" in text
    assert f"So {reason.partition(':')[0]}: what is described cannot happen." in text
