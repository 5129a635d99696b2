"""An exam-style question as a value: sentences made of words, names and mathematics.

How it looks is for the renderers; nothing here knows a format.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from restitution.render.layout import Layout


@dataclass(frozen=True, slots=True)
class Named:
    """The name of a sphere, a wall or a point, which print sets in italics."""

    text: str


Piece: TypeAlias = str | Named | Layout
Words: TypeAlias = tuple[Piece, ...]
Sentence: TypeAlias = tuple[Piece, ...]


@dataclass(frozen=True)
class Paragraph:
    """Sentences that are told together."""

    sentences: tuple[Sentence, ...]


@dataclass(frozen=True)
class Listing:
    """Several things asked at one place, each with its number: (i), (ii), …

    ``lead`` are the words in front of all of them (``Find``), or nothing where each entry is a
    sentence of its own.
    """

    lead: Words
    entries: tuple[tuple[str, Words], ...]


Block: TypeAlias = Paragraph | Listing


@dataclass(frozen=True)
class QuestionPart:
    """A part: its label in the statement (None before the first), what it tells and asks."""

    label: str | None
    body: tuple[Block, ...]
    marks: int | None = None


@dataclass(frozen=True)
class Question:
    """A whole question. It shows itself in a terminal and in Jupyter.

    ``intro`` is what is told before anything is asked.
    """

    title: str | None
    intro: tuple[Sentence, ...]
    parts: tuple[QuestionPart, ...]

    def __str__(self) -> str:
        from restitution.wording.text import to_text

        return to_text(self)

    __repr__ = __str__

    def _repr_html_(self) -> str:
        from restitution.wording.html import to_fragment

        return to_fragment(self)

    def _repr_markdown_(self) -> str:
        from restitution.wording.markup import to_markdown

        return to_markdown(self)
