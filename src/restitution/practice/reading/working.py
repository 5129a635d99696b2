"""A student's working, read: plain text to a `Script`.

A line is made plain (`characters`), scanned (`scanner`) with what is known of the script's letters
(`usage`), parted into segments of mathematics and the words between them (`segments`), and each
side of a relation is read in every sensible way (`grammar`). Nothing typed is executed, and no
text raises an error: what cannot be read is a line of kind ``unread`` that says what was expected.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple, TypeAlias

from restitution.practice.reading.chains import Past, Statements
from restitution.practice.reading.characters import Plain, plain
from restitution.practice.reading.decimal_commas import with_decimal_points
from restitution.practice.reading.energies import energy_links
from restitution.practice.reading.energy_lines import with_energy_labels
from restitution.practice.reading.headings import (
    case_of,
    crossed,
    heading_end,
    number_behind,
    part_of,
    scope_of,
    without_number,
)
from restitution.practice.reading.merging import with_phrases
from restitution.practice.reading.owners import with_owners
from restitution.practice.reading.quoted import without_quoted, without_steady_motion
from restitution.practice.reading.scanner import scan
from restitution.practice.reading.segments import segments
from restitution.practice.reading.spoken import with_labels
from restitution.practice.reading.statements import read_statements
from restitution.practice.reading.tokens import Token, Usage
from restitution.practice.reading.usage import (
    GREEK_ANGLES,
    letters_of_question,
    usage_of,
    with_angles,
)
from restitution.practice.reading.vocabulary import DIRECTIONS, HEADS, STAGES
from restitution.practice.script import ANYWHERE, LineKind, Scope, Script, ScriptLine
from restitution.problem import Impact, Problem

MAX_LINES = 60
MAX_LENGTH = 200

Working: TypeAlias = str | Sequence[str] | Mapping[str | None, Sequence[str]]
"""A working as text, as lines, or as the lines of each part by its label."""


class _Typed(NamedTuple):
    """A line of a working as typed; ``part`` is the label of its part where that is known."""

    number: int
    text: str
    part: str | None


# What has a value at every moment.
_OF_A_MOMENT = frozenset(("speed", "velocity", "component", "momentum", "energy"))
_WALL = re.compile(r"\s*(?:the\s+)?(?:wall|cushion|barrier)\s*:", re.IGNORECASE)


def read_working(text: Working, problem: Problem, declared: Collection[str] = ()) -> Script:
    """The working of a question as a script: at most 60 lines of 200 characters are read.

    ``text`` is the working, or its lines. A ``declared`` letter stands for no other: a is not α
    then. Never raises: lines beyond the limits, and lines that
    are no mathematics, are ``unread``.
    """
    typed = list(_typed(text))[: MAX_LINES + 1]
    texts = with_decimal_points([line.text[: MAX_LENGTH + 1] for line in typed[:MAX_LINES]])
    texts = with_angles(texts, problem)
    of_question = {*letters_of_question(problem), *declared}
    plains = [plain(without_steady_motion(text, of_question)) for text in texts]
    # The a of (a) is no letter of the working.
    without_parts = [line.text[part_of(line.text, problem)[1] :] for line in plains]
    usage = usage_of(without_parts, problem)
    plains = list(with_owners(plains, problem, {*usage.letters, *declared}))
    aliases = {letter: meant for letter, meant in usage.aliases.items() if letter not in declared}
    aliases |= {
        letter: letter for letter in declared if len(letter) == 2 and letter in usage.aliases
    }
    own = {letter: meant for letter, meant in aliases.items() if meant not in GREEK_ANGLES}
    known = {*usage.letters, *declared}
    script = without_quoted(_read(typed, plains, problem, replace(usage, aliases=aliases)), known)
    if own == aliases:
        return script
    literal = _read(typed, plains, problem, replace(usage, aliases=own))
    return replace(script, literal=without_quoted(literal, known))


def _typed(text: Working) -> Iterator[_Typed]:
    """The lines that are not blank; all are counted from 1."""
    if isinstance(text, str):
        text = text.splitlines()
    parts = text.items() if isinstance(text, Mapping) else [(None, text)]
    lines = ((label, str(line)) for label, own in parts for line in own)
    for number, (label, line) in enumerate(lines, 1):
        if line.strip():
            yield _Typed(number, line, label)


def _read(
    typed: Sequence[_Typed], plains: Sequence[Plain], problem: Problem, usage: Usage
) -> Script:
    reader = _Reader(problem, usage)
    plains, energies = with_energy_labels(plains, problem)
    script_lines = []
    for place, ((number, line, label), shown) in enumerate(zip(typed, plains)):
        reader.of_energy = place in energies
        if label is not None:
            reader.open(label)
        script_lines.append(reader.line(number, line, shown))
    if len(typed) > MAX_LINES:
        number, line, _ = typed[MAX_LINES]
        fault = f"a working has at most {MAX_LINES} lines: this one and those below are not read"
        script_lines.append(ScriptLine(number, line[:MAX_LENGTH], "unread", fault=fault, column=1))
    return Script(_all_in_parts(script_lines, problem))


def _all_in_parts(lines: Sequence[ScriptLine], problem: Problem) -> tuple[ScriptLine, ...]:
    """The lines, of which those above the first label of a part are in a part too.

    Mathematics without a label is of the first part; words and letters are of the part below them.
    """
    opened = next((line.part for line in lines if line.part is not None), None)
    if opened is None:
        return tuple(lines)
    above = [line for line in lines if line.part is None]
    if any(line.kind in ("relations", "unread") for line in above):
        opened = next(part.label for part in problem.parts if part.label)
    return tuple(replace(line, part=opened) if line.part is None else line for line in lines)


# A change of velocity as a vector, at the end of its line, and a size that says not of what.
_CHANGE = re.compile(
    r"change\s+(?:in|of)\s+(?:v|vel|velocity)\b[^=]*=(?:[^=]*=)*\s*"
    r"(-?\s*[\d./√]*[ij]\s*[-+]\s*[\d./√]*[ij])\s*$",
    re.IGNORECASE,
)
_SIZE_OF_IT = re.compile(
    r"^\s*(?:so\s+)?(?:its\s+|the\s+)?(?:size|magnitude|mag|modulus)(?:\s+of\s+(?:it|this|that))?"
    r"\s*(?:is|=|:)?\s*(?=[\d√(])",
    re.IGNORECASE,
)


class _Reader:
    """Reads line after line; keeps the part, the scope and the last right side."""

    def __init__(self, problem: Problem, usage: Usage) -> None:
        self.problem, self.usage = problem, usage
        self.part: str | None = None
        self.scope: Scope = ANYWHERE
        self.cases = 0
        self.past = Past()
        self.of_energy = False
        self.change: str | None = None

    def open(self, label: str) -> None:
        """Read what follows as working of a part."""
        if label != self.part:
            self.part, self.scope, self.past = label, ANYWHERE, Past()

    def line(self, number: int, typed: str, line: Plain) -> ScriptLine:
        """One line, read."""
        if len(typed) > MAX_LENGTH:
            fault = f"a line has at most {MAX_LENGTH} characters"
            return self._script_line(number, typed, "unread", fault=fault, column=MAX_LENGTH + 1)
        inside = crossed(line.text)
        if inside is not None:
            start = line.text.find(inside)
            kept = self.part, self.scope, self.cases, self.past
            read = self._read(number, typed, _cut(line, start, start + len(inside)))
            self.part, self.scope, self.cases, self.past = kept
            return replace(read, kind="crossed", declarations=(), fault=None, column=None)
        return self._read(number, typed, line)

    def _script_line(
        self, number: int, typed: str, kind: LineKind, scope: Scope | None = None, **more: object
    ) -> ScriptLine:
        where = self.scope if scope is None else scope
        return ScriptLine(number, typed, kind, self.part, where, **more)  # type: ignore[arg-type]

    def _read(self, number: int, typed: str, line: Plain) -> ScriptLine:
        cases = self.cases
        line, opened = self._behind_headings(line)
        line = self._with_the_change(with_labels(line, self.problem))
        tokens = with_phrases(scan(line, self.usage), line.text, self.problem)
        if not tokens:
            return self._script_line(number, typed, "heading" if opened else "remark")
        scope, tokens = self._heading(tokens, line)
        if not tokens:
            return self._script_line(number, typed, "heading")
        tokens = [_staged(token, scope.stage) for token in tokens]
        whose = None if scope == self.scope and scope.event is None else self._whose(scope)
        if _WALL.match(line.text) or _ends_at(line, tokens):
            whose = None  # wall: 2i + j is its direction, hits at (2, 1) a place
        statements = read_statements(
            segments(tokens, self.cases > cases),
            self.usage,
            self.problem,
            number,
            line,
            self.past,
            whose,
        )
        self.past = statements.past
        return self._line_of_statements(number, typed, statements, scope, opened)

    def _with_the_change(self, line: Plain) -> Plain:
        """A line about a size alone, with the change of velocity of the line above in bars."""
        match = None if self.change is None else _SIZE_OF_IT.match(line.text)
        change, above = _CHANGE.search(line.text), self.change
        self.change = None if change is None else change[1]
        if match is None or above is None:
            return line
        put = f"|{above}| = "
        # Numbers are known by their columns: those put in stand beyond the line.
        columns = tuple(range(MAX_LENGTH + 1, MAX_LENGTH + 1 + len(put)))
        return Plain(put + line.text[match.end() :], columns + line.columns[match.end() :])

    def _whose(self, scope: Scope) -> str | None:
        """The velocity of which a heading speaks, in words: ``after W: 8i + 3j``."""
        spheres = [sphere.name for sphere in self.problem.spheres]
        if scope.event is not None:
            event = self.problem.events[scope.event - 1]
            met = (event.first, event.second) if isinstance(event, Impact) else (event.body,)
            spheres = [sphere for sphere in spheres if sphere in met]
        body = scope.body or (spheres[0] if len(spheres) == 1 else None)
        return None if body is None else f"velocity of {body} {scope.stage or 'after'}"

    def _line_of_statements(
        self, number: int, typed: str, statements: Statements, scope: Scope, opened: bool
    ) -> ScriptLine:
        if statements.body and scope.body is None:
            scope = replace(scope, body=statements.body)
        links = energy_links(
            statements.links,
            statements.values,
            scope,
            self.usage,
            self.problem,
            known=self.of_energy,
        )
        values = statements.values if links == statements.links else ()
        kind: LineKind = "remark"
        if links:
            kind = "relations"
        elif statements.declarations:
            kind = "declaration"
        elif statements.fault:
            kind = "unread"
        elif opened and not statements.values:
            kind = "heading"
        return self._script_line(
            number,
            typed,
            kind,
            scope,
            links=links,
            declarations=statements.declarations,
            values=values,
            supposed=statements.supposed,
            fault=statements.fault,
            column=statements.column,
        )

    def _behind_headings(self, line: Plain) -> tuple[Plain, bool]:
        """A line behind the label of its part, its number and the word of its case."""
        opened = False
        label, start = part_of(line.text, self.problem)
        if label is not None:
            self.open(label)
            line, opened = _cut(line, start, len(line.text)), True
        line = _cut(line, without_number(line.text), number_behind(line.text))
        start = case_of(line.text)
        if start:
            self.cases += 1
            self.scope = replace(self.scope, case=self.cases)
            line, opened = _cut(line, start, len(line.text)), True
        return line, opened

    def _heading(self, tokens: list[Token], line: Plain) -> tuple[Scope, list[Token]]:
        """The scope of a line, and its tokens behind a heading.

        A heading alone on its line, and one that names an event, hold for the lines below.
        """
        end = heading_end(tokens, self.usage)
        if not end:
            return self.scope, tokens
        words = line.text[tokens[0].start : tokens[end - 1].end]
        scope = scope_of(words, self.problem, self.scope)
        if scope is None:
            return self.scope, tokens
        scope = replace(scope, case=self.scope.case)
        rest = tokens[end:]
        while rest and (rest[0].kind in (":", ",", "stop", ";", "arrow") or _is_dash(rest)):
            rest = rest[1:]
        if not rest or scope.event != self.scope.event:
            self.scope = scope if not rest else replace(scope, body=None, stage=None)
        return scope, rest


def _staged(token: Token, stage: str | None) -> Token:
    """A phrase for a motion without a moment, at that of the heading: ``before: perp = 3``."""
    words = token.name.split()
    heads = {HEADS[word] for word in words if word in HEADS}
    moving = heads <= _OF_A_MOMENT and (heads or not DIRECTIONS.keys().isdisjoint(words))
    if token.kind != "phrase" or stage is None or not moving or not STAGES.keys().isdisjoint(words):
        return token
    return replace(token, name=f"{token.name} {stage}")


def _is_dash(tokens: Sequence[Token]) -> bool:
    """Whether a line begins with a dash, and not with the sign of what follows: ``- 3i``."""
    return tokens[0].kind == "-" and (len(tokens) == 1 or tokens[1].gap > 0)


def _ends_at(line: Plain, tokens: Sequence[Token]) -> bool:
    """Whether the words before the tokens of a line say where something is: ``hits it at``."""
    return bool(tokens) and re.search(r"\bat\s*$", line.text[: tokens[0].start]) is not None


def _cut(line: Plain, start: int, end: int) -> Plain:
    return Plain(line.text[start:end], line.columns[start:end])
