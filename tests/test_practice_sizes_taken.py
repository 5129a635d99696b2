"""Numbers and letters that students take as they like: speeds, times, which sphere is which."""

from __future__ import annotations

import pytest
from marked import solution_of, verdicts

import restitution

DEFLECTED = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
given tan(alpha) = 3
P hits W
given deflection(P) = 90°
find e
"""
CORNER = """
wall AB: along i
wall BC: along j
sphere P: mass m, velocity u at theta to AB
P hits AB: e = 1/2
P hits BC: e = 1/2
find velocity(P)
"""
TABLE = """
point O: (0, 0)
wall OX: from O to (8, 0)
wall XY: along j, through (8, 0)
sphere P: mass 0.2, at (2, 3), velocity 3i - 6j
P hits OX: e = 1/3
P hits XY: e = 1/2
find time(2), position(P, 2)
"""
SLANTING = """
sphere A: mass 2, velocity 15i
sphere B: mass 1, at rest
A hits B: along 4i + 3j, e = 1/2
find velocity(A), velocity(B), deflection(A)
"""
WALL = """
wall W: along i
sphere P: mass 0.5, velocity 13 at alpha to W
given tan(alpha) = 5/12
P hits W: e = 2/5
find speed(P), deflection(P), impulse
"""
LINE = """
sphere A: mass 3m, velocity 2u i
sphere B: mass m, at rest
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
"""


def test_a_vector_takes_a_size_for_the_speed() -> None:
    after = ("after i + 3ej", "perpendicular: 1 - 9e = 0", "e = 1/9")
    for first in ("let velocity before be i - 3j", "before: i - 3j"):
        assert verdicts(DEFLECTED, first, *after) == ["true"] * 4
    assert verdicts(DEFLECTED, "take u = √10", *after)[1:] == ["true"] * 3
    assert verdicts(DEFLECTED, "before: i + 3j")[0] == "false"
    assert verdicts(DEFLECTED, "before: i - 3j", "after: i + 2ej")[1] == "false"


def test_a_speed_of_the_question_may_stand_for_the_velocity() -> None:
    lines = ("u = ucosθ i - usinθ j", "v = -½ucosθ i + ½usinθ j", "v = -½u so opposite")
    assert verdicts(CORNER, *lines) == ["true"] * 3
    assert verdicts(CORNER, *lines[:2], "v = -¼u")[-1] == "false"
    # What is a number there is one in a label as well.
    beside = verdicts(CORNER, "after AB: ucosθ along AB, ½usinθ perp", *lines)
    assert beside[0] != "false"


def test_a_letter_may_be_another_time() -> None:
    assert verdicts(TABLE, "t = 3/6 = 0.5", "total t = 6/3 = 2") == ["true", "true"]
    assert verdicts(TABLE, "t = 3/6 = 0.5", "t = 2") == ["true", "true"]
    assert verdicts(TABLE, "t = 3/6 = 0.5", "t = 3")[1] == "false"


def test_two_relations_stand_side_by_side() -> None:
    assert verdicts(TABLE, "after OX vx = 9/3 = 3 vy = 2") == ["true"]
    assert verdicts(TABLE, "after OX vx = 9/3 = 3 vy = 4") == ["false"]


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("angle between i and line of centres = 36.9", "true"),
        ("angle between v_A and line of centres = 56.3", "true"),
        ("angle between i and v_A = 19.4", "true"),
        ("angle between i and line of centres = 53.1", "false"),
    ],
)
def test_the_ends_of_an_angle_are_named(line: str, verdict: str) -> None:
    assert verdicts(SLANTING, line) == [verdict]


def test_a_small_angle_by_its_cosine_is_what_its_figures_make_of_it() -> None:
    letter = "let φ = angle of P to W after"
    assert verdicts(WALL, letter, "cosφ = 12/12.17 so φ = 9.6")[-1] == "true"
    assert verdicts(WALL, letter, "cosφ = 12/12.17 so φ = 10.6")[-1] == "false"


def test_a_wrong_deflection_moves_nothing() -> None:
    lines = ("perp 5, so 2 after", "deflection = 22.6 - 9.5 = 13.1", "I = ½(5 - 2) = 1.5")
    assert verdicts(WALL, *lines)[1:] == ["false", "false"]
    assert verdicts(WALL, *lines[:2], "I = ½(5 + 2) = 3.5")[1:] == ["false", "true"]


def test_numbers_at_the_end_are_what_is_left_to_answer() -> None:
    lines = ("speed = √(12² + 2²) = 12.2", "deflection = 22.62 + 9.46 = 32.1")
    assert verdicts(WALL, *lines, "½ x 5 - ½ x 2 = 1.5") == ["true", "true", "false"]
    assert verdicts(WALL, *lines, "½ x 5 + ½ x 2 = 3.5") == ["true", "true", "true"]


def test_one_mistake_is_likelier_than_letters_that_change_places() -> None:
    lines = ("6u = v + 3w", "w - v = u", "4w = 7u", "w = 7u/4, v = 3u/4")
    answers = ("velocity of A = 3u/4 i", "velocity of B = 7u/4 i")
    assert verdicts(LINE, *lines, *answers) == ["false", "true", *["follows"] * 4]
    marking = restitution.mark(solution_of(LINE), "\n".join((*lines, *answers))).json()
    meant = {x["letter"]: x["meaning"] for x in marking["letters"]}
    assert "velocity(A, 1)" in meant["v"]
