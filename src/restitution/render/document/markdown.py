"""A document as Markdown with LaTeX between ``$``; no text of a user comes through as markup."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Iterator

from restitution.render.document import (
    Block,
    Cell,
    CellPiece,
    Document,
    Emphasis,
    Entries,
    Equations,
    Heading,
    Inset,
    Labelled,
    LineBreak,
    Listing,
    NewPage,
    Numbered,
    Paragraph,
    Picture,
    Room,
    Strong,
    Table,
    Together,
    Typed,
    pieces,
)
from restitution.render.document.aligned import aligned
from restitution.render.latex import to_latex
from restitution.render.markdown import escape


def to_markdown(document: Document) -> str:
    """The document; its title is a heading of the second rank."""
    title = [f"## {escape(document.title)}"] if document.title else []
    return "\n\n".join([*title, *_blocks(document.blocks)]) + "\n"


def inline(words: Cell) -> str:
    """Words with their mathematics."""
    return "".join(map(_piece, pieces(words)))


def _piece(piece: CellPiece) -> str:
    if isinstance(piece, str):
        return escape(piece)
    if isinstance(piece, Emphasis):
        return f"*{escape(piece.text)}*"
    if isinstance(piece, Strong):
        return f"**{escape(piece.text)}**" if piece.text else ""
    if isinstance(piece, LineBreak):
        return "<br>"
    return f"`{piece.text}`" if isinstance(piece, Typed) else f"${to_latex(piece)}$"


def _blocks(blocks: Iterable[Block]) -> list[str]:
    return [text for block in blocks for text in _block(block)]


def _block(block: Block) -> Iterator[str]:
    match block:
        case Heading(words, level):
            named = inline(words)
            if level < 3:
                yield f"{'#' * (level + 1)} {named}"
            else:
                plain = all(isinstance(piece, str) for piece in pieces(words))
                yield f"**{named}**" if plain else named
        case Paragraph(words, role, mark):
            text = inline(words)
            if mark:
                text = f"{text} **[{escape(mark)}]**"
            yield f"> {text}" if role == "note" else text
        case Equations(chains):
            yield f"$$\n{aligned(chains)}\n$$"
        case Entries(entries, lead):
            if lead:
                yield inline(lead)
            for label, own in entries:
                yield f"{label} {inline(own)}" if label else inline(own)
        case Labelled(label, inside, words):
            texts = _blocks(inside)
            if texts and label:
                texts[0] = f"**{escape(label)}** {texts[0]}"
            if texts and words:
                texts[-1] += f" **{words}**"
            yield from texts
        case Table(heads, rows, align):
            marks = {"l": ":--", "c": ":-:", "r": "--:"}
            lines = [map(inline, heads), (marks[side] for side in align)]
            lines += [map(inline, row) for row in rows]
            yield "\n".join(f"| {' | '.join(cells)} |" for cells in lines)
        case Picture():
            # In the text itself, so that the file needs no other beside it.
            data = b64encode(block.svg.encode()).decode()
            yield f"![{escape(block.title)}](data:image/svg+xml;base64,{data})"
            if block.words:
                yield inline(block.words)
        case Listing(items, numbered, first):
            yield "\n".join(
                f"{f'{number}.' if numbered else '-'} {inline(item.words)}"
                for number, item in enumerate(items, first)
            )
        case NewPage():
            yield "---"
        case Room():
            pass
        case Together(inside):
            yield from _blocks(inside)
        case Inset(document):
            yield to_markdown(document).rstrip("\n")
        case Numbered(number, title, inside):
            texts = _blocks(inside)
            head = f"**{number}**" + (f" **{escape(title)}**" if title else "")
            yield from [head, *texts] if title or not texts else [f"{head} {texts[0]}", *texts[1:]]
