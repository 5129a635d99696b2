"""An exam-style question as a value: sentences made of words, names and mathematics.

How it looks is for the renderers; nothing here knows a format.
"""

from __future__ import annotations

from typing import TypeAlias

from restitution.records import dataclass
from restitution.render.document import Emphasis, Piece, Words

Sentence: TypeAlias = Words


@dataclass(frozen=True)
class Paragraph:
    """Sentences that are told together."""

    sentences: tuple[Sentence, ...]


@dataclass(frozen=True)
class Entry:
    """What is asked in one entry of a list: its number, its words, how many items it stands for.

    The number is empty where only one thing is asked.
    """

    number: str
    words: Words
    items: int = 1


@dataclass(frozen=True)
class Listing:
    """What is asked at one place, each entry with its number: (i), (ii), …

    ``lead`` are the words in front of all entries (``Find``), or nothing where each is a sentence
    of its own.
    """

    lead: Words
    entries: tuple[Entry, ...]

    def rows(self) -> tuple[tuple[str, Words], ...]:
        """The entries with the commas and the full stop that a lead asks for."""
        words = [entry.words for entry in self.entries]
        if self.lead:
            *front, last = words
            words = [*((*phrase, ",") for phrase in front), (*last, ".")]
        return tuple((entry.number, own) for entry, own in zip(self.entries, words, strict=True))


Block: TypeAlias = Paragraph | Listing


@dataclass(frozen=True)
class QuestionPart:
    """A part: its label in the statement (None before the first), what it tells and asks."""

    label: str | None
    body: tuple[Block, ...]
    marks: int | None = None

    def flow(self) -> tuple[Block, ...]:
        """The body as it is set: within a labelled part, one thing asked ends the paragraph."""
        if self.label is None:
            return self.body
        out: list[Block] = []
        for block in self.body:
            last = out[-1] if out else None
            if isinstance(block, Listing) and not block.lead and isinstance(last, Paragraph):
                only, *others = block.entries
                if not only.number and not others:
                    out[-1] = Paragraph((*last.sentences, only.words))
                    continue
            out.append(block)
        return tuple(out)


@dataclass(frozen=True)
class QuestionContent:
    """What a whole question holds: a title, what comes before anything is asked, and parts."""

    title: str | None
    intro: tuple[Sentence, ...]
    parts: tuple[QuestionPart, ...]


__all__ = [
    "Block",
    "Emphasis",
    "Entry",
    "Listing",
    "Paragraph",
    "Piece",
    "QuestionContent",
    "QuestionPart",
    "Sentence",
    "Words",
]
