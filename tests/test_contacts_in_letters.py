"""Places of contact in letters: for which of them the spheres come together at all."""

from __future__ import annotations

import math

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

POCKET = """
point N: ({b}, {h})
sphere A: mass 1, at (0, 0), velocity u at alpha, radius 1
sphere B: mass 1, at (4, 5), at rest
A hits B: e = 1/2
B reaches N
find alpha
"""


def value_of(text: str) -> float:
    """A number as the package writes it: ``2*(-4 + sqrt(37))/3``."""
    (item,) = (
        solve(parse(f"sphere P: velocity 0i\nfind {text.replace('*', ' ')}")).parts[None].items
    )
    return float(item.distinct[0].value)


def approaches(b: float, h: float) -> bool:
    """Whether A, where it would have to touch B, comes from the near side of B."""
    x, y = b - 4, h - 5
    size = math.hypot(x, y)
    place = 4 - 2 * x / size, 5 - 2 * y / size
    return place[0] * x + place[1] * y > 0


@pytest.mark.parametrize("h", [8, 9])
def test_the_condition_is_that_the_spheres_approach(h: int) -> None:
    (item,) = solve(parse(POCKET.format(b="b", h=h))).parts[None].items
    (answer,) = item.distinct
    (condition,) = answer.condition
    low, _, right = condition.partition(" < ")
    assert right == "b"
    least = value_of(low)
    assert approaches(least + 0.01, h)
    assert not approaches(least - 0.01, h)


def test_what_holds_for_all_letters_has_no_condition() -> None:
    assert all(approaches(b / 10, 12) for b in range(1, 400))  # a letter alone is positive
    (item,) = solve(parse(POCKET.format(b="b", h=12))).parts[None].items
    assert item.distinct[0].condition == ()


def test_a_working_says_for_which_letters_it_holds() -> None:
    text = to_text(explain(solve(parse(POCKET.format(b="b", h=9)))))
    assert "As A has to move towards B to hit it, this holds for b > 2(√37 − 4)/3 only." in text


def test_no_value_is_called_the_only_one_where_contacts_were_left_out() -> None:
    behind = POCKET.format(b=-10, h=5)
    assert not approaches(-10, 5)
    (item,) = solve(parse(behind)).parts[None].items
    assert item.error is not None
    assert item.rejected == ()
    text = " ".join(to_text(explain(solve(parse(behind)))).split())
    # It would be false of places of A's centre from which no solution comes.
    assert "as in every solution of the equations B moves away from N" in text
    assert "only value" not in text
