"""The plain functions of the fast engine, compiled when they are first needed.

Numba is not imported before: a small run does without, and never waits for a compiler.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from restitution.errors import UnsupportedError


@functools.cache
def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function as Numba compiles it; what is compiled is kept beside the package.

    Raises UnsupportedError where Numba is not installed.
    """
    try:
        import numba
    except ImportError as error:
        raise UnsupportedError(
            "a run of this size needs Numba, the compiler of the fast engine: "
            "pip install 'restitution[fast]'"
        ) from error
    compiler = numba.njit(cache=True, nogil=True, error_model="numpy")
    machine_code: Callable[..., Any] = compiler(function)
    return machine_code
