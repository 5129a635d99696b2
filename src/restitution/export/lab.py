"""The Lab: a scene as plain data, its motion, and the question that one of its impacts makes.

A scene, in SI units, vectors as pairs of numbers::

    {"spheres": [{"name", "mass", "radius", "position", "velocity"}],
     "walls": [{"name", "start", "end", "e"}],
     "e": between spheres, "pairs": [[name, name, e]],
     "seconds": how long, "impacts": how many at most}

An impact of which a question is made, ``line`` leading from the first body into the second::

    {"spheres": [{"name", "mass", "velocity"}], "wall": name or null, "line", "e"}
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeAlias

from restitution import law
from restitution.errors import CollapseError, ImpossibleError, RestitutionError, StatementError
from restitution.export.player.data import of_motion
from restitution.expression.lexer import NAME
from restitution.language import parse, to_statement
from restitution.motion import Table, simulate
from restitution.problem import Sphere, Wall
from restitution.vector import Vector

Object: TypeAlias = dict[str, Any]

MOST_SPHERES = 60
MOST_WALLS = 40
MOST_PAIRS = 60
MOST_IMPACTS = 1000
LONGEST = 120.0
"""Seconds of a motion, at most."""

_LARGEST = 1e6
_LEAST_MASS = 1e-6
_LONGEST_NAME = 12
# What a page says was rounded on its way: by so much of itself a sphere may be smaller.
_LEEWAY = 1e-7


# --- a scene and its motion -----------------------------------------------------------------------


@dataclass(frozen=True)
class Scene:
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


def simulated(told: object) -> Object:
    """The motion of a scene for the player: ``{"motion": data, "stopped": why it ended early}``.

    Where there can be none: ``{"motion": None, "error": {"kind", "message", "bodies"}}``. Raises
    StatementError where ``told`` is no scene at all.
    """
    scene = read_scene(told)
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
        said = [name for name in names if re.search(rf"\b{name}\b", error.message)]
        told_of = {"kind": error.kind, "message": error.message, "bodies": said}
        return {"motion": None, "error": told_of}
    (motion,) = of_motion(run.motion())["motions"]
    return {"motion": motion, "stopped": stopped}


def _with_room(scene: Scene) -> Table:
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


def read_scene(told: object) -> Scene:
    """A scene from plain data; raises StatementError that names what is wrong."""
    scene = _object(told, "a scene")
    spheres = _list(scene.get("spheres", []), "spheres", MOST_SPHERES)
    walls = _list(scene.get("walls", []), "walls", MOST_WALLS)
    pairs = _list(scene.get("pairs", []), "pairs", MOST_PAIRS)
    if not spheres:
        raise StatementError("there is no sphere on the table")
    coefficients: dict[str | tuple[str, str], float] = {}
    read_walls = []
    for each in walls:
        wall = _object(each, "a wall")
        name = _name(wall, "a wall")
        start, end = (_pair(wall.get(key), f"the {key} of {name}") for key in ("start", "end"))
        read_walls.append(Wall(name, start=start, end=end))
        coefficients[name] = _number(wall.get("e", 1), f"e of {name}")
    for each in pairs:
        if not isinstance(each, Sequence) or len(each) != 3:
            raise StatementError("e of a pair is told as two names and a number")
        first, second, e = each
        if not isinstance(first, str) or not isinstance(second, str):
            raise StatementError("e of a pair is told as two names and a number")
        coefficients[first, second] = _number(e, f"e of {first} and {second}")
    seconds = _number(scene.get("seconds", 10), "the duration")
    if not 0 < seconds <= LONGEST:
        raise StatementError(f"the duration is {seconds:g} s: it is positive, up to {LONGEST:g} s")
    impacts = scene.get("impacts", MOST_IMPACTS)
    if not isinstance(impacts, int) or isinstance(impacts, bool) or impacts < 0:
        raise StatementError("the number of impacts is a whole number")
    return Scene(
        tuple(map(_sphere, spheres)),
        tuple(read_walls),
        _number(scene.get("e", 1), "e between spheres"),
        coefficients,
        seconds,
        min(impacts, MOST_IMPACTS),
    )


def _sphere(told: object) -> Sphere:
    sphere = _object(told, "a sphere")
    name = _name(sphere, "a sphere")
    return Sphere(
        name,
        mass=_number(sphere.get("mass"), f"the mass of {name}"),
        radius=_number(sphere.get("radius"), f"the radius of {name}"),
        position=_pair(sphere.get("position"), f"the position of {name}"),
        velocity=_pair(sphere.get("velocity"), f"the velocity of {name}"),
    )


def _object(told: object, what: str) -> Mapping[str, Any]:
    if not isinstance(told, Mapping):
        raise StatementError(f"{what} is told as an object with its properties by name")
    return told


def _list(told: object, what: str, most: int) -> Sequence[Any]:
    if not isinstance(told, list):
        raise StatementError(f"the {what} are a list")
    if len(told) > most:
        raise StatementError(f"there are {len(told)} {what}: {most} are the most that are taken")
    return told


def _name(told: Mapping[str, Any], what: str) -> str:
    name = told.get("name")
    if not isinstance(name, str) or len(name) > _LONGEST_NAME or not NAME.fullmatch(name):
        raise StatementError(
            f"{what} is named by a capital and then letters or digits, {_LONGEST_NAME} at most"
        )
    return name


def _number(told: object, what: str) -> float:
    if isinstance(told, bool) or not isinstance(told, int | float):
        raise StatementError(f"{what} is a number")
    if not abs(told) <= _LARGEST:
        raise StatementError(f"{what} is out of bounds: numbers go up to {_LARGEST:g}")
    return float(told)


def _pair(told: object, what: str) -> tuple[float, float]:
    if not isinstance(told, list | tuple) or len(told) != 2:
        raise StatementError(f"{what} is a pair of numbers")
    return _number(told[0], what), _number(told[1], what)


# --- a question of an impact ----------------------------------------------------------------------

# Directions that people like to reckon with: whole numbers, no larger than this.
_WHOLE = 12
# Within so many radians of one of them a line of centres is taken to be along it, the tidier the
# better, while by its answers the impact is still recognized: velocities differ by no more than
# this share of the greatest.
_NEAR = (math.radians(1.5), math.radians(0.5), 0.0)
_ALIKE = 0.01
# Places after the point, at most: what is smaller is nothing.
_PLACES = 12


@dataclass(frozen=True)
class _Hit:
    """One impact in rounded, exact numbers; for a wall the second sphere is missing."""

    names: tuple[str, ...]
    masses: tuple[Fraction, ...]
    velocities: tuple[Vector, ...]
    wall: str | None
    line: Vector
    e: Fraction


def question(told: object) -> str:
    """The statement of a question about one impact, its numbers rounded to be reckoned with.

    Raises StatementError where ``told`` is no impact, and ImpossibleError where its bodies do not
    approach one another.
    """
    impact = _object(told, "an impact")
    true = _rounded(impact, _PLACES, None)
    for figures, near in (*((3, each) for each in _NEAR), (3, None), (6, None), (12, None)):
        hit = _rounded(impact, figures, near)
        if _approach(hit) > 0 and _alike(hit, true):
            return to_statement(parse("\n".join(_lines(hit))))
    raise ImpossibleError("the bodies of this impact hardly approach one another")


def _alike(hit: _Hit, true: _Hit) -> bool:
    """Whether the velocities after both impacts are the same, but for what rounding does."""
    after = dict(zip(true.names, _after(true)))
    fastest = max(math.hypot(*velocity) for velocity in true.velocities)
    return all(
        math.hypot(*(velocity - after[name])) <= _ALIKE * fastest
        for name, velocity in zip(hit.names, _after(hit))
    )


def _rounded(impact: Mapping[str, Any], figures: int, near: float | None) -> _Hit:
    """An impact rounded to so many figures, its line of centres to a tidy one ``near`` to it."""
    spheres = [_object(each, "a sphere") for each in _list(impact.get("spheres"), "spheres", 2)]
    wall = impact.get("wall")
    if wall is not None:
        wall = _name({"name": wall}, "a wall")
    names = tuple(_name(each, "a sphere") for each in spheres)
    if len(names) != (1 if wall else 2) or len({*names, wall}) < 2:
        raise StatementError("an impact is that of two spheres, or of one and a wall")
    masses = [_number(s.get("mass"), f"the mass of {n}") for n, s in zip(names, spheres)]
    for name, mass in zip(names, masses):
        if mass < _LEAST_MASS:
            raise ImpossibleError(f"the mass of {name} is {mass:g}: a mass is positive")
    told = [_pair(s.get("velocity"), f"the velocity of {n}") for n, s in zip(names, spheres)]
    # What is rounded is rounded by the fastest: to the last digit that counts beside it.
    largest = max(abs(x) for pair in told for x in pair)
    velocities = [Vector(*(_near(x, largest, figures) for x in pair)) for pair in told]
    x, y = _pair(impact.get("line"), "the line of centres")
    if x == y == 0:
        raise StatementError("the line of centres has a direction")
    e = _number(impact.get("e"), "e")
    if not 0 <= e <= 1:
        raise ImpossibleError(f"e is {e:g}: a coefficient of restitution lies in [0, 1]")
    size = math.hypot(x, y)
    if near is None:
        line = Vector(*(_near(c / size, 1.0, figures) for c in (x, y)))
    else:
        line = _tidy(x, y, near)
    simple = tuple(_simple(mass) for mass in masses)
    if wall is None and velocities[0].dot(line) <= 0:
        # The second catches up with the first: it is the one that hits.
        names, simple, velocities, line = names[::-1], simple[::-1], velocities[::-1], -line
    return _Hit(names, simple, tuple(velocities), wall, line, _simple(e, 0.1))


def _near(x: float, largest: float, figures: int) -> Fraction:
    """A number, to as many figures as the largest beside it is given."""
    if largest == 0:
        return Fraction(0)
    digits = min(figures - 1 - math.floor(math.log10(largest)), _PLACES)
    return round(Fraction(x) * Fraction(10) ** digits) / Fraction(10) ** digits


def _simple(x: float, least: float = 0.0) -> Fraction:
    """A number to 3 figures, or a fraction such as 2/3 that is meant by more.

    One that is less than ``least`` has as many places as that.
    """
    short = _near(x, max(abs(x), least), 3)
    if abs(float(short) - x) > 1e-9 * abs(x):
        fraction = Fraction(x).limit_denominator(12)
        if fraction and abs(float(fraction) - x) < 1e-6 * abs(x):
            return fraction
    return short


def _tidy(x: float, y: float, within: float) -> Vector:
    """A vector of small whole numbers nearly along another one, if there is one; else the best."""
    turn = math.atan2(y, x)

    def off(v: tuple[int, int]) -> float:
        return abs(math.remainder(math.atan2(v[1], v[0]) - turn, math.tau))

    # Those with a whole length come first, then the shorter ones.
    near = [v for v in _whole_vectors() if off(v) < within]
    if near:
        best = min(near, key=lambda v: (not math.hypot(*v).is_integer(), math.hypot(*v), off(v)))
    else:
        best = min(_whole_vectors(), key=off)
    return Vector(Fraction(best[0]), Fraction(best[1]))


def _whole_vectors() -> Iterator[tuple[int, int]]:
    sizes = range(-_WHOLE, _WHOLE + 1)
    return ((p, q) for p in sizes for q in sizes if math.gcd(p, q) == 1)


def _approach(hit: _Hit) -> Fraction:
    """How fast the bodies approach along the line of centres, but for its length."""
    other = hit.velocities[1] if hit.wall is None else Vector(Fraction(0), Fraction(0))
    fast: Fraction = (hit.velocities[0] - other).dot(hit.line)
    return fast


def _lines(hit: _Hit) -> Iterator[str]:
    first = hit.names[0]
    second = hit.wall or hit.names[1]
    yield f"title {first} hits {second}"
    for name, mass, velocity in zip(hit.names, hit.masses, hit.velocities):
        moves = f"velocity {_vector(velocity)}" if velocity != _REST else "at rest"
        yield f"sphere {name}: mass {_written(mass)}, {moves}"
    if hit.wall:
        yield f"wall {hit.wall}: along {_vector(_positive(hit.line.turned_left()))}"
        yield f"{first} hits {second}: e = {_written(hit.e)}"
    else:
        yield f"{first} hits {second}: along {_vector(_positive(hit.line))}, e = {_written(hit.e)}"
    yield "find " + ", ".join(_asked(hit))


def _asked(hit: _Hit) -> Iterator[str]:
    after = _after(hit)
    yield from (f"velocity({name})" for name in hit.names)
    yield "impulse"
    for name, u, v in zip(hit.names, hit.velocities, after):
        if _REST not in (u, v):  # else there is no direction, before or after
            yield f"deflection({name})"
    yield "energy_lost"


def _after(hit: _Hit) -> tuple[Vector, ...]:
    """The velocities just after, by the law."""
    weights = [1 / mass for mass in hit.masses] + [Fraction(0)]
    both = [*hit.velocities, _REST]
    impulse = law.impulse(both[0], both[1], weights[0], weights[1], hit.line, hit.e)
    found = law.after_impulse(both[0], both[1], weights[0], weights[1], impulse)
    return tuple(found[: len(hit.names)])


_REST = Vector(Fraction(0), Fraction(0))


def _positive(v: Vector) -> Vector:
    """A direction, in the one of its senses that is written with fewer signs."""
    return -v if v.x < 0 or (v.x == 0 and v.y < 0) else v


def _written(x: Fraction) -> str:
    """A number as people write it: a decimal if it ends soon, else a fraction."""
    rest = x.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    if rest > 1:
        return f"{x.numerator}/{x.denominator}"
    places = 0
    while (x * 10**places).denominator > 1:
        places += 1
    return f"{float(x):.{places}f}"


def _vector(v: Vector) -> str:
    """A vector in components, as people write it."""
    told = ""
    for x, unit in ((v.x, "i"), (v.y, "j")):
        if x == 0:
            continue
        size = "" if abs(x) == 1 else _written(abs(x))
        sign = ("-" if x < 0 else "") if not told else (" - " if x < 0 else " + ")
        told += f"{sign}{size}{unit}"
    return told
