"""Reading statements, and saying what is wrong with them."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from restitution.cli.statuses import CLOSED, REPORT
from restitution.counting import counted
from restitution.errors import RestitutionError, StatementError

if TYPE_CHECKING:
    from restitution.mending import Edit, Note
    from restitution.problem import Problem


def read(file: str) -> bytes:
    """The bytes of a statement, no more than one beyond what it may have.

    Raises StatementError where there is nothing to read.
    """
    from restitution.expression.limits import MAX_TEXT_BYTES

    return first_bytes(file, MAX_TEXT_BYTES + 1, _hint)


def first_bytes(file: str, most: int, hint: Callable[[str], str] = lambda _: "") -> bytes:
    """The first bytes of a file, or of standard input (``-``); ``hint`` says what may help.

    Raises StatementError where there is nothing to read.
    """
    if file == "-" and CLOSED & {0}:
        raise StatementError("cannot be read: standard input is closed")
    try:
        if file == "-":
            return sys.stdin.buffer.read(most)
        with Path(file).open("rb") as stream:
            return stream.read(most)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise StatementError(f"cannot be read: {reason}{hint(file)}") from None


def _hint(file: str) -> str:
    from restitution import examples

    name = Path(file).name.removesuffix(".impact")
    if name in examples.names():
        return f"; did you mean: restitution examples {name} | restitution solve -"
    return ""


def parse(text: bytes) -> Problem:
    """The problem that a text states. Raises RestitutionError, whatever goes wrong."""
    from restitution.errors import UnsupportedError
    from restitution.language import parse

    try:
        return parse(text)
    except RestitutionError:
        raise
    except Exception:
        if debugging():
            raise
        message = f"internal error: the text could not be read; {REPORT}"
        raise UnsupportedError(message) from None


def pointed(file: str, text: bytes, error: RestitutionError) -> Iterator[str]:
    """The message of an error and of those beside it, with the place in the text."""
    yield "\n".join(_with_place(file, text, error))
    for other in getattr(error, "others", ()):
        yield "\n".join(_with_place(file, text, other))


def _with_place(file: str, text: bytes, error: RestitutionError) -> Iterator[str]:
    place = "".join(f":{n}" for n in (error.line, error.column) if n is not None)
    plain = error.kind == "time limit" or (error.line is None and error.kind == "syntax")
    kind = "" if plain else f"{error.kind}: "
    longer = "; --time-limit gives it longer" if error.kind == "time limit" else ""
    yield f"{shown_name(file)}{place}: {kind}{printable(error.message)}{longer}"
    if error.line is None:
        return
    numbered = _lines(text)
    if not 0 < error.line <= len(numbered):
        return
    line = numbered[error.line - 1]
    column = error.column or 0
    first = max(0, column - _SHOWN // 2) if len(line) > _SHOWN else 0
    shown = printable(line[first : first + _SHOWN])
    if first + _SHOWN < len(line):
        shown = f"{shown[:-1]}…"
    yield f"{error.line:>5} | {shown.rstrip()}"
    if column:
        before = shown[: column - 1 - first]
        yield f"      | {' ' * sum(_columns(character) for character in before)}^"
    yield from hint(text, error)


def _lines(text: bytes) -> list[str]:
    """The lines of a text: with the three ends of a line that the language knows, and no others."""
    lines = text.decode("utf-8", errors="replace").removeprefix("\ufeff")
    return lines.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def hint(text: bytes, error: RestitutionError | Note) -> Iterator[str]:
    """The line of which something is told as it would be with the likeliest cure."""
    if not error.fixes or error.line is None:
        return
    from restitution.mending import mended

    lines = _lines(text)
    after = mended("\n".join(lines), error.fixes[0]).split("\n")
    # A cure may begin a line, or join two: what stands below keeps its distance from the end.
    below = len(lines) - max(edit.end_line for edit in error.fixes[0].edits if _near(edit, error))
    others = len({edit.line for edit in error.fixes[0].edits} - {error.line})
    for line in after[error.line - 1 : len(after) - below]:
        if len(line) <= _COPIED:
            yield f"  fix | {printable(line)}"
    if others:
        yield f"      | and in {counted(others, 'other line')}"


def _near(edit: Edit, error: RestitutionError | Note) -> bool:
    return edit.line <= (error.line or 1) <= edit.end_line


_SHOWN = 72
_COPIED = 200
"""A cure is shown whole, as it is to be copied: longer than a row of a terminal, up to this."""


def _columns(character: str) -> int:
    """How many columns of a terminal a character takes."""
    from unicodedata import combining, east_asian_width

    if combining(character):
        return 0
    return 2 if east_asian_width(character) in "WF" else 1


def printable(text: str) -> str:
    """A text without what a terminal would take for a command."""
    return "".join(
        character
        if character.isprintable()
        else " "
        if character.isspace()
        else "\N{REPLACEMENT CHARACTER}"
        for character in text
    )


def shown_name(file: str) -> str:
    """The name of a file as it can be shown."""
    return printable(os.fsencode(file).decode("utf-8", errors="replace"))


def one_line(error: BaseException) -> str:
    """What an error says, on one line that is not too long."""
    return printable(" ".join(str(error).split()))[:200]


def say(message: str) -> None:
    """Writes a line to standard error."""
    sys.stderr.write(f"{message}\n")
    sys.stderr.flush()


def debugging() -> bool:
    """Whether failures of the program are to be shown in full."""
    return bool(os.environ.get("RESTITUTION_DEBUG"))


def terminal_width() -> int:
    """Columns for text: those of the terminal within reason, else 80."""
    if not sys.stdout.isatty():
        return 80
    return max(40, min(shutil.get_terminal_size().columns, 120))
