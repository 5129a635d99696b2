"""Times and places in scripts: false ones, those that follow, and the sentences that tell them."""

from __future__ import annotations

import pytest
from marked import solution_of, verdicts

import restitution

# 12/8 = 1.5 s there; back at 8/4 = 2, so 6 s more.
THERE_AND_BACK = """wall W: along j, through (12, 0)
point O: (0, 0)
sphere P: velocity 8i, at (0, 0)
P hits W: e = 1/4
P reaches O
find time(2)"""

# 6/3 = 2 s to W; then 5i - j, so at 5 s (10, 6) + 3(5, -1) = (25, 3).
ASIDE = """wall W: along i, through (0, 6)
sphere P: velocity 5i + 3j, at (0, 0)
P hits W: e = 1/3
part a
find time(1), velocity(P)
part b
find position(P, at 5)"""

# 2/8 s to W; up at 6, so 4/6 s more.
STRIP = """wall W: along i, through (0, 0)
wall X: along i, through (0, 4)
sphere P: velocity 3i - 8j, at (0, 2)
P hits W: e = 3/4
P hits X: e = 1/2
find time(1), time(2)"""


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["comes back at 2", "so 6 s", "total 7.5 s"], ["true", "remark", "true"]),
        (["it rebounds at 8", "total = 3 s"], ["false", "follows"]),
        (["ball comes back at 8", "total 3 s"], ["false", "follows"]),
        (["rebounds with speed 2", "total time = 6 s"], ["true", "false"]),
    ],
)
def test_a_time_in_all_counts_from_the_start(lines: list[str], expected: list[str]) -> None:
    assert verdicts(THERE_AND_BACK, *lines) == expected


def test_a_speed_kept_by_a_wall_has_no_coefficient() -> None:
    marking = restitution.mark(solution_of(THERE_AND_BACK), "comes back at 8\ntotal = 3 s")
    first, _ = marking.json()["lines"]
    assert first["mistake"]["id"] == "restitution-omitted"
    # The method of the times alone: what rests on the coefficient is lost.
    assert [point.point.kind for point in marking.marks.points if point.state == "earned"] == ["M1"]


def test_a_letter_for_the_time_that_is_asked_is_no_letter_of_his_own() -> None:
    marking = restitution.mark(solution_of(ASIDE), "t = 6/√34 = 1.03\nv = 5i - j", part="a")
    assert [line["verdict"] for line in marking.json()["lines"]] == ["false", "true"]
    assert marking.marks.points[0].state == "lost"
    right = restitution.mark(solution_of(ASIDE), "t = 6/3 = 2\nv = 5i - j", part="a")
    assert right.marks.earned == right.marks.of


def test_a_place_by_its_name_may_be_wrong() -> None:
    def of(line: str) -> restitution.Marking:
        return restitution.mark(solution_of(ASIDE), line, part="b")

    wrong = of("position = (10, 6) + 5(5, -1) = (35, 1)")
    (line,) = wrong.json()["lines"]
    assert (line["verdict"], line["mistake"]["id"]) == ("false", None)
    right = of("position vector = (10, 6) + 3(5, -1) = (25, 3)")
    assert right.json()["lines"][0]["verdict"] == "true"
    assert right.marks.earned == right.marks.of
    assert of("position at t = 3: (15, 5)").json()["lines"][0]["verdict"] != "false"


def test_a_time_without_the_coefficient_keeps_its_method() -> None:
    working = "t1 = 1/4\nthen 4 ÷ 8 = 0.5 s\ntotal 0.75 s"
    marking = restitution.mark(solution_of(STRIP), working)
    lines = marking.json()["lines"]
    assert [line["verdict"] for line in lines] == ["true", "false", "follows"]
    assert lines[1]["mistake"]["id"] == "restitution-omitted"
    states = [point.state for point in marking.marks.points]
    assert states == ["earned", "earned", "lost", "earned", "earned"]


def test_a_letter_below_a_mistake_is_a_time_of_his_own_world() -> None:
    assert verdicts(STRIP, "t1 = 1/4", "then 4 ÷ 8 = 0.5 s", "t2 = 0.75")[1:] == [
        "false",
        "follows",
    ]


def test_the_time_of_a_flight_is_no_component_of_the_same_number() -> None:
    # The component 2i stays; 6/3 = 2 is a time.
    statement = ASIDE.replace("5i + 3j", "2i + 3j")
    marking = restitution.mark(solution_of(statement), "t = 6/3 = 2", part="a")
    assert [line["principle"] for line in marking.json()["lines"]] == ["component"]
    assert [point.state for point in marking.marks.points].count("earned") == 2


def test_the_time_of_the_way_back_is_none_of_the_way_there() -> None:
    # 8 m at 2 take 4 s; back at 1 they take 8 s.
    statement = THERE_AND_BACK.replace("8i", "2i").replace("12", "8").replace("1/4", "1/2")
    assert verdicts(statement, "time back = 8/2 = 4 s", "total = 4 + 4 = 8 s") == [
        "false",
        "follows",
    ]
    right = ("time for the return journey = 8/1 = 8", "time to come back = 8", "total time = 12")
    assert set(verdicts(statement, *right)) == {"true"}


def test_a_time_across_is_a_time() -> None:
    assert verdicts(STRIP, "time across = 4/6 = 0.667", "time to go across = 2/3") == ["true"] * 2
