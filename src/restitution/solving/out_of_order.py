"""Events that are told below others before which they happen."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.errors import RestitutionError
from restitution.expression.tree import Quantity
from restitution.expression.writing import write_expression
from restitution.problem import Arrival, Event, Impact, Problem
from restitution.render.layout import display
from restitution.render.text import to_text
from restitution.solving.equations.solution import PartSolution


def events_out_of_order(problem: Problem, part: PartSolution) -> Iterator[str]:
    """A warning for each event whose time is less than that of one told above, both in numbers."""
    if len(part.branches) != 1:
        return
    (branch,) = part.branches
    try:
        story = branch.story
    except RestitutionError:  # a place in it cannot be told exactly
        return
    latest: tuple[Event, sp.Expr] | None = None
    for number, event in enumerate(problem.events[: len(story.happenings)], 1):
        try:
            time = story.evaluator(number).scalar(Quantity("time", (), number))
        except RestitutionError:
            continue
        own = sp.sympify(time, strict=True)
        if not own.is_number:
            continue
        if latest is not None and bool(own < latest[1]):
            (earlier, before), shown = latest, to_text(display(own))
            yield (
                f"{_named(event)} at the time {shown}, before {_named(earlier)} at the time "
                f"{to_text(display(before))}: tell what happens in the order of time"
            )
        else:
            latest = event, own


def _named(event: Event) -> str:
    match event:
        case Impact(first, second):
            return f"{first} hits {second}"
        case Arrival(body, target):
            return f"{body} reaches {write_expression(target)}"
    return f"{event.body} is struck"
