"""SymPy, loaded as far as the work needs it: what is left comes as soon as anybody asks for it.

``import sympy`` loads geometry, plots, differential equations and much else, a fifth of its time,
which no question here asks for. This is for processes of the package's own; elsewhere SymPy is
loaded as it stands.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib import import_module
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import find_spec, module_from_spec
from types import ModuleType
from typing import Any

_PACKAGES = (
    *("core", "logic", "assumptions", "polys", "series", "functions", "ntheory", "concrete"),
    *("simplify", "sets", "matrices", "utilities", "tensor", "calculus", "printing"),
)
"""What is loaded, in SymPy's own order, since its packages need each other.

Its names are those of these packages, of the first that has one.
"""


def load_algebra() -> None:
    """Load SymPy without what is seldom asked for, if it is not there and nothing is unusual."""
    if "sympy" in sys.modules or "SYMPY_DEBUG" in os.environ:
        return
    spec = find_spec("sympy")
    if spec is None or spec.loader is None:
        return
    _without_tensors()
    package = module_from_spec(spec)
    rest = _Rest(package, spec)
    names: Any = package
    names.SYMPY_DEBUG, names.__getattr__ = False, rest.name
    sys.modules["sympy"] = package
    for name in _PACKAGES:
        import_module(f"sympy.{name}")
    for name in ("series", "simplify"):  # functions as well, which is what SymPy means by them
        setattr(package, name, getattr(sys.modules[f"sympy.{name}"], name))
    names.__version__ = import_module("sympy.release").__version__
    import_module("sympy.core.evalf")._create_evalf_table()
    rest.wait()


class _Rest(MetaPathFinder, Loader):
    """What is not loaded: it comes where a name or a package is asked for that is not there."""

    def __init__(self, package: ModuleType, spec: ModuleSpec) -> None:
        self._package, self._spec, self._waiting = package, spec, False

    def wait(self) -> None:
        """From now on, whatever is asked for and not there is among what is not loaded."""
        self._waiting = True
        sys.meta_path.insert(0, self)

    def name(self, name: str) -> Any:
        """What has a name in SymPy."""
        for own in () if name.startswith("__") else _PACKAGES:
            value = getattr(sys.modules.get(f"sympy.{own}"), name, None)
            if value is not None and not isinstance(value, ModuleType):
                setattr(self._package, name, value)
                return value
        if not self._waiting or (name.startswith("__") and name != "__all__"):
            raise AttributeError(f"module 'sympy' has no attribute {name!r}", name=name)
        self._complete()
        return getattr(self._package, name)

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Of a package of SymPy that is not loaded: it comes with all the others."""
        parent, _, _ = fullname.rpartition(".")
        if parent != "sympy" or not self._waiting:
            return None
        self._complete()
        return ModuleSpec(fullname, self) if fullname in sys.modules else None

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """The package that has come meanwhile."""
        return sys.modules[spec.name]

    def exec_module(self, module: ModuleType) -> None:
        """Nothing: it is loaded."""

    def _complete(self) -> None:
        self._waiting = False
        sys.meta_path.remove(self)
        names: Any = self._package
        del names.__getattr__
        loader: Any = self._spec.loader
        loader.exec_module(self._package)


_TENSORS = "sympy.tensor.tensor"


def _without_tensors() -> None:
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
