"""What a long run does between two windows of time."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator
from typing import Any

from restitution.batch.progress import progress as progress_bar


@contextlib.contextmanager
def pauses(
    reached: Callable[[], tuple[float, int]],
    end: float,
    impacts: int | None,
    progress: bool | None,
) -> Iterator[Callable[[], None]]:
    """What is done between two windows: Ctrl-C is heard, the bar moves on.

    ``reached`` gives the time (s) and the number of impacts; ``end`` is the last time, ``impacts``
    the number of impacts to come, where that ends the run.
    """
    stop = threading.Event()
    main = threading.current_thread() is threading.main_thread()

    def hear(*_: Any) -> None:
        if stop.is_set():  # asked twice
            raise KeyboardInterrupt
        stop.set()

    previous = signal.signal(signal.SIGINT, hear) if main else None
    start, before = reached()
    total, unit = (end - start, "s") if impacts is None else (impacts, "impacts")
    try:
        with progress_bar(total, unit, progress, None if impacts else "impacts") as tell:

            def pause() -> None:
                time, so_far = reached()
                struck = so_far - before
                tell(struck if impacts else time - start, struck)
                if stop.is_set():
                    raise KeyboardInterrupt

            yield pause
    finally:
        if previous is not None:
            signal.signal(signal.SIGINT, previous)
