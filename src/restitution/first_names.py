"""Modules under the names that they had first, which still answer.

A package that bears the name of a public function hides its modules: ``restitution.solve`` is the
function, so ``import restitution.solve.story as story`` would look for the module in it. Packages
are therefore called by what they do, and an import under an old name gives the same module.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib import import_module
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType

# The first name of each module or package that has another now.
FIRST_NAMES = {
    "restitution.solve": "restitution.solving",
    "restitution.draw": "restitution.drawing",
    "restitution.explain": "restitution.workings",
    "restitution.motion.told": "restitution.motion.parts",
    "restitution.motion.gas": "restitution.gas",
    "restitution.motion.ensemble": "restitution.batch.ensemble",
}


def present_name(name: str) -> str | None:
    """What a module with this first name is called now; None for any other name."""
    for first, now in FIRST_NAMES.items():
        if name == first or name.startswith(f"{first}."):
            return now + name[len(first) :]
    return None


class _FirstNames(MetaPathFinder, Loader):
    """Finds a module under its first name: the same object, not a second copy of it."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        return None if present_name(fullname) is None else ModuleSpec(fullname, self)

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        name = present_name(spec.name)
        assert name is not None
        module = import_module(name)
        self._specs[spec.name] = module.__spec__
        return module

    def exec_module(self, module: ModuleType) -> None:
        """Gives the module back its own spec, which the import system has replaced."""
        assert module.__spec__ is not None
        module.__spec__ = self._specs.pop(module.__spec__.name)

    def __init__(self) -> None:
        self._specs: dict[str, ModuleSpec | None] = {}


def install() -> None:
    """Let first names be imported. It comes before the finder of files, which knows no aliases."""
    sys.meta_path.insert(0, _FirstNames())
