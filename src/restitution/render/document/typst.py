"""A document in Typst's markup, and the PDF of it."""

from __future__ import annotations

from typing import assert_never

from restitution.render.document import (
    Block,
    Document,
    Heading,
    Inline,
    Listing,
    NewPage,
    Paragraph,
    Picture,
    Table,
    pieces,
)
from restitution.render.typst import compiled, literal, paper, to_typst, words

_ALIGNED = {"l": "left", "c": "center", "r": "right"}
_SIZES = {"text": "", "result": "size: 1.25em", "remark": "size: 0.85em"}


def to_pdf(document: Document) -> bytes:
    """The document as a PDF of A4 pages, the same bytes for the same document.

    Raises UnsupportedError where typst is not installed.
    """
    return compiled(to_markup(document), "pdf", "HTML")


def to_markup(document: Document) -> str:
    """The document as markup."""
    title = f"#text(size: 1.3em, strong({literal(document.title)}))"
    body = [_block(block) for block in document.blocks]
    return "\n\n".join([paper(document.title, document.head), title, *body]) + "\n"


def _block(block: Block) -> str:
    match block:
        case Heading(text):
            return (
                f"#block(above: 1.5em, below: 0.8em, sticky: true, "
                f"text(size: 1.1em, strong[{inline(text)}]))"
            )
        case Paragraph(text, role):
            content = inline(text)
            return f"#text({_SIZES[role]})[{content}]" if _SIZES[role] else content
        case Table():
            return _table(block)
        case Picture(svg, width, caption):
            beneath = f"\n  #block(above: 0.6em)[{inline(caption)}]" if caption else ""
            return (
                "#align(center, block(above: 1em, below: 1em, breakable: false)[\n"
                f'  #image(bytes({literal(svg)}), format: "svg", width: {width:g}mm){beneath}\n])'
            )
        case Listing():
            return _listing(block)
        case NewPage():
            return "#pagebreak(weak: true)"
    assert_never(block)


def inline(text: Inline) -> str:
    """Words with their mathematics."""
    return "".join(
        words(piece) if isinstance(piece, str) else to_typst(piece)
        for piece in pieces(text)
        if piece != ""
    )


def _table(table: Table) -> str:
    heads = ", ".join(f"[#strong[{inline(word)}]]" for word in table.heads)
    rows = "".join(
        "  " + ", ".join(f"[{inline(word)}]" for word in row) + ",\n" for row in table.rows
    )
    # The last column of words takes the room that is left.
    kinds = ["auto"] * len(table.align)
    if table.ruled and not table.narrow:
        kinds = ["1fr"] * len(table.align)  # room to write in
    elif "l" in table.align and not table.narrow:
        kinds[table.align.rfind("l")] = "1fr"
    sides = ", ".join(_ALIGNED[each] for each in table.align)
    lines = "0.4pt" if table.ruled else "(x, y) => (bottom: if y == 0 { 0.8pt } else { 0.25pt })"
    height = "" if table.height is None else f"rows: (auto, {table.height:g}mm), "
    columns = ", ".join(kinds)
    table_of = (
        f"table(columns: ({columns},), {height}stroke: {lines}, inset: (x: 6pt, y: 4pt), "
        f"align: ({sides},),\n  table.header({heads}),\n{rows})"
    )
    return f"#block(breakable: false, {table_of})" if table.narrow else f"#{table_of}"


def _listing(listing: Listing) -> str:
    items = []
    for item in listing.items:
        room = f" #block(height: {item.room:g}mm, width: 100%, breakable: true)"
        items.append(f"[{inline(item.words)}{room if item.room else ''}]")
    inside = ", ".join(items)
    if listing.numbered:
        return f"#enum(start: {listing.first}, tight: false, {inside})"
    return f"#list(tight: false, {inside})"
