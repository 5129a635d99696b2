"""Whether the lines above support what a part prints or asks for.

A printed relation that is written down without lines from which it follows is not a mistake, and
not shown either.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import Degrees, Expression, is_binary, is_function, walk
from restitution.practice.judging.deduction import deduced_from
from restitution.practice.judging.entries import Entry, is_numeric
from restitution.practice.letters.options import staged
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import agrees, difference
from restitution.practice.worlds.student import (
    scattered_world,
    smooth_world,
    world_of_lines,
    world_without,
)
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Part, Problem, Show, Value
from restitution.records import dataclass

# What has so many parts more than the printed side is a line on the way to it.
_LONGER = 3


@dataclass(frozen=True)
class Wanted:
    """What a part prints, as claims, and what it asks for, each after so many events."""

    printed: tuple[tuple[Claim, int], ...] = ()
    asked: tuple[tuple[Expression, int], ...] = ()

    def trees(self, problem: Problem, part: Part | None) -> list[Expression]:
        """What is asked for, each quantity with the number of its event."""
        return [staged(tree, problem, part, now) for tree, now in self.asked]


def wanted_of(problem: Problem, part: Part) -> Wanted:
    """The relations to be shown and the values to be found in a part."""
    printed: list[tuple[Claim, int]] = []
    asked: list[tuple[Expression, int]] = []
    for item, now in problem.asked(part):
        if isinstance(item, Show) and item.subject is None and isinstance(item.relation, Compare):
            sides = item.relation.operands
            signs = item.relation.operators
            for left, sign, right in zip(sides, signs, sides[1:], strict=False):
                printed.append((Claim(left, sign, right), now))
        elif isinstance(item, Value):
            asked.append((item.expression, now))
    return Wanted(tuple(printed), tuple(asked))


def _differs(entry: Entry, other: Entry) -> bool:
    """Whether an earlier line gives what a claim is about another value, and a wrong one."""
    return other.is_value and not other.right and other.claim.left == entry.claim.left


def _gives_angle(above: Entry, entry: Entry) -> bool:
    """Whether a line above gives the angle of a line: by its tangent, or as another angle.

    A rounded number in it, ``tan θ = 2.29/0.0819``, leaves no more than the figures of the angle.
    """
    angle, own = entry.claim.left, above.claim.left
    if above.claim.sign != "=" or not isinstance(entry.claim.right, Degrees):
        return False
    if is_function(own, "sin", "cos", "tan"):
        return own.argument == angle
    return own != angle and above.is_value and above.claim.right == entry.claim.right


def is_sum_for_product(own: Expression, printed: Expression) -> bool:
    """Whether a side is a sum that ends in a square, ``u²/2 + (eu/√2)²``, and what is printed none.

    It is on the way to what is printed.
    """
    if not is_binary(own, "+") or is_binary(printed, "+", "-"):
        return False
    return is_binary(own.right, "^")


class Support:
    """Support that lines of one script have in the lines above them."""

    def __init__(
        self, base: World, wanted: Wanted, unknown: frozenset[str], data: frozenset[str]
    ) -> None:
        self.base = base
        self.wanted = wanted
        self.unknown = unknown
        self.data = data
        self.scattered = scattered_world(base, unknown)
        self._kept: tuple[object, World | None] = ((), None)
        self.smooth = smooth_world(base, unknown) or self.scattered

    def is_missing(
        self, entry: Entry, entries: Sequence[Entry], students: Sequence[World] = ()
    ) -> bool:
        """Whether a true claim is what is printed or asked, and no line above supports it."""
        wrong = any(entry.wrong for entry in entries)
        if not self.is_printed(entry) and not (
            bool(self.answered_by(entry)) and any(_differs(entry, other) for other in entries)
        ):
            return False
        right = [entry for entry in entries if entry.right]
        if any(self._holds(entry, world) for world in students if wrong):
            return False
        if any(_gives_angle(other, entry) for other in right):
            return False
        return not self.leads_to(entry, right)

    def leads_to(self, entry: Entry, right: Sequence[Entry]) -> bool:
        """Whether a claim follows from some true lines."""
        if deduced_from(entry, right, self.base, self.data):
            return True
        world = world_of_lines(self.base, right, self.unknown)
        return world is not None and self._holds(entry, world)

    def is_grounded(
        self, entry: Entry, entries: Sequence[Entry], broken: frozenset[tuple[str, int | None]]
    ) -> bool:
        """Whether a true claim follows from true lines above and from the laws not broken there."""
        if not broken or entry.claim.sign != "=":
            return True
        right = [entry for entry in entries if entry.right]
        key = len(entries), broken
        if self._kept[0] != key:
            world = world_without(self.base, right, broken, self.unknown)
            met = world is not None and all(self._holds(entry, world) for entry in right)
            self._kept = key, world if met else None
        world = self._kept[1]
        return world is None or self._holds(entry, world)

    def is_printed(self, entry: Entry) -> bool:
        """Whether a claim is a relation that the part prints."""
        return any(self._same(entry, claim, now) for claim, now in self.wanted.printed)

    def answered_by(self, entry: Entry) -> tuple[tuple[Expression, int], ...]:
        """The quantities that the part asks for to which a claim gives a value."""
        if entry.claim.sign != "=" or not is_numeric(entry.claim.right):
            return ()
        asked = self.wanted.asked
        return tuple(item for item in asked if self._equal(entry, entry.claim.left, *item))

    def _same(self, entry: Entry, claim: Claim, now: int) -> bool:
        own = entry.claim
        if own.sign == claim.sign and self._both(entry, (own.left, own.right), claim, now):
            return True
        turned = {"=": "=", "<": ">", ">": "<", "<=": ">=", ">=": "<=", "!=": "!="}[claim.sign]
        return own.sign == turned and self._both(entry, (own.right, own.left), claim, now)

    def _both(
        self, entry: Entry, sides: tuple[Expression, Expression], claim: Claim, now: int
    ) -> bool:
        return self._equal(entry, sides[0], claim.left, now) and self._equal(
            entry, sides[1], claim.right, now
        )

    def _equal(self, entry: Entry, own: Expression, other: Expression, now: int) -> bool:
        """Whether two trees have one value whatever happens, and the first is as short.

        A speed is its only component too, where bodies are smooth. A sum of squares for a product
        is a line on the way.
        """
        if len(walk(own)) > len(walk(other)) + _LONGER or is_sum_for_product(own, other):
            return False
        return any(
            self._equal_in(world, entry, own, other, now) for world in (self.scattered, self.smooth)
        )

    def _equal_in(
        self, world: World, entry: Entry, own: Expression, other: Expression, now: int
    ) -> bool:
        try:
            a = world.scalar(own, entry.meanings, scope=entry.scope)
            b = world.scalar(other, now=now, degrees=False)
        except RestitutionError:
            return False
        return bool(np.allclose(a, b, rtol=1e-9, atol=1e-12))

    def _holds(self, entry: Entry, world: World) -> bool:
        try:
            if agrees(entry.claim, world, entry.meanings, entry.decimals, entry.scope) is not None:
                return True
            if entry.claim.sign != "=":
                return False
            apart, size = difference(entry.claim, world, entry.meanings, entry.scope)
        except RestitutionError:
            return False
        return bool(np.all(np.abs(apart) <= 1e-6 * (size + 1e-6)))
