"""Several solutions of a part, each written by itself, put together as cases."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from restitution.explaining.lines.derivation import (
    Case,
    Derivation,
    ItemEnd,
    Line,
    Ref,
    numbers_in,
)
from restitution.planning.writing.desk import Desk, NotPlannedError


def joined(before: Desk, drafts: Sequence[Desk]) -> Desk:
    """One desk of several that went on from the same: what is common stands once.

    Where all are alike, that is the one.
    Raises NotPlannedError where the solutions do not part at lines of alternatives.
    """
    if all(_same(draft, drafts[0]) for draft in drafts):
        parted = [split[0] for split in drafts[0].splits[len(before.splits) :]]
        drafts[0].splits = before.splits if len(drafts) > 1 else drafts[0].splits
        if len(drafts) > 1 and parted:
            drafts[0].forget(min(parted))
        return drafts[0]
    for draft in drafts:
        draft.splits = _splits_in_use(before, draft)
    if (common := _ended_before_they_part(before, drafts)) is not None:
        return common
    desk = _joined(before, drafts, 0)
    if len(drafts) > 1:
        desk.forget(min(split[0] for draft in drafts for split in draft.splits[:1]))
    return desk


def _ended_before_they_part(before: Desk, drafts: Sequence[Desk]) -> Desk | None:
    """The lines that are the same in all drafts, where every item ends there; None where not.

    A quadratic that is to be shown is solved in the part that asks for its roots.
    """
    first, own = drafts[0], [draft.splits[len(before.splits) :] for draft in drafts]
    if not all(own) or len({splits[0][0] for splits in own}) > 1:
        return None
    split = own[0][0][0]
    lines = first.lines[: split - 1]
    ends = first.ends[len(before.ends) :]
    if len(lines) < len(before.lines) or not ends or any(end.line >= split for end in ends):
        return None
    if any(
        (e.lines[: split - 1], e.ends, e.notes) != (lines, first.ends, first.notes) for e in drafts
    ):
        return None
    desk = first.fork()
    desk.lines, desk.splits = lines, before.splits
    desk.forget(split)
    return desk


def _splits_in_use(before: Desk, draft: Desk) -> tuple[tuple[int, int], ...]:
    """The splits of a draft without those of an earlier part on which nothing new rests.

    An item may end at a line of an earlier part.
    """
    new = [line.number for line in draft.lines[len(before.lines) :]]
    new += [end.line for end in draft.ends if end not in before.ends]
    return tuple(
        split
        for split in draft.splits
        if split[0] > len(before.lines) or any(split[0] in draft.under(n) for n in new)
    )


def _same(one: Desk, other: Desk) -> bool:
    return (one.lines, one.ends, one.notes) == (other.lines, other.ends, other.notes)


def _joined(before: Desk, drafts: Sequence[Desk], depth: int) -> Desk:
    """The same, of solutions that have parted so many times already."""
    if len(drafts) == 1:
        return drafts[0]
    splits = [draft.splits[depth] if len(draft.splits) > depth else None for draft in drafts]
    parted = {split[0] for split in splits if split is not None}
    options = list(dict.fromkeys(split[1] for split in splits if split is not None))
    if len(parted) != 1 or None in splits or len(options) < 2:
        raise NotPlannedError("solutions that do not part at one line")
    (split,) = parted
    groups = [
        [own for own, branch in zip(drafts, splits, strict=True) if branch == (split, option)]
        for option in options
    ]
    first = drafts[0]
    # The alternatives may be those of an earlier part, of which all lines stay.
    start = max(split, len(before.lines))
    if not all(_alike(draft.lines[:start], first.lines[:start]) for draft in drafts):
        raise NotPlannedError("solutions that differ before they part")
    desk = first.fork()
    desk.lines, desk.ends, desk.splits = first.lines[:start], list(before.ends), ()
    desk.cases = list(before.cases)
    ends: list[ItemEnd] = []
    branches = [_joined(before, group, depth + 1) for group in groups]
    for n, (option, branch) in enumerate(zip(options, branches, strict=True)):
        # What only one case makes use of stands there, and not below what another one ends with.
        alone = _of_one_case(branch, branches[:n] + branches[n + 1 :], split, start) if n else ()
        for end in _added_case(before, desk, branch, split, option, alone):
            if end not in ends:
                ends.append(end)
    items = list(dict.fromkeys(end.item for end in ends))
    desk.ends += sorted(ends, key=lambda end: items.index(end.item))
    desk.splits = first.splits[:depth]
    if any(draft.notes != first.notes for draft in drafts):
        raise NotPlannedError("solutions of which one has no answer")
    return desk


def _alike(some: Sequence[Line], others: Sequence[Line]) -> bool:
    """Whether lines say the same, but for the form of equations on the way to the last of them.

    Of a factor that has one sign in one solution only, the sides may be turned round.
    """
    for one, other in zip(some, others, strict=True):
        if one == other:
            continue
        if (
            one is some[-1]
            or one.move.id != "rearrange"
            or one != replace(other, relation=one.relation)
        ):
            return False
    return True


def without_idle(derivation: Derivation) -> Derivation:
    """A working without cases under which nothing stands: the alternatives are the answer."""
    busy = {case.line for case in derivation.cases if case.lines}
    idle = {case.number for case in derivation.cases if case.line not in busy}
    return replace(
        derivation,
        cases=tuple(case for case in derivation.cases if case.number not in idle),
        items=tuple(
            dict.fromkeys(
                replace(item, case=None) if item.case in idle else item for item in derivation.items
            )
        ),
    )


def _of_one_case(draft: Desk, others: Sequence[Desk], split: int, start: int) -> set[int]:
    """The lines of a case that hold in all of them, but of which only this one makes use."""
    elsewhere = [line.relation for other in others for line in other.lines[start:]]
    shared: set[int] = set()
    alone: set[int] = set()
    for line in reversed(draft.lines[start:]):
        if split in draft.under(line.number):
            continue
        if line.number in shared or line.relation in elsewhere:
            shared |= set(numbers_in(line.premises))
        else:
            alone.add(line.number)
    return alone


def _added_case(
    before: Desk, desk: Desk, draft: Desk, split: int, option: int, alone: Collection[int]
) -> list[ItemEnd]:
    """Adds what follows from one of some alternatives; returns its last lines of items.

    The lines that stand ``alone`` are of this case too.
    """
    start = max(split, len(before.lines))
    within_case = {
        line.number
        for line in draft.lines[start:]
        if line.number in alone or split in draft.under(line.number)
    }
    numbers = _added(desk, draft, within_case, start)
    own = tuple(numbers[line.number] for line in draft.lines[start:] if line.number in within_case)
    count = len(desk.cases) + 1
    desk.cases.append(Case(count, split, option, own))
    within = {}
    for case in draft.cases[len(before.cases) :]:
        within[case.number] = len(desk.cases) + 1
        lines = tuple(numbers.get(number, number) for number in case.lines)
        line = numbers.get(case.line, case.line)
        desk.cases.append(Case(within[case.number], line, case.option, lines))
    ends = []
    for end in draft.ends[len(before.ends) :]:
        line = numbers.get(end.line, end.line)
        number = count if line in own else None
        if end.case is not None:
            number = within.get(end.case, number)
        ends.append(replace(end, line=line, case=number))
    return ends


def _added(desk: Desk, draft: Desk, own: Collection[int], start: int) -> dict[int, int]:
    """Adds the lines of one solution from a start on; returns their new numbers by the old.

    Its ``own`` lines are those of the case.
    """
    numbers: dict[int, int] = {}
    # What holds in all cases stands before the first of them.
    for line in sorted(draft.lines[start:], key=lambda line: line.number in own):
        premises = tuple(_renumbered(premise, numbers) for premise in line.premises)
        again = None
        if line.number not in own:
            again = next(
                (e.number for e in desk.lines[start:] if e.relation == line.relation), None
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
