"""A document as one page of HTML, light or dark, that prints on A4."""

from __future__ import annotations

from html import escape
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
from restitution.render.mathml import to_mathml
from restitution.render.page import page

STYLE = """
:root { --ink: #1b1b1f; --paper: #fff; --soft: #5f6368; --line: #b9bcc4 }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8ec; --paper: #17181c; --soft: #a3a7ae;
  --line: #4a4d55 } }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 1.02rem/1.5 Georgia, "Times New Roman", serif }
main { max-width: 46rem; margin: 0 auto; padding: 1rem; overflow-wrap: break-word }
h1 { font-size: 1.35rem; line-height: 1.25; margin: .5rem 0 1rem }
h2 { font-size: 1.1rem; margin: 1.5rem 0 .5rem; break-after: avoid }
p { margin: .5rem 0 } .result { font-size: 1.3rem } .remark { color: var(--soft); font-size: .9em }
.head { text-align: right; color: var(--soft); margin: 0 }
.wide { overflow-x: auto }
table { border-collapse: collapse; margin: .6rem 0; font-variant-numeric: tabular-nums }
table.full { width: 100% } thead { display: table-header-group } tr { break-inside: avoid }
th, td { padding: .18rem .5rem; vertical-align: top; font-size: .95em }
th { border-bottom: 1.5px solid var(--ink); font-weight: 600; vertical-align: bottom }
td { border-bottom: 1px solid var(--line) }
.ruled.full { table-layout: fixed } .ruled th, .ruled td { border: 1px solid var(--soft) }
.l { text-align: left } .c { text-align: center } .r { text-align: right }
figure { margin: 1rem 0; text-align: center; break-inside: avoid }
figure svg { max-width: 100%; height: auto }
ol, ul { padding-left: 1.6rem } li { margin: .4rem 0 }
.break { break-before: page }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math }
@media print { @page { size: A4; margin: 20mm } main { padding: 0; max-width: none }
  :root { --ink: #000; --paper: #fff; --soft: #333; --line: #999 } body { font-size: 11pt }
  li, p { break-inside: avoid } }
"""


def to_html(document: Document) -> str:
    """The whole page."""
    head = f'<p class="head">{escape(document.head)}</p>\n' if document.head else ""
    body = "\n".join(_block(block) for block in document.blocks)
    inside = f"<main>\n{head}<h1>{escape(document.title)}</h1>\n{body}\n</main>"
    return page(document.title, STYLE, inside)


def _block(block: Block) -> str:
    match block:
        case Heading(words):
            return f"<h2>{inline(words)}</h2>"
        case Paragraph(words, role):
            named = "" if role == "text" else f' class="{role}"'
            return f"<p{named}>{inline(words)}</p>"
        case Table():
            return _table(block)
        case Picture(svg, width, words):
            beneath = f"<figcaption>{inline(words)}</figcaption>" if words else ""
            sized = svg.replace("<svg ", f'<svg style="width:{width:g}mm" ', 1)
            return f"<figure>{sized}{beneath}</figure>"
        case Listing():
            return _listing(block)
        case NewPage():
            return '<div class="break"></div>'
    assert_never(block)


def inline(words: Inline) -> str:
    """Words with their mathematics."""
    return "".join(
        escape(piece) if isinstance(piece, str) else to_mathml(piece) for piece in pieces(words)
    )


def _table(table: Table) -> str:
    heads = "".join(
        f'<th scope="col" class="{side}">{inline(word)}</th>'
        for side, word in zip(table.align, table.heads, strict=True)
    )
    high = "" if table.height is None else f' style="height:{table.height:g}mm"'
    rows = "".join(
        f"<tr{high}>"
        + "".join(
            f'<td class="{side}">{inline(word)}</td>'
            for side, word in zip(table.align, row, strict=True)
        )
        + "</tr>"
        for row in table.rows
    )
    names = [*(["ruled"] if table.ruled else []), *([] if table.narrow else ["full"])]
    return (
        f'<div class="wide"><table class="{" ".join(names)}"><thead><tr>{heads}</tr></thead>'
        f"<tbody>{rows}</tbody></table></div>"
    )


def _listing(listing: Listing) -> str:
    items = "".join(
        f"<li>{inline(item.words)}"
        + (f'<div style="height:{item.room:g}mm"></div>' if item.room else "")
        + "</li>"
        for item in listing.items
    )
    if not listing.numbered:
        return f"<ul>{items}</ul>"
    start = "" if listing.first == 1 else f' start="{listing.first}"'
    return f"<ol{start}>{items}</ol>"
