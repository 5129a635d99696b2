"""Which points of a scheme lines earn that say little, or say one thing right beside another."""

from __future__ import annotations

from typing import Any

import pytest
from marked import solution_of, verdicts

import restitution

# Change of momentum of A (-6, -6): v_A = 2i - j, v_B = 2i + 4j along i + j.
BLOW = """sphere A: mass 3, velocity 4i + j
sphere B: mass 2, velocity -i + j
A hits B
given impulse(A) = -6i - 6j
find velocity(A), velocity(B), e
"""
# Along 2i - j: u_A.(2i - j) = 9, v_A.(2i - j) = 4.
CHANGE = """sphere A: mass 3, velocity 4i - j
sphere B: mass 1, velocity -i + j
A hits B
given velocity(A) = 2i
find line_of_centres, velocity(B), e
"""
TURN = """wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 2/3
show tan(deflection(P)) = 6(1 + e)/(9 - 4e)
"""
TANGENT = """sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
let theta = angle(velocity(A), line_of_centres)
show tan(theta) = 3tan(alpha)/(2 - e)
"""


def points(statement: str, *lines: str, **letters: str) -> list[tuple[str, str, bool]]:
    """The kind of each point, what it is for, and whether it is earned."""
    marking = restitution.mark(solution_of(statement), "\n".join(lines), letters=letters)
    return [(x.point.kind, x.point.purpose, x.state == "earned") for x in marking.marks.points]


def earned(statement: str, *lines: str, **letters: str) -> int:
    return sum(won for _, _, won in points(statement, *lines, **letters))


def of(statement: str, purpose: str, *lines: str, **letters: str) -> list[bool]:
    """Whether the points for one purpose are earned, in order."""
    return [won for _, p, won in points(statement, *lines, **letters) if p == purpose]


def test_components_that_are_only_listed_are_taken() -> None:
    lines = ["v_A = 2i - j", "v_B = 2i + 4j", "line of centres along (i + j)/√2"]
    listed = ["A: 5/√2 before, 1/√2 after", "B: 0 before, 6/√2 after"]
    assert of(BLOW, "components", *lines, *listed) == [True, True]
    assert of(BLOW, "components", *lines) == [False, False]
    wrong = ["A: 4/√2 before, 3/√2 after", "B: 0 before, 7/√2 after"]
    assert of(BLOW, "components", *lines, *wrong) == [False, False]


def test_components_are_used_in_a_law_that_is_upside_down() -> None:
    lines = ["change = -2i + j, so line of centres is (2i - j)/√5", "v_B = 5i - 2j", "e = 12/8"]
    assert of(CHANGE, "components", *lines) == [True, True]
    assert of(CHANGE, "Newton's experimental law", *lines) == [False]


def test_a_wrong_impulse_on_one_sphere_costs_nothing_of_the_other() -> None:
    wrong, right = "v_A = 4i + j - 6i - 6j = -2i - 5j", "v_B = -i + j + 3i + 3j = 2i + 4j"
    found = of(BLOW, "impulse as a change of momentum", wrong, right)
    assert found[:2] == [False, True]
    found = of(BLOW, "impulse as a change of momentum", right.replace("3i + 3j = 2i", "6i = 5i"))
    assert found[:2] == [False, False]


def test_a_change_of_one_velocity_is_no_momentum_of_two() -> None:
    lines = ["change in A = -2i + j", "line of centres = (2i - j)/√5", "v_B = -i + j + 2i - j = i"]
    assert of(CHANGE, "conservation of momentum", *lines) == [False]


def test_a_component_that_is_right_stands_in_a_velocity_that_is_wrong() -> None:
    statement = "wall W: along j\nsphere P: mass 2, velocity 6i + 3j\nP hits W: e = 2/3\n"
    statement += "find velocity(P)"
    kinds = points(statement, "v = -4i + 2j", v="velocity(P)")
    assert [won for _, purpose, won in kinds if "Newton" in purpose] == [True]
    kinds = points(statement, "v = -5i + 2j", v="velocity(P)")
    assert not any(won for _, _, won in kinds)


def test_a_slip_in_an_answer_is_none_in_a_line_above_it() -> None:
    statement = "wall W: along 4i - 3j\nsphere P: mass 0.6, velocity 10i + 5j\nP hits W: e = 1/2\n"
    statement += "find velocity(P)\npart b\nfind impulse(P)"
    statement = statement.replace("find velocity(P)\n", "part a\nfind velocity(P)\n")
    marking = restitution.mark(
        solution_of(statement),
        "I = 0.6(10i + 5j + i - 7j)\nI = 6.6i - 1.2j",
        part="b",
        letters={"I": "impulse(P)"},
    )
    assert marking.marks.points[-1].state == "lost"


def test_a_sum_of_angles_is_the_deflection_that_is_printed() -> None:
    lines = [
        "u cos α = v cos β",
        "e u sin α = v sin β",
        "tan β = e tan α = 2e/3",
        "tan(α + β) = (2/3 + 2e/3)/(1 - 2/3 x 2e/3)",
        "tan(α + β) = 6(1 + e)/(9 - 4e)",
    ]
    meant = {"β": "angle(velocity(P), W)", "v": "speed(P)"}
    assert all(won for _, _, won in points(TURN, *lines, **meant))


@pytest.mark.parametrize(
    ("lines", "right"),
    [
        (["tan θ = 3 tan α/(2 - e)"], False),
        (["tan θ = u sin α/v", "tan θ = 3 tan α/(2 - e)"], True),
        (["tan θ = u sin α/v = 3 tan α/(2 - e)"], True),
        (["perp component of A = u sin α", "tan θ = 3 tan α/(2 - e)"], True),
    ],
)
def test_a_printed_angle_to_which_nothing_leads_is_asserted(lines: list[str], right: bool) -> None:
    laws = ["2mu cos α = 2mv + mw", "w - v = eu cos α", "v = (2 - e)u cos α/3"]
    found = points(TANGENT, *laws, *lines, v="along(velocity(A), i)", w="along(velocity(B), i)")
    assert [won for kind, _, won in found if kind == "A1*"] == [right]


def test_a_printed_result_below_a_wrong_deflection_shows_no_method() -> None:
    lines = ["v cos b = 3u/√13", "v sin b = 2eu/√13", "tan b = 2e/3", "deflection = α - b"]
    fudged = [*lines, "so tan = 6(1 + e)/(9 - 4e)"]
    meant = {"b": "angle(velocity(P), W)", "v": "speed(P)"}
    assert of(TURN, "angle of deflection", *fudged, **meant) == [False]
    assert of(TURN, "solving for one unknown", *fudged, **meant) == [False]


def test_a_multiple_in_which_a_working_ends_is_no_value() -> None:
    statement = "sphere A: mass 1, velocity 7i + j\nsphere B: mass 2, at rest\n"
    statement += "A hits B: along 3i + 4j, e = 4/5\nfind velocity(A), velocity(B)"
    lines = ["5 = v + 2w", "w - v = 4", "3w = 9"]
    meant = {"v": "along(velocity(A), 3i + 4j)", "w": "along(velocity(B), 3i + 4j)"}
    assert of(statement, "correct value", *lines, **meant) == [False]
    assert of(statement, "correct value", *lines, "w = 3", **meant)[0]


def test_that_spheres_do_not_meet_again_is_shown_by_a_strict_inequality() -> None:
    statement = """sphere A: mass 3, velocity 10i
sphere B: mass 2, at rest
sphere C: mass 1, at rest
A hits B: along i, e = 1/2
B hits C: along i, e = 1/2
show A and B do not collide again
"""
    lines = ["30 = 3a + 2b", "b - a = 5", "a = 4", "b = 9"]
    lines += ["18 = 2p + q", "q - p = 4.5", "3p = 13.5", "p = 4.5"]
    end = ["A has 4 < 4.5", "so A never gets to B"]
    meant = {"a": "speed(A, 1)", "b": "speed(B, 1)", "p": "speed(B)", "q": "speed(C)"}
    found = points(statement, *lines, *end, **meant)
    assert found[-1][0] == "A1*"
    assert found[-1][2]


def test_a_separation_with_a_wrong_value_is_the_law() -> None:
    statement = "sphere A: mass 3, velocity 9i\nsphere B: mass 2, velocity i\n"
    statement += "A hits B: along i, e = 1/2\nfind along(velocity(A), i)"
    meant = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    law = "Newton's experimental law"
    assert of(statement, law, "w - v = 5.3", **meant) == [True]
    assert of(statement, law, "w = 5.3", **meant) == [False]
    assert of(statement, law, "w - v = 8", **meant) == [False]  # e is left out


def test_each_answer_that_early_rounding_puts_off_costs_its_own() -> None:
    statement = "wall W: along i\nsphere P: velocity 10 at 75° to W\nP hits W: e = 1/2\n"
    statement += "find speed(P), angle(velocity(P), W)"
    lines = ["parallel: 10 cos 75 = 2.6", "perp: 0.5 x 10 sin 75 = 4.8"]
    angle = "angle = tan^-1(4.8/2.6) = 61.6"
    found = points(statement, *lines, "speed = 5.48", angle)
    assert [won for kind, _, won in found if kind[0] == "A"] == [True, False]
    found = points(statement, *lines, "speed = √(2.6² + 4.8²) = 5.46", angle)
    assert [won for kind, _, won in found if kind[0] == "A"] == [False, False]


def test_nothing_is_eliminated_above_the_equations() -> None:
    lines = ["perp = 2eu/√13, parallel = 3u/√13", "tan b = 2e/3"]
    lines += ["tan(α + b) = (2/3 + 2e/3)/(1 + 4e/9)", "= 6(1 + e)/(9 - 4e)"]
    found = points(TURN, *lines, b="angle(velocity(P), W)")
    assert [won for kind, _, won in found if kind == "DM1"] == [False]


def test_a_speed_by_a_difference_of_squares_has_no_method() -> None:
    statement = (
        "wall W: along i\nsphere P: mass 2, velocity 2i - j\nP hits W: e = 1/2\nfind speed(P)"
    )
    lines = ["velocity after is 2i + 0.5j", "speed = √(4 - 0.25) = 1.94"]
    assert of(statement, "speed from its components", *lines) == [False]
    lines = ["velocity after is 2i + 0.5j", "speed = √(4 + 0.35) = 2.09"]
    assert of(statement, "speed from its components", *lines) == [True]


def test_numbers_that_add_up_are_no_slip_in_arithmetic() -> None:
    statement = "wall AB: along i\nwall BC: along 105°\nsphere P: velocity 10 at 45° to AB\n"
    statement += "P hits AB: e = sqrt(3)/3\nP hits BC: e = 1/2\nfind speed(P)"
    found: Any = restitution.mark(solution_of(statement), "angle to BC = 180 - 75 - 45 = 60").json()
    mistake = found["lines"][0]["mistake"]
    assert found["lines"][0]["verdict"] == "false"
    assert mistake["id"] != "arithmetic"


def test_a_component_by_a_vector_is_along_no_line_that_is_wrong() -> None:
    statement = "sphere A: mass m, velocity 3i\nsphere B: mass m, velocity -2i + j\nA hits B\n"
    statement += "given velocity(A) = 2i + 2j\nfind velocity(B), e, line_of_centres\n"
    assert verdicts(statement, "change in A's velocity -i + 2j", "approach 7") == ["true", "true"]
    assert verdicts(statement, "change in A's velocity i + j", "approach 7")[1] != "true"


COURT = """wall W: along j, through (6, 0)
wall V: along i, through (0, 4)
sphere P: mass 2, at (0, 0), velocity 3i + j
P hits W: e = 2/3
P hits V: e = 1/2
find time(2), position(P, 2)
"""


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("needs 2 more in y at 1 m/s = 2 s", "true"),
        ("moves 2 m at 1 m/s = 2 s", "true"),
        ("needs 2 more in y at 1 m/s = 3 s", "false"),
        ("2 s at 3 m/s = 6", "true"),
        ("x coordinate = 6 - 4 = 2", "true"),
        ("the y coordinate is 4", "true"),
        ("x-coord = 6 - 2(4) = -2", "false"),
    ],
)
def test_ways_at_a_speed_and_single_coordinates_are_read(line: str, verdict: str) -> None:
    assert verdicts(COURT, line) == [verdict]


def test_one_coordinate_at_a_wall_that_gives_the_other_is_the_place() -> None:
    kinds = points(COURT, "time = 2 + 2 = 4", "x coordinate = 6 - 2(2) = 2")
    assert all(won for kind, _, won in kinds if kind in ("M1", "A1", "A1ft"))


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("angle of line = tan^-1(4/3) = 53.13", "true"),
        ("angle of line = tan^-1(4/7) = 29.7", "false"),
        ("angle of A = tan^-1(1/7) = 8.13", "true"),
        ("angle of A = tan^-1(2/7) = 15.9", "false"),
        ("angle between = 45", "true"),
        ("angle between = 40", "false"),
    ],
)
def test_angles_to_an_axis_beside_a_line_that_slants(line: str, verdict: str) -> None:
    statement = "sphere A: mass 1, velocity 7i + j\nsphere B: mass 2, at rest\n"
    statement += "A hits B: along 3i + 4j, e = 4/5\nfind velocity(A), velocity(B)"
    assert verdicts(statement, line) == [verdict]


def test_who_goes_back_at_an_angle_has_no_component_of_that_size() -> None:
    statement = "sphere A: mass m, velocity u at alpha\nsphere B: mass 3m, at rest\n"
    statement += "A hits B: along i\ngiven tan(alpha) = 1/2, deflection(A) = 90°\nfind e"
    assert verdicts(statement, "A goes back at angle 90 - α to the line") == ["true"]
    assert verdicts(statement, "A goes back at angle 80 - α to the line") == ["false"]


def test_what_is_asked_about_a_letter_says_how_to_answer() -> None:
    statement = "wall W: along i\nsphere P: mass 2, velocity 10 at 50° to W\nP hits W: e = 1/2\n"
    solution = solution_of(statement + "find speed(P)")
    asks = restitution.mark(solution, "k sin q = 3").asks
    assert {ask.letter for ask in asks} == {"k", "q"}
    for ask in asks:
        assert f"let {ask.letter} = component of P" in ask.text
        answered = ask.text.partition("such as: ")[2].rstrip(".")
        assert restitution.mark(solution, f"{answered}\n{ask.letter} = 3.83").asks == ()


SLANTING = """wall W
sphere P: mass 2, velocity 6i + 2j
P hits W
given velocity(P) = 5j
find direction(W), e
"""


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("so wall has gradient 2", "true"),
        ("W has a slope of 1/2", "false"),
        ("wall makes 63.4 with i", "true"),
        ("the wall makes 53.1 with i", "false"),
        ("so wall is parallel to i + 2j", "true"),
        ("so wall is parallel to -2i + j", "false"),
        ("direction of wall is 2i + 4j", "true"),
        ("normal is 2i - j", "true"),
        ("unit normal to wall (2i + j)/√5", "false"),
    ],
)
def test_how_a_wall_lies_is_a_claim(line: str, verdict: str) -> None:
    assert verdicts(SLANTING, line) == [verdict]


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("angle of wall: 63.4° to i", "true"),
        ("wall is inclined at 26.6° to j", "true"),
        ("the angle of W = 63.4°", "true"),
        ("angle of the wall = 26.6°", "true"),
        ("angle of wall = tan⁻¹(2) = 63.4° to the x axis", "true"),
        ("angle of wall: 63.4° to j", "false"),
        ("wall at 18.4° to i", "false"),
        ("angle of the wall: 53.1°", "false"),
    ],
)
def test_the_angle_of_a_wall_is_to_the_axis_that_is_named_or_to_either(
    line: str, verdict: str
) -> None:
    assert verdicts(SLANTING, line) == [verdict]


def test_the_angle_of_a_line_of_centres_or_a_given_wall_is_to_the_axis_that_is_named() -> None:
    board = "wall W: along 4i + 3j\nsphere P: mass m, velocity 11i + 2j\n"
    board += "P hits W: e = 2/5\nfind velocity(P)"
    lines = {"36.9°": "true", "53.1° to j": "true", "36.9° to j": "false", "63.4°": "false"}
    for size, verdict in lines.items():
        assert verdicts(board, f"angle of wall: {size}") == [verdict], size
    spheres = "sphere A: mass 1, velocity 7i + j\nsphere B: mass 2, at rest\n"
    spheres += "A hits B: along 3i + 4j, e = 4/5\nfind velocity(A), velocity(B)"
    lines = {"53.1° to i": "true", "36.9° to j": "true", "53.1° to j": "false"}
    for size, verdict in lines.items():
        assert verdicts(spheres, f"angle of line of centres: {size}") == [verdict], size


def test_an_angle_of_a_wall_beside_an_axis_is_no_right_angle_to_the_other() -> None:
    beside = "wall W: along i\nsphere P: mass 2, velocity 10 at 50° to W\n"
    beside += "P hits W: e = 1/2\nfind velocity(P)"
    assert verdicts(beside, "angle of wall = 50°") == ["true"]
    assert verdicts(beside, "angle of wall = 90°") == ["false"]


def test_the_direction_of_a_wall_is_answered_by_its_gradient_or_its_angle() -> None:
    for line in ("so wall has gradient 2", "wall makes 63.4 with i", "wall along i + 2j"):
        assert of(SLANTING, "correct answer", "change of velocity = -6i + 3j", line)[0]
    lines = ["so wall is parallel to -2i + j", "normal is i + 2j"]
    assert verdicts(SLANTING, *lines) == ["false", "follows"]
    assert not of(SLANTING, "correct answer", *lines, "before (6i + 2j).(i + 2j) = 10")[0]


def test_newtons_law_may_be_in_numbers_of_his_own() -> None:
    law = "Newton's experimental law"
    wrong = "v_A = 4i + j - 6i - 6j = -2i - 5j"
    lines = [
        wrong,
        "v_B = -i + j + 3i + 3j = 2i + 4j",
        "along i + j: before 5 and 0, after -7 and 6",
    ]
    assert of(BLOW, law, *lines, "13 = 5e") == [True]
    assert of(BLOW, law, *lines, "e = 13/5") == of(BLOW, law, *lines)


def test_of_two_conditions_one_inequality_is_one() -> None:
    statement = "sphere A: mass m, velocity 3u i\nsphere B: mass k m, velocity -u i\n"
    statement += "A hits B: along i, e = 1/2\npart a\n"
    statement += "find along(velocity(A), i), along(velocity(B), i)\npart b\nunknown k\n"
    statement += "given along(velocity(A), i) < 0, along(velocity(B), i) > 0\nfind range of k"

    def used(*lines: str) -> int:
        marking = restitution.mark(solution_of(statement), "\n".join(lines), part="b")
        purpose = "the condition used"
        own = (x for x in marking.marks.points if x.point.purpose == purpose)
        return sum(x.state == "earned" for x in own)

    assert used("3 - 3k < 0", "k > 1") == 1
    assert used("3 - 3k < 0", "k > 1", "5 - k > 0", "1 < k < 5") == 2


def test_an_equation_is_no_condition_with_an_inequality() -> None:
    statement = "sphere A: mass m, velocity u i\nsphere B: mass 3m, at rest\nwall W: along j\n"
    statement += "A hits B: along i, e = 1/2\nB hits W: e = f\ngiven A and B collide again\n"
    statement += "find range of f"
    lines = ["v = -u/8", "w = 3u/8", "speed of B after the wall = 3fu/8"]
    used = of(statement, "the condition used", *lines, "3f/8 = 1/8", "f = 1/3")
    assert used == [False]
    assert of(statement, "the condition used", *lines, "3f/8 > 1/8", "f > 1/3") == [True]
    assert points(statement, *lines, "3f > 1", "so f > 1/3 up to 1")[-1][2]
    assert not points(statement, *lines, "3f > 1", "so f > 1/3")[-1][2]


def test_the_angle_after_is_the_one_that_is_asked_below_a_mistake() -> None:
    statement = "wall AB: along i\nwall BC: along 105°\nsphere P: velocity 10 at 45° to AB\n"
    statement += "P hits AB: e = sqrt(3)/3\nP hits BC: e = 1/2\nfind angle(velocity(P), BC)"
    lines = ["angle with BC is 75", "perp after = 8.16sin75 = 7.88", "angle after = 75"]
    assert verdicts(statement, *lines) == ["true", "false", "follows"]


def test_decimals_that_are_exact_are_no_rounding() -> None:
    statement = "wall W: along 4i + 3j\nsphere P: mass 1, velocity 10i\nP hits W: e = 1/3\n"
    statement += "find velocity(P)"
    line = "v = 8(0.8i + 0.6j) + 2(-0.6i + 0.8j)"
    for end, verdict in (("5.2i + 6.4j", "true"), ("5.2i + 6.2j", "false"), ("5i + 6.4j", "false")):
        assert verdicts(statement, line, f"v = {end}") == ["true", verdict]


def test_a_part_of_what_is_lost_alone_has_no_method() -> None:
    statement = "wall W: along i\nwall V: along j\nsphere P: mass 2, velocity -6i - 8j\n"
    statement += "P hits W: e = 1/2\nP hits V: e = 2/3\nfind total_energy_lost"
    before = ["after W -6i + 4j", "after V 4i + 4j"]
    method = "kinetic energy"
    assert not any(of(statement, method, *before, "loss = 1/2×2×(52 - 32) = 20"))
    whole = ["loss at W = 1/2×2×(100 - 52) = 48", "loss at V = 20", "total 68"]
    assert all(of(statement, method, *before, *whole))
    assert all(of(statement, method, *before, "loss = 1/2×2×(100 - 32) = 68"))


def test_a_letter_may_multiply_the_vector_along_which_a_sphere_leaves() -> None:
    statement = "sphere A: mass 1, velocity 10i\nsphere B: mass 2, at rest\n"
    statement += "A hits B: along 3i + 4j, e = 3/4\nfind velocity(A), velocity(B)"
    lines = ["10i = v_A + 2k(3i + 4j)", "v_A = 10i - 2k(3i + 4j)", "v_A.(3i + 4j) = 30 - 50k"]
    lines += ["25k - 30 + 50k = 3/4 × 30", "k = 0.7", "v_B = 2.1i + 2.8j", "v_A = 5.8i - 5.6j"]
    assert verdicts(statement, *lines) == ["true"] * 7
    assert all(won for _, _, won in points(statement, *lines))
    other = statement.replace("3i + 4j", "i + j").replace("mass 1, velocity 10i", "mass 3")
    other = other.replace("mass 3", "mass 3, velocity 6i").replace("e = 3/4", "e = 1/2")
    assert verdicts(other, "v_B = q(i + j)", "18i = 3v_A + 2q(i + j)", "q = 2.7") == ["true"] * 3
    assert verdicts(other, "v_B = q(i + j)", "18i = 3v_A + 3q(i + j)")[1] == "false"


SLOWED = """wall W: along i
sphere P: mass m, velocity u at theta to W
P hits W
given tan(theta) = 3/4, speed(P) = 7/8 u
find e"""
CORNER = """wall AB: along i
wall BC: along 70°
sphere P: velocity 9 at 35° to AB
part a
P hits AB: e = 1/2
find speed(P), angle(velocity(P), AB)
part b
P hits BC: e = 3/5
find speed(P)"""
DIAGONAL = """sphere A: mass 2, velocity 6i - 3j
sphere B: mass 3, at rest
A hits B: along i, e = 1/2
find speed(A), speed(B)"""


def test_a_speed_by_a_sum_of_components_has_no_method() -> None:
    before = ["parallel 4u/5", "perp 3eu/5"]
    method = "speed from its components"
    assert of(SLOWED, method, *before, "7u/8 = 4u/5 + 3eu/5", "e = 1/8") == [False]
    assert of(SLOWED, method, *before, "(7u/8)² = (4u/5)² + (3eu/5)²") == [True]


def test_a_ratio_of_whole_speeds_shows_no_component_that_stays() -> None:
    assert earned(SLOWED, "7u/8 = e × u", "e = 7/8") == 0


def test_an_answer_that_follows_needs_the_method_of_the_other() -> None:
    assert earned(DIAGONAL, "speed of A = 3", "speed of B = 4.5") == 0


def test_components_at_the_angle_of_the_wall_before_are_resolved() -> None:
    lines = ["parallel to BC: 7.810 cos 19.3 = 7.37", "perp: 0.6 × 7.810 sin 19.3 = 1.55"]
    marking = restitution.mark(
        solution_of(CORNER), "\n".join([*lines, "speed = √(7.37² + 1.55²) = 7.53"]), part="b"
    )
    won = [(x.point.kind, x.point.purpose) for x in marking.marks.points if x.state == "earned"]
    assert ("DM1", "speed from its components") in won
    assert ("M1", "components") in won
    assert not any(kind.startswith("A1") for kind, _ in won)


def test_another_angle_of_deflection_below_the_right_one_withdraws_it() -> None:
    statement = "wall W: along i\nsphere P: mass 2, velocity 9i - 5j\nP hits W: e = 3/5\n"
    statement += "find deflection(P)"
    lines = ["cos t = (81 - 15)/(√106 × √90)", "deflection = 47.5"]
    assert of(statement, "correct answer", *lines) == [True]
    for last in ("so it is deflected through 180 - 47.5 = 132.5", "angle of deflection = 132.5"):
        assert of(statement, "correct answer", *lines, last) == [False]


def test_that_two_speeds_are_equal_is_said_in_words() -> None:
    statement = "sphere A: mass m, velocity 5i + 3j\nsphere B: mass m, velocity i + 3j\n"
    statement += "A hits B: along i, e = 0\nshow speed(A) = speed(B)"
    lines = ["5 + 1 = v + w", "w - v = 0", "v = w = 3", "speed of A = √(9 + 9) = 3√2"]
    lines += ["speed of B = √(9 + 9) = 3√2"]
    for last in ("so the speeds are equal", "they have the same speed", "speed of A = speed of B"):
        assert points(statement, *lines, last)[-1][2]
    assert not points(statement, *lines[:4], "so the speeds are equal")[-1][2]


def test_what_is_truly_zero_may_be_a_divisor() -> None:
    statement = "sphere A: mass m, velocity u at 60°\nsphere B: mass m, at rest\n"
    statement += "A hits B: along i, e = 1\nfind deflection(A)"
    letters = {"v": "along(velocity(A), i)"}
    marking = restitution.mark(
        solution_of(statement), ["tan 30 = (√3u/2)/v", "v = 3u/2"], letters=letters
    )
    assert [line.verdict for line in marking.lines] == ["false", "follows"]


def test_an_inequality_with_a_rebound_in_letters_shows_the_law_at_the_wall() -> None:
    statement = "sphere A: mass m, velocity u i\nsphere B: mass 3m, at rest\nwall W: along j\n"
    statement += "part a\nA hits B: along i, e = 2/3\nfind velocity(A), velocity(B)\n"
    statement += "part b\nB hits W: e = f\ngiven A and B collide again\nfind range of f"
    marking = restitution.mark(
        solution_of(statement), ["catches A if 5fu/12 > u/4", "so f > 3/5"], part="b"
    )
    assert [x.state for x in marking.marks.points] == ["earned", "earned", "earned", "lost"]


def test_noughts_at_the_end_of_three_figures_may_be_left_out() -> None:
    statement = (
        "sphere A: mass 1, velocity 4 at 60°\nsphere B: mass 1, at rest\nA hits B: along i\n"
    )
    statement += "given angle(velocity(A), i) = 81.787°\nfind e"
    lines = ["tan81.787 = 3.464/x", "x = 0.500", "2 = x + y", "y = 1.5", "e = (1.5 - 0.5)/2 = 0.5"]
    assert points(statement, *lines)[-1][2]


def test_a_value_below_another_of_his_own_is_not_supported() -> None:
    statement = "sphere A: mass 2, velocity 6i + 3j\nsphere B: mass 2, at rest\nA hits B: along i\n"
    statement += "given energy_lost = 10\nfind e"
    laws = ["v + w = 6", "w - v = 6e", "w = 3 + 3e, v = 3 - 3e"]
    wrong = ["9(1 - e)² + 9(1 + e)² = 10", "18 + 18e² = 10", "e² = -4/9", "e = 2/3"]
    assert verdicts(statement, *laws, *wrong)[-4:] == ["false", "follows", "follows", "unsupported"]
    assert not points(statement, *laws, *wrong)[-1][2]
    right = ["36 - 9(1 - e)² - 9(1 + e)² = 10", "18e² = 8", "e² = 4/9", "e = 2/3"]
    assert verdicts(statement, *laws, *right) == ["true"] * 7


@pytest.mark.parametrize("line", ["A = sqrt(2² + 3²)u = 3.61u", "A=√(4+9)u", "so A = √13u"])
def test_a_root_is_the_speed_of_a_sphere(line: str) -> None:
    statement = "sphere A: mass 2m, velocity 5u i\nsphere B: mass m, at rest\n"
    statement += "A hits B: along 4i + 3j, e = 1/2\nfind speed(A)"
    assert points(statement, line)[-1][2]


def test_what_is_lost_may_be_said_below_its_negative() -> None:
    statement = "wall W: along i\nsphere P: mass 2, velocity 3i - 5j\nP hits W: e = 2/5\n"
    statement += "find energy_lost"
    lines = ["KE lost = 13 - 34 = -21", "so 21 J lost"]
    assert verdicts(statement, *lines) == ["false", "true"]
    assert points(statement, *lines)[-1][2]
    assert not points(statement, lines[0])[-1][2]


TURNED_TO = """sphere A: mass 2, velocity 5i + 3j
sphere B: mass k, velocity -3i + j
A hits B: along i, e = 1/2
given velocity(A) in the direction of -i + 3j
find k
"""


def test_a_vector_gives_the_value_of_its_component() -> None:
    for first in ("v_A = -i + 3j", "A: -i + 3j"):
        assert of(TURNED_TO, "correct value", first) == [True]
    assert of(TURNED_TO, "correct value", "v_A = -2i + 3j") == [False]


def test_a_component_that_stays_is_kept_in_vectors_below_a_slip() -> None:
    pair = (
        "sphere A: mass 2m, velocity u i + 4u j\nsphere B: mass m, velocity 3u i - 2u j\n"
        "A hits B: along j, e = 1/3\nfind velocity(A), velocity(B)"
    )
    laws = ["8mu - 2mu = 2ma + mb", "b - a = 2u", "a = 4u", "b = 6u"]
    vectors = "vA = ui + 4uj, vB = 3ui + 6uj"
    letters = {"a": "along(velocity(A), j)", "b": "along(velocity(B), j)"}
    stays = "component that the impact does not change"
    assert of(pair, stays, *laws, vectors, **letters) == [True]
    assert of(pair, stays, *laws, "vA = 4uj, vB = 6uj", **letters) == [False]


def test_a_printed_result_is_spoilt_by_what_goes_on_from_its_worth() -> None:
    wall = (
        "wall W: along j\nsphere P: mass m, velocity u at alpha\nP hits W\n"
        "show energy_lost = 1/2 m u^2 (1 - e^2) cos^2(alpha)"
    )
    result = "the printed result, from correct working"
    lines = ["v cosβ = e u cosα", "KE lost = 1/2 m u² cos²α - 1/2 m e² u² cos²α"]
    assert of(wall, result, *lines, "= 1/2 m u² cos²α (1 - e)²") == [False]
    assert of(wall, result, *lines, "= 1/2 m u² cos²α (1 - e²)") == [True]


def test_a_sign_in_the_law_that_is_the_condition_keeps_its_method() -> None:
    cars = (
        "sphere A: mass 2, velocity 8i\nsphere B: mass 1, velocity -2i\nA hits B: along i\n"
        "part a\nshow velocity(A) = (14 - 10e)/3 i\npart b\ngiven e = 4/5\nfind velocity(B)"
    )
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    for line, kept in (("w = 8 - 2 = 6", True), ("w = 2 + 8 = 10", True), ("w = 7", False)):
        marking = restitution.mark(solution_of(cars), f"v = 2\n{line}", part="b", letters=letters)
        used = [x for x in marking.marks.points if x.point.purpose == "the condition used"]
        assert [x.state == "earned" for x in used] == [kept]
