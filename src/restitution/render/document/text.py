"""A document as Unicode text, for a terminal: words wrapped, equations aligned at their signs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import zip_longest
from string import ascii_letters, digits

from restitution.render.document import (
    Block,
    Cell,
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
from restitution.render.document.columns import INDENT, TextLine, aligned, inline, plain
from restitution.render.text import NO_BREAK, bold, wrapped
from restitution.render.text import width as columns

# Where the paragraphs of a part stand behind its label.
_BEHIND = 5
_NOTHING = TextLine()
# Columns that a cell has at the least.
_NARROWEST = 12

_BOLD, _FAINT, _NORMAL = "\x1b[1m", "\x1b[2m", "\x1b[0m"
_LETTERS = {bold(c): c for c in ascii_letters + digits}


def to_text(document: Document, width: int = 80, styled: bool = False) -> str:
    """The whole document as Unicode text, at most ``width`` columns wide where that can be.

    With ``styled``, for a terminal: headings and vectors in bold type, by ANSI sequences, where
    plain text has the bold letters of Unicode, which not every terminal shows.
    """
    lines = [*_strong(wrapped(document.title, width)), _NOTHING] if document.title else []
    texts = _Texts(width, _margin(document.blocks), document.kind != "working")
    lines = texts.below(lines, document.blocks)
    while lines and lines[-1] == _NOTHING:
        lines.pop()
    return "\n".join(_finished(line, width, styled) for line in lines).replace(NO_BREAK, " ")


def _margin(blocks: Iterable[Block]) -> int:
    """Columns in front of all lines of mathematics that the longest of their labels needs."""
    labels = (
        chain.label for block in blocks if isinstance(block, Equations) for chain in block.chains
    )
    return max(0, max(map(columns, labels), default=0) + 1 - INDENT)


class _Texts:
    """How blocks are written: in what width, behind what margin, and whether they are apart."""

    def __init__(self, width: int, margin: int, apart: bool) -> None:
        self.width = width
        self.margin = margin
        self.apart = apart

    def below(self, lines: list[TextLine], blocks: Iterable[Block]) -> list[TextLine]:
        """Lines, and those of blocks below them."""
        for block in blocks:
            own = list(self.block(block))
            gap = self.apart or isinstance(block, Heading)
            gap = gap and bool(lines) and lines[-1] != _NOTHING
            lines += [*([_NOTHING] if gap and own else []), *own]
        return lines

    def block(self, block: Block) -> Iterator[TextLine]:
        """The lines of one block."""
        match block:
            case Heading(words, level):
                yield from _strong(wrapped(inline(words), self.width))
                if level == 2:
                    yield _NOTHING
            case Paragraph(words, _, mark):
                yield from self.paragraph(words, mark or "")
            case Equations(chains):
                yield from aligned(chains, self.width, self.margin)
            case Entries(entries, lead):
                yield from plain(wrapped(inline(lead), self.width)) if lead else ()
                room = max((len(label) + 1 for label, _ in entries if label), default=0)
                for label, words in entries:
                    yield from _hanging(label, wrapped(inline(words), self.width - room), room)
            case Labelled(label, inside, words):
                yield from self.labelled(label, inside, words)
            case Table(heads, rows, shares=shares):
                yield from plain(_table([heads, *rows], shares, self.width))
            case Picture(words=words):
                yield from plain(wrapped(inline(words), self.width)) if words else ()
            case Listing(items, numbered, first):
                for number, item in enumerate(items, first):
                    head = f"{number}." if numbered else "-"
                    room = len(head) + 1
                    yield from _hanging(head, wrapped(inline(item.words), self.width - room), room)
            case Together(inside):
                yield from self.below([], inside)
            case Inset(document):
                own = to_text(document, self.width)
                yield from plain(own.splitlines())
            case Numbered(number, title, inside):
                named = [Heading(title, 3)] if title else []
                yield from self.labelled(f"{number}", [*named, *inside], "")
            case NewPage() | Room():
                pass

    def paragraph(self, words: Inline, mark: str) -> list[TextLine]:
        """Words, with their mark at the end of the last line."""
        room = self.width - (columns(mark) + 2 if mark else 0)
        lines = plain(wrapped(inline(words), room))
        return [*lines[:-1], replace(lines[-1], mark=mark)]

    def labelled(self, label: str, blocks: Sequence[Block], words: str) -> list[TextLine]:
        """Blocks behind a label, with words at the right end of the last line."""
        behind = _BEHIND if label else 0
        inner = _Texts(self.width - behind, self.margin, self.apart)
        lines = inner.below([], blocks)
        if words and lines:
            lines.append(TextLine(" " * max(0, inner.width - columns(words)) + words))
        if not label:
            return lines
        lines = [
            replace(line, text=" " * behind + line.text) if line.text else line for line in lines
        ]
        if lines:
            lines[0] = replace(lines[0], text=f"{label:<{behind - 1}} {lines[0].text[behind:]}")
        return lines


def _hanging(head: str, texts: Sequence[str], room: int) -> list[TextLine]:
    """Texts below one another, with a head in front of the first."""
    return [
        TextLine(f"{head if number == 0 else '':<{room}}{text}")
        for number, text in enumerate(texts)
    ]


def _table(rows: Sequence[Sequence[Cell]], shares: Sequence[float | None], width: int) -> list[str]:
    """Rows of cells in columns two blanks apart; those with a share of the width are wrapped."""
    cells = [[inline(cell).split("\n") for cell in row] for row in rows]
    widths = [max(columns(line) for cell in column for line in cell) for column in zip(*cells)]
    if shares:
        own = sum(room for room, share in zip(widths, shares, strict=True) if share is None)
        left = max(width - own - 2 * (len(widths) - 1), 0)
        whole = sum(filter(None, shares))
        widths = [
            room if share is None else max(int(left * share / whole), _NARROWEST)
            for room, share in zip(widths, shares, strict=True)
        ]
    out = []
    for row in cells:
        wrapped_cells = [
            [piece for line in cell for piece in wrapped(line, room) or [""]]
            for cell, room in zip(row, widths, strict=True)
        ]
        for texts in zip_longest(*wrapped_cells, fillvalue=""):
            padded = (
                text + " " * (room - columns(text))
                for text, room in zip(texts, widths, strict=True)
            )
            out.append("  ".join(padded).rstrip())
    return out


def _strong(texts: Sequence[str]) -> list[TextLine]:
    return [TextLine(text, strong=True) for text in texts]


def _finished(line: TextLine, width: int, styled: bool) -> str:
    gap = " " * max(2, width - columns(line.text) - columns(line.mark)) if line.mark else ""
    if not styled:
        return f"{line.text}{gap}{line.mark}"
    text, mark = line.text, line.mark
    text = "".join(_LETTERS.get(c, c) for c in text) if line.strong else _with_bold(text)
    if line.strong and text:
        text = f"{_BOLD}{text}{_NORMAL}"
    return f"{text}{gap}{_FAINT}{mark}{_NORMAL}" if mark else text


def _with_bold(text: str) -> str:
    """Bold type for the bold letters of Unicode."""
    return "".join(f"{_BOLD}{_LETTERS[c]}{_NORMAL}" if c in _LETTERS else c for c in text)
