"""What determines what: equations in an order in which each group fixes as many new unknowns.

The smallest groups come first (one equation for one unknown, two for two, …), as in the block
triangular form of a system of equations; groups that nothing asked for rests on are left out.
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Generic, TypeVar

Unknown = TypeVar("Unknown", bound=Hashable)

# Trying all groups of k equations among n is only sensible for small n.
_LARGEST = 6
_TRIED = 4000


@dataclass(frozen=True)
class Block(Generic[Unknown]):
    """Equations, by index, that together fix some unknowns; the others in them are known."""

    equations: tuple[int, ...]
    unknowns: frozenset[Unknown]
    uses: frozenset[Unknown]


def blocks(equations: Sequence[Collection[Unknown]]) -> list[Block[Unknown]]:
    """Groups of equations, each given by the unknowns in it, in an order of working."""
    known: set[Unknown] = set()
    left = [index for index, each in enumerate(equations) if each]
    found: list[Block[Unknown]] = []
    while left:
        group = _smallest(equations, left, known)
        if group is None:
            break
        inside = frozenset(x for index in group for x in equations[index])
        found.append(Block(group, inside - known, inside & frozenset(known)))
        known |= inside
        left = [
            index for index in left if index not in group and not set(equations[index]) <= known
        ]
    return found


def _smallest(
    equations: Sequence[Collection[Unknown]], left: Sequence[int], known: set[Unknown]
) -> tuple[int, ...] | None:
    open_ = {index: frozenset(equations[index]) - known for index in left}
    tried = 0
    for size in range(1, min(_LARGEST, len(left)) + 1):
        for group in combinations(left, size):
            tried += 1
            if tried > _TRIED:
                return None
            inside = frozenset[Unknown]().union(*(open_[index] for index in group))
            if len(inside) == size:
                return group
    return None


def needed(ordered: Sequence[Block[Unknown]], wanted: Collection[Unknown]) -> list[Block[Unknown]]:
    """The blocks on which the wanted unknowns rest, in the same order."""
    open_ = set(wanted)
    kept: list[Block[Unknown]] = []
    for block in reversed(ordered):
        if block.unknowns & open_:
            kept.append(block)
            open_ |= block.uses
    return kept[::-1]
