"""A question as HTML with MathML: a page that needs nothing else, or what stands in one."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape

from restitution.render.layout import Layout
from restitution.render.mathml import to_mathml
from restitution.render.page import page
from restitution.render.paragraph import paragraph
from restitution.wording.structure import (
    Block,
    Listing,
    Named,
    QuestionContent,
    QuestionPart,
    Words,
)
from restitution.wording.words import count_of_marks

STYLE = """
.question { color: #1b1b1f; background: #fff; max-width: 42rem; margin: 0 auto; padding: 1rem;
  font: 1.05rem/1.6 Georgia, "Times New Roman", serif; }
.question h1 { font-size: 1.35rem; line-height: 1.25; margin: 0 0 1rem; }
.question p { margin: .5rem 0; }
.question .row { display: grid; grid-template-columns: minmax(2.4rem, max-content) minmax(0, 1fr);
  align-items: baseline; }
.question .row > span { padding-right: .5rem; }
.question .asked { display: grid;
  grid-template-columns: minmax(2.4rem, max-content) minmax(0, 1fr); }
.question .asked > * { grid-column: 1 / -1; }
.question .asked > .row { grid-template-columns: subgrid; }
.question .asked .row > div > p { margin: .1rem 0; }
.question .marks { text-align: right; }
.question .whole { white-space: nowrap; }
.question math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math;
  font-size: 1.05em; }
@media (prefers-color-scheme: dark) { .question { color: #e8e8ec; background: #17181c; } }
@media print { .question { color: #000; background: #fff; max-width: none; padding: 0;
  font-size: 11pt; } .question p, .question .row, .question .figure { break-inside: avoid; }
  .question h1, .question h1 + p, .question p:has(+ .figure), .question .figure {
  break-after: avoid; } }
"""


def to_html(question: QuestionContent) -> str:
    """A whole page."""
    return page(question.title or "Question", "body { margin: 0 }", to_fragment(question))


def to_fragment(question: QuestionContent) -> str:
    """What stands in a page (or in a notebook), with its style."""
    return f"<style>{STYLE}</style>\n{to_body(question)}"


def to_body(question: QuestionContent) -> str:
    """A question without its style, for a page that has it already."""
    out = ['<article class="question">']
    if question.title:
        out.append(f"<h1>{escape(question.title)}</h1>")
    out += [*opening(question), *map(part, question.parts), "</article>"]
    return "\n".join(out)


def opening(question: QuestionContent) -> list[str]:
    """The paragraphs before anything is asked."""
    return [_paragraph(*question.intro)] if question.intro else []


def inline(words: Words) -> str:
    """Words with their mathematics; what follows a formula without a blank stays on its line."""
    return paragraph(words, _markup, lambda piece: not isinstance(piece, Named))


def _markup(piece: Named | Layout) -> str:
    return f"<i>{escape(piece.text)}</i>" if isinstance(piece, Named) else to_mathml(piece)


def _paragraph(*sentences: Words) -> str:
    return f"<p>{' '.join(map(inline, sentences))}</p>"


def _row(head: str, body: str) -> str:
    return f'<div class="row"><span>({escape(head)})</span><div>{body}</div></div>'


def part(part: QuestionPart) -> str:
    """A part, with its label at the left and its marks at the right."""
    body = "\n".join(text for block in part.flow() for text in _block(block))
    if part.marks is not None:
        body += f'\n<p class="marks">{count_of_marks(part.marks)}</p>'
    return body if part.label is None else _row(part.label, body)


def _block(block: Block) -> Iterator[str]:
    if not isinstance(block, Listing):
        yield _paragraph(*block.sentences)
        return
    if block.lead:
        yield _paragraph(block.lead)
    rows = [
        _row(number, _paragraph(words)) if number else _paragraph(words)
        for number, words in block.rows()
    ]
    yield f'<div class="asked">{"".join(rows)}</div>'
