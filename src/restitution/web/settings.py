"""What an operator may choose."""

from __future__ import annotations

import os
from dataclasses import field

from restitution.records import dataclass


def _workers() -> int:
    # One more than there are processors: a slow question holds up the others less.
    return (os.cpu_count() or 1) + 1


@dataclass(frozen=True)
class Settings:
    """How much work is taken on: seconds, numbers of requests, characters and bytes.

    ``connections`` is how many connections one address may have, all browsers of a school behind
    it among them, and ``arriving`` for how long a request may be on its way.
    ``waiting`` is how many requests may wait for a worker, and ``patience`` for how long;
    ``longest`` is the length of a statement, ``largest`` the size of a request, ``kept`` that of
    all replies that are kept for those who ask the same. ``hosts`` are the names under which the
    page may be asked for (none: any).
    """

    time_limit: float = 10.0
    connections: int = 1000
    arriving: float = 20.0
    workers: int = field(default_factory=_workers)
    waiting: int = 64
    patience: float = 30.0
    longest: int = 20_000
    largest: int = 128 * 1024
    kept: int = 16 * 2**20
    hosts: tuple[str, ...] = ()
