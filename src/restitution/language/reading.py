"""The text of a statement to a Problem."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import field, replace
from fractions import Fraction
from functools import cache, partial
from itertools import chain, islice
from os import PathLike
from pathlib import Path
from typing import Any

from lark import Lark, Token

from restitution.errors import StatementError
from restitution.expression.lexer import scan
from restitution.expression.limits import (
    MAX_BODIES,
    MAX_ERRORS,
    MAX_EVENTS,
    MAX_TEXT_BYTES,
)
from restitution.expression.parsers import make_parser
from restitution.expression.reading import (
    Reading,
    parse_tokens,
)
from restitution.expression.tree import Number, Pair, Place
from restitution.language.builders import LINES, PROPERTY, Declaration, error_at, place_of
from restitution.language.checking import mistakes as mistakes_of
from restitution.language.cures import MistakeWithin, cured
from restitution.language.doubts import degrees_without_sign, doubts
from restitution.language.grammar import STATEMENT
from restitution.language.lines import LogicalLine, declared_names, decode, logical_lines
from restitution.language.measuring import in_si
from restitution.language.plain_walls import with_plain_walls
from restitution.language.prose import in_words, is_in_words, is_of_the_language
from restitution.language.slips import with_guess
from restitution.mending import Note, mended
from restitution.problem import (
    Event,
    Part,
    Point,
    Problem,
    Sphere,
    Step,
    Wall,
)
from restitution.records import dataclass

_BODIES: Mapping[str, Any] = {
    "sphere": Sphere,
    "wall": Wall,
    "point": lambda name: Point(name, Pair(Number(Fraction(0)), Number(Fraction(0)))),
}
_CURED = 5  # mistakes in what lines say for which cures are sought
_LABELLED = re.compile(r"\s*part\s+\(?\w{1,3}[).:]*(?P<gap>[\s:,]+)(?=[A-Za-z]{2})")
_LABEL = re.compile(r"\(?([^\W_](?:[\w.'-]*\w)?)\)?:?")


def read(path: str | PathLike[str]) -> Problem:
    """The problem that a file states.

    Raises StatementError, with line and column, for a mistake in the text, and OSError where
    the file cannot be read.
    """
    with Path(path).open("rb") as file:
        return parse(file.read(MAX_TEXT_BYTES + 1))


def parse(text: str | bytes) -> Problem:
    """The problem that a text states; bytes are UTF-8.

    Raises StatementError for the first mistake, with its line and column; further ones are
    its ``others``.

    >>> parse("sphere P: velocity 3i").spheres[0].name
    'P'
    """
    problem, mistakes = _read_through(decode(text))
    if problem is not None:
        return problem
    first = mistakes[0]
    first.others = (*mistakes[1:], *first.others)
    raise first


def _read_through(text: str) -> tuple[Problem | None, list[StatementError]]:
    """The problem of a text, or the mistakes in it, each with what cures it."""
    lines = list(logical_lines(text))
    story = _Story(declared_names(lines))
    within = partial(_mistake_within, {})
    wrong: list[tuple[LogicalLine, StatementError]] = []
    prose: list[LogicalLine] = []
    for line in lines:
        if len(wrong) + len(prose) >= MAX_ERRORS:
            if prose and is_in_words(line, story.bodies):
                prose.append(line)
            continue
        try:
            _tell(story, line)
        except StatementError as mistake:
            cured(text, line, mistake, _first_mistake, within)
            if not mistake.fixes and is_in_words(line, story.bodies):
                prose.append(line)
                continue
            wrong.append((line, mistake))
    if wrong or prose:
        return None, _without_copies(_distinct(text, wrong, prose, story, within))
    problem, mistakes = _checked(story)
    if not mistakes:
        # Of two spheres of one line the same is read once.
        notes = tuple(dict.fromkeys((*story.notes, *doubts(problem, text))))
        return replace(with_plain_walls(problem), notes=notes), []
    for number, met in enumerate(mistakes):
        if number >= _CURED:
            met.fixes = ()  # each cure costs readings of the whole
        elif met.line is not None:
            line = _line_of(lines, met.line)
            met = _with_a_guess(met, line, story)
            mistakes[number] = cured(text, line, met, _first_mistake, within)
    return None, _without_copies(mistakes)


def _without_copies(mistakes: list[StatementError]) -> list[StatementError]:
    """Mistakes without what was told before: a name that no line declares is told once."""
    first: list[StatementError] = []
    for mistake in mistakes:
        a_name = "unknown name" in mistake.message and "did you mean" not in mistake.message
        if not (a_name and any(other.message == mistake.message for other in first)):
            first.append(mistake)
    return first


def _distinct(
    text: str,
    wrong: list[tuple[LogicalLine, StatementError]],
    prose: list[LogicalLine],
    story: _Story,
    within: MistakeWithin,
) -> list[StatementError]:
    """The mistakes in lines, without those that come of others.

    Lines in words are one mistake together. A mistake that the cure of another line mends as well,
    as a name does that is written with a capital, is not told.
    """
    if prose:
        beside = [line for line, _ in wrong if not is_of_the_language(line, story.bodies)]
        wrong = [(line, mistake) for line, mistake in wrong if line not in beside]
        together = sorted((*prose, *beside), key=lambda line: line.source.pieces[0][1])
        wrong = [*wrong, (together[0], in_words(together))]
        wrong.sort(key=lambda pair: pair[0].source.pieces[0][1])
    mistakes: list[StatementError] = []
    mended_besides: set[int] = set()
    for line, mistake in wrong:
        if line.source.pieces[0][1] in mended_besides:
            continue
        mistakes.append(mistake)
        if len(mistake.fixes) == 1:
            cure = mistake.fixes[0]
            rows = {edit.line for edit in cure.edits}
            if len(rows) > 1:
                then = mended(text, cure)
                mended_besides |= {row for row in rows if within(then, row, row) is None}
    return mistakes


def _line_of(lines: list[LogicalLine], number: int) -> LogicalLine:
    """The logical line that holds a line of the text."""
    return [line for line in lines if line.source.pieces[0][1] <= number][-1]


def _with_a_guess(mistake: StatementError, line: LogicalLine, story: _Story) -> StatementError:
    """A mistake in what a line says, with what was probably meant if it has no cure of its own."""
    if mistake.fixes:
        return mistake
    return with_guess(line.source, line.word, mistake, story.names)


def _checked(story: _Story, broken: int = 0) -> tuple[Problem, list[StatementError]]:
    """The problem that a story is, in SI, and the mistakes in what its lines say.

    ``broken`` lines besides could not be read; any of them may tell an event.
    """
    problem = story.problem()
    if story.has_units:
        try:
            problem, notes = in_si(problem, frozenset(story.names))
        except StatementError as first:
            others = first.others
            first.others = ()
            return problem, [first, *others]
        story.notes.extend(notes)
    return problem, list(islice(mistakes_of(problem, broken), MAX_ERRORS if not broken else None))


_Shelf = dict[tuple[LogicalLine, tuple[tuple[str, str], ...], int], "tuple[Reading, Any] | None"]


def _mistake_within(shelf: _Shelf, text: str, first: int, last: int) -> StatementError | None:
    """The first mistake in some lines of a text, whatever there is in its other lines.

    The ``shelf`` keeps what those others say, None where they cannot be read: cure after cure is
    tried on one of many lines.
    """
    lines = list(logical_lines(text))
    story = _Story(declared_names(lines))
    broken = 0
    names = tuple(story.names.items())
    for line in lines:
        here = first <= line.source.pieces[0][1] <= last
        key = (line, names, story.events)
        try:
            if here or line.word in ("title", "part"):
                _tell(story, line)
                continue
            if key not in shelf:
                shelf[key] = None
                shelf[key] = _understood(line, story.names, story.events)
            understood = shelf[key]
            if understood is not None:
                _add(story, line, *understood)
            else:
                broken += 1
        except StatementError as mistake:
            if here:
                return mistake
            broken += 1
    for name, kind in story.names.items():
        story.bodies.setdefault(name, _BODIES[kind](name))
    problem, mistakes = _checked(story, broken)
    for met in mistakes:
        if met.line is not None and first <= met.line <= last:
            return _with_a_guess(met, _line_of(lines, met.line), story)
    # What is probably a slip has no answer, or another one.
    without_a_sign = (note for note in degrees_without_sign(problem, text) if note.fixes)
    for note in chain(story.doubts, without_a_sign):
        if note.line is not None and first <= note.line <= last:
            doubt = StatementError(note.message, note.line, note.column)
            doubt.fixes = note.fixes
            return doubt
    return None


def _first_mistake(line: LogicalLine, names: Mapping[str, str]) -> StatementError | None:
    """The mistake in a line by itself, or None where it reads."""
    if line.word in ("title", "part"):
        return None
    try:
        _understood(line, names)
    except StatementError as mistake:
        return mistake
    return None


@cache
def statement_parser() -> Lark:
    """The parser of lines, made at first use."""
    return make_parser(STATEMENT, "line")


@dataclass
class _Story:
    """The statement as far as it is read. It lives only while ``parse`` runs."""

    names: Mapping[str, str]
    title: str | None = None
    bodies: dict[str, Sphere | Wall | Point] = field(default_factory=dict)
    declared: dict[tuple[str, str], int] = field(default_factory=dict)
    parts: list[tuple[str | None, Place | None, list[Step]]] = field(
        default_factory=lambda: [(None, None, [])]
    )
    events: int = 0
    notes: list[Note] = field(default_factory=list)
    doubts: list[Note] = field(default_factory=list)
    has_units: bool = False

    def problem(self) -> Problem:
        """The problem, as a value."""
        bodies = self.bodies.values()
        return Problem(
            title=self.title,
            spheres=tuple(body for body in bodies if isinstance(body, Sphere)),
            walls=tuple(body for body in bodies if isinstance(body, Wall)),
            points=tuple(body for body in bodies if isinstance(body, Point)),
            parts=tuple(
                Part(label, tuple(steps), place=place) for label, place, steps in self.parts
            ),
        )


def _tell(story: _Story, line: LogicalLine) -> None:
    """Adds one line to the story."""
    place = line.source.place(line.start)
    if line.word == "title":
        _tell_title(story, line, place)
        return
    if line.word == "part":
        _tell_part(story, line, place)
        return
    _add(story, line, *_understood(line, story.names, story.events))


def _add(story: _Story, line: LogicalLine, reading: Reading, value: Any) -> None:
    """Adds what a line says to the story."""
    place = line.source.place(line.start)
    story.notes.extend((*reading.scan.warnings, *reading.warnings))
    story.doubts.extend(reading.warnings)
    story.has_units |= any(token.type == "MEASURE" for token in reading.scan.tokens)
    if isinstance(value, Declaration):
        for name in value.names:
            _declare(story, value, name)
        if len(story.bodies) > MAX_BODIES:
            raise StatementError(
                f"a statement has at most {MAX_BODIES} spheres, walls and points",
                place.line,
                place.column,
            )
        return
    if isinstance(value, Event):
        story.events += 1
        if story.events > MAX_EVENTS:
            raise StatementError(
                f"a statement tells at most {MAX_EVENTS} events", place.line, place.column
            )
    story.parts[-1][2].append(value)


def _understood(
    line: LogicalLine, names: Mapping[str, str], events: int = 0
) -> tuple[Reading, Any]:
    """A line read by itself, and what it says. Raises StatementError with what was meant."""
    try:
        reading = Reading(scan(line.source, names), events)
        return reading, parse_tokens(statement_parser(), reading, LINES).value
    except StatementError as mistake:
        raise with_guess(line.source, line.word, mistake, names) from None


def _tell_title(story: _Story, line: LogicalLine, place: Place) -> None:
    title = line.rest.strip()
    if story.title is not None:
        raise StatementError("the statement has a title already", place.line, place.column)
    if not title:
        raise StatementError("expected a text after 'title'", place.line, place.column)
    for offset, character in enumerate(line.source.text):
        if not character.isprintable() and not character.isspace():
            raise line.source.error(f"unexpected character U+{ord(character):04X}", offset)
    story.title = " ".join(title.split())


def _tell_part(story: _Story, line: LogicalLine, place: Place) -> None:
    text = line.rest.strip()
    match = _LABEL.fullmatch(text)
    if not match:
        message = "expected one word as a label after 'part'" + (
            f", not '{text[:40]}'" if text else ""
        )
        mistake = StatementError(message, place.line, place.column)
        labelled = _LABELLED.match(line.source.text)
        if labelled is not None:
            mistake.fixes = (line.source.fix(*labelled.span("gap"), "\n", "Begin a line"),)
        raise mistake
    label = match.group(1)
    if any(label == known for known, _, _ in story.parts):
        raise StatementError(f"there is a part '{label}' already", place.line, place.column)
    story.parts.append((label, place, []))


def _declare(story: _Story, declaration: Declaration, token: Token) -> None:
    """Adds what a line says of one body to what is known of it."""
    name, place = str(token), place_of(token)
    known = story.names.get(name)
    if known != declaration.kind:
        raise error_at(f"'{name}' is the name of a {known} already", place)
    body = story.bodies.get(name)
    if body is None:
        match declaration.kind:
            case "sphere":
                body = Sphere(name, place=place)
            case "wall":
                body = Wall(name, place=place)
            case _:
                body = Point(name, None, place=place)
    changes: dict[str, Any] = {}
    for key, value, where in declaration.properties:
        line = story.declared.get((name, key))
        if line is not None:
            raise error_at(
                f"the {PROPERTY[key]} of {name} was given already, in line {line}", where
            )
        story.declared[name, key] = where.line
        changes[key] = value
    story.bodies[name] = replace(body, **changes)
