"""A document in Typst's markup, and the PDF of it: marks stand in the margin."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import assert_never

from restitution.render.document import (
    Block,
    Cell,
    Chain,
    Document,
    Emphasis,
    Entries,
    Equations,
    Heading,
    Inline,
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
    lines,
    pieces,
)
from restitution.render.layout import Layout, Words
from restitution.render.text import NO_BREAK
from restitution.render.typst import compiled, literal, paper, to_typst
from restitution.render.typst import words as plain

_ALIGNED = {"l": "left", "c": "center", "r": "right"}
_SIZES = {"result": "size: 1.25em", "remark": "size: 0.85em"}
# Characters of markup that a page may not hold.
_LONG = 4000

PREAMBLE = """
#let working-mark(mark) = text(size: 0.85em, weight: "bold", mark)
#let working-picture(svg) = align(center, block(above: 1em, below: 1em,
  image(bytes(svg), format: "svg")))
#let working-line(body, mark) = block(above: 0.7em, below: 0.7em, grid(
  columns: (1fr, 5.6em), column-gutter: 0.6em, body, align(right + bottom, working-mark(mark))))
// Each row is one line of text, so that all of it stands on one baseline; the left sides are as
// wide as the widest that is less than half a page. The leading is nothing, as a line of text
// lets tall formulas reach into it.
#let working-rows(..rows) = block(above: 0.8em, below: 0.8em, width: 100%, context {
  set par(leading: 0em)
  let room = calc.max(0cm, ..rows.pos().map(row => measure(row.at(0)).width).filter(w => w < 8cm))
  for (left, sign, right, mark) in rows.pos() {
    let body = if sign == none { left } else {
      let beside = measure(left).width
      if beside > room { left } else { box(width: room, align(std.right, left)) }
      [#h(0.3em)#sign#h(0.3em)#right]
    }
    // What does not fit into a line goes on below its right side.
    let hanging = if sign == none or measure(left).width > room { 2em } else {
      calc.min(room + 1.6em.to-absolute(), 4.5cm) }
    block(above: 0.65em, below: 0.65em, grid(columns: (1fr, 5.6em), column-gutter: 0.6em,
      align: (std.left + horizon, std.right + horizon),
      par(hanging-indent: hanging, leading: 0.25em, body), working-mark(mark)))
  }
})
"""
"""What the markup of equations calls; it stands once at the head of a document that has such."""


def to_pdf(document: Document) -> bytes:
    """The document as a PDF of A4 pages, the same bytes for the same document.

    Raises UnsupportedError where typst is not installed.
    """
    return compiled(to_markup(document), "pdf", "HTML")


def to_markup(document: Document) -> str:
    """The document as markup."""
    setup = paper(document.title, document.head)
    if document.kind == "sheet" or any(isinstance(block, Equations) for block in document.blocks):
        setup += PREAMBLE
    # The title of a sheet stands above every page.
    title = f"#text(size: 1.3em, strong({literal(document.title)}))"
    titles = [] if document.kind == "sheet" else [title]
    return "\n\n".join([setup, *titles, *_blocks(document.blocks)]) + "\n"


def to_content(document: Document) -> str:
    """The document to stand in another; one with equations needs the ``PREAMBLE`` there."""
    title = [f"#strong[{plain(document.title)}]"] if document.title else []
    return "\n\n".join([*title, *_blocks(document.blocks)]) + "\n"


def to_blocks(blocks: Iterable[Block]) -> str:
    """Blocks to stand in a document, without a title."""
    return "\n\n".join(_blocks(blocks))


def _blocks(blocks: Iterable[Block]) -> list[str]:
    return [
        text
        for block, after in pairwise((*blocks, None))
        if block is not None
        for text in _block(block, isinstance(after, Equations))
    ]


def _block(block: Block, is_held: bool) -> list[str]:
    """A block as paragraphs; one that is held stays on the page of what follows."""
    match block:
        case Heading(words, level):
            return [_heading(words, level)]
        case Paragraph():
            return [_paragraph(block, is_held)]
        case Equations(chains):
            rows = [row for chain in chains for row in _rows(chain)]
            return ["#working-rows(\n  " + ",\n  ".join(rows) + ",\n)"]
        case Entries(entries, lead):
            widest = max((label for label, _ in entries), key=len, default="")
            own = [
                _labelled(label, inline(words), widest) if label else inline(words)
                for label, words in entries
            ]
            return [*([inline(lead)] if lead else []), *own]
        case Labelled(label, inside, words):
            texts = _blocks(inside)
            if words:
                texts.append(f"#align(right)[{plain(words)}]")
            return [_labelled(label, "\n\n".join(texts), label)] if label else texts
        case Table():
            return [_table(block)]
        case Picture(svg, width, caption):
            beneath = f"\n  #block(above: 0.6em)[{inline(caption)}]" if caption else ""
            size = "" if width is None else f", width: {width:g}mm"
            image = f'#image(bytes({literal(svg)}), format: "svg"{size}){beneath}'
            around = "block(above: 1em, below: 1em, breakable: false)"
            return [f"#align(center, {around}[\n  {image}\n])"]
        case Listing():
            return [_listing(block)]
        case NewPage():
            return ["#pagebreak(weak: true)"]
        case Room(height):
            return [f"#block(height: {height:g}mm, width: 100%, breakable: true)"]
        case Together(inside):
            texts = _blocks(inside)
            plain_blocks = [content for content in inside if not isinstance(content, Picture)]
            if len(to_blocks(plain_blocks)) >= _LONG:
                return texts
            whole = "\n\n".join(texts)
            return [f"#block(breakable: false, width: 100%)[\n{whole}\n]"]
        case Inset(document):
            return [to_content(document)]
        case Numbered(number, title, inside):
            named = f"#block(sticky: true, strong({literal(title)}))\n" if title else ""
            body = "\n\n".join(_blocks(inside))
            beside = f"grid(columns: (1.8em, 1fr), strong[{number}], [{named}{body}\n])"
            return [f"#block(above: 1.6em, breakable: true, {beside})"]
    assert_never(block)


def _heading(words: Inline, level: int) -> str:
    if level == 1:
        return f"#heading(numbering: none)[{inline(words)}]"
    if level == 2:
        return (
            f"#block(above: 1.5em, below: 0.8em, sticky: true, "
            f"text(size: 1.1em, strong[{inline(words)}]))"
        )
    return f"#block(above: 1.1em, sticky: true)[#strong[{inline(words)}]]"


def _paragraph(paragraph: Paragraph, is_held: bool) -> str:
    text = inline(paragraph.words)
    if paragraph.role == "note":
        return f"#emph[{text}]"
    if paragraph.role != "text":
        return f"#text({_SIZES[paragraph.role]})[{text}]"
    if paragraph.mark is None:
        return text
    line = f"#working-line([{text}], {literal(paragraph.mark)})"
    return f"#block(sticky: true)[{line}]" if is_held else line


def inline(words: Cell) -> str:
    """Words with their mathematics."""
    out: list[str] = []
    for piece in pieces(words):
        if isinstance(piece, str):
            # A literal knows no such blank: Typst's own sign for one is outside of it.
            out.append("~".join(plain(part) if part else "" for part in piece.split(NO_BREAK)))
        elif isinstance(piece, Emphasis):
            out.append(f"#emph[{plain(piece.text)}]")
        elif isinstance(piece, Typed):
            out.append(f"#raw({literal(piece.text)})")
        elif isinstance(piece, Strong):
            out.append(f"#strong[{plain(piece.text)}]")
        elif isinstance(piece, LineBreak):
            out.append(" #linebreak() ")
        else:
            out.append(to_typst(piece))
    return "".join(out)


def _labelled(label: str, body: str, widest: str) -> str:
    """A label and what it is of; ``widest`` is the longest label of those below one another."""
    room = plain(widest)
    column = f"calc.max(2.2em.to-absolute(), measure[{room}].width + 0.6em.to-absolute())"
    return (
        f"#context grid(columns: ({column}, 1fr), row-gutter: 0.65em, [{plain(label)}], [{body}])"
    )


def _rows(chain: Chain) -> list[str]:
    """Arrays of the left side, the sign, the right side and the mark."""
    label = f"{plain(chain.label)} #h(0.4em) " if chain.label else ""
    left = label + _operand(chain.operands[0])
    note = f"#text(size: 0.9em)[{inline(chain.note)}]" if chain.note else ""
    note = note if chain.goes_on or not note else f" {note}"
    mark = literal(chain.mark)
    if not chain.signs:
        return [f"([{left}{note}], none, [], {mark})"]
    cells: list[str] = []
    broken = lines(chain)
    for index, (sign, operands) in enumerate(broken):
        last = index == len(broken) - 1
        right = "".join(f"{f' ${s}$ ' if s else ''}{_operand(operand)}" for s, operand in operands)
        cells.append(
            f"([{left if index == 0 else ''}], [${sign}$], "
            f"[{right}{note if last else ''}], {mark if last else literal('')})"
        )
    return cells


def _operand(layout: Layout | None) -> str:
    if layout is None:
        return ""
    return plain(layout.text) if isinstance(layout, Words) else to_typst(layout, block=True)


# An empty block that stays with what stands above it, and is taken back: a table of marks with so
# much room below it on the page is begun there, any other on the next one.
_BEGUN = "#block(height: 9em, breakable: false, sticky: true, below: 0pt)\n#v(-9em)"


def _table(table: Table) -> str:
    heads = ", ".join(f"[#strong[{inline(word)}]]" for word in table.heads)
    rows = "".join(
        "  "
        + ", ".join(
            f"[#text(size: 0.85em)[{inline(words)}]]"
            if column in table.remarks
            else f"[{inline(words)}]"
            for column, words in enumerate(row)
        )
        + ",\n"
        for row in table.rows
    )
    # The last column of words takes the room that is left.
    kinds = ["auto"] * len(table.align)
    if table.shares:
        kinds = ["auto" if share is None else f"{share:g}fr" for share in table.shares]
    elif table.ruled and not table.narrow:
        kinds = ["1fr"] * len(table.align)  # room to write in
    elif "l" in table.align and not table.narrow:
        kinds[table.align.rfind("l")] = "1fr"
    sides = ", ".join(_ALIGNED[side] for side in table.align)
    lines = "0.4pt" if table.ruled else "(x, y) => (bottom: if y == 0 { 0.8pt } else { 0.25pt })"
    height = "" if table.height is None else f"rows: (auto, {table.height:g}mm), "
    columns = ", ".join(kinds)
    table_of = (
        f"table(columns: ({columns},), {height}stroke: {lines}, inset: (x: 6pt, y: 4pt), "
        f"align: ({sides},),\n  table.header({heads}),\n{rows})"
    )
    if table.narrow:
        return f"#block(breakable: false, {table_of})"
    if table.remarks and len(table.rows) > 2:
        return f"{_BEGUN}\n#block(above: 0pt, {table_of})"
    return f"#{table_of}"


def _listing(listing: Listing) -> str:
    items = []
    for item in listing.items:
        room = f" #block(height: {item.room:g}mm, width: 100%, breakable: true)"
        items.append(f"[{inline(item.words)}{room if item.room else ''}]")
    inside = ", ".join(items)
    if listing.numbered:
        return f"#enum(start: {listing.first}, tight: false, {inside})"
    return f"#list(tight: false, {inside})"
