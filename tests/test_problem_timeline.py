"""The timeline of a problem: which steps concern a part, and after how many events."""

from __future__ import annotations

import pytest

from restitution.language import parse
from restitution.problem import Find, Given, Impact, Part, Show

STATEMENT = """
wall W: along i
sphere P: mass m, velocity 3i - 4j
let k = 2 m
find velocity(P)
P hits W: e = 1/2
part a
given speed(P) > 3
find speed(P)
P receives j
find impulse
part b
given m = 2
show speed(P) > 3
"""


def of(label: str | None) -> tuple[list[tuple[str, int]], Part]:
    problem = parse(STATEMENT)
    (part,) = (each for each in problem.parts if each.label == label)
    return [(type(s).__name__, n) for s, n, _ in problem.timeline(part)], part


def test_a_part_has_the_events_up_to_it_the_facts_in_force_and_its_own_questions() -> None:
    assert of(None)[0] == [("Let", 0), ("Find", 0), ("Impact", 1)]
    assert of("a")[0] == [
        ("Let", 0),
        ("Impact", 1),
        ("Given", 1),
        ("Find", 1),
        ("Kick", 2),
        ("Find", 2),
    ]
    assert of("b")[0] == [("Let", 0), ("Impact", 1), ("Kick", 2), ("Given", 2), ("Show", 2)]


def test_the_whole_story_has_every_step_with_its_part() -> None:
    problem = parse(STATEMENT)
    whole = list(problem.timeline())
    assert [(step, part) for step, _, part in whole] == [
        (step, part) for part, step in problem.steps()
    ]
    assert [events for _, events, _ in whole] == [0, 0, 1, 1, 1, 2, 2, 2, 2]
    assert len(problem.events) == 2
    assert isinstance(problem.events[0], Impact)


def test_what_is_asked_has_the_number_of_events_before_it() -> None:
    problem = parse(STATEMENT)
    _, part = of("a")
    assert [events for _, events in problem.asked(part)] == [1, 2]
    _, part = of("b")
    ((item, events),) = problem.asked(part)
    assert isinstance(item, Show)
    assert events == 2


def test_a_part_of_another_problem_is_refused() -> None:
    problem = parse(STATEMENT)
    with pytest.raises(ValueError, match="not in"):
        list(problem.timeline(Part("c", (Find(()), Given(())))))
