"""Lines that are true by a root, in a sense told in words, or but for rounding."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import takewhile

from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Binary,
    Degrees,
    Letter,
    Negate,
    Number,
    unsigned,
    walk,
)
from restitution.practice.judging.entries import (
    Entry,
    Meanings,
    is_numeric,
    is_root_of,
)
from restitution.practice.judging.judged_link import (
    COARSE,
    OTHER_ROOT,
    JudgedLink,
    Question,
)
from restitution.practice.judging.other_forms import is_signed, same_left
from restitution.practice.judging.own_values import Naming, OwnValues
from restitution.practice.reading.relations import worked_out
from restitution.practice.script import Claim, Decimal, Link, ScriptLine, column_of
from restitution.practice.worlds.student import student_world
from restitution.practice.worlds.world import World

_HUNDRED = 100
_FIGURES = 3
# The sense of a component in words, behind its size.
_BACK = re.compile(
    r"\b(to the left|leftwards?|backwards?|downwards?|(in the )?(opposite|other|reverse) direction"
    r"|the other way|reversed)\b",
    re.IGNORECASE,
)


class NearlyTrue(OwnValues):
    """What holds by another root of an own equation, with its sense, or but for rounding."""

    def __init__(
        self,
        worlds: Sequence[World],
        meanings: Mapping[int, Meanings],
        naming: Naming,
        question: Question,
        *,
        names: bool = True,
    ) -> None:
        super().__init__(worlds, meanings, naming, question, names=names)
        self._roots: list[Entry] = []
        self._rooted: tuple[tuple[int, int], list[World]] = ((-1, -1), [])

    def _root(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A value that is another root of the student's own equation, beside the right one."""
        for claim in link.readings:
            single = [
                replace(claim, right=right, others=()) for right in (claim.right, *claim.others)
            ]
            entries = [e for e in reversed(self.entries) if e.right]
            for entry in entries:
                roots = [is_root_of(claim, entry) for claim in single]
                if all(r is not None and self._valid(r, entry) for r in roots):
                    right = any(
                        self.accuracy(claim, w, line, link) for claim in single for w in self.worlds
                    )
                    if right or any(
                        same_left(e.claim, claim) and e.right and e.is_value for e in entries
                    ):
                        for root in single:
                            other = replace(self._entry_of(line, link, root), right=False)
                            if not any(self.accuracy(root, w, line, link) for w in self.worlds):
                                self._roots.append(other)
                        return JudgedLink("true", claim, "exact", remark=OTHER_ROOT)
        return None

    def _of_other_root(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """What another root of the student's own equation leads to: it is tried, and rejected."""
        if not self._roots:
            return None
        known = len(self.entries), len(self._roots)
        if self._rooted[0] != known:
            tried = [
                student_world(self._base, [*self.entries, root], self.question.unknown)
                for root in self._roots
            ]
            self._rooted = known, [world for world in tried if world is not None]
        for claim in link.readings:
            for world in self._rooted[1]:
                grade = self.accuracy(claim, world, line, link)
                if grade is not None:
                    return JudgedLink("true", claim, grade, remark=OTHER_ROOT)
        return None

    def _own_root(self, entry: Entry) -> int | None:
        """The line that is not true and of which a value is a root, or both of ``x = 1 or 2``."""
        claim = entry.claim
        values = [replace(claim, right=right, others=()) for right in (claim.right, *claim.others)]
        for other in reversed(self.entries):
            roots = [] if other.right else [is_root_of(value, other) for value in values]
            own = replace(other, decimals=(*other.decimals, *entry.decimals))
            if roots and all(root is not None and self._valid(root, own) for root in roots):
                return other.number
        return None

    def _nearly(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line that is true but for what the student's own rounding may have moved.

        A decimal of four figures or more may be cut off where it should be rounded.
        """
        if any(map(_is_rounded_whole, link.readings)):
            return JudgedLink("true", link.readings[0], "rounded")
        above = any(entry.decimals for entry in self.entries)
        beside = any(other.decimals for other in line.links if other is not link)
        cut = not (above or beside) and [x for x in link.decimals if x.figures > _FIGURES]
        if self.wrong or not link.decimals or not (above or beside or cut):
            return None
        own = replace(link, decimals=tuple(map(_cut_off, link.decimals)))
        for claim in link.readings:
            turned = is_numeric(claim.left)
            if turned and is_numeric(claim.right):
                continue
            if self._is_worked_beside(claim, line, link):
                return JudgedLink("true", claim, "rounded")
            if turned and not (cut or isinstance(claim.left, Number)):
                continue  # there every number has to be right: 2(5.36) - 1.71 = 2v + w
            for world in self.worlds:
                if (cut or turned) and self.accuracy(claim, world, line, own) is not None:
                    return JudgedLink("true", claim, "rounded")
                if not (cut or turned) and self._loosely(claim, world, line, link) is not None:
                    return JudgedLink("true", claim, "coarse", remark=COARSE)
        return None

    def _is_worked_beside(self, claim: Claim, line: ScriptLine, link: Link) -> bool:
        """Whether a number is what those of a true equation come to that has its other side.

        In ``3(7.372) = 3v + 2w, so 22.116 = 3v + 2w`` it is right as the figures stand.
        """
        own = {decimal.column: decimal.half_unit for decimal in link.decimals}
        before = takewhile(lambda other: other is not link, line.links)
        beside = [self._entry_of(line, other, x) for other in before for x in other.readings[:1]]
        equations = [entry for entry in (*beside, *self.entries[-1:]) if entry.right]
        for number, side in ((claim.left, claim.right), (claim.right, claim.left)):
            if not isinstance(number, Number) or claim.sign != "=" or claim.others:
                continue
            half = own.get(column_of(number) or 0, Fraction(0))
            for entry in equations:
                sides = entry.claim.left, entry.claim.right
                if side not in sides or entry.claim.sign != "=":
                    continue
                value = worked_out(sides[1 - sides.index(side)])
                if value is not None and abs(value - number.value) <= half:
                    return self._valid(entry.claim, entry)
        return False

    def _in_other_sense(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A component by its size, with its sense in words: ``v = 2u/15 to the left``."""
        if not _BACK.search(line.text):
            return None
        for claim in link.readings:
            left = claim.left
            meant = self.meanings(line.number).get(left.name) if isinstance(left, Letter) else None
            inside = unsigned(meant)
            if claim.sign != "=" or claim.others or inside is None or not is_signed(inside):
                continue
            turned = replace(claim, right=Negate(claim.right))
            for world in self.worlds:
                grade = self.accuracy(turned, world, line, link)
                if grade is not None:
                    return JudgedLink("true", turned, grade)
        return None

    def _by_rounded_equation(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A value worked from a true equation with rounded numbers: ``cos φ = 12/12.17``, φ = 9.6.

        A small angle may be far off by a cosine that is nearly 1.
        """
        before = takewhile(lambda other: other is not link, line.links)
        equations = [
            (self._entry_of(line, other, claim), other.decimals)
            for other in before
            for claim in other.readings[:1]
        ]
        last = self.entries[-1:]
        equations += [(entry, entry.decimals) for entry in last if entry.right and not self.wrong]
        for claim in link.readings if link.decimals else ():
            match claim:
                case Claim(Letter() as letter, "=", value, ()) if is_numeric(value):
                    pass
                case _:
                    continue
            for entry, decimals in equations:
                columns = {decimal.column for decimal in decimals}
                if letter not in walk(entry.claim.left) or not decimals:
                    continue
                if entry.number != line.number and columns & {x.column for x in link.decimals}:
                    continue
                own = exchanged(entry.claim.left, {letter: value})
                put = replace(entry.claim, left=own)
                if letter in walk(put.right) or not self._valid(entry.claim, entry):
                    continue
                if self._valid(put, replace(entry, decimals=(*decimals, *link.decimals))):
                    return JudgedLink("true", claim, "coarse", remark=COARSE)
        return None

    def _by_rounded_lines(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A value from two rounded equations, v of v + w = 2.83 and w - v = 2.6: it may be far off.

        It holds in the world of the lines above, all of which are true but for their rounding.
        """
        above = any(entry.decimals for entry in self.entries)
        for claim in link.readings if above and link.decimals and not self.wrong else ():
            for world in self.students():
                if self.accuracy(claim, world, line, link) is not None:
                    return JudgedLink("true", claim, "coarse", remark=COARSE)
        return None


def _cut_off(decimal: Decimal) -> Decimal:
    """A decimal whose last figure may be one too small."""
    return replace(decimal, half_unit=2 * decimal.half_unit)


def _is_rounded_whole(claim: Claim) -> bool:
    """Whether decimals are added up to a whole number of three figures: ``67.38 + 38.66 = 106``."""
    right = claim.right
    if claim.sign != "=" or not isinstance(right, Number | Degrees):
        return False
    numbers = [node for node in walk(claim.left) if isinstance(node, Number | Degrees)]
    plain = all(isinstance(node, Number | Degrees | Binary) for node in walk(claim.left))
    broken = any(number.value.denominator > 1 for number in numbers)
    if not (plain and broken and right.value.denominator == 1 and right.value >= _HUNDRED):
        return False
    value = worked_out(claim.left)
    return value is not None and abs(value - right.value) <= Fraction(1, 2)
