"""Energies of which a line says only when, and shares of them."""

from __future__ import annotations

import pytest
from marked import verdicts

import restitution
from restitution.practice.marking.answers import mark_answers

_LOSS = (
    "sphere A: mass 2, velocity 5i + 2j\nsphere B: mass 3, velocity -i + 4j\n"
    "A hits B: along i, e = 1/3\nfind energy_lost"
)
_SHARE = _LOSS.replace("energy_lost", "energy_lost/energy(0)")


@pytest.mark.parametrize("label", ["before = {}", "before {}", "total before: {}", "before {} J"])
def test_an_energy_may_say_only_when(label: str) -> None:
    lines = [label.format("54.5"), label.replace("before", "after").format("35.3"), "lost 19.2 J"]
    assert verdicts(_LOSS, *lines) == ["true", "true", "true"]


def test_what_is_lost_follows_from_a_wrong_energy() -> None:
    after = "after = 1/2 x 2 x 4.04 + 1/2 x 3 x 20.84 = 34.3"
    lines = ["before = 1/2 x 2 x 29 + 1/2 x 3 x 17 = 54.5", after, "lost = 20.2"]
    assert verdicts(_LOSS, *lines) == ["true", "false", "follows"]


def test_numbers_before_and_after_are_no_energies_where_a_share_is_asked() -> None:
    """They may count in other units: 109 and 70.6 halves of a joule."""
    lines = ["before 109", "after 70.6", "lost 38.4/109 = 0.352"]
    assert "false" not in verdicts(_SHARE, *lines)


def test_a_share_is_worked_out_behind_what_is_lost() -> None:
    assert verdicts(_SHARE, "19.2/54.5 lost = 0.352") == ["true"]
    assert verdicts(_SHARE, "19.2/54.5 lost = 0.452") == ["false"]


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("KE lost = -19.2", "false"),
        ("loss in KE = 35.3 - 54.5 = -19.2", "false"),
        ("KE lost by A = 4.04 - 29 = -24.96", "false"),
        ("change in KE = -19.2", "true"),
        ("change in KE = 19.2", "true"),
        ("gain in KE = -19.2", "true"),
        ("gain in KE = 19.2", "false"),
        ("KE lost = 54.5 - 35.3 = 19.2", "true"),
    ],
)
def test_a_loss_and_a_gain_have_their_sign(line: str, verdict: str) -> None:
    assert verdicts(_LOSS, line) == [verdict]


def test_a_loss_with_the_sign_of_a_gain_is_a_slip_of_sign() -> None:
    """It keeps the method, and loses the answer."""
    marks = restitution.mark(restitution.parse(_LOSS), ["KE lost = 35.3 - 54.5 = -19.2"]).json()
    assert marks["lines"][0]["mistake"]["id"] == "sign"
    states = [(point["kind"], point["state"]) for point in marks["marks"]["points"][-2:]]
    assert states == [("M1", "earned"), ("A1", "lost")]


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (_LOSS, ["A: 29 J to 4.04 J, B: 25.5 J to 31.26 J", "net loss = 19.2"]),
        (_LOSS, ["Ei = 54.5", "Ef = 35.3"]),
        (_SHARE, ["lost 19.2", "as a fraction of 54.5: 0.352"]),
        (f"{_SHARE} as a percentage", ["19.2/54.5 × 100 = 35.2"]),
    ],
)
def test_energies_and_shares_by_other_labels(statement: str, lines: list[str]) -> None:
    assert set(verdicts(statement, *lines)) == {"true"}


def test_an_energy_in_joules_may_be_wrong() -> None:
    assert verdicts(_LOSS, "A: 29 J to 5.04 J") == ["false"]
    assert verdicts(f"{_SHARE} as a percentage", "19.2/54.5 × 100 = 36.2") == ["false"]


def test_a_way_in_metres_is_no_component() -> None:
    statement = (
        "wall W: along i, through (0, 5)\nsphere P: at (0, 0), velocity 2i + 2j\n"
        "P hits W: e = 1/2\nfind position(P, 1)"
    )
    lines = ["5 ÷ 2 = 2.5 s", "horizontal: 2 m/s × 2.5 s = 5 m", "(5, 5)"]
    assert "false" not in verdicts(statement, *lines)


def test_the_share_that_one_sphere_gains() -> None:
    of_one = _LOSS.replace("energy_lost", "energy(B) - energy(B, 0)")
    assert verdicts(of_one, "fraction gained = 5.76/25.5 = 0.226") == ["true"]
    assert verdicts(of_one, "fraction of KE gained by B = 0.226") == ["true"]
    assert verdicts(_LOSS, "fraction lost by A = 24.96/29 = 0.861") == ["true"]


def test_a_number_behind_a_sphere_may_be_its_energy() -> None:
    assert "false" not in verdicts(_LOSS, "A: 29 → 4.04", "B: 25.5 → 31.26")
    assert verdicts(_LOSS, "A: 30") == ["false"]
    of_speed = _LOSS.replace("energy_lost", "speed(A)")
    assert verdicts(of_speed, "A: 29") == ["false"]


_COEFFICIENT = (
    "sphere A: mass 2, velocity 3i + 3j\nsphere B: mass 1, velocity -3i + 3j\n"
    "A hits B: along i\ngiven energy_lost = 9\nfind e"
)
_ABOVE = ["3 = 2v + w", "w - v = 6e", "9 = 12(1 - e^2)"]


@pytest.mark.parametrize(
    ("statement", "lines", "lost"),
    [
        (_LOSS, ["KE lost = 19.2 or 20"], True),
        (_LOSS, ["KE lost = 19.2 or 96/5"], False),
        (_LOSS, ["KE lost = 19.2 or 20", "KE lost = 19.2"], False),
        (_COEFFICIENT, [*_ABOVE, "e = 1/2 or -1/2"], True),
        (_COEFFICIENT, [*_ABOVE, "e = ±1/2"], True),
        (_COEFFICIENT, [*_ABOVE, "e = ±1/2", "e = 1/2"], False),
        (_COEFFICIENT, [*_ABOVE, "e = ±1/2", "e > 0"], False),
        (_COEFFICIENT, [*_ABOVE, "e = 1/2 or e = -1/2 (reject)"], False),
    ],
)
def test_an_answer_beside_a_value_that_is_none(
    statement: str, lines: list[str], lost: bool
) -> None:
    assert set(verdicts(statement, *lines)) == {"true"}
    marks = restitution.mark(restitution.parse(statement), lines).json()["marks"]
    assert (marks["points"][-1]["state"] == "lost") == lost


def test_an_answer_alone_beside_a_value_that_is_none() -> None:
    problem = restitution.parse(_LOSS)
    answers = ["19.2", "19.2 or 20", "19.2 or 96/5"]
    marks = mark_answers(problem, answers)
    assert [mark.right for mark in marks] == [True, False, True]
    assert marks[1].as_if == ()


_ALONG_J = (
    "sphere A: mass 2, velocity 3i + 4j\nsphere B: mass 1, velocity i - 2j\n"
    "A hits B: along j, e = 1/2\nfind energy_lost/energy(0) as a percentage"
)
_ALONG_I = (
    "sphere A: mass 3, velocity 4i + j\nsphere B: mass 1, velocity 2j\n"
    "A hits B: along i, e = 1/3\nfind energy_lost"
)


@pytest.mark.parametrize(
    ("statement", "lines", "expected"),
    [
        (
            _ALONG_J,
            ["along j: before 16 + 2 = 18", "along j: after 1 + 8 = 9", "loss = 9"],
            "true true true",
        ),
        (
            _ALONG_I,
            ["i direction: before = 24 + 0 = 24", "in i, after = 32/3 + 8 = 18.67", "lost 5.33"],
            "true true true",
        ),
        (
            _ALONG_J,
            ["along j: before 16 + 2 = 18", "along j: after 1 + 7 = 8", "loss = 10"],
            "true false follows",
        ),
        (
            _ALONG_J,
            ["along j: before 8 + -2 = 6", "along j: after 2 + 4 = 6", "loss = 9"],
            "true true true",
        ),
    ],
)
def test_sums_before_and_after_of_one_direction_are_energies(
    statement: str, lines: list[str], expected: str
) -> None:
    """They are where something is lost; momentum of one direction stays."""
    assert verdicts(statement, *lines) == expected.split()


_GAIN = (
    "sphere A: mass 2, velocity 4i + 2j\nsphere B: mass 1, velocity -2i + 3j\n"
    "A hits B: along i, e = 1/2\nfind energy_lost"
)


def test_an_energy_increases_and_decreases() -> None:
    right = ["decrease in KE of A = 15", "increase in KE of B = 6", "B's KE increases by 6"]
    assert verdicts(_GAIN, *right, "KE of A falls by 20 - 5 = 15") == ["true"] * 4
    for line in ("increase in KE of B = 7", "KE of A increases by 15", "decrease in KE of A = 6"):
        assert verdicts(_GAIN, line) == ["false"]
    wall = "wall W: along j\nA hits B: along i, e = 1/2\nB hits W: e = 1/2\nfind total_energy_lost"
    twice = _GAIN.split("A hits")[0] + wall
    lines = ["KE of B increases by 6", "B's KE decreases by 8 - 2 = 6", "decrease in KE of B = 7"]
    assert verdicts(twice, *lines) == ["true", "true", "false"]


def test_a_wrong_gain_is_no_loss() -> None:
    """What is lost in all does not follow from their sum."""
    gain = "KE gained by B = 9 - 6.5 = 2.5"
    assert verdicts(_GAIN, gain, "total KE lost = 15 + 2.5 = 17.5") == ["false", "false"]
    assert verdicts(_GAIN, gain, "total KE lost = 15 - 2.5 = 12.5") == ["false", "follows"]
    turned = "KE lost by A = 5 - 21 = -16"
    assert verdicts(_GAIN, turned, "KE lost = 16 - 6 = 10") == ["false", "follows"]


def test_a_gain_in_all_impacts_is_one_where_the_loss_in_all_is_asked() -> None:
    """B has 6.5 at first, 12.5 behind A and 9 behind the wall."""
    twice = _GAIN.replace("3j\n", "3j\nwall W: along j\n").replace("find energy_lost", "")
    twice += "B hits W: e = 3/4\nfind total_energy_lost"
    lines = ["B gains 9 - 6.5 = 2.5", "B gains 12.5 - 6.5 = 6", "B loses 12.5 - 9 = 3.5"]
    assert verdicts(twice, *lines) == ["true", "true", "true"]
    assert verdicts(twice, "KE gained by B = 4.5") == ["false"]


def test_an_energy_with_a_component_missing_spoils_the_loss() -> None:
    """That before or after may be right: the difference is not."""
    lines = ["KE before = 20 + 6.5 = 26.5", "KE after = ½ × 2 × 1² + ½ × 4² = 9", "loss = 17.5"]
    right = ["KE before = 26.5", "KE after = 5 + 12.5 = 17.5", "loss = 9"]
    problem = restitution.parse(_GAIN)
    for script, earned in ((lines, 0), (right, 1)):
        marks = restitution.mark(problem, "\n".join(script)).json()["marks"]
        methods = [x for x in marks["points"] if x["kind"][-2:] == "M1" and "energy" in x["for"]]
        assert [x["state"] for x in methods] == ["earned" if earned else "lost"]


def test_a_fraction_of_the_wrong_energy_and_a_wrong_sum_keep_the_method() -> None:
    """Only an energy that is not whole spoils the loss."""
    share = _GAIN.replace("find energy_lost", "find energy_lost/energy(0)")
    lines = ["along i: before 16 + 2 = 18", "along i: after 1 + 8 = 9", "loss = 9"]
    twice = _GAIN.replace("3j\n", "3j\nwall W: along j\n").replace("find energy_lost", "")
    twice += "B hits W: e = 3/4\nfind total_energy_lost"
    wrong_sum = ["B gains 9 - 6.5 = 2.5", "total KE lost = 15 + 2.5 = 17.5"]
    for statement, script in ((share, [*lines, "fraction = 9/18"]), (twice, wrong_sum)):
        marks = restitution.mark(restitution.parse(statement), "\n".join(script)).json()["marks"]
        methods = [x for x in marks["points"] if x["kind"][-2:] == "M1" and "energy" in x["for"]]
        assert [x["state"] for x in methods] == ["earned"]
