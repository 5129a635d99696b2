"""The law of impact and its vectors for Numba: the same lines, compiled.

Importing this module teaches Numba what ``+``, ``-``, ``*`` and ``dot`` of a ``Vector`` are, and
that the functions of ``restitution.law`` may be called in compiled code; their source is compiled
as it stands, for whatever kind of number the components are. Nothing is contracted or reordered
(no ``fastmath``), so that compiled code rounds as NumPy does.

Numba notices by itself when the file of a kernel has changed, and compiles it again; not so when a
file has from which the kernel calls something, such as ``law.py``. Then empty
``motion/__pycache__``.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

from numba import types
from numba.extending import overload, overload_method

from restitution import law
from restitution.vector import Vector


def _are_vectors(*kinds: Any) -> bool:
    return all(
        isinstance(kind, types.BaseNamedTuple) and kind.instance_class is Vector for kind in kinds
    )


@overload(operator.add, strict=False)
def _sum(one: Any, two: Any) -> Callable[..., Any] | None:
    if _are_vectors(one, two):
        return lambda one, two: Vector(one.x + two.x, one.y + two.y)
    return None


@overload(operator.sub, strict=False)
def _difference(one: Any, two: Any) -> Callable[..., Any] | None:
    if _are_vectors(one, two):
        return lambda one, two: Vector(one.x - two.x, one.y - two.y)
    return None


@overload(operator.mul, strict=False)
def _multiple(vector: Any, factor: Any) -> Callable[..., Any] | None:
    if _are_vectors(vector) and not isinstance(factor, types.BaseTuple):
        return lambda vector, factor: Vector(vector.x * factor, vector.y * factor)
    return None


@overload_method(types.NamedUniTuple, "dot", strict=False)
def _dot(self: Any, other: Any) -> Callable[..., Any] | None:
    if _are_vectors(self, other):
        return lambda self, other: self.x * other.x + self.y * other.y
    return None


def as_it_stands(function: Callable[..., Any]) -> None:
    """Let a plain function be called in compiled code."""
    overload(function, strict=False)(lambda *_: function)


for _law in (law.impulse, law.impact, law.after_impulse):
    as_it_stands(_law)
