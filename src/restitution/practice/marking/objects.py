"""A marked working as an object of JSON: its fields, and what each holds."""

from __future__ import annotations

from typing import TypedDict


class LetterObject(TypedDict):
    """What a letter of the working stands for."""

    letter: str
    meaning: str
    """A quantity of the statement language."""
    words: str
    by: str
    """Who says so: it is declared, known from the question, or inferred."""


class MistakeOfLineObject(TypedDict):
    """The mistake that begins in a line."""

    id: str | None
    """Of a misconception; null where none is known to lead there."""
    variants: list[str]
    also: list[str]
    """Others that lead to the same line."""
    kind: str | None
    """``misconception``, ``slip`` or ``accuracy``."""
    at: str | None
    """The text at which it stands."""
    sure: bool
    leads_to: dict[str, str]
    """What comes of it, by what is asked."""


_JudgedBase = TypedDict("_JudgedBase", {"from": list[int]})


class JudgedLineObject(_JudgedBase):
    """A line of the working with its verdict; ``from`` numbers the lines it comes of."""

    n: int
    text: str
    read_as: str | None
    verdict: str
    accuracy: str | None
    principle: str | None
    event: int | None
    link: int | None
    """The place, from 0, of the link that fails."""
    mistake: MistakeOfLineObject | None


class AnswerMarkObject(TypedDict):
    """A value given for an item."""

    item: str
    value: str
    right: bool
    accuracy: str | None
    """How exactly it is right; null where it is not."""
    as_if: str | list[str] | None
    """The mistakes that lead to it: one name, a list of several, or null."""


_PointBase = TypedDict("_PointBase", {"for": str})


class PointObject(_PointBase):
    """A mark; ``for`` says for what it is given."""

    id: str
    kind: str
    state: str
    line: int | None
    why: str | None


class MarksObject(TypedDict):
    """The marks of a working."""

    earned: int
    lost: int
    open: int
    of: int
    points: list[PointObject]


class MessageObject(TypedDict):
    """What is told to who wrote the working."""

    line: int | None
    """Null for the whole."""
    level: int
    """Of hints, from 0 to 4."""
    text: str


class ProposalObject(TypedDict):
    """A meaning that would do."""

    meaning: str
    words: str


class AskObject(TypedDict):
    """A letter of which the meaning has to be known."""

    letter: str
    text: str
    proposals: list[ProposalObject]


class MarkingObject(TypedDict):
    """The marking of one part: the reply of ``api/mark``."""

    part: str | None
    letters: list[LetterObject]
    lines: list[JudgedLineObject]
    answers: list[AnswerMarkObject]
    marks: MarksObject
    messages: list[MessageObject]
    asks: list[AskObject]
    error: str | None


class PartsMarkedObject(TypedDict):
    """The same where a working opens several parts."""

    parts: list[MarkingObject]
