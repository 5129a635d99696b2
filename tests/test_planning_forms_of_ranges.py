"""A range of several forms, worked out where what is divided by has its sign by their condition."""

from __future__ import annotations

import re

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

SPHERES = """
sphere A: mass m, velocity u{angle}
sphere B: mass k m, at rest
wall W: along j
A hits B: along i
{more}
find range of {asked}
"""
WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given {given}
find range of {asked}
"""

TWO_WALLS = """
wall X: along j, through (0, 0)
wall Y: along j, through (d, 0)
sphere P: at (0, 0), velocity u i
P hits Y
P hits X
given time(2) >= 3 d/u
find range of e
"""

CASES = {
    "collide again": (
        SPHERES.format(
            angle=" i", more="B hits W: e = 1/2\ngiven A and B collide again", asked="e"
        ),
        ["e < 3/(2k − 1), as k ≥ 2", "This holds for k ≥ 2.", "0 ≤ e ≤ 1, for k < 2"],
    ),
    "the faster": (
        SPHERES.format(angle=" i", more="given speed(A) < speed(B)", asked="e"),
        ["0 < e < 2/(k − 1)", "This holds for k ≥ 3.", "0 < e ≤ 1, for k < 3"],
    ),
    "of an angle": (
        SPHERES.format(angle=" at alpha", more="given deflection(A) < 90°", asked="k"),
        ["as tan²α < e", "This holds for α < arctan(√e).", "k > 0, for α ≥ arctan(√e)"],
    ),
    "a root": (
        WALL.format(given="energy(P) >= 1/2 energy(0)", asked="alpha"),
        ["tan²α ≤ 1/(1 − 2e²)", "0° < α ≤ arctan(1/√(1 − 2e²))", "for e ≥ 1/√2"],
    ),
    "a coefficient that divides": (
        WALL.format(given="deflection(P) > 90°", asked="alpha"),
        [
            "tan²α > 1/e",
            "tan α > 1/√e, as α is acute",
            "This holds for e > 0 only, as there is no such α otherwise.",
        ],
    ),
    "the lesser of two": (
        WALL.format(given="deflection(P) <= 90°", asked="e"),
        [
            "so the scalar product of the velocities before and after is not negative",
            "0 ≤ e ≤ 1/tan²α",
            "0 ≤ e ≤ 1, for α ≤ 45°",
        ],
    ),
}


@pytest.mark.parametrize(("text", "lines"), CASES.values(), ids=CASES)
def test_a_range_is_worked_out_in_the_form_with_letters(text: str, lines: list[str]) -> None:
    problem = parse(text)
    solution = solve(problem)
    working = re.sub(r"\s+", " ", to_text(explain(solution), 200))
    assert "not written out" not in working
    for line in lines:
        assert line in working
    assert follow(plan(solution), Oracle(roles(problem))) == ()


ALONG = SPHERES.format(angle=" i", more="", asked="").replace("find range of ", "")
EXTREMES = {
    "in cases": (
        f"{ALONG}find minimum of energy(A) over e\n",
        [
            "decreases with increasing e, e ≤ 1 and k ≤ 1 DM1",
            "= (k − 1)²mu²/(2(1 + k)²), when e = 1 A1 A1 This holds for k ≤ 1",
            "= 0, when ek − 1 = 0, so e = 1/k A1 A1 This holds for k > 1",
        ],
    ),
    "where a bar vanishes": (
        f"{ALONG}find minimum of speed(A) over k\n",
        ["speed of A ≥ 0", "least speed of A = 0, when k = 1/e", "This holds for e > 0 only"],
    ),
}


@pytest.mark.parametrize(("text", "lines"), EXTREMES.values(), ids=EXTREMES)
def test_an_extremum_has_its_working_in_each_case(text: str, lines: list[str]) -> None:
    test_a_range_is_worked_out_in_the_form_with_letters(text, lines)


def test_no_case_of_an_extremum_rests_on_another() -> None:
    derivation = plan(solve(parse(EXTREMES["in cases"][0])))
    resting: dict[int, set[str]] = {}
    for line in derivation.lines:
        resting[line.number] = set()
        for ref in line.premises:
            own = resting[ref] if isinstance(ref, int) else {ref} if "case" in ref else set()
            resting[line.number] |= own
    ends = [resting[end.line] for end in derivation.items]
    assert len(ends) == 2
    assert all(len(each) <= 1 for each in resting.values())
    assert ends[0] and not ends[0] & ends[1]


def test_a_condition_of_a_form_is_in_force_for_its_range_alone() -> None:
    text = CASES["the faster"][0] + "find speed(A)\n"
    derivation = plan(solve(parse(text)))
    lines = {end.item: end.line for end in derivation.items}
    cited = {ref for line in derivation.lines if line.item == "2" for ref in line.premises}
    assert len(lines) == 2
    assert not any(str(ref).startswith("case") for ref in cited)


def test_what_divides_a_time_is_not_zero() -> None:
    working = re.sub(r"\s+", " ", to_text(explain(solve(parse(TWO_WALLS))), 200))
    assert "(1 + e)d/(eu) ≥ 3d/u" in working
    assert "0 < e ≤ ½ A1" in working
