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
    "asked",
    [
        "given deflection(P) = 90°\nshow tan(alpha)^2 = 1/e",
        "given tan(alpha) = 3/4, e = 1/3\nfind speed(P), impulse, angle(velocity(P), W)",
        "find deflection(P) in terms of alpha, e",
    ],
)
def test_a_wall_to_which_all_angles_are_told_needs_no_direction(asked: str) -> None:
    story = "wall W{}\nsphere P: mass m, velocity u at alpha to W\nP hits W\n" + asked
    shown, other = (to_text(explain(solve(parse(story.format(e)))), 80) for e in ("", ": along i"))
    assert shown == other
    assert "not written" not in shown


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
