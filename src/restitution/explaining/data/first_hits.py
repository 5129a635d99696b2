"""That a sphere will hit a wall, or will not: a fact of its velocity, and of its place there."""

from __future__ import annotations

from fractions import Fraction
from functools import partial, reduce
from math import gcd

from restitution.explaining.data.arrangement import Arrangement, dot, opposite, turned
from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.derivation import FLIPPED, Link, Relation, Sign
from restitution.explaining.lines.quotients import NotComparableError, Plane
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
    Quantity,
    Unit,
    is_function,
    is_rest,
    is_zero,
    rational,
)
from restitution.problem import Arrival, Event, Impact, Meets, Wall
from restitution.shapes import Circle, Segment

_ZERO = Number(Fraction(0))


def hits(arrangement: Arrangement, relation: Meets, events: int) -> Relation | None:
    """What it says of a sphere that it will hit a wall, or that it will not.

    It moves towards the wall; and between two ends its path comes to the line of the wall between
    them. None where the places do not make plain on which side it is, or where a wall with ends is
    concerned and it is open whether it moves towards that. With places the wall is along **i** or
    **j**.
    """
    ahead = _Ahead.of(arrangement, relation, events)
    if ahead is None:
        return _towards_an_unplaced_wall(arrangement, relation, events)
    if not isinstance(ahead.wall.shape, Segment):
        return None if ahead.is_nearing else ahead.towards(relation.happens)
    return ahead.between(relation.happens) if ahead.is_nearing else None


def _towards_an_unplaced_wall(
    arrangement: Arrangement, relation: Meets, events: int
) -> Relation | None:
    """That a component is towards a straight wall, where the wall or the sphere has no place.

    Such a wall lies ahead of the sphere as that moves at the start. None where this is open, where
    places tell more, or where a sphere has struck the wall before.
    """
    names = [relation.first.name, relation.second.name]
    walls = [name for name in names if name in arrangement.walls]
    if relation.again or len(walls) != 1:
        return None
    (body,) = (name for name in names if name not in walls)
    wall = arrangement.walls[walls[0]]
    along = arrangement.along_of(wall)
    if isinstance(wall.shape, Circle) or along is None:
        return None
    if wall.shape.is_placed and arrangement.sphere(body).position is not None:
        return None
    if any(wall.name in event.bodies for event in arrangement.events[:events]):
        return None
    axis = _across(arrangement, along)
    if axis is None:
        return None
    side = _side_at_the_start(arrangement, body, axis)
    if side is None:
        return None
    sign: Sign = ">" if relation.happens else "<="
    if isinstance(axis, Negate) and isinstance(axis.operand, Unit):
        axis, side = axis.operand, -side
    if side < 0:
        axis, sign = (axis, FLIPPED[sign]) if isinstance(axis, Unit) else (opposite(axis), sign)
    velocity = Quantity("velocity", (Name(body),), arrangement.latest([body], events))
    return Relation(((Link(Quantity("along", (velocity, axis)), sign, _ZERO),),))


def _across(arrangement: Arrangement, along: Expression) -> Expression | None:
    """A direction perpendicular to a straight wall; of one told by its angle by sine and cosine."""
    if not arrangement.world().is_angle(along):
        across = turned(along)
        return _in_units(across, arrangement) if isinstance(across, Pair) else across
    i, j = Unit("i"), Unit("j")
    match along:
        case Degrees(value) if value % 180 in (45, 135):
            return Binary("-" if value % 180 == 45 else "+", i, j)
        case Degrees(value) if 90 < value < 180:
            acute = Degrees(180 - value)
            return Binary(
                "+",
                Binary("*", Apply("sin", acute), i),
                Binary("*", Apply("cos", acute), j),
            )
    sine, cosine = Apply("sin", along), Apply("cos", along)
    return Binary("-", Binary("*", sine, i), Binary("*", cosine, j))


def _in_units(direction: Pair, arrangement: Arrangement) -> Expression:
    """A direction in **i** and **j**, without the factors that both of its coordinates have."""
    if is_zero(direction.x) or is_zero(direction.y):
        return direction
    roles = arrangement.world().roles
    (first, ours), (second, theirs) = map(_factors, (direction.x, direction.y))
    for factor in list(ours):
        positive = isinstance(factor, Letter) and roles[factor.name].kind == "positive"
        if factor in theirs and (positive or is_function(factor, "sqrt")):
            ours.remove(factor)
            theirs.remove(factor)
    common = Fraction(
        gcd(first.numerator * second.denominator, second.numerator * first.denominator),
        first.denominator * second.denominator,
    )
    across, upward = (
        _product(abs(number) / common, [*factors, unit])
        for number, factors, unit in ((first, ours, Unit("i")), (second, theirs, Unit("j")))
    )
    return Binary("-" if second < 0 else "+", Negate(across) if first < 0 else across, upward)


def _factors(tree: Expression) -> tuple[Fraction, list[Expression]]:
    """A coordinate as a number, not zero, and what that is multiplied by."""
    match tree:
        case Number(value):
            return value, []
        case Negate(operand):
            number, factors = _factors(operand)
            return -number, factors
        case Binary("*", left, right):
            (one, ours), (other, theirs) = _factors(left), _factors(right)
            return one * other, ours + theirs
    return Fraction(1), [tree]


def _product(number: Fraction, factors: list[Expression]) -> Expression:
    return reduce(partial(Binary, "*"), factors if number == 1 else [rational(number), *factors])


def _side_at_the_start(arrangement: Arrangement, body: str, axis: Expression) -> int | None:
    """1 where a sphere first moves in the direction of an axis, −1 against it; None if open."""
    given, world = arrangement.sphere(body).velocity, arrangement.world()
    try:
        velocity = world.value(given) if isinstance(given, Expression) else None
        direction = world.direction(axis)
        if direction is None or not isinstance(velocity, Plane):
            return None
        return arrangement.sign_in(world, dot(world, velocity, direction))
    except NotComparableError:
        return None


class _Ahead:
    """A sphere and a wall that it may come to next."""

    def __init__(
        self,
        arrangement: Arrangement,
        body: str,
        wall: Wall,
        events: int,
        place: tuple[World, Plane],
    ) -> None:
        self.arrangement, self.body, self.wall, self.events = arrangement, body, wall, events
        self.stage = arrangement.latest([body], events)
        self.horizontal = _is_level(arrangement.along_of(wall))
        self.world, self.place = place

    @classmethod
    def of(cls, arrangement: Arrangement, relation: Meets, events: int) -> _Ahead | None:
        """The pair that a relation names; None where no place tells how they lie."""
        names = [relation.first.name, relation.second.name]
        walls = [name for name in names if name in arrangement.walls]
        if relation.again or len(walls) != 1 or arrangement.radius is not None:
            return None
        (body,) = (name for name in names if name not in walls)
        wall = arrangement.walls[walls[0]]
        along = arrangement.along_of(wall)
        if isinstance(wall.shape, Circle) or along is None:
            return None
        if not (_is_level(along) or _is_upright(along)):
            return None
        if any({body, wall.name} == set(event.bodies) for event in arrangement.events[:events]):
            return None
        world = arrangement.world()
        place = _Path(arrangement, body, events, world).place()
        through = arrangement.place_of(wall.shape.point)
        if place is None or not isinstance(through, Pair):
            return None
        return cls(arrangement, body, wall, events, (world, place))

    @property
    def _level(self) -> Expression:
        """The coordinate that all points of the wall have."""
        point = self.arrangement.place_of(self.wall.shape.point)
        assert isinstance(point, Pair)
        return point.y if self.horizontal else point.x

    @property
    def _across(self) -> Unit:
        return Unit("j" if self.horizontal else "i")

    @property
    def side(self) -> int | None:
        """1 where the wall lies ahead in the direction of **i** or **j**, −1 behind."""
        own = self.place.y if self.horizontal else self.place.x
        gap = self.world.scalar(self._level) - own
        side: int | None = self.arrangement.sign_in(self.world, gap)
        return side

    @property
    def is_nearing(self) -> bool:
        """Whether it is plain that the sphere moves towards the wall."""
        velocity = self.arrangement.velocity_before(self.body, self.events + 1, self.world)
        side = self.side
        if velocity is None or side is None:
            return False
        pace = velocity.y if self.horizontal else velocity.x
        return bool(self.arrangement.sign_in(self.world, pace) == side)

    def _component(self, unit: Unit) -> Quantity:
        velocity = Quantity("velocity", (Name(self.body),), self.stage)
        return Quantity("along", (velocity, unit))

    def _coordinate(self, unit: Unit) -> Expression:
        """A coordinate at the last event of the sphere, or where it begins."""
        if self.stage:
            return Quantity("along", (Quantity("position", (Name(self.body),), self.stage), unit))
        start = self.arrangement.place_of(self.arrangement.sphere(self.body).position)
        assert isinstance(start, Pair)
        return start.x if unit.axis == "i" else start.y

    def towards(self, happens: bool) -> Relation | None:
        """That its component across the wall is towards the wall."""
        if self.side is None:
            return None
        ahead, away = (">", "<=") if self.side > 0 else ("<", ">=")
        link = Link(self._component(self._across), ahead if happens else away, _ZERO)  # type: ignore[arg-type]
        return Relation(((link,),))

    def between(self, happens: bool) -> Relation | None:
        """That its path comes to the line of the wall between both ends, or does not."""
        first, last = (self.arrangement.place_of(end) for end in (self.wall.start, self.wall.end))
        assert isinstance(first, Pair)
        assert isinstance(last, Pair)
        ends = (first.x, last.x) if self.horizontal else (first.y, last.y)
        order = self.arrangement.sign_in(
            self.world, self.world.scalar(Binary("-", ends[1], ends[0]))
        )
        if order is None:
            return None
        low, high = ends if order > 0 else ends[::-1]
        across, beside = self._across, Unit("i" if self.horizontal else "j")
        distance = Binary("-", self._level, self._coordinate(across))
        slope = Binary("/", self._component(beside), self._component(across))
        there = Binary("+", self._coordinate(beside), Binary("*", distance, slope))
        if happens:
            return Relation(((Link(low, "<", there), Link(there, "<", high)),))
        return Relation(((Link(there, "<=", low),), (Link(there, ">=", high),)))


class _Path:
    """Where a sphere is after some events, as far as walls and points tell."""

    def __init__(self, arrangement: Arrangement, body: str, events: int, world: World) -> None:
        self.arrangement, self.body, self.events, self.world = arrangement, body, events, world

    def place(self) -> Plane | None:
        """Its place at its last event; None where that is not told."""
        place = self._point(self.arrangement.sphere(self.body).position)
        for number, step in enumerate(self.arrangement.problem.events[: self.events], 1):
            if place is not None and self.body in self.arrangement.events[number - 1].bodies:
                place = self._after(number, step, place)
        return place

    def _point(self, tree: object) -> Plane | None:
        return self.arrangement.point(tree, self.world)

    def _after(self, number: int, step: Event, place: Plane) -> Plane | None:
        match step:
            case Arrival(target=target) if not self._is_wall(target):
                return self._point(target)
            case Arrival(target=Name(name)):
                return self._at(number, self.arrangement.walls[name], place)
            case Impact(second=second) if second in self.arrangement.walls:
                return self._at(number, self.arrangement.walls[second], place)
            case Impact(first=first, second=second) if first == self.body:
                return _Path(self.arrangement, second, number, self.world).resting()
            case Impact() if _Path(self.arrangement, self.body, number, self.world).resting():
                return place
        return None

    def resting(self) -> Plane | None:
        """The place of a sphere that is at rest there until its first event."""
        sphere = self.arrangement.sphere(self.body)
        met = any(self.body in event.bodies for event in self.arrangement.events[: self.events - 1])
        return self._point(sphere.position) if is_rest(sphere.velocity) and not met else None

    def _is_wall(self, target: object) -> bool:
        return isinstance(target, Name) and target.name in self.arrangement.walls

    def _at(self, number: int, wall: Wall, place: Plane) -> Plane | None:
        """The place where the path comes to the line of a wall along **i** or **j**."""
        point = self._point(wall.shape.point)
        along = self.arrangement.along_of(wall)
        velocity = self.arrangement.velocity_before(self.body, number, self.world)
        if point is None or along is None or velocity is None:
            return None
        if _is_level(along) and not velocity.y.vanishes:
            shift = (point.y - place.y) / velocity.y
        elif _is_upright(along) and not velocity.x.vanishes:
            shift = (point.x - place.x) / velocity.x
        else:
            return None
        return Plane(place.x + shift * velocity.x, place.y + shift * velocity.y)


def _is_level(along: Expression | None) -> bool:
    return along == Unit("i") or (isinstance(along, Pair) and is_zero(along.y))


def _is_upright(along: Expression | None) -> bool:
    return along == Unit("j") or (isinstance(along, Pair) and is_zero(along.x))
