"""A text to its logical lines: comments taken off, continued lines joined, sizes checked."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from restitution.errors import StatementError
from restitution.expression.lexer import Source
from restitution.expression.limits import MAX_LINE_LENGTH, MAX_LINES, MAX_TEXT_BYTES
from restitution.expression.words import NAME

_BREAK = re.compile(r"\r\n|\r|\n")
_FIRST_WORD = re.compile(r"\s*(\w+)")
_DECLARATION = re.compile(r"\s*(sphere|wall|point)\b([^:]*)")


@dataclass(frozen=True)
class Line:
    """A logical line, its first word, and what follows that word."""

    source: Source
    word: str
    rest: str

    @property
    def start(self) -> int:
        """The offset of the first character that is no blank."""
        return len(self.source.text) - len(self.source.text.lstrip())


def decode(text: str | bytes) -> str:
    """The text itself, of a bearable size. Raises StatementError for bytes that are no UTF-8."""
    if len(text) > MAX_TEXT_BYTES:
        raise StatementError(
            f"the text is too long: at most {MAX_TEXT_BYTES} bytes, and this has {len(text)}", 1, 1
        )
    if isinstance(text, bytes):
        try:
            text = text.decode("utf-8")
        except UnicodeDecodeError as error:
            before = _BREAK.split(error.object[: error.start].decode("utf-8"))
            raise StatementError(
                f"the text is not UTF-8: byte {error.object[error.start]:#04x} cannot stand here",
                len(before),
                len(before[-1]) + 1,
            ) from None
    return text.removeprefix("\ufeff")


def logical_lines(text: str) -> Iterator[Line]:
    """The lines that say something, in order. Raises StatementError where a limit is exceeded."""
    physical = _BREAK.split(text)
    if len(physical) > MAX_LINES:
        raise StatementError(f"a statement has at most {MAX_LINES} lines", MAX_LINES + 1, 1)
    for number, line in enumerate(physical, start=1):
        if len(line) > MAX_LINE_LENGTH:
            raise StatementError(
                f"the line is too long: at most {MAX_LINE_LENGTH} characters", number, 1
            )
    at = 0
    while at < len(physical):
        is_title = _first_word(physical[at]) == "title"
        joined = ""
        pieces: list[tuple[int, int, int]] = []
        while True:
            line = physical[at] if is_title else physical[at].partition("#")[0]
            at += 1
            pieces.append((len(joined), at, 1))
            goes_on = line.rstrip().endswith("\\") and at < len(physical)
            joined += line.rstrip()[:-1] + " " if goes_on else line
            if not goes_on:
                break
            if len(joined) > MAX_TEXT_BYTES:
                break
        word = _first_word(joined)
        if joined.strip():
            rest = joined.strip()[len(word) :] if word else joined
            yield Line(Source(joined, tuple(pieces)), word, rest)


def _first_word(line: str) -> str:
    match = _FIRST_WORD.match(line)
    return match.group(1) if match else ""


def declared_names(lines: list[Line]) -> dict[str, str]:
    """Every name declared anywhere, with what it is; the first declaration counts."""
    names: dict[str, str] = {}
    for line in lines:
        match = _DECLARATION.match(line.source.plain)
        if match:
            for told in match.group(2).split(","):
                # What follows a name without a colon is a mistake, but not of the name.
                name = told.split()[0] if told.strip() else ""
                if NAME.fullmatch(name):
                    names.setdefault(name, match.group(1))
    return names
