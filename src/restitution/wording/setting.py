"""What stands on the plane before anything happens: spheres, walls, points, first velocities."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import sympy

from restitution.errors import RestitutionError
from restitution.expression.dimensions import MASS, SPEED
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Expression, Name, Negate, Polar, is_rest
from restitution.problem import Problem, Sphere, Wall
from restitution.shapes import Circle, Line, Segment
from restitution.vector import Vector
from restitution.wording import values
from restitution.wording.scene import Scene, before, wall_before
from restitution.wording.structure import Emphasis, Sentence, Words
from restitution.wording.words import count, listed, names, sentence, words

_PLANE = "on a smooth horizontal plane"


def setting(scene: Scene) -> Iterator[Sentence]:
    """The bodies; where the spheres are and how they move at first tells ``start``."""
    yield from spheres(scene)
    if scene.problem.points:
        yield _points(scene)
    yield from _walls(scene)


# --- spheres --------------------------------------------------------------------------------------


def spheres(scene: Scene) -> Iterator[Sentence]:
    """The sentences that introduce the spheres."""
    spheres = scene.problem.spheres
    if not spheres:
        return
    small = "small " if scene.places and all(sphere.radius is None for sphere in spheres) else ""
    if len(spheres) == 1:
        (only,) = spheres
        of = [words("mass ", _mass(scene, only))] if only.mass is not None else []
        if only.radius is not None:
            of.append(words("radius ", values.length(scene.style, only.radius)))
        radius = words(", of ", listed(of), ",") if of else ""
        yield sentence(
            f"a {small}smooth uniform sphere ", Emphasis(only.name), radius, f" moves {_PLANE}"
        )
        return
    yield from _several(scene, spheres, small)


def _several(scene: Scene, spheres: tuple[Sphere, ...], small: str) -> Iterator[Sentence]:
    kind = f"{count(len(spheres))} {small}smooth uniform spheres"
    masses = [sphere.mass for sphere in spheres]
    radii = {sphere.radius for sphere in spheres if sphere.radius is not None}
    radius: Any = radii.pop() if len(radii) == 1 else None
    equal = words(" have equal radii")
    if radius is not None:
        equal = words(" each have radius ", values.length(scene.style, radius))
    rest = f" and move {_PLANE}"
    all_given = all(mass is not None for mass in masses)
    if all_given and len(set(masses)) == 1:
        phrase = words(kind, " ", names(s.name for s in spheres), ", each of mass ")
        mass = _mass(scene, spheres[0])
        if radius is not None:
            size = words(" and radius ", values.length(scene.style, radius))
            yield sentence(phrase, mass, size, f", move {_PLANE}")
        else:
            yield sentence(phrase, mass, ",", equal, rest)
    elif all_given:
        yield sentence(kind, ", ", _masses(scene, spheres), ",", equal, rest)
    else:
        yield sentence(kind, " ", names(sphere.name for sphere in spheres), equal, rest)
        for group in _by_mass(spheres):
            if group[0].mass is not None:
                verb = " has mass " if len(group) == 1 else " each have mass "
                yield sentence(names(s.name for s in group), verb, _mass(scene, group[0]))
    if radii:
        for sphere in spheres:
            if sphere.radius is not None:
                phrase = values.length(scene.style, sphere.radius)
                yield sentence("the radius of ", Emphasis(sphere.name), " is ", phrase)


def _by_mass(spheres: tuple[Sphere, ...]) -> list[list[Sphere]]:
    """The spheres in groups of one mass."""
    groups: dict[Any, list[Sphere]] = {}
    for sphere in spheres:
        groups.setdefault(sphere.mass, []).append(sphere)
    return list(groups.values())


def _masses(scene: Scene, spheres: tuple[Sphere, ...]) -> Words:
    """``A of mass 2 kg and B of mass 3 kg``, ``A and B each of mass m, and C of mass km``."""
    phrases = [
        words(
            names(sphere.name for sphere in group),
            " of mass " if len(group) == 1 else " each of mass ",
            _mass(scene, group[0]),
        )
        for group in _by_mass(spheres)
    ]
    return listed(phrases, "and" if len(phrases) == len(spheres) else ", and")


def _mass(scene: Scene, sphere: Sphere) -> Words:
    return values.value(scene.style, sphere.mass, MASS)


# --- walls and points -----------------------------------------------------------------------------


def _walls(scene: Scene) -> Iterator[Sentence]:
    walls = scene.problem.walls
    if len(walls) > 1 and all(_plain(wall) for wall in walls):
        kind = " are fixed smooth vertical walls"
        all_names = names(wall.name for wall in walls)
        if _alike(walls):
            yield sentence(all_names, kind, " ", values.lies_along(scene.style, walls[0].along))
        else:
            directions = [
                words(Emphasis(w.name), " is ", values.lies_along(scene.style, w.along))
                for w in walls
            ]
            yield sentence(all_names, kind)
            yield sentence(listed(directions))
        return
    for wall in walls:
        kind, name = "a fixed smooth vertical wall ", Emphasis(wall.name)
        match wall.shape:
            case Circle(centre, radius):
                kind = "a fixed smooth vertical circular wall "
                size = values.length(scene.style, radius)
                yield sentence(
                    kind, name, " has its centre at ", values.point(centre), " and radius ", size
                )
            case Segment(start, end):
                ends = words(" runs from ", values.spot(start), " to ", values.spot(end))
                yield sentence(kind, name, ends)
            case Line(along, through) if (
                along is not None and scene.oriented
            ) or through is not None:
                yield sentence(kind, name, " ", _is(scene, wall))
            case Line():
                yield sentence(kind, name, " stands on the plane")


def _plain(wall: Wall) -> bool:
    return wall.along is not None and wall.through is None


def _alike(walls: tuple[Wall, ...]) -> bool:
    return len({wall.along for wall in walls}) == 1 and values.is_vector(walls[0].along)


def _is(scene: Scene, wall: Wall) -> Words:
    phrases: list[Words] = []
    if wall.along is not None:
        phrases.append(words("is ", values.lies_along(scene.style, wall.along)))
    if wall.through is not None:
        phrases.append(words("passes through ", values.point(wall.through)))
    return listed(phrases)


def _points(scene: Scene) -> Sentence:
    return sentence(
        listed(
            [
                words(Emphasis(point.name), " is ", values.point(point.position))
                for point in scene.problem.points
            ]
        )
    )


# --- where they are and how they move -------------------------------------------------------------


def start(scene: Scene) -> Iterator[Sentence]:
    """Where the spheres are at first, and how they move."""
    phrases: list[Words] = []
    resting: list[str] = []
    for sphere in scene.problem.spheres:
        if is_rest(sphere.velocity) and sphere.position is None:
            resting.append(sphere.name)
        elif sphere.velocity is not None or sphere.position is not None:
            phrases.append(_state(scene, sphere))
    if resting:
        verb = " is at rest" if len(resting) == 1 else " are at rest"
        phrases.append(words(names(resting), verb))
    if not phrases:
        return
    moment = words(before(scene), " ")
    if len(phrases) <= 2:
        broken = any(isinstance(one, str) and ", " in one for one in words(phrases[0]))
        yield sentence(moment, listed(phrases, ", and" if broken else "and"))
        return
    *front, last = phrases
    out: list[Any] = []
    for phrase in front:
        out += [phrase, "; "]
    yield sentence(moment, *out, "and ", last)


def _state(scene: Scene, sphere: Sphere) -> Words:
    name = Emphasis(sphere.name)
    rest = is_rest(sphere.velocity)
    if sphere.position is None:
        return words(name, " is ", moving(scene, sphere.velocity))
    centre = words("the centre of ", name) if sphere.radius is not None else (name,)
    where = words("at ", values.point(sphere.position), _side(scene, sphere))
    if sphere.velocity is None:
        return words(centre, " is ", where)
    if rest:
        if sphere.radius is None:
            return words(name, " is at rest ", where)
        return words(name, " is at rest with its centre ", where)
    then = " " if where[-1] == "," or str(where[-1]).endswith(",") else ", "
    if sphere.radius is not None:
        return words(name, " has its centre ", where, then, moving(scene, sphere.velocity))
    return words(name, " is ", where, then, moving(scene, sphere.velocity))


def moving(scene: Scene, velocity: Expression) -> Words:
    """``moving with velocity (3i − 4j) m s⁻¹``, ``moving with speed u towards W …``."""
    if isinstance(velocity, Polar):
        speed = values.value(scene.style, velocity.size, SPEED)
        return words("moving with speed ", speed, " ", course(scene, velocity))
    return words("moving with velocity ", values.value(scene.style, velocity, SPEED))


def course(scene: Scene, velocity: Polar) -> Words:
    """The direction of a vector by size and direction; towards a wall, with its sense."""
    name = wall_before(scene, velocity)
    if name is not None:
        return values.towards(scene.style, name, velocity.angle)
    if not isinstance(velocity.wall, Name):
        return values.direction(scene.style, velocity)
    wall = scene.wall(velocity.wall.name)
    match wall.shape if wall is not None else None:
        case Line(along) if along is not None and values.is_vector(along):
            turned = Polar(velocity.size, Negate(velocity.angle), along)
            return words("towards ", Emphasis(velocity.wall.name), " ", course(scene, turned))
    return words(values.direction(scene.style, velocity), _sense(scene, velocity.wall.name))


def _sense(scene: Scene, name: str) -> Words:
    """From which side a sphere comes to a wall, where that matters."""
    wall = scene.wall(name)
    if wall is None or not scene.oriented:
        return ()
    match wall.shape:
        case Line(along) if along is not None:
            return words(", measured clockwise from ", values.direction_of(scene.style, along))
        case Segment(start, end):
            ends = words(values.spot(start), " to ", values.spot(end))
            return words(", measured clockwise from the direction from ", ends)
    return ()


def _side(scene: Scene, sphere: Sphere) -> Words:
    """Inside or outside a circular wall, where it is known."""
    sides = [
        words(f"{side} ", Emphasis(wall.name))
        for wall in scene.problem.walls
        if (side := _which_side(scene.problem, sphere, wall))
    ]
    return words(", ", listed(sides), ",") if sides else ()


def _which_side(problem: Problem, sphere: Sphere, wall: Wall) -> str:
    """On which side of a circle a sphere starts; nothing where letters leave it open."""
    centre, place = locus(problem, wall.centre), locus(problem, sphere.position)
    radius = exact(wall.radius)
    if centre is None or place is None or radius is None:
        return ""
    apart = place - centre
    excess = sympy.expand(apart.x**2 + apart.y**2 - radius**2)
    if excess.is_zero:
        return "on the inside of"
    return "outside" if excess.is_positive else "inside" if excess.is_negative else ""


def locus(problem: Problem, tree: Any) -> Vector | None:
    """The coordinates of a point, given or named."""
    if isinstance(tree, Name):
        tree = next((point.position for point in problem.points if point.name == tree.name), None)
    place = exact(tree)
    return place if isinstance(place, Vector) else None


def exact(tree: Any) -> Any:
    """The exact value of an expression of letters, all of them positive; None if it has none."""
    if not isinstance(tree, Expression):
        return None
    with suppress(RestitutionError):
        return in_letters(tree, positive=True)
    return None
