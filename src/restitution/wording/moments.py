"""The events to which quantities belong, and when something holds by their names."""

from __future__ import annotations

from restitution.expression.tree import Quantity
from restitution.problem import Kick, bodies_of
from restitution.wording.scene import Scene, event_name
from restitution.wording.structure import Words
from restitution.wording.words import words


def event_number(scene: Scene, tree: Quantity, body: str | None = None) -> int:
    """The number of the event that a quantity of an event belongs to."""
    if isinstance(tree.stage, int):
        return tree.stage
    if body is not None:
        for number in range(scene.now, 0, -1):
            if body in bodies_of(scene.events[number - 1]):
                return number
    return scene.now


def in_event(scene: Scene, number: int) -> Words:
    """``in the impact``; nothing where the statement has only one event."""
    if len(scene.events) <= 1:
        return ()
    return during(scene, number)


def during(scene: Scene, number: int) -> Words:
    """``in the impact``, ``due to the impulse``."""
    if number == 0:
        return ()
    due = isinstance(scene.events[number - 1], Kick)
    return words("due to " if due else "in ", event_name(scene, number))


def same_event(one: Words, other: Words) -> bool:
    """Whether two moments are of one event: ``immediately after …`` and ``in …`` it."""
    return bool(one and other) and _event_of(one) == _event_of(other)


def _event_of(when: Words) -> Words:
    first = when[0]
    if isinstance(first, str):
        for lead in ("immediately after ", "immediately before ", "in ", "due to "):
            if first.startswith(lead):
                return (first.removeprefix(lead), *when[1:])
    return when
