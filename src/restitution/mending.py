"""Cures for what is wrong with a text: edits that can be made without more questions."""

from __future__ import annotations

import re

from restitution.records import dataclass

_LINE = re.compile(r"[^\r\n]*(?:\r\n|\r|\n|$)")


@dataclass(frozen=True, slots=True)
class Edit:
    """A stretch of a text that another text replaces; the end is not part of the stretch.

    Lines and columns count from 1, columns in characters.
    """

    line: int
    column: int
    end_line: int
    end_column: int
    text: str


@dataclass(frozen=True, slots=True)
class Fix:
    """A cure: what it does, in words, and the edits of the text that do it.

    The edits are of one text as it stands, and do not overlap.
    """

    label: str
    edits: tuple[Edit, ...]


@dataclass(frozen=True, slots=True)
class Note:
    """What is said of a text that reads: how something doubtful was taken, where, and what would
    settle it.
    """

    message: str
    line: int | None = None
    column: int | None = None
    fixes: tuple[Fix, ...] = ()

    def __str__(self) -> str:
        if self.line is None:
            return self.message
        return f"line {self.line}, column {self.column}: {self.message}"


def mended(text: str, fix: Fix) -> str:
    """A text with the edits of a fix made.

    >>> mended("fnd e", Fix("Replace 'fnd' by 'find'", (Edit(1, 1, 1, 4, "find"),)))
    'find e'
    """
    starts = [0]
    for match in _LINE.finditer(text):
        if match.end() > match.start():
            starts.append(match.end())

    def offset(line: int, column: int) -> int:
        return min(starts[min(line, len(starts)) - 1] + column - 1, len(text))

    for edit in sorted(fix.edits, key=lambda edit: (edit.line, edit.column), reverse=True):
        start, end = offset(edit.line, edit.column), offset(edit.end_line, edit.end_column)
        text = text[:start] + edit.text + text[end:]
    return text
