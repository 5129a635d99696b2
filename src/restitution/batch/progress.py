"""How far a long run has come: a bar on standard error, with the rate and the time left."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

INTERVAL = 0.1
"""Seconds between two looks of the bar."""

PATIENCE = 1.0
"""Seconds before a bar appears that nobody asked for."""


@contextmanager
def progress(
    total: float | None, unit: str, shown: bool | None = None, counting: str | None = None
) -> Iterator[Callable[..., None]]:
    """A function to tell how much has been done in all, in ``unit``, of ``total`` if that is known.

    The rate is that of what is done; or of what else is counted, by the name ``counting``, if the
    function is told of it in second place. By default the bar is shown if standard error is a
    terminal and the run takes long.
    """
    if not (sys.stderr.isatty() if shown is None else shown):
        yield lambda done, counted=0.0: None
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
    wait = PATIENCE if shown is None else 0.0
    begun = False

    def look(done: float, counted: float, now: float) -> None:
        nonlocal begun
        if not begun:
            bar.start()
            begun = True
        of = "" if total is None else f" of {_short(total)}"
        rate = (done if counting is None else counted) / max(now - start, 1e-9)
        what = "" if counting is None else f" {counting}"
        bar.update(
            task,
            completed=done,
            description=f"{_short(done)}{of} {unit}, {_short(rate)}{what} a second",
            refresh=True,
        )

    reached = (0.0, 0.0)

    def report(done: float, counted: float = 0.0) -> None:
        nonlocal last, reached
        reached, now = (done, counted), time.monotonic()
        if now - last >= INTERVAL and now - start >= wait:
            look(*reached, now)
            last = now

    try:
        yield report
    finally:
        if begun or wait == 0.0:
            look(*reached, time.monotonic())
            bar.stop()


def _short(number: float) -> str:
    return f"{number:,.0f}" if number >= 100 or number == int(number) else f"{number:.2g}"
