"""Planned workings of all examples and questions: what has a plan, and laws of what is planned."""

from __future__ import annotations

import random
from functools import cache

import pytest
from laws_of_printing import PRINTED
from laws_of_steps import STEPS
from laws_of_workings import LAWS as MADE
from laws_of_workings import answers, complaints, false_lines, storing
from numbers_of_workings import BeyondError, worlds
from planned import LIST, listed, planned, statements

from restitution.errors import StatementError
from restitution.explaining.lines.derivation import Derivation
from restitution.planning.routes import choice
from restitution.planning.writing.desk import UNPLANNED
from restitution.solving import Solution

STATEMENTS = statements()
LISTED = listed()
ACCEPTED = sorted(name for name, good in LISTED.items() if good)
SAMPLE = sorted(random.Random(5).sample(ACCEPTED, min(6, len(ACCEPTED))))
"""What the normal run looks at; all the others are for ``nightly``."""


@cache
def working(name: str) -> tuple[Solution, Derivation]:
    """The solution of a statement that has a plan, and its working."""
    made = planned(STATEMENTS[name])
    assert made is not None, f"{name} has lost its plan"
    return made


LAWS = {**MADE, **PRINTED, **STEPS}
# Workings that do not keep a law yet; the list is to become shorter.
NOT_YET = {
    # A quantity is used in words before its letter comes.
    "letters come first": {
        "047-wall-show-false",
        "236-distance-apart-t",
        "423-half-angle",
    },
    # The values are too long in the letters that are asked.
    "brackets stay on a line": {
        "241-impulse-in-terms",
        "517-greek-subscripts",
        "559-STEP-lowest-energy-after-over-e",
        "616-three-decimals-show",
    },
    "vectors stay vectors": {"286-triangular-table"},
    "numbers are plain": {"243-abs-dot", "308-mirrored-unequal-speeds"},
}


def some(names: list[str]) -> list[object]:
    """All of these, those that are not in the sample under ``nightly``."""
    return [
        pytest.param(each, marks=() if each in SAMPLE else pytest.mark.nightly) for each in names
    ]


def test_the_list_names_statements() -> None:
    assert LISTED.keys() <= STATEMENTS.keys()
    assert len(ACCEPTED) >= 50


@pytest.mark.parametrize("name", some(ACCEPTED))
def test_a_planned_working_is_followed(name: str) -> None:
    assert complaints(*working(name)) == []


@pytest.mark.parametrize("name", some(sorted(LISTED)))
def test_a_plan_is_kept(name: str) -> None:
    working(name)


@pytest.mark.nightly
@pytest.mark.timeout(3600)
def test_the_list_is_whole() -> None:
    gained = [name for name, path in STATEMENTS.items() if name not in LISTED and planned(path)]
    if gained:
        pytest.fail(
            f"{len(gained)} statements have a plan and are not in {LIST.name}:"
            f" {', '.join(gained)}; write it anew with scripts/planned.py --write"
        )


@pytest.mark.parametrize("name", some(ACCEPTED))
def test_a_planned_working_reaches_the_answers_of_the_solver(name: str) -> None:
    assert answers(*working(name)) == []


@pytest.mark.parametrize("name", some(ACCEPTED))
def test_a_planned_working_is_read_back(name: str) -> None:
    assert storing(*working(name)) == []


@pytest.mark.parametrize("name", some(ACCEPTED))
def test_planned_lines_are_true_in_numbers(name: str) -> None:
    solution, derivation = working(name)
    for part in dict.fromkeys(end.part for end in derivation.items):
        try:
            stories = list(worlds(solution.problem, part, 7, 1))
        except BeyondError:
            continue
        own = {end.item for end in derivation.items if end.part in (None, part)}
        assert false_lines(derivation, stories, own) == []


@pytest.mark.parametrize("name", some(ACCEPTED))
def test_a_planned_working_keeps_all_laws_but_those_listed(name: str) -> None:
    broken = {law: wrong for law in LAWS if (wrong := LAWS[law](*working(name)))}
    assert broken.keys() == {law for law in NOT_YET if name in NOT_YET[law]}, broken


def test_what_is_listed_is_a_law() -> None:
    assert NOT_YET.keys() <= LAWS.keys()


@pytest.mark.parametrize("name", some(ACCEPTED))
def test_the_cheapest_way_is_taken(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The next best ways cost no less."""
    cheapest = choice.Routes.cheapest
    costs: list[list[float]] = []

    def watched(self: choice.Routes, *args: object, **kwargs: object) -> object:
        found = cheapest(self, *args, **kwargs)  # type: ignore[arg-type]
        costs.append([sum(each.cost for each in way) for way in found])
        return found

    monkeypatch.setattr(choice.Routes, "cheapest", watched)
    assert planned(STATEMENTS[name]) is not None
    assert all(each == sorted(each) for each in costs), costs


def test_what_has_no_value_has_no_plan() -> None:
    """A divisor that comes to zero in a line broke off the whole working."""
    assert issubclass(StatementError, UNPLANNED)
