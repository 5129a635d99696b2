"""On what a line rests: true ones above it, his own values, a condition, or nothing true."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

import restitution

RANGE = """
sphere A: mass m, velocity 3u at 60°
sphere B: mass 2m, velocity u at 60° from -i
A hits B: along i
given along(velocity(A), i) < 0
find range of e
"""
TURNED = """
sphere A: mass m, velocity u at alpha
sphere B: mass lambda m, velocity -u i
A hits B: along i, e = 1/2
given along(velocity(A), i) < 0, tan(alpha) = 3/4
find range of lambda
"""
SHOWN = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = 1/3
show tan(angle(velocity(A), line_of_centres)) = 3 tan(alpha)
"""
WALLS = """
wall W: along i
wall X: along -60°
sphere P: velocity u at -30°
P hits W: e = 1/3
P hits X: e = 1/2
part a
find speed(P, 1), direction(P, 1)
part b
find speed(P)
"""
EITHER = """
sphere A: mass m, velocity u at 45°
sphere B: mass 2m, at rest
A hits B: along i
given angle(velocity(A), line_of_centres) = arctan(4)
find e
"""
ACROSS = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 4, velocity i - 2j
A hits B: along j, e = 1/2
find velocity(A), velocity(B)
"""
OBLIQUE = """
sphere A: mass 3, velocity 5 at alpha
sphere B: mass 2, velocity -3i + 4j
given tan(alpha) = 3/4
A hits B: along i, e = 3/7
part a
find velocity(A), velocity(B)
part b
find energy_lost
part c
find deflection(B)
"""
LETTERS = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}


@cache
def solved(statement: str) -> restitution.Solution:
    return restitution.solve(restitution.parse(statement))


def marked(
    statement: str, working: str, letters: dict[str, str] | None = None, part: str | None = None
) -> dict[str, Any]:
    marking = restitution.mark(solved(statement), working, part=part, letters=letters or LETTERS)
    found: dict[str, Any] = marking.json()
    return found


def verdicts(found: dict[str, Any]) -> list[str]:
    return [line["verdict"] for line in found["lines"]]


def points(found: dict[str, Any]) -> dict[str, str]:
    return {each["id"]: each["state"] for each in found["marks"]["points"]}


def test_an_inequality_follows_from_his_value_and_the_condition() -> None:
    working = """1.5u + 2(0.5u) = v + 2w
w - v = e(1.5u + 0.5u)
v = (2.5 - 4e)u/3
v < 0 => e > 5/8
so 5/8 < e <= 1"""
    said = verdicts(marked(RANGE, working))
    assert said == ["false", "true", "follows", "follows", "follows"]


def test_an_inequality_that_his_value_does_not_give_is_a_mistake_of_its_own() -> None:
    working = """1.5u + 2(0.5u) = v + 2w
w - v = e(1.5u + 0.5u)
v = (2.5 - 4e)u/3
e < 5/8"""
    assert verdicts(marked(RANGE, working))[-1] == "false"


def test_an_inequality_with_a_root_is_judged() -> None:
    statement = (
        "sphere A: mass 2m, velocity u at 45°\nsphere B: mass m, at rest\nA hits B: along i\n"
        "given speed(B) >= speed(A)\nfind range of e\n"
    )
    working = "3w = √2u + √2eu\n3e² + 4e - 9 >= 0\ne >= (-4 + √124)/6 = 1.19"
    said = verdicts(marked(statement, working))
    assert said == ["true", "false", "follows"]


@pytest.mark.parametrize(
    ("typed", "verdict"), [("λ > 8/19", "true"), ("λ > 8/9", "false"), ("λ > 1/9", "true")]
)
def test_a_part_of_the_range_is_not_the_range(typed: str, verdict: str) -> None:
    assert verdicts(marked(TURNED, typed)) == [verdict]


@pytest.mark.parametrize(
    ("typed", "verdict"),
    [
        ("sin²α > 0.6cos²α", "true"),
        ("sin²α > 0.68cos²α", "false"),
        ("sin²α > 0.5cos²α", "true"),
        ("tanα > 0.775", "true"),
        ("tanα > 0.825", "false"),
    ],
)
def test_what_leaves_out_a_part_of_the_range_in_another_form_is_false(
    typed: str, verdict: str
) -> None:
    statement = (
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
        "A hits B: along i, e = 3/5\ngiven speed(A) > speed(B)\nfind range of alpha\n"
    )
    assert verdicts(marked(statement, typed)) == [verdict]


def test_two_inequalities_with_a_comma_are_no_vector() -> None:
    found = marked(RANGE, "3v = 0.5u - 4eu\nv<0 so 0.5 - 4e < 0, e > 1/8")
    assert verdicts(found) == ["true", "true"]
    assert found["lines"][1]["read_as"] == "v < 0, 0.5 − 4e < 0, e > ⅛"


def test_the_condition_used_is_earned_where_the_range_is_wrong() -> None:
    working = "0.5u = v + 2w\nw - v = 2eu\n3v = 0.5u - 4eu\n0.5 - 4e < 0\ne < 1/8"
    found = marked(RANGE, working)
    assert verdicts(found)[-1] == "false"
    assert found["marks"]["lost"] == 1


def test_a_true_value_from_a_false_law_earns_no_accuracy() -> None:
    broken = "mu cosα = mv + mw\nw + v = 1/3ucosα\nv = 1/3ucosα"
    sound = "mu cosα = mv + mw\nw - v = 1/3ucosα\nv = 1/3ucosα"
    states = points(marked(SHOWN, broken)), points(marked(SHOWN, sound))
    value = next(
        each["id"]
        for each in marked(SHOWN, sound)["marks"]["points"]
        if each["for"] == "correct value"
    )
    assert [each[value] for each in states] == ["lost", "earned"]


def test_a_value_follows_through_from_another_part_and_not_from_a_law_in_one() -> None:
    whole = OBLIQUE.replace("part b\n", "").replace("part c\nfind deflection(B)\n", "")
    lost = "v = 0, w = 5\nKE lost = 1/2*3*16 + 1/2*2*(9 - 25) = 8"
    found = marked(OBLIQUE, lost, part="b"), marked(whole, "w - v = 5\n" + lost, part="a")
    states = [
        next(
            each["state"]
            for each in reversed(one["marks"]["points"])
            if each["kind"].startswith("A")
        )
        for one in found
    ]
    assert states == ["earned", "lost"]


def test_what_follows_from_a_wrong_angle_at_a_second_wall() -> None:
    working = """angle with X = 60 - 10.9 = 49.1
para = 0.882ucos49.1 = 0.577u
perp = 0.5 x 0.882u sin49.1 = 0.333u
speed = √(0.577² + 0.333²)u = 0.666u"""
    found = marked(WALLS, working, {"q": "speed(P)"}, part="b")
    assert verdicts(found) == ["false", "follows", "follows", "follows"]
    assert found["lines"][0]["mistake"]["id"] is None
    assert [each["state"] for each in found["marks"]["points"] if each["kind"] == "B1"] == [
        "earned",
        "earned",
    ]


def test_one_of_two_values_is_not_the_answer() -> None:
    start = "u/√2 = v + 2w\nw - v = eu/√2\n"
    one = marked(EITHER, start + "1 - 2e = 3/4\ne = 1/8")
    both = marked(EITHER, start + "1 - 2e = ±3/4\ne = 1/8 or 7/8")
    assert set(verdicts(one)) == set(verdicts(both)) == {"true"}
    assert both["marks"]["lost"] == 0
    assert one["marks"]["lost"] > 0


def test_momenta_across_the_line_of_centres_are_no_law() -> None:
    found = marked(ACROSS, "2*3 + 4*1 = 2v + 4w")
    assert found["lines"][0]["verdict"] == "true"
    assert found["lines"][0]["principle"] == "unchanged"
    assert all(
        each["state"] == "lost"
        for each in found["marks"]["points"]
        if "momentum" in each["for"] or "Newton" in each["for"]
    )


def test_given_angles_solve_nothing() -> None:
    found = marked(OBLIQUE, "sinα=3/5 cosα=4/5\n12 - 6 = 3v + 2w", part="a")
    earned = [each["kind"] for each in found["marks"]["points"] if each["state"] == "earned"]
    assert earned == ["B1", "M1", "A1"]


def test_an_angle_to_a_line_may_be_the_acute_one() -> None:
    letters = {
        "a": "angle(velocity(B, 0), line_of_centres)",
        "b": "angle(velocity(B), line_of_centres)",
    }
    working = "tan a = 4/3, a = 53.1\ntan b = 4/3, b = 53.1\ndeflection = a + b = 106"
    found = marked(OBLIQUE, working, letters, part="c")
    assert verdicts(found) == ["true", "true", "false"]
    assert found["lines"][2]["mistake"]["id"] == "deflection-difference"


def test_the_part_of_an_energy_along_a_line_is_that_part() -> None:
    found = marked(
        OBLIQUE, "KE along i before = 24 + 9 = 33\nKE along i after = 9\nloss = 24", part="b"
    )
    assert verdicts(found) == ["true", "true", "true"]
    assert verdicts(marked(OBLIQUE, "KE before = 24 + 9 = 33", part="b")) == ["false"]


def test_a_letter_of_one_body_means_no_relative_velocity() -> None:
    statement = """
sphere A: mass m, velocity 2u i + u j
sphere B: mass m, velocity -u i + 2u j
A hits B: along i, e = 1/3
find velocity(A), velocity(B)
"""
    found = marked(statement, "u = v + w\nu = w - v\nvA = uj\nvB = ui + uj")
    assert verdicts(found)[-1] == "false"


def test_an_impulse_is_not_named_after_momentum() -> None:
    statement = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 3, velocity -2i + j
A hits B: along i
given impulse = 9
find velocity(A), velocity(B)
"""
    mistake = marked(statement, "9 = 2(v - 3)\nv = 7.5")["lines"][0]["mistake"]
    assert mistake["id"] in ("impulse-sign", "sign", None)


@pytest.mark.parametrize(
    "line",
    [
        "A: KE before = 1/2 x 3 x 25 = 37.5",
        "perp to loc for A: (4i + 3j).(-2j) = -6 and (3j).(-2j) = -6",
        "e = sep/app = 3/7",
    ],
)
def test_true_lines_with_labels_of_bodies_and_directions(line: str) -> None:
    assert verdicts(marked(OBLIQUE, line, part="a"))[0] == "true"


def test_masses_of_which_nothing_is_given_have_a_ratio() -> None:
    statement = """
sphere A: velocity 3i + j
sphere B: velocity -2i
A hits B: along i
given velocity(A) = -i + j, velocity(B) = i
find mass(A)/mass(B), e
"""
    found = restitution.mark(solved(statement), "3m - 2km = -m + km\n4m = 3km\nk = 4/3").json()
    assert verdicts(found) == ["true", "true", "true"]


@pytest.mark.parametrize("asked", ["energy_lost(A)", "energy(A, 0) - energy(A)"])
def test_an_energy_lost_is_that_of_the_body_asked_for(asked: str) -> None:
    statement = f"""
sphere A: mass 2, velocity 3i + j
sphere B: mass 1, at rest
A hits B: along i, e = 1/2
find {asked}
"""
    working = """6 = 2v + w
w - v = 1.5
v = 1.5, w = 3
kinetic energy lost = 1/2*2*(9 - 2.25) = 6.75"""
    found = restitution.mark(solved(statement), working).json()
    assert verdicts(found) == ["true"] * 4
    assert found["marks"]["lost"] == 0
    total = restitution.mark(solved(statement), working.replace("6.75", "2.25")).json()
    assert verdicts(total)[-1] == "false"


def test_left_for_lost_is_a_misread() -> None:
    statement = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/2
given energy_lost = 1/3*energy(0)
find sin(alpha)^2
"""
    working = "cos²α + 1/4sin²α = 1/3\nsin²α = 8/9"
    found = marked(statement, working, {"v": "speed(P)"})
    assert verdicts(found) == ["false", "follows"]
    assert found["lines"][0]["mistake"]["id"] == "misread"
    right = marked(statement, "cos²α + 1/4sin²α = 2/3\nsin²α = 4/9", {"v": "speed(P)"})
    assert verdicts(right) == ["true", "true"]


def test_a_component_that_stays_is_seen_in_a_remark() -> None:
    seen, unseen = (marked(OBLIQUE, text, part="a") for text in ("perp: A 3, B 4", "A 3, B 4"))
    states = [
        next(e["state"] for e in one["marks"]["points"] if "does not change" in e["for"])
        for one in (seen, unseen)
    ]
    assert states == ["earned", "lost"]


TURNED_BACK = """
sphere A: mass m, velocity 4u i
sphere B: mass 3m, velocity u i
A hits B: along i
given along(velocity(A), i) < 0
find range of e
"""
NAMELESS_WALL = """
sphere P: mass 2, velocity 4i - 3j
P hits W
wall W
given velocity(P) = i + 3j
find impulse(P), e, energy_lost
"""
AT_ANGLES = """
sphere A: mass 3, velocity 5 at alpha
given tan(alpha) = 3/4
sphere B: mass 2, velocity 2 at 120°
A hits B: along i, e = 2/5
find speed(B), energy_lost
"""
BALL = """
wall W: along i
sphere P: mass 0.5, velocity 13 at alpha to W
given tan(alpha) = 5/12
P hits W: e = 2/5
find speed(P)
"""
WAY_BACK = """
wall AB: along i
wall BC: along j
sphere P: mass m, velocity u at theta to AB
given e > 0
P hits AB
P hits BC: e = e
show velocity(P) opposite to velocity(P, 0)
"""


def kinds(found: dict[str, Any]) -> list[tuple[str, str]]:
    return [(each["kind"], each["state"]) for each in found["marks"]["points"]]


def test_a_range_has_both_its_ends() -> None:
    lines = "7u = v + 3w\nw - v = 3eu\nv = (7 - 9e)u/4\n7 - 9e < 0\n"
    one, both, apart = (
        kinds(marked(TURNED_BACK, lines + end))[-1]
        for end in ("e > 7/9", "7/9 < e <= 1", "e > 7/9\ne ≤ 1")
    )
    assert one == ("A1ft", "lost") or one == ("A1", "lost")
    assert both[1] == apart[1] == "earned"


def test_an_inequality_the_wrong_way_is_no_method() -> None:
    lines = "7u = v + 3w\nw - v = 3eu\nv = (7 - 9e)u/4\n"
    ends = ("7 - 9e > 0\n7/9 > e", "v < 0", "7 - 9e < 0")
    states = [kinds(marked(TURNED_BACK, lines + end))[-2][1] for end in ends]
    assert states == ["lost", "lost", "earned"]


def test_an_energy_by_whole_speeds_shows_no_components() -> None:
    found = marked(NAMELESS_WALL, "I = -6i + 12j\ne = √10/5\nKE lost = 25 - 10 = 15", {"v": "e"})
    earned = [each["for"] for each in found["marks"]["points"] if each["state"] == "earned"]
    assert "components" not in earned
    assert "kinetic energy" in earned


def test_an_energy_of_components_shows_no_speed() -> None:
    lines = """12 - 2 = 3v + 2w
w - v = 2
v = 6/5, w = 16/5
speed of B = 3.2
KE lost = 1.5(16 - 1.44) + (1 - 10.24) = 12.6"""
    found = marked(AT_ANGLES, lines)
    speed = [x["state"] for x in found["marks"]["points"] if x["for"].startswith("speed")]
    assert speed == ["lost"]
    assert points(found) and found["marks"]["points"][-1]["state"] == "earned"


def test_a_component_that_is_changed_below_is_not_seen() -> None:
    before = "before: 12 along the wall, 5 perp\n"
    lines = before + "along the wall after = 0.4 x 12 = 4.8\nperp after = 5"
    assert kinds(marked(BALL, lines, {"v": "speed(P)"}))[0] == ("B1", "lost")
    lines = before + "along the wall after = 12\nperp after = 2"
    assert kinds(marked(BALL, lines, {"v": "speed(P)"}))[0] == ("B1", "earned")


def test_a_direction_back_is_concluded_in_words() -> None:
    lines = """after AB: ucosθ along AB, eusinθ perp
after BC: eucosθ perp to BC, eusinθ along BC
v = -eucosθ i + eusinθ j
original u = ucosθ i - usinθ j
v = -e u so opposite direction"""
    assert kinds(marked(WAY_BACK, lines, {"v": "velocity(P)"}))[-1] == ("A1*", "earned")


SQUARE = """wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 1/4
given deflection(P) = 90°
part a
find tan(alpha)
part b
find speed(P)"""
PAIR = """sphere A: mass 2, velocity 5i + 2j
sphere B: mass 3, velocity -i + 4j
A hits B: along i, e = 1/3
find velocity(A), velocity(B)"""
BLOW = """wall W: along j
sphere P: mass 2, velocity 3i - j
P receives 4i + 8j
find velocity(P), speed(P)"""
CORNER = """wall AB: along i
wall BC: along 100°
sphere P: velocity 6 at 40° to AB
P hits AB: e = 1/2
part a
find speed(P), angle(velocity(P), AB)
P hits BC: e = 1/2
part b
find speed(P)"""
SLOWER = """wall W: along j
sphere P: mass 0.4, velocity 10 at 35° to W
P hits W: e = 0.7
find speed(P), angle(velocity(P), W)"""
HALL = """wall W: along i, through (0, 0)
wall X: along i, through (0, 6)
sphere P: mass 1, at (0, 4), velocity 3i - 2j
P hits W: e = 3/4
part a
find position(P, 1)
part b
P hits X: e = 2/3
find time(2), position(P, 2)"""


def states(statement: str, part: str | None, *lines: str, **letters: str) -> list[str]:
    """The points of a script, each with its principle: ``B1 unchanged +``."""
    solution = restitution.solve(restitution.parse(statement))
    marks = restitution.mark(solution, list(lines), part, letters).marks
    signs = {"earned": "+", "lost": "-", "open": "?"}
    return [f"{x.point.kind} {x.point.principle} {signs[x.state]}" for x in marks.points]


def test_what_stands_in_a_line_before_its_mistake_is_kept() -> None:
    own = states(PAIR, None, "10 - 3 = 2v + 3w and w - v = 4/3")
    assert own[1:5] == ["M1 momentum +", "A1 momentum +", "M1 restitution +", "A1 restitution -"]
    angles = {"b": "angle(velocity(P), W)"}
    both = "v cos b = u cos α and v sin b = 4u sin α"
    assert states(SQUARE, "a", both, "tan b = 4 tan α", **angles)[0] == "B1 unchanged +"
    assert states(SLOWER, None, "perp after = 0.7 x 10 sin35 = 4.52")[1] == "B1 restitution +"


def test_a_method_stands_above_a_slip_and_where_one_part_is_right() -> None:
    assert states(SQUARE, "b", "v² = u²/5 + u²/20", "v² = u²/25")[0] == "M1 speed +"
    lines = ["para = 8.19, perp = 4.02", "speed = √(67.1 + 4.02) = 8.43"]
    assert "M1 speed +" in states(SLOWER, None, *lines)
    assert "M1 speed -" in states(SLOWER, None, lines[0], "speed = √(60 + 4.02) = 8.00")


def test_an_impulse_without_its_mass_has_no_method() -> None:
    own = states(BLOW, None, "v = 3i - j + 4i + 8j = 7i + 7j", "speed = 7√2 = 9.90")
    assert own == [f"{x} -" for x in ("M1 impulse", "A1 impulse", "A1 answer")] + [
        "M1 speed +",
        "A1ft speed +",
    ]


def test_a_wrong_angle_to_a_wall_is_no_method_for_it() -> None:
    lines = ["angle with BC = 80 - 22.76 = 57.24", "parallel = 4.984cos57.24 = 2.697"]
    lines += ["perp = 0.5 x 4.984sin57.24 = 2.096", "speed = 3.42"]
    own = states(CORNER, "b", *lines)
    # The angle has a point of its own; the components by it, and the speed, stand.
    assert [x[-1] for x in own if x[:2] == "M1"] == ["-", "+"]
    assert [x[-1] for x in own if x[:2] == "B1"] == ["+", "+"]
    assert own[-2:] == ["DM1 speed +", "A1ft speed -"]


def test_the_coordinate_of_the_wall_need_not_be_said() -> None:
    assert states(HALL, "a", "t = 4/2 = 2", "x = 3 x 2 = 6")[-1].endswith("+")
    assert states(HALL, "a", "t = 4/2 = 2")[-1].endswith("-")


def test_a_coordinate_follows_from_his_own_time() -> None:
    solution = restitution.solve(restitution.parse(HALL))
    lines = ["6 = 2(T - 2)", "T = 5", "x = 3 x 5 = 15, position (15, 6)"]
    marking = restitution.mark(solution, lines, "b", {"T": "time(2)"})
    assert [line["verdict"] for line in marking.json()["lines"]] == ["false", "follows", "follows"]


DEFLECTED_AT_A_WALL = """wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/3
given tan(deflection(P)) = 2
find alpha"""
DEFLECTED = """sphere A: mass 3, velocity 4i - 2j
sphere B: mass 1, velocity -4i + 3j
A hits B: along i, e = 1/4
part a
find velocity(A), velocity(B)
part b
find deflection(B)"""


def test_an_angle_that_is_asked_does_not_follow_from_its_cosine() -> None:
    own = states(DEFLECTED, "b", "cosθ = (14 + 9)/(5 x 4.61) = 0.998", "θ = 3.8")
    assert own == ["M1 angle +", "A1ft angle -", "A1ft answer -"]


def test_the_difference_of_angles_is_no_deflection_at_a_wall() -> None:
    solution = restitution.solve(restitution.parse(DEFLECTED_AT_A_WALL))
    lines = ["tan b = t/3", "tan(α - b) = (t - t/3)/(1 + t²/3) = 2"]
    letters = {"t": "tan(alpha)", "b": "angle(velocity(P), W)"}
    found = restitution.mark(solution, lines, None, letters).json()["lines"][1]
    assert found["mistake"]["id"] == "deflection-difference"


def test_what_a_calculator_works_out_wrongly_is_seen_as_it_stands() -> None:
    assert states(SLOWER, None, "0.7 x 10 sin35 = -3.00")[1] == "B1 restitution +"
    assert states(SLOWER, None, "0.7 x 10 cos35 = 5.00")[1] == "B1 restitution -"
    assert states(SLOWER, None, "perp after = 0.6 x 5.736 = 3.44")[1] == "B1 restitution -"


def test_degrees_that_are_added_up_answer_for_an_angle() -> None:
    statement = """wall W: along i
sphere P: mass m, velocity u at 60° to W
P hits W: e = 1/3
find deflection(P)"""
    assert states(statement, None, "60 + 30 = 90")[-1].endswith("+")
    assert states(statement, None, "60 + 20 = 80")[-1].endswith("-")
