"""What costs work while a working is planned is done once, and its result kept."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from fractions import Fraction
from operator import is_
from typing import Any

import pytest

from restitution import examples
from restitution.explaining.awarding.awards import awarded
from restitution.explaining.data.facts import facts_of
from restitution.explaining.lines.derivation import Meaning
from restitution.expression.tree import Binary, Name, Number, Quantity
from restitution.language import parse
from restitution.planning import planner
from restitution.planning.writing import checking
from restitution.planning.writing.gathering import numbered_anew
from restitution.planning.writing.scene import Scene
from restitution.solving import solve

CORNER = examples.text("corner")


def test_the_facts_of_a_problem_are_made_once() -> None:
    assert facts_of(parse(CORNER)) is facts_of(parse(CORNER))


def test_lines_are_tried_by_one_reading_of_the_sample(monkeypatch: pytest.MonkeyPatch) -> None:
    """As long as letters mean the same, what sides are worth there is kept."""
    made: Counter[object] = Counter()
    kept = []  # no two models may have the same place in memory
    make = checking.evaluator

    def counted(model: Any, lines: Any, facts: Any) -> Any:
        meanings = frozenset(line.relation for line in lines if isinstance(line.relation, Meaning))
        kept.append(model)
        made[id(model), meanings] += 1
        return make(model, lines, facts)

    monkeypatch.setattr(checking, "evaluator", counted)
    planner.plan(solve(parse(CORNER)))
    assert made
    assert set(made.values()) == {1}


def test_what_a_tree_is_worth_in_letters_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    scenes: list[Scene] = []

    def seen(*values: Any, **named: Any) -> Scene:
        scenes.append(Scene(*values, **named))
        return scenes[-1]

    monkeypatch.setattr(planner, "Scene", seen)
    planner.plan(solve(parse(CORNER)))
    twice = Binary("*", Number(Fraction(2)), Quantity("velocity", (Name("P"),), 2))
    (scene,) = scenes
    assert scene.vector(twice) is scene.vector(twice)


def test_lines_that_stay_what_they_are_are_not_made_anew() -> None:
    derivation = planner.plan(solve(parse(CORNER)))
    first = list(derivation.lines[:-1])
    shorter = numbered_anew(replace(derivation, items=(), notes=(), cases=()), first)
    assert all(map(is_, shorter.lines, first))
    marked = awarded(derivation)
    assert all(map(is_, awarded(marked).lines, marked.lines))
