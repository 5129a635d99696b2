"""The student's own world, and what follows from lines by algebra alone."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from marked import verdicts

import restitution
from restitution.explaining.data.arrangement import events_of
from restitution.explaining.mistakes.misconceptions import variants_at
from restitution.expression import read_expression
from restitution.practice.judging.deduction import deduced_from
from restitution.practice.judging.entries import Entry
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.sampling import true_worlds
from restitution.practice.worlds.student import altered_world, student_world, world_of_lines
from restitution.practice.worlds.world import World

_STATEMENT = """
sphere A: mass 4, velocity 5i + 2j
sphere B: mass 1, velocity -3i + 7j
A hits B: along i, e = 1/4
find velocity(A), velocity(B)
"""
# By hand: 4v + w = 17 and w - v = 2, so v = 3 and w = 5.
_MEANINGS = {
    "v": read_expression("along(velocity(A), i)", names={"A", "B"}),
    "w": read_expression("along(velocity(B), i)", names={"A", "B"}),
}


@cache
def _world() -> World:
    (world,) = true_worlds(restitution.solve(restitution.parse(_STATEMENT)), None)
    return world


def _entry(text: str, *, right: bool = True) -> Entry:
    left, _, other = text.partition("=")
    claim = Claim(read_expression(left), "=", read_expression(other))
    return Entry(1, claim, _MEANINGS, right=right, wrong=not right)


def _holds(text: str, world: World) -> bool:
    return agrees(_entry(text).claim, world, _MEANINGS) is not None


def test_laws_that_a_wrong_line_leaves_standing_hold_on() -> None:
    # 4v + w = 23 in place of momentum: with w = v + 2, v = 21/5.
    own = student_world(_world(), [_entry("20 + 3 = 4v + w", right=False)])
    assert own is not None
    assert _holds("v = 21/5", own)
    assert _holds("w = 31/5", own)
    assert np.allclose(own.after[1, "A"].y, 2)


def test_a_wrong_value_wins_over_the_lines_before_it() -> None:
    lines = [_entry("17 = 4v + w"), _entry("w - v = 2"), _entry("v = 4", right=False)]
    latest = student_world(_world(), lines)
    first = student_world(_world(), lines, latest=False)
    assert latest is not None
    assert first is not None
    assert _holds("w = 6", latest)
    assert _holds("w = 1", first)


def test_lines_alone_carry_what_they_determine_and_nothing_else() -> None:
    both = world_of_lines(_world(), [_entry("17 = 4v + w"), _entry("w - v = 2")], ())
    one = world_of_lines(_world(), [_entry("17 = 4v + w")], ())
    assert both is not None
    assert one is not None
    assert _holds("v = 3", both)
    assert not _holds("v = 3", one)


def test_an_altered_law_stands_in_place_of_the_right_one() -> None:
    (event,) = events_of(_world().problem)
    variant = next(each for each in variants_at(event) if each.mistake == "restitution-inverted")
    world = altered_world(_world(), variant)
    assert world is not None
    # e(w - v) = 8 gives w - v = 32, and 4v + w = 17.
    assert _holds("v = -3", world)
    assert _holds("w = 29", world)


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("w = v + 2", (1,)),
        ("17 = 5v + 2", (0, 1)),
        ("v = 3", (0, 1)),
        ("v = 4", ()),
        ("w = 17 - 4v", (0,)),
    ],
)
def test_what_follows_by_algebra(text: str, places: tuple[int, ...]) -> None:
    lines = [_entry("17 = 4v + w"), _entry("w - v = 2")]
    assert deduced_from(_entry(text), lines, _world()) == places


def test_algebra_without_a_real_end_is_followed() -> None:
    line = Claim(read_expression("20 sin(alpha)^2"), "=", read_expression("30"))
    right = Claim(read_expression("sin(alpha)^2"), "=", read_expression("3/2"))
    wrong = Claim(read_expression("sin(alpha)^2"), "=", read_expression("2/3"))
    assert deduced_from(Entry(2, right), [Entry(1, line)], _world()) == (0,)
    assert deduced_from(Entry(2, wrong), [Entry(1, line)], _world()) == ()


BETWEEN_CUSHIONS = """
wall L: along j, through (0, 0)
wall R: along j, through (6, 0)
sphere P: at (2, 0), velocity 3i + j
P hits R: e = 2/3
find position(P), time(1)
P hits L: e = 1/2
find time(2), position(P)
"""


@pytest.mark.parametrize(("value", "verdict"), [("10/3", "follows"), ("8/3", "false")])
def test_a_letter_given_another_value_is_its_quantity_after_a_later_event(
    value: str, verdict: str
) -> None:
    lines = (
        "t = 4/3, y = 4/3",
        "after R v = -2i + 2/3 j",
        "time to L = 6/2 = 3 so t2 = 13/3",
        f"y = 4/3 + 2/3(3) = {value}" if verdict == "follows" else f"y = {value}",
    )
    problem = restitution.parse(BETWEEN_CUSHIONS)
    letters = {"t": "time(1)", "y": "along(position(P, 1), j)", "t_2": "time(2)"}
    marking = restitution.mark(problem, "\n".join(lines), letters=letters)
    assert [line.verdict for line in marking.lines] == ["true", "false", "true", verdict]


QUARTER_LOST = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given energy_lost = 1/4 energy(0)
find range of e
"""


@pytest.mark.parametrize(
    ("bound", "verdict"), [("1-e > ¼, e < ¾", "follows"), ("1-e > ½, e < ½", "false")]
)
def test_a_wrong_sine_is_at_most_one(bound: str, verdict: str) -> None:
    lines = "½mu²sin²α - ½meu²sin²α = ⅛mu²", "sin²α = 1/(4(1-e))", f"sin²α < 1 so {bound}"
    marking = restitution.mark(restitution.parse(QUARTER_LOST), "\n".join(lines))
    assert [line.verdict for line in marking.lines] == ["false", "follows", verdict]


_ICE = """wall W: along i
sphere P: mass 1/2, velocity 8 at 30° to W
P hits W: e = 3/4
find speed(P), impulse"""
_UNKNOWN = """wall W: along j
sphere P: mass 3, velocity 2a i + a j
P hits W: e = 1/2
given speed(P) = 4
find a, impulse"""
_RANGE = """sphere A: mass 2m, velocity 3u i
sphere B: mass 5m, velocity u i
A hits B: along i
find velocity(B)
unknown e
find range of impulse"""


@pytest.mark.parametrize(
    ("statement", "lines", "last"),
    [
        (_ICE, "vcosθ = 8sin30\nvsinθ = 0.75×8cos30\nI = 0.5(3√3 + 4√3)", "follows"),
        (_ICE, "vcosθ = 8sin30\nvsinθ = 0.75×8cos30\nI = 0.5(3√3 - 4√3)", "false"),
        (_UNKNOWN, "v = -2ai + ½aj\na = 1.94\nI = 3(2a + 2a)", "follows"),
        (_UNKNOWN, "v = -2ai + ½aj\na = 1.94\nI = 3(2a + ½a)", "false"),
        (_RANGE, "w = (11 + 4e)u/7\nI = 5m(w + u) = 5mu(18 + 4e)/7\ne = 0: I = 90mu/7", "follows"),
        (_RANGE, "w = (11 + 4e)u/7\nI = 5m(w + u) = 5mu(18 + 4e)/7\ne = 0: I = 80mu/7", "false"),
    ],
)
def test_impulses_and_cases_follow_from_the_components_of_the_student(
    statement: str, lines: str, last: str
) -> None:
    letters = {"w": "along(velocity(B), i)"} if statement == _RANGE else {}
    marking = restitution.mark(restitution.parse(statement), lines, letters=letters)
    assert [line["verdict"] for line in marking.json()["lines"]][-1] == last


def test_a_value_in_a_case_holds_in_that_case_alone() -> None:
    lines = "w = (11 + 4e)u/7\nI = 5m(w - u)\ne = 0: I = 20mu/7\ne = 1: I = 40mu/7"
    letters = {"w": "along(velocity(B), i)"}
    for wrong, verdict in (("", "true"), ("\ne = 1: I = 20mu/7", "false")):
        marking = restitution.mark(restitution.parse(_RANGE), lines + wrong, letters=letters)
        assert marking.json()["lines"][-1]["verdict"] == verdict


def test_the_impulse_on_the_other_sphere_is_opposite_to_his_own() -> None:
    statement = (
        "sphere A: mass 2, velocity 5i + 3j\nsphere B: mass 4, at rest\nA hits B\n"
        "given velocity(A) = 3i + j\nfind velocity(B)"
    )
    working = ["change in velocity of A = -2i + 4j", "impulse on A = -4i + 8j"]
    assert verdicts(statement, *working, "vB = i - 2j")[1:] == ["follows", "follows"]
    assert verdicts(statement, *working, "vB = 4i - 8j")[2] == "false"


def test_sine_and_cosine_exchanged_are_so_across_the_line_too() -> None:
    statement = (
        "sphere A: mass 3, velocity 10 at 60°\nsphere B: mass 2, at rest\n"
        "A hits B: along i, e = 3/4\nfind speed(A)"
    )
    working = ["30 sin 60 = 3v + 2w", "w - v = 7.5 sin 60", "5v = 13.0 so v = 2.60"]
    speed = "speed of A = √(2.60² + 5²) = 5.64"
    assert verdicts(statement, *working, speed)[2:] == ["follows", "follows"]
    assert verdicts(statement, *working, "speed of A = √(2.60² + 6²) = 6.54")[3] == "false"


def test_no_figure_of_a_fraction_that_is_given_is_his_own() -> None:
    """The 4 of ¾ is not the wrong 4 above, and so −1 = 1 follows from nothing."""
    statement = (
        "wall X: along i\nwall Y: along i\nsphere P: mass 1, velocity 3i - 2j\n"
        "P hits X: e = 3/4\nP hits Y: e = 2/3\nfind velocity(P)"
    )
    letters = {
        "T": "along(velocity(P, 1), i)",
        "H": "along(velocity(P, 1), j)",
        "q": "along(velocity(P, 2), j)",
    }
    lines = ["T = 4", "H = 3/4*2 = 3/2", "q = -2/3 (3/2) = 1"]
    marking = restitution.mark(restitution.parse(statement), lines, letters=letters).json()
    assert [line["verdict"] for line in marking["lines"]] == ["false", "true", "false"]


def test_nothing_follows_where_a_letter_would_have_to_be_zero() -> None:
    """Lines that hold together for u = 0 alone say nothing of a line that they would make true."""
    statement = (
        "sphere A: mass m, velocity 2u i\nsphere B: mass 3m, at rest\nA hits B: along i, e = 1/2\n"
        "find speed(A), speed(B)"
    )
    letters = {"d": "along(velocity(A), i)", "z": "along(velocity(B), i)"}
    lines = ["3u/4 - d = 1/2 (5u)", "d = -u/4", "z = 3u/5"]
    marking = restitution.mark(restitution.parse(statement), lines, letters=letters).json()
    assert [line["verdict"] for line in marking["lines"]] == ["false", "true", "false"]
