"""Directions that lines show: unit vectors, multiples of vectors, and what is no velocity yet."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest
from marked import verdicts

import restitution

TURNED = """
sphere A: mass 1, velocity 6i + 3j
sphere B: mass 2, at rest
A hits B
given velocity(A) = 3i - 3j
find e, velocity(B)
"""
WALL = """
wall W: along 3i - 4j
sphere P: mass 2, velocity 7i + j
P hits W: e = 1/2
find velocity(P)
"""


@cache
def solved(text: str) -> restitution.Solution:
    return restitution.solve(restitution.parse(text))


def marking(text: str, *lines: str, letters: dict[str, str] | None = None) -> dict[str, Any]:
    return restitution.mark(solved(text), lines, letters=letters or {}).json()


def states(found: dict[str, Any]) -> list[tuple[str, str]]:
    return [(point["kind"], point["state"]) for point in found["marks"]["points"]]


@pytest.mark.parametrize(
    "line",
    [
        "let n = (i + 2j)/√5",
        "let n = (-3i - 6j)/√45",
        "velocity of B = w(i + 2j)/√5",
    ],
)
def test_a_vector_along_the_line_of_centres_is_its_direction(line: str) -> None:
    assert states(marking(TURNED, line))[:2] == [("M1", "earned"), ("A1", "earned")]


def test_a_vector_along_another_line_is_no_direction() -> None:
    found = marking(TURNED, "let n = (2i + j)/√5")
    assert states(found)[:2] == [("M1", "lost"), ("A1", "lost")]


def test_a_scalar_product_worked_out_is_no_momentum() -> None:
    found = marking(TURNED, "let n = (3i + 6j)/√45", "(6i + 3j).n = (18 + 18)/√45 = 12/√5")
    assert found["lines"][1]["verdict"] == "true"
    assert found["lines"][1]["principle"] == "arithmetic"
    earned = [p["for"] for p in found["marks"]["points"] if p["state"] == "earned"]
    assert not any("momentum along" in purpose for purpose in earned)


def test_a_component_along_a_slanted_line_is_no_velocity() -> None:
    letters = {"w": "along(velocity(B), i + 2j)"}
    lines = "let n = (i + 2j)/√5", "12/√5 = -3/√5 + 2w", "w = 15/(2√5)"
    found = marking(TURNED, *lines, letters=letters)
    assert [line["verdict"] for line in found["lines"]] == ["remark", "true", "true"]
    assert states(found)[-2:] == [("M1", "lost"), ("A1ft", "lost")]
    whole = marking(TURNED, *lines, "velocity of B = 1.5i + 3j", letters=letters)
    assert states(whole)[-2:] == [("M1", "earned"), ("A1ft", "earned")]


def test_a_component_before_an_impact_is_no_velocity_after_it() -> None:
    found = marking(WALL, "u.(4i + 3j)/5 = 31/5", letters={"u": "velocity(P, 0)"})
    assert states(found) == [("B1", "earned"), ("B1", "lost"), ("M1", "lost"), ("A1", "lost")]


HIDDEN_WALL = """
wall W
sphere P: mass 2, velocity 7i + j
P hits W
given velocity(P) = 3i + 5j
find direction(W), e
"""


@pytest.mark.parametrize(
    ("typed", "state"),
    [
        ("wall is along i + j", "earned"),
        ("W is parallel to i + j", "earned"),
        ("so the wall is in the direction 2i + 2j", "earned"),
        ("wall = (1, 1)", "earned"),
        ("the wall is along i - j", "lost"),
        ("wall is perpendicular to the impulse so it is parallel to i + j", "earned"),
        ("W ⟂ -i + j => along (1, 1)", "earned"),
        ("I = 11.3, wall parallel to 2i + 2j", "earned"),
        ("W is perpendicular to J, so parallel to i + 2j", "lost"),
    ],
)
def test_a_wall_lies_along_a_vector(typed: str, state: str) -> None:
    text = f"change = -4i + 4j\n{typed}"
    marking = restitution.mark(restitution.parse(HIDDEN_WALL), text).json()
    _, of_wall, *_ = [point for point in marking["marks"]["points"] if point["kind"][0] == "A"]
    assert of_wall["state"] == state
    assert marking["lines"][1]["verdict"] == ("true" if state == "earned" else "false")


@pytest.mark.parametrize(
    ("typed", "verdict"),
    [
        ("gradient of J = -1", "true"),
        ("grad of change in velocity = 4/(-4) = -1", "true"),
        ("Δv of P = -4i + 4j", "true"),
        ("Δv for P = -4i - 4j", "false"),
        ("impulse has gradient -1, m1 m2 = -1 so gradient of W = 1", "true"),
        ("slope of v - u is 1", "false"),
    ],
)
def test_an_impulse_has_the_gradient_of_a_change_of_velocity(typed: str, verdict: str) -> None:
    text = f"J = 2(3i + 5j - 7i - j) = -8i + 8j\n{typed}"
    marking = restitution.mark(restitution.parse(HIDDEN_WALL), text).json()
    assert [line["verdict"] for line in marking["lines"]] == ["true", verdict]


BLOW = """
sphere P: mass 2, velocity 3i + 3j
P receives 4i - 8j
find velocity(P), deflection(P)
"""


@pytest.mark.parametrize(
    "typed", ["angles 45 and 11.3", "angle before 45, angle after 11.3", "angle = 11.3"]
)
def test_an_angle_beside_a_blow_may_be_one_to_i(typed: str) -> None:
    text = f"v = 5i - j\n{typed}\ndeflection = 56.3"
    marking = restitution.mark(restitution.parse(BLOW), text).json()
    assert [line["verdict"] for line in marking["lines"]] == ["true", "true", "true"]


@pytest.mark.parametrize(
    ("typed", "state"),
    [
        ("unit vector = (3i + 4j)/5", "earned"),
        ("so the unit vec: 0.6i + 0.8j", "earned"),
        ("unit vector along I = -0.6i - 0.8j", "earned"),
        ("a unit vector in the direction of the impulse is (3i + 4j)/5", "earned"),
        ("unit vector = (4i - 3j)/5", "lost"),
        ("unit vector parallel to the impulse = (4i - 3j)/5", "lost"),
    ],
)
def test_a_unit_vector_tells_the_line_of_centres(typed: str, state: str) -> None:
    statement = "sphere A: mass 2, velocity 5i + 2j\nsphere B: mass 1, velocity -3i - 7j\n"
    statement += "A hits B\ngiven velocity(A) = 2i - 2j\nfind line_of_centres"
    lines = ["change in velocity of A = -3i - 4j", typed]
    marking = restitution.mark(restitution.solve(restitution.parse(statement)), lines)
    assert (marking.lines[1].verdict == "false") is ("parallel" in typed)
    alone = restitution.mark(restitution.solve(restitution.parse(statement)), typed)
    assert alone.marks.points[-1].state == state


def test_the_change_for_a_body_is_one_of_velocity_or_of_momentum() -> None:
    statement = "sphere A: mass 2, velocity 4i + j\nsphere B: mass 3, velocity -i + 2j\n"
    statement += "A hits B\ngiven velocity(A) = i + 2j\nfind line_of_centres"
    lines = ["change for A = -3i + j", "change for A = -6i + 2j", "change for A = -3i + 3j"]
    assert [verdicts(statement, line) for line in lines] == [["true"], ["true"], ["false"]]


def test_the_angle_of_a_path_beside_a_wall_that_slants_is_to_an_axis_too() -> None:
    slanting = (
        "wall W: along 3i - j\nsphere P: mass 2, velocity 5i - 12j\nP hits W: e = 1/2\n"
        "find velocity(P)"
    )
    line = "angle of wall: tan⁻¹(1/3) = 18.43°, angle of path: tan⁻¹(12/5) = 67.38°"
    assert verdicts(slanting, line, "angle of path = 48.95") == ["true", "true"]
    assert verdicts(slanting, line, "angle of path = 57.38") == ["true", "false"]
