"""Work in processes that can be killed, and no more of it than can be done."""

from __future__ import annotations

import asyncio
import multiprocessing
import sys
from collections.abc import Callable
from typing import Any

from pebble import ProcessExpired, ProcessPool

from restitution.export.job import prepare
from restitution.killable import LostError

_GRACE = 2.0
"""Seconds after the limit of the work itself at which its process is killed."""


class BusyError(Exception):
    """So much work is waiting that no more is taken."""


class Pool:
    """Processes that load the algebra once, and a queue before them that has an end."""

    def __init__(self, workers: int, waiting: int) -> None:
        forks = not sys.platform.startswith("win")
        context: Any = multiprocessing.get_context("forkserver" if forks else "spawn")
        if forks:
            # The algebra is loaded there, and a process that was killed is soon there again.
            context.set_forkserver_preload(
                ["restitution.solve", "restitution.explain", "restitution.export.answers"]
            )
        self._most = workers + waiting
        self._under_way = 0
        self._processes: Any = ProcessPool(
            max_workers=workers, initializer=prepare, context=context
        )

    async def run(self, function: Callable[..., Any], *arguments: Any, limit: float) -> Any:
        """What the function returns or raises.

        Raises BusyError where too much waits, TimeoutError after ``limit`` seconds of work, and
        LostError where its process ended.
        """
        if self._under_way >= self._most:
            raise BusyError
        self._under_way += 1
        try:
            future = self._processes.schedule(function, args=arguments, timeout=limit + _GRACE)
            return await asyncio.wrap_future(future)
        except ProcessExpired as error:
            raise LostError("the process that solves ended without an answer") from error
        finally:
            self._under_way -= 1

    def close(self) -> None:
        """Kill the processes."""
        self._processes.stop()
        self._processes.join()
