"""Links of a chain in one reading of what stands between them: ``v = 2 ÷ 1/2 = 4``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from restitution.practice.judging.entries import is_numeric
from restitution.practice.judging.judged_link import JudgedLink
from restitution.practice.script import Link, ScriptLine


def in_one_reading(
    line: ScriptLine, before: Sequence[JudgedLink], behind: JudgedLink
) -> tuple[Link, Link] | None:
    """The last two links where each is true in a reading of its own of a number between them.

    The first as the second reads it, and the second as the first does.
    """
    place = len(before) - 1
    if place < 0 or {before[place].verdict, behind.verdict} != {"true"}:
        return None
    first, second = before[place].claim.right, behind.claim.left
    if first == second or not all(map(is_numeric, (first, second, behind.claim.right))):
        return None
    own, last = line.links[place : place + 2]
    alike = tuple(claim for claim in own.readings if claim.right == second)
    others = tuple(claim for claim in last.readings if claim.left == first)
    if not alike or not others:
        return None
    return replace(own, readings=alike), replace(last, readings=others)
