"""Which lines follow from those above by algebra alone, whatever their letters mean.

Such a line is true if those are, and tells little more of what the letters mean. Letters are free
numbers here: a point is kept at which all independent lines so far hold, found by Newton's method
from random values, and a line that holds there as well follows from them.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import field
from typing import Any, Literal

import numpy as np

from restitution.expression.evaluate import Angle, Value
from restitution.practice.letters.trial import Frame, Tester
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import Array, angle
from restitution.records import dataclass
from restitution.vector import Vector

Relation = Literal["new", "follows", "contradicts"]

_STARTS = 2
_STEPS = 14
_STEP = 1e-6
_SMALL = 1e-7


@dataclass
class Dependence:
    """The lines so far, and points at which they hold. Names are those of letters in a scope."""

    tester: Tester
    angular: frozenset[str]
    claims: list[tuple[Claim, Mapping[str, str], Frame]] = field(default_factory=list)
    vectors: set[str] = field(default_factory=set)
    points: list[dict[str, Array]] = field(default_factory=lambda: [{} for _ in range(_STARTS)])
    apart: Dependence | None = None
    last: bool = False
    seed: random.Random = field(default_factory=lambda: random.Random(16))

    def relation(self, claim: Claim, names: Mapping[str, str], frame: Frame) -> Relation:
        """Whether a claim follows from those before it, or contradicts them.

        If it does neither, it is one of them from now on.

        ``names`` are the letters of the claim, each with its name in its scope.
        """
        if claim.sign != "=" or claim.others or not self._prepared(claim, names, frame):
            return "new"
        one = (claim, names, frame)
        gaps = [self._gap(one, point) for point in self.points]
        if any(gap is None for gap in gaps):
            return "new"
        if all(np.max(np.abs(gap)) < _SMALL for gap in gaps if gap is not None):
            return "follows"
        self.claims.append(one)
        moved = [self._solved(point) for point in self.points]
        if any(point is None for point in moved):
            self.claims.pop()
            return self._beside(claim, names, frame)
        self.points = [point for point in moved if point is not None]
        return "new"

    def _beside(self, claim: Claim, names: Mapping[str, str], frame: Frame) -> Relation:
        """Whether a claim that contradicts follows from others that do."""
        if self.last:
            return "contradicts"
        if self.apart is None:
            self.apart = Dependence(self.tester, self.angular, last=True)
        known = self.apart.relation(claim, names, frame)
        return "follows" if known == "follows" else "contradicts"

    def _prepared(self, claim: Claim, names: Mapping[str, str], frame: Frame) -> bool:
        """Gives new letters a random value of the nature that fits; False where none does."""
        fresh = [name for name in names.values() if name not in self.points[0]]
        for vectors in ((), fresh):
            for point in self.points:
                for name in fresh:
                    point[name] = self._random(name, name in vectors)
            if self._gap((claim, names, frame), self.points[0]) is not None:
                return True
        for point in self.points:
            for name in fresh:
                del point[name]
        return False

    def _random(self, name: str, vector: bool) -> Array:
        """A random value, of shape (1,) or, for a vector, (2,)."""
        if name.partition(" ")[0] in self.angular:
            return np.array([self.seed.uniform(0.3, 1.2)])
        return np.array([self.seed.uniform(0.5, 2.5) for _ in range(2 if vector else 1)])

    def _gap(self, one: tuple[Claim, Mapping[str, str], Frame], point: Mapping[str, Array]) -> Any:
        """Left side less right side at points, relative to the sides; None where it makes no sense.

        Values in ``point`` have the shape (parts,) or (points, parts); the result is an array of
        shape (points, equations), or (equations,).
        """
        claim, names, frame = one
        put = {letter: self._value(letter, point[name]) for letter, name in names.items()}
        a, b = (self.tester.value(side, put, frame) for side in (claim.left, claim.right))
        if a is None or b is None:
            return None
        if isinstance(a, Vector) != isinstance(b, Vector):
            return None
        if isinstance(a, Vector) and isinstance(b, Vector):
            pairs = [(a.x, b.x), (a.y, b.y)]
        else:
            pairs = [(_plain(a), _plain(b))]
        with np.errstate(all="ignore"):
            gaps = [self._relative(x - y, 1 + np.abs(x) + np.abs(y)) for x, y in pairs]
        gap = np.stack(np.broadcast_arrays(*gaps), axis=-1)
        return gap if np.all(np.isfinite(gap)) else None

    def _relative(self, apart: Array, size: Array) -> Array:
        """A difference at the first sample, by the size that its sides have at the first point."""
        apart, size = (
            np.asarray(x)[..., 0] if np.ndim(x) else np.asarray(x) for x in (apart, size)
        )
        return apart / size.flat[0]

    def _value(self, name: str, x: Array) -> Value:
        """A letter's value with one sample on the last axis."""
        if x.shape[-1] == 2:
            return Vector(x[..., :1], x[..., 1:])
        return angle(x) if name in self.angular else x

    def _solved(self, point: Mapping[str, Array]) -> dict[str, Array] | None:
        """A point near another at which all claims hold; None where there seems to be none."""
        names = list(point)
        sizes = [point[name].shape[-1] for name in names]
        x = np.concatenate([point[name] for name in names])
        for _ in range(_STEPS):
            steps = np.vstack([x, x + _STEP * np.eye(len(x))])
            columns = np.split(steps, np.cumsum(sizes)[:-1], axis=1)
            there = dict(zip(names, columns, strict=True))
            gaps = [self._gap(one, there) for one in self.claims]
            if any(gap is None for gap in gaps):
                return None
            rows = [np.broadcast_to(gap, (len(steps), gap.shape[-1])) for gap in gaps]
            residual = np.concatenate(rows, axis=1)
            if np.max(np.abs(residual[0])) < 1e-10:
                parts = np.split(x, np.cumsum(sizes)[:-1])
                return dict(zip(names, parts, strict=True))
            slopes = (residual[1:] - residual[0]).T / _STEP
            x = x - np.clip(np.linalg.pinv(slopes, rcond=1e-8) @ residual[0], -2, 2)
        return None


def _plain(value: Value) -> Array:
    return value.measure() if isinstance(value, Angle) else value
