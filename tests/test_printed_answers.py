"""Ranges, and conditions of values, against impacts worked in numbers at many points."""

from __future__ import annotations

import random

import pytest
from drawn_questions import SHAPES, drawn_question
from printed_answers import REFUSALS, disagreements, possibilities
from workings import solved

from restitution.errors import RestitutionError

LONG = {9, 15, 19}
"""Seeds of questions that take seconds: the nightly run has them."""

NORMAL = [seed for seed in range(16) if seed not in LONG]


def wrong(seed: int, count: int) -> list[str]:
    """Where what is printed for a question is not what is true."""
    question = drawn_question(seed)
    try:
        solution = solved(question.statement)
    except RestitutionError as error:
        return [f"{question.shape}: {error!r}"]
    ((_, item),) = solution.items()
    rng = random.Random(seed)
    if item.error is not None:
        if item.error.kind not in REFUSALS:
            return []
        return [f"{doubt}: {item.error}" for doubt in possibilities(question, rng, count)]
    if any("not proved" in warning or "not decided" in warning for warning in solution.warnings):
        return []  # that is said
    return [*disagreements(question, item, rng, count)]


@pytest.mark.parametrize("seed", NORMAL)
def test_what_is_printed_is_true(seed: int) -> None:
    assert not wrong(seed, 6)


@pytest.mark.nightly
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("n", range(len(SHAPES)))
def test_what_is_printed_is_true_of_many(n: int) -> None:
    seeds = range(n, 40 * len(SHAPES), len(SHAPES))
    doubts = [doubt for seed in seeds for doubt in wrong(seed, 12)]
    assert not doubts, "\n".join(doubts)


CORNER = """wall W: along i
wall V: along j
sphere P: mass m, velocity u at alpha to W
P hits W: e = e
P hits V: e = f
given energy(P) > 2/5 energy(P, 0)
find range of f
"""
STRUCK = """sphere A: mass {mass}, velocity u at alpha
sphere B: mass {other}, {motion}
A hits B: along i
given {fact}
find {asked}
"""


def printed(**words: str) -> list[str]:
    text = STRUCK.format(**{"mass": "2m", "other": "k m", "motion": "at rest"} | words)
    ((_, item),) = solved(text).items()
    return [answer.display for answer in item.answers]


def test_an_end_that_is_a_root_has_its_condition_and_the_other_form_is_told() -> None:
    ((_, item),) = solved(CORNER).items()
    assert [answer.display for answer in item.answers] == [
        "√((2 − 5e² sin²α)/5)/cos α < f ≤ 1, for 5e² sin²α ≤ 2 and 5 cos α > √(5(2 − 5e² sin²α))",
        "0 ≤ f ≤ 1, for 5e² sin²α > 2",
    ]
    assert printed(fact="speed(A) >= 3/4 u", asked="range of alpha") == [
        "0° < α < 90°, for (14 + (3 − 4e)k)(2 − (3 + 4e)k) ≥ 0",
        (
            "arctan(√((14 + (3 − 4e)k)((3 + 4e)k − 2)/7)/(2 + k)) ≤ α < 90°, "
            "for (14 + (3 − 4e)k)((3 + 4e)k − 2) > 0"
        ),
    ]


def test_what_decides_for_all_values_of_a_letter_is_a_condition() -> None:
    fact = "tan(angle(velocity(A), i)) < 3 tan(alpha)"
    assert printed(other="2m", fact=fact, asked="range of alpha") == ["0° < α < 90°, for e < ⅓"]
    assert printed(fact="impulse < 1/2 m u", asked="range of alpha") == [
        "0° < α < 90°, for k ≤ 2/(3 + 4e)",
        "arctan(√((2 + (5 + 4e)k)((3 + 4e)k − 2))/(2 + k)) < α < 90°, for k > 2/(3 + 4e)",
    ]


def test_where_ends_meet_a_range_has_another_form() -> None:
    assert printed(mass="m", fact="angle(velocity(A), i) >= 30°", asked="range of e") == [
        "0 ≤ e ≤ 1, for √3(1 + k) sin α ≥ cos α",
        (
            "(1 − √3(1 + k) tan α)/k ≤ e ≤ 1, "
            "for cos α > √3(1 + k) sin α and k − 1 + √3(1 + k) tan α ≥ 0"
        ),
    ]


def test_a_root_has_its_condition_where_that_follows_from_nothing_else_that_is_printed() -> None:
    motion = "velocity 4u at 180° - beta"
    for display in printed(mass="m", motion=motion, fact="speed(A) = 2/3 u", asked="k"):
        assert ", for 3 sin α ≤ 2 and " in display
