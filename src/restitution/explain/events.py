"""Events by what they are: ``after the first impact`` for ``after event 1``, ``t₂`` for times."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

from restitution.explain.journeys import time_letter
from restitution.explain.phrases import ORDINALS
from restitution.explain.steps import Row, Step
from restitution.expression.tree import Name
from restitution.problem import Arrival, Impact, Kick
from restitution.render.layout import Brackets, Layout, Letter, Phrase, Words
from restitution.solve.story import Story

Table = Mapping[Layout, Layout]


def table_of(story: Story) -> Table:
    """What to say in place of the number of an event."""
    table: dict[Layout, Layout] = {}
    steps = [each.step for each in story.happenings]
    impacts = [step for step in steps if isinstance(step, Impact)]
    for number, step in enumerate(steps, 1):
        table[Phrase((Words("time"), Words(f"of event {number}")))] = time_letter(number)
        name = _name(step, impacts, steps)
        if name is not None:
            table[Words(f"after event {number}")] = Words(f"after {name}")
            table[Words(f"in event {number}")] = Words(f"at {name}")
        elif isinstance(step, Arrival) and isinstance(step.target, Name):
            said = Words(f"when {step.body} reaches {step.target.name}")
            table[Words(f"after event {number}")] = said
    return table


def _name(step: Any, impacts: list[Impact], steps: list[Any]) -> str | None:
    if isinstance(step, Impact):
        order = next(n for n, each in enumerate(impacts, 1) if each is step)
        if len(impacts) == 1:
            return "the impact"
        return f"the {ORDINALS[order]} impact" if order < len(ORDINALS) else f"impact {order}"
    if isinstance(step, Kick):
        given = [each for each in steps if isinstance(each, Kick) and each.body == step.body]
        return f"the impulse given to {step.body}" if len(given) == 1 else None
    return None


def spoken(step: Step, table: Table) -> Step:
    """A step with its events named."""
    return replace(
        step,
        words=tuple(each if isinstance(each, str) else _put(each, table) for each in step.words),
        rows=tuple(_row(each, table) for each in step.rows),
    )


def _row(row: Row, table: Table) -> Row:
    operands = tuple(None if each is None else _put(each, table) for each in row.operands)
    note = tuple(each if isinstance(each, str) else _put(each, table) for each in row.note)
    return replace(row, operands=operands, note=note)


def _put(laid: Any, table: Table) -> Any:
    """A layout with parts replaced, wherever they stand in it."""
    if isinstance(laid, tuple):
        return tuple(_put(each, table) for each in laid)
    if not hasattr(laid, "__dataclass_fields__"):
        return laid
    if laid in table:
        return table[laid]
    changed = {
        each.name: _put(getattr(laid, each.name), table)
        for each in fields(laid)
        if not isinstance(getattr(laid, each.name), str | int | None)
    }
    changed = {name: made for name, made in changed.items() if made is not getattr(laid, name)}
    if not any(made != getattr(laid, name) for name, made in changed.items()):
        return laid
    made = replace(laid, **changed)
    if isinstance(made, Brackets) and isinstance(made.inside, Letter):
        return made.inside  # no longer several words
    return made


__all__ = ["spoken", "table_of"]
