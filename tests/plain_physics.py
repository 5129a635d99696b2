"""Impacts worked by the textbook's principles, in numbers: what the tests judge answers by.

Statements are read by the package; nothing else of it is used here. A `World` is one statement
with a number for every letter. Numbers are mpmath's with 160 digits, so that what differs by
10⁻³⁰ is told apart. What is implemented: straight walls and segments, spheres, blows, places of
spheres that fly freely from the start. What is not raises NotImplementedError.

A world is *possible* if bodies approach before each impact, coefficients lie from 0 to 1, masses
are positive, segments are struck between their ends, and all that is given holds.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath as mp

from restitution import problem as p
from restitution.expression import tree as t
from restitution.language import parse

DIGITS = 160
mp.mp.dps = DIGITS
SAME = mp.mpf(10) ** -75  # relative
NONE = mp.mpf(10) ** -70  # what is smaller is a rounding error

Vector = tuple[Any, Any]


class ImpossibleWorldError(Exception):
    """Numbers for which the story cannot happen as it is told."""


def number(x: object) -> Any:
    if isinstance(x, Fraction):
        return mp.mpf(x.numerator) / x.denominator
    return mp.mpf(x)


def dot(a: Vector, b: Vector) -> Any:
    return a[0] * b[0] + a[1] * b[1]


def cross(a: Vector, b: Vector) -> Any:
    return a[0] * b[1] - a[1] * b[0]


def plus(a: Vector, b: Vector, times: Any = 1) -> Vector:
    return a[0] + times * b[0], a[1] + times * b[1]


def scaled(a: Vector, times: Any) -> Vector:
    return a[0] * times, a[1] * times


def left_of(a: Vector) -> Vector:
    """Turned by +90°."""
    return -a[1], a[0]


def size(a: Vector) -> Any:
    return mp.sqrt(dot(a, a))


def unit(a: Vector) -> Vector:
    length = size(a)
    if length == 0:
        raise ImpossibleWorldError("a direction without a size")
    return scaled(a, 1 / length)


def after_wall(v: Vector, along: Vector, e: Any) -> Vector:
    """The part along the wall stays; the part perpendicular to it turns round, times e."""
    tangent = unit(along)
    normal = left_of(tangent)
    return plus(scaled(tangent, dot(v, tangent)), normal, -e * dot(v, normal))


def after_spheres(
    m: Any, a: Vector, k: Any, b: Vector, normal: Vector, e: Any
) -> tuple[Vector, Vector]:
    """Momentum along the line of centres, Newton's law along it, nothing across it."""
    first, second = dot(a, normal), dot(b, normal)
    approach = first - second
    # m x + k y = m first + k second and y - x = e approach
    x = (m * first + k * second - k * e * approach) / (m + k)
    y = x + e * approach
    return plus(a, normal, x - first), plus(b, normal, y - second)


class World:
    """A statement told in numbers: the velocities of all spheres at every stage.

    Raises ImpossibleWorldError where the story cannot happen with these numbers. Facts are not
    asked here, but by `possible`.
    """

    def __init__(self, problem: p.Problem, letters: Mapping[str, Any]) -> None:
        self.problem = problem
        self.letters = dict(letters)
        self.spheres = {each.name: each for each in problem.spheres}
        self.walls = {each.name: each for each in problem.walls}
        self.points = {each.name: each for each in problem.points}
        self.stages: list[dict[str, Vector]] = [{}]
        self.events: list[Any] = []
        self.impulses: list[dict[str, Vector]] = [{}]
        self.normals: list[Vector | None] = [None]
        for name, sphere in self.spheres.items():
            if sphere.velocity is not None:
                self.stages[0][name] = self.vector(sphere.velocity, 0)
            if sphere.mass is not None and self.scalar(sphere.mass, 0) <= 0:
                raise ImpossibleWorldError(f"the mass of {name} is not positive")
        self.claims: list[tuple[p.Show, int]] = []
        self.facts: list[tuple[Any, int]] = []
        for _, step in problem.steps():
            now = len(self.events)
            if isinstance(step, p.Show):
                self.claims.append((step, now))
            elif isinstance(step, p.Given):
                self.facts += [(each, now) for each in step.relations]
            elif isinstance(step, p.Let):
                self.letters[step.letter] = self.scalar(step.expression, now)
            elif isinstance(step, p.Impact):
                self.impact(step)
            elif isinstance(step, p.Kick):
                blow = self.vector(step.impulse, now)
                new = dict(self.stages[-1])
                new[step.body] = plus(new[step.body], blow, 1 / self.mass(step.body))
                self.log(step, new, {step.body: blow}, unit(blow))
            elif not isinstance(step, p.Find | p.Unknown):
                raise NotImplementedError(type(step).__name__)

    def log(self, step: Any, stage: Any, impulses: Any, normal: Vector) -> None:
        self.events.append(step)
        self.stages.append(stage)
        self.impulses.append(impulses)
        self.normals.append(normal)

    def mass(self, name: str) -> Any:
        mass = self.spheres[name].mass
        return None if mass is None else self.scalar(mass, 0)

    def impact(self, step: p.Impact) -> None:
        now = len(self.events)
        e = self.letters["e"] if step.e is None else self.scalar(step.e, now)
        if not -NONE <= e <= 1 + NONE:
            raise ImpossibleWorldError(f"e = {e}")
        new = dict(self.stages[-1])
        v = new[step.first]
        if step.second in self.walls:
            along = unit(self.vector(t.Name(step.second), now))
            normal = left_of(along)
            if dot(v, normal) < 0:
                normal = scaled(normal, -1)
            if abs(dot(v, normal)) <= NONE:
                raise ImpossibleWorldError("the sphere moves along the wall")
            wall = self.walls[step.second]
            placed = self.spheres[step.first].position is not None
            if placed and (wall.start is not None or wall.through is not None):
                if any(step.first in (each.first, each.second) for each in self.events):
                    raise NotImplementedError("places after an impact")
                if not self.meets_wall(step.first, step.second, now):
                    raise ImpossibleWorldError("the sphere does not come to the wall")
            new[step.first] = after_wall(v, along, e)
            mass = self.mass(step.first)
            change = plus(new[step.first], v, -1)
            impulses = {} if mass is None else {step.first: scaled(change, mass)}
            self.log(step, new, impulses, normal)
            return
        w = new[step.second]
        if step.offset is not None:
            path = unit(plus(v, w, -1))
            radius = self.spheres[step.first].radius or self.spheres[step.second].radius
            share = self.scalar(step.offset, now) / (2 * self.scalar(radius, now))
            if not -1 < share < 1:
                raise ImpossibleWorldError("the spheres pass each other")
            normal = plus(scaled(path, mp.sqrt(1 - share**2)), left_of(path), share)
        elif step.along is None:
            raise NotImplementedError("a line of centres to be found")
        else:
            normal = unit(self.direction(step.along, now))
            earlier = [
                (old, each)
                for old, each in zip(self.normals[1:], self.events, strict=True)
                if {step.first, step.second}
                == {getattr(each, "first", 0), getattr(each, "second", 0)}
            ]
            if earlier:  # spheres that have met before keep their order on a line
                old, each = earlier[-1]
                old = old if each.first == step.first else scaled(old, -1)
                if dot(old, normal) < 0:
                    normal = scaled(normal, -1)
            elif dot(v, normal) < -NONE or (abs(dot(v, normal)) <= NONE and dot(w, normal) > 0):
                normal = scaled(normal, -1)
        if dot(v, normal) - dot(w, normal) <= NONE:
            raise ImpossibleWorldError("the spheres do not approach")
        m, k = self.mass(step.first), self.mass(step.second)
        new[step.first], new[step.second] = after_spheres(m, v, k, w, normal, e)
        impulse = scaled(plus(new[step.second], w, -1), k)
        self.log(step, new, {step.first: scaled(impulse, -1), step.second: impulse}, normal)

    # --- places: of spheres that fly freely from the start ---------------------------------

    def place(self, tree: Any, now: int) -> Vector:
        if isinstance(tree, t.Name):
            tree = self.points[tree.name].position
        return self.vector(tree, now)

    def meets_wall(self, name: str, wall_name: str, now: int) -> bool:
        """Whether a sphere's centre, flying on from its place at the start, comes to a wall."""
        wall = self.walls[wall_name]
        v = self.stages[-1][name]
        start = self.place(self.spheres[name].position, now)
        if wall.start is not None:
            origin = self.place(wall.start, now)
            along = plus(self.place(wall.end, now), origin, -1)
        else:
            origin = self.place(wall.through, now)
            along = unit(self.direction(wall.along, now))
        across = cross(v, along)
        if abs(across) <= NONE:
            return False
        gap = plus(origin, start, -1)
        time = cross(gap, along) / across
        share = cross(gap, v) / across
        # An end is met for certain where only rounding sets the share apart from it.
        inside = NONE < share < 1 - NONE
        return bool(time > 0 and (wall.start is None or inside))

    # --- expressions ------------------------------------------------------------------------

    def scalar(self, tree: Any, now: int) -> Any:
        value = self.value(tree, now)
        if isinstance(value, tuple):
            raise TypeError("a vector where a number is wanted")
        return value

    def vector(self, tree: Any, now: int) -> Vector:
        value = self.value(tree, now)
        if not isinstance(value, tuple):
            raise TypeError("a number where a vector is wanted")
        return value

    def direction(self, tree: Any, now: int) -> Vector:
        """A vector, an angle from i, a wall or a line of centres."""
        value = self.value(tree, now)
        return value if isinstance(value, tuple) else (mp.cos(value), mp.sin(value))

    def value(self, tree: Any, now: int) -> Any:
        match tree:
            case t.Number(value=x):
                return number(x)
            case t.Degrees(value=x):
                return number(x) * mp.pi / 180
            case t.Pi():
                return +mp.pi
            case t.Letter(name=name):
                return self.letters[name]
            case t.Unit(axis=axis):
                return (mp.mpf(1), mp.mpf(0)) if axis == "i" else (mp.mpf(0), mp.mpf(1))
            case t.Name(name=name) if name in self.walls:
                wall = self.walls[name]
                if wall.along is not None:
                    return self.direction(wall.along, now)
                if wall.start is None:
                    raise NotImplementedError("a circular wall")
                return plus(self.place(wall.end, now), self.place(wall.start, now), -1)
            case t.Pair(x=x, y=y):
                return self.scalar(x, now), self.scalar(y, now)
            case t.Polar():
                return self.polar(tree, now)
            case t.Negate(operand=operand):
                value = self.value(operand, now)
                return scaled(value, -1) if isinstance(value, tuple) else -value
            case t.Binary():
                return self.binary(tree, now)
            case t.Apply(function=function, argument=argument):
                return self.applied(function, self.value(argument, now))
            case t.Quantity():
                return self.quantity(tree, now)
        raise NotImplementedError(repr(tree))

    def polar(self, tree: Any, now: int) -> Vector:
        length, angle = self.scalar(tree.size, now), self.scalar(tree.angle, now)
        if tree.wall is not None:
            origin = unit(self.vector(tree.wall, now))
            angle = -angle
        elif tree.origin is not None:
            origin = unit(self.direction(tree.origin, now))
        else:
            origin = (mp.mpf(1), mp.mpf(0))
        turned = plus(scaled(origin, mp.cos(angle)), left_of(origin), mp.sin(angle))
        return scaled(turned, length)

    def binary(self, tree: Any, now: int) -> Any:
        a, b = self.value(tree.left, now), self.value(tree.right, now)
        vectors = isinstance(a, tuple), isinstance(b, tuple)
        match tree.op:
            case "+" | "-":
                sign = 1 if tree.op == "+" else -1
                return plus(a, b, sign) if all(vectors) else a + sign * b
            case "*":
                if any(vectors):
                    return scaled(a, b) if vectors[0] else scaled(b, a)
                return a * b
            case "/":
                if b == 0:
                    raise ImpossibleWorldError("division by zero")
                return scaled(a, 1 / b) if vectors[0] else a / b
        return a**b

    def applied(self, function: str, x: Any) -> Any:
        if function == "abs":
            return size(x) if isinstance(x, tuple) else abs(x)
        if function == "sqrt" and -NONE <= x < 0:
            return mp.mpf(0)
        if function == "sqrt" and x < 0:
            raise ImpossibleWorldError("the root of a negative number")
        if function in ("arcsin", "arccos") and not -1 <= x <= 1:
            raise ImpossibleWorldError(f"{function} of {x}")
        if function in ("tan", "sec") and abs(mp.cos(x)) < NONE:
            raise ImpossibleWorldError(f"the {function} of a right angle")
        named = {"arcsin": mp.asin, "arccos": mp.acos, "arctan": mp.atan, "cosec": mp.csc}
        return named[function](x) if function in named else getattr(mp, function)(x)

    def stage(self, tree: Any, now: int, body: str | None = None) -> int:
        if tree.stage is None:
            return now
        if tree.stage == "before":
            return self.latest(body, now) - 1
        if isinstance(tree.stage, int):
            return tree.stage
        raise NotImplementedError("a stage at a time")

    def latest(self, body: str | None, now: int) -> int:
        """The number of the latest event of a body, or of all."""
        for n in range(now, 0, -1):
            event = self.events[n - 1]
            bodies = {getattr(event, each, None) for each in ("first", "second", "body")}
            if body is None or body in bodies:
                return n
        raise ImpossibleWorldError("nothing has happened")

    def energy(self, n: int, names: Any) -> Any:
        return sum(self.mass(name) * dot(v, v) / 2 for name, v in self.at(n, names).items())

    def at(self, n: int, names: Any) -> dict[str, Vector]:
        return {name: self.stages[n][name] for name in names}

    def quantity(self, tree: Any, now: int) -> Any:
        arguments = tree.arguments
        body = arguments[0].name if arguments and isinstance(arguments[0], t.Name) else None
        n = self.stage(tree, now, body)
        moving = list(self.stages[0])
        match tree.kind:
            case "velocity":
                return self.stages[n][body]
            case "speed":
                return size(self.stages[n][body])
            case "direction":
                v = self.vector(arguments[0], now) if body in self.walls else self.stages[n][body]
                return v if body in self.walls else mp.atan2(v[1], v[0])
            case "along" | "across":
                axis = unit(self.direction(arguments[1], now))
                v = self.vector(arguments[0], now)
                return dot(v, axis) if tree.kind == "along" else dot(v, left_of(axis))
            case "angle":
                a, b = (unit(self.direction(each, now)) for each in arguments)
                turned = mp.atan2(abs(cross(a, b)), dot(a, b))
                lines = [
                    (isinstance(each, t.Name) and each.name in self.walls)
                    or (isinstance(each, t.Quantity) and each.kind == "line_of_centres")
                    for each in arguments
                ]
                return min(turned, mp.pi - turned) if any(lines) else turned
            case "deflection":
                n = self.latest(body, n)
                a, b = self.stages[n - 1][body], self.stages[n][body]
                if size(a) == 0 or size(b) == 0:
                    raise ImpossibleWorldError("no direction, so no angle of deflection")
                return mp.atan2(abs(cross(a, b)), dot(a, b))
            case "impulse":
                n = tree.stage if isinstance(tree.stage, int) else self.latest(body, now)
                if body is not None:
                    return self.impulses[n][body]
                return size(next(iter(self.impulses[n].values())))
            case "energy":
                return self.energy(n, moving if body is None else [body])
            case "energy_lost":
                n = tree.stage if isinstance(tree.stage, int) else self.latest(None, now)
                bodies = list(self.impulses[n])
                return self.energy(n - 1, bodies) - self.energy(n, bodies)
            case "total_energy_lost":
                return self.energy(0, moving) - self.energy(now, moving)
            case "momentum":
                total: Vector = (mp.mpf(0), mp.mpf(0))
                for name, v in self.at(n, moving if body is None else [body]).items():
                    total = plus(total, v, self.mass(name))
                return total
            case "line_of_centres":
                n = tree.stage if isinstance(tree.stage, int) else self.latest(None, now)
                return self.normals[n]
            case "mass":
                return self.mass(body)
            case "dot":
                a, b = (self.vector(each, now) for each in arguments)
                return dot(a, b)
        raise NotImplementedError(tree.kind)

    # --- relations --------------------------------------------------------------------------

    def holds(self, relation: Any, now: int) -> bool:
        match relation:
            case p.Compare(operands=operands, operators=operators, figures=None):
                values = [self.value(each, now) for each in operands]
                return all(
                    compared(a, operator, b)
                    for a, operator, b in zip(values, operators, values[1:])
                )
            case p.Aligned():
                a, b = (self.direction(each, now) for each in (relation.left, relation.right))
                straight = abs(cross(a, b)) <= SAME * size(a) * size(b)
                match relation.relation:
                    case "perpendicular to":
                        return bool(abs(dot(a, b)) <= SAME * size(a) * size(b))
                    case "parallel to":
                        return bool(straight)
                    case "in the direction of":
                        return bool(straight and dot(a, b) > 0)
                    case _:
                        return bool(straight and dot(a, b) < 0)
            case p.AtRest():
                v = self.stages[now][relation.body.name]
                largest = max(size(each) for each in self.stages[now].values())
                return bool(size(v) <= SAME * (largest or 1))
            case p.Meets():
                return self.meets(relation, now) is relation.happens
        raise NotImplementedError(repr(relation))

    def meets(self, relation: p.Meets, now: int) -> bool:
        first, second = relation.first.name, relation.second.name
        if second in self.walls:
            if relation.again:
                raise NotImplementedError("a wall struck again")
            return self.meets_wall(first, second, now)
        last = max(
            n
            for n, each in enumerate(self.events[:now], 1)
            if {first, second} == {getattr(each, "first", 0), getattr(each, "second", 0)}
        )
        normal = self.normals[last]
        assert normal is not None
        if self.events[last - 1].first != first:
            normal = scaled(normal, -1)
        apart = plus(self.stages[now][second], self.stages[now][first], -1)
        if abs(cross(apart, normal)) > SAME * (1 + size(apart)):
            raise NotImplementedError("spheres that move across their old line of centres")
        gained = last < now  # something has happened since, so that there is a gap
        return bool(gained and dot(apart, normal) < -SAME * (1 + size(apart)))

    def possible(self) -> bool:
        """Whether all that is given holds in these numbers."""
        return all(self.holds(relation, now) for relation, now in self.facts)


def compared(a: Any, operator: str, b: Any) -> bool:
    if isinstance(a, tuple):
        return bool(size(plus(a, b, -1)) <= max(NONE, SAME * max(size(a), size(b))))
    same = abs(a - b) <= max(NONE, SAME * max(abs(a), abs(b)))
    match operator:
        case "=":
            return bool(same)
        case "<":
            return bool(a < b and not same)
        case "<=":
            return bool(a < b or same)
        case ">":
            return bool(a > b and not same)
    return bool(a > b or same)


@cache
def relations(text: str) -> tuple[Any, ...]:
    """Relations between letters, as they stand in a statement."""
    problem = parse(f"sphere Z: mass 1, at rest\ngiven {text}\n")
    return tuple(
        relation
        for _, step in problem.steps()
        if isinstance(step, p.Given)
        for relation in step.relations
    )


EMPTY = p.Problem()


def value_of(text: str, letters: Mapping[str, Any] | None = None) -> Any:
    """The number, or the pair of numbers, that an expression of letters is."""
    return World(EMPTY, letters or {}).value(expression(text), 0)


@cache
def expression(text: str) -> t.Expression:
    """An expression of letters, as it stands in a statement."""
    problem = parse(f"sphere Z: mass 1, at rest\nfind {text}\n")
    (step,) = (step for _, step in problem.steps() if isinstance(step, p.Find))
    item: Any = step.items[0]
    return item.expression


def true_of(text: str, letters: Mapping[str, Any]) -> bool:
    """Whether relations between letters hold for these numbers."""
    world = World(EMPTY, letters)
    return all(world.holds(relation, 0) for relation in relations(text))
