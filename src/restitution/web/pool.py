"""Work in processes that can be killed, and no more of it than can be done."""

from __future__ import annotations

import asyncio
import math
import multiprocessing
import os
import signal
import sys
import threading
import time
from collections.abc import AsyncIterator, Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager, suppress
from functools import partial
from typing import Any, Protocol, TypeVar

from restitution.killable import EndedError, Worker
from restitution.records import dataclass

_LOADED = "restitution.web.loaded"
"""What all processes begin with."""

_POLITE = 5
"""By how much they are nicer than the server."""

_GRACE = 2.0
"""Seconds after the limit of the work itself at which its process is killed."""

_TASKS = 500
"""After so many tasks a process makes place for a fresh one: what a library keeps, grows."""

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


_Result = TypeVar("_Result", bound=Tiring)


class BusyError(Exception):
    """So much work is waiting that no more is taken; ``again`` is when to ask again (seconds)."""

    def __init__(self, again: int) -> None:
        super().__init__(f"ask again in {again} s")
        self.again = again


@asynccontextmanager
async def pool(workers: int, waiting: int, patience: float) -> AsyncIterator[Pool]:
    """A pool of processes, which begin at once and are killed in the end."""
    pool_ = Pool(workers, waiting, patience)
    try:
        yield pool_
    finally:
        await pool_.close()


class Pool:
    """Processes, and a queue before them that has an end. Belongs to one event loop.

    ``patience`` is how many seconds anyone waits in it. Of the processes that are free, the one
    that worked last takes the next task: whoever edits a question finds it known there.
    """

    def __init__(self, workers: int, waiting: int, patience: float) -> None:
        self._workers = workers
        self._most = workers + waiting
        self._patience = patience
        self._under_way = 0
        self._usual = 0.1  # seconds that a task takes, about
        self._free = asyncio.Semaphore(workers)
        self._hands = [_Hand() for _ in range(workers)]
        self._idle = list(self._hands)  # as many as the semaphore has places
        self._closed = False

    async def run(self, function: Callable[..., _Result], *arguments: Any, limit: float) -> _Result:
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
        hand = self._idle.pop()
        working = asyncio.create_task(self._done(hand, function, arguments, limit))
        working.add_done_callback(partial(self._release, hand))
        try:
            return await asyncio.shield(working)
        except asyncio.CancelledError:
            asyncio.get_running_loop().call_later(_ABANDONED, working.cancel)
            raise

    def _release(self, hand: _Hand, working: asyncio.Task[Any]) -> None:
        self._idle.append(hand)
        self._free.release()
        self._under_way -= 1
        if not working.cancelled():
            working.exception()  # told to whoever asked, if somebody still does

    async def close(self) -> None:
        """Kill the processes."""
        self._closed = True
        await asyncio.gather(*(asyncio.to_thread(hand.dismiss) for hand in self._hands))

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
        self, hand: _Hand, function: Callable[..., _Result], arguments: Sequence[Any], limit: float
    ) -> _Result:
        began = time.monotonic()
        try:
            try:
                return await hand.done(function, arguments, limit + _GRACE)
            except EndedError as error:
                if self._closed or error.code == -signal.SIGTERM:
                    raise BusyError(_AFTERWARDS) from error
            # Once more: nobody here ends a process whose work is wanted, but the system may.
            return await hand.done(function, arguments, limit + _GRACE)
        finally:
            self._usual += 0.1 * (time.monotonic() - began - self._usual)


@dataclass
class _Turn:
    """One piece of work of a process, and whether nobody wants it any more."""

    is_over: bool = False


class _Hand:
    """One process and the thread that asks it, with a pipe of their own.

    What is sent to the process is for it alone, and it is ended only in the midst of work that
    nobody wants. So nothing is lost between one that ends and another that begins.
    """

    def __init__(self) -> None:
        self._thread = ThreadPoolExecutor(1, initializer=_deaf)
        self._lock = threading.Lock()
        self._worker: Worker | None = None
        self._turn: _Turn | None = None
        self._tasks = 0
        self._dismissed = False
        self._thread.submit(self._renew)

    async def done(
        self, function: Callable[..., _Result], arguments: Sequence[Any], seconds: float
    ) -> _Result:
        """What the function returns or raises; its process is killed after so many seconds."""
        turn = _Turn()
        loop = asyncio.get_running_loop()
        request = function, arguments
        try:
            reply: _Result = await loop.run_in_executor(
                self._thread, self._ask, turn, request, seconds
            )
        except asyncio.CancelledError:
            self._give_up(turn)
            raise
        return reply

    def dismiss(self) -> None:
        """End the process and the thread; lasts until both have ended."""
        with self._lock:
            self._dismissed = True
            if self._worker is not None:
                self._worker.kill()
        self._thread.shutdown(cancel_futures=True)
        if self._worker is not None:
            self._worker.close()

    def _give_up(self, turn: _Turn) -> None:
        with self._lock:
            turn.is_over = True
            if self._turn is turn and self._worker is not None:
                self._worker.kill()

    def _ask(self, turn: _Turn, request: Any, seconds: float) -> Any:
        """In the thread: what the process answers. What does not end well is its last."""
        worker = self._begin() if self._worker is None else self._worker
        with self._lock:
            is_wanted = not turn.is_over and not self._dismissed
            self._turn = turn if is_wanted else None
        if not is_wanted:
            raise BusyError(_AFTERWARDS)
        is_fit = False
        try:
            reply = worker.ask(request, seconds)
            is_fit = not reply.tired
            return reply
        finally:
            self._tasks += 1
            with self._lock:
                self._turn = None
                is_fresh = not turn.is_over and self._tasks < _TASKS
                if not (is_fit and is_fresh) and not self._dismissed:
                    self._thread.submit(self._renew)  # before anything else

    def _renew(self) -> None:
        """In the thread: another process in place of this one."""
        if self._worker is not None:
            self._worker.close()
            self._worker = None
        if not self._dismissed:
            with suppress(BusyError):  # tried again for whoever comes
                self._begin()

    def _begin(self) -> Worker:
        self._tasks = 0
        try:
            self._worker = Worker(_serve, _settled, context=_context())
        except (OSError, EOFError) as error:
            raise BusyError(_AFTERWARDS) from error
        return self._worker


def _context() -> Any:
    forks = not sys.platform.startswith("win")
    context: Any = multiprocessing.get_context("forkserver" if forks else "spawn")
    if forks:
        # Libraries are loaded there, and a process that was killed is soon there again.
        context.set_forkserver_preload([_LOADED])
    return context


def _deaf() -> None:
    """Ctrl-C goes to all processes of the terminal, and only the server is to heed it.

    What is begun by this thread, the process that loads the libraries too, is deaf like it.
    """
    mask = getattr(signal, "pthread_sigmask", None)
    if mask:
        mask(signal.SIG_BLOCK, {signal.SIGINT})


def _settled() -> None:
    """In a process that begins: it yields to others.

    So the server itself, which has little to do, is never kept waiting by those who solve.
    """
    if hasattr(os, "nice"):
        os.nice(_POLITE)


def _serve(request: tuple[Callable[..., Any], Sequence[Any]]) -> Any:
    """In the process: what the function returns."""
    function, arguments = request
    return function(*arguments)
