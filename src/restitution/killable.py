"""Work in a process of its own, which can be stopped at any moment.

A thread cannot be stopped in Python, and a computation inside a library does not look at a clock;
a process can be killed. The one who asks needs none of the libraries of the work, so that they
are loaded in one place only, and meanwhile the asker can read its input.

On Linux the process is a fork, elsewhere a fresh interpreter, unless something else is chosen; so
``serve``, ``prepare`` and ``rehearse`` have to be functions of a module.
"""

from __future__ import annotations

import contextlib
import math
import multiprocessing
import signal
import sys
import traceback
from collections.abc import Callable
from types import TracebackType
from typing import Any, Self

_START = 120.0
"""Seconds for which loading the libraries may last: they are not part of what is limited."""

_PARTING = 1.0
"""Seconds for which a process that has closed its pipe may still take to end."""

_MEMORY = 4 * 2**30
"""Bytes of memory that the work may take, where the system can limit that."""


class LostError(Exception):
    """The work ended otherwise than with an answer; ``details`` is a traceback, or empty."""

    def __init__(self, message: str, details: str = "") -> None:
        super().__init__(message)
        self.details = details

    def __reduce__(self) -> tuple[type[LostError], tuple[str, str]]:
        return type(self), (str(self), self.details)


class EndedError(LostError):
    """The process ended in the midst of the work; ``code`` is its exit status, if it has one."""

    def __init__(self, code: int | None) -> None:
        super().__init__("the process that solves ended without an answer")
        self.code = code

    def __reduce__(self) -> tuple[type[EndedError], tuple[Any, ...]]:
        return type(self), (self.code,)


class Worker:
    """A process that answers requests one after another with ``serve(request)``.

    It starts at once and calls ``prepare`` (loading libraries) while the caller does something
    else. If no request is there by then, it calls ``rehearse``, after which the first request is
    answered sooner. After it was stopped, the next request starts it anew. Use it as a context
    manager. ``context`` is that of `multiprocessing` from which the process comes.
    """

    def __init__(
        self,
        serve: Callable[[Any], Any],
        prepare: Callable[[], None],
        rehearse: Callable[[], None] | None = None,
        context: Any = None,
    ) -> None:
        self._work = serve, prepare, rehearse
        self._context: Any = context or multiprocessing.get_context(
            "fork" if sys.platform.startswith("linux") else "spawn"
        )
        self._process: Any = None
        self._pipe: Any = None
        self._ready = False
        self._start()

    def ask(self, request: Any, limit: float | None = None) -> Any:
        """The answer, or what ``serve`` raised, raised again here where it can be pickled.

        Raises TimeoutError after ``limit`` seconds (None is no limit), and LostError where the
        process failed, EndedError where it ended; it is killed then.
        """
        if self._process is None:
            self._start()
        try:
            try:
                # Before it is ready: so it sees that there is no time to rehearse.
                self._pipe.send((request, limit))
            except BrokenPipeError:
                if self._ready:
                    raise
                # It ended while it was loading, and may have left word why.
            if not self._ready:
                self._receive(_START)
                self._ready = True
            return self._receive(limit)
        except TimeoutError:
            self.close()
            raise
        except (EOFError, OSError) as error:
            self._process.join(_PARTING)
            code = self._process.exitcode
            self.close()
            raise EndedError(code) from error
        except BaseException as error:
            # An error of the work leaves the process fit for the next; Ctrl-C does not.
            if not isinstance(error, Exception):
                self.close()
            raise

    def kill(self) -> None:
        """End the process, from any thread: whoever asks it is told so. It is not closed."""
        process = self._process
        if process is not None:
            process.kill()

    def close(self) -> None:
        """Kill the process; it holds nothing that could be lost."""
        process, pipe = self._process, self._pipe
        self._process = self._pipe = None
        self._ready = False
        if process is not None:
            # Killed first: a process that sees the pipe closed would complain of it.
            process.kill()
            process.join()
            process.close()
            pipe.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _start(self) -> None:
        self._pipe, theirs = self._context.Pipe()
        process: Any = self._context.Process
        self._process = process(target=_live, args=(theirs, self._pipe, *self._work), daemon=True)
        self._process.start()
        theirs.close()

    def _receive(self, limit: float | None) -> Any:
        if not self._pipe.poll(limit):
            raise TimeoutError
        good, value = self._pipe.recv()
        if not good:
            raise value
        return value


def _live(
    pipe: Any,
    other: Any,
    serve: Callable[[Any], Any],
    prepare: Callable[[], None],
    rehearse: Callable[[], None] | None,
) -> None:
    """The life of the process."""
    # A fork holds a copy of the asker's end: while that is open, no end of file is seen.
    other.close()
    # Ctrl-C goes to all processes of the terminal; the asker decides what it means.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    limit_memory()
    try:
        prepare()
        pipe.send((True, None))
    except (BrokenPipeError, ConnectionResetError):
        return  # nobody is there any more
    except BaseException as error:  # noqa: BLE001 - told to the one who asks
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            pipe.send((False, portable(error)))
        return
    if rehearse is not None and not pipe.poll():
        with contextlib.suppress(Exception):  # whatever it is, a request will tell
            rehearse()
    while True:
        try:
            request, limit = pipe.recv()
        except EOFError:
            return
        _end_by_itself(limit)
        reply: tuple[bool, Any]
        try:
            reply = True, serve(request)
        except BaseException as error:  # noqa: BLE001 - told to the one who asks
            reply = False, portable(error)
        _end_by_itself(None)
        try:
            pipe.send(reply)
        except (BrokenPipeError, ConnectionResetError):
            return


def portable(error: BaseException) -> Exception:
    """An error that can be sent: those of this package as they are, others by their traceback."""
    if isinstance(error, MemoryError):
        return LostError("there is not memory enough for this")
    if isinstance(error, Exception) and hasattr(error, "kind") and hasattr(error, "message"):
        return error
    return LostError("a fault of the program", "".join(traceback.format_exception(error)))


def limit_memory() -> None:
    """Let this process take no more memory than work may, where the system can limit that."""
    try:
        import resource
    except ImportError:  # not on Windows
        return
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    sizes = [size for size in (soft, hard, _MEMORY) if size != resource.RLIM_INFINITY]
    with contextlib.suppress(ValueError, OSError):  # macOS refuses
        resource.setrlimit(resource.RLIMIT_AS, (min(sizes), hard))


def _end_by_itself(limit: float | None) -> None:
    """Let the system end this process if the asker is gone and cannot."""
    if hasattr(signal, "alarm"):
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.alarm(0 if limit is None else math.ceil(limit) + 5)
