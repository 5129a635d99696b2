"""Which question comes next, and how sure one is of each topic: from attempts as plain data.

An attempt is a mapping as JSON has it::

    {"topic": "wall-forward", "level": 1, "seed": 7, "day": 740000, "earned": 3, "of": 4,
     "lost_method": true, "mistakes": ["restitution-inverted"]}

``day`` counts days (``date.toordinal()``); nothing here knows what day it is, or keeps anything.
What is missing or no such value is left out of account, as the data are a user's own.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from restitution.practice.questions.dice import Dice
from restitution.practice.questions.topics import LEVELS, TOPICS
from restitution.records import dataclass

PAUSES = (1, 3, 7, 16)
"""Days after which a topic comes back: after the first success in a row, the second, and so on."""

_WELL = 0.7  # the share of marks with which an attempt went well
_IDS = tuple(topic.id for topic in TOPICS)
_WORDS = 60  # characters of the id of a mistake


class Next(NamedTuple):
    """The question that comes next; ``mistake`` is one that it should show, or None."""

    topic: str
    level: int
    mistake: str | None


@dataclass(frozen=True)
class _Attempt:
    topic: str
    level: int
    day: int
    share: float
    lost_method: bool
    mistakes: tuple[str, ...]

    @property
    def well(self) -> bool:
        return self.share >= _WELL and not self.lost_method


def sureness(attempts: Iterable[Mapping[str, object]], day: int) -> dict[str, float]:
    """How sure one is of each topic, 0 to 1, in the order of topics.

    The last three attempts count, the latest most, with the level of each; it fades by half for
    each pause that passes without a return, and never falls to nothing.
    """
    known = _by_topic(attempts)
    return {name: _sureness(known.get(name, []), day) for name in _IDS}


def next_question(attempts: Sequence[Mapping[str, object]], day: int) -> Next:
    """The topic and level that come next.

    First comes a mistake that was named twice since its topic last went well, then topics that are
    due, those that lost a method mark before those that had their rest, then the first topic that
    was never tried. Where nothing is due, the topics are shuffled, by the number of attempts.
    """
    known = _by_topic(attempts)
    mistake = _named_twice(known)
    if mistake is not None:
        topic, name = mistake
        return Next(topic, known[topic][-1].level, name)
    due = [name for name in _IDS if name in known and _is_due(known[name], day)]
    for name in (*(subject for subject in due if known[subject][-1].lost_method), *due):
        return Next(name, level_of(known[name]), None)
    for name in _IDS:
        if name not in known:
            return Next(name, 1, None)
    tried = sum(map(len, known.values()))
    last = next(reversed(_attempts(attempts)))
    others = [name for name in _IDS if name != last.topic]
    name = Dice(f"next/{day}/{tried}").of(others)
    return Next(name, level_of(known[name]), None)


def level_of(attempts: Sequence[_Attempt]) -> int:
    """The level that comes next in a topic: one up after two that went well, one down after two
    that did not.
    """
    last = attempts[-1]
    if len(attempts) < 2 or attempts[-2].level != last.level:
        return last.level
    if all(attempt.well for attempt in attempts[-2:]):
        return min(last.level + 1, LEVELS[-1])
    if all(attempt.share < _WELL for attempt in attempts[-2:]):
        return max(last.level - 1, LEVELS[0])
    return last.level


# --- of one topic -------------------------------------------------------------------------------


def _due(tried: Sequence[_Attempt]) -> int:
    """The day on which a topic comes back: the next day after a method mark was lost."""
    last = tried[-1]
    if last.lost_method or not last.well:
        return last.day if last.lost_method else last.day + PAUSES[0]
    return last.day + PAUSES[min(_days_in_a_row(tried), len(PAUSES)) - 1]


def _is_due(tried: Sequence[_Attempt], day: int) -> bool:
    return _due(tried) <= day


def _days_in_a_row(tried: Sequence[_Attempt]) -> int:
    """On how many days in a row the topic went well; several on one day are one success."""
    run: list[_Attempt] = []
    for attempt in reversed(tried):
        if not attempt.well:
            break
        run.append(attempt)
    return 1 + sum(later.day != earlier.day for later, earlier in pairwise(run)) if run else 0


def _sureness(tried: Sequence[_Attempt], day: int) -> float:
    if not tried:
        return 0.0
    weights = (0.6, 0.3, 0.1)
    latest = list(reversed(tried))[: len(weights)]
    worth = [attempt.share * (0.7 + 0.1 * (attempt.level - 1)) for attempt in latest]
    learnt = sum(weight * number for weight, number in zip(weights, worth, strict=False))
    pause = PAUSES[min(max(_days_in_a_row(tried), 1), len(PAUSES)) - 1]
    late = max(day - tried[-1].day - pause, 0)
    faded: float = learnt * 0.5 ** (late / (4 * pause))
    return round(min(faded, 1.0), 3)


def _named_twice(known: Mapping[str, Sequence[_Attempt]]) -> tuple[str, str] | None:
    """A topic and a mistake that was named in two of its attempts since it last went well."""
    for name in _IDS:
        count: dict[str, int] = {}
        for attempt in reversed(known.get(name, ())):
            if attempt.well and not attempt.mistakes:
                break
            for mistake in dict.fromkeys(attempt.mistakes):
                if not _can_be_shown(mistake):
                    continue
                count[mistake] = count.get(mistake, 0) + 1
        if count and max(count.values()) >= 2:
            return name, max(sorted(count), key=lambda mistake: count[mistake])
    return None


def _can_be_shown(mistake: str) -> bool:
    """Whether a mistake leads to an answer of its own: a slip does not."""
    from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS

    return mistake in MISCONCEPTIONS and MISCONCEPTIONS[mistake].world != "none"


# --- reading ------------------------------------------------------------------------------------


def _by_topic(attempts: Iterable[Mapping[str, object]]) -> dict[str, list[_Attempt]]:
    known: dict[str, list[_Attempt]] = {}
    for attempt in _attempts(attempts):
        known.setdefault(attempt.topic, []).append(attempt)
    return known


def _attempts(attempts: Iterable[Mapping[str, object]]) -> list[_Attempt]:
    read = [_attempt(attempt) for attempt in attempts]
    return [attempt for attempt in read if attempt is not None]


def _attempt(data: object) -> _Attempt | None:
    """An attempt as read; None where it is none."""
    if not isinstance(data, Mapping) or data.get("topic") not in _IDS:
        return None
    level, day, earned, of = (_whole(data.get(key)) for key in ("level", "day", "earned", "of"))
    if level is None or day is None or level not in LEVELS or abs(day) >= 10**8:
        return None
    if earned is None or of is None or not 0 <= earned <= of <= 1000:
        return None
    named = data.get("mistakes")
    mistakes = tuple(
        name for name in (named if isinstance(named, list | tuple) else ()) if _is_id(name)
    )
    share = earned / of if of else 0.0
    return _Attempt(data["topic"], level, day, share, data.get("lost_method") is True, mistakes)


def _whole(value: object) -> int | None:
    return value if isinstance(value, int) and not isinstance(value, bool) else None


def _is_id(value: object) -> bool:
    return isinstance(value, str) and 0 < len(value) <= _WORDS
