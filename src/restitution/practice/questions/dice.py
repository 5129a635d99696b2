"""Draws that are the same on every machine: whole numbers from hashes of a text."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from hashlib import sha256
from typing import TypeVar

_T = TypeVar("_T")


class Dice:
    """Draws that follow from a key alone, one after another."""

    def __init__(self, key: str) -> None:
        self._key = key
        self._drawn = 0

    def below(self, bound: int) -> int:
        """A whole number from 0 on, below ``bound``, each as likely. ``bound`` is at least 1."""
        self._drawn += 1
        digest = sha256(f"{self._key}/{self._drawn}".encode()).digest()
        return int.from_bytes(digest[:16]) % bound

    def between(self, low: int, high: int) -> int:
        """A whole number, both ends included."""
        return low + self.below(high - low + 1)

    def of(self, values: Sequence[_T]) -> _T:
        """One of some values."""
        return values[self.below(len(values))]

    def sign(self) -> int:
        """1 or -1."""
        return 1 - 2 * self.below(2)

    def shuffled(self, values: Sequence[_T]) -> list[_T]:
        """All of some values, in any order."""
        left = list(values)
        return [left.pop(self.below(len(left))) for _ in values]


Recipe = Callable[[Dice], str]
"""A way to draw the statement of a question."""
