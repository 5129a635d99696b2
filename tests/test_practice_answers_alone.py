"""Answers without a letter that was declared, attributed in words, and what they earn."""

from __future__ import annotations

from typing import Any

import pytest
from marked import solution_of, verdicts

import restitution

CORNER = """wall X: along i
wall Y: along j
sphere P: mass 3, velocity -8i - 6j
part a
P hits X: e = 1/3
find velocity(P)
part b
P hits Y: e = 1/4
find velocity(P), total_energy_lost
"""
SHARE = """wall W: along i
sphere P: mass m, velocity u at 60° to W
P hits W
given energy_lost = 5/12 energy(0)
find e
"""
PAIR = """sphere A: mass 2, velocity 6i + j
sphere B: mass 1, velocity -3i + 4j
A hits B: along i, e = 1/3
part a
find velocity(A), velocity(B)
part b
find deflection(A)
part c
find energy_lost
"""
WALL = """wall W: along i
sphere P: mass 2, velocity 8 at 35° to W
P hits W: e = 0.6
part a
find speed(P), angle(velocity(P), W)
part b
find deflection(P)
"""


def marked(statement: str, part: str, *lines: str) -> dict[str, Any]:
    found: dict[str, Any] = restitution.mark(
        solution_of(statement), "\n".join(lines), part=part
    ).json()
    return found


def said(found: dict[str, Any]) -> list[str]:
    return [line["verdict"] for line in found["lines"]]


def names(found: dict[str, Any]) -> list[str | None]:
    return [(line["mistake"] or {}).get("id") for line in found["lines"]]


@pytest.mark.parametrize(
    ("part", "line", "name"),
    [
        ("a", "v = -8i - 2j", "restitution-sign"),
        ("a", "v = -8/3 i + 6j", "restitution-parallel"),
        ("b", "V = 8i + 2j", "restitution-omitted"),
        ("b", "v = 8i + 1/2 j", "restitution-parallel"),
    ],
)
def test_a_vector_is_the_velocity_that_is_asked(part: str, line: str, name: str) -> None:
    found = marked(CORNER, part, line)
    assert said(found) == ["false"]
    assert names(found) == [name]


def test_a_true_velocity_on_the_way_is_no_wrong_answer() -> None:
    assert said(marked(CORNER, "b", "v = -8i + 2j", "v = 2i + 2j")) == ["true", "true"]


def test_a_letter_alone_is_the_only_speed() -> None:
    lines = ("v = 5/24 u", "25/576 = 1/4 + 3/4 e^2", "e^2 = -119/432")
    assert verdicts(SHARE, *lines) == ["false", "follows", "follows"]
    assert verdicts(SHARE, "v^2 = 7/12 u^2") == ["true"]
    assert verdicts(SHARE, "v^2 = 5/12 u^2", "5/12 = 1/4 + 3/4 e^2") == ["false", "follows"]


def test_a_body_has_a_velocity_and_comes_with_one() -> None:
    assert said(marked(PAIR, "a", "so A has 2i + j and B has 5i + 4j")) == ["true"]
    assert said(marked(PAIR, "a", "so A has 2i + 4j and B has 5i + j")) == ["false"]
    assert said(marked(PAIR, "a", "2i + j and 5i + 4j")) == ["true"]
    lines = ("hits Y with -8i + 2j", "leaves with 1/4×8 i + 2j", "= 2i + 2j")
    assert "false" not in said(marked(CORNER, "b", *lines))


def test_what_each_body_loses_is_an_energy() -> None:
    found = marked(
        PAIR, "c", "A loses 1/2(2)(37 - 5) = 32", "B loses 1/2(1)(25 - 41) = -8", "total 24"
    )
    assert said(found) == ["true"] * 3
    assert found["marks"]["earned"] == found["marks"]["of"]
    assert said(marked(PAIR, "a", "A loses momentum 2(6 - 2) = 8"))[0] != "false"
    assert said(marked(PAIR, "a", "A loses 12 - 4 = 8"))[0] != "false"  # of momentum


def test_components_listed_with_a_factor_are_no_equation() -> None:
    found = said(marked(PAIR, "a", "components x√2: A 6 before 2 after, B -3 before 5 after"))
    assert found == ["remark"]


def test_an_angle_of_a_deflection_is_a_method_though_the_sum_is_wrong() -> None:
    lines = ("tan β = 0.6 tan 35, β = 22.8°", "turned through 35 - 22.8 = 12.2°")
    marks = marked(WALL, "b", *lines)["marks"]
    assert (marks["earned"], marks["of"]) == (0, 2)  # part (a) has the marks of this angle
    lines = ("arctan(1/2) = 26.6 and arctan(1/6) = 9.46", "deflection = 26.6 + 9.46 = 36.0")
    found = marked(PAIR, "b", *lines)
    assert said(found)[1] == "false"
    assert found["marks"]["earned"] == 1


def test_an_angle_to_a_tenth_of_a_degree_is_fine_enough() -> None:
    fine = """wall W: along i
sphere P: velocity 8 at 30° to W
P hits W: e = 1/4
find angle(velocity(P), W)
"""
    marks = restitution.mark(solution_of(fine), "tan β = 1/4 tan 30, β = 8.2°").marks
    assert marks.earned == marks.of


def test_an_answer_off_by_early_rounding_loses_its_accuracy() -> None:
    lines = ("8cos35 = 6.6", "0.6 × 8sin35 = 2.8", "speed = √(6.6² + 2.8²) = 7.17")
    found = marked(WALL, "a", *lines)
    lost = [point for point in found["marks"]["points"] if "rounding" in point["why"]]
    assert said(found) == ["true"] * 3
    assert len(lost) == 1
    lines = ("8cos35 = 6.55", "0.6 × 8sin35 = 2.75", "speed = √(6.55² + 2.75²) = 7.10")
    points = marked(WALL, "a", *lines)["marks"]["points"]
    assert not [point for point in points if "rounding" in point["why"]]


def test_what_follows_from_a_law_lost_at_a_wall_earns_its_accuracy() -> None:
    lines = ("parallel 8 sin 35 = 4.589", "perp 0.6 × 8 cos 35 = 3.932", "speed = 6.04")
    points = marked(WALL, "a", *lines, "angle = arctan(3.932/4.589) = 40.6°")["marks"]["points"]
    assert [point["state"] for point in points] == [
        "lost",
        "lost",
        "earned",
        "lost",
        "earned",
        "earned",
    ]


def test_numbers_that_agree_are_no_slip_in_arithmetic() -> None:
    pair = """sphere A: mass 2, velocity 5i + 2j
sphere B: mass 4, at rest
A hits B: along i
given velocity(A) = i + 2j
part a
find e
part b
find energy_lost
"""
    assert names(marked(pair, "b", "loss = 1/2×2×(5 - 1)^2 - 1/2×4×2^2 = 8")) == [
        "energy-of-difference"
    ]
    lines = ("w = 2", "2 - 1 = 5e", "e = 5")
    assert names(marked(pair, "a", *lines))[2] not in ("restitution-inverted", None)


def principles(found: dict[str, Any]) -> list[str | None]:
    return [line["principle"] for line in found["lines"]]


def test_restitution_in_numbers_is_restitution() -> None:
    wall = """wall W: along j
sphere P: mass 2, velocity 9i + 2j
P hits W: e = 1/3
find velocity(P)
"""
    solution = solution_of(wall)
    for line in ("9/3 = 3", "9 x 1/3 = 3 back", "i part reversed 9 x 1/3 = 3"):
        found: dict[str, Any] = restitution.mark(solution, line).json()
        assert principles(found) == ["restitution"], line
    found = restitution.mark(solution, "9 x 1/3 = 3\nvelocity = 3i + 2j").json()
    states = [point["state"] for point in found["marks"]["points"]]
    assert states == ["earned", "earned", "lost"]  # the law stands, its sense is lost


def test_an_impulse_divided_by_the_mass_is_its_method() -> None:
    wall = """wall W: along i
sphere P: mass 0.5, velocity 8 at 30° to W
P hits W
given impulse = 3
find e
"""
    found = restitution.mark(solution_of(wall), "3/0.5 = 6 change in velocity").json()
    assert principles(found) == ["impulse"]
    assert found["marks"]["earned"] == 2
    found = restitution.mark(solution_of(wall), "3 = 0.5(4 - 4e)\n4e = -2, e = -1/2").json()
    assert found["marks"]["points"][-1]["state"] == "lost"  # not the size of e


def test_a_vector_with_a_letter_and_its_value_are_an_answer() -> None:
    lines = ("vA = pi + j, vB = qi + 4j", "12 - 3 = 2p + q", "q - p = 3", "p = 2, q = 5")
    marks = marked(PAIR, "a", *lines)["marks"]
    assert marks["earned"] == marks["of"]
    lines = ("12 - 3 = 2v + w", "w - v = 3", "v = 2, w = 5")
    answers = marked(PAIR, "a", *lines)["marks"]["points"][-2:]
    assert [point["state"] for point in answers] == ["lost", "lost"]


def test_a_speed_follows_from_the_numbers_above() -> None:
    lines = ("perp 0.6 × 8 cos 35 = 3.932", "along 8 cos 35 = 6.553")
    found = marked(WALL, "a", *lines, "speed = √(3.932² + 6.553²) = 7.64")
    assert said(found)[0] == "false"
    assert said(found)[2] == "follows"
    assert said(marked(WALL, "a", "speed = √(6.55² + 4.59²) = 8.00", "answer"))[0] != "follows"


def test_a_given_energy_by_squares_is_its_method() -> None:
    pair = """sphere A: mass m, velocity u at 30°
sphere B: mass 3m, at rest
A hits B: along i
given energy_lost = 5/16 energy(0)
find e
"""
    lines = ("√3u/2 = v + 3w", "w - v = √3eu/2", "v² + 3w² + u²/4 = 11u²/16")
    points = restitution.mark(solution_of(pair), "\n".join(lines)).json()["marks"]["points"]
    energy = [point["state"] for point in points if point["for"] == "kinetic energy"]
    assert energy[0] == "earned"


def test_the_complement_of_an_angle_is_no_answer() -> None:
    lines = ("tan 35 = 0.700", "tan β = 0.6 tan 35 = 0.42")
    assert said(marked(WALL, "a", *lines, "β = 22.8")) == ["true"] * 3
    wrong = ("along 6.553, perp 2.753", "tan β = 6.553/2.753, β = 67.2°")
    assert said(marked(WALL, "a", *wrong))[1] == "false"
    assert "false" not in said(marked(WALL, "a", *wrong, "angle = 90 - 67.2 = 22.8"))


def test_a_deflection_has_the_letter_of_one() -> None:
    pair = """sphere A: mass m, velocity u at 45°
sphere B: mass m, at rest
A hits B: along i, e = 1/2
part a
find velocity(A)
part b
show tan(deflection(A)) = 3/5
"""
    assert said(marked(pair, "b", "tan b = 4", "tan δ = (4 + 1)/(1 - 4)"))[1] == "false"
    assert said(marked(pair, "b", "tan b = 4", "tan δ = (4 - 1)/(1 + 4) = 3/5"))[1] == "true"
