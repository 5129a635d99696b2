"""Lines as data for the tests of practice, from text of the statement language."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache

import restitution as r
from restitution.explaining.lines.trees import rebuilt
from restitution.expression import read_expression
from restitution.expression.tree import Expression
from restitution.practice.script import Claim, Decimal, InScript
from restitution.practice.worlds.sampling import true_worlds
from restitution.practice.worlds.world import World
from restitution.solving.equations.solution import Solution

_SIGN = re.compile(r"<=|>=|=|<|>")
_DECIMAL = re.compile(r"(?<![\w.])\d+\.\d+")
NAMES = ("A", "B", "C", "P", "Q", "W", "V")


@lru_cache(maxsize=16)
def solved(text: str) -> Solution:
    return r.solve(r.parse(text))


def world_of(text: str, part: str | None = None) -> World:
    """The only true world of a part of a statement."""
    (world,) = true_worlds(solved(text), part)
    return world


def read(text: str, column: int = 0) -> Expression:
    return read_expression(" " * column + text, names=set(NAMES))


def in_script(tree: Expression) -> Expression:
    """A tree whose parts stand in a script, as those that a student typed do."""

    def placed(node: Expression) -> Expression:
        place = node.place
        return node if place is None else replace(node, place=InScript(place.line, place.column))

    return rebuilt(tree, placed)


def claim(text: str) -> tuple[Claim, tuple[Decimal, ...]]:
    """``left = right`` with its decimals, columns counted in the text."""
    sign = _SIGN.search(text)
    assert sign is not None, text
    left = in_script(read(text[: sign.start()]))
    right = in_script(read(text[sign.end() :], sign.end()))
    found = (
        Decimal(
            match.start() + 1,
            Fraction(match[0]),
            len(match[0].replace(".", "").lstrip("0")),
            Fraction(1, 2 * 10 ** len(match[0].split(".")[1])),
        )
        for match in _DECIMAL.finditer(text)
    )
    return Claim(left, sign[0], right), tuple(found)  # type: ignore[arg-type]


def meanings(table: Mapping[str, str]) -> dict[str, Expression]:
    return {letter: read(text) for letter, text in table.items()}


def claims(texts: Iterable[str]) -> list[Claim]:
    return [claim(text)[0] for text in texts]
