"""A claim about a motion that cannot be is neither shown nor refuted."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve

WALL = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
PAIR = "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"

CASES = {
    "facts that clash": (PAIR + "given k > 3, k < 2\n", "contradiction"),
    "facts that clash with the physics": (
        PAIR + "given along(velocity(A), i) < 0, k < 1\n",
        "contradiction",
    ),
    "energy that is gained": (WALL + "given energy_lost < 0\n", "contradiction"),
    "steeper after than before": (WALL + "given angle(velocity(P), W) > alpha\n", "contradiction"),
    "a coefficient that cannot be": (PAIR + "given e > 2\n", "impossible"),
    "both at rest": (PAIR.replace("velocity u i", "at rest"), "impossible"),
    "along the wall": (WALL.replace("u at alpha to W", "u i"), "impossible"),
    "two values of one letter": (WALL + "given u = 2, u = 3\n", "contradiction"),
    "no further impact": (PAIR + "given A and B collide again\n", "contradiction"),
}


@pytest.mark.parametrize(("text", "kind"), CASES.values(), ids=CASES.keys())
@pytest.mark.parametrize("claim", ["m > 0", "e = e", "e <= 1", "e > 1", "energy < energy(0)"])
def test_nothing_is_shown_of_it(text: str, kind: str, claim: str) -> None:
    item = next(result for _, result in solve(parse(f"{text}show {claim}\n")).items())
    assert item.holds is None
    assert item.error is not None
    assert item.error.kind == kind


def test_facts_that_leave_little_room() -> None:
    """1/k² < e < 1.05/k²: no simple numbers satisfy that, but others do; with k = 1.01, e = 1."""
    text = PAIR + "given k > 1, e > 1/k^2, e < 1.05/k^2\n"
    solution = solve(parse(text + "show e < 1\nshow k > 2\nshow k > 1\n"))
    assert [item.holds for _, item in solution.items()] == [False, False, True]
