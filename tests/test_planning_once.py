"""What stands in a working is not worked out a second time: places, times, distances, tangents."""

from __future__ import annotations

import pytest
from test_planning_closing import planned, said

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.lines.derivation import Derivation
from restitution.explaining.lines.notation import write_relation
from restitution.language import parse
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.workings import explain, to_text

PAIR = "sphere A: mass 3, velocity 4i - j\nsphere B: mass 2, velocity i + j\n"
ROAD = (
    "wall W: along j, through (12, 0)\nsphere A: mass 1, at (0, 0), velocity 4i\n"
    "sphere B: mass 3, at (8, 0), at rest\nA hits B: along i, e = 1/3\nB hits W: e = 1/2\n"
)


def shown(derivation: Derivation, beginning: str) -> list[str]:
    """The lines that stand on paper and begin so."""
    lines = (line for line in derivation.lines if line.move.id != "let")
    told = zip(lines, said(derivation), strict=True)
    return [text for line, text in told if line.shown != "silent" and text.startswith(beginning)]


def test_a_distance_at_another_time_has_no_second_root() -> None:
    _, derivation = planned(
        f"{PAIR}A hits B: along i, e = 1/3\nfind distance(A, B, at t) in terms of t\n"
        "given distance(A, B, at T) = 7\nfind T"
    )
    assert shown(derivation, "distance(") == [
        "distance(A, B, at t) = t sqrt(1^2 + (1 + 1)^2) = sqrt(5) t [rearrange]"
    ]
    assert "sqrt(5) T = 7" in said(derivation)


def test_a_distance_at_another_time_is_no_method() -> None:
    _, derivation = planned(
        f"{PAIR}A hits B: along i, e = 1/3\nfind distance(A, B, at 3), distance(A, B, at t)"
    )
    assert len(shown(derivation, "distance(")) == 2
    marks = [
        "".join(mark.kind for mark in line.marks)
        for line in awarded(derivation).lines
        if line.move.record == "distance"
    ]
    assert marks == ["MA", "A"]


def test_the_place_of_who_rests_stands_once() -> None:
    _, derivation = planned(
        f"{ROAD}find distance(A, B), distance(A, B, at 6)\nB hits A: along i, e = 1\nfind time(3)"
    )
    assert len(shown(derivation, "position(A, ")) == 1


def test_a_time_that_stands_is_not_added_up_again() -> None:
    _, derivation = planned(
        f"{ROAD}find time(2)\nB hits A: along i, e = 1\nfind time(3)",
    )
    assert any("= 5 + 6 = 11" in each for each in said(derivation))


def test_where_two_meet_is_a_coordinate_with_its_time() -> None:
    solution, derivation = planned(
        "wall W: along j, through (2d, 0)\nsphere A: mass 2m, at (-d, 0), velocity u i\n"
        "sphere B: mass m, at (0, 0), at rest\nA hits B: along i, e = 1/2\n"
        "B hits W: e = 1/4\nA hits B: along i\nfind position(A)"
    )
    assert any("(2d - d)/(u/2 + u/4) = 4d/(3u)" in each for each in said(derivation))
    assert "Position, from its coordinates" not in to_text(explain(solution))


def test_the_tangent_of_a_named_angle_is_put_equal_to_what_is_given() -> None:
    _, derivation = planned(
        "sphere A: mass 3m, velocity u at theta\nsphere B: mass m, at rest\nA hits B: along i\n"
        "let phi = direction(A)\nlet psi = phi - theta\n"
        "given e = 1\nfind tan(psi) in terms of theta\n"
        "given psi = arctan(1/3), tan(theta) > 3/5\nfind theta"
    )
    assert len([each for each in derivation.lines if each.move.record == "sum-of-angles"]) == 1
    assert not any("sin(theta) =" in each for each in said(derivation))


def test_a_coefficient_that_is_given_is_put_into_the_law_at_once() -> None:
    _, derivation = planned(
        "wall W: along i\nsphere P: mass m, velocity u at theta to W\nP hits W\n"
        "given tan(theta) = 4/3, e = 1/4\nfind energy_lost"
    )
    assert "along(velocity(P, 1), j) = 1/4 (u sin(theta)) = u/5 [put]" in said(derivation)


def test_where_two_meet_before_a_wall_is_by_the_gap_between_them() -> None:
    solution, derivation = planned(
        "wall W: along j, through (d, 0)\nsphere A: mass m, at (-d, 0), velocity u i\n"
        "sphere B: mass m, at (0, 0), at rest\nA hits B: along i, e = 1/3\nB hits W: e = 1/2\n"
        "B hits A: along i\nfind distance(position(A, 3), position(B, 2))"
    )
    assert said(derivation)[-1].endswith("= d - 3d/4 = d/4 [rearrange]")
    assert "Time = gap ÷ speed at which it closes:" in to_text(explain(solution))


def test_a_change_of_velocity_stands_in_the_impulse_that_is_asked_alone() -> None:
    _, derivation = planned(
        "wall W\nsphere P: mass 3, velocity 2i + 7j\nP hits W\ngiven velocity(P) = -4i - j\n"
        "find direction(W), e, impulse(P)"
    )
    lines = said(derivation)
    assert sum("-4i - j - (2i + 7j)" in each for each in lines) == 1
    assert "line_of_centres(1) parallel to -18i - 24j" in lines


def test_the_unit_vector_of_an_offset_is_printed_once() -> None:
    solution, _ = planned(
        "sphere A: mass 2, velocity 5i, radius r\nsphere B: mass 1, at rest, radius r\n"
        "A hits B: offset 6/5 r, e = 1/2\nfind velocity(A), velocity(B)"
    )
    text = " ".join(to_text(explain(solution)).split())
    assert "that unit vector along the line of centres" in text
    assert text.count("unit vector along the line of centres = (4𝐢 + 3𝐣)/5") == 1
    assert "𝐧 = (4𝐢 + 3𝐣)/5" not in text


def test_a_component_that_stays_goes_over_the_whole_time_that_is_told_by_another() -> None:
    _, derivation = planned(
        "wall W: along i, through (0, 0)\npoint Q: (14, 3)\n"
        "sphere P: at (0, 6), velocity V at alpha to W\nP hits W\nP reaches Q\n"
        "given time(2) = 2 time(1)\nfind e, tan(alpha)"
    )
    lines = said(derivation)
    assert "14 = V cos(alpha) (2(6/(V sin(alpha)))) = 12/tan(alpha) [rearrange]" in lines
    assert not any(each.startswith("along(position(P, 1), i)") for each in lines)


def test_vectors_that_are_compared_have_no_numbers() -> None:
    text = to_text(
        explain(
            solve(
                parse(
                    "sphere A, B: mass m\nsphere A: velocity 6i + 2j\nsphere B: velocity -2i + 3j\n"
                    "A hits B: along i\ngiven velocity(A) parallel to velocity(B)\n"
                    "find e, velocity(A), velocity(B)\n"
                    "show velocity(A) in the direction of velocity(B)"
                )
            )
        )
    )
    assert "Comparing the two vectors" in text
    assert "𝐯_A = ⅔𝐯_B" in text and "(3)" not in text


def test_no_root_is_taken_of_a_speed_of_which_only_the_square_is_used() -> None:
    text = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, at rest\nA hits B: along i\n"
        "unknown e\nfind range of speed(A)\ngiven alpha = 45°"
    )
    derivation = plan(solve(parse(text)))
    (speed,) = (each for each in derivation.lines if each.move.record == "speed")
    line = write_relation(speed.relation)  # type: ignore[arg-type]
    assert line.startswith("speed(A, 1)^2 = (sqrt(2) (1 - 2e) u/6)^2 + ")
    assert line.endswith("= u^2/18 (1 - 2e)^2 + u^2/2 [rearrange]")


def test_the_size_of_an_impulse_is_that_of_the_vector_that_stands() -> None:
    text = "sphere A: mass 2m, velocity u(3i + j)\nsphere B: mass m, at rest\n"
    _, derivation = planned(f"{text}A hits B: along i - 2j, e = e\nfind impulse(A), impulse")
    (size,) = shown(derivation, "impulse(1)")
    assert size.startswith("impulse(1) = 2(1 + e) m u/15 sqrt(1^2 + 2^2) = ")


def test_an_impulse_is_by_velocities_that_stand_and_its_size_by_it() -> None:
    _, derivation = planned(
        "wall W: along i + 2j\nsphere P: mass 1/4, velocity 4i + 12j\nP hits W: e = 2/5\n"
        "find velocity(P), impulse, impulse(P)"
    )
    assert shown(derivation, "impulse") == [
        "impulse(P, 1) = 1/4 (156/25 i + 272/25 j - (4i + 12j))",
        "impulse(P, 1) = 14/25 i - 7/25 j",
        "impulse(1) = sqrt((14/25)^2 + (7/25)^2) = 7sqrt(5)/25 [rearrange]",
    ]


def test_an_impulse_is_by_the_sphere_of_the_shorter_numbers() -> None:
    _, derivation = planned(
        "sphere A: mass sqrt(3), velocity 2i + sqrt(3) j\nsphere B: mass 1, velocity -sqrt(3) i\n"
        "A hits B: along i, e = 1/sqrt(3)\nfind velocity(A), velocity(B), impulse"
    )
    assert shown(derivation, "impulse(1)") == ["impulse(1) = 2 + sqrt(3)"]


def test_energies_that_are_asked_stand_before_what_is_lost_of_them() -> None:
    _, derivation = planned(
        "sphere A: mass 2m, velocity 3u at 60°\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\nfind energy_lost, energy(A)/energy(0), energy(B)/energy"
    )
    (lost,) = shown(derivation, "energy_lost(1)")
    assert lost.startswith("energy_lost(1) = ")
    assert " - " in lost
    assert "(3u)^2" not in lost.split(" - ")[1]
    assert [len(shown(derivation, f"energy({body}, 1)")) for body in "AB"] == [2, 2]


@pytest.mark.parametrize("offset", ["r", "d"])
def test_a_direction_after_an_offset_needs_no_component_across(offset: str) -> None:
    text = "sphere A: mass m, radius r, velocity u i\nsphere B: mass m, radius r, at rest\n"
    asked = "find direction(A)" if offset == "r" else "given speed(B) = 3/5 u\nfind d, direction(A)"
    derivation = plan(solve(parse(f"{text}A hits B: offset {offset}, e = 1/2\n{asked}")))
    records = [line.move.record for line in derivation.lines]
    assert "changed-velocity" in records
    assert not any(text.startswith("across(velocity(A") for text in said(derivation))


def test_no_sine_with_a_root_is_worked_out_for_a_tangent_of_the_data() -> None:
    _, derivation = planned(
        "wall W: along i\nsphere P: velocity u at alpha to W\ngiven tan(alpha) = 3/2\nP hits W\n"
        "given angle(velocity(P), W) = 30°\nfind e"
    )
    assert "tan(30°) = e (u sin(alpha))/(u cos(alpha)) = e tan(alpha) [rearrange]" in said(
        derivation
    )
    assert "triangle" not in [line.move.id for line in derivation.lines]


BACK = (
    "wall W: along j, through (d, 0)\nsphere A: mass 2m, at (0, 0), velocity u i\n"
    "sphere B: mass m, at (0, 0), at rest\nA hits B: along i, e = 1/2\nB hits W: e = {e}\n"
)


@pytest.mark.parametrize("gap", ["", "distance(A, B, 2), "])
def test_two_that_meet_close_the_gap_between_them(gap: str) -> None:
    text = BACK.format(e="1/3") + f"find {gap}time(2)\nA hits B: e = 1/2\nfind time(3) - time(2)"
    _, derivation = planned(text)
    (time,) = shown(derivation, "time(3) - time(2)")
    above = "d/2/" if gap else "(d - d/2)/"
    assert time == f"time(3) - time(2) = {above}(u/2 + u/3) = 3d/(5u) [rearrange]"
    assert not shown(derivation, "along(position(A, 3)")
    words = to_text(explain(solve(parse(text))))
    assert "Time = gap ÷ speed at which it closes" in words


def test_no_gap_is_closed_along_one_axis_by_two_that_move_in_two_directions() -> None:
    _, derivation = planned(
        "sphere A: mass 1, at (0, 0), velocity 3i\nsphere B: mass 1, at (6, -4), velocity 2j\n"
        "A hits B: along i, e = 1/2\nfind time(1), position(A, 1)"
    )
    lines = [line for line in derivation.lines if line.move.record == "straight-line"]
    assert all(len(line.move.bodies) == 1 for line in lines)


def test_the_bounds_of_a_square_are_put_into_the_speed_that_shows_it() -> None:
    _, derivation = planned(
        "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, at rest\nA hits B: along i\n"
        "find minimum of speed(A) over e, maximum of speed(A) over e"
    )
    assert shown(derivation, "0 <= (1 - 2e)^2 <= 1")
    assert not shown(derivation, "speed(A, 1)^2")
