"""Times, places and distances of which a phrase may speak."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    is_quantity,
    walk,
)
from restitution.practice.reading.moments import Moments

_UNITS = Unit("i"), Unit("j")


def names_in(tree: Expression) -> frozenset[str]:
    """The names of bodies in a tree."""
    return frozenset(node.name for node in walk(tree) if isinstance(node, Name))


def _is_time(tree: Expression) -> bool:
    """Whether a value is a time, or one between two."""
    return all(
        is_quantity(x, "time") for x in walk(tree) if isinstance(x, Quantity | Letter)
    ) and any(is_quantity(x, "time") for x in walk(tree))


class Journeys(Moments):
    """The times of events, and where bodies are at them."""

    def times(self) -> Iterator[Expression]:
        """The times of all events, and those between two of them, the latest first.

        In *total* a time is one since the start, or the one that is asked for.
        """
        last = len(self.events) if self.until is None else self.until
        if self.features.both:
            yield from (Quantity("time", (), number) for number in range(last, 0, -1))
            yield from (tree for tree in self.values_asked() if _is_time(tree))
            return
        if self.features.back and len(self.events) > 1:
            end = Quantity("time", (), last)
            for number in range(last - 1, 0, -1):
                yield Binary("-", end, Quantity("time", (), number))
            return
        for later in range(len(self.events), 0, -1):
            time = Quantity("time", (), later)
            yield time
            for earlier in range(later - 1, 0, -1):
                yield Binary("-", time, Quantity("time", (), earlier))

    def places(self, event: int) -> Iterator[Expression]:
        """Where a sphere is at a moment that is asked for, or at an event; or its components."""
        named = {name for name in self.features.names if name in self.spheres}
        asked = [x for x in self.asked("position") if names_in(x) <= (named or names_in(x))]
        placed = [sphere.name for sphere in self.problem.spheres if sphere.position is not None]
        bodies = [body for body in self.bodies(event) if body in placed] or placed
        met = [self.of("position", body, event) for body in bodies]
        for place in (*asked, *met):
            for axis in (self.features.axis,) if self.features.axis is not None else _UNITS:
                if self.features.axis is None:
                    yield place
                yield Quantity("along", (place, axis))

    def travelled(self) -> Iterator[Expression]:
        """The distances that a sphere moves between two events, where its place is known.

        Along i or j, if the phrase names it: ``j distance``.
        """
        axis = self.features.axis
        placed = {sphere.name for sphere in self.problem.spheres if sphere.position is not None}
        named = set(self.features.names) or (set(self.spheres) if axis is not None else set())
        for body in placed & named:
            if not self.features.wall and len(named) == 1:
                at = [Quantity("position", (Name(body),), n) for n in range(len(self.events) + 1)]
                for later, earlier in combinations(reversed(at), 2):
                    moved = Binary("-", later, earlier)
                    yield Apply("abs", moved if axis is None else Quantity("along", (moved, axis)))

    def gaps(self) -> Iterator[Expression]:
        """The distances of two spheres whose places are known, at every event, of *gap*."""
        if not self.features.gap or self.walls:
            return  # any other distance may be one to a wall
        placed = [sphere.name for sphere in self.problem.spheres if sphere.position is not None]
        named = set(self.features.names)
        for one, other in combinations(placed, 2):
            for stage in range(len(self.events), -1, -1) if named <= {one, other} else ():
                yield Quantity("distance", (Name(one), Name(other)), stage)
