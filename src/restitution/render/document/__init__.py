"""A document as data: headings, paragraphs, tables, pictures, lists, and room to write.

It is written by `html` and `typst`, which know no word of what it says.
"""

from __future__ import annotations

from typing import Literal, TypeAlias

from restitution.records import dataclass
from restitution.render.layout import Layout

Inline: TypeAlias = "str | Layout | tuple[str | Layout, ...]"
"""Words, mathematics, or a mixture."""


@dataclass(frozen=True)
class Heading:
    """The title of what follows."""

    words: Inline


@dataclass(frozen=True)
class Paragraph:
    """Words that stand together: the main result is large, a remark small."""

    words: Inline
    role: Literal["text", "result", "remark"] = "text"


@dataclass(frozen=True)
class Table:
    """Rows of cells beneath a head.

    ``align`` has a letter for each column: l, c or r. ``height`` is the least of a row in
    millimetres, for cells that are filled in by hand, and ``ruled`` draws all lines. A narrow
    table is as wide as its cells are, another one as the page.
    """

    heads: tuple[Inline, ...]
    rows: tuple[tuple[Inline, ...], ...]
    align: str
    height: float | None = None
    ruled: bool = False
    narrow: bool = False


@dataclass(frozen=True)
class Picture:
    """A picture (SVG with ids of its own) at a width in millimetres, and words beneath."""

    svg: str
    width: float
    words: Inline = ""


@dataclass(frozen=True)
class Item:
    """One entry of a list, and the room after it in millimetres."""

    words: Inline
    room: float = 0.0


@dataclass(frozen=True)
class Listing:
    """Entries with numbers, or with a dot each; ``first`` is the first number."""

    items: tuple[Item, ...]
    numbered: bool = False
    first: int = 1


@dataclass(frozen=True)
class NewPage:
    """What follows begins on a page of its own."""


Block: TypeAlias = Heading | Paragraph | Table | Picture | Listing | NewPage


@dataclass(frozen=True)
class Document:
    """What is printed on A4; ``head`` stands at the right above every page."""

    title: str
    blocks: tuple[Block, ...]
    head: str = ""


def pieces(words: Inline) -> tuple[str | Layout, ...]:
    """Words as their pieces."""
    return words if isinstance(words, tuple) else (words,)
