"""Workings of questions in letters: what is shown, ranges, and greatest and least values."""

from __future__ import annotations

import pytest

from restitution import parse, solve
from restitution.workings import explain, to_text

WALL = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\n"
IN_LINE = "sphere P: mass m, velocity 2u i\nsphere Q: mass 3m, velocity u i\nP hits Q: along i\n"

# What stands in a working, and what does not.
SAYS: dict[str, tuple[str, list[str], list[str]]] = {
    "a sign that the range of a coefficient tells is no matter of growth": (
        IN_LINE + "part a\nfind velocity(P)\npart b\nshow along(velocity(P), i) > 0\n",
        ["v > 0, as e ≤ 1 (as required)"],
        ["increases"],
    ),
    "a multiple of a coefficient is at most what it multiplies": (
        WALL + "P hits W\nlet beta = angle(velocity(P), W)\nshow beta <= alpha\n",
        ["tan β ≤ tan α, as α is acute and e ≤ 1"],
        ["increases"],
    ),
}


@pytest.mark.parametrize("name", SAYS)
def test_it_says_what_a_teacher_would_write(name: str) -> None:
    text, says, never = SAYS[name]
    working = " ".join(to_text(explain(solve(parse(text)), check=True)).split())
    assert [words for words in says if words not in working] == []
    assert [words for words in never if words in working] == []
