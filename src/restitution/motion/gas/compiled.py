"""The plain functions of the fast engine, compiled when they are first needed.

Numba is not imported before: a small run does without, and never waits for a compiler.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from restitution.errors import UnsupportedError


def available() -> bool:
    """Whether Numba is installed."""
    from importlib.util import find_spec

    return find_spec("numba") is not None


@functools.cache
def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function as Numba compiles it; what is compiled is kept beside the package."""
    try:
        import numba
    except ImportError as error:
        raise UnsupportedError(
            "a run of this size needs Numba, the compiler of the fast engine: "
            "pip install 'restitution[fast]'"
        ) from error
    compiler = numba.njit(cache=True, nogil=True, error_model="numpy")
    made: Callable[..., Any] = compiler(function)
    return made
