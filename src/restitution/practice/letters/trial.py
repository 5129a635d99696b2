"""Claims tried over many meanings of their letters at once."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field
from fractions import Fraction
from typing import Any

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.evaluate import Angle, Value
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Number,
    Quantity,
    has_standard_ratios,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.practice.script import Claim, Decimal, column_of
from restitution.practice.worlds import effort
from restitution.practice.worlds.agreement import looseness
from restitution.practice.worlds.arrays import FIELD, Array, angle, is_bare
from restitution.practice.worlds.telling import NO_MEANINGS, Meanings, Telling
from restitution.practice.worlds.world import World
from restitution.problem import trees
from restitution.records import dataclass
from restitution.vector import Vector

_NEAR = 1e-7
_ZERO = 1e-10
_ORDER: Mapping[str, Callable[[Any, Any], Any]] = {
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
}
_TRIGONOMETRIC = frozenset({"sin", "cos", "tan", "cot", "sec", "cosec"})
_REFUSALS = (RestitutionError, ArithmeticError, LookupError, TypeError, ValueError, AttributeError)


class Trial(Telling):
    """A world in which letters have arrays of values.

    Each value in ``put`` is an array, a Vector of arrays or an Angle, with the samples on the last
    axis; shapes broadcast.
    """

    def __init__(self, world: World, put: Mapping[str, Value], meanings: Meanings):
        super().__init__(world, meanings)
        self.put = put

    def _letter(self, name: str, now: int) -> Value:
        if name in self.put:
            return self.put[name]
        return super()._letter(name, now)

    def quantity(self, tree: Quantity, now: int) -> Value:
        if letters(tree).isdisjoint(self.put):
            return super().quantity(tree, now)
        return self._quantity(tree, now)


@dataclass(frozen=True)
class Frame:
    """Where a claim stands: after how many events, with letters that have a meaning already."""

    now: int | None = None
    meanings: Meanings = field(default_factory=lambda: NO_MEANINGS)


NOWHERE = Frame()


class Tester:
    """Tries claims in a world.

    Decimals that stand in the statement are exact wherever they stand.
    """

    def __init__(self, world: World) -> None:
        self.world = world
        self.exact = numbers_of(world)
        # Where an angle of the statement is rounded, its sine is as well.
        self._near = max(_NEAR, looseness(world))

    def value(
        self,
        tree: Expression,
        put: Mapping[str, Value],
        frame: Frame = NOWHERE,
        numbers: Mapping[int, Array] | None = None,
    ) -> Value | None:
        """The value of a tree, None where it makes no sense."""
        effort.evaluate()
        trial = Trial(self.world, put, frame.meanings)
        stage = len(self.world.events) if frame.now is None else frame.now
        with np.errstate(all="ignore"):
            try:
                return trial.evaluator(stage, numbers or {}).value(tree)
            except _REFUSALS:
                return None

    def holds(
        self,
        claim: Claim,
        put: Mapping[str, Value],
        decimals: Iterable[Decimal] = (),
        frame: Frame = NOWHERE,
    ) -> Array | None:
        """At which samples a claim holds, for every meaning: truth values, samples last.

        None where the claim makes no sense with values of this nature.
        """
        truth: Array | None = None
        for right in (claim.right, *claim.others):
            held = self._holds(claim.left, claim.sign, right, put, decimals, frame)
            if held is not None:
                truth = held if truth is None else truth | held
        return truth

    def _holds(
        self,
        left: Expression,
        sign: str,
        right: Expression,
        put: Mapping[str, Value],
        decimals: Iterable[Decimal],
        frame: Frame,
    ) -> Array | None:
        sides = self._sides(left, right, put, frame, None)
        if sides is None:
            return None
        with np.errstate(all="ignore"):
            if sign in _ORDER:
                return _ORDER[sign](*sides[0]) if len(sides) == 1 else None
            near = _all(
                (np.abs(a - b) <= _room(a, b, self._near)) & (np.abs(a) + np.abs(b) < _HUGE)
                for a, b in sides
            )
            halves = self._halves(left, right, decimals) if not np.all(near) else {}
            if halves:
                near = near | self._rounded(sides, left, right, put, halves, frame)
            return ~near if sign == "!=" else near

    def _halves(
        self, left: Expression, right: Expression, decimals: Iterable[Decimal]
    ) -> Mapping[int, Array]:
        """The decimals of a claim that are rounded, at the end of their half units, by column.

        Whole degrees count where they stand for an angle by themselves.
        """
        numbers = {
            column: node.value
            for side in (left, right)
            for node in walk(side)
            if isinstance(node, Number | Degrees) and (column := column_of(node)) is not None
        }
        ends = {
            decimal.column: np.float64(number + decimal.half_unit_of(number))
            for decimal in decimals
            if decimal.value not in self.exact
            for number in (numbers.get(decimal.column, decimal.value),)
        }
        for side in (left, right):
            column = column_of(side)
            if column is not None and isinstance(side, Number | Degrees):
                whole = side.value.denominator == 1 and side.value not in self.exact
                if whole and not has_standard_ratios(side.value) and column not in ends:
                    ends[-column] = np.float64(side.value + Fraction(1, 2))
        return ends

    def _rounded(
        self,
        sides: list[tuple[Array, Array]],
        left: Expression,
        right: Expression,
        put: Mapping[str, Value],
        halves: Mapping[int, Array],
        frame: Frame,
    ) -> Array:
        """Where sides agree within what the rounding of decimals may change."""
        angular = any(isinstance(self.value(x, put, frame), Angle) for x in (left, right))
        room = [_room(a, b) for a, b in sides]
        for column, moved in halves.items():
            if column < 0 and not angular:
                continue
            others = self._sides(left, right, put, frame, {abs(column): moved})
            if others is None:
                continue
            room = [
                r + np.abs((c - d) - (a - b))
                for r, (a, b), (c, d) in zip(room, sides, others, strict=True)
            ]
        return _all(np.abs(a - b) <= r * (1 + 1e-6) for r, (a, b) in zip(room, sides, strict=True))

    def _sides(
        self,
        left: Expression,
        right: Expression,
        put: Mapping[str, Value],
        frame: Frame,
        numbers: Mapping[int, Array] | None,
    ) -> list[tuple[Array, Array]] | None:
        """Both sides as pairs of numbers that have to agree; None where they cannot."""
        a, b = (self.value(tree, put, frame, numbers) for tree in (left, right))
        if a is None or b is None:
            return None
        if isinstance(a, Vector) or isinstance(b, Vector):
            a, b = _as_vector(a), _as_vector(b)
            if a is None or b is None:
                return None
            return [(np.asarray(a.x), np.asarray(b.x)), (np.asarray(a.y), np.asarray(b.y))]
        if isinstance(a, Angle) != isinstance(b, Angle):
            a = _in_degrees(left, a) if isinstance(b, Angle) else a
            b = _in_degrees(right, b) if isinstance(a, Angle) else b
        return [(np.asarray(_number(a)), np.asarray(_number(b)))]


def numbers_of(world: World) -> frozenset[Fraction]:
    """The numbers that a statement holds."""
    return frozenset(
        node.value
        for tree in trees(world.problem)
        for node in walk(tree)
        if isinstance(node, Number)
    )


# The tangent of a right angle is as large: beside it anything is small.
_HUGE = 1e9


def _room(a: Array, b: Array, near: float = _NEAR) -> Array:
    """The largest difference of two numbers that are equal up to the rounding of doubles."""
    return near * np.maximum(np.abs(a), np.abs(b)) + _ZERO


def _all(held: Iterable[Array]) -> Array:
    return np.logical_and.reduce(np.broadcast_arrays(*held))


def everywhere(held: Array) -> Array:
    """Truth at all samples, which are on the last axis."""
    held = np.asarray(held)
    return held if held.ndim == 0 else np.all(held, axis=-1)


def _number(value: Value) -> Array:
    return value.measure() if isinstance(value, Angle) else value


def _as_vector(value: Value) -> Vector | None:
    if isinstance(value, Vector):
        return value
    zero = not isinstance(value, Angle) and FIELD.is_zero(value)
    return Vector(FIELD.zero, FIELD.zero) if zero else None


def _in_degrees(tree: Expression, value: Value) -> Value:
    """A bare number beside an angle, which is in degrees."""
    return angle(np.radians(value)) if is_bare(tree) else value


def resolved_in(tree: Expression) -> frozenset[str]:
    """The letters of a tree that stand before a sine or a cosine: speeds that are resolved."""
    return frozenset(
        factor.name
        for node in walk(tree)
        if is_binary(node, "*")
        if is_function(node.right, "sin", "cos")
        for factor in _factors(node.left)
        if isinstance(factor, Letter)
    )


def _factors(tree: Expression) -> Iterator[Expression]:
    if is_binary(tree, "*"):
        yield from _factors(tree.left)
        yield from _factors(tree.right)
    else:
        yield tree


def inside_angles(tree: Expression) -> frozenset[str]:
    """The letters that stand inside a trigonometric function of a tree."""
    return frozenset(
        letter.name
        for node in walk(tree)
        if isinstance(node, Apply) and node.function in _TRIGONOMETRIC
        for letter in walk(node.argument)
        if isinstance(letter, Letter)
    )
