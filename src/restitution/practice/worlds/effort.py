"""How much is worked out for a script: sides of relations, counted.

A limit is in force inside a block, and in the thread that sets it. What is counted is the same on
every machine, so it may decide how much of a long text is judged.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar


class ExhaustedError(Exception):
    """The effort that was allowed is spent.

    It is no `RestitutionError`: nobody on the way takes it for a relation without a value.
    """


class Effort:
    """The evaluations that are ``left`` in a block."""

    __slots__ = ("left",)

    def __init__(self, left: int) -> None:
        self.left = left


_CURRENT: ContextVar[Effort | None] = ContextVar("effort", default=None)


@contextmanager
def effort(evaluations: int) -> Iterator[Effort]:
    """Allow so many evaluations in the block, in place of a limit around it."""
    allowed = Effort(evaluations)
    token = _CURRENT.set(allowed)
    try:
        yield allowed
    finally:
        _CURRENT.reset(token)


def evaluate() -> None:
    """Count one evaluation, which is about to be made. Raises ExhaustedError beyond the limit."""
    current = _CURRENT.get()
    if current is not None:
        current.left -= 1
        if current.left < 0:
            raise ExhaustedError
