"""A question in the world of a mistake: its impacts, or what it asks for, altered.

A law that is altered is altered at every impact at which the mistake can be made. A result that is
altered is rewritten wherever the statement speaks of it, in questions and in facts: so a mistake
works forwards and backwards.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import staged
from restitution.explaining.lines.derivation import Event
from restitution.explaining.lines.trees import exchanged, rebuilt, settled
from restitution.explaining.mistakes.alteration import Alteration
from restitution.explaining.mistakes.misconceptions import VariantAt, variant_at
from restitution.expression.tree import (
    Expression,
    Letter,
    Quantity,
    is_binary,
    is_quantity,
    walk,
)
from restitution.problem import (
    Aligned,
    AlteredEquation,
    AlteredImpact,
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Let,
    Part,
    Problem,
    Relation,
    Show,
    Step,
)
from restitution.records import dataclass

Change = Callable[[Expression], Expression]
# Mistakes about a fact: nobody makes them where the quantity itself is asked for.
_OF_RATIOS = frozenset({"energy-ratio-as-speed"})


@dataclass(frozen=True)
class AlteredProblem:
    """A problem in the world of a variant; ``at`` are the events at which something is altered."""

    alteration: Alteration
    problem: Problem
    at: tuple[VariantAt, ...]


def altered(
    problem: Problem, wanted: Alteration, only: Iterable[int] | None = None
) -> AlteredProblem | None:
    """A problem with a variant of a mistake at each impact, or at those with the numbers ``only``.

    None where nothing in it is altered: no impact of this kind, or no such result spoken of.
    """
    events = events_of(problem)
    at = tuple(
        variant
        for event in events
        if only is None or event.number in only
        for variant in (variant_at(wanted, event, events),)
        if variant is not None
    )
    changed = problem
    if any(variant.laws for variant in at):
        changed = replace(problem, altered=tuple(_impact(variant) for variant in at))
    results = _results(problem, at, events)
    if results:
        changed = _rewritten(changed, results, events, wanted.mistake in _OF_RATIOS)
    return AlteredProblem(wanted, changed, at) if changed != problem else None


def _impact(variant: VariantAt) -> AlteredImpact:
    equations = (AlteredEquation(law.law, law.bodies, *law.sides) for law in variant.laws)
    return AlteredImpact(variant.event.number, tuple(equations), variant.senses)


# --- results --------------------------------------------------------------------------------------


def _results(
    problem: Problem, at: Iterable[VariantAt], events: tuple[Event, ...]
) -> dict[Expression, Expression]:
    """What is put in place of what, after all stages are written."""
    put: dict[Expression, Expression] = {}
    for variant in at:
        e = _coefficient(problem, variant.event.number)
        for result in variant.results:
            value = rebuilt(result.value, _with_coefficient(e))
            put.setdefault(settled(result.quantity, events), value)
    return put


def _coefficient(problem: Problem, number: int) -> Expression:
    """The coefficient of restitution as the statement gives it."""
    step = problem.events[number - 1]
    given = step.e if isinstance(step, Impact) else None
    return Letter("e") if given is None else given


def _with_coefficient(e: Expression) -> Change:
    def change(node: Expression) -> Expression:
        return e if is_quantity(node, "restitution") else node

    return change


def _rewritten(
    problem: Problem,
    put: Mapping[Expression, Expression],
    events: tuple[Event, ...],
    ratios: bool = False,
) -> Problem:
    """The problem with others in place of some of its quantities, wherever it speaks of them.

    With ``ratios`` in its facts alone, and where a quotient is asked for.
    """
    parts = []
    count = 0
    for part in problem.parts:
        steps: list[Step] = []
        for step in part.steps:
            if step in part.events:
                count += 1
                steps.append(step)
                continue

            def change(
                tree: Expression, now: int = count, given: bool = isinstance(step, Given)
            ) -> Expression:
                if ratios and not given and not is_binary(tree, "/"):
                    return tree
                plain = settled(staged(problem, tree, now), events)
                other = exchanged(plain, put)
                if ratios and any(_is_energy(node) for node in walk(other)):
                    return tree  # energies and speeds would stand side by side
                return tree if other == plain else other

            steps.append(_step(step, change))
        parts.append(Part(part.label, tuple(steps), place=part.place))
    return replace(problem, parts=tuple(parts))


def _is_energy(tree: Expression) -> bool:
    return isinstance(tree, Quantity) and "energy" in tree.kind


def _step(step: Step, change: Change) -> Step:
    match step:
        case Let():
            return replace(step, expression=change(step.expression))
        case Given():
            return replace(
                step, relations=tuple(_relation(relation, change) for relation in step.relations)
            )
        case Find():
            return replace(step, items=tuple(_item(item, change) for item in step.items))
        case Show():
            subject = None if step.subject is None else _item(step.subject, change)
            return replace(step, relation=_relation(step.relation, change), subject=subject)
    return step


def _item(item: Any, change: Change) -> Any:
    if isinstance(item, Extremum):
        return replace(item, expression=change(item.expression), over=change(item.over))
    return replace(item, expression=change(item.expression))


def _relation(relation: Relation, change: Change) -> Relation:
    if isinstance(relation, Compare):
        return replace(relation, operands=tuple(change(operand) for operand in relation.operands))
    if isinstance(relation, Aligned):
        return replace(relation, left=change(relation.left), right=change(relation.right))
    return relation
