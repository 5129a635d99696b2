"""What sentences, lists and bare numbers of students say of amounts: energies, shares, impulses."""

from __future__ import annotations

import pytest
from marked import solution_of, verdicts

import restitution

WALL = "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W: e = 1/2\n"
BOTH = (
    "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 1, velocity -i + 4j\n"
    "A hits B: along i, e = 1/2\n"
)
AT_SIXTY = "wall W: along i\nsphere P: mass m, velocity u at 60° to W\nP hits W: e = 1/3\n"
AT_FORTY = (
    "wall W: along j\nsphere P: mass 1/2, velocity 4 at 40° to W\nP hits W\n"
    "given angle(velocity(P), W) = 26°\nfind e\n"
)
TRAY = (
    "wall W: along i\nwall X: along j\nsphere P: mass 2, velocity 8i - 6j\nP hits W: e = 1/3\n"
    "P hits X: e = 1/4\nfind total_energy_lost\n"
)
HALL = (
    "wall W: along i, through (0, 8)\nsphere P: at (0, 0), velocity 2i + 4j\nP hits W: e = 1/4\n"
    "find position(P, at 5)\n"
)
ENERGY = f"{WALL}find energy_lost"
IMPULSE = f"{WALL}part a\nfind velocity(P)\npart b\nfind impulse"
SPEED = f"{WALL}find speed(P)"
SHARE = f"{BOTH}find energy_lost/energy(0) as a percentage"
KEPT = f"{AT_SIXTY}find energy_lost/energy(0)"


def marks(statement: str, *lines: str) -> str:
    """The points of a script for the last part: earned or lost."""
    solution = solution_of(statement)
    points = restitution.mark(solution, list(lines), [*solution.parts][-1]).marks.points
    return "".join({"earned": "+", "lost": "-", "open": "?"}[point.state] for point in points)


@pytest.mark.parametrize(
    ("statement", "line", "wanted"),
    [
        (ENERGY, "KE before 25 KE after 13 lost 12", "++"),
        (ENERGY, "KE before 25 J, after 13 J so 12 J lost", "++"),
        (ENERGY, "KE 25 before, 13 after", "+-"),
        (ENERGY, "it loses 12 J", "++"),
        (ENERGY, "KE before 25 after 13 lost 11", "+-"),  # by a slip in the difference
        (f"{BOTH}find energy_lost", "KE before 21.5 after 17.5 lost 5", "+-"),
        (f"{BOTH}find energy_lost", "the balls lose 3 m/s", "--"),
        (SHARE, "4/21.5 x 100 = 18.6%", "+"),
        (SHARE, "4/17.5 x 100 = 22.9%", "-"),
        (SHARE, "4 out of 17.5 is 22.9%", "-"),
        (SHARE, "4 out of 21.5 is 18.6%", "+"),
        (SHARE, "KE lost = 4", "-"),  # which is no share
        (SHARE, "lost 4 which is 18.6%", "+"),
        (KEPT, "keeps 1/3 of the energy, loses 66.7%", "++"),
        (KEPT, "loses 2/3 of its KE", "++"),
        (KEPT, "loses 1/3 of its KE", "--"),
    ],
)
def test_amounts_in_sentences_earn_what_they_say(statement, line, wanted):
    assert marks(statement, line).endswith(wanted)


def test_amounts_in_sentences_are_true_where_they_are() -> None:
    assert verdicts(ENERGY, "KE before 25 KE after 13 lost 12") == ["true"]
    assert verdicts(SHARE, "lost 4 which is 18.6%") == ["true"]
    assert verdicts(KEPT, "keeps 1/3 of the energy, loses 66.7%") == ["true"]


def test_a_percentage_of_the_energy_after_is_false_and_no_question_about_words() -> None:
    assert verdicts(SHARE, "percentage lost = 22.9%") == ["false"]


def test_the_total_lost_by_one_sphere_is_that_of_all_impacts() -> None:
    assert verdicts(TRAY, "total lost = 68 - 8 = 60") == ["false"]
    assert verdicts(TRAY, "total lost = 100 - 8 = 92") == ["true"]


def test_a_component_changes_in_a_sentence() -> None:
    assert verdicts(SPEED, "the component along the wall changes to 1.5") == ["false"]
    assert verdicts(SPEED, "the component along the wall stays 3") == ["true"]
    assert verdicts(SPEED, "3 along the wall stays 3") != ["false"]


def test_a_word_for_the_way_out_takes_no_factor_with_it() -> None:
    assert verdicts(AT_FORTY, "out 3.06 tan 26 = 1.49") == ["true"]


def test_a_sphere_sets_off_with_a_speed() -> None:
    statement = f"{BOTH}find speed(B)"
    assert verdicts(statement, "B goes off at 5 m/s") == ["true"]
    assert verdicts(statement, "B goes off at 53.1 degrees") != ["false"]


@pytest.mark.parametrize(
    ("line", "wanted", "mistake"),
    [
        ("2*4 - 2*2 = 4", "+-", "impulse-sign"),
        ("2(4 - 2) = 4", "+-", "impulse-sign"),
        ("2*4 + 2*2 = 12", "++", None),
        ("2*4 = 8", "--", None),  # a momentum on the way
    ],
)
def test_a_change_of_momentum_in_numbers_alone_is_an_impulse(line, wanted, mistake):
    (judged,) = restitution.mark(solution_of(IMPULSE), line, "b").lines
    assert marks(IMPULSE, line) == wanted
    assert (judged.mistake.id if judged.mistake else None) == mistake


def test_bare_numbers_are_the_impulse_beside_another_answer() -> None:
    wall = WALL.replace("1/2", "1/4")
    statement = f"{wall}part a\nfind velocity(P)\npart b\nfind impulse, energy_lost"
    lines = ("2*4 - 2*1 = 6", "25 - 10 = 15")
    assert marks(statement, *lines) == "+-++"


def test_a_decimal_that_rounds_what_is_asked_answers() -> None:
    statement = (
        "sphere A: mass 1, velocity 8 at 30°\nsphere B: mass 2, velocity 5 at 120°\n"
        "A hits B: along i, e = 0.6\nfind impulse\n"
    )
    assert marks(statement, "6.93 + 3.13 = 10.1").endswith("++")


def test_squares_that_are_subtracted_are_no_method_for_a_speed() -> None:
    assert marks(SPEED, "perp 2 and 3 along", "v = √(3² + 2²) = 3.61").endswith("++")
    assert marks(SPEED, "perp = 2", "v = √(3² - 2²) = 2.24").endswith("--")


def test_what_stays_is_seen_in_a_vector_and_in_a_tangent_below_a_mistake() -> None:
    velocities = f"{BOTH}find velocity(A), velocity(B)"
    wrong = ("2*3 + 1*1 = 2v + w", "w - v = 2", "v = 5/3", "w = 11/3")
    assert marks(velocities, *wrong)[0] == "-"
    assert marks(velocities, *wrong, "so 1.67i + 2j and 3.67i + 4j")[0] == "+"


def test_coordinates_are_those_of_the_place_that_is_asked() -> None:
    assert verdicts(HALL, "x = 2x5 = 10, y = 8 - 3 = 5 so its at (10, 5)") == ["true"]
    assert marks(HALL, "at wall (4, 8)").count("+") > 0
