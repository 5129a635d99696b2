"""A question as a document, and that as text, Markdown, HTML and Typst."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.render import document as blocks
from restitution.wording.structure import (
    Listing,
    Piece,
    QuestionContent,
    QuestionPart,
    Sentence,
    Words,
)
from restitution.wording.words import count_of_marks


def document_of(question: QuestionContent) -> blocks.Document:
    """The question as it is set, without a picture."""
    own = [*opening(question), *map(part, question.parts)]
    return blocks.Document(question.title or "", tuple(own), kind="question")


def opening(question: QuestionContent) -> list[blocks.Block]:
    """What is told before anything is asked."""
    return [blocks.Paragraph(_joined(question.intro))] if question.intro else []


def part(part: QuestionPart) -> blocks.Block:
    """A part behind its label, with its marks at the right."""
    label = "" if part.label is None else f"({part.label})"
    marks = "" if part.marks is None else count_of_marks(part.marks)
    return blocks.Labelled(label, tuple(_body(part)), marks)


def _body(part: QuestionPart) -> Iterator[blocks.Block]:
    for block in part.flow():
        if isinstance(block, Listing):
            rows = ((f"({number})" if number else "", words) for number, words in block.rows())
            yield blocks.Entries(tuple(rows), block.lead)
        else:
            yield blocks.Paragraph(_joined(block.sentences))


def _joined(sentences: tuple[Sentence, ...]) -> Words:
    """Sentences with a blank between any two."""
    out: list[Piece] = []
    for sentence in sentences:
        first, *rest = sentence
        blank = " " if out else ""
        out += (
            [f"{blank}{first}"] if isinstance(first, str) else [*([blank] if blank else []), first]
        )
        out += rest
    return tuple(out)


def to_text(question: QuestionContent, columns: int = 80) -> str:
    """The whole question as Unicode text, at most so many columns wide where that can be."""
    from restitution.render.document import text

    return text.to_text(document_of(question), columns)


def to_markdown(question: QuestionContent) -> str:
    """The question as Markdown with LaTeX between ``$``."""
    from restitution.render.document import markdown

    return markdown.to_markdown(document_of(question))


def to_html(question: QuestionContent) -> str:
    """A whole page, which needs nothing else."""
    from restitution.render.document import html

    return html.to_html(document_of(question), "Question")


def to_fragment(question: QuestionContent) -> str:
    """What stands in a page (or in a notebook), with its style."""
    from restitution.render.document import html

    return html.to_fragment(document_of(question))


def to_body(question: QuestionContent) -> str:
    """A question without its style, for a page that has it already."""
    from restitution.render.document import html

    return html.to_body(document_of(question))


def to_typst(question: QuestionContent) -> str:
    """The question in Typst's markup: paragraphs, and rows with a label at the left.

    Uses Typst's own functions alone, so that it can stand in any document.
    """
    from restitution.render.document import typst

    return typst.to_content(document_of(question))
