"""What turns with the letters of a statement: starts, walls and lines of centres."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, TypeVar, cast

import numpy as np

from restitution.expression.tree import Expression, letters
from restitution.practice.worlds.motion import SampledMotion
from restitution.practice.worlds.telling import Telling
from restitution.problem import Impact, Wall
from restitution.shapes import Line, Segment
from restitution.vector import Vector

AnyMotion = TypeVar("AnyMotion", bound=SampledMotion)


def turned(world: AnyMotion, changed: frozenset[str], fixed: frozenset[int]) -> AnyMotion:
    """The world with starts, walls and lines of centres by its letters, some of them changed."""
    telling = Telling(world, degrees=False)
    with np.errstate(all="ignore"):
        start = {
            sphere.name: telling.read(sphere.velocity)
            for sphere in world.problem.spheres
            if _speaks_of(sphere.velocity, changed)
        }
        world = replace(world, start={**world.start, **start})
        walls = {
            wall.name: direction
            for wall in world.problem.walls
            if (direction := _wall_by_letters(world, wall, changed)) is not None
        }
        world = replace(world, walls={**world.walls, **walls})
        for number, step in enumerate(world.events, 1):
            if isinstance(step, Impact) and number not in fixed:
                line = _line_by_letters(world, number, step, changed, walls)
                if line is not None:
                    near = np.where(line.dot(world.lines[number]) < 0, -1.0, 1.0)
                    world = replace(world, lines={**world.lines, number: line * near})
    return world


def _speaks_of(tree: Any, names: frozenset[str]) -> bool:
    if isinstance(tree, tuple | list):
        return any(_speaks_of(part, names) for part in tree)
    return isinstance(tree, Expression) and not letters(tree).isdisjoint(names)


def _wall_by_letters(world: SampledMotion, wall: Wall, changed: frozenset[str]) -> Vector | None:
    telling = Telling(world, degrees=False)
    match wall.shape:
        case Line(along) if _speaks_of(along, changed):
            if isinstance(along, tuple | list):
                return cast("Vector", telling.read(along))
            return telling.direction(along, 0)
        case Segment(start, end) if _speaks_of(start, changed) or _speaks_of(end, changed):
            return cast("Vector", telling.read(end) - telling.read(start))
    return None


def _line_by_letters(
    world: SampledMotion,
    number: int,
    step: Impact,
    changed: frozenset[str],
    walls: Mapping[str, Vector],
) -> Vector | None:
    """The line of centres as the statement gives it, where it turns with its letters."""
    telling = Telling(world, degrees=False)
    if step.second in walls:
        return unit(walls[step.second].turned_left())
    if _speaks_of(step.along, changed) and step.along is not None:
        return unit(telling.direction(step.along, number - 1))
    radius = telling.radius(step.first) if step.offset is not None else None
    if radius is None or step.offset is None:
        return None
    approach = telling.velocity(step.first, number - 1) - telling.velocity(step.second, number - 1)
    d = telling.read(step.offset, number - 1)
    return unit(approach * np.sqrt(4 * radius * radius - d * d) + approach.turned_left() * d)


def unit(v: Vector) -> Vector:
    """A vector of length 1 in the direction of another."""
    length = np.hypot(v.x, v.y)
    return Vector(v.x / length, v.y / length)


def with_line_at(world: AnyMotion, number: int, change: Any) -> AnyMotion:
    """The world with a line of centres turned by an angle, in radians; velocities stay."""
    c = world.lines[number]
    cos, sin = np.cos(change), np.sin(change)
    line = Vector(c.x * cos - c.y * sin, c.x * sin + c.y * cos)
    return replace(world, lines={**world.lines, number: line})
