"""Sympy's rules for cosines and sines, mended: they failed for angles with surds, such as 54°.

The rules look a cosine up as it was written, ``cos 54°``, but have worked it out in roots by then,
and so do not know it. Sympy comes to them by itself, in deciding whether a root is real; such a
term is left as it is.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from sympy import Basic

_RULES = import_module("sympy.simplify.trigsimp")
_APPLIED: Callable[[Basic], Basic] = _RULES._futrig


def by_the_rules(term: Basic) -> Basic:
    """A term as the rules of sympy leave it, or as it is where they fail."""
    try:
        return _APPLIED(term)
    except KeyError:
        return term


def mend_rules_of_cosines() -> None:
    """Have sympy leave a term as it is where its rules fail."""
    setattr(_RULES, "_futrig", by_the_rules)  # noqa: B010  (a module has no such attribute to mypy)


__all__ = ["by_the_rules", "mend_rules_of_cosines"]
