"""The timeline of a problem: which steps concern a part, and after how many events."""

from __future__ import annotations

import pickle
from dataclasses import replace

import pytest

from restitution import solve
from restitution.language import parse
from restitution.problem import Find, Given, Impact, Let, Part, Show

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


NAMES = """
wall W: along i
sphere P: velocity u at alpha to W
part a
P hits W: e = 1/2
let beta = angle(velocity(P), W)
let gamma = 2 beta
find tan(beta)
part b
wall V: along j
P hits V: e = 1/3
{own}
find {asked}
"""


@pytest.mark.parametrize(
    ("own", "asked", "expected"),
    [
        ("", "tan(beta)", [("beta", 1)]),
        ("", "tan(gamma)", [("beta", 1), ("gamma", 1)]),
        ("", "speed(P)", []),
        ("given alpha + beta = 90°", "tan(alpha)", [("beta", 1)]),
        ("let beta = angle(velocity(P), V)", "tan(beta)", [("beta", 2)]),
        ("unknown beta", "speed(P)", []),
    ],
)
def test_a_name_of_an_earlier_part_goes_on_where_it_is_used(
    own: str, asked: str, expected: list[tuple[str, int]]
) -> None:
    problem = parse(NAMES.format(own=own, asked=asked))
    lets = [(s.letter, n) for s, n, _ in problem.timeline(problem.parts[-1]) if isinstance(s, Let)]
    assert lets == expected


def test_a_name_of_an_earlier_part_means_the_quantity_as_it_was() -> None:
    # tan β = ½ tan α at the first wall, so that α + β = 90° where tan²α = 2.
    problem = parse(NAMES.format(own="given alpha + beta = 90°", asked="tan(alpha)"))
    (answer,) = solve(problem).parts["b"].items
    assert [each.exact for each in answer.answers] == ["sqrt(2)"]


def test_a_problem_goes_to_another_process_without_its_hash() -> None:
    # The hash of a text is another one in each process.
    problem = parse("sphere P: velocity (3, 4)\nwall W: along i\nP hits W: e = 1/2\nfind speed(P)")
    assert hash(problem) == hash(replace(problem))
    sent = pickle.loads(pickle.dumps(problem))
    assert "_hash" in vars(problem) and "_hash" not in vars(sent)
    assert sent == problem and hash(sent) == hash(problem)
