"""The libraries of the extra "experiment", loaded when they are first needed."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from restitution.errors import UnsupportedError


def needed(module: str, purpose: str) -> Any:
    """A module of the extra "experiment". Raises UnsupportedError where it is not installed."""
    try:
        return import_module(module)
    except ImportError as error:
        library = module.partition(".")[0]
        raise UnsupportedError(
            f"{purpose} needs {library}: pip install 'restitution[experiment]'"
        ) from error
