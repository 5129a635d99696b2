"""Trees evaluated over arrays: one number a sample, as many samples at once as there are.

The evaluator is the one of statements. What differs is what a student means: a bare number beside
an angle, or under a sine, is in degrees.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.evaluate import Angle, Evaluator, Value
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    walk,
)
from restitution.practice.script import column_of
from restitution.vector import Vector

Array = Any  # an array of shape (n,), or a single number for all samples

_NOTHING: Mapping[int, Array] = {}
# Components are about 1: what is smaller than this is what rounding leaves of zero.
_ZERO = 1e-12
_TWO = Number(Fraction(2))
_NUMERIC = frozenset({Number, Negate, Binary, Apply})
_TRIGONOMETRIC = frozenset({"sin", "cos", "tan", "cot", "sec", "cosec"})


class UnvaluedError(RestitutionError):
    """A tree has no value in a world; ``letter`` is the letter that means nothing there."""

    def __init__(self, message: str, letter: str | None = None) -> None:
        super().__init__(message)
        self.letter = letter


class Arrays:
    """Arithmetic of double precision over samples. What is not real is nan, and raises nothing."""

    exact = False
    pi = np.float64(np.pi)
    zero = np.float64(0)

    def number(self, value: Fraction) -> Array:
        try:
            return np.float64(value)
        except OverflowError:
            return np.float64(np.inf if value > 0 else -np.inf)

    def sqrt(self, x: Array) -> Array:
        return np.sqrt(x)

    def abs(self, x: Array) -> Array:
        return np.abs(x)

    def power(self, x: Array, y: Array) -> Array:
        return np.power(x, y)

    def cos_sin(self, x: Array) -> tuple[Array, Array]:
        return np.cos(x), np.sin(x)

    def arctan2(self, y: Array, x: Array) -> Array:
        return np.arctan2(y, x)

    def arc(self, function: str, x: Array) -> Angle:
        return angle({"arcsin": np.arcsin, "arccos": np.arccos, "arctan": np.arctan}[function](x))

    def is_zero(self, x: Array) -> bool:
        return bool(np.all(np.abs(x) < _ZERO))


FIELD = Arrays()


def angle(radians: Array) -> Angle:
    """An angle by its measure."""
    return Angle(np.cos(radians), np.sin(radians), lambda: radians)


@lru_cache(maxsize=4096)
def is_bare(tree: Expression) -> bool:
    """Whether a tree is of numbers alone, with no unit and no angle in it: ``90``, ``2*36.9``."""
    return all(
        type(node) in _NUMERIC and not (isinstance(node, Apply) and node.function.startswith("arc"))
        for node in walk(tree)
    )


class ArrayEvaluator(Evaluator):
    """Evaluates trees over samples.

    ``degrees`` tells whether bare numbers are degrees where an angle is meant. ``put`` has other
    values for numbers, by the columns at which they stand. Where a bare number was taken for an
    angle, its tree is added to ``noted``.
    """

    def __init__(
        self,
        *sources: Any,
        degrees: bool = True,
        put: Mapping[int, Array] = _NOTHING,
        noted: list[Expression] | None = None,
    ) -> None:
        super().__init__(FIELD, *sources)  # type: ignore[arg-type]
        self._degrees = degrees
        self._put = put
        self._noted = noted

    def value(self, tree: Expression) -> Value:
        kind = type(tree)
        if kind is Quantity:
            return self._quantity(tree)  # type: ignore[misc,arg-type]
        if kind is Number or kind is Degrees:
            column = column_of(tree) if self._put else None
            number = None if column is None else self._put.get(column)
            if number is None:
                number = FIELD.number(tree.value)  # type: ignore[union-attr]
            return number if kind is Number else angle(np.radians(number))
        if kind is Letter:
            return self._letter(tree.name)  # type: ignore[union-attr]
        if kind is Binary:
            return self._binary(tree)  # type: ignore[arg-type]
        if kind is Negate:
            return self._negate(self.value(tree.operand))  # type: ignore[union-attr]
        return super().value(tree)

    def angle_of(self, tree: Expression, value: Value) -> Value:
        """The value of a tree where an angle is meant: bare numbers are degrees."""
        if not is_bare(tree):
            return value
        if self._noted is not None:
            self._noted.append(tree)
        return np.radians(value) if self._degrees else value

    def _binary(self, tree: Binary) -> Value:
        if tree.op not in ("+", "-"):
            return super()._binary(tree)
        left, right = self.value(tree.left), self.value(tree.right)
        vectors = isinstance(left, Vector) or isinstance(right, Vector)
        if not vectors and isinstance(left, Angle) != isinstance(right, Angle):
            left, right = self.angle_of(tree.left, left), self.angle_of(tree.right, right)
            return self._sum_of_angles(left, right, 1 if tree.op == "+" else -1)
        return self._combined(tree, left, right)

    def _combined(self, tree: Binary, left: Value, right: Value) -> Value:
        """As in statements, and a product of two vectors, or a square of one, is the scalar one."""
        if isinstance(left, Vector):
            if tree.op == "*" and isinstance(right, Vector):
                return left.dot(right)
            if tree.op == "^" and tree.right == _TWO:
                return left.dot(left)
        return super()._combined(tree, left, right)

    def _times_angle(self, factor: Array, angle_: Angle, tree: Expression) -> Value:
        return angle(factor * angle_.measure())

    def _positive(self, x: Array) -> bool:
        return bool(np.all(np.asarray(x) > 0))

    def _apply(self, tree: Apply, function: str, value: Value) -> Value:
        if function in _TRIGONOMETRIC:
            value = self.angle_of(tree.argument, value)
        return super()._apply(tree, function, value)
