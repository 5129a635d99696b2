"""Workings marked, as work for a process: text, JSON, HTML, or a table of many scripts."""

from __future__ import annotations

import csv
import io
import json
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING, Any, Literal

from restitution.errors import RestitutionError, StatementError, TimeLimitError
from restitution.problem import require_part
from restitution.records import dataclass
from restitution.work import limited

if TYPE_CHECKING:
    from restitution.practice.marking.answers import AnswerMark
    from restitution.practice.marking.marking import Marking
    from restitution.practice.marking.objects import MarkingObject, PartsMarkedObject
    from restitution.solving.equations.solution import Solution

Form = Literal["text", "json", "html", "csv"]

HEADER = ("script", "part", "earned", "open", "of", "mistakes")
"""The columns of the table of many scripts."""


@dataclass(frozen=True)
class Workings:
    """Workings to be marked, each by its name, or ``answers`` alone such as ``speed(P) = 4.5``.

    A working without a text (None) could not be read: a table has a row for it without marks.
    ``letters`` is the text of a letters file, ``hints`` the level of messages.
    """

    workings: tuple[tuple[str, str | None], ...] = ()
    answers: tuple[str, ...] = ()
    part: str | None = None
    letters: str = ""
    hints: int = 1
    form: Form = "text"
    width: int = 80


def written(
    solution: Solution, task: Workings, seconds: float | None = None
) -> tuple[str, tuple[str, ...]]:
    """What is said of the workings, in the form asked for, and what there was no time to mark.

    Of the ``seconds`` each working has its share, and what those before it leave. Raises
    StatementError for letters or answers that cannot be read, the error of a part that has no
    answer, and TimeLimitError where nothing is marked in time.
    """
    from restitution.practice.marking.answers import mark_answers

    if task.answers:
        return _of_answers(mark_answers(solution, task.answers, task.part), task.form), ()
    letters = _letters(task.letters, solution)
    unattempted = cache(lambda label: _unattempted(solution, label, task.hints))
    rows: list[tuple[str, Marking | None]] = []
    late: list[str] = []
    began = time.monotonic()
    for number, (name, text) in enumerate(task.workings, 1):
        until = None if seconds is None else began + seconds * number / len(task.workings)
        clock = _Clock(name, until, late)
        markings = (
            [] if text is None else _marked(solution, text, task, letters, unattempted, clock)
        )
        rows += [(name, marking) for marking in markings] or [(name, None)]
    if late and not any(marking for _, marking in rows):
        raise TimeLimitError(f"{late[0]}: not marked within the time limit")
    return _in_form(solution, task, rows), tuple(late)


def _in_form(solution: Solution, task: Workings, rows: Sequence[tuple[str, Marking | None]]) -> str:
    """What is said of workings that are marked."""
    if task.form == "csv":
        return table(rows)
    marked = [(name, marking) for name, marking in rows if marking is not None]
    if task.form == "json":
        named = len(task.workings) > 1
        return "".join(
            json.dumps(
                {**({"script": name} if named else {}), **marking.json()}, ensure_ascii=False
            )
            + "\n"
            for name, marking in marked
        )
    from restitution.practice.marking.showing import document, to_text

    if task.form == "html":
        return document(marked, solution.problem.title, _question(solution))
    blocks = [
        (f"{name}\n" if len(task.workings) > 1 else "") + to_text(marking, task.width)
        for name, marking in marked
    ]
    return "\n\n".join(blocks) + "\n"


def _question(solution: Solution) -> str:
    """The question in words, as HTML; nothing where it cannot be worded."""
    from dataclasses import replace

    from restitution.wording import question
    from restitution.wording.document import to_body

    try:
        return to_body(replace(question(solution.problem), title=None))
    except RestitutionError:
        return ""


def marking_of(
    solution: Solution,
    working: str,
    part: str | None,
    letters: Mapping[str, str],
    hints: int | Mapping[str, int],
) -> MarkingObject | PartsMarkedObject:
    """The object of one part, or ``{"parts": [...]}`` where the working opens several."""
    from restitution.practice.marking.marking import mark, mark_parts

    levels = hints if isinstance(hints, int) else dict(_levels(hints))
    for letter, meaning in letters.items():
        if not isinstance(meaning, str):
            raise StatementError(f"the meaning of {letter[:20]} is a text")
    if part is not None:
        require_part(solution.problem, part)
        return mark(solution, working, part, letters, hints=levels).json()
    markings = mark_parts(solution, working, letters, hints=levels)
    if len(markings) == 1:
        return markings[0].json()
    return {"parts": [marking.json() for marking in markings]}


def table(marked: Iterable[tuple[str, Marking | None]]) -> str:
    """Scripts and their marks as CSV, a row for each part of each.

    A script that could not be read (None) has one row, without marks.
    """
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(HEADER)
    for name, marking in marked:
        if marking is None:
            rows.writerow([_cell(name), *("" for _ in HEADER[1:])])
            continue
        marks = marking.marks
        mistakes = " ".join(dict.fromkeys(marking.mistakes))
        rows.writerow(
            [_cell(name), marking.part or "", marks.earned, marks.open, marks.of, mistakes]
        )
    return text.getvalue()


def _cell(text: str) -> str:
    """A text that no spreadsheet takes for a formula."""
    return f"'{text}" if text[:1] in "=+-@\t" else text


def _levels(hints: Mapping[str, int]) -> Iterator[tuple[int | None, int]]:
    for line, level in hints.items():
        if not (line == "next" or (line.isascii() and line.isdigit() and len(line) < 4)):
            raise StatementError(
                f"hints are for lines by number, or for next, not for {line[:20]!r}"
            )
        if isinstance(level, bool) or not isinstance(level, int):
            raise StatementError(f"the hint for line {line} has a level from 0 to 4")
        yield (None if line == "next" else int(line)), level


def _letters(text: str, solution: Solution) -> Mapping[str, Any]:
    from restitution.practice.letters.declaring import letters_from_text

    return letters_from_text(text, solution.problem)


@dataclass(frozen=True)
class _Clock:
    """Until when a working is marked, and the list of parts for which there was no time."""

    name: str
    until: float | None
    late: list[str]

    def marking(self, label: str | None, mark: Callable[[], Marking | None]) -> Marking | None:
        """The marking of a part; None where the time ends before."""
        left = None if self.until is None else max(0.0, self.until - time.monotonic())
        try:
            with limited(left):
                return mark()
        except TimeLimitError:
            self.late.append(self.name if label is None else f"{self.name}, part ({label})")
            return None


def _marked(
    solution: Solution,
    text: str,
    task: Workings,
    letters: Mapping[str, Any],
    unattempted: Callable[[str | None], Marking | None],
    clock: _Clock,
) -> list[Marking]:
    """The markings of all parts of a working: a part that it does not attempt has no marks.

    A part for which there is no time has none either; those before it keep theirs.
    """
    from restitution.practice.marking.marking import mark, markings_of_parts

    part = task.part
    if part is not None:
        marked = partial(mark, solution, text, part, letters, hints=task.hints)
        marking = clock.marking(part, marked)
        return [] if marking is None else [marking]
    attempted = {
        label: clock.marking(label, marked)
        for label, marked in markings_of_parts(solution, text, letters, hints=task.hints)
    }
    markings = [
        attempted[label]
        if label in attempted
        else clock.marking(label, partial(unattempted, label))
        for label in solution.parts
    ]
    return [marking for marking in markings if marking is not None]


def _unattempted(solution: Solution, part: str | None, hints: int) -> Marking | None:
    """The marking of a part of which there is no working; None where the part has no marks."""
    from restitution.practice.marking.marking import mark

    try:
        marking = mark(solution, "", part, hints=hints)
    except TimeLimitError:
        raise
    except RestitutionError:
        return None  # it has no answer
    return marking if marking.marks.of else None


def _of_answers(answers: Sequence[AnswerMark], form: Form) -> str:
    if form == "json":
        return "".join(json.dumps(answer.json(), ensure_ascii=False) + "\n" for answer in answers)
    from restitution.practice.marking.showing import answer_line

    return "".join(f"{answer_line(answer)}\n" for answer in answers)
