"""Marks of a part beside what earlier parts and earlier impacts have earned, and a wrong datum."""

from __future__ import annotations

from marked import solution_of

import restitution

# tan β = (1/2) tan 60° at 40.9°.
RAIL = """wall W: along i
sphere P: mass 2, velocity 6 at 60° to W
P hits W: e = 1/2
part a
find angle(velocity(P), W)
part b
find deflection(P)
"""
GLANCE = """sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
let beta = angle(velocity(A), line_of_centres)
part a
show tan(beta) = 2tan(alpha)/(1 - e)
part b
given tan(alpha) = 1/2, e = 1/3
find tan(deflection(A))
"""
# v_A = 2 and v_B = 5 along i; B comes back from the wall with -2.
BUFFER = """sphere A: mass 3, velocity 4i
sphere B: mass 2, velocity 2i
wall W: along j
A hits B: along i, e = 1
part a
find velocity(A), velocity(B)
part b
B hits W: e = 1/2
A hits B: e = 1/4
find velocity(A), velocity(B)
"""
# Along 2i + j: u_A is 7/√5, u_B is -1/√5, and after it 1/√5 and 5/√5.
LINE = """sphere A: mass 1, velocity 3i + j
sphere B: mass 1, velocity -i + j
A hits B
given velocity(A) = 3/5 i - 1/5 j
part a
find line_of_centres, velocity(B)
part b
find e
"""


def states(statement: str, part: str, *lines: str, **letters: str) -> list[tuple[str, str]]:
    """For what each point is, and whether it is earned."""
    working = "\n".join(lines)
    marking = restitution.mark(solution_of(statement), working, part=part, letters=letters)
    return [(x.point.principle, x.state) for x in marking.marks.points]


def test_an_angle_that_an_earlier_part_has_found_is_no_method_for_a_deflection() -> None:
    for last in ("deflection = 40.9°", "deflection = 60 - 40.9 = 19.1°"):
        own = states(RAIL, "b", "tan b = 0.5tan60 so b = 40.9", last, b="angle(velocity(P), W)")
        assert [state for _, state in own] == ["lost", "lost"], last
    own = states(RAIL, "b", "deflection = 60 + 40.9 = 100.9°")
    assert [state for _, state in own] == ["earned", "earned"]


def test_the_tangent_of_a_difference_is_the_method_of_a_deflection() -> None:
    wrong = "tan d = (3/2 + 1/2)/(1 - 3/4) = 8"
    right = "tan d = (3/2 - 1/2)/(1 + 3/4) = 4/7"
    for last, state in ((wrong, "lost"), (right, "earned"), ("tan d = 3/2", "lost")):
        own = states(GLANCE, "b", "tanβ = 3/2", last, d="deflection(A)")
        assert own[0] == ("deflection", state), last


def test_a_velocity_after_a_wall_implies_nothing_of_the_next_impact() -> None:
    own = states(BUFFER, "b", "w = -1/2 x 4.4 = -2.2", w="along(velocity(B, 2), i)")
    assert [state for _, state in own].count("earned") == 1


def test_scalar_products_over_the_length_of_the_vector_are_components() -> None:
    own = states(LINE, "b", "(3i + j).(2i + j)/√5 = 7/√5", "(-i + j).(2i + j)/√5 = -1/√5")
    assert own[:4] == [
        ("component", "earned"),
        ("component", "earned"),
        ("component", "lost"),
        ("component", "lost"),
    ]


def test_whole_numbers_listed_before_and_after_are_components() -> None:
    lines = ["A: before 7, after 1", "B: before -1, after 5"]
    assert [state for _, state in states(LINE, "b", *lines)[:4]] == ["earned"] * 4
    lines = ["A: before 1, after 7", "B: before 5, after -1"]
    assert [state for _, state in states(LINE, "b", *lines)[:4]] != ["earned"] * 4


def test_what_stays_is_earned_below_a_whole_speed_by_a_letter_for_the_angle() -> None:
    lines = ["speed after = 1/2 x 6 = 3", "3cos b = 6cos60"]
    statement = RAIL.replace("find angle", "find speed(P), angle")
    own = states(statement, "a", *lines, b="angle(velocity(P), W)")
    assert own[0] == ("unchanged", "earned")
    assert own[1] == ("restitution", "lost")


# tan β = 1/(1/3): β = 71.6 after a turn of 26.6 from 45°.
TURNED = """sphere A: mass m, velocity u at 45°
sphere B: mass m, at rest
A hits B: along i
given tan(deflection(A)) = 1/2
find e
"""
SLANT = """wall AB: along i
wall BC: along 60°
sphere P: velocity 8 at 40° to AB
P hits AB: e = 1/2
part a
find speed(P), angle(velocity(P), AB)
part b
P hits BC: e = 0.8
find speed(P), angle(velocity(P), BC)
"""
BOTH = """sphere A: mass 2, velocity 3i + 2j
sphere B: mass 1, velocity -i + 4j
A hits B: along i, e = 1/2
part a
find along(velocity(A), i), along(velocity(B), i)
part b
find speed(A), speed(B)
"""


def purposes(statement: str, part: str | None, *lines: str, **letters: str) -> dict[str, str]:
    """What is earned, by its words: of points with the same words the last one."""
    marking = restitution.mark(solution_of(statement), "\n".join(lines), part, letters)
    return {x.point.purpose: x.state for x in marking.marks.points}


def test_a_deflection_taken_for_the_angle_after_is_no_use_of_the_condition() -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    letters["b"] = "angle(velocity(A), i)"
    wrong = ["tan b = 1/2", "v = 2usin45", "ucos45 = v + w", "w = -usin45"]
    own = purposes(TURNED, None, *wrong, **letters)
    assert own["the condition used"] == "lost"
    assert own["component that the impact does not change"] == "earned"
    right = ["b = 45 + 26.57 = 71.57, tan b = 3", "v = usin45/tan b = 0.236u"]
    assert purposes(TURNED, None, *right, **letters)["the condition used"] == "earned"


def test_an_angle_is_put_together_the_same_way_at_a_wrong_angle() -> None:
    letters = {"w": "speed(P, 2)", "c": "angle(velocity(P, 2), BC)"}
    lines = ["w cos c = 6.65cos22.8 = 6.13", "w sin c = 0.8 x 6.65sin22.8 = 2.06"]
    lines += ["tan c = 2.06/6.13, c = 18.6"]
    marking = restitution.mark(solution_of(SLANT), "\n".join(lines), "b", letters)
    last = [x.state for x in marking.marks.points if x.point.principle in ("angle", "answer")]
    assert last == ["earned", "lost"]


def test_what_stays_is_shown_by_the_speed_of_one_sphere() -> None:
    stays = "component that the impact does not change"
    own = purposes(BOTH, "b", "speed of A = √(1 + 4) = √5", "speed of B = 3")
    assert own[stays] == "earned"
    own = purposes(BOTH, "b", "speed of A = √(1 + 2) = √3", "speed of B = √(3² + 4²) = 5")
    assert own[stays] == "earned"


def test_a_law_at_the_first_wall_is_shown_above_a_mistake_at_the_second() -> None:
    lane = (
        "wall W: along i, through (0, 0)\nwall V: along i, through (0, 6)\n"
        "sphere P: at (0, 3), velocity 2i - 4j\nP hits W: e = 1/4\nP hits V: e = 1/4\n"
        "find velocity(P, 1), velocity(P)"
    )
    problem = solution_of(lane)
    letters = {"v1": "velocity(P, 1)", "v2": "velocity(P, 2)"}
    for second in ("v2 = 2i + ¼j", "v2 = 2i - j"):
        marking = restitution.mark(problem, f"v1 = 2i + j\n{second}", letters=letters)
        laws = [x.state for x in marking.marks.points if "law" in x.point.purpose]
        assert laws == ["earned", "lost"]
