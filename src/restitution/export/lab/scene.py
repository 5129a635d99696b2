"""A scene of the Lab as plain data, and its motion.

A scene, in SI units, vectors as pairs of numbers::

    {"spheres": [{"name", "mass", "radius", "position", "velocity"}],
     "walls": [{"name", "start", "end", "e"}],
     "e": between spheres, "pairs": [[name, name, e]],
     "seconds": how long, "impacts": how many at most}
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from restitution.errors import CollapseError, ImpossibleError, RestitutionError, StatementError
from restitution.export.lab.reading import a_list, a_name, a_number, a_pair, an_object
from restitution.export.player.data import of_motion
from restitution.motion import Table, simulate
from restitution.problem import Sphere, Wall
from restitution.records import dataclass

Object = dict[str, Any]

MOST_SPHERES = 60
MOST_WALLS = 40
MOST_PAIRS = 60
MOST_IMPACTS = 1000
LONGEST = 120.0
"""Seconds of a motion, at most."""

# What a page says was rounded on its way: by so much of itself a sphere may be smaller.
_LEEWAY = 1e-7


@dataclass(frozen=True)
class LabScene:
    """What is on the table, how the spheres start, and for how long they are followed."""

    spheres: tuple[Sphere, ...]
    walls: tuple[Wall, ...]
    e: float
    coefficients: Mapping[str | tuple[str, str], float]
    seconds: float
    impacts: int

    def table(self) -> Table:
        """The table, for a simulation; raises as it does."""
        return Table(self.spheres, self.walls, self.e, self.coefficients)


def simulated(data: object) -> Object:
    """The motion of a scene for the player: ``{"motion": data, "stopped": why it ended early}``.

    Where there can be none: ``{"motion": None, "error": {"kind", "message", "bodies"}}``. Raises
    StatementError where ``told`` is no scene at all.
    """
    scene = read_scene(data)
    names = [*(ball.name for ball in scene.spheres), *(wall.name for wall in scene.walls)]
    try:
        table = _with_room(scene)
        run, stopped = simulate(table, until=scene.seconds, impacts=scene.impacts), None
        if len(run.impacts) == scene.impacts and run.end < scene.seconds:
            stopped = f"followed for {scene.impacts} impacts, until {run.end:.3g} s"
    except CollapseError as error:
        run = error.run
        stopped = (
            f"from {float(run.end):.3g} s on impacts follow one another without end and in no time "
            "(inelastic collapse): the motion is shown until then"
        )
    except RestitutionError as error:
        bodies = [name for name in names if re.search(rf"\b{name}\b", error.message)]
        refusal = {"kind": error.kind, "message": error.message, "bodies": bodies}
        return {"motion": None, "error": refusal}
    (motion,) = of_motion(run.motion())["motions"]
    return {"motion": motion, "stopped": stopped}


def _with_room(scene: LabScene) -> Table:
    """The table; bodies that overlap by no more than rounding are given room."""
    try:
        return scene.table()
    except ImpossibleError:
        try:
            smaller = tuple(
                replace(sphere, radius=sphere.radius * (1 - _LEEWAY)) for sphere in scene.spheres
            )
            return replace(scene, spheres=smaller).table()
        except ImpossibleError:
            pass
        raise


def read_scene(data: object) -> LabScene:
    """A scene from plain data; raises StatementError that names what is wrong."""
    scene = an_object(data, "a scene")
    spheres = a_list(scene.get("spheres", []), "spheres", MOST_SPHERES)
    walls = a_list(scene.get("walls", []), "walls", MOST_WALLS)
    pairs = a_list(scene.get("pairs", []), "pairs", MOST_PAIRS)
    if not spheres:
        raise StatementError("there is no sphere on the table")
    coefficients: dict[str | tuple[str, str], float] = {}
    read_walls = []
    for other in walls:
        wall = an_object(other, "a wall")
        name = a_name(wall, "a wall")
        start, end = (a_pair(wall.get(key), f"the {key} of {name}") for key in ("start", "end"))
        read_walls.append(Wall(name, start=start, end=end))
        coefficients[name] = a_number(wall.get("e", 1), f"e of {name}")
    for pair in pairs:
        first, second, e = _pair_of_bodies(pair)
        coefficients[first, second] = a_number(e, f"e of {first} and {second}")
    seconds = a_number(scene.get("seconds", 10), "the duration")
    if not 0 < seconds <= LONGEST:
        raise StatementError(f"the duration is {seconds:g} s: it is positive, up to {LONGEST:g} s")
    impacts = scene.get("impacts", MOST_IMPACTS)
    if not isinstance(impacts, int) or isinstance(impacts, bool) or impacts < 0:
        raise StatementError("the number of impacts is a whole number")
    return LabScene(
        tuple(map(_sphere, spheres)),
        tuple(read_walls),
        a_number(scene.get("e", 1), "e between spheres"),
        coefficients,
        seconds,
        min(impacts, MOST_IMPACTS),
    )


def _pair_of_bodies(data: object) -> tuple[str, str, object]:
    match data:
        case [str(first), str(second), e]:
            return first, second, e
    raise StatementError("e of a pair is told as two names and a number")


def _sphere(data: object) -> Sphere:
    sphere = an_object(data, "a sphere")
    name = a_name(sphere, "a sphere")
    return Sphere(
        name,
        mass=a_number(sphere.get("mass"), f"the mass of {name}"),
        radius=a_number(sphere.get("radius"), f"the radius of {name}"),
        position=a_pair(sphere.get("position"), f"the position of {name}"),
        velocity=a_pair(sphere.get("velocity"), f"the velocity of {name}"),
    )
