"""The text of a statement to a Problem."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cache, partial
from itertools import chain, islice, pairwise
from os import PathLike
from pathlib import Path
from typing import Any

from lark import Lark, Token, Tree

from restitution.errors import StatementError
from restitution.expression.dimensions import NONE
from restitution.expression.lexer import scan
from restitution.expression.limits import (
    MAX_BODIES,
    MAX_ERRORS,
    MAX_EVENTS,
    MAX_TEXT_BYTES,
)
from restitution.expression.parsers import make_parser
from restitution.expression.quantities import dimension_of_any
from restitution.expression.reading import (
    BUILDERS,
    Builder,
    Reading,
    Span,
    parse_tokens,
)
from restitution.expression.tree import Expression, Name, Number, Pair, Place, Quantity
from restitution.expression.units import NAMES
from restitution.expression.writing import write_expression
from restitution.language.checking import mistakes as mistakes_of
from restitution.language.cures import MistakeWithin, cured
from restitution.language.doubts import degrees_without_sign, doubts
from restitution.language.grammar import STATEMENT
from restitution.language.lines import Line, declared_names, decode, logical_lines
from restitution.language.measuring import in_si
from restitution.language.prose import in_words, is_in_words, is_of_the_language
from restitution.language.slips import with_guess
from restitution.mending import Fix, Note, mended
from restitution.problem import (
    Aligned,
    Arrival,
    AtRest,
    Compare,
    Event,
    Extremum,
    Find,
    Given,
    Impact,
    Kick,
    Let,
    Meets,
    Part,
    Point,
    Problem,
    Range,
    Relation,
    Show,
    Sphere,
    Step,
    Unknown,
    Value,
    Wall,
)

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
    wrong: list[tuple[Line, StatementError]] = []
    prose: list[Line] = []
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
        return None, _one_of_each(_distinct(text, wrong, prose, story, within))
    problem, mistakes = _checked(story)
    if not mistakes:
        return replace(problem, notes=(*story.notes, *doubts(problem, text))), []
    for number, met in enumerate(mistakes):
        if number >= _CURED:
            met.fixes = ()  # each cure costs readings of the whole
        elif met.line is not None:
            line = _line_of(lines, met.line)
            met = _with_a_guess(met, line, story)
            mistakes[number] = cured(text, line, met, _first_mistake, within)
    return None, _one_of_each(mistakes)


def _one_of_each(mistakes: list[StatementError]) -> list[StatementError]:
    """Mistakes without what was told before: a name that no line declares is told once."""
    first: list[StatementError] = []
    for mistake in mistakes:
        a_name = "unknown name" in mistake.message and "did you mean" not in mistake.message
        if not (a_name and any(other.message == mistake.message for other in first)):
            first.append(mistake)
    return first


def _distinct(
    text: str,
    wrong: list[tuple[Line, StatementError]],
    prose: list[Line],
    story: _Story,
    within: MistakeWithin,
) -> list[StatementError]:
    """The mistakes in lines, without those that come of others.

    Lines in words are one mistake together. A mistake that the cure of another line mends as well,
    as a name does that is written with a capital, is not told.
    """
    if prose:
        beside = [line for line, _ in wrong if not is_of_the_language(line, story.bodies)]
        wrong = [(line, each) for line, each in wrong if line not in beside]
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


def _line_of(lines: list[Line], number: int) -> Line:
    """The logical line that holds a line of the text."""
    return [line for line in lines if line.source.pieces[0][1] <= number][-1]


def _with_a_guess(mistake: StatementError, line: Line, story: _Story) -> StatementError:
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


_Shelf = dict[tuple[Line, tuple[tuple[str, str], ...], int], "tuple[Reading, Any] | None"]


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


def _first_mistake(line: Line, names: Mapping[str, str]) -> StatementError | None:
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


@dataclass(frozen=True)
class _Declaration:
    """What a line says of bodies: of which, and which properties."""

    kind: str
    names: tuple[Token, ...]
    properties: tuple[tuple[str, Any, Place], ...]


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


def _tell(story: _Story, line: Line) -> None:
    """Add one line to the story."""
    place = line.source.place(line.start)
    if line.word == "title":
        _tell_title(story, line, place)
        return
    if line.word == "part":
        _tell_part(story, line, place)
        return
    _add(story, line, *_understood(line, story.names, story.events))


def _add(story: _Story, line: Line, reading: Reading, value: Any) -> None:
    """Add what a line says to the story."""
    place = line.source.place(line.start)
    story.notes.extend((*reading.scan.warnings, *reading.warnings))
    story.doubts.extend(reading.warnings)
    story.has_units |= any(token.type == "MEASURE" for token in reading.scan.tokens)
    if isinstance(value, _Declaration):
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


def _understood(line: Line, names: Mapping[str, str], events: int = 0) -> tuple[Reading, Any]:
    """A line read by itself, and what it says. Raises StatementError with what was meant."""
    try:
        reading = Reading(scan(line.source, names), events)
        return reading, parse_tokens(statement_parser(), reading, _BUILDERS).value
    except StatementError as mistake:
        raise with_guess(line.source, line.word, mistake, names) from None


def _tell_title(story: _Story, line: Line, place: Place) -> None:
    title = line.rest.strip()
    if story.title is not None:
        raise StatementError("the statement has a title already", place.line, place.column)
    if not title:
        raise StatementError("expected a text after 'title'", place.line, place.column)
    for offset, character in enumerate(line.source.text):
        if not character.isprintable() and not character.isspace():
            raise line.source.error(f"unexpected character U+{ord(character):04X}", offset)
    story.title = " ".join(title.split())


def _tell_part(story: _Story, line: Line, place: Place) -> None:
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


# --- bodies -----------------------------------------------------------------------------------

_SPHERE_FIELDS = {
    "MASS": "mass",
    "VELOCITY": "velocity",
    "AT_REST": "velocity",
    "AT": "position",
    "RADIUS": "radius",
}
_WALL_FIELDS = {"ALONG": "along", "THROUGH": "through", "RADIUS": "radius"}


def _declare(story: _Story, declaration: _Declaration, token: Token) -> None:
    """Add what a line says of one body to what is known of it."""
    name, place = str(token), _place(token)
    known = story.names.get(name)
    if known != declaration.kind:
        raise _error(f"'{name}' is the name of a {known} already", place)
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
            raise _error(f"the {_PROPERTY[key]} of {name} was given already, in line {line}", where)
        story.declared[name, key] = where.line
        changes[key] = value
    story.bodies[name] = replace(body, **changes)


_PROPERTY = {
    "mass": "mass",
    "velocity": "velocity",
    "position": "place",
    "radius": "radius",
    "along": "direction",
    "through": "place",
    "start": "place",
    "end": "end",
    "centre": "centre",
}


def _place(token: Token) -> Place:
    return Place(token.line or 1, token.column or 1)


def _error(message: str, place: Place | None) -> StatementError:
    return StatementError(message, *((place.line, place.column) if place else (None, None)))


def _names(reading: Reading, node: Tree[Token], spans: list[Span]) -> tuple[Token, ...]:
    return tuple(span.first for span in spans[::2])


def _spheres(reading: Reading, node: Tree[Token], spans: list[Span]) -> _Declaration:
    properties = spans[3].value if len(spans) > 3 else ()
    return _Declaration("sphere", spans[1].value, _once_each(properties))


def _walls(reading: Reading, node: Tree[Token], spans: list[Span]) -> _Declaration:
    properties = spans[3].value if len(spans) > 3 else ()
    return _Declaration("wall", spans[1].value, _once_each(properties))


def _point(reading: Reading, node: Tree[Token], spans: list[Span]) -> _Declaration:
    place = spans[3].place
    return _Declaration("point", (spans[1].first,), (("position", spans[3].value, place),))


_Property = tuple[str, Any, Place]


def _once_each(properties: tuple[_Property, ...]) -> tuple[_Property, ...]:
    seen: set[str] = set()
    for key, _, place in properties:
        if key in seen:
            raise _error(f"the {_PROPERTY[key]} is given twice", place)
        seen.add(key)
    return properties


def _sphere_properties(
    reading: Reading, node: Tree[Token], spans: list[Span]
) -> tuple[_Property, ...]:
    return tuple(span.value for span in spans[::2])


def _sphere_property(reading: Reading, node: Tree[Token], spans: list[Span]) -> _Property:
    key = _SPHERE_FIELDS[spans[0].first.type]
    value = spans[1].value if len(spans) > 1 else Pair(Number(Fraction(0)), Number(Fraction(0)))
    return key, value, spans[0].place


def _wall_properties(
    reading: Reading, node: Tree[Token], spans: list[Span]
) -> tuple[_Property, ...]:
    first = spans[0].value
    if len(spans) == 1:
        return tuple(first)
    if spans[1].first.type == "COMMA":
        return (*first, *spans[2].value)
    return (*first, (_WALL_FIELDS[spans[1].first.type], spans[2].value, spans[1].place))


def _wall_property(reading: Reading, node: Tree[Token], spans: list[Span]) -> tuple[_Property, ...]:
    place = spans[0].place
    match spans[0].first.type:
        case "FROM":
            return ("start", spans[1].value, place), ("end", spans[3].value, place)
        case "CIRCLE":
            return (("centre", spans[2].value, place),)
        case kind:
            return ((_WALL_FIELDS[kind], spans[1].value, place),)


# --- events -----------------------------------------------------------------------------------


def _impact_property(reading: Reading, node: Tree[Token], spans: list[Span]) -> _Property:
    first = spans[0]
    if first.first.type != "LETTER":
        return str(first.first), spans[1].value, first.place
    if str(first.first) != "e":
        typed = reading.text(first.first, first.first)
        raise reading.error(
            f"unknown property '{typed}': the coefficient of restitution is given as e = …",
            first.place,
        )
    return "e", spans[2].value, first.place


def _impact(reading: Reading, node: Tree[Token], spans: list[Span]) -> Impact:
    first, second = str(spans[0].first), str(spans[2].first)
    properties: dict[str, Expression] = {}
    for key, value, place in spans[4].value if len(spans) > 4 else ():
        if key in properties:
            raise reading.error(f"'{key}' is given twice", place)
        properties[key] = value
    return Impact(first, second, **properties, place=spans[0].place)


def _kick(reading: Reading, node: Tree[Token], spans: list[Span]) -> Kick:
    return Kick(str(spans[0].first), spans[2].value, place=spans[0].place)


def _arrival(reading: Reading, node: Tree[Token], spans: list[Span]) -> Arrival:
    return Arrival(str(spans[0].first), spans[2].value, place=spans[0].place)


# --- facts ------------------------------------------------------------------------------------


def _let(reading: Reading, node: Tree[Token], spans: list[Span]) -> Let:
    return Let(spans[1].value.name, spans[3].value, place=spans[0].place)


def _given(reading: Reading, node: Tree[Token], spans: list[Span]) -> Given:
    return Given(tuple(span.value for span in spans[1::2]), place=spans[0].place)


def _unknown(reading: Reading, node: Tree[Token], spans: list[Span]) -> Unknown:
    return Unknown(_each_once(reading, spans[1::2]), place=spans[0].place)


def _each_once(reading: Reading, spans: list[Span]) -> tuple[str, ...]:
    names: list[str] = []
    for span in spans:
        if span.value.name in names:
            raise reading.error(f"'{span.value.name}' is listed twice", span.place)
        names.append(span.value.name)
    return tuple(names)


def _terms(reading: Reading, node: Tree[Token], spans: list[Span]) -> tuple[str, ...]:
    return _each_once(reading, spans[1::2])


def _compare(reading: Reading, node: Tree[Token], spans: list[Span]) -> Compare:
    operators: Any = tuple(str(span.first) for span in spans[1::2])
    operands = spans[::2]
    for one, other in (*pairwise(operands), *pairwise(operands[::-1])):
        _look_for_a_share(reading, one, other)
    return Compare(tuple(span.value for span in operands), operators)


def _look_for_a_share(reading: Reading, quantity: Span, number: Span) -> None:
    """Note ``energy_lost = 60%``, which says 0.6 J."""
    typed = reading.text(number.first, number.last)
    if number.first is not number.last or not str(number.first).endswith("%"):
        return
    tree = quantity.value
    if not isinstance(tree, Expression) or dimension_of_any([tree]) in (None, NONE):
        return
    message = f"{typed} was read as {write_expression(number.value)}, a number in SI"
    whole = _whole_of(tree, reading.events)
    fixes: tuple[Fix, ...] = ()
    if whole is not None:
        meant = f"{typed} of {whole}"
        message += f": did you mean {meant}?"
        fixes = (reading.fix(number.first, number.last, meant),)
    else:
        message += f": {typed} of what?"
    reading.warnings.append(Note(message, number.place.line, number.place.column, fixes))


def _whole_of(tree: Expression, events: int) -> str | None:
    """What a share of energy is surely a share of: the energy before."""
    match tree:
        case Quantity("energy_lost", (), stage):
            last = stage if isinstance(stage, int) else max(events, 1)
            return f"energy({last - 1})"
        case Quantity("total_energy_lost" | "energy", ()):
            return "energy(0)"
        case Quantity("energy", (Name(name),)):
            return f"energy({name}, 0)"
    return None


def _aligned(reading: Reading, node: Tree[Token], spans: list[Span]) -> Aligned:
    relation: Any = str(spans[1].first)
    return Aligned(spans[0].value, relation, spans[2].value)


def _at_rest(reading: Reading, node: Tree[Token], spans: list[Span]) -> AtRest:
    return AtRest(spans[0].value)


def _collide_again(reading: Reading, node: Tree[Token], spans: list[Span]) -> Meets:
    happens = str(spans[3].first) == "collide again"
    return Meets(spans[0].value, spans[2].value, again=True, happens=happens)


def _hits_again(reading: Reading, node: Tree[Token], spans: list[Span]) -> Meets:
    happens = spans[1].first.type == "HITS"
    return Meets(spans[0].value, spans[2].value, again=True, happens=happens)


def _will_hit(reading: Reading, node: Tree[Token], spans: list[Span]) -> Meets:
    happens = str(spans[1].first) == "will hit"
    return Meets(spans[0].value, spans[2].value, again=False, happens=happens)


# --- questions --------------------------------------------------------------------------------


def _percentage(spans: list[Span]) -> bool:
    return spans[-1].first.type == "PERCENTAGE"


def _value(reading: Reading, node: Tree[Token], spans: list[Span]) -> Value:
    text = reading.text(spans[0].first, spans[-1].last)
    if _percentage(spans):
        _look_for_a_unit(reading, spans[0])
    return Value(spans[0].value, _percentage(spans), text, place=spans[0].place)


def _look_for_a_unit(reading: Reading, item: Span) -> None:
    """Note a percentage of what has a unit: ``energy_lost as a percentage``."""
    dimension = dimension_of_any([item.value])
    whole = _whole_of(item.value, reading.events)
    if whole is None or dimension in (None, NONE):
        return
    typed = reading.text(item.first, item.last)
    message = f"a percentage needs a ratio, and {typed} is in {NAMES[dimension][1]}"
    meant = f"{typed}/{whole}"
    fix = reading.fix(item.first, item.last, meant)
    place = item.place
    reading.warnings.append(
        Note(f"{message}: did you mean {meant}?", place.line, place.column, (fix,))
    )


def _range(reading: Reading, node: Tree[Token], spans: list[Span]) -> Range:
    text = reading.text(spans[0].first, spans[-1].last)
    return Range(spans[1].value, _percentage(spans), text, place=spans[0].place)


def _extremum(reading: Reading, node: Tree[Token], spans: list[Span]) -> Extremum:
    kind: Any = str(spans[0].first).split()[0]
    text = reading.text(spans[0].first, spans[-1].last)
    return Extremum(
        kind, spans[1].value, spans[3].value, _percentage(spans), text, place=spans[0].place
    )


def _find(reading: Reading, node: Tree[Token], spans: list[Span]) -> Find:
    terms = spans[-1].value if isinstance(spans[-1].value, tuple) else None
    items = spans[1:-1:2] if terms is not None else spans[1::2]
    return Find(tuple(span.value for span in items), terms, place=spans[0].place)


def _show_with(reading: Reading, spans: list[Span], relation: Relation, subject: Any) -> Show:
    terms = None
    last = spans[-1]
    if isinstance(last.value, tuple):
        terms = last.value
        last = spans[-2]
    text = reading.text(spans[1].first, last.last)
    for span in spans:
        if span.first.type == "FIGURES":
            figures = int(str(span.first).split()[1].rstrip("sf."))
            if not isinstance(relation, Compare) or relation.operators[-1] != "=":
                raise reading.error("'s.f.' stands after a value, as in '= 0.236u'", span.place)
            if figures < 1:
                raise reading.error("expected at least 1 significant figure", span.place)
            relation = replace(relation, figures=figures)
    return Show(relation, subject, terms, text, place=spans[0].place)


def _show(reading: Reading, node: Tree[Token], spans: list[Span]) -> Show:
    return _show_with(reading, spans, spans[1].value, None)


def _show_range(reading: Reading, node: Tree[Token], spans: list[Span]) -> Show:
    text = reading.text(spans[1].first, spans[2].last)
    subject = Range(spans[2].value, False, text, place=spans[1].place)
    return _show_with(reading, spans, spans[4].value, subject)


def _show_extremum(reading: Reading, node: Tree[Token], spans: list[Span]) -> Show:
    kind: Any = str(spans[1].first).split()[0]
    text = reading.text(spans[1].first, spans[4].last)
    subject = Extremum(kind, spans[2].value, spans[4].value, False, text, place=spans[1].place)
    relation = Compare((spans[2].value, spans[6].value), ("=",))
    return _show_with(reading, spans, relation, subject)


_BUILDERS: Mapping[str, Builder] = {
    **BUILDERS,
    "names": _names,
    "spheres": _spheres,
    "walls": _walls,
    "point": _point,
    "sphere_properties": _sphere_properties,
    "sphere_property": _sphere_property,
    "wall_properties": _wall_properties,
    "wall_property": _wall_property,
    "impact_properties": _sphere_properties,
    "impact_property": _impact_property,
    "impact": _impact,
    "kick": _kick,
    "arrival": _arrival,
    "let": _let,
    "given": _given,
    "unknown": _unknown,
    "terms": _terms,
    "compare": _compare,
    "aligned": _aligned,
    "at_rest": _at_rest,
    "collide_again": _collide_again,
    "hits_again": _hits_again,
    "will_hit": _will_hit,
    "value": _value,
    "range": _range,
    "extremum": _extremum,
    "find": _find,
    "show": _show,
    "show_range": _show_range,
    "show_extremum": _show_extremum,
}
