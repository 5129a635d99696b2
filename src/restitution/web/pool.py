"""Work in processes that can be killed, and no more of it than can be done."""

from __future__ import annotations

import asyncio
import logging
import math
import multiprocessing
import os
import signal
import sys
import threading
import time
from collections.abc import AsyncIterator, Callable, Sequence
from concurrent.futures.process import BrokenProcessPool
from contextlib import asynccontextmanager, suppress
from typing import Any, Protocol, TypeVar

from pebble import ProcessExpired, ProcessPool

from restitution.killable import LostError, limit_memory, portable

_log = logging.getLogger(__name__)

_LOADED = "restitution.web.loaded"
"""What all processes begin with."""

_POLITE = 5
"""By how much they are nicer than the server."""

_GRACE = 2.0
"""Seconds after the limit of the work itself at which its process is killed."""

_TASKS = 500
"""After so many tasks a process makes place for a fresh one: what a library keeps, grows."""

_SPENT = 75
"""The exit status of a process that would rather not begin another task."""

_AFTERWARDS = 2
"""Seconds after which to ask again when all processes are told to end, the server among them."""

_ABANDONED = 0.5
"""Seconds for which work goes on that nobody waits for any more: most of it is done by then, and to
kill its process and begin another would take as long."""

_LOOKED = 0.5
"""Seconds for which one who finds no place looks for one, so many times."""

_LOOKS = 10

_LONGEST_WAIT = 30
"""Seconds after which a client is told to come back, at most."""


class Tiring(Protocol):
    """What work returns: whether it was broken off, and its process should do no more."""

    @property
    def tired(self) -> bool: ...


_Made = TypeVar("_Made", bound=Tiring)


class BusyError(Exception):
    """So much work is waiting that no more is taken; ``again`` is when to ask again (seconds)."""

    def __init__(self, again: int) -> None:
        super().__init__(f"ask again in {again} s")
        self.again = again


@asynccontextmanager
async def pool(workers: int, waiting: int, patience: float) -> AsyncIterator[Pool]:
    """So many processes, which begin at once, and are killed in the end."""
    made = Pool(workers, waiting, patience)
    try:
        yield made
    finally:
        await made.close()


class Pool:
    """Processes, and a queue before them that has an end. Belongs to one event loop.

    ``patience`` is how many seconds anyone waits in it.
    """

    def __init__(self, workers: int, waiting: int, patience: float) -> None:
        self._workers = workers
        self._most = workers + waiting
        self._patience = patience
        self._under_way = 0
        self._usual = 0.1  # seconds that a task takes, about
        self._free = asyncio.Semaphore(workers)
        self._crew = _Crew(workers)
        self._parting: set[asyncio.Task[None]] = set()
        self._closed = False

    async def run(self, function: Callable[..., _Made], *arguments: Any, limit: float) -> _Made:
        """What the function returns; where that is ``tired``, it is the last of its process.

        When it is cancelled, work that has not begun is dropped; what has begun may end, if it does
        so soon, and keeps its place until then. Raises BusyError where too much waits, TimeoutError
        after ``limit`` seconds of work, and LostError where its process ended or failed.
        """
        await self._place()
        self._under_way += 1
        try:
            await self._turn()
        except BaseException:
            self._under_way -= 1
            raise
        working = asyncio.create_task(self._done(function, arguments, limit))
        working.add_done_callback(self._release)
        try:
            return await asyncio.shield(working)
        except asyncio.CancelledError:
            asyncio.get_running_loop().call_later(_ABANDONED, working.cancel)
            raise

    def _release(self, working: asyncio.Task[Any]) -> None:
        self._free.release()
        self._under_way -= 1
        if not working.cancelled():
            working.exception()  # told to whoever asked, if somebody still does

    async def close(self) -> None:
        """Kill the processes."""
        self._closed = True
        await asyncio.gather(self._crew.dismissed(), *self._parting)

    @property
    def again(self) -> int:
        """Seconds until there is likely to be place."""
        ahead = self._under_way * self._usual / self._workers
        return max(1, min(math.ceil(ahead), _LONGEST_WAIT))

    async def _place(self) -> None:
        """Wait a moment for a place: whoever has left may not have been missed yet."""
        for _ in range(_LOOKS):
            if self._under_way < self._most:
                return
            await asyncio.sleep(_LOOKED / _LOOKS)
        raise BusyError(self.again)

    async def _turn(self) -> None:
        try:
            await asyncio.wait_for(self._free.acquire(), self._patience)
        except TimeoutError:
            raise BusyError(self.again) from None

    async def _done(
        self, function: Callable[..., _Made], arguments: Sequence[Any], limit: float
    ) -> _Made:
        crew = self._crew
        crashes = 0
        for _ in range(2 * self._workers + 2):
            began = time.monotonic()
            try:
                return await crew.done(function, arguments, limit + _GRACE)
            except ProcessExpired as error:
                if abs(error.exitcode) == signal.SIGTERM:
                    raise BusyError(_AFTERWARDS) from error
                # Once more, in case it was ended for the sake of work that somebody gave up.
                crashes += error.exitcode != _SPENT
                if crashes > 1:
                    raise LostError("the process that solves ended without an answer") from error
            except (BrokenProcessPool, RuntimeError) as error:
                self._replace(crew)
                raise BusyError(_AFTERWARDS) from error
            finally:
                self._usual += 0.1 * (time.monotonic() - began - self._usual)
        raise LostError("no process took the work")

    def _replace(self, crew: _Crew) -> None:
        """Other processes in place of those from which nothing can come any more."""
        if crew is self._crew and not self._closed:
            _log.error("all processes were lost; others are begun")
            self._crew = _Crew(self._workers)
            parting = asyncio.create_task(crew.dismissed())
            self._parting.add(parting)
            parting.add_done_callback(self._parting.discard)


class _Crew:
    """The processes, from their beginning to their end."""

    def __init__(self, workers: int) -> None:
        forks = not sys.platform.startswith("win")
        context: Any = multiprocessing.get_context("forkserver" if forks else "spawn")
        if forks:
            # Libraries are loaded there, and a process that was killed is soon there again.
            context.set_forkserver_preload([_LOADED])
        self._processes: Any = ProcessPool(workers, _TASKS, _settled, context=context)
        self._begun = asyncio.create_task(asyncio.to_thread(self._begin))

    def _begin(self) -> None:
        """Have all begin, which lasts until the libraries are loaded."""
        mask = getattr(signal, "pthread_sigmask", None)
        # Ctrl-C goes to all processes of the terminal, and only the server is to heed it.
        kept = mask(signal.SIG_BLOCK, {signal.SIGINT}) if mask else None
        try:
            self._processes.schedule(_ready).result()
        finally:
            if mask:
                mask(signal.SIG_SETMASK, kept)

    async def done(
        self, function: Callable[..., _Made], arguments: Sequence[Any], seconds: float
    ) -> _Made:
        """What the function returns or raises; killed after so many seconds."""
        await asyncio.shield(self._begun)
        future = self._processes.schedule(_serve, args=(function, arguments), timeout=seconds)
        made: _Made = await asyncio.wrap_future(future)
        return made

    async def dismissed(self) -> None:
        """Nothing; the processes have ended."""
        with suppress(Exception):  # told to whoever asked
            await self._begun
        self._processes.stop()
        await asyncio.to_thread(self._processes.join)


def _settled() -> None:
    """In a process that begins: it takes no more than its share of memory, and yields to others.

    So the server itself, which has little to do, is never kept waiting by those who solve.
    """
    limit_memory()
    if hasattr(os, "nice"):
        os.nice(_POLITE)


def _ready() -> None:
    """Nothing; who comes to do it has begun."""


_tired = threading.Event()
"""Set in a process whose work was broken off: a library may have been left half done."""


def _serve(function: Callable[..., _Made], arguments: Sequence[Any]) -> _Made:
    """In the process: what the function returns.

    The process ends when it is given more, not at once: it must never be in the midst of a
    message to the others.
    """
    if _tired.is_set():
        os._exit(_SPENT)
    try:
        made = function(*arguments)
    except BaseException as error:  # noqa: BLE001 - told to the one who asks
        _tired.set()
        raise portable(error) from None
    if made.tired:
        _tired.set()
    return made
