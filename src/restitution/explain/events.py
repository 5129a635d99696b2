"""Events by what they are: ``after the first impact`` for ``after event 1``, ``t₂`` for times."""

from __future__ import annotations

from typing import Any

from restitution.explain.journeys import time_letter
from restitution.explain.phrases import ordinal
from restitution.explaining.saying import Sentence, say
from restitution.expression.tree import Name
from restitution.problem import Arrival, Impact, Kick
from restitution.render.layout import EventNames, Layout
from restitution.solve.story import Story


def names_of(story: Story) -> EventNames:
    """What to say in place of the number of an event."""
    after: dict[int, str] = {}
    during: dict[int, str] = {}
    times: dict[int, Layout] = {}
    steps = [each.step for each in story.happenings]
    impacts = [step for step in steps if isinstance(step, Impact)]
    for number, step in enumerate(steps, 1):
        times[number] = time_letter(number)
        name = _name(step, impacts, steps)
        if name is not None:
            after[number] = str(say("event.after", event=name))
            during[number] = str(say("event.during", event=name))
        elif isinstance(step, Arrival) and isinstance(step.target, Name):
            arrival = say("event.arrival", body=step.body, target=step.target.name)
            after[number] = str(arrival)
    return EventNames(after, during, times)


def _name(step: Any, impacts: list[Impact], steps: list[Any]) -> Sentence | None:
    if isinstance(step, Impact):
        order = next(n for n, each in enumerate(impacts, 1) if each is step)
        if len(impacts) == 1:
            return say("event.only")
        spoken = ordinal(order)
        if spoken is None:
            return say("event.impact-number", number=order)
        return say("event.impact", order=spoken)
    if isinstance(step, Kick):
        given = [each for each in steps if isinstance(each, Kick) and each.body == step.body]
        return say("event.kick", body=step.body) if len(given) == 1 else None
    return None


__all__ = ["names_of"]
