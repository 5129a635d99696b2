"""Planned workings of questions that are made up: they are followed, and say what is true."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

import pytest
import strategies
from hypothesis import HealthCheck, Phase, given, seed, settings
from laws_of_workings import answers, complaints, false_lines, storing
from plain_physics import World
from strategies import Question

from restitution.language import parse
from restitution.planning.planner import plan
from restitution.planning.writing.desk import NotPlannedError
from restitution.solving import solve

FEW, MANY, NIGHTLY = 10, 25, 2000
REFUSED = 0.05
"""The share of workings that the follower may refuse; it is to be lowered as plans get better."""


def drawn(count: int, number: int) -> list[Question]:
    """So many questions, always the same for one number; those that come twice stand once."""
    found: dict[str, Question] = {}

    @seed(number)
    @settings(
        max_examples=count,
        database=None,
        derandomize=False,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(strategies.questions())
    def collect(question: Question) -> None:
        found.setdefault(question.statement, question)

    collect()
    return list(found.values())


def judged(question: Question) -> Iterator[tuple[str, str]]:
    """What is wrong with the working of a question, and of what kind that is."""
    problem = parse(question.statement)
    solution = solve(problem)
    try:
        derivation = plan(solution)
    except NotPlannedError:
        yield "not planned", ""
        return
    for wrong in answers(solution, derivation):
        yield "answer", wrong
    for wrong in storing(solution, derivation):
        yield "storing", wrong
    stories = [] if question.letters is None else [World(problem, question.letters)]
    for wrong in false_lines(derivation, stories):
        yield "false", wrong
    for wrong in complaints(solution, derivation):
        # What is given and serves nothing that is asked is the fault of the question.
        yield "unused" if wrong.startswith("fact not used") else "refused", wrong


def judge(questions: list[Question]) -> tuple[Counter[str], str]:
    """How many workings are wrong in each way, and their statements."""
    counts: Counter[str] = Counter()
    texts = []
    for question in questions:
        found = list(judged(question))
        counts.update({kind for kind, _ in found} or {"right"})
        wrong = [f"{k}: {what}" for k, what in found if k not in ("not planned", "unused")]
        if wrong:
            texts.append("\n".join([question.statement, *wrong]))
    return counts, "\n\n".join(texts)


@pytest.mark.parametrize(
    ("count", "number"),
    [
        (FEW, 1),
        pytest.param(MANY, 1, marks=pytest.mark.nightly),
        pytest.param(
            NIGHTLY, 2, marks=[pytest.mark.nightly, pytest.mark.timeout(7200)], id="nightly"
        ),
    ],
)
@pytest.mark.timeout(300)
def test_questions_that_are_made_up_have_workings_that_are_right(count: int, number: int) -> None:
    counts, texts = judge(drawn(count, number))
    assert not counts["false"] and not counts["answer"] and not counts["storing"], texts
    planned = counts.total() - counts["not planned"]
    assert planned >= 0.4 * counts.total()
    assert counts["refused"] <= REFUSED * planned, texts


def test_questions_are_of_every_kind() -> None:
    questions = drawn(100, 1)
    asked = {kind for each in questions for kind in each.asked}
    assert {"e", "speed", "velocity", "impulse", "deflection", "show"} <= asked
    assert {each.forgotten for each in questions} >= {None, "e", "angle", "ratio", "speed"}
    assert {each.given for each in questions} >= {None, "bound", "condition"}
    assert sum(each.letters is not None for each in questions) >= 0.5 * len(questions)
