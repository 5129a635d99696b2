"""What is false in numbers is never followed, however a line by hand is changed."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
from derivations import FOLDER, oracle_of, read_derivation
from numbers_of_workings import BeyondError, Judge, worlds
from plain_physics import ImpossibleWorldError

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Link, Meaning, Relation
from restitution.explaining.lines.notation import write_relation
from restitution.explaining.lines.trees import rebuilt, trees_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    walk,
)
from restitution.problem import Problem

FILES = sorted(FOLDER.glob("*.txt"))
TRIED = 25
_TWO = Number(Fraction(2))


@cache
def working(path: Path) -> tuple[Problem, Derivation]:
    return read_derivation(path)


@cache
def judges(path: Path, part: str | None) -> tuple[Judge, ...]:
    """Stories in which the facts of a part hold."""
    problem, derivation = working(path)
    try:
        return tuple(Judge(world, derivation) for world in worlds(problem, part, 7))
    except BeyondError:
        return ()


def judged(path: Path, line: Line) -> tuple[Judge, ...]:
    """The stories in which a line stands."""
    _, derivation = working(path)
    part = next((end.part for end in derivation.items if end.item == line.item), None)
    try:
        return tuple(each for each in judges(path, part) if each.applies(line))
    except (BeyondError, ImpossibleWorldError):
        return ()


def is_false(judge: Judge, relation: Relation) -> bool:
    """Whether a relation has a meaning in a story, and does not hold there."""
    try:
        return not judge.true(relation)
    except (BeyondError, ImpossibleWorldError, ZeroDivisionError):
        return False


def lines_of(path: Path) -> Iterator[tuple[Line, tuple[Judge, ...]]]:
    _, derivation = working(path)
    for line in derivation.lines:
        if not isinstance(line.relation, Meaning):
            yield line, judged(path, line)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_lines_by_hand_are_true_in_numbers(path: Path) -> None:
    for line, own in lines_of(path):
        assert isinstance(line.relation, Relation)
        for judge in own:
            assert not is_false(judge, line.relation), (line.number, write_relation(line.relation))


def test_most_workings_are_judged_in_numbers() -> None:
    told = [path.stem for path in FILES if any(own for _, own in lines_of(path))]
    assert len(told) >= 0.7 * len(FILES), sorted({path.stem for path in FILES} - set(told))


# --- false lines ----------------------------------------------------------------------------------


def changed(relation: Relation, others: list[Expression], chance: random.Random) -> Relation:
    """A relation with one to three things changed at random."""
    options = [list(links) for links in relation.options]
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        links = chance.choice(options)
        n = chance.randrange(len(links))
        links[n] = _changed_link(links[n], others, chance)
        if len(options) > 1 and chance.random() < 0.15:
            options.remove(chance.choice(options))
    return Relation(tuple(tuple(links) for links in options))


def _changed_link(link: Link, others: list[Expression], chance: random.Random) -> Link:
    kind = chance.random()
    if kind < 0.1:
        return replace(link, sign=chance.choice(("=", "<", "<=", ">", ">=", "!=")))
    if kind < 0.15:
        return replace(link, left=link.right, right=link.left)
    if kind < 0.25:  # the same done to one side only, or to both
        extra = chance.choice(others)
        op = chance.choice("+-*/")
        both = chance.random() < 0.3
        right = Binary(op, link.right, extra)  # type: ignore[arg-type]
        left = Binary(op, link.left, extra) if both else link.left  # type: ignore[arg-type]
        return replace(link, left=left, right=right)
    side = chance.choice(("left", "right"))
    tree = getattr(link, side)
    nodes = [each for each in walk(tree) if not isinstance(each, Quantity)] or [tree]
    old = chance.choice(nodes)
    new = _changed_node(old, others, chance)
    return replace(link, **{side: rebuilt(tree, lambda each: new if each == old else each)})


def _changed_node(node: Expression, others: list[Expression], chance: random.Random) -> Expression:
    match node:
        case Number(value) if chance.random() < 0.8:
            return Number(abs(chance.choice((value + 1, value - 1, 2 * value, value / 2))))
        case Binary("+" | "-" as op, left, right) if chance.random() < 0.6:
            other = "-" if op == "+" else "+"
            return chance.choice((Binary(other, left, right), left, right))
        case Binary("*" | "/", left, right) if chance.random() < 0.6:
            return chance.choice((left, right, Binary("/", right, left)))
        case Binary("^", left, _) if chance.random() < 0.5:
            return left
        case Apply(function, argument) if function in ("sin", "cos", "tan"):
            other_name = chance.choice(("sin", "cos", "tan"))
            return Apply(other_name, argument)  # type: ignore[arg-type]
        case Negate(operand):
            return operand
    wrapped = (Negate(node), Binary("*", _TWO, node), Binary("^", node, _TWO))
    return chance.choice((*wrapped, chance.choice(others)))


def _alone(derivation: Derivation, line: Line) -> Derivation:
    """A line with what it cites, and the letters."""
    cases = tuple(case for case in derivation.cases if line.number in case.lines)
    cited = set(line.premises) | {case.line for case in cases}
    above = tuple(
        each
        for each in derivation.lines
        if each.number < line.number
        and (each.number in cited or isinstance(each.relation, Meaning))
    )
    items = tuple(replace(end, case=None) for end in derivation.items)
    return replace(derivation, lines=(*above, line), items=items, cases=cases)


def is_followed(problem: Problem, derivation: Derivation, line: Line) -> bool:
    complaints = follow(_alone(derivation, line), oracle_of(problem))
    assert not any(each.reason in ("number-twice", "case-unknown") for each in complaints)
    return not any(
        each.line == line.number and each.reason not in ("leads-nowhere", "not-the-answer")
        for each in complaints
    )


def accepted_false_lines(path: Path, seed: int, tried: int) -> list[str]:
    """False lines, of so many that are tried, that the follower does not refuse."""
    problem, derivation = working(path)
    chance = random.Random(f"{path.stem} {seed}")
    own = [(line, judges_) for line, judges_ in lines_of(path) if judges_]
    if not own:
        return []
    trees = [t for line in derivation.lines for t in trees_of(line.relation)]
    others = [e for t in trees for e in walk(t) if isinstance(e, Letter | Number | Apply | Binary)]
    through = []
    for _ in range(tried):
        line, judges_ = chance.choice(own)
        assert isinstance(line.relation, Relation)
        new = changed(line.relation, others, chance)
        if not any(is_false(judge, new) for judge in judges_):
            continue
        if is_followed(problem, derivation, replace(line, relation=new)):
            through.append(f"{line.number} {line.move.id}: {write_relation(new)}")
    return through


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_line_that_is_false_in_numbers_is_refused(path: Path) -> None:
    assert accepted_false_lines(path, 1, TRIED) == []
