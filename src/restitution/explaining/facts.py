"""What a statement gives, as facts with ids, and the events of its story.

Ids are short and say what they are: ``mass A``, ``velocity A``, ``wall W``, ``axis 1``, ``e 1``,
``given 1``. A fact is one relation; stages are numbers in it, never *now*.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from restitution.explaining.derivation import Event, Fact, Link, Relation, Sign
from restitution.explaining.first_hits import hits
from restitution.explaining.trees import rebuilt, settled
from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    is_zero,
    letters,
    rational,
    walk,
)
from restitution.problem import (
    Aligned,
    Arrival,
    AtRest,
    Compare,
    Given,
    Impact,
    Kick,
    Let,
    Meets,
    Problem,
)
from restitution.problem import (
    Relation as Said,
)
from restitution.problem import trees as all_trees
from restitution.shapes import Circle, Segment

# Of these, a stage left out is the one reached where the quantity stands.
_STAGED = frozenset(word for word, kind in KINDS.items() if kind.staged and not kind.stage_needed)
_PLAIN = 12
"""So many events may come before a velocity of which the direction is plain."""

_OF_AN_EVENT = frozenset(word for word in _STAGED if KINDS[word].of_an_event)
_AXES: Mapping[Expression, Expression] = {
    Unit("i"): Unit("j"),
    Unit("j"): Negate(Unit("i")),
}


def events_of(problem: Problem) -> tuple[Event, ...]:
    """The events of a problem, in the order told."""
    walls = {each.name for each in problem.walls}
    events: list[Event] = []
    for number, step in enumerate(problem.events, 1):
        match step:
            case Impact():
                wall = step.second in walls
                events.append(Event(number, "impact", (step.first, step.second), wall))
            case Kick():
                events.append(Event(number, "kick", (step.body,)))
            case Arrival():
                events.append(Event(number, "arrival", (step.body,)))
    return tuple(events)


def facts_of(problem: Problem) -> tuple[Fact, ...]:
    """What a problem gives, part by part. Made of the statement alone, once a problem."""
    maker = FactsOf(problem)
    return tuple(maker.facts())


def staged(problem: Problem, tree: Expression, events: int) -> Expression:
    """A tree of a statement with the stages that are meant after some events."""
    return FactsOf(problem).settled(tree, events)


def links_of(problem: Problem, relation: Said, events: int) -> tuple[Link, ...]:
    """What a relation of a statement says after some events, as given facts say it.

    Nothing where two bodies meet for the first time.
    """
    return tuple(link for links in FactsOf(problem)._links(relation, events) for link in links)


def _is_about_the_sense(tree: Expression) -> bool:
    """Whether a tree is a line of centres, or holds a component in its direction."""
    return any(
        isinstance(node, Quantity)
        and node.kind in ("along", "across")
        and isinstance(node.arguments[-1], Quantity)
        and node.arguments[-1].kind == "line_of_centres"
        for node in walk(tree)
    )


class FactsOf:
    """The facts of one problem."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.events = events_of(problem)
        self.walls = {wall.name: wall for wall in problem.walls}
        self._normals: dict[int, Expression | None] = {}

    def facts(self) -> Iterator[Fact]:
        """All facts: of bodies, of events, then what is given."""
        yield from self._of_bodies()
        yield from self._of_events()
        yield from self._given()

    def _of_bodies(self) -> Iterator[Fact]:
        for sphere in self.problem.spheres:
            name = Name(sphere.name)
            properties = (
                ("mass", Quantity("mass", (name,)), sphere.mass),
                ("velocity", Quantity("velocity", (name,), 0), sphere.velocity),
                ("position", Quantity("position", (name,), 0), self.place_of(sphere.position)),
            )
            for word, quantity, value in properties:
                if isinstance(value, Expression):
                    if word == "velocity" and is_zero(value):
                        value = Pair(value, value)
                    yield self._fact(f"{word} {sphere.name}", quantity, value, sphere.place)
        for point in self.problem.points:
            place = Quantity("position", (Name(point.name),))
            if isinstance(point.position, Expression):
                yield self._fact(f"point {point.name}", place, point.position, point.place)
        for wall in self.problem.walls:
            along = self.along_of(wall)
            if along is not None:
                direction = Quantity("direction", (Name(wall.name),))
                yield self._fact(f"wall {wall.name}", direction, along, wall.place, "parallel to")

    def along_of(self, wall: Any) -> Expression | None:
        """The direction of a straight wall: as told, or from one end of it to the other."""
        if isinstance(wall.along, Expression):
            return wall.along
        ends = [self.place_of(each) for each in (wall.start, wall.end)]
        match ends:
            case [Pair(a, b), Pair(c, d)]:
                return Pair(_difference(c, a), _difference(d, b))
        return None

    def place_of(self, tree: Any) -> Expression | None:
        """The coordinates of a point that is named or given."""
        if isinstance(tree, Name):
            points = {point.name: point.position for point in self.problem.points}
            return self.place_of(points.get(tree.name))
        return tree if isinstance(tree, Expression) else None

    def _contact(self, step: Impact | Arrival, number: int) -> Iterator[tuple[Expression, Any]]:
        """Where the bodies of an event are: on the line of the wall, or in one place.

        The centre of a sphere with a radius is that far from a wall, and two radii from another
        centre. That is said where it is plain on which side it is.
        """
        first, second = (
            (step.first, step.second)
            if isinstance(step, Impact)
            else (step.body, getattr(step.target, "name", ""))
        )
        own = Quantity("position", (Name(first),), number)
        wall = self.walls.get(second)
        if wall is None:
            if isinstance(step, Impact):
                theirs = self._beside_it(step, number)
                if theirs is not None:
                    yield own, theirs
                elif (both := self._touching(step)) is not None:
                    centres = _between(step, number)
                    yield (
                        Quantity("dot", (centres, centres)),
                        Binary("^", both, Number(Fraction(2))),
                    )
            elif isinstance(place := self.place_of(step.target), Expression):
                yield own, place
            return
        if isinstance(wall.shape, Circle):
            yield from self._on_the_circle(first, wall, number)
            return
        place = self.place_of(wall.shape.point)
        along = self.along_of(wall)
        if not isinstance(place, Pair) or along is None:
            return
        axis = _turned(along)
        if along == Unit("i") or (isinstance(along, Pair) and is_zero(along.y)):
            centre = self._off_the_wall(first, "y", place.y)
            if centre is not None:
                yield Quantity("along", (own, Unit("j"))), centre
        elif along == Unit("j") or (isinstance(along, Pair) and is_zero(along.x)):
            centre = self._off_the_wall(first, "x", place.x)
            if centre is not None:
                yield Quantity("along", (own, Unit("i"))), centre
        elif axis is not None and self.radius is None:
            yield Quantity("dot", (Binary("-", own, place), axis)), Number(Fraction(0))

    def _on_the_circle(
        self, body: str, wall: Any, number: int
    ) -> Iterator[tuple[Expression, Expression]]:
        """That a centre is at the distance of the radius from that of a circular wall."""
        size, side = self._radius(body, wall), self._side(body, wall)
        radius_vector = self._from_centre(body, wall, number)
        if size is not None and side is not None and radius_vector is not None:
            yield (
                Quantity("dot", (radius_vector, radius_vector)),
                Binary("^", size, Number(Fraction(2))),
            )

    def _from_centre(self, body: str, wall: Any, number: int) -> Expression | None:
        """The way from the centre of a circular wall to a body, at an event."""
        centre = self.place_of(wall.centre)
        if not isinstance(centre, Pair):
            return None
        own = Quantity("position", (Name(body),), number)
        at_origin = is_zero(centre.x) and is_zero(centre.y)
        return own if at_origin else Binary("-", own, centre)

    def _radius(self, body: str, wall: Any) -> Expression | None:
        """How far from the centre of a circular wall a body is when it touches it."""
        radius = self.radius
        if radius is None:
            return wall.radius if isinstance(wall.radius, Expression) else None
        side = self._side(body, wall)
        if side is None or not isinstance(radius, Expression):
            return None
        whole = Binary("+" if side > 0 else "-", wall.radius, radius)
        if isinstance(wall.radius, Number) and isinstance(radius, Number):
            return rational(wall.radius.value + side * radius.value)
        return whole

    def _side(self, body: str, wall: Any) -> int | None:
        """1 where a body begins outside a circular wall, −1 inside, or on it; None if open."""
        place, centre = self.place_of(self.sphere(body).position), self.place_of(wall.centre)
        if not isinstance(place, Pair) or not isinstance(centre, Pair):
            return None
        radius_vector = Binary("-", place, centre)
        gap = Binary(
            "-",
            Quantity("dot", (radius_vector, radius_vector)),
            Binary("^", wall.radius, Number(Fraction(2))),
        )
        side = self._sign(gap)
        if side is None:
            world = world_of(self.problem)
            inside = world.scalar(gap).vanishes or self._goes_outward(body, wall, radius_vector)
            return -1 if inside else None
        return side

    def _goes_outward(self, body: str, wall: Any, radius_vector: Expression) -> bool:
        """Whether a body that strikes a circular wall first of all comes no nearer to its centre.

        So it begins inside.
        """
        own = next((event for event in self.events if body in event.bodies), None)
        velocity = self.sphere(body).velocity
        if own is None or not own.wall or wall.name not in own.bodies:
            return False
        if not isinstance(velocity, Expression):
            return False
        outward = Quantity("dot", (radius_vector, velocity))
        return world_of(self.problem).scalar(outward).vanishes or self._sign(outward) == 1

    def _of_the_story(self, step: Impact, number: int) -> Iterator[Fact]:
        """What has to be, or there is no such impact: of its coefficient, and of the approach."""
        if isinstance(step.e, Expression) and not isinstance(step.e, Letter | Number):
            one = Number(Fraction(1))
            if letters(step.e) and self._sign(Binary("-", one, step.e)) is None:
                most = Relation(((Link(step.e, "<=", one),),))
                yield Fact(f"most {number}", "geometry", most, None, step.place)
        if number > 1 or step.second in self.walls:
            return
        if isinstance(step.offset, Expression) and self.radius is not None:
            both = self._doubled(self.radius)
            if letters(step.offset) and self._sign(step.offset) == 1:
                near = Relation(((Link(step.offset, "<", both),),))
                yield Fact(f"offset {number}", "geometry", near, None, step.place)
        if step.along is None:
            return
        speeds = [self.sphere(each).velocity for each in (step.first, step.second)]
        if all(isinstance(speed, Expression) for speed in speeds) and any(map(letters, speeds)):
            axis = step.along
            a, b = (
                Quantity("along", (Quantity("velocity", (Name(each),), 0), axis))
                for each in (step.first, step.second)
            )
            nearer = Relation(((Link(a, ">", b),),))
            yield Fact(f"approach {number}", "geometry", nearer, None, step.place)

    def _within(self, step: Impact, number: int) -> Relation | None:
        """That a sphere comes to a wall between its ends, where that is along **i** or **j**."""
        wall = self.walls.get(step.second)
        if wall is None or not isinstance(wall.shape, Segment) or self.radius is not None:
            return None
        if not isinstance(self.sphere(step.first).position, Expression):
            return None
        match self.place_of(wall.start), self.place_of(wall.end):
            case Pair(a, b), Pair(c, d) if is_zero(_difference(d, b)):
                ends, unit = (a, c), Unit("i")
            case Pair(a, b), Pair(c, d) if is_zero(_difference(c, a)):
                ends, unit = (b, d), Unit("j")
            case _:
                return None
        side = self._sign(Binary("-", ends[1], ends[0]))
        if side is None:
            return None
        low, high = ends if side > 0 else ends[::-1]
        place = Quantity("along", (Quantity("position", (Name(step.first),), number), unit))
        return Relation(((Link(low, "<", place), Link(place, "<", high)),))

    @cached_property
    def radius(self) -> Expression | None:
        """The radius of all spheres; None where they are small."""
        radii = (sphere.radius for sphere in self.problem.spheres)
        return next((each for each in radii if isinstance(each, Expression)), None)

    def sphere(self, name: str) -> Any:
        return next(sphere for sphere in self.problem.spheres if sphere.name == name)

    def _off_the_wall(self, body: str, part: str, wall: Expression) -> Expression | None:
        """The coordinate of a centre at a wall: its radius away on the side where it begins."""
        sphere = self.sphere(body)
        if self.radius is None:
            return wall
        if not isinstance(sphere.position, Pair) or not isinstance(self.radius, Expression):
            return None
        side = self._sign(Binary("-", getattr(sphere.position, part), wall))
        if side is None:
            return None
        if is_zero(wall):
            return self.radius if side > 0 else Negate(self.radius)
        return Binary("+" if side > 0 else "-", wall, self.radius)

    def _beside_it(self, step: Impact, number: int) -> Expression | None:
        """Where the first centre is, by that of the second: in one place, or two radii away."""
        theirs = Quantity("position", (Name(step.second),), number)
        first, second = (self.sphere(each) for each in (step.first, step.second))
        if self.radius is None:
            return theirs
        met = {body for each in self.events[: number - 1] for body in each.bodies}
        places = [each.position for each in (first, second)]
        if met & {first.name, second.name} or not isinstance(self.radius, Expression):
            return None
        if step.along not in (Unit("i"), Unit("j")):
            return self._beside_on_a_slant(step, theirs, places)
        if all(isinstance(place, Pair) for place in places):
            part = "x" if step.along == Unit("i") else "y"
            side = self._sign(Binary("-", *(getattr(place, part) for place in reversed(places))))
        elif any(isinstance(place, Pair) for place in places):
            return None
        else:
            side = self._approach(first, second, step.along)
        if side is None:
            return None
        apart = Binary("*", Binary("*", Number(Fraction(2)), self.radius), step.along)
        return Binary("-" if side > 0 else "+", theirs, apart)

    def _beside_on_a_slant(
        self, step: Impact, theirs: Expression, places: list[Any]
    ) -> Expression | None:
        """Where the first centre is by the second, on a line at an angle or along a vector.

        It comes from its side of the second, so that the way between their places tells the sense.
        """
        match step.along:
            case Degrees() | Negate(Degrees()):
                unit: Expression = Polar(Number(Fraction(1)), step.along)
            case Pair() | Binary() as vector:
                unit = Binary("/", vector, Apply("abs", vector))
            case _:
                return None
        if not all(isinstance(place, Pair) for place in places) or self.radius is None:
            return None
        first, second = places
        displacement = Pair(_difference(second.x, first.x), _difference(second.y, first.y))
        side = self._sign(Quantity("dot", (displacement, unit)))
        if side is None:
            return None
        apart = Binary("*", Binary("*", Number(Fraction(2)), self.radius), unit)
        return Binary("-" if side > 0 else "+", theirs, apart)

    def _approach(self, first: Any, second: Any, axis: Expression) -> int | None:
        """In which sense of an axis the first sphere comes nearer to the second at the start."""
        paces = [
            Number(Fraction(0)) if _at_rest(each.velocity) else each.velocity
            for each in (first, second)
        ]
        if not all(isinstance(pace, Expression) for pace in paces):
            return None
        a, b = (Quantity("dot", (pace, axis)) if not is_zero(pace) else pace for pace in paces)
        return self._sign(Binary("-", a, b))

    def _sign(self, tree: Expression) -> int | None:
        """The sign of an expression in letters, where it is plain."""
        from restitution.explaining.quotients import NotComparableError

        world = world_of(self.problem)
        try:
            return self.sign_in(world, world.scalar(tree))
        except NotComparableError:
            return None

    @staticmethod
    def sign_in(world: Any, value: Any) -> int | None:
        """The sign of a quotient of a world, where it is plain."""
        from restitution.oracle import Oracle, compared

        own = world.expression(value, world.roles)
        oracle = Oracle(world.roles)
        for sign in (1, -1):
            if oracle.proves(compared(sign * own, ">", 0)):
                return sign
        return None

    def world(self) -> Any:
        """The letters of the statement, and the directions of its walls."""
        world = world_of(self.problem)
        for wall in self.problem.walls:
            along = self.along_of(wall)
            if along is not None:
                world.directions[Quantity("direction", (Name(wall.name),))] = along
        return world

    def _start(self) -> Iterator[Fact]:
        """When the clock starts: with places at time 0, without them with the first impact.

        Who rests until the first event, a blow, is struck at that time.
        """
        placed = any(isinstance(sphere.position, Expression) for sphere in self.problem.spheres)
        apart = bool(self.events) and self.events[0].kind == "impact" and not self.events[0].wall
        if placed or apart:
            time = Quantity("time", (), 0 if placed and not self._is_struck() else 1)
            yield self._fact("start", time, Number(Fraction(0)), None)
        if apart and not placed:
            zero = Number(Fraction(0))
            place = Quantity("position", (Name(self.events[0].bodies[0]),), 1)
            yield self._fact("origin", place, Pair(zero, zero), None, "=", "geometry")

    def _is_struck(self) -> bool:
        """Whether the first event is a blow to a body at rest."""
        if not self.events or self.events[0].kind != "kick":
            return False
        (name,) = self.events[0].bodies
        return any(
            sphere.name == name and _at_rest(sphere.velocity) for sphere in self.problem.spheres
        )

    def _of_events(self) -> Iterator[Fact]:
        yield from self._start()
        for number, step in enumerate(self.problem.events, 1):
            if isinstance(step, Kick):
                impulse = Quantity("impulse", (Name(step.body),), number)
                yield self._fact(f"impulse {number}", impulse, step.impulse, step.place)
            else:
                for left, right in self._contact(step, number):
                    yield self._fact(f"contact {number}", left, right, step.place, "=", "geometry")
            if not isinstance(step, Impact):
                continue
            within = self._within(step, number)
            if within is not None:
                yield Fact(f"within {number}", "geometry", within, None, step.place)
            yield from self._of_the_story(step, number)
            e = Letter("e") if step.e is None else step.e
            yield self._fact(f"e {number}", Quantity("restitution", (), number), e, step.place)
            axis = Quantity("line_of_centres", (), number)
            if step.along is not None:
                along = step.along
                if number == 1 and self._is_backwards(step):
                    along = along.operand if isinstance(along, Negate) else Negate(along)
                sign: Sign = "=" if along in (Unit("i"), Unit("j")) else "parallel to"
                yield self._fact(f"axis {number}", axis, along, step.place, sign, "geometry")
            elif step.offset is not None:
                centres = self._beside(step, number)
                if centres is not None:
                    yield self._fact(f"axis {number}", axis, centres, step.place, "=", "geometry")
            elif step.second in self.walls and isinstance(self.walls[step.second].shape, Circle):
                yield from self._of_circle(step, number)
            elif step.second not in self.walls and self._touching(step) is not None:
                yield from self._of_touching(step, number)
            elif step.second in self.walls:
                normal = self._into_the_wall(step, number)
                if normal is not None:
                    sign = "=" if _is_unit(normal) else "parallel to"
                    yield self._fact(f"axis {number}", axis, normal, step.place, sign, "geometry")

    def _is_backwards(self, step: Impact) -> bool:
        """Whether a line of centres is typed against the approach, and its sense is asked for.

        In a statement it leads from the first sphere to the second. So it does here, where a
        component in its direction, or the direction itself, is asked or given.
        """
        if not any(_is_about_the_sense(tree) for tree in all_trees(self.problem)):
            return False
        velocities = [self.sphere(each).velocity for each in (step.first, step.second)]
        directions = [each for each in (step.along, *velocities) if isinstance(each, Expression)]
        nodes = (each for tree in directions for each in walk(tree))
        if len(directions) != 3 or any(isinstance(node, Letter | Polar) for node in nodes):
            return False
        world = world_of(self.problem)
        centres, *both = (world.value(each) for each in directions)
        if not hasattr(centres, "x") or not any(hasattr(each, "x") for each in both):
            return False
        # Who is at rest has 0 for its velocity.
        first, second = (
            _dot(world, centres, each) if hasattr(each, "x") else each for each in both
        )
        approach = first - second
        if not (approach.above.is_ground and approach.below.is_ground) or approach.vanishes:
            return False
        return bool(approach.above.LC / approach.below.LC < 0)

    def _touching(self, step: Impact) -> Expression | None:
        """Both radii of spheres that begin at places, where nothing else tells how they meet."""
        first, second = (self.sphere(each) for each in (step.first, step.second))
        placed = all(isinstance(each.position, Expression) for each in (first, second))
        if not placed or step.along is not None or step.offset is not None:
            return None
        return None if self.radius is None else self._doubled(self.radius)

    def _doubled(self, tree: Expression) -> Expression:
        """Twice a length, as a number where it is one."""
        value = world_of(self.problem).scalar(tree)
        if value.above.is_ground and value.below.is_ground:
            number = 2 * value.above.LC / value.below.LC
            return rational(Fraction(int(number.numerator), int(number.denominator)))
        return Binary("*", Number(Fraction(2)), tree)

    def _of_touching(self, step: Impact, number: int) -> Iterator[Fact]:
        """The line of centres of spheres that touch, by their places, and that they approach."""
        centres = _between(step, number)
        axis = Quantity("line_of_centres", (), number)
        yield self._fact(f"axis {number}", axis, centres, step.place, "parallel to", "geometry")
        first, second = (
            settled(Quantity("velocity", (Name(each),), number - 1), self.events)
            for each in (step.first, step.second)
        )
        towards = Quantity("dot", (Binary("-", first, second), centres))
        zero = Number(Fraction(0))
        yield self._fact(f"towards {number}", towards, zero, step.place, ">", "geometry")

    def _of_circle(self, step: Impact, number: int) -> Iterator[Fact]:
        """The normal of a circular wall where it is struck, and which of two times that is.

        It is along the radius, away from the centre inside and towards it outside. Who is inside
        comes to the wall after the last event; who is outside moves towards it.
        """
        wall = self.walls[step.second]
        side, radius_vector = (
            self._side(step.first, wall),
            self._from_centre(step.first, wall, number),
        )
        if side is None or radius_vector is None:
            return
        axis = Quantity("line_of_centres", (), number)
        if side > 0:
            radius_vector = (
                Binary("-", radius_vector.right, radius_vector.left)
                if isinstance(radius_vector, Binary)
                else Negate(radius_vector)
            )
        yield self._fact(
            f"axis {number}", axis, radius_vector, step.place, "parallel to", "geometry"
        )
        if side > 0:
            velocity = Quantity("velocity", (Name(step.first),), number - 1)
            towards = settled(Quantity("dot", (velocity, radius_vector)), self.events)
            zero = Number(Fraction(0))
            yield self._fact(f"towards {number}", towards, zero, step.place, ">", "geometry")
        else:
            since = self.latest([step.first], number - 1)
            early = Quantity("time", (), since) if since else Number(Fraction(0))
            time = Quantity("time", (), number)
            yield self._fact(f"order {number}", time, early, step.place, ">", "geometry")

    def _beside(self, step: Impact, number: int) -> Expression | None:
        """The line of centres of spheres that meet beside each other's path, at the first event.

        Its angle with the path has the offset over both radii as its sine.
        """
        first, second = (
            next(e for e in self.problem.spheres if e.name == name)
            for name in (step.first, step.second)
        )
        if number > 1 or self.radius is None or step.offset is None:
            return None
        if not isinstance(first.velocity, Expression):
            return None
        path = first.velocity
        if not _at_rest(second.velocity):
            if not isinstance(second.velocity, Expression):
                return None
            path = Binary("-", path, second.velocity)
        both = Binary("*", Number(Fraction(2)), self.radius)
        angle = Apply("arcsin", Binary("/", step.offset, both))
        return Polar(Number(Fraction(1)), angle, path)

    def _into_the_wall(self, step: Impact, number: int) -> Expression | None:
        """A direction perpendicular to a straight wall: towards it, as far as that is plain."""
        # A velocity rests on all walls on the way, and each of them on the velocity before it.
        if number not in self._normals:
            self._normals[number] = self._normal_into(step, number)
        return self._normals[number]

    def _normal_into(self, step: Impact, number: int) -> Expression | None:
        along = self.along_of(self.walls[step.second])
        if along is None:
            return None
        left = _turned(along)
        if left is None:
            left = self._turned_angle(along)
        if left is None:
            return None
        return _opposite(left) if self._leads_away(step.first, number, left) else left

    def _turned_angle(self, along: Expression) -> Expression | None:
        """A direction that is told by its angle, turned by +90°."""
        if not world_of(self.problem).is_angle(along):
            return None
        right = Degrees(Fraction(90))
        if isinstance(along, Degrees):
            return Degrees(along.value + right.value)
        return Binary("+", along, right)

    def _leads_away(self, body: str, number: int, normal: Expression) -> bool:
        """Whether a velocity before an event, where it is plain, is against a direction."""
        from restitution.explaining.quotients import NotComparableError
        from restitution.oracle import Oracle, compared

        if number > _PLAIN:
            return False
        world = self.world()
        try:
            velocity, axis = self.velocity_before(body, number, world), world.direction(normal)
            if velocity is None or axis is None:
                return False
            value = world.expression(_dot(world, velocity, axis), world.roles)
        except NotComparableError:
            return False
        oracle = Oracle(world.roles)
        return oracle.proves(compared(value, "<=", 0)) and (
            oracle.decide(compared(value, ">=", 0)).answer != "proved"
        )

    def velocity_before(self, body: str, number: int, world: Any) -> Any:
        """The velocity before an event: the one given, turned back by walls on the way.

        None where another sphere, or a blow, comes in between.
        """
        from restitution.explaining.quotients import CONSTANT, Plane

        given = next(sphere.velocity for sphere in self.problem.spheres if sphere.name == body)
        value = world.value(given) if isinstance(given, Expression) else None
        for event, step in enumerate(self.problem.events, 1):
            if event == number or not isinstance(value, Plane):
                break
            if body not in self.events[event - 1].bodies or isinstance(step, Arrival):
                continue
            if isinstance(step, Kick):
                push = world.value(step.impulse)
                mass = next(sphere.mass for sphere in self.problem.spheres if sphere.name == body)
                if not isinstance(push, Plane) or not isinstance(mass, Expression):
                    return None
                share = world.scalar(mass)
                value = Plane(value.x + push.x / share, value.y + push.y / share)
                continue
            normal = self._into_the_wall(step, event) if self.events[event - 1].wall else None
            axis = None if normal is None else world.direction(normal)
            if axis is None:
                return None
            e = world.scalar(Letter("e") if step.e is None else step.e)
            factor = (CONSTANT(1) + e) * _dot(world, value, axis) / _dot(world, axis, axis)
            value = Plane(value.x - factor * axis.x, value.y - factor * axis.y)
        return value if isinstance(value, Plane) else None

    def _given(self) -> Iterator[Fact]:
        number = 0
        for step, events, part in self.problem.timeline():
            if isinstance(step, Let):
                quantity = self.settled(step.expression, events)
                yield self._fact(f"let {step.letter}", quantity, Letter(step.letter), step.place)
            if not isinstance(step, Given):
                continue
            for relation in step.relations:
                for own in self._relations(relation, events):
                    number += 1
                    kind: Any = "range" if _is_range(own) else "given"
                    yield Fact(f"given {number}", kind, own, part.label, step.place)
                sense = self._sense(relation, events)
                if sense is not None:
                    stated = Relation(((sense,),))
                    yield Fact(f"sense {number}", "range", stated, part.label, step.place)

    def _relations(self, relation: Said, events: int) -> Iterator[Relation]:
        """What a relation of a statement says after some events, as facts."""
        if isinstance(relation, Meets):
            own = hits(self, relation, events)
            if own is not None:
                yield own
                return
        yield from (Relation((links,)) for links in self._links(relation, events))

    def _links(self, relation: Said, events: int) -> Iterator[tuple[Link, ...]]:
        match relation:
            case Compare(operands, operators):
                trees = [self.settled(operand, events) for operand in operands]
                for left, sign, right in zip(trees, operators, trees[1:], strict=False):
                    yield (Link(left, sign, right),)
            case Aligned(left, how, right):
                a, b = (self.settled(each, events) for each in (left, right))
                if how == "opposite to":
                    b = Negate(b)
                sign_: Sign = "perpendicular to" if how == "perpendicular to" else "parallel to"
                yield (Link(self._direction(a, events), sign_, self._direction(b, events)),)
            case Meets(first, second, _, happens):
                link = self._separation(first, second, happens, events)
                if link is not None:
                    yield (link,)
            case AtRest(body):
                velocity = self.settled(Quantity("velocity", (body,), None), events)
                zero = Number(Fraction(0))
                yield (Link(velocity, "=", Pair(zero, zero)),)

    def _sense(self, relation: Said, events: int) -> Link | None:
        """In which of two directions what is parallel to one points."""
        if not isinstance(relation, Aligned):
            return None
        sign: Sign
        match relation.relation:
            case "in the direction of":
                sign = ">"
            case "opposite to":
                sign = "<"
            case _:
                return None
        a, b = (
            self._direction(self.settled(each, events), events)
            for each in (relation.left, relation.right)
        )
        left = Quantity("along" if isinstance(b, Unit) else "dot", (a, b))
        return Link(left, sign, Number(Fraction(0)))

    def _separation(
        self, first: Expression, second: Expression, happens: bool, events: int
    ) -> Link | None:
        """Two that have met meet again if the one behind is the faster.

        None where they have not met: who is ahead is not plain then.
        """
        pair = tuple(each.name for each in (first, second) if isinstance(each, Name))
        met = [e for e in self.events[:events] if set(e.bodies) == set(pair)]
        if not met:
            return None
        axis = Quantity("line_of_centres", (), met[-1].number)
        behind, ahead = (
            Quantity("along", (Quantity("velocity", (Name(body),), events), axis))
            for body in met[-1].bodies
        )
        left, right = (settled(each, self.events) for each in (behind, ahead))
        other: Expression = Number(Fraction(0)) if met[-1].wall else right
        return Link(left, ">" if happens else "<=", other)

    def _direction(self, tree: Expression, events: int) -> Expression:
        """The velocity of a sphere, where its name stands for a direction."""
        if isinstance(tree, Name) and tree.name not in self.walls:
            return self.settled(Quantity("velocity", (tree,), None), events)
        return tree

    def settled(self, tree: Expression, events: int) -> Expression:
        """A tree with the stage that *now* and *before* mean after some events."""

        def change(each: Expression) -> Expression:
            if not isinstance(each, Quantity) or each.kind not in _STAGED:
                return each
            if each.stage is None and each.kind == "direction" and self._is_wall(each):
                return each
            if each.stage not in (None, "before"):
                return each
            if each.kind == "distance" and not self._is_between_bodies(each):
                return each
            bodies = [a.name for a in each.arguments if isinstance(a, Name)]
            latest = self.latest(bodies, events)
            if each.stage == "before":
                return replace(each, stage=max(0, latest - 1))
            stage = latest if each.kind in _OF_AN_EVENT else events
            return replace(each, stage=stage)

        return settled(rebuilt(tree, change), self.events)

    def _is_between_bodies(self, tree: Quantity) -> bool:
        spheres = {sphere.name for sphere in self.problem.spheres}
        return any(
            isinstance(argument, Name) and argument.name in spheres for argument in tree.arguments
        )

    def _is_wall(self, tree: Quantity) -> bool:
        return any(isinstance(a, Name) and a.name in self.walls for a in tree.arguments)

    def latest(self, bodies: list[str], events: int) -> int:
        """The last event so far in which one of some bodies took part; of all, if there is none."""
        own = [
            e.number
            for e in self.events[:events]
            if not bodies or any(body in e.bodies for body in bodies)
        ]
        return max(own, default=0)

    def _fact(
        self,
        name: str,
        left: Expression,
        right: Expression,
        place: Any,
        sign: Sign = "=",
        kind: Any = "data",
    ) -> Fact:
        relation = Relation(((Link(left, sign, settled(right, self.events)),),))
        return Fact(name, kind, relation, None, place)


def _between(step: Impact, number: int) -> Expression:
    """The way from the first centre to the second at an impact of two spheres."""
    first, second = (
        Quantity("position", (Name(each),), number) for each in (step.first, step.second)
    )
    return Binary("-", second, first)


def _is_range(relation: Relation) -> bool:
    """Whether a relation only bounds letters."""
    links = [link for option in relation.options for link in option]
    trees = [tree for link in links for side in (link.left, link.right) for tree in walk(side)]
    return all(link.sign in ("<", "<=", ">", ">=", "!=") for link in links) and not any(
        isinstance(each, Quantity | Apply) for each in trees
    )


def _difference(a: Expression, b: Expression) -> Expression:
    if a == b:
        return Number(Fraction(0))
    if isinstance(a, Number) and isinstance(b, Number):
        return rational(a.value - b.value)
    return a if is_zero(b) else Negate(b) if is_zero(a) else Binary("-", a, b)


def _is_unit(tree: Expression) -> bool:
    return isinstance(tree, Unit) or (isinstance(tree, Negate) and isinstance(tree.operand, Unit))


def _turned(along: Expression) -> Expression | None:
    """A direction turned by +90°."""
    if along in _AXES:
        return _AXES[along]
    match along:
        case Negate(operand):
            turned = _turned(operand)
            return None if turned is None else _opposite(turned)
        case Pair(x, y):
            return Pair(_opposite(y), x)
        case Binary("+" | "-", left, right):
            a, b = _turned(left), _turned(right)
            if a is None or b is None:
                return None
            if isinstance(b, Negate):
                return Binary("-" if along.op == "+" else "+", a, b.operand)
            return Binary(along.op, a, b)
        case Binary("*", left, right):
            b = _turned(right)
            if b is None:
                return None
            if isinstance(b, Negate):
                return Negate(Binary("*", left, b.operand))
            return Binary("*", left, b)
    return None


def world_of(problem: Problem) -> Any:
    """The letters of a statement, to compare trees in."""
    from restitution.explaining.algebra import World
    from restitution.solving.letters import roles

    known = roles(problem)
    angles = frozenset(name for name, role in known.items() if role.kind == "angle")
    return World(known, frozenset(), angles, {})


def _dot(world: Any, a: Any, b: Any) -> Any:
    """The scalar product of two vectors of a world."""
    return world.reduced(a.x * b.x + a.y * b.y)


def _at_rest(velocity: Any) -> bool:
    return isinstance(velocity, Pair) and is_zero(velocity.x) and is_zero(velocity.y)


def _opposite(tree: Expression) -> Expression:
    if isinstance(tree, Degrees):
        return Degrees((tree.value + 180) % 360)
    if isinstance(tree, Binary) and tree.right == Degrees(Fraction(90)):
        return Binary("-" if tree.op == "+" else "+", tree.left, tree.right)
    if isinstance(tree, Binary) and tree.op == "-":
        return Binary("-", tree.right, tree.left)
    return tree.operand if isinstance(tree, Negate) else Negate(tree)
