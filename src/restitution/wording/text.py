"""A question as Unicode text."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.render.text import NO_BREAK, width, wrapped
from restitution.render.text import to_text as one_line
from restitution.wording.structure import (
    Block,
    Listing,
    Named,
    Piece,
    QuestionContent,
    QuestionPart,
    Words,
)
from restitution.wording.words import count_of_marks

_INDENT = 5


def to_text(question: QuestionContent, columns: int = 80) -> str:
    """The whole question, at most so many columns wide where that can be."""
    blocks: list[list[str]] = []
    if question.title:
        blocks.append(wrapped(question.title, columns))
    if question.intro:
        blocks.append(wrapped(" ".join(map(inline, question.intro)), columns))
    for part in question.parts:
        blocks += _part(part, columns)
    return "\n\n".join("\n".join(block) for block in blocks)


def inline(words: Words) -> str:
    """Words on one line; mathematics is held together by no-break spaces."""
    return "".join(_piece(word) for word in words)


def _piece(word: Piece) -> str:
    if isinstance(word, str):
        return word
    if isinstance(word, Named):
        return word.text
    return one_line(word).replace(" ", NO_BREAK)


def _part(part: QuestionPart, columns: int) -> list[list[str]]:
    label = f"({part.label})" if part.label is not None else ""
    indent = _INDENT if label else 0
    blocks = [lines for block in part.flow() for lines in _block(block, columns - indent)]
    if part.marks is not None and blocks:
        blocks[-1] += _right(count_of_marks(part.marks), columns - indent)
    if not label:
        return blocks
    out = [[" " * indent + line for line in lines] for lines in blocks]
    if out:
        out[0][0] = f"{label:<{indent - 1}} {out[0][0][indent:]}"
    return out


def _block(block: Block, columns: int) -> Iterator[list[str]]:
    if not isinstance(block, Listing):
        yield wrapped(" ".join(map(inline, block.sentences)), columns)
        return
    lines = wrapped(inline(block.lead), columns) if block.lead else []
    heads = [f"({entry.number}) " if entry.number else "" for entry in block.entries]
    room = max(map(len, heads))
    for head, (_, words) in zip(heads, block.rows(), strict=True):
        for row, line in enumerate(wrapped(inline(words), columns - room)):
            lines.append(f"{head if row == 0 else '':<{room}}{line}")
    yield lines


def _right(text: str, columns: int) -> list[str]:
    return [" " * max(0, columns - width(text)) + text]
