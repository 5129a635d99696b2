"""A place among the tokens of a side, and the questions that a reading of them answers."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.practice.reading.tokens import Token, Usage
from restitution.practice.script import InScript


class UnreadableError(Exception):
    """What was expected, and the column at which it was."""

    def __init__(self, expected: str, column: int) -> None:
        super().__init__(expected)
        self.expected, self.column = expected, column


class Cursor:
    """A run over the tokens of a side; ``picks`` answers its questions, 0 where not there."""

    def __init__(
        self,
        tokens: Sequence[Token],
        usage: Usage,
        line: int,
        end_column: int,
        picks: dict[str, int],
        lower: bool = False,
    ) -> None:
        self.tokens, self.usage, self.line, self.picks = tokens, usage, line, picks
        self.end_column, self.lower = end_column, lower
        self.position = self.depth = self.bars = 0
        self.asked: dict[str, int] = {}
        self.radians: set[int] = set()
        self.counts: dict[str, int] = {}

    def choose(self, kind: str, options: int = 2) -> int:
        """Which of the readings of a kind is wanted here; the first unless picked otherwise.

        A kind is asked as a whole, and from its second occurrence each alone as well.
        """
        number = self.counts[kind] = self.counts.get(kind, -1) + 1
        question = f"{kind}/{number}"
        self.asked.setdefault(kind, options)
        if number and number < 4:
            self.asked.setdefault(f"{kind}/0", options)
            self.asked.setdefault(question, options)
        return self.picks.get(question, self.picks.get(kind, 0)) % options

    def kind(self, ahead: int = 0) -> str:
        """The kind of a token ahead; empty behind the last one."""
        place = self.position + ahead
        return self.tokens[place].kind if place < len(self.tokens) else ""

    def token(self, ahead: int = 0) -> Token:
        """A token ahead, which has to be there."""
        return self.tokens[self.position + ahead]

    def take(self) -> Token:
        """The next token, passed."""
        token = self.tokens[self.position]
        self.position += 1
        return token

    def fail(self, expected: str) -> UnreadableError:
        """What to raise where something else was expected."""
        there = self.position < len(self.tokens)
        return UnreadableError(expected, self.token().column if there else self.end_column)

    def place(self, token: Token) -> InScript:
        """Where a token stands."""
        return InScript(self.line, token.column)
