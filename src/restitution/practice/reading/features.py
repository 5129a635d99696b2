"""Features of a phrase: its head, its bodies, its moment, its direction and its sense."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from restitution.expression.tree import Expression, Negate, Unit
from restitution.practice.reading.vocabulary import (
    AT_THE_START,
    BODY_WORDS,
    DIRECTIONS,
    EVENT_WORDS,
    HEADS,
    ORDINALS,
    STAGES,
)
from restitution.problem import Problem
from restitution.records import dataclass

_WORD = re.compile(r"[A-Za-z]+[0-9]*|[0-9](?:st|nd|rd|th)|-(?=[ij]\b)|&|\d")
_AGAINST = frozenset(("-", "minus", "negative", "against"))
_SENSES = frozenset(("left", "right", "up", "down", "towards", "away", "opposite"))
AXES: dict[str, Expression] = {
    "i": Unit("i"),
    "j": Unit("j"),
    "x": Unit("i"),
    "y": Unit("j"),
    "horizontal": Unit("i"),
    "vertical": Unit("j"),
    "right": Unit("i"),
    "left": Negate(Unit("i")),
    "up": Unit("j"),
    "down": Negate(Unit("j")),
}


_MASS_CENTRE = frozenset(("centre", "center", "mass", "com", "cm"))
_OF_MOTION = frozenset(("velocity", "vel", "speed", "v", "relative", "rel"))


@dataclass(frozen=True)
class Features:
    """Features of a phrase; ``names`` stand in the order of the words.

    ``timed`` tells that its words say whether it is before or after the event, ``start`` that
    they speak of the very beginning, ``at_wall`` that they do of the moment at a wall, ``lies``
    that an angle is that of a wall itself: ``angle of the wall``.
    """

    heads: frozenset[str] = frozenset()
    names: tuple[str, ...] = ()
    stage: str | None = None
    direction: str | None = None
    axis: Expression | None = None
    sense: str | None = None
    event: int | None = None
    target: str | None = None
    wall: bool = False
    at_wall: bool = False
    lies: bool = False
    both: bool = False
    mass_centre: bool = False
    timed: bool = False
    start: bool = False
    between: bool = False
    gap: bool = False
    reduced: bool = False
    percent: bool = False
    blow: bool = False
    back: bool = False


def words_of(text: str) -> tuple[str, ...]:
    """The words of a phrase as typed."""
    return tuple(_WORD.findall(text.replace("k.e.", "KE").replace("K.E.", "KE")))


def features_of(words: Sequence[str], problem: Problem) -> Features:
    """Features of the words of a phrase; words without a meaning are passed over."""
    spheres = {sphere.name for sphere in problem.spheres}
    walls = {wall.name for wall in problem.walls}
    known = spheres | walls | {point.name for point in problem.points}
    features = Features(mass_centre=_is_of_mass_centre(words))
    if features.mass_centre:
        words = [word for word in words if word.lower() not in _MASS_CENTRE]
    previous = ""
    for place, word in enumerate(words):
        low = word.lower()
        if word in known or (len(word) == 1 and word.upper() in known and _is_name(words, place)):
            name = word if word in known else word.upper()
            features = _with_name(features, name, previous)
            if name in walls and _is_own_angle(words, place, previous):
                features = replace(features, lies=True)
        elif _is_pair_of(word, spheres):
            features = replace(features, names=(*features.names, *word))
        elif low in ("i", "j", "x", "y") and _is_axis(words, place):
            axis = AXES[low]
            features = replace(features, axis=Negate(axis) if previous in _AGAINST else axis)
            if not features.sense and "direction" in [
                word.lower() for word in words[max(0, place - 3) : place]
            ]:
                features = replace(features, sense="axis")
        elif low in HEADS and not (low == "direction" and _is_filler(words, place)):
            percent = features.percent or low in ("percentage", "percent")
            heads, gap = features.heads | {HEADS[low]}, features.gap or low == "gap"
            features = replace(features, heads=heads, percent=percent, gap=gap)
        elif low in DIRECTIONS:
            features = _with_direction(features, DIRECTIONS[low])
        elif low in STAGES:
            features = replace(features, stage=STAGES[low], start=low in AT_THE_START)
        elif low in ORDINALS and _counts_events(words, place):
            features = replace(features, event=ORDINALS[low])
        elif low in ("wall", "cushion", "barrier"):
            met = previous in STAGES or (bool(features.stage) and previous in EVENT_WORDS)
            lies = features.lies or _is_own_angle(words, place, previous)
            features = replace(features, wall=True, at_wall=met, lies=lies)
        elif low in ("total", "both", "system", "overall", "combined"):
            features = replace(features, both=True)
        elif len(low) == 2 and low[0] in "uvw" and low[1] in "xy":
            features = replace(features, axis=AXES[low[1]])
        elif low in ("u", "v", "w") and len(words) == 2:
            features = replace(features, heads=features.heads | {"velocity"})
        elif low in ("blow", "kick", "kicked"):
            features = replace(features, blow=True)
        elif low == "back":
            features = replace(features, back=True)
        elif low == "reduced":
            features = replace(features, reduced=True)
        elif low == "between":
            features = replace(features, between=True)
        elif low in ("relative", "rel"):
            features = replace(features, heads=features.heads | {"relative"})
        elif low in ("from", "off") and previous in ("speed", "component") and not features.sense:
            features = replace(features, sense="away")  # the speed from the wall
        elif low in ("rebounds", "hits", "collides") and not features.stage:
            features = replace(features, stage="after")
        if low not in ("the", "of", "sphere", "ball", "particle", "point"):
            previous = low
    if "energy" in features.heads and features.sense == "left":
        features = replace(features, sense=None, stage="after")  # KE left: what remains
    return features


def _is_of_mass_centre(words: Sequence[str]) -> bool:
    """Whether words speak of the mass centre: ``A relative to centre of mass``.

    Of *COM* and *CM* others say so, as these may be momentum that is kept.
    """
    low = {word.lower() for word in words}
    if "mass" in low and low & {"centre", "center"}:
        return True
    return bool(low & {"com", "cm"} and low & _OF_MOTION)


def _is_name(words: Sequence[str], place: int) -> bool:
    """Whether a small letter stands for a body: ``speed of a``."""
    before = words[place - 1].lower() if place else ""
    return before in ("of", "for", "sphere", "ball", "particle", "on", "towards") and (
        place + 1 == len(words) or words[place + 1].lower() not in BODY_WORDS
    )


def _is_pair_of(word: str, spheres: set[str]) -> bool:
    return len(word) == 2 and word[0] in spheres and word[1] in spheres


def _is_own_angle(words: Sequence[str], place: int, previous: str) -> bool:
    """Whether the angle that words name is that of the wall behind: ``angle of the wall``."""
    between = {word.lower() for word in words[max(0, place - 2) : place]}
    return HEADS.get(previous) == "angle" and "of" in between


def _is_axis(words: Sequence[str], place: int) -> bool:
    return words[place] in ("i", "j") or len(words) > 1


def _is_filler(words: Sequence[str], place: int) -> bool:
    """Whether ``direction`` only goes with what stands beside it: ``in the direction of i``."""
    around = {word.lower() for word in words[max(0, place - 2) : place]}
    return bool(around & {"in", "x", "y", "i", "j", "the", "this", "that"})


def _counts_events(words: Sequence[str], place: int) -> bool:
    if place and words[place - 1].lower() in ("after", "before", "at"):
        return True
    return any(word.lower() in EVENT_WORDS for word in words[place + 1 : place + 3])


def _with_name(features: Features, name: str, previous: str) -> Features:
    if previous in ("towards", "toward", "from", "away"):
        return replace(features, target=name)
    if previous in ("along", "parallel", "perp", "perpendicular", "to", "at", "wall", "with", "on"):
        return replace(features, names=(*features.names, name), target=features.target or name)
    return replace(features, names=(*features.names, name))


def _with_direction(features: Features, word: str) -> Features:
    if word in ("horizontal", "vertical"):
        return replace(features, axis=AXES[word])
    if word in _SENSES:
        return replace(features, sense=word)
    if word == "centres":
        return replace(features, direction=f"{features.direction or 'along'} centres")
    if features.direction and features.direction.endswith("centres"):
        return replace(features, direction=f"{word} centres")
    return replace(features, direction=word)
