"""Bodies that cannot be, and impacts that cannot: quantity, value and rule, with the place.

A clash of facts, or a sphere that misses, must not hide what is wrong.
"""

from __future__ import annotations

import pytest

import restitution
from restitution.errors import ImpossibleError
from restitution.solving.equations.solution import ItemResult

CLASH = "given speed(A, 0) = 70\n"

PAIR = "sphere A: mass 2, velocity 3i\nsphere B: mass 1, at rest\n"
PLACED = (
    "sphere A: mass 2, velocity 3i, at (0, 0), radius {r}\nsphere B: mass 1, at rest, at {at}\n"
)
HIT = "A hits B: along i, e = 1/2\n"
CIRCLE = (
    "sphere A: at (0, 0), velocity 3i\nwall W: circle centre (0, 0) radius {r}\nA hits W: e = 1\n"
)
WALL = "sphere A: velocity 3i - 4j{at}\nwall W: {wall}\nA hits W: e = 1/2\n"
ROUND = (
    "sphere A: velocity 3i, at {at}, radius {r}\n"
    "wall W: circle centre (0, 0) radius 3/2\nA hits W: e = 1\n"
)

WRONG = {
    PAIR.replace("2", "-2") + HIT: ("the mass of A is −2: a mass must be positive", 1),
    PAIR.replace("1", "0") + HIT: ("the mass of B is 0: a mass must be positive", 2),
    PAIR.replace("1", "1/3 - 1/3") + HIT: ("the mass of B is 0: a mass must be positive", 2),
    PAIR.replace("1", "m") + HIT + "given m = -2\n": (
        "the mass of B is m = −2: a mass must be positive",
        2,
    ),
    "let k = -2\n" + PAIR.replace("1", "k + 1") + HIT: (
        "the mass of B is k + 1 = −1: a mass must be positive",
        3,
    ),
    PAIR + "A hits B: along i, e = -k\n": ("e = -k where A hits B: a coefficient", 3),
    PAIR + "A hits B: along i, e = 1 + k\n": ("e = 1 + k where A hits B: a coefficient", 3),
    PAIR.replace("1", "-m") + HIT: ("the mass of B is −m: a mass must be positive", 2),
    PAIR.replace("1", "√8 - 2√2 - 10^-30") + HIT: ("a mass must be positive", 2),
    CIRCLE.format(r="-5"): ("the radius of the wall W is −5: a radius must be positive", 2),
    CIRCLE.format(r="0"): ("the radius of the wall W is 0: a radius must be positive", 2),
    CIRCLE.format(r="a - 3") + "given a = 1\n": (
        "the radius of the wall W is a - 3 = −2: a radius must be positive",
        2,
    ),
    PLACED.format(r="0", at="(5, 0)") + "A hits B: e = 1\n": (
        "the radius of A is 0: a radius must be positive",
        1,
    ),
    PLACED.format(r="-1", at="(5, 0)") + "A hits B: e = 1\n": (
        "the radius of A is −1: a radius must be positive",
        1,
    ),
    WALL.format(at="", wall="along 0i"): (
        "the wall W is along the zero vector, which has no direction",
        2,
    ),
    WALL.format(at=", at (0, 3)", wall="from (1, 2) to (1, 2)"): (
        "the wall W goes from (1, 2) to (1, 2): a wall must have a length",
        2,
    ),
    "point N: (1, 2)\n" + WALL.format(at=", at (0, 3)", wall="from N to (1, 2)"): (
        "a wall must have a length",
        3,
    ),
    PAIR + "A hits B: along (0, 0), e = 1\n": (
        "the line of centres of A and B is along the zero vector, which has no direction",
        3,
    ),
    PAIR + "A hits B: along (a - 1) i, e = 1\ngiven a = 1\n": ("along the zero vector", 3),
    PLACED.format(r="1", at="(1, 0)") + "A hits B: e = 1\n": (
        (
            "A and B overlap at the start: their centres, at (0, 0) and (1, 0), are 1 apart, "
            "less than two radii, 2"
        ),
        2,
    ),
    PLACED.format(r="r", at="(r, r)") + "A hits B: e = 1\n": ("A and B overlap at the start", 2),
    PLACED.format(r="1", at="(2 - 10^-30, 0)") + "A hits B: e = 1\n": ("A and B overlap", 2),
    ROUND.format(at="(0, 0)", r=2): (
        "A is too large to move inside W: its radius is 2, that of W 3/2",
        1,
    ),
    ROUND.format(at="(1, 0)", r=1): (
        (
            "A overlaps W at the start: its centre, at (1, 0), is 1 from that of W, whose radius "
            "is 3/2"
        ),
        1,
    ),
    ROUND.format(at="(-2, 0)", r=1): ("A overlaps W at the start", 1),
    PAIR.replace("at rest", "velocity 3i") + HIT: (
        "A and B are at rest relative to each other, and do not collide",
        3,
    ),
    PLACED.format(r="1", at="(5, 0)").replace("at rest", "velocity 3i") + "A hits B: e = 1\n": (
        "A and B are at rest relative to each other",
        3,
    ),
    PAIR.replace("at rest", "velocity 3i + j") + HIT: (
        "A and B move alike along the line of centres, and do not collide",
        3,
    ),
    PAIR + "A hits B: along i, e = 1.2\n": ("a coefficient of restitution lies in [0, 1]", 3),
    PAIR + "A hits B: along i, e = -1/2\n": ("e = -1/2", 3),
    PAIR + "A hits B: along i, e = 1 + 10^-30\n": ("e = 1 + 10^(-30)", 3),
    PAIR + "A hits B: along i, e = -10^-30\n": ("e = -10^(-30)", 3),
}


def answer(text: str) -> ItemResult:
    """The first item of a statement, solved."""
    (part, *_) = restitution.solve(restitution.parse(text)).parts.values()
    return part.items[0]


@pytest.mark.parametrize("facts", ["", CLASH], ids=["alone", "clashing"])
@pytest.mark.parametrize("text", WRONG)
def test_what_is_wrong_is_named(text: str, facts: str) -> None:
    said, line = WRONG[text]
    error = answer(text + facts + "find speed(A)\n").error
    assert isinstance(error, ImpossibleError)
    assert said.replace("10^(-30)", "10^-30") in error.message.replace("10^(-30)", "10^-30")
    assert error.line == line
    assert error.column is not None


@pytest.mark.parametrize("e", ["0", "1", "1 - 10^-30", "10^-30", "2/2"])
def test_the_ends_are_possible(e: str) -> None:
    assert answer(PAIR + f"A hits B: along i, e = {e}\nfind speed(A)").error is None


@pytest.mark.parametrize("at", ["(2, 0)", "(2 + 10^-9, 0)", "(8/5, 6/5)"])
def test_spheres_in_contact_collide_there_and_then(at: str) -> None:
    text = PLACED.format(r="1", at=at) + "A hits B: e = 1\nfind time(1), speed(A)"
    assert answer(text).error is None


def test_one_root_may_be_a_radius_and_another_not() -> None:
    """(a − 1)(a − 7) = 0, and the radius a − 3 is −2 or 4."""
    item = answer(CIRCLE.format(r="a - 3") + "given a^2 - 8a + 7 = 0\nfind a")
    assert [each.exact for each in item.answers] == ["7"]
    assert [(each.exact, each.reason) for each in item.rejected] == [
        ("1", "the radius of W must be positive")
    ]


def test_a_letter_of_a_radius_is_bounded_by_it() -> None:
    item = answer(CIRCLE.format(r="a - 3") + "find range of a")
    assert item.error is None
    assert "3" in item.answers[0].exact


def test_a_fact_may_make_a_speed_negative() -> None:
    text = PAIR.replace("3i", "-u i") + "A hits B: along i, e = 1\ngiven u = -3\nfind velocity(B)"
    assert answer(text).answers[0].exact == ("4", "0")


# --- the order of the names -----------------------------------------------------------------------

CHASE = "sphere A: mass 2, velocity {a}\nsphere B: mass 1, velocity {b}\n{hit}: along i, e = 1/2\n"


@pytest.mark.parametrize(
    ("a", "b", "helps"),
    [
        ("i", "3i", True),
        ("-i + j", "-3i + 5j", True),
        ("u i", "2u i", True),
        ("3i", "3i", False),
        ("3i + j", "3i", False),
    ],
)
def test_the_other_order_is_suggested_where_it_helps(a: str, b: str, helps: bool) -> None:
    error = answer(CHASE.format(a=a, b=b, hit="A hits B") + "find speed(A)").error
    assert isinstance(error, ImpossibleError)
    assert error.message.endswith("did you mean 'B hits A'?") == helps
    other = answer(CHASE.format(a=a, b=b, hit="B hits A") + "find speed(A)").error
    assert (other is None) == helps


def test_the_order_is_no_matter_where_places_tell_it() -> None:
    text = (
        "sphere A: mass 1, at (0, 0), velocity 2i\nsphere B: mass 1, at (5, 0), velocity 3i\n"
        "A hits B: along i, e = 1\nfind velocity(B)"
    )
    error = answer(text).error
    assert isinstance(error, ImpossibleError)
    assert error.message == "A and B are separating"


@pytest.mark.parametrize("at", ["(1/2, 0)", "(-5/2, 0)", "(-4, 0)"])
def test_a_sphere_may_touch_a_circle_that_it_leaves_or_be_apart(at: str) -> None:
    text = ROUND.format(at=at, r=1)
    problem = restitution.parse(text + "find speed(A)")
    (item,) = (item for _, item in restitution.solve(problem).items())
    assert item.error is None or "overlaps" not in item.error.message


def test_a_circle_in_letters_has_room_for_the_sphere() -> None:
    text = ROUND.format(at="(0, 0)", r=2).replace("3/2", "a") + "find range of a"
    assert answer(text).answers[0].display == "a > 2"
