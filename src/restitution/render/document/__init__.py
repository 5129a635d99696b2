"""A document as data: headings, paragraphs, equations, entries, tables, pictures, room to write.

Questions, worked solutions, mark schemes, sheets of them, reports and worksheets are documents.
`text`, `markdown`, `latex`, `html` (as text or as a tree of elements) and `typst` write them, and
know no word of what they say.
"""

from __future__ import annotations

from typing import Literal, TypeAlias

from restitution.records import dataclass
from restitution.render.layout import Layout
from restitution.render.text import to_text, width

# Columns of plain text that are about as wide as a page.
_PAGE = 80


@dataclass(frozen=True, slots=True)
class Emphasis:
    """Words in italics: the name of a sphere, a wall, a point or a law."""

    text: str


@dataclass(frozen=True, slots=True)
class Typed:
    """Words as they were typed, such as an item of a statement."""

    text: str


@dataclass(frozen=True, slots=True)
class Strong:
    """Words in bold type, such as the marks of a line."""

    text: str


@dataclass(frozen=True, slots=True)
class LineBreak:
    """The end of a line within the words of a cell."""


Piece: TypeAlias = str | Emphasis | Typed | Layout
Words: TypeAlias = tuple[Piece, ...]
Inline: TypeAlias = Piece | Words
"""Words, mathematics, or a mixture."""
CellPiece: TypeAlias = Piece | Strong | LineBreak
Cell: TypeAlias = CellPiece | tuple[CellPiece, ...]
"""The same in a table, where words may be bold, and lines end."""


@dataclass(frozen=True)
class Heading:
    """The title of what follows: of a half of a sheet, a section, or a step in it (``level`` 3)."""

    words: Inline
    level: Literal[1, 2, 3] = 2


@dataclass(frozen=True)
class Paragraph:
    """Words that stand together: the main result is large, a remark small.

    ``mark`` is what an examiner gives for it, or nothing (``""``) in a column of marks; None where
    there is no such column.
    """

    words: Inline
    role: Literal["text", "result", "remark", "note"] = "text"
    mark: str | None = None


@dataclass(frozen=True)
class Chain:
    """A line of mathematics: operands with signs between them.

    ``operands[0]`` None goes on from the line above. Behind it stand the words of a ``note``, with
    the brackets they need, of which the last may be its ``number``, and its ``mark``. In front of
    it stands the ``label`` of the item that it ends, and an ``answer`` is underlined.
    """

    operands: tuple[Layout | None, ...]
    signs: tuple[str, ...]
    mark: str = ""
    note: Words = ()
    number: str = ""
    answer: bool = False
    label: str = ""

    @property
    def goes_on(self) -> bool:
        """Whether the words behind it begin with a comma."""
        return bool(self.note) and isinstance(self.note[0], str) and self.note[0].startswith(",")


@dataclass(frozen=True)
class Equations:
    """Lines of mathematics, aligned at their signs; marks stand in a column of their own."""

    chains: tuple[Chain, ...]


@dataclass(frozen=True)
class Entries:
    """What is asked, each entry behind its label: (i), (ii), …

    An entry without a label is a paragraph. ``lead`` are the words in front of all of them.
    """

    rows: tuple[tuple[str, Words], ...]
    lead: Words = ()


@dataclass(frozen=True)
class Labelled:
    """Blocks behind a label, (a), with ``words`` at their right end, such as a number of marks."""

    label: str
    blocks: tuple[Block, ...]
    words: str = ""


@dataclass(frozen=True)
class Table:
    """Rows of cells beneath a head.

    ``align`` has a letter for each column: l, c or r. ``height`` is the least of a row in
    millimetres, for cells that are filled in by hand, and ``ruled`` draws all lines. A narrow
    table is as wide as its cells are, another one as the page; there, columns may have ``shares``
    of the room that is left, where those without (None) are as wide as their cells. ``remarks``
    are the columns in small type.
    """

    heads: tuple[Cell, ...]
    rows: tuple[tuple[Cell, ...], ...]
    align: str
    height: float | None = None
    ruled: bool = False
    narrow: bool = False
    shares: tuple[float | None, ...] = ()
    remarks: tuple[int, ...] = ()


@dataclass(frozen=True)
class Picture:
    """A picture (SVG with ids of its own), and words beneath; ``title`` is for who cannot see it.

    ``width`` is in millimetres; None leaves it to the page.
    """

    svg: str
    width: float | None = None
    words: Inline = ""
    title: str = ""


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


@dataclass(frozen=True)
class Room:
    """Empty paper to write on, in millimetres."""

    height: float


@dataclass(frozen=True)
class Together:
    """Blocks that stand on one page where they are short enough."""

    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Inset:
    """A question or a worked solution that stands in another document."""

    document: Document


@dataclass(frozen=True)
class Numbered:
    """What stands behind its number in a margin, below a title, which may be empty."""

    number: int
    title: str
    blocks: tuple[Block, ...]


Block: TypeAlias = (
    Heading
    | Paragraph
    | Equations
    | Entries
    | Labelled
    | Table
    | Picture
    | Listing
    | NewPage
    | Room
    | Together
    | Inset
    | Numbered
)


@dataclass(frozen=True)
class Document:
    """Blocks below a title, which may be empty; ``head`` stands at the right above every page.

    A report and a sheet are pages of their own, a question or a worked solution may stand in
    another page.
    """

    title: str
    blocks: tuple[Block, ...]
    head: str = ""
    kind: Literal["report", "question", "working", "sheet"] = "report"


def pieces(words: Cell) -> tuple[CellPiece, ...]:
    """Words as their pieces."""
    return words if isinstance(words, tuple) else (words,)


def lines(chain: Chain) -> list[tuple[str, list[tuple[str, Layout | None]]]]:
    """A chain in lines of a page: short ones in one, long ones with each sign on its own.

    A line is its first sign, and the operands with the signs between them (none for the first).
    """
    own = list(zip(chain.signs, chain.operands[1:], strict=True))
    room = sum(width(to_text(operand)) + 3 for operand in chain.operands if operand is not None)
    if room <= _PAGE or len(own) == 1:
        (first, operand), *rest = own
        return [(first, [("", operand), *rest])]
    return [(sign, [("", operand)]) for sign, operand in own]
