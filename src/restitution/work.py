"""Limits of work: operations counted, and as outer guard a clock.

Whoever works passes checkpoints: ``spend(n)`` before a step of about n operations. Whoever asks
for the work sets limits around it::

    with limited(operations=10**6, error=UnsupportedError("too hard")):
        ...

What is counted comes out the same on every machine, so operations may decide what is answered; a
clock may only break off. Limits nest, and hold in the thread that sets them and in no other: there
is no signal, and no state is left behind.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache, wraps
from threading import local
from typing import Any, TypeVar

from restitution.errors import RestitutionError, TimeLimitError, UnsupportedError

_F = TypeVar("_F", bound=Callable[..., Any])
_CURRENT: ContextVar[Limit | None] = ContextVar("limit of work", default=None)


class Limit:
    """One limit in force.

    ``left`` are operations, or None where they do not matter, ``used`` those counted so far;
    ``broken`` tells that something was broken off because its clock ran out.
    """

    __slots__ = ("_end", "_error", "_outer", "broken", "left", "used")

    def __init__(
        self,
        outer: Limit | None,
        seconds: float | None,
        operations: int | None,
        error: RestitutionError | None,
    ) -> None:
        self._outer = outer
        self._end = None if seconds is None else time.monotonic() + seconds
        self._error = error
        self.left = operations
        self.used = 0
        self.broken = False

    def spend(self, operations: int) -> None:
        """Count a step, here and in the limits around it; raises the error of one that is over."""
        limit: Limit | None = self
        while limit is not None:
            limit.used += operations
            if limit.left is not None:
                limit.left -= operations
                if limit.left < 0:
                    raise limit.error(UnsupportedError("this takes too many steps to work out"))
            if limit._end is not None and time.monotonic() >= limit._end:
                limit.broken = True
                raise limit.error(TimeLimitError("this was not done within its time limit"))
            limit = limit._outer

    def confirm(self) -> None:
        """Raise again what a clock has raised in this block, had somebody passed over it."""
        limit: Limit | None = self
        while limit is not None:
            if limit.broken:
                raise limit.error(TimeLimitError("this was not done within its time limit"))
            limit = limit._outer

    def error(self, usual: RestitutionError) -> RestitutionError:
        """An error of this limit, made anew: one that was raised carries its traceback."""
        if self._error is None:
            return usual
        return type(self._error)(self._error.message, self._error.line, self._error.column)


@contextmanager
def limited(
    seconds: float | None = None,
    operations: int | None = None,
    error: RestitutionError | None = None,
) -> Iterator[Limit]:
    """Limit the work inside the block, beside the limits that are in force around it.

    The first checkpoint beyond ``seconds`` or ``operations``, and every one after it, raises
    ``error``; without that, TimeLimitError for the clock and UnsupportedError for operations.
    """
    limit = Limit(_CURRENT.get(), seconds, operations, error)
    token = _CURRENT.set(limit)
    try:
        yield limit
    finally:
        _CURRENT.reset(token)


def seconds_of(time_limit: Any) -> float | None:
    """A time limit as a caller gives it, in seconds; None where there is none (None, or 0).

    Raises ValueError for one that is negative, or no number.
    """
    if time_limit is None:
        return None
    if not isinstance(time_limit, int | float) or not time_limit >= 0:
        raise ValueError(f"a time limit is a number of seconds, 0 for none, and not {time_limit!r}")
    return time_limit or None


def spend(operations: int = 1) -> None:
    """A checkpoint: so many operations are about to be done. Raises the error of a limit."""
    limit = _CURRENT.get()
    if limit is not None:
        limit.spend(operations)


def seconds_left() -> float | None:
    """Seconds until the first clock in force runs out, None without one: for who passes no
    checkpoints meanwhile.
    """
    limit, ends = _CURRENT.get(), []
    while limit is not None:
        if limit._end is not None:
            ends.append(limit._end)
        limit = limit._outer
    return min(ends) - time.monotonic() if ends else None


def confirm() -> None:
    """Before a result is kept: raise again what a clock has raised, had it been passed over.

    Much of the work tries several ways, and takes an error for "not this way".
    """
    limit = _CURRENT.get()
    if limit is not None:
        limit.confirm()


def remembered(maxsize: int) -> Callable[[_F], _F]:
    """Keep the results of a function, as ``lru_cache`` does, with the operations they took.

    A result that is taken from the store counts as much as one that is worked out: what is refused
    is the same, whatever was asked before; one for which a clock was passed over is not kept, but
    its error raised again. The function has ``cache_clear``, and arguments by
    position that can be hashed.
    """

    def decorate(function: _F) -> _F:
        state = local()

        @lru_cache(maxsize=maxsize)
        def kept(*arguments: Any) -> tuple[Any, int]:
            with limited() as limit:
                value = function(*arguments)
                limit.confirm()
            state.fresh = True
            return value, limit.used

        @wraps(function)
        def wrapper(*arguments: Any) -> Any:
            state.fresh = False
            value, used = kept(*arguments)
            if used and not state.fresh:
                spend(used)
            return value

        wrapper.cache_clear = kept.cache_clear  # type: ignore[attr-defined]
        return wrapper  # type: ignore[return-value]

    return decorate
