"""The discs of ``restitution.gas`` under the name that they had first."""

from __future__ import annotations

from importlib import import_module
from typing import Any


def __getattr__(name: str) -> Any:
    return getattr(import_module("restitution.gas"), name)
