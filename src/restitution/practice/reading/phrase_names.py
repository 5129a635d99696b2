"""What a name in words is of: a moment, an event, an axis, nothing certain."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.practice.reading.features import features_of, words_of
from restitution.practice.reading.vocabulary import HEADS
from restitution.problem import Impact, Problem

_MOVING = frozenset(("speed", "velocity"))
_IN_ALL = frozenset(("total", "overall", "altogether"))
_MOMENTS = frozenset(("at", "when", "where", "t", "after", "before"))
_VAGUE = frozenset(("magnitude", "angle", "ratio", "gradient"))


def names_quantity(words: Sequence[str], problem: Problem) -> bool:
    """Whether words name a quantity: they have a head, or a direction and nothing strange."""
    features = features_of(words, problem)
    if features.heads == {"change"}:
        return bool(features.names)
    if features.heads == {"gain"}:
        return False
    if "position" in features.heads:
        return _tells_a_place(words, problem)
    if features.heads == {"gradient"} and not (features.names or features.stage):
        return features.wall or features.direction is not None  # of what, it has to say
    return bool(features.heads or features.direction or features.axis is not None)


def _tells_a_place(words: Sequence[str], problem: Problem) -> bool:
    """Whether words name where a body is that the question places, at no moment of their own."""
    moment = any(word.isdigit() or word.casefold() in _MOMENTS for word in words)
    return not moment and any(sphere.position is not None for sphere in problem.spheres)


UNNAMED_ANGLE = "an angle"
"""The argument of a sine, cosine or tangent typed without one: ``tan = 3/4``."""

UNNAMED_DIRECTION = "the direction"
"""What *direction* alone is read as: ``direction = 30° below i``."""


def is_phrase(name: str) -> bool:
    """Whether the name of a `Letter` is a phrase: it has a blank in it, as no letter has."""
    return " " in name


def is_relative(name: str) -> bool:
    """Whether a phrase names a speed of approach or of separation, and so its moment."""
    words = name.casefold().split()
    return any(HEADS.get(word) in ("approach", "separation") for word in words) or (
        not {"rel", "relative"}.isdisjoint(words) and any(HEADS.get(x) in _MOVING for x in words)
    )


def tells_after(name: str, problem: Problem) -> bool:
    """Whether a phrase says that its quantity is one after an event."""
    return features_of(words_of(name), problem).stage == "after"


def speaks_of_the_end(name: str) -> bool:
    """Whether a phrase names what is after all events: *final speed*."""
    return not {"final", "finally", "eventual"}.isdisjoint(name.casefold().split())


def event_of(name: str, problem: Problem) -> int | None:
    """The number of the event that a phrase counts, ``loss of the second impact``; else None."""
    counted = features_of(words_of(name), problem).event
    impacts = [n for n, event in enumerate(problem.events, 1) if isinstance(event, Impact)]
    return impacts[counted - 1] if counted is not None and counted <= len(impacts) else None


def is_vague(name: str) -> bool:
    """Whether a phrase says what kind of value it is, and not of what: *size*, *the angle*."""
    words = [word for word in name.casefold().split() if word != "the"]
    return all(HEADS.get(word) in _VAGUE for word in words)


def is_whole_loss(name: str, problem: Problem) -> bool:
    """Whether a phrase names an energy lost, and says neither of which body nor in which event."""
    features = features_of(words_of(name), problem)
    of_part = features.names or features.event or features.direction or features.wall
    return "loss" in features.heads and not of_part


def names_time(name: str) -> bool:
    """Whether a phrase names a time: since when, it need not say."""
    return any(HEADS.get(word) == "time" for word in name.casefold().split())


def names_distance(name: str) -> bool:
    """Whether a phrase names a distance: of what, it need not say, and it is no coordinate."""
    return any(HEADS.get(word) == "distance" for word in name.casefold().split())


def names_way_back(name: str) -> bool:
    """Whether a phrase names the time of the way back."""
    return names_time(name) and "back" in name.casefold().split()


def names_whole_time(name: str) -> bool:
    """Whether a phrase names a time and tells since when it counts: *total time*."""
    return names_time(name) and not _IN_ALL.isdisjoint(name.casefold().split())


def names_axis(name: str) -> bool:
    """Whether a phrase names i or j: *the j component*, and so its sense; the letter I does not."""
    return is_phrase(name) and not {"i", "j"}.isdisjoint(name.casefold().split())
