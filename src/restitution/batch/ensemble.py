"""One function for many cases, on all processors of a machine or of many machines.

>>> from math import sqrt
>>> from restitution import ensemble
>>> result = ensemble(sqrt, [4, 9, -1])
>>> result.values
(2.0, 3.0, None)
>>> print(result)
3 cases: 2 worked out, 1 failed
  case 2, -1: ValueError: math domain error
"""

from __future__ import annotations

import operator
import os
import pickle
import signal
import time
import traceback
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence, Sized
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ProcessPoolExecutor,
    wait,
)
from dataclasses import field
from itertools import islice
from typing import Any, Generic, TypeVar

from restitution.batch.progress import progress as progress_bar
from restitution.counting import counted
from restitution.errors import RestitutionError, StatementError
from restitution.records import dataclass

T = TypeVar("T")

CHUNK_SECONDS = 0.2
"""Cases are sent in chunks of about so much work, so that sending them costs little."""

DEATHS = 5
"""After so many deaths of worker processes with nothing worked out between them, no more start."""

GRACE = 5
"""Seconds in which a broken executor is to say so of all that it had under way."""

_SHOWN, _LONGEST = 5, 80  # failures in a summary, and characters of what is told of them


@dataclass(frozen=True, slots=True)
class Failure:
    """A case that could not be worked out: its place among the cases from 0, and what happened.

    ``error`` is the type and message of the exception; ``traceback`` is text, as it was where the
    function ran.
    """

    index: int
    case: Any
    error: str
    traceback: str = field(default="", repr=False)


@dataclass(frozen=True)
class Ensemble(Generic[T]):
    """What came of the cases.

    ``values`` are in the order of the cases, whatever was finished first, with None for each case
    in ``failures`` and in ``missing``. Missing are the numbers of cases that were not worked out
    because it was stopped, and ``stopped`` says by what.
    """

    values: tuple[T | None, ...]
    failures: tuple[Failure, ...] = ()
    missing: tuple[int, ...] = ()
    stopped: str = ""

    def all_values(self) -> tuple[T, ...]:
        """The values, where every case has one. Raises RestitutionError with a summary if not."""
        if self.failures or self.missing or self.stopped:
            raise RestitutionError(str(self))
        return self.values  # type: ignore[return-value]

    def __str__(self) -> str:
        done = len(self.values) - len(self.failures) - len(self.missing)
        counts = [f"{done} worked out", f"{len(self.failures)} failed"]
        if self.missing:
            counts.append(f"{len(self.missing)} not begun or not finished")
        lines = [f"{counted(len(self.values), 'case')}: {', '.join(counts)}"]
        if self.stopped:
            lines.append(f"  stopped: {self.stopped}")
        for failure in self.failures[:_SHOWN]:
            lines.append(f"  case {failure.index}, {_shown(failure.case)}: {_brief(failure.error)}")
        if len(self.failures) > _SHOWN:
            lines.append(f"  and {len(self.failures) - _SHOWN} more in .failures")
        return "\n".join(lines)


class EnsembleInterrupt(KeyboardInterrupt):
    """Ctrl-C while an ensemble was at work; ``ensemble`` holds what had been done until then."""

    def __init__(self, ensemble: Ensemble[Any]) -> None:
        super().__init__(str(ensemble))
        self.ensemble = ensemble


def ensemble(
    function: Callable[..., T],
    cases: Iterable[Any],
    executor: Executor | None = None,
    *,
    seed: int | Sequence[int] | None = None,
    workers: int | None = None,
    progress: bool | None = None,
) -> Ensemble[T]:
    """``function(case)`` for every case, at the same time where there are processors for it.

    ``executor`` is any of ``concurrent.futures``, or another library's of that kind: Dask's
    ``client.get_executor()`` reaches many machines. By default it is a pool of processes, to which
    the function is sent by its name. ``workers`` is how many cases the executor works on at the
    same time, by default as many as this machine has processors; no more than twice as many chunks
    of cases are under way, so that ``cases`` may be a generator of any length.

    With a ``seed`` the function is called as ``function(case, rng=…)``, with a random generator of
    NumPy for each case: that of ``SeedSequence(seed).spawn(…)`` at its place. So the numbers depend
    on the seed and the place of a case alone, not on the executor or the number of workers.

    What fails is no reason to stop: an exception in the function is kept in ``failures`` with its
    case. What could not be sent to a worker or back is tried once more. If a worker process of the
    default pool dies, the cases that were under way are tried once more, one after another, and
    that which kills its worker is the one that failed. An executor that
    is given cannot be started again; when it breaks, the cases under way count as failed, and the
    others are ``missing``. Where ``cases`` themselves raise an exception, those before it are
    worked out, and ``stopped`` tells of it.

    ``progress`` shows a bar with the rate and the time left, by default on a terminal.

    Raises:
        StatementError: the function cannot be sent to other processes, ``workers`` is no whole
            number from 1, ``seed`` is no seed of NumPy, ``cases`` cannot be gone through, or
            ``executor`` takes no work.
        EnsembleInterrupt: Ctrl-C; its ``ensemble`` has what was done.
    """
    count = (os.cpu_count() or 1) if workers is None else _checked_workers(workers)
    if executor is None:
        _check_sendable(function)
    elif not hasattr(executor, "submit"):
        raise StatementError(f"the executor is {executor!r}, which takes no work: it has no submit")
    if seed is not None:
        _check_seed(seed)
    try:
        drawn = iter(cases)
    except TypeError as error:
        raise StatementError(f"the cases are {cases!r}, and not several") from error
    total = len(cases) if isinstance(cases, Sized) else None
    run = _Run(function, seed, drawn, executor, count)
    try:
        with progress_bar(total, "cases", progress) as report:
            for done in run.work():
                report(done)
    except KeyboardInterrupt:
        run.stopped = "Ctrl-C"
        raise EnsembleInterrupt(run.result(total)) from None
    finally:
        run.close()
    return run.result(total)


_Chunk = list[tuple[int, Any]]  # cases with their places

# --- in the worker -----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Error:
    """An exception as text: not every exception can be sent from process to process."""

    error: str
    traceback: str


def _chunk_worked_out(
    function: Callable[..., Any], seed: int | Sequence[int] | None, chunk: _Chunk
) -> tuple[float, list[Any]]:
    """How long it took, and a value or an ``_Error`` for each case."""
    start = time.perf_counter()
    results: list[Any] = []
    for index, case in chunk:
        try:
            results.append(_worked_out(function, seed, index, case))
        except Exception as error:  # noqa: BLE001 - whatever a user's function raises is kept
            results.append(_Error(_described(error), traceback.format_exc()))
    return time.perf_counter() - start, results


def _worked_out(
    function: Callable[..., Any], seed: int | Sequence[int] | None, index: int, case: Any
) -> Any:
    if seed is None:
        return function(case)
    import numpy as np

    seeds = np.random.SeedSequence(seed, spawn_key=(index,))
    return function(case, rng=np.random.default_rng(seeds))


def _ignore_interrupts() -> None:
    """Ctrl-C is for the process that started the workers."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


# --- in the process that started them ------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Sent:
    """A chunk under way: whether its cases are tried for a second time, and nothing beside it."""

    chunk: _Chunk
    again: bool
    alone: bool


class _Run:
    """Cases on their way through an executor."""

    def __init__(
        self,
        function: Callable[..., Any],
        seed: int | Sequence[int] | None,
        cases: Iterator[Any],
        executor: Executor | None,
        workers: int,
    ) -> None:
        self._function, self._seed = function, seed
        self._numbered = enumerate(cases)
        self._workers = workers
        self._given = executor
        self._executor = executor
        self._size = 1  # of the next chunk
        self._under_way: dict[Future[Any], _Sent] = {}
        self._again: deque[_Chunk] = deque()
        self._one_by_one = False  # so that it is known what a worker died of
        self._deaths = 0
        self._begun = 0
        self._no_more_cases = ""  # why
        self._values: dict[int, Any] = {}
        self._failures: list[Failure] = []
        self.stopped = ""

    def work(self) -> Iterator[int]:
        """Work, and yield now and then how many cases are done."""
        while not self.stopped and self._send():
            finished, _ = wait(self._under_way, return_when=FIRST_COMPLETED)
            for future in finished:
                self._finish(future)
            yield len(self._values) + len(self._failures)
        self.stopped = self.stopped or self._no_more_cases

    def result(self, total: int | None) -> Ensemble[Any]:
        """What came of it so far; ``total`` is how many cases there are, if known."""
        for future in [
            chunk_future
            for chunk_future in self._under_way
            if chunk_future.done() and not chunk_future.cancelled()
        ]:
            self._finish(future)
        count = self._begun if total is None else total
        failures = {failure.index: failure for failure in self._failures}
        missing = (k for k in range(count) if k not in self._values and k not in failures)
        return Ensemble(
            tuple(map(self._values.get, range(count))),
            tuple(failures[k] for k in sorted(failures)),
            tuple(missing),
            self.stopped,
        )

    def close(self) -> None:
        """Let go of what is still under way, and end the processes that were started here."""
        for future in self._under_way:
            future.cancel()
        if self._given is None and self._executor is not None:
            if self._under_way:
                _terminate(self._executor)
            self._executor.shutdown(wait=not self._under_way, cancel_futures=True)

    def _send(self) -> bool:
        """Send chunks, as many as may be under way; whether there are any."""
        while sent := self._next():
            if self._executor is None:
                self._executor = ProcessPoolExecutor(self._workers, initializer=_ignore_interrupts)
            try:
                future = self._executor.submit(
                    _chunk_worked_out, self._function, self._seed, sent.chunk
                )
            except RuntimeError as error:
                # It broke, which is not known yet, or was so from the start; or was shut down.
                if self._given is None and not isinstance(error, BrokenExecutor):
                    raise
                self._broken(sent, error)
                if self.stopped:
                    break
            else:
                self._under_way[future] = sent
        return bool(self._under_way)

    def _next(self) -> _Sent | None:
        """The next chunk to send, if there is one and it may be sent now."""
        if not self._again:
            self._one_by_one &= bool(self._under_way)
        if len(self._under_way) >= (1 if self._one_by_one else 2 * self._workers):
            return None
        if self._again:
            return _Sent(self._again.popleft(), again=True, alone=self._one_by_one)
        chunk = self._drawn()
        self._begun += len(chunk)
        return _Sent(chunk, again=False, alone=self._one_by_one) if chunk else None

    def _drawn(self) -> _Chunk:
        """The cases of a chunk; fewer where there are no more."""
        chunk: _Chunk = []
        if self._no_more_cases:
            return chunk
        try:
            for case in islice(self._numbered, self._size):
                chunk.append(case)
        except Exception as error:  # noqa: BLE001 - whatever a user's generator raises
            self._no_more_cases = (
                f"after {counted(self._begun + len(chunk), 'case')} there came {_described(error)}"
            )
        return chunk

    def _finish(self, future: Future[Any]) -> None:
        """Takes what came of a chunk."""
        sent = self._under_way.pop(future)
        error = CancelledError() if future.cancelled() else future.exception()
        if isinstance(error, BrokenExecutor):
            self._broken(sent, error)
        elif error is None:
            self._keep(sent.chunk, *future.result())
        else:  # the function did not raise it: something could not be sent, or not be sent back
            self._try_again(sent, error, last=sent.again)

    def _keep(self, chunk: _Chunk, seconds: float, results: list[Any]) -> None:
        for (index, case), result in zip(chunk, results):
            if isinstance(result, _Error):
                self._failures.append(Failure(index, case, result.error, result.traceback))
            else:
                self._values[index] = result
        fitting = int(len(chunk) * CHUNK_SECONDS / max(seconds, 1e-9))
        self._size = max(1, min(2 * self._size, fitting))
        self._deaths = 0

    def _fail(self, chunk: _Chunk, error: BaseException) -> None:
        text = "".join(traceback.format_exception(error))
        self._failures += [Failure(index, case, _described(error), text) for index, case in chunk]

    def _try_again(self, sent: _Sent, error: BaseException, *, last: bool) -> None:
        """Cases that came to nothing are tried once more, each by itself."""
        if last:
            self._fail(sent.chunk, error)
        else:
            self._again.extend([case] for case in sent.chunk)

    def _broken(self, sent: _Sent, error: BaseException) -> None:
        """The executor broke with this chunk under way."""
        if self._given is not None:
            self._fail(sent.chunk, error)
            self.stopped = f"the executor broke: {error}"
            wait(self._under_way, timeout=GRACE)
            return
        self._try_again(sent, error, last=sent.again and sent.alone)
        if self._executor is None:  # known from another chunk
            return
        # Nothing is sent to another pool before all that was under way has come back.
        self._executor.shutdown(wait=False)
        self._executor, self._one_by_one = None, True
        self._deaths += 1
        if self._deaths >= DEATHS:
            self.stopped = f"worker processes died {DEATHS} times with nothing worked out"


def _terminate(executor: Executor) -> None:
    if hasattr(executor, "terminate_workers"):  # from Python 3.14 on
        executor.terminate_workers()
        return
    for process in list((getattr(executor, "_processes", None) or {}).values()):
        process.terminate()


def _checked_workers(workers: Any) -> int:
    try:
        count = operator.index(workers)
    except TypeError as error:
        raise StatementError(f"workers is a whole number, not {workers!r}") from error
    if count < 1:
        raise StatementError(f"workers = {count}: at least one is needed")
    return count


def _check_seed(seed: Any) -> None:
    import numpy as np

    try:
        np.random.SeedSequence(seed)
    except (TypeError, ValueError) as error:
        raise StatementError(f"seed = {seed!r}: {error}") from error


def _check_sendable(function: Callable[..., Any]) -> None:
    try:
        pickle.dumps(function)
    except (pickle.PicklingError, AttributeError, TypeError) as error:
        raise StatementError(
            f"the function cannot be sent to other processes ({error}): define it at the top of a "
            "module, or give an executor of threads"
        ) from error


def _described(error: BaseException) -> str:
    return traceback.format_exception_only(error)[-1].strip()


def _shown(case: Any) -> str:
    try:
        return _brief(repr(case))
    except Exception:  # noqa: BLE001 - a case that cannot be shown costs no result
        return f"of type {type(case).__name__}"


def _brief(text: str) -> str:
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"
