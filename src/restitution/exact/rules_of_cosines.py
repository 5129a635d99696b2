"""Sympy's rules for cosines and sines, mended: they failed for angles with surds, such as 54°.

The rules look a cosine up as it was written, ``cos 54°``, but have worked it out in roots by then,
and so do not know it. Sympy comes to them by itself, in deciding whether a root is real; such a
term is left as it is.

For the sign of a polynomial in one letter sympy looks for the roots of its derivative, and
simplifies these, which takes seconds where its numbers are made of cosines: there the sign is open.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from sympy import cos, sin, tan

if TYPE_CHECKING:
    from collections.abc import Callable

    from sympy import Basic, Expr

_RULES = import_module("sympy.simplify.trigsimp")
_APPLIED: Callable[[Basic], Basic] = _RULES._futrig
_SIGNS = import_module("sympy.core.exprtools")
_NEAREST_TO_ZERO: Callable[[Expr], Expr | None] = _SIGNS._monotonic_sign


def by_the_rules(term: Basic) -> Basic:
    """A term as the rules of sympy leave it, or as it is where they fail."""
    try:
        return _APPLIED(term)
    except KeyError:
        return term


def nearest_to_zero(value: Expr) -> Expr | None:
    """What sympy takes for the value nearest to zero, of which it takes the sign; None if open."""
    if value.is_Add and value.has(sin, cos, tan):
        return None
    return _NEAREST_TO_ZERO(value)


def mend_rules_of_cosines() -> None:
    """Have sympy leave a term as it is where its rules fail, and a sign open that takes long."""
    setattr(_RULES, "_futrig", by_the_rules)  # noqa: B010  (a module has no such attribute to mypy)
    setattr(_SIGNS, "_monotonic_sign", nearest_to_zero)  # noqa: B010


__all__ = ["by_the_rules", "mend_rules_of_cosines", "nearest_to_zero"]
