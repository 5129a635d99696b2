"""A time limit for every test, which fails with the statement that was worked on when it ended.

pytest-timeout says how long a test may take; what happens then is told here.
"""

from __future__ import annotations

import faulthandler
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from types import FrameType
from typing import Any

import pytest

from restitution.language import parse, to_statement
from restitution.problem import Problem

_LONGEST = 4000
"""Characters of a statement that are printed."""

_GRACE = 60
"""So many seconds after a time limit the whole process ends: a long step in compiled code comes
back to no line of Python. It prints where it was, and pytest-xdist names the test."""

_AGAIN = 20
"""Seconds after which it rings again: Python drops an error that comes as an object is deleted."""


class TooSlow(BaseException):
    """A test has not ended within its time limit.

    No Exception: what is tested may not catch it. And no failure in the eyes of Hypothesis, which
    would run the example again, to make it smaller, and without a limit.
    """


def pytest_timeout_set_timer(item: pytest.Item, settings: Any) -> bool | None:
    """Start the clock of a test; None where pytest-timeout has to do what it can, without signals.

    A hook of pytest-timeout.
    """
    main = threading.current_thread() is threading.main_thread()
    if settings.method != "signal" or not main or not hasattr(signal, "setitimer"):
        return None

    def ring(number: int, frame: FrameType | None) -> None:
        raise TooSlow(f"no end within {settings.timeout:g} s\n{worked_on(frame)}")

    def cancel() -> None:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        faulthandler.cancel_dump_traceback_later()

    item.cancel_timeout = cancel  # type: ignore[attr-defined] # called by pytest-timeout
    signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, settings.timeout, _AGAIN)
    last = settings.timeout + _GRACE
    faulthandler.dump_traceback_later(last, exit=True, file=sys.__stderr__)
    return True


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> None:
    """Ring no more where it was heard: pytest may take long for the report."""
    if call.excinfo is not None and call.excinfo.errisinstance(TooSlow):
        signal.setitimer(signal.ITIMER_REAL, 0)


def worked_on(frame: FrameType | None) -> str:
    """The statement that is read, solved or explained in a frame, or in one that called it."""
    texts = [text for each in _callers(frame) if (text := _statement(each)) is not None]
    if not texts:
        return "(no statement was being worked on)"
    text = texts[-1].strip("\n")  # as the test gave it, before anything was made of it
    short = text if len(text) <= _LONGEST else f"{text[:_LONGEST]}\n[{len(text)} characters in all]"
    return f"while this was worked on:\n\n{short}"


def _callers(frame: FrameType | None) -> Iterator[FrameType]:
    while frame is not None:
        yield frame
        frame = frame.f_back


def _statement(frame: FrameType) -> str | None:
    """What a function of the package, or a command that a test has begun, works on."""
    names = frame.f_locals
    if frame.f_code is subprocess.run.__code__:
        given = names.get("input")
        return given.decode(errors="replace") if isinstance(given, bytes) else given or None
    if frame.f_code is parse.__code__:
        text = names["text"]
        return text if isinstance(text, str) else text.decode(errors="replace")
    if not frame.f_globals.get("__name__", "").startswith("restitution."):
        return None
    for value in names.values():
        problem = value if isinstance(value, Problem) else getattr(value, "problem", None)
        if isinstance(problem, Problem):
            return to_statement(problem)
    return None
