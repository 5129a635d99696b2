"""The answers of a statement: those that are written in it, and each by itself as all together."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from answers import disagreements, expected
from statements import FILES, law, solved

from restitution.exact import tidy
from restitution.problem import Find, Part, Problem, Show, Value
from restitution.solving import ItemResult, solve


@law(FILES)
def solves_to_the_written_answers(path: Path) -> None:
    wanted = expected(path.read_text(encoding="utf-8"))
    assert wanted, "a statement without answers proves nothing"
    assert disagreements(solved(path), wanted) == []


def bounding(part: Part) -> list[tuple[int, int]]:
    """Where a part has ranges, extrema and claims: step, and item in a ``find``."""
    found = []
    for n, step in enumerate(part.steps):
        if isinstance(step, Show):
            found.append((n, 0))
        elif isinstance(step, Find):
            found += [(n, k) for k, item in enumerate(step.items) if not isinstance(item, Value)]
    return found


def only(problem: Problem, part: Part, kept: tuple[int, int]) -> Problem:
    """The problem with one range, extremum or claim in a part, and all its plain values."""
    steps: list[Any] = []
    for n, step in enumerate(part.steps):
        if isinstance(step, Find):
            items = tuple(
                item
                for k, item in enumerate(step.items)
                if isinstance(item, Value) or (n, k) == kept
            )
            if items:
                steps.append(replace(step, items=items))
        elif not isinstance(step, Show) or (n, 0) == kept:
            steps.append(step)
    changed = replace(part, steps=tuple(steps))
    return replace(problem, parts=tuple(changed if p is part else p for p in problem.parts))


def outcome(item: ItemResult) -> object:
    if item.error is not None:
        return item.error.kind, item.error.message
    return item.holds, item.counterexample, [(a.exact, a.where, a.reached) for a in item.answers]


@law(FILES)
def each_alone_is_answered_as_all_together(path: Path) -> None:
    together = solved(path)
    problem = together.problem
    for part in problem.parts:
        places = bounding(part)
        if len(places) < 2:
            continue
        results = [each for each in together.parts[part.label].items if not is_value(each)]
        assert len(results) == len(places)
        for place, result in zip(places, results, strict=True):
            alone = solve(only(problem, part, place)).parts[part.label].items
            (single,) = [each for each in alone if not is_value(each)]
            assert single.text == result.text
            assert outcome(single) == outcome(result)


def is_value(item: ItemResult) -> bool:
    return isinstance(item.item, Value)


@law(FILES)
def are_in_textbook_form(path: Path) -> None:
    """Tidied once, an answer is not changed again."""
    for part in solved(path).parts.values():
        for answer in (answer for item in part.items for answer in item.answers):
            if not answer.angle:
                values = answer.value if isinstance(answer.value, tuple) else (answer.value,)
                assert [tidy(value) for value in values] == list(values)
