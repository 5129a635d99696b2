"""What cannot be found says, as a sentence, what is not given."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

WITHOUT_PLACES = """
sphere A: mass m, velocity u i
sphere B: mass 4m, at rest
wall W: along j
A hits B: along i, e = 3/4
B hits W: e = 2/5
"""


@pytest.mark.parametrize(
    ("asked", "why"),
    [
        ("time(2) - time(1)", "as the distance between B and W is not given"),
        ("position(B, 2)", "as the position of B at any time is not given"),
    ],
)
def test_times_and_places_say_which_distance_is_not_given(asked: str, why: str) -> None:
    text = " ".join(to_text(explain(solve(parse(f"{WITHOUT_PLACES}find {asked}")))).split())
    assert f"cannot be found, {why}." in text
