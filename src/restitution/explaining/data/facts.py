"""What a statement gives, as facts with ids, and the events of its story.

Ids are short and say what they are: ``mass A``, ``velocity A``, ``wall W``, ``axis 1``, ``e 1``,
``given 1``. A fact is one relation; stages are numbers in it, never *now*.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property

from restitution.explaining.data.arrangement import Arrangement, difference, dot, turned, world_of
from restitution.explaining.data.coming_to_walls import coming_to_wall
from restitution.explaining.data.first_hits import hits
from restitution.explaining.data.meeting_again import separation
from restitution.explaining.data.one_line import axis_of_all, side_along, with_lines_of_centres
from restitution.explaining.lines.derivation import Fact, FactKind, Link, Relation, Sign
from restitution.explaining.lines.quotients import Plane
from restitution.explaining.lines.trees import degrees_worked_out, rebuilt, settled
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
    Place,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_component,
    is_function,
    is_quantity,
    is_rest,
    is_zero,
    letters,
    negated,
    rational,
    unsigned,
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
    Wall,
    once_a_problem,
)
from restitution.problem import (
    Relation as Said,
)
from restitution.problem import trees as all_trees
from restitution.shapes import Circle, Segment
from restitution.solving.story.paths_to_walls import angle_to_be_acute

# Of these, a stage left out is the one reached where the quantity stands.
_STAGED = frozenset(word for word, kind in KINDS.items() if kind.staged and not kind.stage_needed)
_OF_AN_EVENT = frozenset(word for word in _STAGED if KINDS[word].of_an_event)


@once_a_problem
def facts_of(problem: Problem) -> tuple[Fact, ...]:
    """What a problem gives, part by part. Made of the statement alone, once a problem."""
    maker = FactsOf(with_lines_of_centres(Arrangement(problem)))
    return tuple(maker.facts())


def staged(problem: Problem, tree: Expression, events: int) -> Expression:
    """A tree of a statement with the stages that are meant after some events."""
    return _maker(problem).settled(tree, events)


def links_of(problem: Problem, relation: Said, events: int) -> tuple[Link, ...]:
    """What a relation of a statement says after some events, as given facts say it.

    Nothing where two bodies meet for the first time.
    """
    return tuple(link for links in _maker(problem)._links(relation, events) for link in links)


@once_a_problem
def _maker(problem: Problem) -> FactsOf:
    """Who settles the trees of a statement as it stands, without the directions of its lines."""
    return FactsOf(problem)


def _is_about_the_sense(tree: Expression) -> bool:
    """Whether a tree is a line of centres, or holds a component in its direction."""
    return is_quantity(tree, "line_of_centres") or any(
        is_component(node) and is_quantity(node.arguments[-1], "line_of_centres")
        for node in walk(tree)
    )


class FactsOf(Arrangement):
    """The facts of one problem."""

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
            acute = angle_to_be_acute(self.problem, sphere)
            if acute is not None:
                link = Link(Apply("cos", acute), ">", Number(Fraction(0)))
                yield Fact(f"path {sphere.name}", "range", Relation(((link,),)), None, sphere.place)
        for point in self.problem.points:
            place = Quantity("position", (Name(point.name),))
            if isinstance(point.position, Expression):
                yield self._fact(f"point {point.name}", place, point.position, point.place)
        for wall in self.problem.walls:
            along = self.along_of(wall)
            if along is not None:
                direction = Quantity("direction", (Name(wall.name),))
                yield self._fact(f"wall {wall.name}", direction, along, wall.place, "parallel to")

    def _contact(
        self, step: Impact | Arrival, number: int
    ) -> Iterator[tuple[Expression, Expression]]:
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
        axis = turned(along)
        if axis is None and world_of(self.problem).is_angle(along):
            axis = Pair(Negate(Apply("sin", along)), Apply("cos", along))
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
        self, body: str, wall: Wall, number: int
    ) -> Iterator[tuple[Expression, Expression]]:
        """That a centre is at the distance of the radius from that of a circular wall."""
        size, side = self.distance_to_centre(body, wall), self.side_of_circle(body, wall)
        radius_vector = self.from_centre(body, wall, number)
        if size is not None and side is not None and radius_vector is not None:
            yield (
                Quantity("dot", (radius_vector, radius_vector)),
                Binary("^", size, Number(Fraction(2))),
            )

    def _of_the_story(self, step: Impact, number: int) -> Iterator[Fact]:
        """What has to be, or there is no such impact: of its coefficient, and of the approach."""
        if isinstance(step.e, Expression) and not isinstance(step.e, Letter | Number):
            one = Number(Fraction(1))
            if letters(step.e) and self.sign(Binary("-", one, step.e)) is None:
                most = Relation(((Link(step.e, "<=", one),),))
                yield Fact(f"most {number}", "geometry", most, None, step.place)
        if step.second in self.walls:
            towards = coming_to_wall(self, step, number)
            if towards is not None:
                left = self.settled(towards.left, number - 1)
                nearer = Relation(((replace(towards, left=left),),))
                yield Fact(f"approach {number}", "geometry", nearer, None, step.place)
            return
        offset = step.offset if number == 1 else None
        if isinstance(offset, Expression) and self.radius is not None:
            both = self._doubled(self.radius)
            if letters(offset) and self.sign(offset) == 1:
                near = Relation(((Link(offset, "<", both),),))
                yield Fact(f"offset {number}", "geometry", near, None, step.place)
        if step.along is None:
            return
        first, second = (self.sphere(name) for name in (step.first, step.second))
        speeds = (first.velocity, second.velocity)
        if number > 1 or (
            all(isinstance(speed, Expression) for speed in speeds) and any(map(letters, speeds))
        ):
            axis = step.along
            a, b = (
                self.settled(
                    Quantity("along", (Quantity("velocity", (Name(name),), None), axis)), number - 1
                )
                for name in (step.first, step.second)
            )
            side = (
                side_along(self, step, axis) if number > 1 else self.approach(first, second, axis)
            )
            nearer = Relation(((Link(a, "<" if side == -1 else ">", b),),))
            yield Fact(f"approach {number}", "geometry", nearer, None, step.place)

    def _within(self, step: Impact, number: int) -> Relation | None:
        """That a sphere comes to a wall between its ends, where that is along **i** or **j**."""
        wall = self.walls.get(step.second)
        if wall is None or not isinstance(wall.shape, Segment) or self.radius is not None:
            return None
        if not isinstance(self.sphere(step.first).position, Expression):
            return None
        match self.place_of(wall.start), self.place_of(wall.end):
            case Pair(a, b), Pair(c, d) if is_zero(difference(d, b)):
                ends, unit = (a, c), Unit("i")
            case Pair(a, b), Pair(c, d) if is_zero(difference(c, a)):
                ends, unit = (b, d), Unit("j")
            case _:
                return None
        side = self.sign(Binary("-", ends[1], ends[0]))
        if side is None:
            return None
        low, high = ends if side > 0 else ends[::-1]
        place = Quantity("along", (Quantity("position", (Name(step.first),), number), unit))
        return Relation(((Link(low, "<", place), Link(place, "<", high)),))

    def _off_the_wall(self, body: str, part: str, wall: Expression) -> Expression | None:
        """The coordinate of a centre at a wall: its radius away on the side where it begins."""
        sphere = self.sphere(body)
        if self.radius is None:
            return wall
        if not isinstance(sphere.position, Pair) or not isinstance(self.radius, Expression):
            return None
        side = self.sign(Binary("-", getattr(sphere.position, part), wall))
        if side is None:
            return None
        if is_zero(wall):
            return self.radius if side > 0 else Negate(self.radius)
        return Binary("+" if side > 0 else "-", wall, self.radius)

    def _beside_it(self, step: Impact, number: int) -> Expression | None:
        """Where the first centre is, by that of the second: in one place, or two radii away."""
        theirs = Quantity("position", (Name(step.second),), number)
        first, second = (self.sphere(name) for name in (step.first, step.second))
        if self.radius is None:
            return theirs
        met = {body for event in self.events[: number - 1] for body in event.bodies}
        places = [sphere.position for sphere in (first, second)]
        if met & {first.name, second.name} and axis_of_all(self) is None:
            return None
        axis = unsigned(step.along)
        if axis not in (Unit("i"), Unit("j")):
            return self._beside_on_a_slant(step, theirs, places)
        side = side_along(self, step, axis)
        if side is None:
            return None
        apart = Binary("*", Binary("*", Number(Fraction(2)), self.radius), axis)
        return Binary("-" if side > 0 else "+", theirs, apart)

    def _beside_on_a_slant(
        self, step: Impact, theirs: Expression, places: Sequence[object]
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
        match places:
            case [Pair() as first, Pair() as second] if self.radius is not None:
                pass
            case _:
                return None
        displacement = Pair(difference(second.x, first.x), difference(second.y, first.y))
        side = self.sign(Quantity("dot", (displacement, unit)))
        if side is None:
            return None
        apart = Binary("*", Binary("*", Number(Fraction(2)), self.radius), unit)
        return Binary("-" if side > 0 else "+", theirs, apart)

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
            sphere.name == name and is_rest(sphere.velocity) for sphere in self.problem.spheres
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
                    along = negated(along)
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
                normal = self.into_the_wall(step, number)
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
        velocities = [self.sphere(name).velocity for name in (step.first, step.second)]
        directions = [
            velocity for velocity in (step.along, *velocities) if isinstance(velocity, Expression)
        ]
        nodes = (node for tree in directions for node in walk(tree))
        if len(directions) != 3 or any(isinstance(node, Letter | Polar) for node in nodes):
            return False
        world = world_of(self.problem)
        centres, *both = (world.value(direction) for direction in directions)
        if not isinstance(centres, Plane) or not any(isinstance(value, Plane) for value in both):
            return False
        # Who is at rest has 0 for its velocity.
        first, second = (
            dot(world, centres, value) if isinstance(value, Plane) else value for value in both
        )
        approach = first - second
        if not (approach.above.is_ground and approach.below.is_ground) or approach.vanishes:
            return False
        return bool(approach.above.LC / approach.below.LC < 0)

    def _touching(self, step: Impact) -> Expression | None:
        """Both radii of spheres that begin at places, where nothing else tells how they meet."""
        first, second = (self.sphere(name) for name in (step.first, step.second))
        placed = all(isinstance(sphere.position, Expression) for sphere in (first, second))
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
            settled(Quantity("velocity", (Name(name),), number - 1), self.events)
            for name in (step.first, step.second)
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
            self.side_of_circle(step.first, wall),
            self.from_centre(step.first, wall, number),
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
        velocity = Quantity("velocity", (Name(step.first),), number - 1)
        towards = settled(Quantity("dot", (velocity, radius_vector)), self.events)
        zero = Number(Fraction(0))
        yield self._fact(f"towards {number}", towards, zero, step.place, ">", "geometry")
        if side < 0:
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
        if not is_rest(second.velocity):
            if not isinstance(second.velocity, Expression):
                return None
            path = Binary("-", path, second.velocity)
        both = Binary("*", Number(Fraction(2)), self.radius)
        angle = Apply("arcsin", Binary("/", step.offset, both))
        return Polar(Number(Fraction(1)), angle, path)

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
                    kind: FactKind = "range" if _is_range(own) else "given"
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
                trees = [degrees_worked_out(self.settled(e, events)) for e in operands]
                if set(operators) == {"="} and _are_of_one_value(trees):
                    yield from ((Link(letter, "=", trees[-1]),) for letter in trees[:-1])
                    return
                for left, sign, right in zip(trees, operators, trees[1:], strict=False):
                    yield (Link(left, sign, right),)
            case Aligned(left, how, right):
                a, b = (self.settled(tree, events) for tree in (left, right))
                if how == "opposite to":
                    b = Negate(b)
                sign_: Sign = "perpendicular to" if how == "perpendicular to" else "parallel to"
                yield (Link(self._direction(a, events), sign_, self._direction(b, events)),)
            case Meets():
                link = separation(self, relation, events)
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
            self._direction(self.settled(side, events), events)
            for side in (relation.left, relation.right)
        )
        b = self._axis_of(b) or b
        if isinstance(b, Negate) and isinstance(b.operand, Unit):
            b, sign = b.operand, ">" if sign == "<" else "<"
        left = Quantity("along" if isinstance(b, Unit) else "dot", (a, b))
        return Link(left, sign, Number(Fraction(0)))

    def _axis_of(self, tree: Expression) -> Expression | None:
        """**i** or **j**, or the opposite, where a velocity of the data is in that direction."""
        match tree:
            case Quantity("velocity", (Name(body),), 0):
                return self.axis_of(self.sphere(body).velocity)
        return None

    def _direction(self, tree: Expression, events: int) -> Expression:
        """The velocity of a sphere, and a wall, where its name stands for a direction."""
        if is_quantity(tree, "direction") and self._is_wall(tree):
            return tree.arguments[0]
        if isinstance(tree, Name) and tree.name not in self.walls:
            return self.settled(Quantity("velocity", (tree,), None), events)
        return tree

    def settled(self, tree: Expression, events: int) -> Expression:
        """A tree with the stage that *now* and *before* mean after some events."""
        if not has_quantity(tree):
            return tree

        def change(tree: Expression) -> Expression:
            if not isinstance(tree, Quantity) or tree.kind not in _STAGED:
                return tree
            if (tree.kind, tree.arguments) == ("energy", ()):
                tree = replace(tree, arguments=self._with_energies)
            if tree.stage is None and tree.kind == "direction" and self._is_wall(tree):
                return tree
            if tree.stage not in (None, "before"):
                return tree
            if tree.kind == "distance" and not self._is_between_bodies(tree):
                return tree
            bodies = [a.name for a in tree.arguments if isinstance(a, Name)]
            latest = self.latest(bodies, events)
            if tree.stage == "before":
                return replace(tree, stage=max(0, latest - 1))
            stage = latest if tree.kind in _OF_AN_EVENT else events
            return replace(tree, stage=stage)

        return settled(rebuilt(tree, change), self.events)

    @cached_property
    def _with_energies(self) -> tuple[Expression, ...]:
        """The only sphere, where its own energies are spoken of: all energy is that."""
        own = (tree for whole in all_trees(self.problem) for tree in walk(whole))
        named = any(is_quantity(tree, "energy", "energy_lost") and tree.arguments for tree in own)
        spheres = self.problem.spheres
        return (Name(spheres[0].name),) if named and len(spheres) == 1 else ()

    def _is_between_bodies(self, tree: Quantity) -> bool:
        spheres = {sphere.name for sphere in self.problem.spheres}
        return any(
            isinstance(argument, Name) and argument.name in spheres for argument in tree.arguments
        )

    def _is_wall(self, tree: Quantity) -> bool:
        return any(isinstance(a, Name) and a.name in self.walls for a in tree.arguments)

    def _fact(
        self,
        name: str,
        left: Expression,
        right: Expression,
        place: Place | None,
        sign: Sign = "=",
        kind: FactKind = "data",
    ) -> Fact:
        relation = Relation(((Link(left, sign, settled(right, self.events)),),))
        return Fact(name, kind, relation, None, place)


def _between(step: Impact, number: int) -> Expression:
    """The way from the first centre to the second at an impact of two spheres."""
    first, second = (
        Quantity("position", (Name(name),), number) for name in (step.first, step.second)
    )
    return Binary("-", second, first)


def _is_range(relation: Relation) -> bool:
    """Whether a relation only bounds letters, or ratios of angles that are letters."""
    links = [link for option in relation.options for link in option]
    trees = [tree for link in links for side in (link.left, link.right) for tree in walk(side)]
    return all(link.sign in ("<", "<=", ">", ">=", "!=") for link in links) and not any(
        isinstance(tree, Quantity)
        or (isinstance(tree, Apply) and not is_function(tree, "sin", "cos", "tan"))
        for tree in trees
    )


def _is_unit(tree: Expression) -> bool:
    return isinstance(tree, Unit) or (isinstance(tree, Negate) and isinstance(tree.operand, Unit))


def _are_of_one_value(trees: Sequence[Expression]) -> bool:
    """Whether several letters have one value without letters: e = f = ½, for each of them."""
    *equal, value = trees
    plain = not letters(value) and not has_quantity(value)
    return len(equal) > 1 and plain and all(isinstance(tree, Letter) for tree in equal)
