"""Questions on sheets of A4: wording, a figure, room for working, and worked solutions.

A sheet is made in two steps. `entry` sets a solved problem as blocks of a document, in the process
that has solved it; `to_document` puts entries together, and needs no algebra for it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from restitution.records import dataclass
from restitution.render.document import (
    Block,
    Document,
    Heading,
    Inset,
    NewPage,
    Numbered,
    Picture,
    Room,
    Together,
)
from restitution.render.typst import NAME

if TYPE_CHECKING:
    from restitution.explaining.lines.marks import Style
    from restitution.solving.equations.solution import Solution
    from restitution.wording import Question, QuestionPart

DEFAULT_TITLE = "Oblique impacts"
_MOST = 200.0  # millimetres of room that are given unasked: nearly a page
FIGURE = 84
"""Width of a figure, in millimetres."""


@dataclass(frozen=True)
class Options:
    """What a sheet holds beside its questions.

    ``space`` is the room for working after each part, in centimetres; None gives a centimetre for
    each mark, and nothing where the solutions or the mark scheme stand behind. ``marks`` is the
    style of marks; in the style ``"none"`` there are none to be seen, and as much room as in
    ``"fm1"``. ``scheme`` sets the mark scheme behind.
    """

    solutions: bool = False
    diagrams: bool = True
    space: float | None = None
    marks: Style = "fm1"
    scheme: bool = False


@dataclass(frozen=True)
class Entry:
    """One question of a sheet: ``room`` is that for the working of its last part.

    Its parts have theirs between them. Behind all questions stand the ``working`` and the
    ``scheme``, the mark scheme, where they are wanted.
    """

    title: str | None
    question: tuple[Block, ...]
    room: Room
    working: tuple[Block, ...] = ()
    scheme: tuple[Block, ...] = ()


def entry(solution: Solution, options: Options) -> Entry:
    """A solved problem as it stands on a sheet.

    Raises RestitutionError where the problem cannot be worded or explained.
    """
    from restitution.wording import question
    from restitution.workings import explain, illustrated
    from restitution.workings.rendering.document import document_of

    explanation = explain(solution, marks="fm1" if options.marks == "none" else options.marks)
    marks = {part.label: part.marks for part in explanation.parts if part.marks}
    asked = replace(question(solution.problem, marks=marks), title=None)
    rooms = [_room(part, options) for part in asked.parts]
    if options.marks == "none":
        explanation = explanation.without_marks()
        asked = replace(asked, parts=tuple(replace(part, marks=None) for part in asked.parts))
    explained = replace(explanation, title=None)
    if options.diagrams and options.solutions:
        explained = illustrated(explained)
    figure = _figure(solution) if options.diagrams else []
    return Entry(
        solution.problem.title,
        tuple(_question(asked, figure, rooms)),
        rooms[-1] if rooms else Room(0),
        (Inset(document_of(explained)),) if options.solutions else (),
        tuple(_scheme(solution, options)),
    )


def _scheme(solution: Solution, options: Options) -> Iterator[Block]:
    """The mark scheme as a table, where it is wanted."""
    if options.scheme:
        from restitution.export.mark_scheme import to_table
        from restitution.practice.marking.mark_scheme import mark_scheme

        yield to_table(mark_scheme(solution, "fm1" if options.marks == "none" else options.marks))


def _figure(solution: Solution) -> list[Block]:
    """The situation before the first impact."""
    from restitution.drawing import figure
    from restitution.drawing.svg import to_svg

    scene = figure(solution)
    return [] if scene is None else [Picture(to_svg(scene), FIGURE)]


def _room(part: QuestionPart, options: Options) -> Room:
    """Room for the working of a part: ten millimetres for a mark."""
    if options.space is not None:
        return Room(10 * options.space)
    return Room(0.0 if options.solutions else min(10 * float(part.marks or 0), _MOST))


def _question(question: Question, figure: list[Block], rooms: Sequence[Room]) -> Iterator[Block]:
    """What is told with the figure and the first part, and the others, with room between them."""
    from restitution.wording import document

    parts = [*map(document.part, question.parts)]
    yield _inset([*document.opening(question), *figure, *parts[:1]])
    for room, part in zip(rooms, parts[1:], strict=False):
        yield from (room, _inset([part]))


def _inset(blocks: Iterable[Block]) -> Block:
    """A piece of a question, on one page if it is short."""
    return Inset(Document("", (Together(tuple(blocks)),), kind="question"))


def to_document(entries: Sequence[Entry | None], title: str | None, options: Options) -> Document:
    """The sheet: all questions, and behind them all workings or mark schemes.

    None stands for a question that is left out: the others keep their numbers.
    """
    numbered = [(number, item) for number, item in enumerate(entries, 1) if item is not None]
    alone = numbered[0][1].title if len(entries) == 1 and numbered else None
    named = title or alone or DEFAULT_TITLE
    close = options.scheme and options.space is None  # nobody writes on it
    blocks: list[Block] = []
    for number, item in numbered:
        asked = item.question
        if close:
            asked = tuple(block for block in asked if not isinstance(block, Room))
        blocks.append(_numbered(number, item, asked, named, len(entries)))
        # What is left of the last page is room enough, whatever it is.
        blocks += [] if close or number == len(entries) else [item.room]
    behind = [
        ("Solutions", options.solutions, [item.working for _, item in numbered]),
        ("Mark scheme", options.scheme, [item.scheme for _, item in numbered]),
    ]
    for heading, wanted, contents in behind:
        if wanted:
            blocks += [NewPage(), Heading(heading, 1)]
            blocks += [
                _numbered(number, item, content, named, len(entries))
                for (number, item), content in zip(numbered, contents, strict=True)
            ]
    head = "" if options.solutions or options.scheme else NAME
    return Document(named, tuple(blocks), head, "sheet")


def _numbered(
    number: int, entry: Entry, blocks: tuple[Block, ...], sheet: str, count: int
) -> Numbered:
    """Blocks of a question behind its number; the title of the only one may be the sheet's."""
    title = "" if entry.title is None or (count == 1 and entry.title == sheet) else entry.title
    return Numbered(number, title, blocks)
