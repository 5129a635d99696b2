"""Sentences about shares, totals and velocities, and the marks of what they and others give."""

from __future__ import annotations

from typing import Any

import pytest
from marked import solution_of, verdicts

import restitution

# -3i + 2j after X, i + 2j after Y: kinetic energies 25, 13, 5.
CORNER = """wall X: along i
wall Y: along j
sphere P: mass 2, velocity -3i - 4j
P hits X: e = 1/2
P hits Y: e = 1/3
find """

# 2v + w = 9 and w - v = 3: v = 2, w = 5.
PAIR = """sphere A: mass 2, velocity 6i + j
sphere B: mass 1, velocity -3i + 4j
A hits B: along i, e = 1/3
find """


def marked(statement: str, *lines: str, **letters: str) -> dict[str, Any]:
    found: dict[str, Any] = restitution.mark(
        solution_of(statement), "\n".join(lines), letters=letters
    ).json()
    return found


def names(found: dict[str, Any]) -> list[str | None]:
    return [(line["mistake"] or {}).get("id") for line in found["lines"]]


def test_the_half_of_a_number_is_no_half() -> None:
    statement = "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind speed(P)"
    assert verdicts(statement, "perp before = 4, half is 2", "speed = √(9 + 4) = 3.61") == [
        "true",
        "true",
    ]


def test_a_total_in_joules_is_an_energy() -> None:
    statement = CORNER + "total_energy_lost"
    lines = ["first wall 16 - 4 = 12, second 9 - 1 = 8", "total = 20 J"]
    found = marked(statement, *lines)
    assert [line["verdict"] for line in found["lines"]] == ["true", "true"]
    assert found["marks"]["earned"] == found["marks"]["of"]
    assert verdicts(statement, lines[0], "total = 21 J")[1] == "false"
    assert verdicts(statement, lines[0], "total 20 J") == ["true", "true"]
    assert verdicts(statement, lines[0], "total 21 J")[1] == "false"


def test_a_speed_squared_is_its_square() -> None:
    statement = "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind speed(P)"
    assert verdicts(statement, "9 + 4 = 13 is final speed squared") == ["true"]
    assert verdicts(statement, "speed of P after squared = 15") == ["false"]


def test_what_a_unit_vector_becomes_is_a_component() -> None:
    statement = "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind speed(P)"
    assert verdicts(statement, "i stays 3", "j becomes 1/2 x 4 = 2") == ["true", "true"]
    assert verdicts(statement, "so j becomes 1/4 x 4 = 1") == ["false"]


def test_equations_behind_a_result_are_whole() -> None:
    statement = "wall W: along i\nsphere P: velocity u at 50° to W\nP hits W: e = 1/2\nfind "
    line = "tan x = 0.5 tan 50 from v cos x = u cos 50 and v sin x = 0.5(u sin 50)"
    statement += "angle(velocity(P), W)"
    assert [line["verdict"] for line in marked(statement, line, x="angle after")["lines"]] == [
        "true"
    ]


def test_what_is_left_and_what_is_lost_are_shares() -> None:
    statement = CORNER + "total_energy_lost/energy(0)"
    assert verdicts(statement, "KE after is ⅕ of it so 4/5 lost") == ["true"]
    assert verdicts(statement, "KE after/KE before = 5/25 = 1/5 so 4/5 lost") == ["true"]
    assert verdicts(statement, "KE after/KE before = 5/25 = 1/5 so 3/5 lost") == ["false"]


def test_who_goes_has_a_velocity() -> None:
    statement = PAIR + "velocity(A), velocity(B)"
    assert verdicts(statement, "A goes 2i + j, B goes 5i + 4j") == ["true"]
    assert verdicts(statement, "(2, 1) for A, (5, 4) for B") == ["true"]
    assert verdicts(statement, "A goes 3i + j, B goes 5i + 4j") == ["false"]


def test_a_sign_within_a_cosine_is_none_of_a_law() -> None:
    statement = CORNER + "angle(velocity(P), velocity(P, 0))"
    found = marked(statement, "cos x = (-3 + 8)/(5√5)", x="angle(velocity(P), velocity(P, 0))")
    assert names(found) == ["sign"]


def test_a_loss_that_is_worked_out_is_not_taken_for_none() -> None:
    # With all kept at X the loss would be the 8 J at Y.
    found = marked(CORNER + "total_energy_lost", "total KE lost = 25 - 17 = 8")
    assert found["lines"][0]["verdict"] == "false"
    assert names(found) != ["energy-conserved"]


def test_the_angle_after_is_a_method_for_the_deflection() -> None:
    found = marked(PAIR + "deflection(B)", "deflection of B = arctan(4/5) = 38.7°")
    assert names(found) == ["deflection-is-after"]
    kept = [point["for"] for point in found["marks"]["points"] if point["state"] == "earned"]
    assert kept == ["angle from components"]


def test_an_angle_is_the_one_that_is_asked() -> None:
    statement = CORNER + "angle(velocity(P), velocity(P, 0))"
    found = marked(statement, "angle = arccos((-3 - 8)/(5√5)) = arccos(-0.984) = 169.7")
    assert found["lines"][0]["verdict"] == "true"
    assert found["marks"]["points"][-1]["state"] == "earned"


def test_speeds_taken_for_components_are_no_speeds_from_components() -> None:
    statement = """sphere A: mass 2, velocity 3i + 4j
sphere B: mass 1, at rest
A hits B: along i, e = 1/2
find speed(A), speed(B)"""
    lines = ["2 × 5 = 2v + w", "w - v = 2.5", "v = 2.5, w = 5"]
    assert marked(statement, *lines, v="speed(A)", w="speed(B)")["marks"]["earned"] == 0


def test_the_line_of_centres_alone_is_no_component() -> None:
    statement = """sphere A: mass 3, velocity 4i + 6j
sphere B: mass 2, at rest
A hits B
given velocity(A) = i + 3j
find e"""
    found = marked(statement, "line of centres is parallel to 3i + 3j, i.e. i + j")
    kept = [point["kind"] for point in found["marks"]["points"] if point["state"] == "earned"]
    assert kept == ["M1", "A1"]


def test_an_angle_is_no_step_towards_one_put_together_wrongly() -> None:
    statement = """sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/3
show tan(deflection(A)) = 2tan(alpha)/(1 + 3tan(alpha)^2)"""
    lines = ["v + w = u cos α", "w - v = ⅓u cos α", "2v = ⅔u cos α, v = ⅓u cos α"]
    lines += ["tan θ = u sin α/(⅓u cos α) = 3tan α"]
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    letters["θ"] = "angle(velocity(A), i)"
    right = "tan(θ - α) = (3t - t)/(1 + 3t²) where t = tan α"
    found = marked(statement, *lines, right, "= 2tan α/(1 + 3tan² α)", **letters)
    assert found["marks"]["earned"] == found["marks"]["of"]


# v = -u/4, w = 5u/12 along i; B comes back with 5fu/12.
AGAIN = """sphere A: mass m, velocity u i
sphere B: mass 3m, at rest
wall W: along j
A hits B: along i, e = 2/3
B hits W: e = f
given A and B collide again
find range of f"""


def test_a_second_meeting_is_told_in_words() -> None:
    speed = "after the wall B has 5fu/12"
    found = marked(AGAIN, speed, "they collide again if 5fu/12 > u/4", "f > 3/5 so 3/5 < f <= 1")
    assert [line["verdict"] for line in found["lines"]] == ["true"] * 3
    assert found["marks"]["earned"] == found["marks"]["of"]
    found = marked(AGAIN, speed, "collide if 5fu/12 < u/4", "0 <= f < 3/5")
    assert [line["verdict"] for line in found["lines"]] == ["true", "false", "follows"]
    other = AGAIN.replace("collide again", "do not collide again")
    assert verdicts(other, "they would collide if 5fu/12 > u/4") != ["false"]


def test_parts_of_a_velocity_as_vectors_resolve_it() -> None:
    wall = "wall W: along 3i + 4j\nsphere P: mass 2, velocity 10i + 5j\nP hits W: e = 1/2\n"
    wrong = "v = 6i + 8j + 1/2(4i - 3j) = 8i + 6.5j"
    for parts, state in (
        ("parallel part 6i + 8j and the rest is 4i - 3j", "earned"),
        ("parallel part 10i + 5j", "lost"),
    ):
        found = marked(f"{wall}find velocity(P)", parts, wrong)
        assert found["marks"]["points"][0]["state"] == state


def test_the_angle_after_is_worked_out_though_it_is_no_deflection() -> None:
    found = marked(f"{PAIR}deflection(B)", "tan b = 4/5 so deflected 38.7")
    assert found["lines"][0]["mistake"]["id"] == "deflection-is-after"
    points = [x for x in found["marks"]["points"] if x["for"] == "angle from components"]
    assert [point["state"] for point in points] == ["earned"]


def test_the_given_deflection_is_not_that_of_the_angle_after() -> None:
    statement = """wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/3
given tan(deflection(P)) = 2
find alpha"""
    lines = ["tan b = 1/3 tan α", "tan b = 2", "tan α = 6 so α = 80.5"]
    found = marked(statement, *lines, b="angle(velocity(P), W)")
    assert found["lines"][1]["mistake"]["id"] == "deflection-is-after"
    points = [x for x in found["marks"]["points"] if x["for"] == "angle of deflection"]
    assert [point["state"] for point in points] == ["lost"]


# 5i + 10j after 14i - 2j: the impulse is 2(-9i + 12j).
UNKNOWN_WALL = """wall W
sphere P: mass 2, velocity 14i - 2j
P hits W
given velocity(P) = 5i + 10j
find impulse, e
"""


def test_a_size_below_a_change_of_velocity_is_that_of_it() -> None:
    change = "change in velocity = -9i + 12j"
    assert (
        verdicts(UNKNOWN_WALL, change, "size √(81 + 144) = 15", "I = 2 x 15 = 30") == ["true"] * 3
    )
    assert verdicts(UNKNOWN_WALL, change, "size = 16")[1] == "false"


def test_the_direction_of_an_impulse_is_no_value_of_it() -> None:
    lines = ["impulse direction is -3i + 4j so normal is (-3i + 4j)/5", "direction of P is i + 2j"]
    assert "false" not in verdicts(UNKNOWN_WALL, *lines)


def test_energies_along_the_line_are_parts_of_energies() -> None:
    statement = PAIR.replace("mass 2", "mass 2m").replace("mass 1", "mass m")
    statement = statement.replace("6i + j", "6u i + u j").replace("-3i + 4j", "-3u i + 4u j")
    line = "along the line: {}mu² at first and 16.5mu² at last"
    assert verdicts(statement + "energy_lost", line.format("40.5")) == ["true"]
    assert verdicts(statement + "energy_lost", line.format("41.5")) == ["false"]


# 2(4i - 2j) + 4j = 2(2i + 2j) + 4(i - j): the impulse on A is -4i + 8j.
UNKNOWN_LINE = """sphere A: mass 2, velocity 4i - 2j
sphere B: mass 4, velocity j
A hits B
given velocity(A) = 2i + 2j
find velocity(B), line_of_centres
"""


def test_sentences_say_which_way_the_line_of_centres_goes() -> None:
    for sentence in (
        "so line of centres is parallel to {}",
        "line of centres in direction {}",
        "change -2i + 4j so line of centres // {}",
        "LOC has direction {}",
    ):
        right, wrong = (marked(UNKNOWN_LINE, sentence.format(n)) for n in ("-i + 2j", "2i + j"))
        assert right["lines"][0]["verdict"] == "true", sentence
        assert wrong["lines"][0]["verdict"] == "false", sentence
        assert (right["marks"]["earned"], wrong["marks"]["earned"] < 2) == (2, True), sentence


def test_momenta_with_numbers_put_in_are_momentum() -> None:
    letters = {"p": "along(velocity(B), i)", "q": "along(velocity(B), j)"}
    found = marked(UNKNOWN_LINE, "i: 8 = 4 + 4p", "j: -4 + 4 = 4 + 4q", "4q = -4", **letters)
    principles = [line["principle"] for line in found["lines"]]
    assert principles[:2] == ["momentum", "momentum"]
    assert principles[2] != "momentum"


def test_an_equation_of_a_given_impulse_has_its_own_mistakes() -> None:
    statement = """sphere A: mass 3, velocity 4i + 2j
sphere B: mass 1, velocity -2i + j
A hits B: along i
given impulse = 7.5
find velocity(A), velocity(B)
"""
    for line, name in (
        ("7.5 = 3(v - 4)", "impulse-sign"),
        ("7.5 = 4 - v", "mass-omitted"),
        ("7.5 = 3(4 - v)", None),
    ):
        assert names(marked(statement, line, v="along(velocity(A), i)")) == [name], line


def test_whole_speeds_in_both_laws_are_two_mistakes() -> None:
    statement = """sphere A: mass 3m, velocity 5u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
given tan(alpha) = 3/4
find speed(A), speed(B)
"""
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    lines = ["15u = 3v + w", "w - v = 1/2 × 5u", "v = 3.125u, w = 5.625u"]
    found = marked(statement, *lines, **letters)
    assert [line["verdict"] for line in found["lines"]] == ["false", "false", "follows"]
    assert names(found)[:2] == ["speed-for-component"] * 2


PASSAGE = """wall V: along i, through (0, 0)
wall W: along i, through (0, 6)
sphere P: at (0, 3), velocity 4i - 2j
P hits V: e = 1/2
P hits W: e = 1/2
part a
find time(2)
part b
find velocity(P), distance(position(P, 2), (0, 6))
"""


def marked_part(part: str, *lines: str) -> dict[str, Any]:
    found: dict[str, Any] = restitution.mark(
        solution_of(PASSAGE), "\n".join(lines), part=part
    ).json()
    return found


def test_a_time_in_all_follows_from_one_without_a_name() -> None:
    found = marked_part("a", "t = 3/2", "across after = 2", "6/2 = 3", "total = 4.5 s")
    assert [line["verdict"] for line in found["lines"]] == ["true", "false", "true", "follows"]
    assert found["marks"]["earned"] == 2
    other = marked_part("a", "t = 3/2", "across after = 2", "6/2 = 3", "total = 4.9 s")
    assert other["lines"][3]["verdict"] == "false"


def test_a_number_between_two_signs_has_one_reading() -> None:
    found = marked_part("a", "time to V 3/2", "speed across = 2 ÷ 1/2 = 4")
    assert [line["verdict"] for line in found["lines"]] == ["true", "false"]
    found = marked_part("a", "speed across after V = 2 ÷ 2/1 = 1")
    assert [line["verdict"] for line in found["lines"]] == ["true"]


def test_a_coordinate_answers_for_the_distance_that_it_is() -> None:
    lines = ["x component 4 throughout", "v = 4i - 0.5j", "x = 4 × 7.5 = {} m"]
    for value, state in ((30, "earned"), (36, "lost")):
        points = marked_part("b", *lines[:2], lines[2].format(value))["marks"]["points"]
        assert points[-1]["state"] == state, value


def test_components_by_a_vector_that_is_no_unit_vector() -> None:
    statement = UNKNOWN_LINE.replace("find velocity(B), line_of_centres", "find e")
    lines = ["approach: 8 + 2 = 10", "separation: 3 + 2 = 5", "e = 1/2"]
    found = marked(statement, *lines)
    assert [line["verdict"] for line in found["lines"]] == ["true"] * 3
    found = marked(statement, "approach: 8 + 2 = 10", "separation: 3 - 2 = 1", "e = 1/10")
    assert [line["verdict"] for line in found["lines"]] == ["true", "false", "follows"]
    assert names(found)[1] == "restitution-sign"
    assert marked(statement, "approach: 8 + 1 = 9")["lines"][0]["verdict"] == "false"


def test_sine_for_cosine_on_one_side_of_a_component_along_a_wall() -> None:
    statement = """wall W: along i
sphere P: velocity u at 45° to W
P hits W
given deflection(P) = 75°
find e, speed(P)
"""
    lines = ["v sin 30 = u cos 45", "v cos 30 = e u sin 45"]
    found = marked(statement, *lines, v="speed(P)")
    assert names(found)[0] == "sine-cosine"
    states = {(p["kind"], p["for"]): p["state"] for p in found["marks"]["points"]}
    assert states["M1", "Newton's experimental law"] == "earned"
    assert states["A1", "correct equation"] == "lost"
    assert names(marked(statement, "v sin 30 = u sin 45", v="speed(P)"))[0] != "sine-cosine"


def test_a_speed_by_the_name_of_its_body_is_no_rounding() -> None:
    statement = """sphere A: mass 0.3, velocity 4 at 35°
sphere B: mass 0.5, at rest
A hits B: along i, e = 0.4
find speed(A), speed(B)
"""
    for line, verdict in (
        ("A = √(0.983² + 2.294²) = 2.50", "false"),
        ("A = √(0.410² + 2.294²) = 2.33", "true"),
    ):
        assert marked(statement, line)["lines"][0]["verdict"] == verdict, line


def test_a_number_over_itself_is_no_other_number() -> None:
    statement = """sphere A: mass 3, velocity 2i + 5j
sphere B: mass 1, velocity 4i - 3j
A hits B: along j, e = 1/4
find velocity(A), velocity(B)
"""
    letters = {"p": "along(velocity(A), i)", "y": "along(velocity(A), j)"}
    for value, verdict in (("5/5", "false"), ("5/2", "true")):
        found = marked(statement, "p = 5", f"y = {value}", **letters)
        assert [line["verdict"] for line in found["lines"]] == ["false", verdict], value


# 2v + w = 11 and w - v = 2.5: v = 17/6, w = 16/3; after the wall B has -8/3.
OFF_A_WALL = """sphere A: mass 2, velocity 5i + 2j
sphere B: mass 1, velocity i + 3j
wall W: along j
A hits B: along i, e = 5/8
B hits W: e = 1/2
find speed(B)"""


@pytest.mark.parametrize(
    "words",
    [
        "speed from wall",
        "speed away from the wall",
        "speed of B away from W",
        "speed of B to the left after W",
    ],
)
def test_a_speed_with_a_sense_is_a_component(words: str) -> None:
    assert verdicts(OFF_A_WALL, f"{words} = 8/3") == ["true"]
    assert verdicts(OFF_A_WALL, f"{words} = 7.1") == ["false"]


@pytest.mark.parametrize("sign", ["//", "∥", "||", "is // to"])
def test_a_sign_for_parallel_stands_between_directions(sign: str) -> None:
    statement = (
        "sphere P: mass 0.5, velocity 6i + 3j\nwall W: unknown\nP hits W\n"
        "given velocity(P) = 2i + 6j\nfind direction(W)"
    )
    statement = statement.replace("wall W: unknown\n", "wall W\n")
    assert verdicts(statement, f"wall {sign} 3i + 4j") == ["true"]
    assert verdicts(statement, f"wall {sign} 4i + 3j") == ["false"]


def test_two_answers_that_are_right_to_two_figures_lose_one_mark() -> None:
    statement = (
        "sphere A: mass 0.3, velocity 6 at 30°\nsphere B: mass 0.2, velocity 5 at 60° from -i\n"
        "A hits B: along i, e = 0.8\nfind speed(A), speed(B)"
    )
    found = marked(
        statement,
        "0.3(6 cos 30) + 0.2(-5 cos 60) = 0.3v + 0.2w",
        "w - v = 0.8(5.196 + 2.5)",
        "v = -0.35",
        "w = 5.8",
        "speed of A = 3.0",
        "speed of B = 7.2",
        v="along(velocity(A), i)",
        w="along(velocity(B), i)",
    )
    points = found["marks"]["points"][-2:]
    assert [point["state"] for point in points] == ["lost", "earned"]
    assert points[0]["why"] == "given too coarsely"


AT_A_WALL = """wall W: along i
sphere P: mass 2, velocity 3i + 6j
P hits W: e = 2/3
find velocity(P), impulse(P), energy_lost"""


@pytest.mark.parametrize(
    "impulse",
    [
        "Impulse = change in momentum = 6i - 8j - (6i + 12j) = -20j",
        "I = final momentum - initial momentum = 2(3i - 4j) - 2(3i + 6j) = -20j",
        "I = Δmv = 2(3i - 4j) - 2(3i + 6j) = -20j",
        "Ix = 2(3 - 3) = 0, Iy = 2(-4 - 6) = -20 so I = -20j",
    ],
)
def test_an_impulse_is_a_change_of_momentum_in_words_and_by_components(impulse: str) -> None:
    lines = ["v = 3i - 4j", impulse, "loss at W = 20", "total = 20"]
    found = marked(AT_A_WALL, *lines)
    assert {line["verdict"] for line in found["lines"]} == {"true"}
    assert found["marks"]["earned"] == found["marks"]["of"]
    assert verdicts(AT_A_WALL, lines[0], "I_y = 2(4 - 6) = -4") == ["true", "false"]


def test_a_resultant_is_a_speed_and_a_total_is_what_is_asked() -> None:
    statement = CORNER + "total_energy_lost, speed(P)"
    lines = [
        "loss at X = 12",
        "loss at Y = 8",
        "total = 12 + 8 = 20",
        "resultant = √(1 + 4) = 2.24",
    ]
    found = marked(statement, *lines)
    assert {line["verdict"] for line in found["lines"]} == {"true"}
    assert [p["state"] for p in found["marks"]["points"] if p["kind"].startswith("A")] == [
        "earned",
        "earned",
    ]
    assert verdicts(statement, "total = 21", "resultant = 2.42") == ["false", "false"]


@pytest.mark.parametrize("word", ["def", "deflection", "def."])
def test_the_cosine_of_a_deflection_by_its_name(word: str) -> None:
    lines = ["v_A = 2i + j", f"cos({word}) = (6i + j).(2i + j)/(|6i + j||2i + j|) = 0.956"]
    assert verdicts(PAIR + "deflection(A)", *lines) == ["true", "true"]


def test_a_letter_ends_a_formula() -> None:
    lines = "J = m1m2/(m1 + m2) (1 + e) w = 2/3 × 4/3 × 9 = 8"
    assert verdicts(PAIR + "impulse", lines) == ["true"]
    assert verdicts(PAIR + "impulse", lines.replace("8", "6")) == ["false"]


# (3u, -4u) comes off as (3u, 9u/4): 9u² − 9u² = 0.
TURNED = """wall W: along i
sphere P: mass m, velocity u(3i - 4j)
P hits W: e = 9/16
show deflection(P) = 90°
"""


@pytest.mark.parametrize(
    "words",
    [
        "dot product",
        "so scalar product",
        "the dot product of the velocities",
        "velocity before . velocity after",
        "initial velocity · final velocity",
        "v before . v after",
        "u.v",
        "(3ui - 4uj).(3ui + 9u/4 j)",
        "(3u, -4u) . (3u, 9u/4)",
    ],
)
def test_a_scalar_product_in_words_that_is_zero_shows_a_right_angle(words: str) -> None:
    found = marked(
        TURNED,
        "after: along W 3u, away from W 9u/4",
        f"{words} = 9u² - 9u² = 0",
        "so perpendicular, deflection = 90°",
    )
    assert [line["verdict"] for line in found["lines"][1:]] == ["true", "true"]
    assert found["marks"]["points"][-1]["state"] == "earned"


def test_a_scalar_product_that_is_not_zero_is_what_it_comes_to() -> None:
    statement = "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind deflection(P)"
    lines = ["velocity before . velocity after = 9 - 8 = 1", "cos d = 1/(5 × √13)"]
    assert verdicts(statement, *lines)[0] == "true"
    assert verdicts(statement, "dot product of the velocities = 9 - 9 = 0") == ["false"]
    assert verdicts(statement, "v.v = 9 + 4 = 13, v = √13") == ["true"]


@pytest.mark.parametrize("behind", ["after the impact", "after", "m/s after the collision"])
def test_a_moment_behind_a_value_is_of_its_label(behind: str) -> None:
    statement = "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind speed(P)"
    assert verdicts(statement, f"perp: 4 × 0.5 = 2 {behind}") == ["true"]
    assert verdicts(statement, f"perp: 4 {behind}") == ["false"]
    assert verdicts(statement, "perp: 4 before the impact", f"parallel = 3 {behind}") == [
        "true",
        "true",
    ]


def test_a_printed_right_angle_by_complementary_angles_has_all_its_marks() -> None:
    found = marked(
        "wall W: along i\nsphere P: mass m, velocity u at theta to W\nP hits W: e = 1/4\n"
        "given tan(theta) = 2\nshow deflection(P) = 90°\n",
        "tan after = ¼ × 2 = ½",
        "2 × ½ = 1 so the angles add to 90°",
        "deflection = 90°",
    )
    assert found["marks"]["earned"] <= found["marks"]["of"]
    whole = marked(
        "wall W: along i\nsphere P: mass m, velocity u at theta to W\nP hits W: e = 1/4\n"
        "given tan(theta) = 2\nshow deflection(P) = 90°\n",
        "component along W = u cos θ, away from W = ¼u sin θ",
        "tan β = (¼u sin θ)/(u cos θ) = ½, where β is the angle to W after",
        "tan θ × tan β = 2 × ½ = 1",
        "so θ + β = 90° i.e. deflection is 90°",
    )
    assert whole["marks"]["earned"] == whole["marks"]["of"]


@pytest.mark.parametrize(
    "typed",
    [
        "tan(angle to Y) = 1/2 => 26.6°",
        "tan θ = 1/2 so 26.6",
        "tan θ = 1/2 = 0.5, 26.6° to Y",
        "cos θ = 2/√5 giving 26.6 degrees",
    ],
)
def test_a_value_behind_a_ratio_is_that_of_its_angle(typed: str) -> None:
    found = marked(CORNER + "angle(velocity(P), Y)", "v = i + 2j", typed)
    assert [line["verdict"] for line in found["lines"]] == ["true", "true"]
    assert found["marks"]["earned"] == found["marks"]["of"]
    wrong = typed.replace("26.6", "62.6")
    assert verdicts(CORNER + "angle(velocity(P), Y)", "v = i + 2j", wrong)[1] == "false"


def test_a_component_behind_a_ratio_is_no_angle() -> None:
    lines = ["v = i + 2j", "cos θ = 2/√5 so 2 along, 1 across"]
    assert verdicts(CORNER + "angle(velocity(P), Y)", *lines) == ["true", "true"]


@pytest.mark.parametrize(
    ("typed", "other"),
    [
        ("A: 1 in the j direction", "A: 3 in the j direction"),
        ("A: 1 along j, B: 4 along j", "A: 1 along j, B: 3 along j"),
        ("A has 1 perpendicular to LOC", "A has 4 perpendicular to LOC"),
        ("A 1 across, B 4 across", "A 4 across, B 1 across"),
        ("so A still has 1 across the line of centres", "A still has 4 across the line of centres"),
    ],
)
def test_the_way_of_a_component_stands_behind_it(typed: str, other: str) -> None:
    lines = ["2v + w = 9", "w - v = 3", "v = 2, w = 5"]
    assert verdicts(PAIR + "velocity(A), velocity(B)", *lines, typed) == ["true"] * 4
    assert verdicts(PAIR + "velocity(A), velocity(B)", *lines, other)[3] == "false"


@pytest.mark.parametrize("vector", ["(-V, 1)", "-Vi + j", "(-V; 1)"])
def test_a_component_and_a_pair_with_its_letter_are_a_velocity(vector: str) -> None:
    heavy = PAIR.replace("B: mass 1", "B: mass 5").replace("A: mass 2", "A: mass 1")
    statement = heavy + "velocity(A)"  # v + 5w = -9 and w - v = 3: v = -4, w = -1
    lines = ["5w - V = -9", "w + V = 3", "V = 4", f"v_A = {vector}"]
    found = marked(statement, *lines, V="-along(velocity(A), i)", w="along(velocity(B), i)")
    assert found["marks"]["earned"] == found["marks"]["of"]


@pytest.mark.parametrize(
    ("typed", "state"),
    [
        ("angle to Y = tan⁻¹(2/1) = 63.4°", "earned"),
        ("tan θ = 2/1, θ = 63.4°", "earned"),
        ("angle to Y = 63.4°", "lost"),
    ],
)
def test_a_tangent_upside_down_keeps_its_method(typed: str, state: str) -> None:
    found = marked(CORNER + "angle(velocity(P), Y)", "v = i + 2j", typed)
    *_, method, answer = found["marks"]["points"]
    assert (method["kind"], method["state"], answer["state"]) == ("M1", state, "lost")


WHO_STRIKES_ALONE = """sphere A: mass 2, velocity 4i + j
sphere B: mass 1, at rest
wall W: along j
A hits B: along i, e = 1/2
B hits W: e = 1/4
find impulse(B), energy_lost"""


def test_who_comes_to_a_wall_alone_has_the_energy_of_a_line_about_it() -> None:
    found = marked(WHO_STRIKES_ALONE, "v_B = 4i, then -i", "KE: 8 -> 0.5, lost 7.5")
    assert found["lines"][1]["verdict"] == "true"
    assert verdicts(WHO_STRIKES_ALONE, "KE before = 8, KE after = 1") == ["false"]


@pytest.mark.parametrize("line", ["I = 1(-1 - 4) = -5", "impulse on B = -1 - 4 = -5, to the left"])
def test_the_only_component_of_an_impulse_has_its_method(line: str) -> None:
    points = marked(WHO_STRIKES_ALONE, "speed of B after = 1", line)["marks"]["points"]
    (method,) = [point for point in points if point["for"].startswith("impulse")]
    assert method["state"] == "earned"


def test_what_is_lost_stands_behind_a_total_too() -> None:
    line = "total = 120/6 = 20 lost"
    assert verdicts(CORNER + "total_energy_lost", "12 + 8", line) == ["remark", "true"]
    assert verdicts(CORNER + "total_energy_lost", "total = 126/6 = 21 lost") == ["false"]


OFFSET = """sphere A: mass m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset r, e = 1/2
find speed(A)"""


@pytest.mark.parametrize("words", ["angle between u and line of centres", "angle of u to the LOC"])
def test_a_letter_of_a_speed_is_a_direction_beside_the_line_of_centres(words: str) -> None:
    assert verdicts(OFFSET, f"{words} is 30", "w = (1+e)/2 u cos 30 = 0.650u") == ["true", "true"]
    assert verdicts(OFFSET, f"{words} = 40") == ["false"]


def test_a_cosine_ends_a_formula_in_the_letter_of_its_value() -> None:
    lines = ["θ = 30°", "w = (1 + e)/2 u cosθ = 0.6495u"]
    assert verdicts(OFFSET, *lines) == ["true", "true"]
    assert verdicts(OFFSET, lines[0], lines[1].replace("0.6495", "0.5495"))[1] == "false"


def test_a_velocity_stands_at_both_moments_of_a_label() -> None:
    statement = (
        "wall W: along j\nsphere P: mass 1, velocity 4i + j\nP hits W: e = 1/4\nfind speed(P)"
    )
    assert verdicts(statement, "velocity before = 4i + j, after: -i + j") == ["true"]
    assert verdicts(statement, "velocity before = 4i + j, after: -4i + j") == ["false"]


def test_components_relative_to_the_mass_centre_are_none_of_the_plane() -> None:
    lines = ["vG = (2(6) + 1(-3))/3 = 3", "relative to the mass centre A has 3 and B -6 along i"]
    assert verdicts(PAIR + "velocity(A)", *lines) == ["true", "remark"]


def test_what_is_worked_out_without_a_name_is_seen() -> None:
    statement = (
        "wall W: along i\nsphere P: velocity 6 at 35° to W\nP hits W: e = 1/2\nfind speed(P)"
    )
    lines = ["6 cos 35 = 4.915", "3 sin 35 = 1.721", "v = √(4.915² + 1.721) = 5.09"]
    points = marked(statement, *lines)["marks"]["points"]
    assert [point["state"] for point in points] == ["earned", "earned", "earned", "lost"]


def test_the_end_of_a_range_as_a_decimal() -> None:
    statement = (
        "wall W: along i\nsphere P: mass m, velocity u at 60° to W\nP hits W\n"
        "given speed(P) < 3/4 u\nfind range of e"
    )
    found = marked(statement, "u²(1 + 3e²)/4 < 9u²/16", "e < 0.645")
    assert found["marks"]["earned"] == found["marks"]["of"]


def test_a_number_over_a_fraction_without_brackets() -> None:
    statement = PAIR.replace("e = 1/3", "e = 1/2") + "deflection(A)"  # v = 3/2 and w = 6
    lines = ["v = 3/2", "after tan⁻¹(1/3/2) = 33.7", "before tan⁻¹(1/6) = 9.46"]
    assert verdicts(statement, *lines) == ["true", "true", "true"]
    assert verdicts(statement, lines[0], "after tan⁻¹(1/2/3) = 33.7")[1] == "false"


def test_a_component_and_then_the_vector_of_an_impulse_by_one_letter() -> None:
    found = marked(WHO_STRIKES_ALONE, "speed of B after = 1", "I = 1(-1 - 4) = -5 so I = -5i")
    assert [line["verdict"] for line in found["lines"]] == ["true", "true"]
    states = [p["state"] for p in found["marks"]["points"] if p["line"] == 2]
    assert set(states) == {"earned"}
    wrong = verdicts(WHO_STRIKES_ALONE, "speed of B after = 1", "I = 1(1 - 4) = -3 so I = -3i")
    assert wrong[1] == "false"


LETTERS = """sphere A: mass 3m, velocity 2u i + u j
sphere B: mass m, velocity -2u i + 3u j
A hits B: along i, e = 1/2
find speed(A)"""


@pytest.mark.parametrize("unit", ["(in u)", "(in terms of u)", "(all in units of u)", "(in u's)"])
def test_the_unit_of_a_line_stands_behind_it(unit: str) -> None:
    lines = [f"6 - 2 = 3v + w {unit}", "w - v = 2", "4v = 2, v = 0.5u, w = 2.5u"]
    assert verdicts(LETTERS, *lines) == ["true", "true", "true"]
    assert verdicts(LETTERS, f"6 + 2 = 3v + w {unit}", *lines[1:])[0] == "false"


def test_titles_of_ratios_and_the_argument_of_a_velocity() -> None:
    statement = "wall W: along i\nsphere P: velocity 5i - 4j\nP hits W: e = 1/2\nfind speed(P)"
    assert verdicts(statement, "arg v = 21.8 deg") == ["true"]
    slanting = PAIR.replace("along i", "along 4i + 3j").replace("-3i + 4j", "0i + 0j")
    slanting = slanting.replace("6i + j", "5i").replace("velocity 0i + 0j", "at rest")
    line = "angle between 5i and LOC: cosθ = 4/5"
    assert verdicts(slanting + "speed(A)", line, "along before = 5cosθ = 4") == ["true", "true"]


def test_ratios_colons_and_centres_that_are_apart() -> None:
    statement = OFFSET.replace("find speed(A)", "find velocity(A), speed(B)")
    lines = ["the centres are 2r apart when they touch", "A: across the line ½u (no change)"]
    assert verdicts(statement, *lines) == ["remark", "true"]
    assert verdicts(statement, "A: across the line ⅓u") == ["false"]
    lines = ["v = 2, w = 5", "v : w = 2 : 5"]
    assert verdicts(PAIR + "velocity(A), velocity(B)", *lines) == ["true", "true"]
    declared = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    found = marked(PAIR + "velocity(A)", lines[0], "v : w = 3 : 5", **declared)
    assert [line["verdict"] for line in found["lines"]] == ["true", "false"]


_QUAY = "wall W: along i\nsphere P: mass 2, velocity 12i - 5j\nP hits W: e = 3/5\nfind energy_lost"
_IN_LINE = (
    "sphere A: mass m, velocity 6u i\nsphere B: mass 2m, at rest\n"
    "A hits B: along i, e = 1/2\nfind velocity(A), velocity(B)"
)
# A changes by -4i + 2j.
_SEEN = (
    "sphere A: mass 1, velocity 5i + j\nsphere B: mass 2, velocity -i + 3j\nA hits B\n"
    "given velocity(A) = i + 3j\nfind line_of_centres, velocity(B)"
)
_BOX = (
    "sphere P: mass 2, velocity 6i - 4j\nwall AB: along i\nwall BC: along j\n"
    "P hits AB: e = 1/2\nP hits BC: e = 2/3\nfind velocity(P)"
)


@pytest.mark.parametrize(
    ("statement", "line", "verdict"),
    [
        (_QUAY, "before: speed 13, after: speed √153", "true"),
        (_QUAY, "before: speed 13, after: speed √150", "false"),
        (_IN_LINE, "A 0 and B 3u", "remark"),
        (_SEEN, "change of A is -4i + 2j which is along the line of centres", "true"),
        (_SEEN, "parallel to 2i - j", "true"),
        (_SEEN, "so parallel to 2i + j", "false"),
        (_BOX, "after AB: 6i + ½(4)j = 6i + 2j", "true"),
        (_BOX, "after AB: 6i - ½(4)j = 6i - 2j", "false"),
    ],
)
def test_what_is_listed_or_said_behind_a_value(statement: str, line: str, verdict: str) -> None:
    assert verdicts(statement, line) == [verdict]


def test_a_list_of_bodies_gives_their_velocities() -> None:
    pair = _IN_LINE.replace("e = 1/2", "e = 1/5")
    for line in ("A 6u/5 and B 12u/5", "so A 1.2u, B 2.4u", "A 6u/5 i and B 12u/5 i"):
        marks = restitution.mark(solution_of(pair), line).marks
        assert marks.earned == marks.of
    for line in ("A 2u and B 2u", "A m and B 2m"):
        assert restitution.mark(solution_of(pair), line).marks.earned == 0
