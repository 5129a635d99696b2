"""How a working calls its events, and when something is so: *after the second impact*."""

from __future__ import annotations

from collections.abc import Mapping

from restitution.explaining.lines.derivation import Derivation, Event, Meaning
from restitution.explaining.lines.saying import Sentence, say, slots_of
from restitution.explaining.lines.sentences import SENTENCES, SentenceId
from restitution.explaining.lines.trees import settled
from restitution.expression.tree import (
    AtTime,
    Binary,
    Expression,
    Number,
    Quantity,
    Stage,
    has_quantity,
    walk,
)
from restitution.problem import Arrival, Problem
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.workings.naming.measured import Measures, with_unit
from restitution.workings.naming.multiples import measured_meanings


@dataclass
class Moments:
    """The events of one working in words.

    ``now`` is the event under whose heading the next line stands, ``heading_in_part`` the
    same where that heading stands in its own part.
    """

    derivation: Derivation
    problem: Problem
    now: int | None = None
    heading_in_part: int | None = None

    def __post_init__(self) -> None:
        self.meanings: Mapping[str, Meaning] = self.derivation.meanings
        self.events = {event.number: event for event in self.derivation.events}
        self.impacts = [event for event in self.events.values() if event.kind == "impact"]
        happenings = [event for event in self.events.values() if event.kind != "arrival"]
        self.several = len(happenings) > 1

    def layout(self, tree: Expression) -> lay.Layout:
        """A tree as it stands in a line."""
        raise NotImplementedError

    def heading(self, event: Event) -> Sentence:
        """The heading of an impact, or of an impulse from outside."""
        if event.kind == "kick":
            return self._kick(event, "heading.kick", "heading.kick-order", "heading.kick-number")
        first, second = event.bodies
        number = self._order(event)
        if f"ordinal.{number}" in SENTENCES:
            order = say(f"ordinal.{number}")
            return say("heading.impact", order=order, first=first, second=second)
        return say("heading.impact-number", number=number, first=first, second=second)

    def _event(self, event: Event) -> Sentence:
        """What an event is called within a sentence: *the impact*, *the second impact*."""
        if event.kind == "kick":
            if self._is_struck_alone(event):
                return self._kick(event, "event.struck", "event.struck-order", "event.kick-number")
            return self._kick(event, "event.kick", "event.kick-order", "event.kick-number")
        if len(self.impacts_with(event)) < 2:
            return say("event.only")
        number = self._order(event)
        if f"ordinal.{number}" in SENTENCES:
            return say("event.impact", order=say(f"ordinal.{number}"))
        return say("event.impact-number", number=number)

    def _kick(
        self, event: Event, only: SentenceId, ordered: SentenceId, numbered: SentenceId
    ) -> Sentence:
        """An impulse from outside, counted among those that its body receives."""
        (body,) = event.bodies
        kicks = [e.number for e in self.events.values() if e.kind == "kick" and body in e.bodies]
        number = 1 + kicks.index(event.number)
        slots = dict.fromkeys(slots_of(only), body)
        if len(kicks) < 2:
            return say(only, **slots)
        if f"ordinal.{number}" in SENTENCES:
            return say(ordered, order=say(f"ordinal.{number}"), **slots)
        return say(numbered, number=number, body=body)

    def _is_struck_alone(self, event: Event) -> bool:
        """Whether no other body receives an impulse from outside."""
        kicks = (event for event in self.events.values() if event.kind == "kick")
        return all(other.bodies == event.bodies for other in kicks)

    def _order(self, event: Event) -> int:
        """Which of the impacts an event is, counted from 1."""
        return 1 + sum(impact.number < event.number for impact in self.impacts_with(event))

    def impacts_with(self, event: Event) -> list[Event]:
        """The impacts of one story with an event: parts may tell of different bodies."""
        bodies, size = set(event.bodies), 0
        while size != len(bodies):
            size = len(bodies)
            for other in self.events.values():
                if bodies & set(other.bodies):
                    bodies |= set(other.bodies)
        return [impact for impact in self.impacts if bodies & set(impact.bodies)]

    def _settled(self, tree: Quantity) -> int | None:
        known = settled(tree, self.derivation.events)
        stage = known.stage if isinstance(known, Quantity) else None
        return stage if isinstance(stage, int) else None

    def last(self, body: str | None) -> int:
        """The number of the last event that changes a velocity."""
        return max(
            (
                e.number
                for e in self.events.values()
                if e.kind != "arrival" and (body is None or body in e.bodies)
            ),
            default=0,
        )

    def _start(self) -> Sentence:
        if self.several or len(self.impacts) != 1:
            return say("derived.at-the-start")
        return say("derived.before", event=say("event.only"))

    def _when(self, number: int | None, body: str | None) -> Sentence | None:
        """When a lasting quantity is meant; None where it is plain."""
        if number is None or number == self.now or (number and number >= self.last(body)):
            return None
        return self._plain_when(number)

    def _plain_when(self, number: int | None) -> Sentence:
        if not number:
            return self._start()
        if self.events[number].kind == "arrival":
            return self._moment(number)
        return say("event.after", event=self._event(self.events[number]))

    def called(self, event: Event) -> Sentence:
        """What an event is called: *the third impact*."""
        return self._event(event)

    def moment(self, stage: int) -> Sentence:
        """When an event is: *at the second impact*."""
        return self._moment(stage)

    def _moment(self, stage: int, of: bool = False) -> Sentence:
        event = self.events[stage]
        if event.kind == "arrival":
            step = self._arrivals().get(stage)
            target = self.layout(step.target) if step is not None else lay.Words("")
            return say("event.arrival", body=event.bodies[0], target=target)
        named = self._event(event)
        return say("derived.of", event=named) if of else say("event.during", event=named)

    def _arrivals(self) -> dict[int, Arrival]:
        kinds = ("Impact", "Kick", "Arrival")
        arrivals = (step for _, step in self.problem.steps() if type(step).__name__ in kinds)
        return {n: step for n, step in enumerate(arrivals, 1) if isinstance(step, Arrival)}

    def _when_at(self, stage: Stage) -> Sentence | None:
        """When a place is meant, in words: at the start, at an event, or at a time."""
        match stage:
            case AtTime(time):
                return self._later(time)
            case 0:
                return say("derived.at-the-start")
            case int(number) if number in self.events:
                return self._moment(number)
        return None

    def _later(self, time: Expression) -> Sentence:
        """A time by what it is counted from: an event, or where the clock starts."""
        match time:
            case Binary("+", Quantity("time", (), int(number)), length) if number in self.events:
                return self._after_by(length, self._started(number))
        fact = self.derivation.fact("start")
        if has_quantity(time) or fact is None:
            return say("derived.at-time", time=self.layout(time))
        left = fact.relation.only[0].left
        begins = left.stage if isinstance(left, Quantity) else None
        return self._after_by(time, self._started(begins if isinstance(begins, int) else 0))

    def _after_by(self, time: Expression, event: Sentence) -> Sentence:
        """How long after an event: *2 s after the impact*, *at time r/u after the impact*."""
        duration = self._in_seconds(time)
        return say(
            "derived.later" if duration != self.layout(time) else "derived.later-at",
            time=duration,
            event=event,
        )

    def _started(self, number: int) -> Sentence:
        """The event, or the start, from which a time is counted."""
        return self._event(self.events[number]) if number in self.events else say("event.start")

    def unit(self, tree: Expression) -> str:
        """The unit of a quantity; nothing where letters give the scale."""
        return Measures(self.problem, measured_meanings(self.derivation)).unit(tree)

    def _in_seconds(self, time: Expression) -> lay.Layout:
        """A plain number of seconds with its unit, where the statement has units."""
        duration = self.layout(time)
        if not all(isinstance(node, Number | Binary) for node in walk(time)):
            return duration
        unit = self.unit(Quantity("time", (), 1))
        return with_unit(duration, unit)
