"""What the lines of an inequality are written with, whatever shape it has."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

from restitution.explaining.lines.derivation import Ref, Relation
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.judging import Judge
from restitution.planning.writing.scene import Scene


class Comparing(Protocol):
    """Writes lines that compare, by what stands and by the ranges of letters."""

    scene: Scene
    judge: Judge
    worths: Worths

    def compared(
        self, refs: Sequence[Ref], relation: Relation, known_only: Sequence[Ref] = ()
    ) -> int | None:
        """A line by what is cited, and the ranges of letters."""

    def monotone(self, line: int, relation: Relation, bounds: Sequence[Ref] = ()) -> int | None:
        """The ends of what only grows, or only falls, with one letter."""

    def coefficients(self, names: Iterable[str]) -> list[str]:
        """The coefficients of restitution among some letters."""
        ...
