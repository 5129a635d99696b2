"""A logical line of text, and where its tokens stand in the file."""

from __future__ import annotations

import unicodedata
from bisect import bisect_right
from dataclasses import field

from lark import Token

from restitution.errors import StatementError
from restitution.expression.tree import Place
from restitution.mending import Edit, Fix
from restitution.records import dataclass


@dataclass(frozen=True)
class Source:
    """A logical line: its text, and where each stretch of it stands in the file.

    ``plain`` is the text with typographical variants of letters and digits made ordinary,
    character by character, so that offsets agree.
    """

    text: str
    pieces: tuple[tuple[int, int, int], ...] = ((0, 1, 1),)  # offset, line, column
    plain: str = field(init=False)

    def __post_init__(self) -> None:
        plain = self.text if self.text.isascii() else "".join(map(_plain, self.text))
        object.__setattr__(self, "plain", plain)

    def place(self, offset: int) -> Place:
        """The line and column of an offset of the text."""
        start, line, column = self.pieces[bisect_right(self.pieces, (offset, 10**9, 0)) - 1]
        return Place(line, column + offset - start)

    def error(self, message: str, offset: int, *fixes: Fix) -> StatementError:
        """A mistake at an offset of the text, and what would cure it."""
        place = self.place(offset)
        mistake = StatementError(message, place.line, place.column)
        mistake.fixes = fixes
        return mistake

    def stretch(self, start: int, end: int) -> tuple[int, int, int, int]:
        """Line and column of an offset, and of another behind it."""
        first = self.place(start)
        if end <= start:
            return first.line, first.column, first.line, first.column
        last = self.place(end - 1)
        return first.line, first.column, last.line, last.column + 1

    def fix(self, start: int, end: int, text: str, label: str = "") -> Fix:
        """The cure that puts a text in the place of another, or takes that out."""
        typed = " ".join(self.text[start:end].split())
        if not text:
            while start and self.text[start - 1].isspace():
                start -= 1
            while not start and end < len(self.text) and self.text[end].isspace():
                end += 1
            if start and self.text[start - 1].isalnum() and self.text[end : end + 1].strip(",:;.)"):
                text = "" if self.text[end].isspace() else " "  # ``mass=2`` is no ``mass2``
        if not label:
            label = (
                f"Leave out '{typed}'"
                if not text.strip()
                else f"Replace '{typed}' by '{text.strip()}'"
                if typed
                else f"Put in '{text.strip()}'"
            )
        return Fix(label, (Edit(*self.stretch(start, end), text),))


def _plain(character: str) -> str:
    """A letter or digit in ordinary type for one in bold, italic or full-width type."""
    code = ord(character)
    if code < 0x80:
        return character
    if 0x1D400 <= code <= 0x1D7FF or 0xFF01 <= code <= 0xFF5E or code == 0x210E:
        normal = unicodedata.normalize("NFKC", character)
        return normal if len(normal) == 1 else character
    if character in "îĵ":
        return "i" if character == "î" else "j"
    if character.isspace() or unicodedata.category(character) == "Cf":
        return " "
    return character


def start_of(token: Token) -> int:
    """Where a token begins in its line."""
    return token.start_pos or 0


def end_of(token: Token) -> int:
    """Where a token ends in its line."""
    return token.end_pos or 0


def token_at(source: Source, kind: str, value: str, start: int, end: int) -> Token:
    """A token of a kind, with its line and column in the file."""
    place = source.place(start)
    return Token(kind, value, start, place.line, place.column, end_pos=end)
