"""Relations and meanings as text, and back: what lines say, in the notation of statements.

A relation of a line may be a chain (``a = b = c``), several together (``a = 1 and b = 2``),
alternatives (``t = 1 or t = -1``), or rounded (``x ≈ 3.993``).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

from restitution.errors import StatementError
from restitution.explaining.lines.derivation import SIGNS, Link, Meaning, Relation, Sign
from restitution.expression.reading import read_expression
from restitution.expression.tree import Expression, Letter
from restitution.expression.writing import write_expression

_EITHER = re.compile(r"\s+or\s+")
_BOTH = re.compile(r"\s+and\s+")
_SIGN = re.compile("|".join(re.escape(sign) for sign in sorted(SIGNS, key=len, reverse=True)))
_BY = re.compile(r"\[([a-z-]+)\]\s*$")
_MEANING = re.compile(
    r"let\s+(?P<vector>vector\s+)?(?P<letter>\S+)\s*=\s*(?P<quantity>.+?)"
    r"(?:\s+in the sense of\s+(?P<sense>.+?))?(?:\s+as an? (?P<angle>acute|turn|signed) angle)?",
)

# Quantities of which lines speak, and statements do not.
_OF_LINES = {"restitution": "quantity"}


def read_tree(text: str, names: Mapping[str, str]) -> Expression:
    """An expression of a line. Raises StatementError for a text that is none.

    ``names`` maps each body and point to what it is (``"sphere"``, ``"wall"``, ``"point"``).
    """
    return _tree(text, frozenset(names.items()))


@lru_cache(maxsize=2048)
def _tree(text: str, names: frozenset[tuple[str, str]]) -> Expression:
    return read_expression(text.strip(), names={**dict(names), **_OF_LINES})


def read_relation(text: str, names: Mapping[str, str]) -> Relation:
    """The relation that a text says. Raises StatementError for a text that says none."""
    return _relation(text, frozenset(names.items()))


@lru_cache(maxsize=2048)
def _relation(text: str, own: frozenset[tuple[str, str]]) -> Relation:
    names = dict(own)
    return Relation(
        tuple(
            tuple(link for part in _BOTH.split(option) for link in _chain(part, names))
            for option in _EITHER.split(text.strip())
        )
    )


def _chain(text: str, names: Mapping[str, str]) -> list[Link]:
    signs: list[Sign] = [sign for value in _SIGN.findall(text) for sign in SIGNS if sign == value]
    if not signs:
        raise StatementError(f"'{text}' is no relation: it has none of {', '.join(SIGNS)}")
    sides, moves = [], []
    for side in _SIGN.split(text):
        by = _BY.search(side)
        moves.append(by.group(1) if by else None)
        sides.append(read_tree(_BY.sub("", side), names))
    return [
        Link(left, sign, right, by)  # type: ignore[arg-type]
        for left, sign, right, by in zip(sides, signs, sides[1:], moves[1:], strict=False)
    ]


def read_meaning(text: str, names: Mapping[str, str]) -> Meaning:
    """What ``let v = along(velocity(A, 1), i)`` introduces. Raises StatementError."""
    match = _MEANING.fullmatch(text.strip())
    if match is None:
        raise StatementError(f"'{text}' introduces no letter: it is written let v = …")
    letter = read_tree(match["letter"], names)
    if not isinstance(letter, Letter):
        raise StatementError(f"'{match['letter']}' is no letter")
    sense = match["sense"]
    return Meaning(
        letter.name,
        read_tree(match["quantity"], names),
        None if sense is None else read_tree(sense, names),
        match["vector"] is not None,
        match["angle"],  # type: ignore[arg-type]
    )


def write_relation(relation: Relation) -> str:
    """The text of a relation, which reads back as an equal one."""
    return " or ".join(_option(links) for links in relation.options)


def _option(links: tuple[Link, ...]) -> str:
    text = ""
    for before, link in zip((None, *links), links, strict=False):
        move = f" [{link.by}]" if link.by else ""
        right = f"{link.sign} {write_expression(link.right)}{move}"
        if before is not None and before.right == link.left:
            text += f" {right}"
        else:
            text += f"{' and ' if text else ''}{write_expression(link.left)} {right}"
    return text


def write_meaning(meaning: Meaning) -> str:
    """The text of a meaning, which reads back as an equal one."""
    vector = "vector " if meaning.vector else ""
    letter = write_expression(Letter(meaning.letter))
    sense = "" if meaning.sense is None else f" in the sense of {write_expression(meaning.sense)}"
    article = "an" if meaning.angle == "acute" else "a"
    angle = "" if meaning.angle is None else f" as {article} {meaning.angle} angle"
    return f"let {vector}{letter} = {write_expression(meaning.quantity)}{sense}{angle}"
