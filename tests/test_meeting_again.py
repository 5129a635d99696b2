"""``collide again`` and ``hits again``: on one line, across it, and by places."""

from __future__ import annotations

import pytest

from restitution.errors import RestitutionError
from restitution.language import parse
from restitution.solving import ItemResult, solve

LINE = """wall W: along {}
sphere A: mass 2, velocity {}
sphere B: mass 1, velocity {}
A hits B: along i, e = 1/2
B hits W: e = {}
"""


def only(text: str) -> ItemResult:
    ((_, item),) = solve(parse(text)).items()
    return item


# Along the line A goes on with (2·3 + 1 − 1/2·2)/3 = 2, B with 3.
@pytest.mark.parametrize("across", ["", " + 2j", " - j"])
def test_on_a_line_that_moves_sideways_or_not(across: str) -> None:
    """With one velocity across for both they stay on their line of centres."""
    text = LINE.format("j", f"3i{across}", f"i{across}", "1/4")
    assert only(text + "show A and B collide again").holds is True
    assert only(text + "show A and B do not collide again").holds is False


def test_after_a_blow_on_the_slower_sphere() -> None:
    """B has 3 along the line; from a blow of −2 it has 1, and A, with 2, catches it."""
    story = "sphere A: mass 2, velocity {0}\nsphere B: mass 1, velocity {1}\nA hits B: along i, \
e = 1/2\nB receives {2}\n"
    text = story.format("3i + j", "i + j", "-2i")
    assert only(text + "show A and B collide again").holds is True
    text = story.format("3i + j", "i + j", "-i/2")
    assert only(text + "show A and B collide again").holds is False
    # the blow turns B out of the line
    text = story.format("3i + j", "i + j", "-2i + j")
    error = only(text + "show A and B collide again").error
    assert error is not None and error.kind == "missing"


@pytest.mark.parametrize("claim", ["collide again", "do not collide again"])
def test_across_the_line_only_places_tell(claim: str) -> None:
    text = LINE.format("j", "3i + 2j", "i - j", "1/2")
    error = only(text + f"show A and B {claim}").error
    assert error is not None
    assert error.kind == "missing"
    text = text.replace("e = 1/2\nB", "e = e\nB") + f"given A and B {claim}\nfind range of e"
    error = only(text).error
    assert error is not None
    assert error.kind == "missing"


def test_across_the_line_without_another_event_they_separate() -> None:
    text = LINE.format("j", "3i + 2j", "i - j", "1/2").replace("B hits W: e = 1/2\n", "")
    assert only(text + "show A and B do not collide again").holds is True
    assert only(text + "show A and B collide again").holds is False


def test_a_wall_along_the_line_leaves_them_separating() -> None:
    text = LINE.format("i", "3i + 2j", "i - j", "1/2")
    assert only(text + "show A and B do not collide again").holds is True


PLACED = """wall W: along i through (0, {})
sphere A: mass 3, velocity 2i, at (0, 0), radius 5/2
sphere B: mass 1, at rest, at (13, 4)
A hits B: e = 1
B hits W: e = {}
"""


@pytest.mark.parametrize(("wall", "meet"), [("9.38", True), ("13.7", False)])
def test_by_places(wall: str, meet: bool) -> None:
    """Centres (3, 4) apart: A goes on with (1.64, −0.48), B with (1.08, 1.44), for 2 or for 5.

    Then B is (1.88, 7.84) or (0.2, 13.6) from A, and A comes with (0.56, 0.96) relative to it: it
    passes at |0.64 − 1.6128 t|/1.1114, which is 2.33 or 6.68; they touch at 5.
    """
    text = PLACED.format(wall, "1")
    assert only(text + "show A and B collide again").holds is meet
    assert only(text + "show A and B do not collide again").holds is not meet


def test_range_by_places() -> None:
    """With e = f at the wall and w = 1.44f − 0.48: (1.88w − 4.3904)² < 25(0.56² + w²)."""
    text = PLACED.format("9.38", "f") + "given A and B collide again\nfind range of f"
    found = only(text).exact
    assert float(found.start) == pytest.approx(0.6392, abs=1e-4)
    assert found.end == 1
    assert (found.left_open, found.right_open) == (True, False)


@pytest.mark.parametrize(("long", "again"), [("12", True), ("10", False)])
def test_a_wall_that_is_a_segment(long: str, again: bool) -> None:
    """From (3, 0) on the floor to (7, 4) on the ceiling, and to (11, 0)."""
    text = (
        f"wall F: from (0, 0) to ({long}, 0)\nwall C: from (0, 4) to (20, 4)\n"
        "sphere P: at (1, 2), velocity i - j\nP hits F: e = 1\nP hits C: e = 1\n"
    )
    assert only(text + "show P hits F again").holds is again
    assert only(text + "show P does not hit F again").holds is not again


def test_several_walls() -> None:
    """Between parallel walls P always comes back; in a right-angled corner it leaves both."""
    walls = "wall V: along j\nwall W: along {}\nsphere P: velocity 3i + j\nP hits V\nP hits W\n"
    text = walls.format("j").replace("P hits V\nP hits W", "P hits V: e = 1/2\nP hits W: e = 1/2")
    assert only(text + "show P hits V again").holds is True
    text = walls.format("i").replace("P hits V\nP hits W", "P hits V: e = 1/2\nP hits W: e = 1/2")
    assert only(text + "show P hits V again").holds is False
    assert only(text + "show P hits W again").holds is False


BACK_FROM_A_WALL = """
wall W: {wall}
sphere A: mass 3m, velocity 2u i
sphere B: mass m, {before}
A hits B: along i, e = 1/3
B hits W: e = 1/2
A hits B: e = 0
find velocity(A), velocity(B)
"""


def test_spheres_that_keep_to_their_line_meet_again_on_it() -> None:
    # 4u/3 and 2u, back with -u; together 3m * 4u/3 - mu = 4m * 3u/4.
    text = BACK_FROM_A_WALL.format(wall="along j", before="at rest")
    (part,) = solve(parse(text)).parts.values()
    assert [str(item.answers[0].exact) for item in part.items] == ["('3*u/4', '0')"] * 2


@pytest.mark.parametrize(
    ("wall", "before"),
    [("along j", "velocity u j"), ("along 60°", "at rest")],
    ids=["they pass each other", "the wall turns one aside"],
)
def test_spheres_that_leave_their_line_have_another(wall: str, before: str) -> None:
    (part,) = solve(parse(BACK_FROM_A_WALL.format(wall=wall, before=before))).parts.values()
    assert all(isinstance(item.error, RestitutionError) for item in part.items)


# A goes on with u/4, B with 3u/4, which comes back with 3eu/4. Then A has (1 - 9e)u/16 and B
# (3 - 3e)u/16, which the wall sends back with 3e(1 - e)u/16: they meet if 1 - 6e - 3e² > 0.
TWICE = """
wall W: along j
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along i, e = 1/2
B hits W: e = {0}
A hits B: along i, e = 1/2
"""


@pytest.mark.parametrize(("e", "meet"), [("1/10", True), ("1/4", False), ("1/2", False)])
def test_a_sphere_that_moves_on_to_a_wall_comes_back(e: str, meet: bool) -> None:
    assert only(TWICE.format(e) + "show A and B collide again").holds is meet
    assert only(TWICE.format(e) + "show A and B do not collide again").holds is not meet


@pytest.mark.parametrize(("claim", "holds"), [("f > 0", False), ("f >= 0", True)])
def test_that_a_sphere_may_stop_at_the_wall_is_not_left_out(claim: str, holds: bool) -> None:
    """Also with f = 0, where B stops at the wall, A comes after it."""
    text = LINE.format("j", "3i", "0i", "f") + "given A and B collide again\n"
    assert only(f"{text}show {claim}").holds is holds
