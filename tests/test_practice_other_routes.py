"""Right workings by routes and in words of the student's own, none of whose lines may be false."""

from __future__ import annotations

import pytest
from marked import solution_of, verdicts

import restitution

APART = (
    "sphere A, B: mass m\nsphere A: velocity 3i + 4j\nsphere B: velocity -i + j\n"
    "A hits B: along i + j, e = 0\nfind distance(A, B, at 3), velocity(A)\n"
)
CHAIN = (
    "sphere A, B, C: mass m\nsphere A: velocity u i\nsphere B, C: at rest\n"
    "A hits B: along 60°, e = 1/2\nfind speed(B)\nB hits C: along 30°, e = 1/2\n"
    "find velocity(B), speed(C)\n"
)
BACK = (
    "wall W: along j\nsphere A: mass 4m, velocity u i\nsphere B: mass m, at rest\n"
    "A hits B: along i, e = 3/4\nB hits W: e = f\nfind velocity(A), velocity(B)\n"
)
OFFSET = (
    "sphere A: mass m, velocity -2u i, radius a\nsphere B: mass m, velocity u i, radius a\n"
    "A hits B: offset sqrt(3) a, e = 2/3\nfind speed(A), speed(B), line_of_centres\n"
)
SLANTED = "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W: e = 1/2\nfind velocity(P)"


def earned(statement: str, *lines: str) -> tuple[int, int]:
    """The marks that lines earn, and those that there are."""
    marks = restitution.mark(solution_of(statement), list(lines)).marks
    return marks.earned, marks.of


@pytest.mark.parametrize(
    "line",
    [
        "distance after 3 secs = 3√(¼+¼) = 2.12",
        "distance apart after 3 s = 2.12",
        "distance 3 seconds later = 2.12",
        "dist at t = 3: 2.12",
    ],
)
def test_the_time_of_a_distance_is_no_value_of_it(line: str) -> None:
    assert verdicts(APART, line) == ["true"]


def test_the_size_of_a_relative_velocity_is_a_speed() -> None:
    assert verdicts(APART, "relative velocity = (-0.5, 0.5), speed = 0.7071") == ["true"]


@pytest.mark.parametrize(
    "line",
    [
        "perp: A: 1/√2, B: √2",
        "perp: A 1/√2, B √2",
        "perp A: 1/√2, B: √2",
        "perp components: A = 1/√2, B = √2",
        "along after: A: 7/(2√2), B: 7/(2√2)",
    ],
)
def test_a_way_before_several_bodies_is_that_of_each(line: str) -> None:
    assert verdicts(APART, line) == ["true"]


def test_a_way_before_several_bodies_shows_a_mistake() -> None:
    assert verdicts(APART, "perp after: A: 1/√2, B: 1/√2") == ["false"]


def test_a_letter_that_was_a_number_becomes_a_vector() -> None:
    assert verdicts(CHAIN, "vB = 3u/8", "vB = (-3u/128, 15√3u/128)") == ["true"] * 2
    assert verdicts(CHAIN, "vB = 3u/8", "vB = (-3u/128, 15√3u/64)")[0] == "true"


def test_an_approach_along_a_direction_of_the_students_own() -> None:
    lines = ("n = -½i - √3/2 j", "rel speed of approach along n = 3u cos 60 = 1.5u")
    assert verdicts(OFFSET, *lines) == ["true"] * 2


@pytest.mark.parametrize("axis", ["y velocity", "y-velocity", "y speed", "j velocity"])
def test_a_velocity_may_be_of_an_axis(axis: str) -> None:
    assert verdicts(SLANTED, f"{axis} after = 0.5×4 = 2") == ["true"]
    assert verdicts(SLANTED, f"{axis} after = 4") == ["false"]
    assert verdicts(SLANTED, "0.5 x speed of approach = 2") == ["true"]


@pytest.mark.parametrize(
    "rebound",
    [
        "velocity of B after wall = 7fu/5 away from wall",
        "B rebounds with 1.4fu to the left",
        "after wall B: -7fu/5",
        "after wall B has speed 7fu/5",
    ],
)
def test_along_one_line_a_speed_answers_for_a_velocity(rebound: str) -> None:
    laws = ("4u = 4x + y", "y - x = ¾u", "x = 13u/20", "y = 7u/5")
    got, total = earned(BACK, *laws, rebound)
    assert got == total
    assert earned(BACK, *laws)[0] < total


KEEPS = (
    "sphere A: mass 2m, velocity 2u i + u j\nsphere B: mass k m, velocity -u i + 2u j\n"
    "A hits B: along i, e = 1/2\nshow along(velocity(A), i) = (8 - 5k)u/(2(2 + k))\n"
)
FOUR = (
    "sphere A: mass 4, velocity 3i + 2j\nsphere B: mass 1, velocity -2i + 4j\n"
    "A hits B: along i, e = 1/2\nfind energy_lost, deflection(B)\n"
)
BOARD = "wall W\nsphere P: mass 2, velocity 7i - 4j\nP hits W\ngiven velocity(P) = 3i + 4j\n"
WHICH = f"{BOARD}part a\nfind direction(W)\npart b\nfind impulse\n"
SHOWN = (
    "wall W: along i\nsphere P: mass m, velocity u at 45° to W\nP hits W\n"
    "show speed(P)^2 = u^2 (1 + e^2)/2\n"
)
UNKNOWN = (
    "sphere A: mass 3, velocity 4i + 3j\nsphere B: mass k, velocity -2i + j\n"
    "A hits B: along i, e = 1/2\ngiven velocity(A) in the direction of -2i + 3j\nfind k\n"
)
LINED = (
    "sphere A: mass 2m, velocity 5u i\nsphere B: mass 3m, at rest\nA hits B: e = 2/3\n"
    "given direction(B) = -arctan(3/4)\nfind velocity(B)\n"
)
GIVEN = (
    "wall W: along i\nsphere P: mass m, velocity u at 45° to W\nP hits W\n"
    "given deflection(P) = 75°\nfind e\n"
)
EQUAL = (
    "sphere A: mass 2, velocity 4i + 3j\nsphere B: mass 2, velocity -2i - j\nA hits B: along i\n"
    "given energy_lost = 13.5\nfind e\n"
)
TURNED = (
    "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, at rest\nA hits B: along i\n"
    "given deflection(A) = 30°\nfind e\n"
)


def names(statement: str, *lines: str, letters: dict[str, str] | None = None) -> list[object]:
    """The names of the mistakes in the lines that are false."""
    marking = restitution.mark(solution_of(statement), list(lines), letters=letters)
    return [x["mistake"]["id"] for x in marking.json()["lines"] if x["verdict"] == "false"]


COMPONENTS = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}


@pytest.mark.parametrize(
    "line",
    [
        "A: 2u - 9ku/(2(2 + k)) = (8 + 4k - 9k)u/(2(2 + k)) = (8 - 5k)u/(2(2 + k))",
        "A = 2u - 9ku/(2(2 + k)) = (8 - 5k)u/(2(2 + k))",
        "A = (8 - 5k)u/(2(2 + k))",
    ],
)
def test_the_name_of_a_sphere_stands_for_its_component(line: str) -> None:
    laws = ("4u - ku = 2v + kw", "w - v = 3u/2", "2v + k(v + 3u/2) = 4u - ku")
    assert verdicts(KEEPS, *laws, line) == ["true"] * 4
    got, total = earned(KEEPS, *laws, line)
    assert got == total


def test_the_name_of_a_sphere_before_a_calculation_accuses_nobody() -> None:
    assert verdicts(FOUR, "A: 4×3 - 4×1.5 = 6") == ["true"]


def test_energies_before_and_after_may_both_be_of_the_components_along_the_line() -> None:
    before, after = "KE before = 18 + 2 = 20", "KE after = ½(4)(1.5)² + ½(1)(4)² = 12.5"
    assert verdicts(FOUR, f"{before} (along i only)", after, "KE lost = 7.5") == ["true"] * 3
    assert verdicts(FOUR, before, "KE after = ½(4)(2.5²) + ½(1)(32) = 28.5")[0] == "false"


def test_a_result_with_a_nought_behind_its_point_is_rounded() -> None:
    pair = (
        "sphere A: mass 2, velocity 10 at 30°\nsphere B: mass 3, velocity 4 at 120°\n"
        "A hits B: along i, e = 0.4\nfind speed(A)\n"
    )
    marking = restitution.mark(solution_of(pair), ["w = 4.0"], letters=COMPONENTS)
    assert marking.json()["lines"][0]["verdict"] == "true"


def test_a_sum_of_squares_is_on_the_way_to_a_printed_product() -> None:
    assert verdicts(SHOWN, "v² = u²/2 + (eu/√2)²") == ["true"]
    assert earned(SHOWN, "u/√2 and eu/√2", "v² = u²/2 + (eu/√2)²") == (3, 4)


def test_a_divisor_may_end_at_a_space() -> None:
    assert verdicts(LINED, "n = 0.8i - 0.6j", "vB = 8mu/3m n") == ["true"] * 2


@pytest.mark.parametrize(
    "line", ["wall ∥ i + ½j", "wall direction = 2i + j", "impulse = -8i + 16j, ⟂ to wall"]
)
def test_ways_of_a_wall(line: str) -> None:
    assert restitution.mark(solution_of(WHICH), [line], "a").json()["lines"][0]["verdict"] == "true"


def test_a_formula_in_words_within_a_chain_is_passed_over() -> None:
    chain = "J = m × (sum of perp speeds) = 2(15/√5 + 5/√5) = 8√5 Ns"
    marking = restitution.mark(solution_of(WHICH), [chain], "b", letters={"J": "impulse"})
    assert marking.json()["lines"][0]["verdict"] == "true"


def test_a_value_is_solved_wrongly_from_the_equation_before_it() -> None:
    assert names(TURNED, "so v = 0", "1 - 2e = 0, e = 2", letters=COMPONENTS) == ["algebra"]
    assert names(UNKNOWN, "12 - 2k = -6 + k", "12 - 6 = 3k") == ["sign"]
    lines = ("v = 1 - 3e and w = 1 + 3e", "20 - (1 - 3e)² - (1 + 3e)² = 13.5", "18 - 9e² = 13.5")
    assert names(EQUAL, *lines, letters=COMPONENTS) == ["algebra"]


def test_a_mass_left_out_of_one_sphere_is_no_sign() -> None:
    above = ("v = -2", "w = 1")
    wrong = {"4 - 2k = -2 + k": "mass-omitted", "12 + 2k = -6 + k": "momentum-sign"}
    for line, name in wrong.items():
        assert names(UNKNOWN, *above, line, letters=COMPONENTS) == [name]


def test_a_law_is_seen_by_its_terms() -> None:
    (line,) = restitution.mark(solution_of(UNKNOWN), ["w + 2 = 3"], letters=COMPONENTS).json()[
        "lines"
    ]
    assert line["principle"] == "restitution"


def test_mistakes_that_have_one_value_by_chance() -> None:
    cosine = "cos(deflection(B)) = (8 + 16)/(√20 √32)"
    assert names(FOUR, cosine) == ["sign"]
    both = "KE lost = ½(4)(3² - 1.5²) + ½(1)(2² - 4²) = 13.5 + 6 = 19.5"
    assert names(FOUR, both) != ["energy-one-sphere"]
    assert names(LINED, "A along: 5u × 3/5 = 3u") == ["sine-cosine"]
    assert names(GIVEN, "tan 75 = e tan 45") == ["deflection-is-after"]


KICKED = (
    "sphere A: mass 2, velocity 5i\nsphere B: mass 3, velocity -i\nA hits B: along i, e = 1/2\n"
    "A receives p i + q j\ngiven velocity(A) = velocity(B, 0)\nfind p, q\n"
)
PLACED = (
    "sphere A: mass 2m, at (0, 0), velocity 2u i\nsphere B: mass m, at (4a, 0), at rest\n"
    "A hits B: along i, e = 1/2\nfind distance(A, B, at 5a/u), position(A, at 5a/u)\n"
)
LATER = (
    "sphere A: mass 2m, velocity u at 30°\nsphere B: mass m, velocity u j\npart a\n"
    "A hits B: along i\nshow impulse = sqrt(3)/3 m u (1 + e)\n"
    "part b\nshow energy_lost = 1/4 m u^2 (1 - e^2)\n"
)


def test_an_impulse_may_be_that_of_a_blow() -> None:
    assert verdicts(KICKED, "impulse = 2(-1 - (-0.4)) = -1.2") == ["true"]
    assert verdicts(KICKED, "impulse = -1.3") == ["false"]


def test_a_number_behind_a_sphere_may_be_where_it_is() -> None:
    assert verdicts(PLACED, "w - v = u", "A: 4a + 3a = 7a", "A: 7a") == ["true"] * 3


def test_a_component_found_anew_in_a_later_part_has_its_mark() -> None:
    solution = solution_of(LATER)
    lines = ["v = √3u(2 - e)/6", "v = √3u(2 + e)/6"]
    got = [restitution.mark(solution, [line], "b").marks.earned for line in lines]
    assert got == [1, 0]


def test_the_velocity_of_the_mass_centre_by_its_letter() -> None:
    lines = ("Vcm = (12 - 2)/5 = 2", "v = Vcm - ½ × (3 - 2) = 1.5", "w - Vcm = 2", "5Vcm = 12 - 2")
    marking = restitution.mark(solution_of(FOUR), list(lines), letters=COMPONENTS)
    assert [line["verdict"] for line in marking.json()["lines"]] == ["true"] * len(lines)


def test_the_tangent_of_an_angle_in_words() -> None:
    statement = "wall W: along 3i + 4j\nsphere S: mass 2, velocity 7i + j\nS hits W: e = 3/5\n"
    lines = ("tan of wall angle = 4/3", "tan of angle to wall after = 3/5")
    assert verdicts(f"{statement}find velocity(S)", *lines) == ["true"] * 2


TWO_WALLS = (
    "wall X: along j\nwall U: along i\nsphere Q: mass 2, velocity 8i + 12j\n"
    "Q hits X: e = 1/2\nQ hits U: e = 1/4\nfind velocity(Q, 1), velocity(Q), speed(Q)\n"
)


def test_letters_of_the_end_are_those_of_the_event_of_a_heading() -> None:
    letters = {"p": "along(velocity(Q), i)", "q": "along(velocity(Q), j)", "U": "speed(Q)"}

    def marked(*lines: str) -> tuple[list[str], int]:
        marking = restitution.mark(solution_of(TWO_WALLS), list(lines), letters=letters)
        return [line["verdict"] for line in marking.json()["lines"]], marking.marks.earned

    # U is the name of a wall, and a letter where it has a value.
    right = ("after X: p = -4, q = 12", "after U: p = -4, q = -3", "U = √(16 + 9) = 5")
    assert marked(*right) == (["true"] * 3, 8)
    assert marked("after X: p = 4, q = 12")[0] == ["false"]
    assert marked("after U: p = -4, q = 12")[0] == ["false"]


def test_components_before_and_after_are_products_with_a_whole_vector() -> None:
    # Along 3i + j the components are 10/√10 and 5/√10.
    statement = (
        "wall W\nsphere P: mass 1, velocity 3i + j\nP hits W\n"
        "given velocity(P) = -1.5i - 0.5j\nfind e"
    )
    assert verdicts(statement, "components: before 10, after 5") == ["true"]
    assert verdicts(statement, "comps 10 before, 4 after") == ["false"]


def test_a_direction_needs_no_mass() -> None:
    statement = (
        "wall K\nsphere P: mass 3, velocity 5i + j\nP hits K\n"
        "given velocity(P) = 2i + 2j\nfind impulse(P), direction(K)"
    )
    change = "impulse = 2i + 2j - 5i - j = -3i + j"
    assert earned(statement, change, "wall parallel to i + 3j") == (3, 5)
    assert earned(statement, change, "wall parallel to 3i + j") == (1, 5)


def test_a_deflection_by_two_tangents_needs_no_line_above() -> None:
    statement = (
        "sphere A: mass 2, velocity 6i + 2j\nsphere B: mass 4, at rest\n"
        "A hits B: along i, e = 1/4\nfind speed(A), deflection(A)"
    )
    turn = "deflection = tan^-1(2/1) - tan^-1(2/6) = 45"
    # The method and the answer of the speed are lost.
    assert earned(statement, "speed of A = 1", turn) == (9, 11)


GATE = (
    "title A puck and a kerb\nwall W: along i\nsphere P: mass m, velocity 8 at 60° to W\n"
    "P hits W: e = 1/2\nfind speed(P), angle(velocity(P), W)"
)


def test_a_speed_at_an_angle_is_both() -> None:
    # The components are 4 and 2√3.
    for line in ("5.29 m/s at 40.9° to the kerb", "so 5.29 at an angle of 40.9 degrees to W"):
        assert earned(GATE, line) == (6, 6), line
    assert verdicts(GATE, "5.29 at 49.1° to the wall") == ["false"]
    assert verdicts(GATE, "8 at 60° to the kerb") == ["true"]


def test_what_is_solved_is_no_component_of_the_same_letter() -> None:
    # B has u along j, which stays.
    statement = (
        "sphere A: mass 2m, velocity 4u i\nsphere B: mass m, velocity -u i + u j\n"
        "A hits B: along i\nshow along(velocity(A), i) = u(7 - 5e)/3"
    )
    lines = ("8mu - mu = 2mv + mw", "w - v = 5eu", "7u - 5eu = 3v => v = u(7 - 5e)/3")
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    marking = restitution.mark(solution_of(statement), list(lines), letters=letters)
    assert marking.marks.earned == marking.marks.of
