"""Items that stand above a given fact of their part, or an event, and hold without it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from restitution.errors import RestitutionError
from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.definitions.ties import tie_of
from restitution.explaining.lines.derivation import Fact
from restitution.explaining.lines.trees import trees_of
from restitution.expression.quantities import ENERGIES
from restitution.expression.tree import (
    Expression,
    Name,
    Pair,
    Quantity,
    Unit,
    has_quantity,
    is_quantity,
    walk,
)
from restitution.problem import Find, Given, Part, Problem, Show, Value, count_of_items
from restitution.records import dataclass
from restitution.solving import solve
from restitution.solving.equations.solution import ItemResult, PartSolution, Solution


@dataclass(frozen=True)
class Early:
    """Items of a part that are written before some of its facts are.

    ``part`` is the part solved without these facts, ``late`` are their ids. ``items`` are the
    numbers of the items; of those in ``ended`` the answer is the same with the facts.
    """

    problem: Problem
    part: PartSolution
    late: frozenset[str]
    items: range
    ended: frozenset[int]


def early_items(solution: Solution, part: PartSolution) -> Iterator[Early]:
    """The items that come before the facts below them, each time as far as the next fact.

    An item is one of them only if every item above it is. A value that is the same with the facts,
    or is asked in no letters and stands above the value of one, is one where another follows it.
    """
    steps = part.part.steps
    asked = 0
    for cut, step in enumerate(steps):
        if not isinstance(step, Given):
            continue
        count = sum(map(count_of_items, steps[:cut]))
        if count == asked:
            continue
        early = _without(solution, part, cut, asked, count)
        if early is None:
            return
        if early.items:
            yield early
        if len(early.items) < count - asked:
            return
        asked = count


def above_event(problem: Problem, part: PartSolution) -> Early | None:
    """The items above an event that cannot happen, if any have an answer without it."""
    before = part.before
    if before is None:
        return None
    number = problem.parts.index(part.part)
    without = replace(problem, parts=(*problem.parts[:number], before.part))
    late = frozenset(fact.id for fact in _late(problem, without, before.part))
    items = range(1, len(before.items) + 1)
    return Early(without, before, late, items, frozenset(items))


def _without(
    solution: Solution, part: PartSolution, cut: int, start: int, stop: int
) -> Early | None:
    """The items between two numbers, without the facts from a step on; None where none is told."""
    problem = solution.problem
    steps = part.part.steps
    later = tuple(step for step in steps[cut:] if not isinstance(step, Given | Find | Show))
    own = replace(part.part, steps=(*steps[:cut], *later))
    number = problem.parts.index(part.part)
    without = replace(problem, parts=(*problem.parts[:number], own))
    try:
        solved = solve(without).parts[own.label]
    except RestitutionError:
        return None
    if len(solved.branches) != 1:
        return None
    late = _late(problem, without, own)
    closes = all(map(_is_of_motion, late)) and not _are_directions_after(problem, late)
    count, ended = start, set[int]()
    for index, alone, whole in zip(
        range(start + 1, stop + 1), solved.items[start:], part.items[start:], strict=False
    ):
        same = _is_same(alone, whole)
        if not same and not _is_in_letters(alone, whole):
            break
        if same:
            ended.add(index)
        in_terms = terms(part.part, index) is not None
        if in_terms or (alone.kind == "show" if same else closes and _serves(alone, late)):
            count = index
    ended = {number for number in ended if number <= count}
    ids = frozenset(fact.id for fact in late)
    return Early(without, solved, ids, range(start + 1, count + 1), frozenset(ended))


def terms(part: Part, index: int) -> tuple[str, ...] | None:
    """The letters in which an item is asked; None where it is asked in none."""
    number = 0
    for step in part.steps:
        number += count_of_items(step)
        if number >= index and isinstance(step, Find | Show):
            return step.in_terms_of
    return None


def _is_of_motion(fact: Fact) -> bool:
    """Whether a fact is no value of a letter, but a condition on the motion."""
    return any(
        has_quantity(side)
        for links in fact.relation.options
        for link in links
        for side in (link.left, link.right)
    )


def _are_directions_after(problem: Problem, late: tuple[Fact, ...]) -> bool:
    """Whether a fact gives the direction of a velocity after a wall that slants.

    The velocity is a letter times that direction, and is resolved: its components are not first.
    """
    axes: dict[Expression, Expression] = {
        Quantity("velocity", (Name(event.bodies[0]),), event.number): fact.relation.only[0].right
        for event in events_of(problem)
        for fact in facts_of(problem)
        if event.wall and fact.id == f"axis {event.number}"
    }
    ties = [tie_of(fact.relation.only[0]) for fact in late if len(fact.relation.options) == 1]
    pairs = [pair for tie in ties if tie is not None for pair in (tie[:2], tie[1::-1])]
    return any(
        isinstance(other, Unit | Pair) and not isinstance(axes.get(one, Unit("i")), Unit)
        for one, other in pairs
    )


def _is_same(alone: ItemResult, whole: ItemResult) -> bool:
    """Whether an item has the same end without the facts below it as with them."""
    if alone.error is not None or whole.error is not None:
        return False
    if alone.kind == "show":
        return bool(alone.holds) and bool(whole.holds)
    return _answers(alone) == _answers(whole)


def _serves(result: ItemResult, late: tuple[Fact, ...]) -> bool:
    """Whether the facts below an item may close by it: an energy or an impulse is no way to another
    quantity.
    """
    item = result.item
    match item.expression if isinstance(item, Value) else None:
        case Quantity(kind) if kind in ENERGIES or kind == "impulse":
            sides = (tree for fact in late for tree in trees_of(fact.relation))
            nodes = (node for tree in sides for node in walk(tree))
            return any(is_quantity(node, kind) for node in nodes)
    return True


def _answers(result: ItemResult) -> list[object]:
    return [
        (answer.exact, answer.where, answer.reached, answer.condition) for answer in result.distinct
    ]


def _is_in_letters(alone: ItemResult, whole: ItemResult) -> bool:
    """Whether an item has one value in letters, of which the facts say what they are."""
    if alone.error is not None or whole.error is not None or not isinstance(alone.item, Value):
        return False
    return len(alone.distinct) == 1


def _late(problem: Problem, without: Problem, part: Part) -> tuple[Fact, ...]:
    """The facts that a part has lost."""
    kept = [fact.relation for fact in facts_of(without) if fact.part == part.label]
    return tuple(
        fact
        for fact in facts_of(problem)
        if fact.part == part.label and fact.id.startswith("given ") and fact.relation not in kept
    )
