"""A question as Markdown with LaTeX between ``$``."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.render.latex import to_latex
from restitution.render.markdown import escape
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


def to_markdown(question: QuestionContent) -> str:
    """The question as Markdown; no text of a user comes through as markup."""
    blocks: list[str] = []
    if question.title:
        blocks.append(f"## {escape(question.title)}")
    if question.intro:
        blocks.append(" ".join(map(inline, question.intro)))
    for part in question.parts:
        blocks += _part(part)
    return "\n\n".join(blocks) + "\n"


def inline(words: Words) -> str:
    """Words with their mathematics in LaTeX."""
    return "".join(_piece(word) for word in words)


def _piece(word: Piece) -> str:
    if isinstance(word, str):
        return escape(word)
    if isinstance(word, Named):
        return f"*{word.text}*"
    return f"${to_latex(word)}$"


def _part(part: QuestionPart) -> list[str]:
    blocks = [text for block in part.flow() for text in _block(block)]
    if blocks and part.label is not None:
        blocks[0] = f"**({escape(part.label)})** {blocks[0]}"
    if blocks and part.marks is not None:
        blocks[-1] += f" **{count_of_marks(part.marks)}**"
    return blocks


def _block(block: Block) -> Iterator[str]:
    if not isinstance(block, Listing):
        yield " ".join(map(inline, block.sentences))
        return
    if block.lead:
        yield inline(block.lead)
    for number, words in block.rows():
        yield f"({number}) {inline(words)}" if number else inline(words)
