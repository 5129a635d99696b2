"""Several solutions of a part, each written by itself, put together as cases."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from restitution.explaining.derivation import Case, Line, Ref
from restitution.planning.desk import Desk, NotPlannedError


def joined(before: Desk, drafts: Sequence[Desk]) -> Desk:
    """One desk of several that went on from the same: what is common stands once.

    Raises NotPlannedError where the solutions do not part at one line of alternatives.
    """
    splits = {draft.split for draft in drafts}
    lines = {each[0] for each in splits if each is not None}
    if len(lines) != 1 or None in splits or len(splits) != len(drafts):
        raise NotPlannedError("solutions that do not part at one line")
    (split,) = lines
    first = drafts[0]
    if any(draft.lines[:split] != first.lines[:split] for draft in drafts):
        raise NotPlannedError("solutions that differ before they part")
    desk = first.fork()
    desk.lines, desk.ends, desk.split = first.lines[:split], list(before.ends), None
    ends = []
    for count, draft in enumerate(drafts, len(before.cases) + 1):
        assert draft.split is not None
        numbers = _added(desk, draft, split)
        own = tuple(
            numbers[each.number]
            for each in draft.lines[split:]
            if _under(draft, each.number, split)
        )
        desk.cases.append(Case(count, split, draft.split[1], own))
        for end in draft.ends[len(before.ends) :]:
            line = numbers.get(end.line, end.line)
            case = count if line in own else None
            placed = replace(end, line=line, case=case)
            if placed not in ends:
                ends.append(placed)
    items = list(dict.fromkeys(each.item for each in ends))
    desk.ends += sorted(ends, key=lambda each: items.index(each.item))
    return desk


def _added(desk: Desk, draft: Desk, split: int) -> dict[int, int]:
    """Adds the lines of one solution below the split; returns their new numbers by the old."""
    numbers: dict[int, int] = {}
    for line in draft.lines[split:]:
        premises = tuple(_renumbered(each, numbers) for each in line.premises)
        again = None
        if not _under(draft, line.number, split):
            again = next(
                (e.number for e in desk.lines[split:] if e.relation == line.relation), None
            )
        if again is not None:
            numbers[line.number] = again
            continue
        number = len(desk.lines) + 1
        desk.lines.append(replace(line, number=number, premises=premises))
        numbers[line.number] = number
    return numbers


def _renumbered(ref: Ref, numbers: dict[int, int]) -> Ref:
    return numbers.get(ref, ref) if isinstance(ref, int) else ref


def _under(draft: Desk, number: int, split: int) -> bool:
    """Whether a line rests on the alternatives at which the solutions part."""
    pending, seen = [number], set()
    while pending:
        line: Line = draft.line(pending.pop())
        for ref in line.premises:
            if ref == split:
                return True
            if isinstance(ref, int) and ref not in seen:
                seen.add(ref)
                pending.append(ref)
    return False
