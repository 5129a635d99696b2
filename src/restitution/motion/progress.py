"""How far a long run has come: a bar on standard error, with the rate and the time left."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

INTERVAL = 0.1
"""Seconds between two looks of the bar."""


@contextmanager
def progress(
    total: float | None, unit: str, shown: bool | None = None
) -> Iterator[Callable[[float], None]]:
    """A function to tell how much has been done in all, in ``unit``, of ``total`` if that is known.

    By default the bar is shown if standard error is a terminal.
    """
    if not (sys.stderr.isatty() if shown is None else shown):
        yield lambda done: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    # Drawn by hand and not by a thread, so that a process can be forked at any time.
    bar = Progress(
        BarColumn(),
        TextColumn("{task.description}"),
        TimeRemainingColumn(elapsed_when_finished=True),
        console=Console(stderr=True),
        auto_refresh=False,
        redirect_stdout=False,
        redirect_stderr=False,
    )
    task = bar.add_task("", total=total)
    start = last = time.monotonic()

    def look(done: float, now: float) -> None:
        of = "" if total is None else f" of {_short(total)}"
        rate = done / max(now - start, 1e-9)
        bar.update(
            task,
            completed=done,
            description=f"{_short(done)}{of} {unit}, {_short(rate)} a second",
            refresh=True,
        )

    reached = 0.0

    def told(done: float) -> None:
        nonlocal last, reached
        reached, now = done, time.monotonic()
        if now - last >= INTERVAL:
            look(done, now)
            last = now

    with bar:
        try:
            yield told
        finally:
            look(reached, time.monotonic())


def _short(number: float) -> str:
    return f"{number:,.0f}" if number >= 100 or number == int(number) else f"{number:.2g}"
