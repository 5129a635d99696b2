"""What events, their working and moments before and after them are called."""

from __future__ import annotations

from collections.abc import Mapping

SENTENCES: Mapping[str, str] = {
    "heading.impact": "{order:capital} impact: {first} hits {second}",
    "heading.impact-number": "Impact {number}: {first} hits {second}",
    "heading.kick": "Impulse given to {body}",
    "heading.kick-order": "{order:capital} impulse given to {body}",
    "heading.kick-number": "Impulse {number}, given to {body}",
    "heading.case": "If {values:and}:",
    "event.only": "the impact",
    "event.impact": "the {order} impact",
    "event.impact-number": "impact {number}",
    "event.struck": "the impulse",
    "event.struck-order": "the {order} impulse",
    "event.kick": "the impulse given to {body}",
    "event.kick-order": "the {order} impulse given to {body}",
    "event.kick-number": "impulse {number} given to {body}",
    "event.after": "after {event}",
    "event.during": "at {event}",
    "event.due": "due to {event}",
    "event.arrival": "when {body} reaches {target}",
    "event.start": "the start",
    "derived.when": "{quantity} {when}",
    "derived.before": "before {event}",
    "derived.at-the-start": "at the start",
    "derived.at-time": "at time {time}",
    "derived.later": "{time} after {event}",
    "derived.later-at": "at time {time} after {event}",
    "derived.of": "of {event}",
}
