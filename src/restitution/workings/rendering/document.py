"""A worked solution as a document, and that as text, Markdown, LaTeX, HTML and Typst."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from restitution.explaining.lines.saying import note, say
from restitution.render import document as blocks
from restitution.solving.solver import is_in_terms
from restitution.workings.rendering.steps import PartExplanation, Row, Step, Working


def document_of(explanation: Working) -> blocks.Document:
    """The working as it is set, with the warnings that its steps do not give themselves."""
    warnings = explanation.left_over
    own: list[blocks.Block] = []
    for part in explanation.parts:
        first = [warning for warning in warnings if part.label and is_in_terms(warning, part.label)]
        warnings = tuple(warning for warning in warnings if warning not in first)
        own += _part(part, first)
    own += [_noted(warning) for warning in warnings]
    return blocks.Document(explanation.title or "", tuple(own), kind="working")


def _noted(warning: str) -> blocks.Paragraph:
    return blocks.Paragraph(note(warning), "note")


def _part(part: PartExplanation, first: Iterable[str]) -> Iterator[blocks.Block]:
    if part.label:
        yield blocks.Heading(f"({part.label})")
    yield from map(_noted, first)
    for step in part.steps:
        yield from step_blocks(step)


def step_blocks(step: Step) -> Iterator[blocks.Block]:
    """The words of a step, and its lines of mathematics; or its picture."""
    if step.picture is not None:
        from restitution.drawing.svg import to_svg

        yield blocks.Picture(to_svg(step.picture), title=step.picture.title)
        return
    if step.kind == "heading":
        yield blocks.Heading(step.words, 3)
        return
    words: blocks.Words = step.words
    if step.principle:
        gap = " " if words else ""
        words = (blocks.Emphasis(step.principle), f"{step.sign}{gap}", *words)
    if words:
        yield blocks.Paragraph(words, mark=step.mark)
    if step.rows:
        yield blocks.Equations(tuple(map(chain, step.rows)))


def chain(row: Row) -> blocks.Chain:
    """A line of mathematics as it is set."""
    return blocks.Chain(
        row.operands, row.signs, row.mark, row.note, row.number, row.answer, row.label
    )


def to_text(explanation: Working, width: int = 80, styled: bool = False) -> str:
    """The whole working as Unicode text, at most ``width`` columns wide where that can be.

    With ``styled``, for a terminal: headings and vectors in bold type, by ANSI sequences, where
    plain text has the bold letters of Unicode, which not every terminal shows.
    """
    from restitution.render.document import text

    return text.to_text(document_of(explanation), width, styled)


def to_markdown(explanation: Working) -> str:
    """The working as Markdown; mathematics between ``$`` and ``$$``."""
    from restitution.render.document import markdown

    return markdown.to_markdown(document_of(explanation))


def to_latex(explanation: Working, document: bool = True) -> str:
    """The working as LaTeX: a whole document, or (``document`` False) what stands in one."""
    from restitution.render.document import latex

    return latex.to_latex(document_of(explanation), document)


def to_html(explanation: Working) -> str:
    """A whole page."""
    from restitution.render.document import html

    return html.to_html(document_of(explanation), str(say("page.title")))


def to_fragment(explanation: Working) -> str:
    """What stands in a page (or in a notebook), with its style."""
    from restitution.render.document import html

    return html.to_fragment(document_of(explanation))


def to_body(explanation: Working) -> str:
    """The same without its style, for a page that has it already."""
    from restitution.render.document import html

    return html.to_body(document_of(explanation))


def to_typst(explanation: Working) -> str:
    """The working as Typst markup, to stand in a document that begins with its ``PREAMBLE``."""
    from restitution.render.document import typst

    return typst.to_content(document_of(explanation))
