"""Which mistakes can be made in questions of a topic at a level."""

from __future__ import annotations

from functools import cache

from restitution.explaining.mistakes.consequences import can_be_made
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.language import parse
from restitution.practice.questions.dice import Dice
from restitution.practice.questions.recipes import RECIPES
from restitution.practice.questions.topics import LEVELS, TOPICS

_DRAWS = 8  # of each recipe, which does not ask the same in all of them


@cache
def shows(mistake: str, topic: str, level: int) -> bool:
    """Whether a mistake, by its id, can be made in some question of a topic at a level."""
    return bool(MISCONCEPTIONS[mistake].variants) and any(
        can_be_made(mistake, parse(recipe(Dice(f"mistakes/{topic}/{level}/{number}"))))
        for number in range(_DRAWS)
        for recipe in RECIPES[topic, level]
    )


def topic_that_shows(mistake: str, topic: str, level: int) -> str:
    """A topic, or the first in which a mistake can be made at that level where it cannot there.

    Where it can in none, the topic itself.
    """
    others = (one.id for one in TOPICS)
    return next((name for name in (topic, *others) if shows(mistake, name, level)), topic)


def why_not(mistake: str, topic: str, level: int) -> str:
    """What to say of a mistake that cannot be made there: with the topics in which it can.

    These are at the same level, or at the nearest one that has some.
    """
    for near in sorted(LEVELS, key=lambda other: abs(other - level)):
        names = [one.id for one in TOPICS if shows(mistake, one.id, near)]
        if names:
            return (
                f"{mistake} cannot be made in {topic} at level {level}: at level {near} it can in "
                f"{', '.join(names)}"
            )
    return f"{mistake} alters no law and no result: it cannot be made in a question of its own"
