"""Events by what they are: ``after the first impact`` for ``after event 1``, ``t₂`` for times."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from functools import cache
from typing import Any

from restitution.explain.journeys import time_letter
from restitution.explain.phrases import ORDINALS
from restitution.explain.steps import Row, Step, Words
from restitution.expression.tree import Name
from restitution.problem import Arrival, Impact, Kick
from restitution.render.layout import Brackets, Layout, Letter, Phrase
from restitution.render.layout import Words as Text
from restitution.solve.story import Story

Table = Mapping[Layout, Layout]


def table_of(story: Story) -> Table:
    """What to say in place of the number of an event."""
    table: dict[Layout, Layout] = {}
    steps = [each.step for each in story.happenings]
    impacts = [step for step in steps if isinstance(step, Impact)]
    for number, step in enumerate(steps, 1):
        table[Phrase((Text("time"), Text(f"of event {number}")))] = time_letter(number)
        name = _name(step, impacts, steps)
        if name is not None:
            table[Text(f"after event {number}")] = Text(f"after {name}")
            table[Text(f"in event {number}")] = Text(f"at {name}")
        elif isinstance(step, Arrival) and isinstance(step.target, Name):
            said = Text(f"when {step.body} reaches {step.target.name}")
            table[Text(f"after event {number}")] = said
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
    words = _words(step.words, table)
    rows = tuple(_row(each, table) for each in step.rows)
    if words is step.words and all(a is b for a, b in zip(rows, step.rows)):
        return step
    return replace(step, words=words, rows=rows)


def _row(row: Row, table: Table) -> Row:
    operands = tuple(None if each is None else _put(each, table) for each in row.operands)
    note = _words(row.note, table)
    if note is row.note and all(a is b for a, b in zip(operands, row.operands)):
        return row
    return replace(row, operands=operands, note=note)


def _words(words: Words, table: Table) -> Words:
    made = tuple(each if isinstance(each, str) else _put(each, table) for each in words)
    return words if all(a is b for a, b in zip(made, words)) else made


def _put(laid: Any, table: Table) -> Any:
    """A layout with parts replaced, wherever they stand in it; the same one if there are none."""
    kind: Any = type(laid)
    if kind is tuple:
        items = tuple(_put(each, table) for each in laid)
        return laid if all(a is b for a, b in zip(items, laid)) else items
    if kind in _NAMING and laid in table:
        return table[laid]
    changed = {}
    for name in _parts(kind):
        part = getattr(laid, name)
        if part is None or isinstance(part, str | int):
            continue
        made = _put(part, table)
        if made is not part:
            changed[name] = made
    if not changed:
        return laid
    made = replace(laid, **changed)
    if isinstance(made, Brackets) and isinstance(made.inside, Letter):
        return made.inside  # no longer several words
    return made


# What names an event; see `table_of`.
_NAMING = (Phrase, Text)


@cache
def _parts(kind: Any) -> tuple[str, ...]:
    """The names of the fields of a layout."""
    return tuple(each.name for each in fields(kind)) if is_dataclass(kind) else ()


__all__ = ["spoken", "table_of"]
