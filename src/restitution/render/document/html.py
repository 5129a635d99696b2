"""A document as HTML with MathML: a page that needs nothing else, or what stands in one.

Elements are trees (`restitution.render.markup`); the text of a page is written of these.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import assert_never

from restitution.render.document import (
    Block,
    Document,
    Entries,
    Equations,
    Heading,
    Inline,
    Inset,
    Labelled,
    Listing,
    NewPage,
    Numbered,
    Paragraph,
    Picture,
    Room,
    Table,
    Together,
)
from restitution.render.document.cells import classed, inline, rows
from restitution.render.document.styles import AROUND, STYLES
from restitution.render.markup import Raw, Tree, element, to_markup
from restitution.render.page import page

_CLASSES = {"question": "question", "working": "restitution"}


def to_html(document: Document, title: str = "") -> str:
    """A whole page; ``title`` is the name of one of a document that has none."""
    named = document.title or title
    if document.kind in ("report", "sheet"):
        return page(named, STYLES[document.kind], to_body(document))
    return page(named, AROUND[document.kind], to_fragment(document))


def to_fragment(document: Document) -> str:
    """What stands in a page (or in a notebook), with its style."""
    return f"<style>{STYLES[document.kind]}</style>\n{to_body(document)}"


def to_body(document: Document) -> str:
    """The same without its style, for a page that has it already; each block begins a line."""
    whole = to_tree(document)
    assert not isinstance(whole, str)
    name, attributes, *children = whole
    inside = [piece for child in children for piece in ("\n", child)]
    return to_markup(element(name, [*inside, "\n"], attributes))


def to_tree(document: Document) -> Tree:
    """The same as a tree of elements."""
    title = [element("h1", [document.title])] if document.title else []
    blocks = to_trees(document.blocks)
    if document.kind in ("report", "sheet"):
        head = [classed("p", "head", [document.head])] if document.head else []
        return element("main", [*head, *title, *blocks])
    return classed("article", _CLASSES[document.kind], [*title, *blocks])


def to_blocks(blocks: Iterable[Block]) -> str:
    """Blocks to stand in a page, one behind the other."""
    return to_markup(*to_trees(blocks))


def to_trees(blocks: Iterable[Block]) -> list[Tree]:
    """Blocks as elements, one behind the other."""
    return [tree for block in blocks for tree in _block(block)]


def _block(block: Block) -> list[Tree]:
    match block:
        case Heading(words, level):
            return [element(f"h{max(level, 2)}", inline(words))]
        case Paragraph(words, role, mark):
            beside = [classed("span", "mark", [mark])] if mark else []
            own = {} if role == "text" else {"class": role}
            return [element("p", [*beside, *inline(words)], own)]
        case Equations(chains):
            return [element("table", [row for chain in chains for row in rows(chain)])]
        case Entries(entries, lead):
            asked = [_row(label, words) if label else _paragraph(words) for label, words in entries]
            return [*([_paragraph(lead)] if lead else []), classed("div", "asked", asked)]
        case Labelled(label, blocks, words):
            inside = to_trees(blocks)
            if words:
                inside.append(classed("p", "marks", [words]))
            return [_labelled(label, inside)] if label else inside
        case Table():
            return [_table(block)]
        case Picture():
            return [_picture(block)]
        case Listing():
            return [_listing(block)]
        case NewPage():
            return [classed("div", "break", [])]
        case Room(height):
            return [element("div", [], {"style": f"height:{height:g}mm"})]
        case Together(inside):
            return to_trees(inside)
        case Inset(document):
            return [to_tree(document)]
        case Numbered(number, title, inside):
            head = [element("h3", [title])] if title else []
            both = element("div", [*head, *to_trees(inside)])
            return [classed("section", "entry", [classed("div", "number", [f"{number}"]), both])]
    assert_never(block)


def _paragraph(words: Inline) -> Tree:
    return element("p", inline(words))


def _row(label: str, words: Inline) -> Tree:
    return _labelled(label, [_paragraph(words)])


def _labelled(label: str, inside: list[Tree]) -> Tree:
    return classed("div", "row", [element("span", [label]), element("div", inside)])


def _picture(picture: Picture) -> Tree:
    svg = picture.svg
    if picture.width is not None:
        svg = svg.replace("<svg ", f'<svg style="width:{picture.width:g}mm" ', 1)
    beneath = [element("figcaption", inline(picture.words))] if picture.words else []
    return element("figure", [Raw(svg), *beneath])


def _table(table: Table) -> Tree:
    heads = [
        element("th", inline(words), {"scope": "col", "class": side})
        for side, words in zip(table.align, table.heads, strict=True)
    ]
    kinds = [
        f"{side} remark" if column in table.remarks else side
        for column, side in enumerate(table.align)
    ]
    high = {} if table.height is None else {"style": f"height:{table.height:g}mm"}
    body = [
        element(
            "tr",
            [classed("td", kind, inline(words)) for kind, words in zip(kinds, row, strict=True)],
            high,
        )
        for row in table.rows
    ]
    names = [*(["ruled"] if table.ruled else []), *([] if table.narrow else ["full"])]
    names += ["shared"] if table.shares else []
    inside = [element("thead", [element("tr", heads)]), element("tbody", body)]
    return classed("div", "wide", [classed("table", " ".join(names), inside)])


def _listing(listing: Listing) -> Tree:
    items = [
        element(
            "li",
            [
                *inline(item.words),
                *([element("div", [], {"style": f"height:{item.room:g}mm"})] if item.room else []),
            ],
        )
        for item in listing.items
    ]
    if not listing.numbered:
        return element("ul", items)
    return element("ol", items, {} if listing.first == 1 else {"start": f"{listing.first}"})
