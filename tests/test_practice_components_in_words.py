"""Sentences about components, and what lines with them earn."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

import restitution

WALL = """
wall W: along i
sphere P: mass 2, velocity 12i - 5j
P hits W: e = 3/5
find velocity(P), speed(P)
"""
REST = """
sphere A: mass 2m, velocity 4u at 30°
sphere B: mass m, at rest
A hits B: along i, e = 1/5
part a
find speed(A), speed(B)
part b
find energy_lost
"""
BACK = """
sphere A: mass m, velocity 9u i + 3u j
sphere B: mass k m, at rest
A hits B: along i, e = 2/3
given velocity(A) in the direction of -i + j
find k
"""
LOST = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 3/4, energy_lost = 27/100 energy(0)
find e
"""
IMPULSE = """
wall W: along j
sphere P: mass 3, velocity 6i + 2j
P hits W: e = 1/2
find impulse, energy_lost
"""


@cache
def solved(text: str) -> restitution.Solution:
    return restitution.solve(restitution.parse(text))


def marking(text: str, *lines: str, part: str | None = None, **letters: str) -> dict[str, Any]:
    return restitution.mark(solved(text), lines, part=part, letters=letters).json()


def verdicts(found: dict[str, Any]) -> list[str]:
    return [line["verdict"] for line in found["lines"]]


def states(found: dict[str, Any]) -> list[tuple[str, str]]:
    return [(point["kind"], point["state"]) for point in found["marks"]["points"]]


@pytest.mark.parametrize("word", ["stays", "remains", "is unchanged at"])
def test_a_component_that_stays_is_one_after(word: str) -> None:
    found = marking(WALL, f"parallel {word} 12", f"perpendicular {word} 5")
    assert verdicts(found) == ["true", "false"]
    assert found["lines"][0]["principle"] == "unchanged"
    assert found["lines"][1]["principle"] == "restitution"


def test_a_sphere_has_components_along_and_across_the_line() -> None:
    right = "along line of centres A has 4u cos 30", "and across it 4u sin 30"
    wrong = "along line of centres A has 4u sin 30", "and across it 4u cos 30"
    assert verdicts(marking(REST, *right, part="a")) == ["true", "true"]
    found = marking(REST, *wrong, part="a")
    assert verdicts(found)[0] == "false"
    assert found["lines"][0]["mistake"]["id"] == "sine-cosine"


def test_a_sphere_that_goes_back_has_its_component_turned() -> None:
    assert verdicts(marking(BACK, "A goes back at 3u")) == ["true"]
    assert verdicts(marking(BACK, "A goes back at 4u")) != ["true"]


def test_energies_along_the_line_only_need_no_component_across() -> None:
    lines = "along the line only: KE before = 1/2 × 2m × 12u^2 = 12mu^2", "KE lost = 96mu^2/25"
    assert verdicts(marking(REST, *lines, part="b")) == ["true", "true"]
    whole = marking(REST, "KE before = 1/2 × 2m × 12u^2 = 12mu^2", part="b")
    assert verdicts(whole) == ["false"]


def test_an_impulse_along_an_axis_is_given_by_its_vector() -> None:
    found = marking(IMPULSE, "impulse = 3(-3i + 2j) - 3(6i + 2j) = -27i")
    assert states(found)[1:3] == [("M1", "earned"), ("A1", "earned")]


def test_an_energy_equation_is_earned_below_which_there_is_a_slip() -> None:
    lines = "perp after = 3eu/5", "9(1 - e^2) = 27/4", "e^2 = 3/4"
    found = marking(LOST, *lines)
    assert verdicts(found) == ["true", "true", "false"]
    assert states(found)[2:4] == [("DM1", "earned"), ("A1", "earned")]


def test_a_velocity_with_the_coefficient_in_it_has_the_component_that_stays() -> None:
    text = WALL.replace("e = 3/5", "").replace(": \nfind velocity(P), speed(P)", "")
    found = marking(text + "given speed(P) = 12.5\nfind e", "after: 12i + 5ej")
    assert ("B1", "earned") in states(found)


def test_a_law_upside_down_has_its_component_all_the_same() -> None:
    corner = """
wall AB: along i
wall BC: along j
sphere P: velocity 4 at 60° to AB
P hits AB: e = 1/2
P hits BC: e = 1/3
find speed(P)
"""
    found = marking(corner, "towards BC: 4 cos 60 = 2", "perp after = 3 × 2 = 6")
    assert found["lines"][-1]["mistake"]["id"] == "restitution-inverted"


TWO = """
sphere A: mass 2, velocity 5i + j
sphere B: mass 4, velocity -i + 3j
A hits B: along i
given impulse = 14
find velocity(A), velocity(B), e
"""
LANE = """
wall V: along i, through (0, 12)
wall U: along i, through (0, 0)
sphere P: at (0, 3), velocity 2i + 3j
P hits V: e = 1/3
part a
find time(1), velocity(P)
P hits U: e = 1/2
part b
find time(2), position(P)
"""
AT_EIGHT = """
wall W: along i
sphere P: mass 2, velocity 3i - 8j
P hits W
given energy_lost = 48
find e
"""


def test_an_impulse_divided_by_the_mass_is_its_equation() -> None:
    found = marking(TWO, "v = 5 - 7 = -2", v="along(velocity(A), i)")
    assert found["lines"][0]["principle"] == "impulse"
    assert states(found)[:2] == [("M1", "earned"), ("A1", "earned")]


def test_newtons_law_with_his_own_values_is_no_value_alone() -> None:
    lines = "v = 5 - 7 = -2", "10 + 4 = 2(-2) + 4w", "w = 4.5", "e = (4.5 + 2)/6"
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    found = marking(TWO, *lines, **letters)
    assert verdicts(found) == ["true", "false", "follows", "follows"]
    assert states(found)[-3:-1] == [("M1", "earned"), ("A1ft", "earned")]


def test_a_time_with_its_unit_and_a_component_beside_a_wrong_one_are_seen() -> None:
    found = marking(LANE, "3 seconds", "velocity = 2/3 i - j", part="a")
    assert [state for _, state in states(found)] == ["earned"] * 2 + ["lost", "earned", "lost"]
    assert states(marking(LANE, "3", "velocity = 2/3 i - j", part="a"))[1] != ("A1", "earned")


def test_a_coordinate_is_that_of_the_place_that_is_asked() -> None:
    time = "time = 3 + 12/1 = 15"
    assert verdicts(marking(LANE, time, "x = 6 + 2 × 12 = 30", part="b"))[1] == "true"
    assert verdicts(marking(LANE, time, "x = 6 + 1 × 12 = 18", part="b"))[1] == "false"


@pytest.mark.parametrize(
    ("line", "name"),
    [
        ("9 + 8e^2 = 25", "square-not-taken"),
        ("½ × 2 × (8e)^2 = 25", "energy-component-missing"),
    ],
)
def test_squares_of_a_speed_at_a_wall_show_what_is_wrong_in_them(line: str, name: str) -> None:
    found = marking(AT_EIGHT, line)
    assert verdicts(found) == ["false"]
    assert found["lines"][0]["mistake"]["id"] == name


def test_a_separation_as_great_as_the_approach_has_no_coefficient() -> None:
    lines = "v = -3u", "w + 3u = 9u"
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    found = marking(BACK, *lines, **letters)
    assert verdicts(found) == ["true", "false"]
    assert found["lines"][1]["mistake"]["id"] == "restitution-omitted"


def test_what_true_lines_decide_is_solved_wrongly_in_decimals() -> None:
    text = """
sphere A: mass 3m, velocity u at 45°
sphere B: mass 2m, at rest
A hits B: along i
given tan(angle(velocity(A), line_of_centres)) = 2, along(velocity(A), i) > 0
find e
"""
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    lines = "v = u cos45 / 2 = 0.354u", "3 × 0.707u = 3 × 0.354u + 2w", "w = 1.06u"
    found = marking(text, *lines, **letters)
    assert verdicts(found) == ["true", "true", "false"]
    assert found["lines"][2]["mistake"]["kind"] != "misconception"


def test_momentum_of_vectors_is_another_equation_than_along_the_line() -> None:
    text = """
sphere A: mass 2, velocity 10i
sphere B: mass 1, at rest
A hits B: along 4i + 3j, e = 1/2
find velocity(B), velocity(A)
"""
    lines = (
        "20 = 2v + w",
        "w - v = 1/2 x 10 = 5",
        "v = 5, w = 10",
        "velocity of B = 10(4i + 3j)/5 = 8i + 6j",
        "20i = 2a + 8i + 6j",
    )
    along = "along(velocity({}), 4i + 3j)".format
    found = marking(text, *lines, v=along("A"), w=along("B"), a="velocity(A)")
    purposes = {point["for"]: point["state"] for point in found["marks"]["points"]}
    assert purposes["conservation of momentum along the line of centres"] == "lost"
    assert purposes["conservation of momentum"] == "earned"


def test_a_time_over_a_whole_speed_is_of_no_component() -> None:
    found = marking(LANE, "t = 9/√13 = 2.50", part="a", t="time(1)")
    assert found["lines"][0]["mistake"]["id"] == "speed-for-component"
    assert states(found)[:2] == [("M1", "lost"), ("A1", "lost")]
    right = marking(LANE, "t = 9/3 = 3", part="a", t="time(1)")
    assert states(right)[:2] == [("M1", "earned"), ("A1", "earned")]


def test_a_speed_that_follows_is_not_the_one_before() -> None:
    lines = "parallel = 12 after", "perpendicular stays 5", "speed = √(144 + 25) = 13"
    assert verdicts(marking(WALL, *lines))[1:] == ["false", "follows"]
    assert verdicts(marking(WALL, "initial speed = √(144 + 25) = 13")) == ["true"]


def test_a_root_without_squares_is_no_pythagoras() -> None:
    points = {
        line: marking(WALL, "velocity of P = 12i + 3j", line)["marks"]["points"]
        for line in ("speed = √(12 + 3) = 3.87", "speed = √(144 + 3) = 12.1")
    }
    method = {
        line: next(x["state"] for x in found if x["for"].startswith("speed"))
        for line, found in points.items()
    }
    assert list(method.values()) == ["lost", "earned"]


def test_an_angle_worked_out_is_the_value_of_its_tangent() -> None:
    text = WALL.replace("find velocity(P), speed(P)", "find velocity(P), deflection(P)")
    lines = "velocity of P = 12i + 3j", "tan^-1(3/12) = 14.0", "tan^-1(5/12) = 22.6"
    found = marking(text, *lines)
    angles = [x["state"] for x in found["marks"]["points"] if "angle" in x["for"]]
    assert angles and "earned" in angles


def test_whole_numbers_called_components_into_a_wall_are_seen() -> None:
    slanted = """
wall W: along 4i + 3j
sphere P: mass 2, velocity 10i - 5j
P hits W: e = 1/2
find velocity(P)
"""
    right = states(marking(slanted, "5 along the wall, 10 into the wall"))
    wrong = states(marking(slanted, "10 along the wall, 5 into the wall"))
    assert right[0] == ("B1", "earned")
    assert wrong[0] == ("B1", "lost")


# By hand: (8, -6) → (8, 4.5) by AB, then (-2, 4.5) by BC.
SQUARE = """
wall AB: along i
wall BC: along j
sphere P: mass 2, velocity 8i - 6j
P hits AB: e = 3/4
P hits BC: e = 1/4
find velocity(P), speed(P)
"""


@pytest.mark.parametrize(
    ("line", "verdict", "earned"),
    [
        ("vector (8, -6) becomes (8, 4.5) then (-2, 4.5)", "true", True),
        ("8i - 6j becomes 8i + 4.5j, then -2i + 4.5j", "true", True),
        ("(8, -6) becomes (8, 4.5)", "true", False),
        ("(8, -6) becomes (8, 1.5) then (-2, 1.5)", "false", False),
        ("(8, -6) becomes (-2, 4.5) then (8, 4.5)", "false", False),
        ("(8, -6) → (8, 3/4 × 6) = (8, 4.5) → (-2, 4.5)", "true", True),
        ("P: 8i - 6j => 8i + 4.5j -> -2i + 4.5j", "true", True),
        ("at AB: (8, -6) → (8, 4.5)", "true", False),
        ("at AB: (8, -6) → (8, -4.5)", "false", False),
        ("after BC = -2i + 4.5j", "true", True),
        ("after the first wall = (8, 4.5)", "true", False),
        ("after BC = 2i + 4.5j", "false", False),
    ],
)
def test_a_vector_becomes_another_at_every_impact(line: str, verdict: str, earned: bool) -> None:
    found = marking(SQUARE, line)
    assert verdicts(found) == [verdict]
    (answer,) = [p for p in found["marks"]["points"] if p["for"] == "correct answer"][:1]
    assert (answer["state"] == "earned") == earned


def test_a_wrong_velocity_after_the_second_wall_withdraws_none_after_the_first() -> None:
    statement = SQUARE.replace("find velocity(P), speed", "find velocity(P, 1), velocity")
    found = marking(statement, "after AB: 8i + 4.5j", "after BC: 2i + 4.5j")
    assert verdicts(found) == ["true", "false"]
    states = [point["state"] for point in found["marks"]["points"]]
    assert states == ["earned"] * 4 + ["lost"] * 2


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("perp before 6, perp after ¾ of it = 4.5", "true"),
        ("into AB 6, out of AB three quarters of that = 4.5", "true"),
        ("into AB 6, out of AB 1/4 of it = 1.5", "false"),
        ("along AB 10cos(36.9) = 8 - doesn't change", "true"),
        ("along AB = 8 - it stays the same", "true"),
        ("along AB = 6 - unchanged", "false"),
    ],
)
def test_a_line_goes_back_to_its_own_value(line: str, verdict: str) -> None:
    statement = SQUARE.replace("P hits BC: e = 1/4\n", "")
    assert verdicts(marking(statement, line)) == [verdict]


@pytest.mark.parametrize(
    ("line", "principle"),
    [
        ("into AB 10sin(36.87) = 6.00, out of AB ¾ of it = 4.5", "restitution"),
        ("before AB: along AB 10cos(36.87) = 8.00 - doesn't change", "unchanged"),
    ],
)
def test_a_law_behind_a_component_is_that_of_the_line(line: str, principle: str) -> None:
    statement = SQUARE.replace("P hits BC: e = 1/4\n", "")
    assert marking(statement, line)["lines"][0]["principle"] == principle


# By hand: A has 4u along the line and 3u across it; 12u = 3v + w, w - v = 2u.
RATIO = """
sphere A: mass 3m, velocity 5u at alpha
given tan(alpha) = 3/4
sphere B: mass m, at rest
A hits B: along i, e = 1/2
find speed(A), speed(B)
"""
ALONG = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}


@pytest.mark.parametrize("first", ["A along the line 5u × 3/5 = 3u", "along 5u × 3/5 = 3u"])
def test_a_component_resolved_by_the_other_ratio_is_gone_on_with(first: str) -> None:
    found = marking(RATIO, first, "across 4u", "9u = 3v + w", "w - v = 1.5u", **ALONG)
    assert verdicts(found)[0] == "false"
    assert found["lines"][0]["mistake"]["id"] == "sine-cosine"
    assert verdicts(found)[2:] == ["follows", "follows"]
    right = [first.replace("3/5 = 3u", "4/5 = 4u"), "across 3u", "12u = 3v + w", "w - v = 2u"]
    assert verdicts(marking(RATIO, *right, **ALONG)) == ["true"] * 4


def test_a_component_that_is_no_share_of_the_speed_is_not_named() -> None:
    (line,) = marking(RATIO, "along 3.2u", **ALONG)["lines"]
    assert line["verdict"] == "false"
    assert line["mistake"]["id"] is None


def test_a_share_of_a_wrong_number_follows() -> None:
    """The coefficient times a whole number that is wrong, beside another wrong number."""
    statement = """
    sphere A: mass 1, velocity 10i
    sphere B: mass 2, at rest
    A hits B: along 4i + 3j, e = 1/2
    find velocity(A), velocity(B)
    """
    letters = {"v": "along(velocity(A), 4i + 3j)", "w": "along(velocity(B), 4i + 3j)"}
    lines = ("along line of centres 10 × 3/5 = 6", "across 10 × 4/5 = 8", "6 = v + 2w")
    assert verdicts(marking(statement, *lines, "w - v = 3", **letters))[2:] == ["follows"] * 2
    assert verdicts(marking(statement, *lines, "w - v = 2", **letters))[3] == "false"


# By hand: the corner turns by 45°, and P leaves AB with (4, 2), at 26.6° to AB.
BENT = """
wall AB: along i
wall BC: along 45°
sphere P: velocity 4i - 6j
P hits AB: e = 1/3
P hits BC: e = 1/2
find speed(P)
"""


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("hits BC at 18.4°", "true"),
        ("then it strikes BC at an angle of 18.4°", "true"),
        ("hits BC at 26.6°", "false"),
        ("hits AB at 56.3°", "true"),
        ("hits AB at 33.7°", "false"),
    ],
)
def test_the_angle_at_which_a_wall_is_hit(line: str, verdict: str) -> None:
    assert verdicts(marking(BENT, line)) == [verdict]


@pytest.mark.parametrize(
    "line",
    [
        "across the line of centres speed of A × sin 60 = ½u",
        "perp to LOC speed of A sin 60 = u/2",
        "speed of A after sin 60 = u/2",
        "along the line the speed of A * cos 60 = √3u/6",
    ],
)
def test_a_speed_is_resolved_by_the_sine_or_cosine_behind_it(line: str) -> None:
    statement = "sphere A: mass m, velocity u i, radius r\nsphere B: mass m, at rest, radius r\n"
    statement += "A hits B: offset r\ngiven deflection(A) = 30°\nfind speed(A)"
    marking = restitution.mark(restitution.solve(restitution.parse(statement)), line)
    assert [judged.verdict for judged in marking.lines] == ["true"]
