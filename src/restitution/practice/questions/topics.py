"""The topics of practice, in the order in which they are taught, and what each asks."""

from __future__ import annotations

from typing import Literal

from restitution.errors import StatementError
from restitution.records import dataclass

LEVELS = (1, 2, 3, 4)

Group = Literal[
    "One wall", "Two walls", "Two spheres", "Line of centres to be found", "Given facts", "Ranges"
]


@dataclass(frozen=True)
class Topic:
    """A topic: its id in commands and addresses, its title, and what its questions ask."""

    id: str
    title: str
    asks: str
    group: Group


TOPICS = (
    Topic(
        "wall-forward",
        "Velocity after an impact with a wall",
        "the velocity, or speed and direction, afterwards",
        "One wall",
    ),
    Topic(
        "wall-coefficient",
        "Coefficient of restitution at a wall",
        "the coefficient of restitution between a sphere and a wall",
        "One wall",
    ),
    Topic(
        "wall-angle",
        "Angles to a wall",
        "the angle between the path and the wall, before or after",
        "One wall",
    ),
    Topic(
        "wall-deflection",
        "Angle of deflection at a wall",
        "the angle through which a wall turns the path",
        "One wall",
    ),
    Topic(
        "wall-impulse",
        "Impulse at a wall",
        "the impulse from a wall, or what follows from it",
        "One wall",
    ),
    Topic(
        "wall-energy",
        "Kinetic energy lost at a wall",
        "the kinetic energy lost at a wall, or what follows from it",
        "One wall",
    ),
    Topic(
        "walls-at-90",
        "Two walls at right angles",
        "two perpendicular walls, one after the other",
        "Two walls",
    ),
    Topic(
        "walls-at-60",
        "Two walls at 60°",
        "impacts with two walls at 60°, one after the other",
        "Two walls",
    ),
    Topic(
        "walls-at-120",
        "Two walls at 120°",
        "impacts with two walls at 120°, one after the other",
        "Two walls",
    ),
    Topic(
        "walls-parallel",
        "Two parallel walls",
        "impacts to and fro between two parallel walls",
        "Two walls",
    ),
    Topic(
        "sphere-at-rest",
        "A sphere strikes one at rest",
        "the collision of a moving sphere with one at rest",
        "Two spheres",
    ),
    Topic(
        "spheres-moving",
        "Two moving spheres, by speeds and angles",
        "a collision of spheres with given speeds and angles",
        "Two spheres",
    ),
    Topic(
        "spheres-vectors",
        "Two moving spheres, with vectors",
        "a collision of spheres with velocities as vectors",
        "Two spheres",
    ),
    Topic(
        "spheres-letters",
        "Two spheres, in letters",
        "a collision with masses and speeds in letters",
        "Two spheres",
    ),
    Topic(
        "wall-then-sphere",
        "A wall and a sphere",
        "an impact with a wall, and a collision",
        "Two spheres",
    ),
    Topic(
        "line-of-centres",
        "Line of centres to be found",
        "the line of centres, from velocities or places",
        "Line of centres to be found",
    ),
    Topic(
        "right-angles",
        "At right angles afterwards",
        "what follows from directions at right angles",
        "Given facts",
    ),
    Topic(
        "energy-given",
        "Loss of kinetic energy given",
        "what follows from the kinetic energy lost in a collision",
        "Given facts",
    ),
    Topic(
        "at-rest-afterwards",
        "Stopped along the line of centres",
        "what follows where a component is taken away",
        "Given facts",
    ),
    Topic("ranges", "Ranges of values", "all values that a quantity may have", "Ranges"),
)

_BY_ID = {topic.id: topic for topic in TOPICS}


def topic(name: str) -> Topic:
    """The topic with an id. Raises StatementError, which names the nearest, for any other text."""
    if name in _BY_ID:
        return _BY_ID[name]
    from difflib import get_close_matches

    near = get_close_matches(name[:100], _BY_ID, 1, 0.5)
    hint = f"did you mean {near[0]}?" if near else "restitution practise --topics lists them"
    raise StatementError(f"there is no topic {name[:100]!r}: {hint}")
