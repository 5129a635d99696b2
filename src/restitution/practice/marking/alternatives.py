"""Values that a line gives one beside another: ``KE lost = 9 or 10``, ``e = ±1/2``."""

from __future__ import annotations

import re
from collections.abc import Sequence

from restitution.errors import RestitutionError
from restitution.expression.tree import Expression
from restitution.practice.judgement import JudgedLine
from restitution.practice.marking.directions import Directions
from restitution.practice.marking.lines import chains
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.world import World
from restitution.records import dataclass

# What is said of a root that is no answer.
_REJECTING = re.compile(
    r"reject|ignor|discard|impossible|invalid|not (?:possible|valid)|can(?:no|'|’)?t|\bno\b|"
    r"\b(?:since|because|as|but|must)\b|[<>≥≤]",
    re.IGNORECASE,
)


@dataclass(frozen=True, eq=False)
class Alternatives(Directions):
    """Whether an answer is left open between several values."""

    def is_decided_below(self, quantity: Expression, lines: Sequence[JudgedLine]) -> bool:
        """Whether remarks, or what bounds a quantity, reject a value that stands above."""
        return any(
            _REJECTING.search(line.line.text)
            and (
                line.verdict == "remark"
                or any(
                    self._names(c[0].left, quantity, self._meanings(line), line)
                    for c in chains(line)
                )
            )
            for line in lines
        )

    def leaves_open(self, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a line gives a quantity a value beside the true one, and rejects none.

        ``KE lost = 9 or 10``; every value may be that of one of several solutions.
        """
        meanings = self._meanings(line)
        named = [c for c in chains(line) if self._names(c[0].left, quantity, meanings, line)]
        values = [claim for chain in named for claim in chain if claim.sign == "="]
        if not values or not values[-1].others or _REJECTING.search(line.line.text):
            return False
        decimals = [decimal for link in line.line.links for decimal in link.decimals]
        lefts = (quantity, *dict.fromkeys(chain[0].left for chain in named))

        def holds(value: Expression, left: Expression, world: World) -> bool:
            try:
                claim = Claim(left, "=", value)
                return agrees(claim, world, meanings, decimals, line.line.scope) is not None
            except RestitutionError:
                return False

        return not all(
            any(holds(value, left, world) for left in lefts for world in self.worlds)
            for value in (values[-1].right, *values[-1].others)
        )
