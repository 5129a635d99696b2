"""Where the bodies and walls of a statement are, and what is plain of their sides and senses.

What is said of letters is proved by the oracle; where it is open, nothing is said.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType

from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.derivation import Event
from restitution.explaining.lines.quotients import CONSTANT, NotComparableError, Plane, Quotient
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Quantity,
    Unit,
    has_unit_vector,
    is_binary,
    is_rest,
    is_zero,
    negated,
    rational,
    walk,
)
from restitution.oracle import Formula, Oracle, compared
from restitution.problem import (
    Arrival,
    Compare,
    Given,
    Impact,
    Kick,
    Problem,
    Sphere,
    Wall,
    once_a_problem,
)
from restitution.solving.story.letters import roles

_PLAIN = 12
"""So many events may come before a velocity of which the direction is plain."""
_FEW_IMPACTS = 3
"""So many impacts of spheres may be worked out for it."""

_AXES: Mapping[Expression, Expression] = {
    Unit("i"): Unit("j"),
    Unit("j"): Negate(Unit("i")),
}


@once_a_problem
def events_of(problem: Problem) -> tuple[Event, ...]:
    """The events of a problem, in the order told."""
    walls = {wall.name for wall in problem.walls}
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


class Arrangement:
    """What a statement says of places and paths."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.events = events_of(problem)
        self.walls = {wall.name: wall for wall in problem.walls}
        self._normals: dict[int, Expression | None] = {}
        self._towards: dict[int, bool] = {}

    def along_of(self, wall: Wall) -> Expression | None:
        """The direction of a straight wall: as told, or from one end of it to the other."""
        if isinstance(wall.along, Expression):
            return wall.along
        ends = [self.place_of(end) for end in (wall.start, wall.end)]
        match ends:
            case [Pair(a, b), Pair(c, d)]:
                return Pair(difference(c, a), difference(d, b))
        return None

    def place_of(self, tree: object) -> Expression | None:
        """The coordinates of a point that is named or given."""
        if isinstance(tree, Name):
            points = {point.name: point.position for point in self.problem.points}
            return self.place_of(points.get(tree.name))
        return tree if isinstance(tree, Expression) else None

    def sphere(self, name: str) -> Sphere:
        """The sphere with a name."""
        return next(sphere for sphere in self.problem.spheres if sphere.name == name)

    @cached_property
    def radius(self) -> Expression | None:
        """The radius of all spheres; None where they are small."""
        radii = (sphere.radius for sphere in self.problem.spheres)
        return next((radius for radius in radii if isinstance(radius, Expression)), None)

    def latest(self, bodies: list[str], events: int) -> int:
        """The last event so far in which one of some bodies took part; of all, if there is none."""
        own = [
            e.number
            for e in self.events[:events]
            if not bodies or any(body in e.bodies for body in bodies)
        ]
        return max(own, default=0)

    # --- what is plain of letters -----------------------------------------------------------------

    def sign(self, tree: Expression) -> int | None:
        """The sign of an expression in letters, where it is plain."""
        world = world_of(self.problem)
        try:
            return self.sign_in(world, world.scalar(tree))
        except NotComparableError:
            return None

    def sign_in(self, world: World, value: Quotient) -> int | None:
        """The sign of a quotient of a world, where it is plain."""
        own = world.expression(value, world.roles)
        oracle = Oracle(world.roles, self.bounds_of_all)
        for sign in (1, -1):
            if oracle.proves(compared(sign * own, ">", 0)):
                return sign
        return None

    @cached_property
    def bounds_of_all(self) -> tuple[Formula, ...]:
        """The inequalities between letters that are given in front of all parts."""
        world = world_of(self.problem)
        steps = [step for step in self.problem.parts[0].steps if isinstance(step, Given)]
        own: list[Formula] = []
        for relation in (relation for step in steps for relation in step.relations):
            match relation:
                case Compare(operands, operators) if set(operators) <= {"<", "<=", ">", ">="}:
                    pass
                case _:
                    continue
            if any(isinstance(node, Quantity) for operand in operands for node in walk(operand)):
                continue
            try:
                values = [world.expression(world.scalar(e), world.roles) for e in operands]
            except NotComparableError:
                continue
            for left, sign, right in zip(values, operators, values[1:], strict=False):
                own.append(compared(left, sign, right))
        return tuple(own)

    def world(self) -> World:
        """The letters of the statement, and the directions of its walls."""
        directions: dict[Expression, Expression] = {}
        for wall in self.problem.walls:
            along = self.along_of(wall)
            if along is not None:
                directions[Quantity("direction", (Name(wall.name),))] = along
        return world_of(self.problem, directions)

    def point(self, tree: object, world: World) -> Plane | None:
        """A place that is named or given, in a world; None where it is not told."""
        place = self.place_of(tree)
        value = None if place is None else world.value(place)
        return value if isinstance(value, Plane) else None

    def axis_of(self, velocity: object) -> Expression | None:
        """**i** or **j**, or the opposite, where a velocity of the data is in that direction."""
        world = self.world()
        value = world.value(velocity) if isinstance(velocity, Expression) else None
        if not isinstance(value, Plane) or value.x.vanishes == value.y.vanishes:
            return None
        axis = Unit("i" if value.y.vanishes else "j")
        side = self.sign_in(world, value.x if value.y.vanishes else value.y)
        return None if side is None else axis if side > 0 else Negate(axis)

    # --- circular walls ---------------------------------------------------------------------------

    def from_centre(self, body: str, wall: Wall, number: int) -> Expression | None:
        """The way from the centre of a circular wall to a body, at an event."""
        centre = self.place_of(wall.centre)
        if not isinstance(centre, Pair):
            return None
        own = Quantity("position", (Name(body),), number)
        at_origin = is_zero(centre.x) and is_zero(centre.y)
        return own if at_origin else Binary("-", own, centre)

    def distance_to_centre(self, body: str, wall: Wall) -> Expression | None:
        """How far from the centre of a circular wall a body is when it touches it."""
        radius = self.radius
        if radius is None:
            return wall.radius if isinstance(wall.radius, Expression) else None
        side = self.side_of_circle(body, wall)
        if side is None or not isinstance(radius, Expression):
            return None
        whole = Binary("+" if side > 0 else "-", wall.radius, radius)
        if isinstance(wall.radius, Number) and isinstance(radius, Number):
            return rational(wall.radius.value + side * radius.value)
        return whole

    def side_of_circle(self, body: str, wall: Wall) -> int | None:
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
        side = self.sign(gap)
        if side is None:
            world = world_of(self.problem)
            inside = world.scalar(gap).vanishes or self._goes_outward(body, wall, radius_vector)
            return -1 if inside else None
        return side

    def _goes_outward(self, body: str, wall: Wall, radius_vector: Expression) -> bool:
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
        return world_of(self.problem).scalar(outward).vanishes or self.sign(outward) == 1

    # --- straight walls, and velocities on the way ------------------------------------------------

    def into_the_wall(self, step: Impact, number: int) -> Expression | None:
        """A direction perpendicular to a straight wall: towards it, as far as that is plain."""
        # A velocity rests on all walls on the way, and each of them on the velocity before it.
        if number not in self._normals:
            self._normals[number] = self._normal_into(step, number)
        return self._normals[number]

    def _normal_into(self, step: Impact, number: int) -> Expression | None:
        along = self.along_of(self.walls[step.second])
        if along is None:
            return None
        left = turned(along)
        if left is None:
            left = self._turned_angle(along)
        if left is None:
            return None
        return opposite(left) if self._leads_away(step, number, left, along) else left

    def is_towards(self, step: Impact, number: int) -> bool | None:
        """Whether it is plain of itself that a body moves towards the wall that it hits.

        False where it may move along it too, as with a coefficient that is 0; None if it is open.
        """
        self.into_the_wall(step, number)
        return self._towards.get(number)

    def _turned_angle(self, along: Expression) -> Expression | None:
        """A direction that is told by its angle, turned by +90°."""
        if not world_of(self.problem).is_angle(along):
            return None
        if isinstance(along, Degrees):
            return Degrees(along.value + RIGHT_ANGLE.value)
        return Binary("+", along, RIGHT_ANGLE)

    def _leads_away(self, step: Impact, number: int, normal: Expression, along: Expression) -> bool:
        """Whether a velocity before an event, where it is plain, is against a direction.

        Where it is open, places tell it. Without them the other direction is taken if the body
        goes that way along the wall, or at the start if that is open too: the component that stays
        is then positive.
        """
        if number > _PLAIN:
            return False
        world, by_places = self.world(), self._is_placed_beyond(step, normal)
        try:
            velocity, axis = (
                self.velocity_before(step.first, number, world, through_spheres=True),
                world.direction(normal),
            )
            if velocity is None or axis is None:
                return by_places or False
            value = world.expression(dot(world, velocity, axis), world.roles)
            wall = world.direction(along)
            ahead = (
                None if wall is None else world.expression(dot(world, velocity, wall), world.roles)
            )
        except NotComparableError:
            return by_places or False
        oracle = Oracle(world.roles, self.bounds_of_all)
        onward = oracle.decide(compared(value, ">=", 0)).answer
        if oracle.proves(compared(value, "<=", 0)):
            self._towards[number] = oracle.proves(compared(value, "<", 0))
            return onward != "proved"
        if onward == "proved":
            self._towards[number] = oracle.proves(compared(value, ">", 0))
            return False
        if by_places is not None:
            return by_places
        is_open = onward == "refuted" and ahead is not None
        if number > 1:
            return is_open and oracle.proves(compared(ahead, ">", 0))
        return is_open and not oracle.proves(compared(ahead, "<", 0))

    def _is_placed_beyond(self, step: Impact, normal: Expression) -> bool | None:
        """Whether a body begins where the normal of a wall leads to; None where it is not told."""
        side = self.side_of_wall(step.first, self.walls[step.second], normal)
        return None if side is None else side == -1

    def side_of_wall(self, body: str, wall: Wall, normal: Expression) -> int | None:
        """1 where a normal leads from where a body begins to a straight wall, −1 away from it."""
        place, world = self.place_of(self.sphere(body).position), self.world()
        point = self.place_of(wall.through) or self.place_of(wall.start)
        if not isinstance(place, Pair) or not isinstance(point, Pair):
            return None
        displacement = Pair(difference(point.x, place.x), difference(point.y, place.y))
        try:
            vector, axis = world.value(displacement), world.direction(normal)
            if not isinstance(vector, Plane) or axis is None:
                return None
            return self.sign_in(world, dot(world, vector, axis))
        except NotComparableError:
            return None

    def velocity_before(
        self, body: str, number: int, world: World, *, through_spheres: bool = False
    ) -> Plane | None:
        """The velocity before an event: the one given, changed by walls and blows on the way.

        None where another sphere comes in between, unless impacts of which the line of centres is
        told are worked out too, ``through_spheres``.
        """
        given = self.sphere(body).velocity
        value = world.value(given) if isinstance(given, Expression) else None
        for event, step in enumerate(self.problem.events, 1):
            if event == number or not isinstance(value, Plane):
                break
            if body not in self.events[event - 1].bodies or isinstance(step, Arrival):
                continue
            if isinstance(step, Impact) and not self.events[event - 1].wall and through_spheres:
                value = self._after_spheres(step, event, body, value, world)
                continue
            if isinstance(step, Kick):
                push = world.value(step.impulse)
                mass = next(sphere.mass for sphere in self.problem.spheres if sphere.name == body)
                if not isinstance(push, Plane) or not isinstance(mass, Expression):
                    return None
                share = world.scalar(mass)
                value = Plane(value.x + push.x / share, value.y + push.y / share)
                continue
            normal = self.into_the_wall(step, event) if self.events[event - 1].wall else None
            axis = None if normal is None else world.direction(normal)
            if axis is None:
                return None
            e = world.scalar(Letter("e") if step.e is None else step.e)
            factor = (CONSTANT(1) + e) * dot(world, value, axis) / dot(world, axis, axis)
            value = Plane(value.x - factor * axis.x, value.y - factor * axis.y)
        return value if isinstance(value, Plane) else None

    def _after_spheres(
        self, step: Impact, number: int, body: str, velocity: Plane, world: World
    ) -> Plane | None:
        """A velocity after an impact with another sphere; None of a line that is not told."""
        other = step.second if body == step.first else step.first
        early = sum(not event.wall for event in self.events[: number - 1])
        theirs = None
        if early < _FEW_IMPACTS:
            theirs = self.velocity_before(other, number, world, through_spheres=True)
        axis = None if step.along is None else world.direction(step.along)
        masses = [self.sphere(name).mass for name in (body, other)]
        if theirs is None or axis is None:
            return None
        own, against = (world.scalar(e) if isinstance(e, Expression) else None for e in masses)
        if own is None or against is None:
            return None
        e = world.scalar(Letter("e") if step.e is None else step.e)
        relative = Plane(theirs.x - velocity.x, theirs.y - velocity.y)
        share = (CONSTANT(1) + e) * against / (own + against)
        factor = share * dot(world, relative, axis) / dot(world, axis, axis)
        return Plane(velocity.x + factor * axis.x, velocity.y + factor * axis.y)

    def approach(self, first: Sphere, second: Sphere, axis: Expression) -> int | None:
        """In which sense of an axis the first sphere comes nearer to the second at the start."""
        paces = [
            Number(Fraction(0)) if is_rest(sphere.velocity) else sphere.velocity
            for sphere in (first, second)
        ]
        if not all(isinstance(pace, Expression) for pace in paces):
            return None
        a, b = (Quantity("dot", (pace, axis)) if not is_zero(pace) else pace for pace in paces)
        return self.sign(Binary("-", a, b))


def world_of(
    problem: Problem, directions: Mapping[Expression, Expression] = MappingProxyType({})
) -> World:
    """The letters of a statement, to compare trees in."""
    known = roles(problem)
    angles = frozenset(name for name, role in known.items() if role.kind == "angle")
    return World(known, angles=angles, directions=directions)


def difference(a: Expression, b: Expression) -> Expression:
    """One coordinate less another, worked out where it is plain."""
    if a == b:
        return Number(Fraction(0))
    if isinstance(a, Number) and isinstance(b, Number):
        return rational(a.value - b.value)
    return a if is_zero(b) else Negate(b) if is_zero(a) else Binary("-", a, b)


def turned(along: Expression) -> Expression | None:
    """A direction turned by +90°."""
    if along in _AXES:
        return _AXES[along]
    match along:
        case Negate(operand):
            other = turned(operand)
            return None if other is None else opposite(other)
        case Pair(x, y):
            return Pair(opposite(y), x)
        case Binary("+" | "-" as op, left, right):
            a, b = turned(left), turned(right)
            if a is None or b is None:
                return None
            return _sum_of(a, b if op == "+" else negated(b))
        case Binary("*", left, right):
            b = turned(right)
            if b is None:
                return None
            if isinstance(b, Negate):
                return Negate(Binary("*", left, b.operand))
            return Binary("*", left, b)
    return None


def opposite(tree: Expression) -> Expression:
    """A direction turned round."""
    if isinstance(tree, Degrees):
        return Degrees((tree.value + 180) % 360)
    if isinstance(tree, Binary) and tree.right == RIGHT_ANGLE:
        return Binary("-" if tree.op == "+" else "+", tree.left, tree.right)
    if is_binary(tree, "+", "-") and has_unit_vector(tree):
        return _sum_of(negated(tree.left), tree.right if tree.op == "-" else negated(tree.right))
    if is_binary(tree, "-"):
        return Binary("-", tree.right, tree.left)
    return negated(tree)


def _sum_of(one: Expression, other: Expression) -> Expression:
    """A sum of multiples of **i** and **j**, with **i** first and one sign between both."""
    if Unit("i") in walk(other):
        one, other = other, one
    match other:
        case Negate(operand):
            return Binary("-", one, operand)
    return Binary("+", one, other)


def dot(world: World, a: Plane, b: Plane) -> Quotient:
    """The scalar product of two vectors of a world."""
    return world.reduced(a.x * b.x + a.y * b.y)
