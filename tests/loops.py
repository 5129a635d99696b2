"""Coroutines in tests of all kinds."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

_T = TypeVar("_T")


def completed(work: Coroutine[Any, Any, _T]) -> _T:
    """What it returns, from a thread of its own: a browser's loop may be at work in this one."""
    with ThreadPoolExecutor(1) as aside:
        return aside.submit(asyncio.run, work).result()
