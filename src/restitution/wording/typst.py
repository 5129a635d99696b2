"""A question in Typst's markup, from which sheets are set."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.render.text import NO_BREAK
from restitution.render.typst import to_typst as equation
from restitution.render.typst import words as text
from restitution.wording.structure import (
    Block,
    Listing,
    Named,
    Piece,
    QuestionPart,
    Words,
)
from restitution.wording.whole import Question
from restitution.wording.words import count_of_marks


def to_typst(question: Question) -> str:
    """The question as content: paragraphs, and rows with a label at the left.

    Uses Typst's own functions alone, so that it can stand in any document.
    """
    blocks: list[str] = []
    if question.title:
        blocks.append(f"#strong[{text(question.title)}]")
    if question.intro:
        blocks.append(opening(question))
    blocks += [part(other) for other in question.parts]
    return "\n\n".join(blocks) + "\n"


def opening(question: Question) -> str:
    """The paragraphs before anything is asked."""
    return " ".join(map(inline, question.intro))


def inline(words: Words) -> str:
    """Words with their mathematics."""
    return "".join(_piece(word) for word in words)


def _piece(word: Piece) -> str:
    if isinstance(word, str):
        # A literal knows no such blank: Typst's own sign for one is outside of it.
        return "~".join(text(part) if part else "" for part in word.split(NO_BREAK))
    if isinstance(word, Named):
        return f"#emph[{text(word.text)}]"
    return equation(word)


def _row(head: str, body: str, widest: str = "") -> str:
    """A label and what it is of; ``widest`` is the longest label of those below one another."""
    label, room = text(f"({head})"), text(f"({widest or head})")
    column = f"calc.max(2.2em.to-absolute(), measure[{room}].width + 0.6em.to-absolute())"
    return f"#context grid(columns: ({column}, 1fr), row-gutter: 0.65em, [{label}], [{body}])"


def part(part: QuestionPart) -> str:
    """A part, with its label at the left and its marks at the right."""
    body = "\n\n".join(line for block in part.flow() for line in _block(block))
    if part.marks is not None:
        body += f"\n\n#align(right)[{text(count_of_marks(part.marks))}]"
    return body if part.label is None else _row(part.label, body)


def _block(block: Block) -> Iterator[str]:
    if not isinstance(block, Listing):
        yield " ".join(map(inline, block.sentences))
        return
    if block.lead:
        yield inline(block.lead)
    widest = max((entry.number for entry in block.entries), key=len)
    for number, words in block.rows():
        yield _row(number, inline(words), widest) if number else inline(words)
