"""What determines what: equations in an order in which each group fixes as many new unknowns.

The smallest groups come first (one equation for one unknown, two for two, …), as in the block
triangular form of a system of equations; groups that nothing asked for rests on are left out.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Mapping, Sequence
from collections.abc import Set as AbstractSet
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


def blocks(
    equations: Sequence[Collection[Unknown]],
    left_in: Callable[[int, AbstractSet[Unknown]], Collection[Unknown]] | None = None,
) -> list[Block[Unknown]]:
    """Groups of equations, each given by the unknowns in it, in an order of working.

    ``left_in(index, known)`` may tell which unknowns an equation still holds once others are
    known: fewer than are left, where a known value makes a term vanish.
    """
    known: set[Unknown] = set()
    left = [index for index, each in enumerate(equations) if each]
    found: list[Block[Unknown]] = []
    while left:
        open_ = {
            index: frozenset(equations[index]) - known
            if left_in is None or not known & set(equations[index])
            else frozenset(left_in(index, known))
            for index in left
        }
        left = [index for index in left if open_[index]]
        group = _smallest(open_, left)
        if group is None:
            break
        inside = frozenset(
            x for index in group for x in (*open_[index], *(known & set(equations[index])))
        )
        found.append(Block(group, inside - known, inside & frozenset(known)))
        known |= inside
        left = [
            index for index in left if index not in group and not set(equations[index]) <= known
        ]
    return found


def _smallest(
    open_: Mapping[int, frozenset[Unknown]], left: Sequence[int]
) -> tuple[int, ...] | None:
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
