"""SymPy without its tensors, for processes of the package's own."""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import Any

_TENSORS = "sympy.tensor.tensor"


def without_tensors() -> None:
    """Let SymPy not load its tensors: its first sum asks whether a term is one of them.

    Loading them, and the permutations that they need, takes as long as solving a small question.
    Nothing here is a tensor, so two classes without members answer that. Whoever asks for anything
    else has the true module loaded in their place.
    """
    if _TENSORS in sys.modules:
        return

    def true_name(name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)  # what the import system asks
        if sys.modules.get(_TENSORS) is absent:
            del sys.modules[_TENSORS]
        return getattr(import_module(_TENSORS), name)

    absent: Any = ModuleType(_TENSORS)
    absent.TensExpr, absent.TensAdd = type("TensExpr", (), {}), type("TensAdd", (), {})
    absent.__getattr__ = true_name
    sys.modules[_TENSORS] = absent
