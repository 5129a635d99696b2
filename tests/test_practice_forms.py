"""Lines in forms that students use beside equations: true ones hold, those with a slip do not."""

from __future__ import annotations

import random
from functools import cache

import pytest

import restitution
from restitution.solving.solution import Solution

WAYS = ((3, 4, 5), (4, 3, 5), (-3, 4, 5), (5, 12, 13), (4, -3, 5), (12, 5, 13))


@cache
def solution_of(statement: str) -> Solution:
    return restitution.solve(restitution.parse(statement))


def verdicts(statement: str, *lines: str) -> list[str]:
    marking = restitution.mark(solution_of(statement), "\n".join(lines))
    return [line["verdict"] for line in marking.json()["lines"]]


def oblique(seed: int) -> tuple[str, dict[str, tuple[int, int]]]:
    """Two spheres with a line of centres along neither axis; components along and across it."""
    dice = random.Random(seed)
    x, y, size = WAYS[seed % len(WAYS)]
    parts = {
        "A": (dice.randint(2, 5), dice.choice((-3, -1, 2))),
        "B": (dice.randint(-3, 0), dice.choice((1, 4, 6))),
    }
    velocities = {
        name: f"({p * x - q * y}/{size}) i + ({p * y + q * x}/{size}) j"
        for name, (p, q) in parts.items()
    }
    statement = (
        f"sphere A: mass 2, velocity {velocities['A']}\n"
        f"sphere B: mass 3, velocity {velocities['B']}\n"
        f"A hits B: along {x}i + {y}j, e = 1/2\nfind velocity(A), velocity(B)\n"
    )
    return statement.replace("+ -", "- "), parts


@pytest.mark.parametrize("seed", range(6))
def test_components_in_turned_axes_hold_and_those_of_another_size_do_not(seed: int) -> None:
    statement, parts = oblique(seed)
    (p, q), (r, s) = parts["A"], parts["B"]
    lines = f"velocity before of A = ({p}, {q})", f"velocity before of B = ({r}, {s})"
    assert verdicts(statement, *lines) == ["true", "true"]
    assert verdicts(statement, f"velocity before of A = ({p + 1}, {q})") == ["false"]


def test_axes_along_i_and_j_leave_no_sign_open() -> None:
    statement = (
        "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 3, at rest\n"
        "A hits B: along i, e = 1/2\nfind velocity(A)\n"
    )
    assert verdicts(statement, "velocity before of A = (3, 2)") == ["true"]
    assert verdicts(statement, "velocity before of A = (3, -2)") == ["false"]


@pytest.mark.parametrize("seed", range(6))
def test_scalar_products_with_n_and_t_need_no_declaration(seed: int) -> None:
    statement, parts = oblique(seed)
    (p, q), (r, s) = parts["A"], parts["B"]
    lines = f"u_A.n = {p}", f"u_B.n = {r}", f"u_A.t = {q}", f"u_B.t = {s}"
    assert verdicts(statement, *lines) == ["true"] * 4


FOUND = (
    "sphere A: mass 1, velocity 5i + 5j\nsphere B: mass 2, velocity -5i\nA hits B\n"
    "given velocity(A) = -i - 3j\nfind line_of_centres, velocity(B), e\n"
)
SAYINGS = (
    "line of centres parallel to {}",
    "line of centres is {}",
    "so the line of centres is along {}",
    "loc = {}",
    "the line of centres is in the direction {}",
)


@pytest.mark.parametrize("saying", SAYINGS)
def test_which_way_the_line_of_centres_points_is_a_claim(saying: str) -> None:
    for way, verdict in (("3i + 4j", "true"), ("-6i - 8j", "true"), ("4i - 3j", "false")):
        assert verdicts(FOUND, saying.format(way)) == [verdict], way


def test_a_change_of_a_body_is_that_of_its_velocity() -> None:
    assert verdicts(FOUND, "change in A = -6i - 8j, parallel to 3i + 4j") == ["true"]
    assert verdicts(FOUND, "change in A = -6i + 8j") == ["false"]


WALLS = (
    "wall W: along i\nwall V: along j\nsphere P: mass 2, velocity 8i - 6j\n"
    "P hits W: e = 1/2\nP hits V: e = 3/4\nfind velocity(P), total_energy_lost\n"
)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("after W: 8i + 3j", "after V: -6i + 3j"),
        ("1st wall: 8i + 3j", "2nd wall: -6i + 3j"),
        ("after W - 8i + 3j", "after V - -6i + 3j"),
    ],
)
def test_a_vector_behind_a_heading_is_the_velocity_there(first: str, second: str) -> None:
    assert verdicts(WALLS, first, second) == ["true", "true"]
    turned = second.replace("-6i", "6i").replace("- 6i", "6i")
    assert verdicts(WALLS, first, turned) == ["true", "false"]


def test_what_a_heading_speaks_of_is_not_another_wall() -> None:
    """Along the second wall is not along the first, whatever is true there."""
    assert verdicts(WALLS, "after W: 8i + 3j", "at V: parallel = 8") == ["true", "false"]


PAIR = (
    "sphere A: mass 3, velocity 4i + 2j\nsphere B: mass 2, velocity -i + 3j\n"
    "A hits B: along i, e = 1/2\nfind velocity(A), velocity(B), energy_lost\n"
)


def test_the_mass_centre_has_its_own_velocity() -> None:
    names = "velocity of centre of mass", "vel of com", "velocity of the mass centre along i"
    for name in names:
        assert verdicts(PAIR, f"{name} = 10/5 = 2") == ["true"], name
        assert verdicts(PAIR, f"{name} = 3") == ["false"], name


def test_the_way_behind_a_value_is_that_of_a_component() -> None:
    assert verdicts(PAIR, "before", "A: 4 along, 2 perp", "B: 1 left, 3 up")[1:] == ["true", "true"]
    assert verdicts(PAIR, "before", "A: 5 along, 2 perp")[1:] == ["false"]


def test_the_factor_behind_a_sum_may_belong_to_all_of_it() -> None:
    statement = (
        "sphere A: mass m, velocity 3u i + u j\nsphere B: mass 3m, velocity u j\n"
        "A hits B: along i, e = 1/2\nfind energy_lost\n"
    )
    assert verdicts(statement, "KE before 5 + 1.5 = 6.5mu²") == ["true"]
    assert verdicts(statement, "KE before 5 + 2.5 = 7.5mu²") == ["false"]


def test_an_angle_to_a_wall_may_be_the_obtuse_one() -> None:
    statement = "wall W: along i\nsphere P: velocity 4 at 60° to W\nP hits W: e = 1/3\n"
    statement += "find angle(velocity(P), W)\n"
    assert verdicts(statement, "angle to W = 180 - 30 = 150") == ["true"]
    assert verdicts(statement, "angle to W = 140") == ["false"]


def test_a_letter_met_below_a_mistake_means_what_makes_it_follow() -> None:
    statement = "wall W: along i\nsphere P: velocity 12 at 60° to W\nP hits W: e = 1/3\n"
    statement += "find speed(P), angle(velocity(P), W)\n"
    lines = "parallel after = 12 sin 60 = 6√3", "perp after = 1/3 * 12 cos 60 = 2"
    angle = "tan β = 2/(6√3), β = 10.9"
    assert verdicts(statement, *lines, angle)[2] == "follows"
    assert verdicts(statement, *lines, "tan β = 3/(6√3)")[2] != "follows"


def test_two_bodies_may_stand_on_one_line() -> None:
    assert verdicts(PAIR, "A = i + 2j  B = 3.5i + 3j") == ["true"]
    assert verdicts(PAIR, "A = i + 2j  B = 3i + 3j") == ["false"]


def test_a_sign_lost_in_a_given_impulse_is_not_one_of_restitution() -> None:
    statement = (
        "wall W: along i\nsphere P: mass 0.5, velocity 7i - 4j\nP hits W\n"
        "given impulse = 3\nfind e, speed(P)\n"
    )
    marking = restitution.mark(solution_of(statement), "3 = 0.5(4 - 4e)")
    (line,) = marking.json()["lines"]
    assert line["verdict"] == "false"
    assert line["mistake"]["id"] != "restitution-sign"
