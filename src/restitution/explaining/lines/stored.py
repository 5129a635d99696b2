"""A derivation as an object of JSON: its fields, and what each holds."""

from __future__ import annotations

from typing import TypedDict

from restitution.explaining.lines.derivation import EventKind, FactKind, MoveId, NoteKind, Showing
from restitution.explaining.lines.marks import MarkKind


class RelationObject(TypedDict):
    """What a line, a fact or an answer says."""

    text: str
    """In the notation of statements, by which it is read again."""
    latex: str
    mathml: str


class MoveObject(TypedDict):
    """What a line does with what it cites."""

    move: MoveId
    record: str | None
    """The id of the principle, definition or identity that it uses."""
    event: int | None
    bodies: list[str]
    eliminated: str | None


class MarkObject(TypedDict):
    """A mark on a line."""

    mark: str
    """As it is printed, such as ``dM1`` or ``A1*``."""
    kind: MarkKind
    number: int
    dependent: bool
    star: bool
    ft: bool
    because: str
    on: list[int]
    """The lines on whose marks it depends."""


class EventObject(TypedDict):
    """An event: an impact, a blow, an arrival."""

    n: int
    kind: EventKind
    bodies: list[str]
    wall: bool
    """Whether the second body is a wall."""


class FactObject(RelationObject):
    """What the statement gives."""

    id: str
    kind: FactKind
    part: str | None
    """The part that alone is given it; null where all are."""
    place: list[int] | None
    """Line and column in the statement."""


class LineObject(RelationObject, MoveObject):
    """A line of the working."""

    n: int
    item: str | None
    """The item under which it stands."""
    premises: list[int | str]
    """Numbers of lines, ids of facts, and what is known of letters, such as ``e <= 1``."""
    marks: list[MarkObject]
    shown: Showing
    """Whether it is printed by itself, within another line, or not at all."""


class ItemEndObject(RelationObject):
    """The line that answers an item."""

    item: str
    line: int
    part: str | None
    printed: bool
    """Whether the answer is printed in the question, which asks to show it."""
    case: int | None


class CaseObject(TypedDict):
    """The lines that stand under one of several alternatives."""

    n: int
    line: int
    """The line of alternatives."""
    option: int
    lines: list[int]


class RouteObject(TypedDict):
    """The principles of another way to an item."""

    item: str
    moves: list[MoveObject]


class DerivationNoteObject(TypedDict):
    """Why an item has no line that answers it."""

    item: str
    kind: NoteKind
    place: int
    part: str | None
    reason: str
    premises: list[int | str]
    """What cannot all hold."""
    claim: RelationObject | None
    """What is not true in general."""
    instance: list[RelationObject]
    """Values of letters for which it is false."""
    sides: list[RelationObject]
    """The sides of the claim for these."""
    marks: list[MarkObject]


class DerivationObject(TypedDict):
    """The working of a part."""

    version: int
    names: dict[str, str]
    """The bodies and points of which lines speak: ``sphere``, ``wall`` or ``body``."""
    events: list[EventObject]
    facts: list[FactObject]
    lines: list[LineObject]
    items: list[ItemEndObject]
    cases: list[CaseObject]
    others: list[RouteObject]
    notes: list[DerivationNoteObject]
