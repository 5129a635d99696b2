"""Marking from the command line: which scripts, which letters, and what comes of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from restitution.cli.asking import Answer, answer
from restitution.cli.files import read, shown_name
from restitution.cli.output import RefusedError
from restitution.cli.statuses import UNREADABLE
from restitution.errors import StatementError
from restitution.export.job import Marking
from restitution.export.marking import Workings
from restitution.records import dataclass

if TYPE_CHECKING:
    from restitution.killable import Worker

ENDINGS = (".txt", ".md")
"""How the names of the scripts in a folder end."""


@dataclass(frozen=True)
class Scripts:
    """What is to be marked: a file, - for standard input, or a folder of scripts."""

    question: str
    working: str | None
    letters: str | None
    task: Workings


def mark(worker: Worker, scripts: Scripts, limit: float | None) -> Answer:
    """The workings marked. What cannot be read has the status of that. Raises RefusedError.

    A script of a folder that cannot be read does not stop the others. The ``limit`` is in seconds
    for each script.
    """
    task = scripts.task
    unread: list[str] = []
    _require(scripts)
    try:
        if scripts.letters is not None:
            task = replace(task, letters=_text(scripts.letters))
        if scripts.working is not None:
            task = replace(task, workings=tuple(_workings(scripts.working, unread)))
    except StatementError as error:
        return Answer(UNREADABLE, None, (error.message,))
    whole = None if limit is None else limit * max(1, len(task.workings))
    letters = scripts.letters or "", task.letters
    done = answer(worker, scripts.question, Marking(task), whole, letters)
    if not unread:
        return done
    return Answer(UNREADABLE, done.content, (*unread, *done.messages))


def _require(scripts: Scripts) -> None:
    if (scripts.working is None) == (not scripts.task.answers):
        raise RefusedError("give a working, or answers by --answer, and not both", "WORKING")
    if [scripts.question, scripts.working, scripts.letters].count("-") > 1:
        rule = "standard input can be only one of the question, the working and the letters"
        raise RefusedError(rule, "WORKING")
    if scripts.task.form == "csv" and scripts.task.answers:
        raise RefusedError("a table is of workings, not of answers alone", "--csv")


def _workings(path: str, unread: list[str]) -> Iterator[tuple[str, str | None]]:
    """The scripts of a path, by name: of a folder all that end as texts do, in order of names.

    One of a folder that cannot be read has no text, and ``unread`` is given the reason.
    """
    folder = Path(path)
    if path == "-" or not folder.is_dir():
        yield shown_name(path), _text(path)
        return
    files = sorted(
        entry for entry in folder.iterdir() if entry.suffix in ENDINGS and entry.is_file()
    )
    if not files:
        raise StatementError(f"{path}: no scripts: their names end in {' or '.join(ENDINGS)}")
    for file in files:
        try:
            yield file.name, _text(str(file))
        except StatementError as error:
            unread.append(error.message)
            yield file.name, None


def _text(file: str) -> str:
    from restitution.language.lines import decode

    try:
        return decode(read(file))
    except StatementError as error:
        raise StatementError(f"{shown_name(file)}: {error.message}") from None
