"""Times in a world with other velocities than the true ones, for the same places of contact.

A wall is struck where it stands, two spheres meet as far from each other as they do in truth, and
a point is reached where it is. So a later event comes when a sphere has gone as far as it has to.
"""

from __future__ import annotations

import numpy as np

from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.telling import Telling
from restitution.practice.worlds.world import World
from restitution.problem import Impact, Kick
from restitution.shapes import Circle
from restitution.vector import Vector


def retimed(world: World, true: World) -> World:
    """A world with the times of its events by its own velocities.

    ``true`` is the world, of as many samples, from which it was altered: it has the places of the
    contacts. Times of which nothing is known, and those of blows, stay as they are.
    """
    with np.errstate(all="ignore"):
        for number, step in enumerate(world.events, 1):
            if true.times.get(number) is None or isinstance(step, Kick):
                continue
            time = _time(world, true, number)
            if time is not None:
                world = world.replaced(times={number: time})
    return world


def _time(world: World, true: World, number: int) -> Array | None:
    """When an event comes; None where it cannot be told from places."""
    step = world.events[number - 1]
    telling, truth = Telling(world, degrees=False), Telling(true, degrees=False)
    if not isinstance(step, Impact):
        reached = truth.place(step.body, number)
        moved = _last(telling, step.body, number)
        if reached is None or moved is None:
            return None
        (where, when), velocity = moved
        return when + (reached[0] - where).dot(velocity) / velocity.dot(velocity)
    line = true.lines[number]
    wall = telling.walls.get(step.second)
    if wall is not None and isinstance(wall.shape, Circle):
        return None
    # Along the line of centres, from the first body: where it is, and where it has to be.
    bodies = [step.first] if wall is not None else [step.first, step.second]
    here, speed, wanted = _no_array(), _no_array(), _no_array()
    for name, sign in zip(bodies, (1, -1), strict=False):
        place, moved = truth.place(name, number), _last(telling, name, number)
        if place is None or moved is None:
            return None
        (where, when), velocity = moved
        here = here + sign * (where - velocity * when).dot(line)
        speed = speed + sign * velocity.dot(line)
        wanted = wanted + sign * place[0].dot(line)
    return (wanted - here) / speed


def _no_array() -> Array:
    return np.float64(0)


def _last(telling: Telling, name: str, number: int) -> tuple[tuple[Vector, Array], Vector] | None:
    """Where a sphere was before an event, since when, and its velocity there."""
    known = telling.place(name, number - 1)
    return None if known is None else (known, telling.velocity(name, number - 1))
