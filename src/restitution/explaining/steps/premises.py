"""What a line cites, and the world that it makes: directions and angles that are given."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from typing import TypeGuard

import sympy as sp

from restitution.explaining.data.offset_angles import named_angles
from restitution.explaining.data.setting import Cited, Known, Setting, is_angle, is_direction
from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.angles import Identity
from restitution.explaining.lines.derivation import Link, Meaning, Move, Relation, whole_of
from restitution.expression.tree import (
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
    letters,
    unsigned,
    walk,
)
from restitution.oracle import Oracle, compared
from restitution.records import dataclass

POSITIVE_KINDS = ("speed", "mass")


def _runs_forward(tree: Expression) -> bool:
    """Whether a tree is the time of an event, or that from one event to a later one."""
    match tree:
        case Quantity("time", (), int(number)):
            return number > 0
        case Binary("-", Quantity("time", (), int(late)), Quantity("time", (), int(early))):
            return late > early
    return False


def _factors(tree: Expression) -> Iterator[Expression]:
    """The factors of a product or a quotient."""
    match tree:
        case Binary("*" | "/", left, right):
            yield from _factors(left)
            yield from _factors(right)
        case _:
            yield tree


def _is_a_wall(line: Expression) -> TypeGuard[Quantity]:
    """Whether a direction is that of a wall."""
    match line:
        case Quantity("direction", (Name(),), None):
            return True
    return False


@dataclass
class Premises:
    """What a line cites: its links, letters, directions and angles, and the world they make."""

    setting: Setting
    move: Move
    cited: tuple[Cited, ...]
    known: tuple[Known, ...]
    opaque: frozenset[Expression] = frozenset()
    identities: frozenset[Identity] = frozenset()
    base: Expression | None = None
    """A direction told by its angle, along which vectors are resolved instead of **i**."""

    # --- the world of what is cited -------------------------------------------------------------

    @cached_property
    def links(self) -> list[Link]:
        """The relations that are cited without alternatives."""
        return [
            link
            for premise in self.cited
            if isinstance(premise.relation, Relation) and len(premise.relation.options) == 1
            for link in premise.relation.only
        ]

    @cached_property
    def lets(self) -> list[Meaning]:
        """The meanings that are cited."""
        return [premise.relation for premise in self.cited if isinstance(premise.relation, Meaning)]

    @cached_property
    def world(self) -> World:
        """The generators, with the directions and the angles that are cited."""
        world = World(
            self.setting.roles,
            vectors=self.setting.vectors,
            angles=self.setting.angles,
            directions=_without_circles(self._directions()),
            identities=self.identities,
            opaque=self.opaque,
            base=self.base,
            nonnegative=frozenset(self._nonnegative()),
        )
        world.turns = _without_circles(self._turns(world))
        for link in self._inequalities():
            less, greater = (world.value(side) for side in (link.left, link.right))
            world.put_in_order(*((less, greater) if link.sign[0] == "<" else (greater, less)))
        return world

    def _inequalities(self) -> Iterator[Link]:
        """The inequalities between expressions of letters that are cited."""
        known = (premise.relation for premise in self.known if len(premise.relation.options) == 1)
        for link in (*self.links, *(link for relation in known for link in relation.only)):
            plain = not any(
                isinstance(e, Quantity) for s in (link.left, link.right) for e in walk(s)
            )
            if link.sign in ("<", "<=", ">", ">=") and plain:
                yield link

    def _nonnegative(self) -> Iterator[str]:
        """The letters that are cited as not negative, and the angles up to 90° that are cited.

        A mass or a speed for which a line has a letter is none that is negative either.
        """
        for name, meaning in self.setting.meanings.items():
            if isinstance(meaning.quantity, Quantity) and meaning.quantity.kind in POSITIVE_KINDS:
                yield name
        for premise in self.known:
            for name in premise.letters:
                role = self.setting.role(name)
                if role.kind != "angle" or role.low is None or role.high is None:
                    continue
                if role.low >= 0 and role.high <= sp.pi / 2:
                    yield name
            for links in premise.relation.options:
                for link in links:
                    match link:
                        case Link(Letter(name), ">" | ">=", Number(0)):
                            yield name
                        case Link(Number(0), "<" | "<=", Letter(name)):
                            yield name
        for own in self.cited:
            if isinstance(own.relation, Relation) and len(own.relation.options) == 1:
                yield from self._by_a_time(whole_of(own.relation.only))

    def _by_a_time(self, link: Link | None) -> Iterator[str]:
        """The one letter of a time that may be of either sign: no time is before the clock starts.

        Nor is an event before one that is told before it. All else in the time has to be positive.
        """
        match link:
            case Link(left, "=", right) if _runs_forward(left):
                factors = list(_factors(right))
                open_ = [
                    factor.name
                    for factor in factors
                    if isinstance(factor, Letter)
                    and self.setting.role(factor.name).kind != "positive"
                ]
                if len(open_) == 1 and all(map(self._is_no_loss, factors)):
                    yield open_[0]

    def _is_no_loss(self, factor: Expression) -> bool:
        """Whether a factor of a time is a letter or a number, or a sum that is plainly positive."""
        match factor:
            case Binary("+", Number(value), Letter(name)) if value > 0:
                role = self.setting.role(name)
                cited = any(name in premise.letters for premise in self.known)
                return cited and role.low is not None and bool(role.low >= 0)
        return isinstance(factor, Letter | Number)

    def _directions(self) -> Iterator[tuple[Expression, Expression]]:
        for meaning in self.lets:
            if meaning.vector:
                yield from self._axis_of(meaning.quantity)
                yield meaning.quantity, Letter(meaning.letter)
            elif meaning.angle == "acute":
                yield from self._on_one_side(meaning.quantity, Letter(meaning.letter))
        for link in self.links:
            if link.sign == "=":
                yield from self._axis_of(link.left)
                yield from self._on_one_side(link.left, link.right)
        for link in self.links:
            if link.sign not in ("=", "parallel to"):
                continue
            for left, right in ((link.left, link.right), (link.right, link.left)):
                if isinstance(left, Name) and link.sign == "parallel to":
                    left = Quantity("direction", (left,))
                if is_direction(left, self.setting) and left not in self.opaque:
                    yield left, right
                    break
        for meaning, own in named_angles(self.lets, self.links, self.setting):
            if own.axis not in self.opaque:
                yield own.axis, own.at(meaning.letter)

    def _axis_of(self, quantity: Expression) -> Iterator[tuple[Expression, Expression]]:
        """The line of centres by an impulse: on the second body along it, on the first against."""
        match quantity:
            case Quantity("impulse", (Name(body),), int(stage)):
                event = self.setting.event(stage)
                axis = Quantity("line_of_centres", (), stage)
                if event is not None and axis not in self.opaque:
                    yield axis, Negate(quantity) if body == event.bodies[0] else quantity

    def _on_one_side(
        self, angle: Expression, value: Expression
    ) -> Iterator[tuple[Expression, Expression]]:
        """A line of centres, or a wall, by its angle with **i**, on the side of **j**.

        Where it may as well be on the other side, all is the same there but for what is mirrored.
        """
        match angle:
            case Quantity("angle", (Name(name), Unit("i")) | (Unit("i"), Name(name))):
                for event in self.setting.events:
                    if event.number not in self.setting.either or name not in event.bodies[1:]:
                        continue
                    axis = Quantity("line_of_centres", (), event.number)
                    if axis not in self.opaque:
                        yield axis, Binary("-", value, RIGHT_ANGLE)
                    wall = Quantity("direction", (Name(name),))
                    if wall not in self.opaque:
                        yield wall, value
            case Quantity(
                "angle", (Quantity("line_of_centres", (), int(number)) as axis, Unit("i"))
            ):
                if number in self.setting.either and axis not in self.opaque:
                    yield axis, value

    def _turns(self, world: World) -> Iterator[tuple[Expression, Expression]]:
        """Angles by what is cited of them; one with a wall tells the one with its normal."""
        for quantity, value in self._given_turns(world):
            yield quantity, value
            match quantity:
                case Quantity("angle", (velocity, Name(wall))):
                    rest = Binary("-", RIGHT_ANGLE, value)
                    for event in self.setting.events:
                        if event.wall and event.bodies[1] == wall:
                            normal = Quantity("line_of_centres", (), event.number)
                            yield Quantity("angle", (velocity, normal)), rest

    def _given_turns(self, world: World) -> Iterator[tuple[Expression, Expression]]:
        for meaning in self.lets:
            if is_angle(meaning):
                yield meaning.quantity, Letter(meaning.letter)
        for link in self.links:
            if link.sign != "=" or link.left in self.opaque:
                continue
            subject = isinstance(link.left, Letter | Quantity) and world.is_angle(link.left)
            if subject and link.left not in set(walk(link.right)):
                yield link.left, link.right
        for link in self.links:
            yield from self._angles_of_data(link, world)

    def _angles_of_data(self, link: Link, world: World) -> Iterator[tuple[Expression, Expression]]:
        """The angles that a velocity makes with lines, where its direction is given, or worked out.

        They are those to walls, lines of centres, and **i** or **j**.
        """
        match link:
            case Link(Quantity("velocity") as velocity, "=", Polar(_, angle, _, Name() as wall)):
                own = self._within_a_right_angle(world, angle)
                if own is not None:
                    yield Quantity("angle", (velocity, wall)), own
                return
            case Link(Quantity("velocity") as velocity, "=", Polar(_, angle, origin, _)):
                given = Unit("i") if origin is None else origin
                if self._is_up_to(world, angle, sp.pi):
                    yield Quantity("angle", (velocity, given)), angle
            case Link(Quantity("velocity") as velocity, "=", right):
                along = self._along_a_unit(world, right)
                if along is None:
                    return
                given, angle = along, Degrees(Fraction(0))
            case Link(Letter(name), "=", angle):
                meaning = next((let for let in self.lets if let.letter == name), None)
                match meaning and meaning.quantity:
                    case Quantity("direction", (Name() as body,), int(stage)):
                        velocity, given = Quantity("velocity", (body,), stage), Unit("i")
                    case _:
                        return
            case _:
                return
        for line, direction in world.directions.items():
            own = self._from_a_line(world, angle, given, direction)
            if own is not None:
                wall_ = line.arguments[0] if _is_a_wall(line) else line
                yield Quantity("angle", (velocity, wall_)), own

    def _along_a_unit(self, world: World, velocity: Expression) -> Expression | None:
        """**i** or **j**, perhaps reversed, where a velocity is a positive number of it."""
        match velocity:
            case Unit():
                return velocity
            case Negate(operand):
                own = self._along_a_unit(world, operand)
                return None if own is None else Negate(own)
            case Binary("*", size, Unit() as unit):
                value = world.expression(world.scalar(size), self.setting.roles)
                positive = Oracle(self.setting.roles).proves(compared(value, ">", sp.Integer(0)))
                return unit if positive else None
        return None

    def _from_a_line(
        self, world: World, angle: Expression, given: Expression, line: Expression
    ) -> Expression | None:
        """The angle of up to 90° to a line, of what is turned by an angle from a direction."""
        if world.is_angle(line):
            unit = unsigned(given)
            if not isinstance(unit, Unit):
                return None
            turned = Binary("-", line, RIGHT_ANGLE) if unit == Unit("j") else line
            angle = Binary("-", angle, turned)
        elif given not in (line, Negate(line)) and Negate(given) != line:
            units = [unsigned(tree) for tree in (given, line)]
            if not all(isinstance(unit, Unit) for unit in units):
                return None
            angle = Binary("-", RIGHT_ANGLE, angle)
        return self._within_a_right_angle(world, angle)

    def _within_a_right_angle(self, world: World, angle: Expression) -> Expression | None:
        """The angle of up to 90° between a line and what is turned from it by an angle."""
        forms: list[Expression] = [angle, Negate(angle)]
        for turns in range(1, 2 if letters(angle) else 4):
            whole = Degrees(turns * STRAIGHT_ANGLE.value)
            forms += [Binary("-", whole, angle), Binary("+", whole, angle)]
            forms += [Binary("-", angle, whole), Binary("-", Negate(angle), whole)]
        return next((form for form in forms if self._is_up_to(world, form, sp.pi / 2)), None)

    def _is_up_to(self, world: World, angle: Expression, most: sp.Expr) -> bool:
        """Whether an angle of the data is from zero to a bound, as angles of directions are.

        Where its cosine is positive, as that of 2θ for a path, it has only to be below 180°.
        """
        if Link(Apply("cos", angle), ">", Number(Fraction(0))) in self.links:
            most = sp.pi
        value = world.expression(world.scalar(angle), self.setting.roles)
        oracle = Oracle(self.setting.roles)
        return all(
            oracle.proves(compared(a, "<=", b)) for a, b in ((sp.Integer(0), value), (value, most))
        )


def _without_circles(
    pairs: Iterable[tuple[Expression, Expression]],
) -> dict[Expression, Expression]:
    """What stands for what, the last that is cited, but nothing for what it is made of itself."""
    chosen: dict[Expression, Expression] = {}
    for left, right in pairs:
        others = {key: value for key, value in chosen.items() if key != left}
        if not _leads_to(right, left, others):
            chosen[left] = right
    return chosen


def _leads_to(tree: Expression, goal: Expression, by: Mapping[Expression, Expression]) -> bool:
    pending, seen = [tree], set()
    while pending:
        for node in walk(pending.pop()):
            own = Quantity("direction", (node,)) if isinstance(node, Name) else node
            if goal in (node, own):
                return True
            for key in (node, own):
                if key in by and key not in seen:
                    seen.add(key)
                    pending.append(by[key])
    return False
