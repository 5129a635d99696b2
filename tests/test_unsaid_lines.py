"""Lines of centres that go without saying, as all is on one line."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

STORY = (
    "wall W: along {wall}, through ({x}, {y})\nsphere A: mass m, at (0, 0), velocity u {axis}\n"
    "sphere B: mass m, at ({at}), at rest\nA hits B: {along}e = 1/2\nB hits W: e = 1/2\n"
    "A hits B{again}\nfind position(A), time(3)"
)


@pytest.mark.parametrize(
    ("axis", "wall", "x", "y", "at"),
    [("i", "j", "4a", "0", "2a, 0"), ("j", "i", "0", "4a", "0, 2a")],
)
def test_places_on_one_line_give_the_line_of_centres(
    axis: str, wall: str, x: str, y: str, at: str
) -> None:
    story = {"axis": axis, "wall": wall, "x": x, "y": y, "at": at}
    unsaid = STORY.format(along="", again="", **story)
    along = STORY.format(along=f"along {axis}, ", again=f": along {axis}", **story)
    shown, other = (to_text(explain(solve(parse(text))), 80) for text in (unsaid, along))
    assert shown == other
    assert "not written" not in shown
    assert "34a/(5u)" in shown
