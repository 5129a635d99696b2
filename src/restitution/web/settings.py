"""What an operator may choose."""

from __future__ import annotations

import os
from dataclasses import dataclass, field


def _workers() -> int:
    # One more than there are processors: a slow question holds up the others less.
    return (os.cpu_count() or 1) + 1


@dataclass(frozen=True)
class Settings:
    """How much work is taken on: seconds, numbers of requests, bytes.

    ``waiting`` is how many requests may wait for a worker, ``largest`` the size of a request.
    """

    time_limit: float = 10.0
    workers: int = field(default_factory=_workers)
    waiting: int = 64
    largest: int = 64 * 1024
