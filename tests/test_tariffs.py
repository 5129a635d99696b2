"""Totals by rule against published tariffs."""

from __future__ import annotations

import pytest
from derivations import oracle_of
from tariffs import Tariff, by_rule, near, off_by, read_tariffs

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation
from restitution.language.reading import parse
from restitution.planning.planner import plan
from restitution.planning.writing.desk import NotPlannedError
from restitution.solving import solve

TARIFFS = read_tariffs()
WITH_WORKING = tuple(each for each in TARIFFS if each.working is not None)


def named(tariffs: tuple[Tariff, ...]) -> list[object]:
    return [pytest.param(each, id=each.name) for each in tariffs]


def test_the_file_has_thirty_tariffs() -> None:
    assert len(TARIFFS) >= 30 and len({each.name for each in TARIFFS}) == len(TARIFFS)
    assert len(WITH_WORKING) >= 10
    for each in TARIFFS:
        assert each.source
        assert len(each.marks) == len(each.moves), each.name


@pytest.mark.parametrize("tariff", named(TARIFFS))
def test_a_statement_is_answered(tariff: Tariff) -> None:
    problem = parse(tariff.statement)
    solution = solve(problem)
    assert solution.error is None
    asked = [(part.part.label, item) for part, item in solution.items()]
    assert {label for label, _ in asked} == set(tariff.marks)
    for _, item in asked:
        assert item.error is None and (item.answers or item.holds), item.text


@pytest.mark.parametrize("tariff", named(WITH_WORKING))
def test_a_working_has_the_marks_of_the_tariff(tariff: Tariff) -> None:
    assert tariff.working is not None
    assert abs(off_by(tariff, tariff.working)) <= 2
    marks = by_rule(tariff.working, tariff.style)
    if set(marks) == set(tariff.marks):
        assert all(abs(marks[part] - tariff.marks[part]) <= 1 for part in marks)


@pytest.mark.parametrize("tariff", named(tuple(each for each in WITH_WORKING if each.own)))
def test_a_working_is_followed(tariff: Tariff) -> None:
    assert tariff.working is not None
    oracle = oracle_of(parse(tariff.statement))
    assert [str(each) for each in follow(tariff.working, oracle)] == []


def planned(tariff: Tariff) -> Derivation | None:
    """The working that is planned for a question."""
    try:
        return plan(solve(parse(tariff.statement)))
    except NotPlannedError:
        return None


def test_planned_workings_have_the_marks_of_four_tariffs_of_five() -> None:
    found = near(TARIFFS, planned)
    assert sum(each is True for each in found.values()) >= 0.8 * len(TARIFFS), found
