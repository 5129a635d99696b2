"""``restitution.batch.ensemble`` under the name that it had first."""

from __future__ import annotations

from importlib import import_module
from typing import Any


def __getattr__(name: str) -> Any:
    return getattr(import_module("restitution.batch.ensemble"), name)
