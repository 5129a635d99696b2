"""Workings by hand: the follower finds nothing to complain of, and refuses what is spoiled."""

from __future__ import annotations

import random
from functools import cache
from pathlib import Path

import pytest
from answers import _differs
from corruptions import corruptions
from derivations import FOLDER, oracle_of, read_derivation

from restitution.explaining.derivation import Derivation, ItemEnd, Link, Relation
from restitution.explaining.follower import follow
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression
from restitution.expression.writing import write_expression
from restitution.problem import Problem, Range
from restitution.solve import ItemResult, solve

FILES = sorted(FOLDER.glob("*.txt"))
SAMPLE = 12

# Where what remains is itself one move, or says the same: kind, file and line.
ONE_MOVE: dict[str, dict[str, tuple[int, ...]]] = {}


def test_there_are_workings_of_every_topic() -> None:
    assert len(FILES) >= 36


@cache
def working(path: Path) -> tuple[Problem, Derivation]:
    return read_derivation(path)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_working_by_hand_is_followed(path: Path) -> None:
    problem, derivation = working(path)
    assert [str(each) for each in follow(derivation, oracle_of(problem))] == []


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_working_reaches_the_answers_of_the_solver(path: Path) -> None:
    problem, derivation = working(path)
    items = list(solve(problem).items())
    names = list(dict.fromkeys(each.item for each in derivation.items))
    assert len(names) == len(items), "a working answers every item, in order"
    for name, (part, item) in zip(names, items, strict=True):
        ends = [each for each in derivation.items if each.item == name]
        assert item.error is None, item.error
        assert _disagrees(item, ends, dict(part.roles)) is None, (name, item.text)


def _disagrees(item: ItemResult, ends: list[ItemEnd], roles: dict[str, object]) -> str | None:
    assert all(end.shown == (item.kind == "show") for end in ends)
    if item.kind == "show":
        return _differs(item, "true", roles)  # type: ignore[arg-type]
    links = [links for end in ends for links in end.answer.options]
    if item.kind == "range":
        assert isinstance(item.item, Range)
        text = " or ".join(_interval(each, item.item.expression) for each in links)
        return _differs(item, text, roles)  # type: ignore[arg-type]
    if any(each[-1].sign == "≈" for each in links):
        return _rounds_to(item, [each[-1].right for each in links])
    text = " ; ".join(write_expression(each[-1].right) for each in links)
    return _differs(item, text, roles)  # type: ignore[arg-type]


def _interval(links: tuple[Link, ...], subject: Expression) -> str:
    sides = [links[0].left, *(each.right for each in links)]
    texts = ["X" if each == subject else write_expression(each) for each in sides]
    return texts[0] + "".join(
        f" {link.sign} {text}" for link, text in zip(links, texts[1:], strict=True)
    )


def _rounds_to(item: ItemResult, decimals: list[Expression]) -> str | None:
    got = sorted(float(each.value) for each in item.answers)
    printed = sorted(float(evaluate(each, lambda name: None)) for each in decimals)
    close = all(abs(a - b) <= 1e-3 * abs(a) for a, b in zip(got, printed, strict=True))
    return None if close else f"got {got}"


def spoiled_line(derivation: Derivation, spoiled: Derivation) -> int:
    """The number of the line that was changed, moved or left out; 0 for none."""
    for a, b in zip(derivation.lines, (*spoiled.lines, None), strict=False):
        if a != b:
            return a.number
    return 0


@pytest.mark.nightly
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_spoiled_working_is_refused(path: Path) -> None:
    problem, derivation = working(path)
    every = [(kind, each) for kind, each in corruptions(derivation) if each != derivation]
    chosen = random.Random(path.stem).sample(every, min(SAMPLE, len(every)))
    through = [
        (kind, spoiled_line(derivation, spoiled))
        for kind, spoiled in chosen
        if not follow(spoiled, oracle_of(problem))
    ]
    faults = [
        (kind, line)
        for kind, line in through
        if line not in ONE_MOVE.get(kind, {}).get(path.stem, ())
    ]
    assert faults == []


def test_the_links_of_a_relation_without_alternatives() -> None:
    with pytest.raises(ValueError):
        _ = Relation(((), ())).only
