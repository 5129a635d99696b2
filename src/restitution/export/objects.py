"""The objects of JSON that other programs read: their fields, and what each holds.

`restitution.explaining.lines.stored` has those of a derivation,
`restitution.practice.marking.objects` those of a marked working.
"""

from __future__ import annotations

from typing import Any, Literal, TypedDict

from restitution.explaining.lines.stored import DerivationObject

# --- mistakes and cures ---------------------------------------------------------------------------


class EditObject(TypedDict):
    """A text in the place of what stands from line and column to the end, which is not in it."""

    line: int
    column: int
    end_line: int
    end_column: int
    text: str


class FixObject(TypedDict):
    """A cure: its edits do not overlap."""

    label: str
    """For a button."""
    edits: list[EditObject]


class ErrorObject(TypedDict):
    """What is wrong, and where."""

    kind: str
    """``syntax``, ``missing``, ``contradiction``, ``impossible``, ``unsupported``, ``time limit``;
    ``malformed`` of a request that cannot be understood."""
    message: str
    line: int | None
    column: int | None
    fixes: list[FixObject]


class TextNoteObject(TypedDict):
    """A warning that the text itself draws."""

    message: str
    line: int | None
    column: int | None
    fixes: list[FixObject]


# --- answers --------------------------------------------------------------------------------------


class AnswerObject(TypedDict):
    """One answer of an item."""

    solution: int | None
    """Which admissible solution it belongs to, from 1."""
    exact: str | list[str]
    """Plain SymPy, angles in radians; two texts for a vector, a point or a direction."""
    decimal: float | list[float] | None
    """Null where letters are left."""
    display: str
    """As people write it."""
    where: dict[str, str] | None
    """Where an extremum is reached."""
    condition: list[str]
    """Relations that all have to hold for the answer; empty where it always holds."""


class RejectedObject(TypedDict):
    """A value that is rejected."""

    exact: str | list[str]
    reason: str


class ItemObject(TypedDict):
    """What is asked, with its answers."""

    line: int | None
    text: str
    kind: str
    """``value``, ``vector``, ``point``, ``direction``, ``range``, ``extremum`` or ``show``."""
    unit: str | None
    """Of the values; null where they have none, or letters hold it."""
    answers: list[AnswerObject]
    holds: bool | None
    """Of a ``show``: whether it is true."""
    proof: str | None
    """What the verdict rests on; ``undecided`` where nothing is proved."""
    trials: int
    """The points at which a claim was tried."""
    counterexample: dict[str, str] | None
    rejected: list[RejectedObject]
    error: ErrorObject | None


class PartObject(TypedDict):
    """A part of a question."""

    part: str | None
    """Its label; null before the first."""
    items: list[ItemObject]


class WorkedPartObject(PartObject):
    """A part with its working."""

    derivation: DerivationObject | None
    """Null where the working could not be made."""


class SolvedObject(TypedDict):
    """A solved statement: the reply of ``api/solve``."""

    file: str
    title: str | None
    parts: list[PartObject]
    warnings: list[str]
    notes: list[TextNoteObject]
    error: ErrorObject | None
    """Why nothing could be answered at all."""


class WorkedObject(TypedDict):
    """The same with ``"working": true``."""

    file: str
    title: str | None
    parts: list[WorkedPartObject]
    warnings: list[str]
    notes: list[TextNoteObject]
    error: ErrorObject | None


class CheckedObject(SolvedObject):
    """A statement that was read and not solved: the reply of ``api/check``."""

    errors: list[ErrorObject]
    """All mistakes of the text."""


class FailedObject(TypedDict):
    """The reply to a request that has no result, or cannot be understood."""

    error: ErrorObject


# --- in an altered world --------------------------------------------------------------------------


class AlteredItemObject(ItemObject):
    """What an item comes to in an altered world."""

    part: str | None


class AlteredWorldObject(TypedDict):
    """What one variant of a mistake changes."""

    id: str
    words: str
    events: list[int]
    items: list[AlteredItemObject]


class MistakeObject(TypedDict):
    """A mistake, and what it leads to."""

    id: str
    title: str
    sentence: str
    consequence: str
    worlds: list[AlteredWorldObject]


_AlteredBase = TypedDict("_AlteredBase", {"as": MistakeObject})


class AlteredObject(SolvedObject, _AlteredBase):
    """A solved statement beside its answers in an altered world: ``solve --as``."""


# --- in pieces ------------------------------------------------------------------------------------


class VelocityObject(TypedDict, total=False):
    """A velocity as it is stated, expressions as text; it has the fields of its ``way``."""

    way: Literal["rest", "components", "polar", "vector"]
    x: str | None
    """Of ``components``."""
    y: str | None
    size: str | None
    """Of ``polar``: the speed."""
    angle: str | None
    origin: str | None
    """From where the angle is measured; null for **i**."""
    wall: str | None
    """The wall with which the angle is made."""
    text: str | None
    """Of ``polar`` and ``vector``: the whole."""


class DirectionObject(TypedDict):
    """A direction as it is stated."""

    way: str
    """``i``, ``j``, ``angle`` or ``vector``."""
    text: str | None


class SphereObject(TypedDict):
    """A sphere."""

    name: str
    line: int | None
    mass: str | None
    radius: str | None
    placed: bool
    """Whether it has a position."""
    velocity: VelocityObject | None


class WallObject(TypedDict):
    """A wall."""

    name: str
    line: int | None
    along: DirectionObject | None
    placed: bool


class AskedObject(TypedDict):
    """An item that is asked."""

    text: str
    staged: str
    """The same with every stage as a number."""
    value: str | None
    percentage: bool


class RelationOutline(TypedDict, total=False):
    """A relation; one of two sides has these too."""

    text: str
    staged: str | None
    """The same with every stage as a number; null where that cannot be."""
    left: str | None
    sign: str
    right: str


class StepOutline(TypedDict, total=False):
    """A step; beside ``kind``, ``part``, ``line`` and ``after`` it has the fields of its kind."""

    kind: str
    part: str | None
    line: int | None
    after: int
    """The number of events that it comes after."""
    first: str
    """Of an ``impact``."""
    second: str
    e: str | None
    along: DirectionObject | None
    offset: str | None
    letters: str | None
    """Of ``unknown``."""
    relations: list[RelationOutline]
    """Of ``given`` and ``show``."""
    subject: str | None
    """Of ``show``: what is to be shown in terms of letters."""
    items: list[AskedObject]
    """Of ``find``."""
    in_terms_of: str | None


class OutlineObject(TypedDict):
    """A statement in the pieces of which a form is made."""

    title: str | None
    parts: list[str | None]
    spheres: list[SphereObject]
    walls: list[WallObject]
    points: list[str]
    steps: list[StepOutline]


class OutlinedObject(TypedDict):
    """The reply of ``api/outline``."""

    outline: OutlineObject | None
    errors: list[ErrorObject]


# --- pictures and pages ---------------------------------------------------------------------------


class PictureObject(TypedDict):
    """A picture."""

    event: int | None
    """Null for a plan of the whole."""
    title: str
    description: str
    svg: str


class PicturesObject(TypedDict):
    """Pictures, or why there are none."""

    pictures: list[PictureObject]
    pictures_error: str | None


class DrawnObject(SolvedObject, PicturesObject):
    """A solved statement with its pictures: the reply of ``api/draw``."""


class RejectedContent(TypedDict):
    """A value that is rejected, as a page shows it."""

    value: Any
    """A tree."""
    reason: str


class AnswersContent(TypedDict):
    """The answers of an item, as a page shows them."""

    item: Any
    """A tree."""
    values: list[Any]
    """Trees."""
    unit: str | None
    equal: bool
    """Whether an equals sign stands before the values."""
    holds: bool | None
    undecided: bool
    counterexample: list[Any] | None
    """Trees."""
    error: str | None
    rejected: list[RejectedContent]


class RowContent(TypedDict):
    """A row of a step."""

    row: Any
    """A tree, or a list of several where the line is long."""
    mark: str


class StepContent(TypedDict):
    """A step of a working, as a page shows it."""

    kind: str
    principle: str | None
    sign: str
    about: Any
    said: Any
    """A tree, or null."""
    mark: str
    event: int | None
    item: int | None
    rows: list[RowContent]


class PartContent(TypedDict):
    """The working of a part, as a page shows it."""

    label: str | None
    marks: int
    asked: list[str]
    answers: list[AnswersContent]
    steps: list[StepContent]


class PageContent(TypedDict):
    """All that a page shows beside the answers."""

    question: Any
    """A tree, or null."""
    pictures: list[PictureObject]
    pictures_error: str | None
    figure: PictureObject | None
    """What the question tells, and nothing of its answers."""
    working: list[PartContent]
    working_error: str | None
    latex: str | None
    motion: dict[str, Any] | None
    """Data of the player."""
    motion_error: str | None
    warnings: list[str]


class ExplainedObject(PageContent):
    """The reply of ``api/explain``."""

    answer: SolvedObject
