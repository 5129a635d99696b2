"""One line and what it cites: values to put in, and what is known of signs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import Any

import sympy as sp

from restitution.explaining.data.setting import Cited, is_angle
from restitution.explaining.lines.derivation import Event, Link, Meaning, Relation, Sign
from restitution.explaining.lines.generators import Value
from restitution.explaining.lines.quotients import CONSTANT, NotComparableError, Plane, Quotient
from restitution.explaining.lines.trees import settled
from restitution.explaining.steps.premises import POSITIVE_KINDS, Premises
from restitution.explaining.steps.rules import Rules
from restitution.explaining.steps.signs import Signs, ratio
from restitution.expression.tree import (
    COMPONENTS,
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
    is_binary,
    is_function,
    is_quantity,
    walk,
)
from restitution.oracle import All, Formula, Oracle, Some, compared, joined
from restitution.oracle.roles import POSITIVE, REAL, Role
from restitution.records import dataclass

_NOTHING = Number(Fraction(0))


@dataclass
class Step(Premises):
    """One line and what it cites: the room in which a move is judged."""

    # --- values put in --------------------------------------------------------------------------

    def rules(self, cited: Sequence[Cited] | None = None) -> Rules:
        """What is cited as values: of a letter or a quantity by a number or other letters."""
        if cited is None:
            return self._rules
        factors = frozenset(self.setting.meanings if self.move.record == "factors" else ())
        rules = Rules(self.world, apart=self._letters_apart, factors=factors)
        self._put_together(cited, rules)
        for premise in cited:
            if isinstance(premise.relation, Meaning):
                meaning = premise.relation
                if isinstance(meaning.quantity, Binary):
                    rules.add(Letter(meaning.letter), meaning.quantity)
                rules.add(meaning.quantity, Letter(meaning.letter), self._sense(meaning))
            elif len(premise.relation.options) == 1:
                for left, right in _values(premise.relation.only):
                    rules.add(left, right)
        for left, right in self._resolved(tuple(cited), rules):
            rules.add(left, right)
        for left, right in self._stays(tuple(cited), rules):
            rules.add(left, right)
        return rules

    @cached_property
    def _letters_apart(self) -> frozenset[str]:
        """The letters of components that are cited, in a line about how far, or how fast, apart."""
        sizes = any(
            is_function(node, "abs")
            for link in self.links
            for side in (link.left, link.right)
            for node in walk(side)
        )
        if not sizes and self.move.record not in ("distance", "size", "relative-velocity"):
            return frozenset()
        return frozenset(let.letter for let in self.lets)

    def _put_together(self, cited: Sequence[Cited], rules: Rules) -> None:
        """Vectors of which both components are cited, in directions that are told in letters.

        Both directions are unit vectors at right angles: no identity of angles is needed.
        """
        parts: dict[tuple[Expression, Expression], dict[str, tuple[Expression, int]]] = {}
        for premise in cited:
            sense = self._sense(premise.relation) if isinstance(premise.relation, Meaning) else 1
            for left, right in self._cited_values(premise):
                match left:
                    case Quantity("along" | "across" as kind, (Quantity() as vector, axis)):
                        if axis in self.world.directions:
                            parts.setdefault((vector, axis), {})[kind] = right, sense
        for (whole, line), pair in parts.items():
            if len(pair) == 2:
                rules.assemble(whole, line, *(pair[kind] for kind in COMPONENTS))

    @cached_property
    def _rules(self) -> Rules:
        """What is cited in all, as values."""
        return self.rules(self.cited)

    def _stays(
        self, cited: Sequence[Cited], rules: Rules
    ) -> Iterator[tuple[Expression, Expression]]:
        """Coordinates that are the same at the next event, as a body does not move that way."""
        placed: set[tuple[Name, int]] = set()
        for premise in cited:
            for left, _ in self._cited_values(premise):
                match left:
                    case Quantity("position", (Name() as body,), int(stage)):
                        placed.add((body, stage))
                    case Quantity(
                        "along", (Quantity("position", (Name() as body,), int(stage)), _)
                    ):
                        placed.add((body, stage))
        # A line about the way of a body says itself where that leads.
        own = self.move.bodies if self.move.record == "straight-line" else ()
        for body, stage in sorted(placed, key=repr):
            velocity = rules.put_into(self.world.value(Quantity("velocity", (body,), stage)))
            if not isinstance(velocity, Plane):
                continue
            for unit, pace in ((Unit("i"), velocity.x), (Unit("j"), velocity.y)):
                if pace.vanishes:
                    for number in self._until(body, stage):
                        ends = number == self.move.event and body.name in own
                        if ends or (body, number) in placed:
                            continue
                        later, now = (
                            Quantity("along", (Quantity("position", (body,), after), unit))
                            for after in (number, stage)
                        )
                        yield later, now

    def _until(self, body: Expression, stage: int) -> Iterator[int]:
        """The events after one, to the next in which a body takes part."""
        for event in self.setting.events:
            if event.number > stage:
                yield event.number
                if isinstance(body, Name) and body.name in event.bodies:
                    return

    def _resolved(
        self, cited: Sequence[Cited], rules: Rules
    ) -> Iterator[tuple[Expression, Expression]]:
        """Components of a velocity of which the size and an angle are cited.

        At a wall a body comes towards it and goes away, and keeps the sense along it that its
        velocity before, as cited, has. On which side of a line of centres it goes, an angle to it
        does not tell.
        """
        speeds, angles, directed = {}, {}, {}
        for premise in cited:
            for left, right in self._cited_values(premise):
                match left, right:
                    case Quantity("velocity", arguments, stage), Polar(size, _):
                        yield Quantity("speed", arguments, stage), size
                    case Quantity("velocity", arguments, stage), Pair(Number(0), Number(0)):
                        yield Quantity("speed", arguments, stage), right.x
                        yield from self._of_nothing(left, right.x)
                match left:
                    case Quantity("speed", (body,), int(stage)):
                        speeds[Quantity("velocity", (body,), stage)] = right
                    case Quantity("direction", (body,), int(stage)):
                        directed[Quantity("velocity", (body,), stage)] = right
                    case Quantity("angle", (Quantity("velocity") as velocity, axis), _):
                        angles[velocity] = axis, right
        for velocity, angle in directed.items():
            if velocity in speeds:
                yield velocity, Polar(speeds[velocity], angle)
        for velocity, (axis, angle) in angles.items():
            if velocity not in speeds:
                continue
            size = speeds[velocity]
            cosine = Binary("*", size, Apply("cos", angle))
            sine = Binary("*", size, Apply("sin", angle))
            for event in self.setting.events:
                centres = Quantity("line_of_centres", (), event.number)
                along = Quantity("along", (velocity, centres))
                across = Quantity("across", (velocity, centres))
                if not event.wall or axis != Name(event.bodies[1]):
                    continue
                before = replace(velocity, stage=event.number - 1)
                before = settled(before, self.setting.events)  # type: ignore[assignment]
                away = velocity.stage == event.number
                if velocity.arguments != (Name(event.bodies[0]),) or not (
                    away or velocity == before
                ):
                    continue
                if velocity.stage and not away:
                    pairs = (along, sine), (across, cosine)
                    senses = [self.sense_on_paper(velocity, centres, n) for n in (0, 1)]
                    for (component, size), on_paper in zip(pairs, senses, strict=True):
                        if on_paper is not None:
                            yield component, size if on_paper == 1 else Negate(size)
                    if senses != [None, None]:
                        continue
                is_open = self._is_open(before)
                if is_open and self._comes_from_either_side(before):
                    ahead: int | None = self._as_along_an_axis(centres)
                else:
                    ahead = self._towards(event, rules)
                if ahead is not None:
                    yield along, Negate(sine) if away == (ahead == 1) else sine
                sense = self._sense_along(Quantity("across", (before, centres)), rules)
                if sense is None and is_open:
                    sense = self._as_along_an_axis(centres, turns=1)
                if sense is not None:
                    yield across, cosine if sense == 1 else Negate(cosine)

    def _as_along_an_axis(self, centres: Quantity, turns: int = 0) -> int:
        """−1 where a normal, turned to the left so many times, is against **i** or **j**; else 1.

        Of a motion of which nothing is told the components are taken positive along these.
        """
        normal = self.world.pointing(centres)
        if not isinstance(normal, Plane):
            return 1
        parts = (-normal.y, normal.x) if turns else (normal.x, normal.y)
        is_along = any(part.vanishes for part in parts)
        return -1 if is_along and any(self.signs.of(part) == -1 for part in parts) else 1

    def _comes_from_either_side(self, velocity: Quantity) -> bool:
        """Whether it is cited that a body comes to a wall, and not from which side."""
        return any(
            link.sign == "!=" and velocity in walk(link.left) and link.right == _NOTHING
            for link in self.links
        )

    def _is_open(self, velocity: Quantity) -> bool:
        """Whether a law at a wall cites nothing of a velocity before it, but that it comes there.

        A letter for a component of it has a sense of its own.
        """
        trees = [meaning.quantity for meaning in self.lets]
        trees += [e for link in self.links if link.sign != "!=" for e in (link.left, link.right)]
        law = self.move.record in ("unchanged", "restitution-wall")
        return law and not any(velocity in walk(tree) for tree in trees)

    def _of_nothing(
        self, velocity: Expression, zero: Expression
    ) -> Iterator[tuple[Expression, Expression]]:
        """Who is at rest has no component in any direction, whether that is cited or not."""
        for event in self.setting.events:
            axis = Quantity("line_of_centres", (), event.number)
            if axis not in self.world.directions:
                for kind in COMPONENTS:
                    yield Quantity(kind, (velocity, axis)), zero

    def _sense_along(self, component: Expression, rules: Rules) -> int | None:
        """1 or −1 where a component, with what is cited put in, is never of the other sign."""
        try:
            value = rules.put_into(self.world.value(component))
        except NotComparableError:
            return None
        assert isinstance(value, Quotient)
        own = self.world.expression(value, self.setting.roles)
        if own.has(*(x for x in own.free_symbols if x.name.startswith("q_"))):
            return None
        oracle = Oracle(self.setting.roles)
        for sign in (1, -1):
            if oracle.proves(compared(sign * own, ">=", sp.Integer(0))):
                return sign
        return None

    def sense_on_paper(self, velocity: Quantity, line: Expression, turns: int = 0) -> int | None:
        """1 or −1 where a velocity is certain to point to that side along a direction.

        So the velocities of the data make it, and the laws at walls as lines have them, whether
        they are cited or not; the inequalities between letters count that are cited. The direction
        is that of a line of centres, or a vector, turned to the left so many times.
        """
        facts = (premise for premise in self.cited if isinstance(premise.ref, str))
        cited = (*facts, *self.setting.bounces)
        paper = self.under(setting=replace(self.setting, bounces=()), cited=cited)
        whole, direction = paper.moving(velocity), paper.world.pointing(line)
        if whole is None or not isinstance(direction, Plane):
            return None
        for _ in range(turns):
            direction = Plane(-direction.y, direction.x)
        value = paper.world.reduced(whole.x * direction.x + whole.y * direction.y)
        worth = paper.world.expression(value, self.setting.roles)
        if any(x.name.startswith("q_") for x in worth.free_symbols):
            return None
        oracle = Oracle(self.setting.roles, self.given_inequalities)
        for sign in (1, -1):
            if oracle.proves(compared(sign * worth, ">=", sp.Integer(0))):
                return sign
        return None

    def moving(self, velocity: Quantity) -> Plane | None:
        """A velocity, with what is cited put in; it is mirrored at a wall with e = 1."""
        own = self.world.value(velocity)
        value = self._rules.put_into(own)
        if value != own and isinstance(value, Plane):
            return value
        event = self.setting.event(velocity.stage if isinstance(velocity.stage, int) else None)
        if event is None or not event.wall or not self.keeps_speeds(event):
            return None
        before = settled(replace(velocity, stage=event.number - 1), self.setting.events)
        assert isinstance(before, Quantity)
        early = self.moving(before)
        normal = self.world.direction(Quantity("line_of_centres", (), event.number))
        if early is None or normal is None:
            return None
        dot = early.x * normal.x + early.y * normal.y
        twice = (dot + dot) / (normal.x * normal.x + normal.y * normal.y)
        return Plane(early.x - twice * normal.x, early.y - twice * normal.y)

    def keeps_speeds(self, event: Event) -> bool:
        """Whether a coefficient is cited with which a wall takes no speed from a body."""
        coefficient = Quantity("restitution", (), event.number)
        return any(
            link.left == coefficient and (link.sign, link.right) == ("=", Number(Fraction(1)))
            for link in self.links
        )

    @cached_property
    def given_inequalities(self) -> tuple[Formula, ...]:
        """The inequalities between letters of the statement that are cited."""
        return tuple(
            compared(self._in_roles(link.left), link.sign, self._in_roles(link.right))
            for link in self._inequalities()
        )

    def _in_roles(self, tree: Expression) -> sp.Expr:
        return self.world.expression(self.world.scalar(tree), self.setting.roles)

    def _towards(self, event: Event, rules: Rules) -> int | None:
        """1 where the direction of an event at a wall is the one into it, as far as is cited.

        −1 where it is the one out of it.
        """
        velocity = Quantity("velocity", (Name(event.bodies[0]),), event.number - 1)
        axis = Quantity("line_of_centres", (), event.number)
        tree = settled(Quantity("along", (velocity, axis)), self.setting.events)
        own = self.world.scalar(tree)
        value = rules.put_into(own)
        if value == own or not isinstance(value, Quotient):
            return 1
        worth = self.world.expression(value, self.setting.roles)
        oracle = Oracle(self.setting.roles)
        signs = (n for n in (1, -1) if oracle.proves(compared(n * worth, ">=", sp.Integer(0))))
        return next(signs, None)

    @staticmethod
    def _cited_values(premise: Cited) -> Iterator[tuple[Expression, Expression]]:
        if isinstance(premise.relation, Meaning):
            yield premise.relation.quantity, Letter(premise.relation.letter)
        elif len(premise.relation.options) == 1:
            yield from _values(premise.relation.only)

    def _sense(self, meaning: Meaning) -> int:
        """−1 where a component is counted against the direction in which it is taken."""
        if meaning.sense is None:
            return 1
        if not (isinstance(meaning.quantity, Quantity) and meaning.quantity.kind in COMPONENTS):
            raise NotComparableError("the sense of what has none")
        axis = meaning.quantity.arguments[-1]
        if meaning.sense == axis:
            return 1
        if Negate(axis) == meaning.sense or Negate(meaning.sense) == axis:
            return -1
        a, b = self.world.direction(axis), self.world.direction(meaning.sense)
        if a is None or b is None:
            raise NotComparableError("the sense of a letter")
        if meaning.quantity.kind == "across":
            a = Plane(-a.y, a.x)
        product_ = self.world.reduced(a.x * b.x + a.y * b.y)
        sign = self.world.reduced(a.x * b.y - a.y * b.x).vanishes and _plain_sign(self, product_)
        if not sign:
            raise NotComparableError("the sense of a letter")
        return sign

    # --- what is known of signs -----------------------------------------------------------------

    @cached_property
    def roles(self) -> Mapping[str, Role]:
        """What each letter may be: nothing beyond what is silent or cited."""
        roles = dict(self.setting.silent)
        for premise in self.known:
            for name in premise.letters:
                if self.setting.role(name).kind == "angle":
                    roles[name] = self.setting.role(name)
        for name, meaning in self.setting.meanings.items():
            if name in roles:
                continue
            if isinstance(meaning.quantity, Quantity) and meaning.quantity.kind in POSITIVE_KINDS:
                roles[name] = POSITIVE  # as the speeds and the masses of a statement are
            elif _never_negative(meaning.quantity):
                roles[name] = Role("real", sp.Integer(0), None, (True, False))
        return roles

    def formula(self, relation: Relation) -> Formula:
        """A relation for the oracle."""
        options = [
            joined(formula for link in links for formula in self._formulas(link))
            for links in relation.options
        ]
        return options[0] if len(options) == 1 else Some(tuple(options))

    def _formulas(self, link: Link) -> list[Formula]:
        world = self.world
        if link.sign in ("parallel to", "perpendicular to", "≈"):
            return []
        left, right = alike(world.value(link.left), world.value(link.right))
        if isinstance(left, Plane) and isinstance(right, Plane):
            pairs = [(left.x, right.x), (left.y, right.y)]
        elif isinstance(left, Plane) or isinstance(right, Plane):
            raise NotComparableError("a vector beside a number")
        else:
            pairs = [(left, right)]
        return [
            compared(world.expression(a, self.roles), link.sign, world.expression(b, self.roles))
            for a, b in pairs
        ]

    @cached_property
    def facts(self) -> tuple[Formula, ...]:
        """What is cited, as facts for the oracle."""
        formulas: list[Formula] = []
        for premise in self.cited:
            if isinstance(premise.relation, Meaning):
                formulas += self._of_meaning(premise.relation)
            else:
                formulas.append(self.formula(premise.relation))
        for left, right in self._stays(self.cited, self._rules):
            formulas += self._formulas(Link(left, "=", right))
        for speed in self._squared_speeds():
            formulas += self._formulas(Link(speed, ">=", Number(Fraction(0))))
        for ahead in self._ahead():
            formulas += self._formulas(Link(ahead, ">", Number(Fraction(0))))
        for known in self.known:
            if not known.letters or not all(
                self.roles.get(n, REAL).kind == "angle" for n in known.letters
            ):
                formulas.append(self.formula(known.relation))
        return tuple(formula for formula in formulas if formula != All(()))

    def _ahead(self) -> Iterator[Expression]:
        """The components of velocities in the directions that are cited for them."""
        for link in self.links:
            match link:
                case Link(Quantity("direction", (Name() as body,), int(stage)), "=", angle) if (
                    isinstance(angle, Degrees)
                ):
                    velocity = Quantity("velocity", (body,), stage)
                    yield Quantity("dot", (velocity, Polar(Number(Fraction(1)), angle)))

    def _squared_speeds(self) -> list[Quantity]:
        """The speeds whose squares are cited: they are what is not negative of the roots."""
        squares = dict.fromkeys(
            node.left
            for cited in self.cited
            if isinstance(cited.relation, Relation)
            for links in cited.relation.options
            for link in links
            for side in (link.left, link.right)
            for node in walk(side)
            if is_binary(node, "^")
        )
        return [e for e in squares if is_quantity(e, "speed")]

    def _of_meaning(self, meaning: Meaning) -> list[Formula]:
        if meaning.vector or is_angle(meaning):
            return []
        try:
            sense = self._sense(meaning)
        except NotComparableError:
            return []
        quantity = meaning.quantity if sense == 1 else Negate(meaning.quantity)
        return self._formulas(Link(Letter(meaning.letter), "=", quantity))

    def pushed(self) -> tuple[Formula, ...]:
        """The senses in which spheres without a component along their line of centres leave it.

        Each is pushed away from the other one, and has a letter for its component that is cited.
        """
        formulas: list[Formula] = []
        for let in self.lets:
            match let.quantity:
                case Quantity("along", (Quantity("velocity", (Name(body),), int(number)), axis)):
                    event = self.setting.event(number)
                case _:
                    continue
            if event is None or event.wall or axis != Quantity("line_of_centres", (), number):
                continue
            if body not in event.bodies or event.kind != "impact":
                continue
            velocity = self.setting.quantity(Quantity("velocity", (Name(body),), number - 1))
            value = self._rules.put_into(self.world.value(Quantity("along", (velocity, axis))))
            if isinstance(value, Quotient) and value.vanishes:
                away = self._sense(let) * (1 if body == event.bodies[-1] else -1)
                sign: Sign = ">=" if away == 1 else "<="
                formulas += self._formulas(Link(Letter(let.letter), sign, Number(Fraction(0))))
        return tuple(formulas)

    @cached_property
    def oracle(self) -> Oracle:
        """The oracle, under what is cited."""
        return Oracle(self.roles, self.facts)

    @cached_property
    def signs(self) -> Signs:
        """The signs of factors, under what is cited."""
        return Signs(self.world, lambda: self.oracle)

    # --- comparing ------------------------------------------------------------------------------

    def residual(self, link: Link, rules: Rules | None = None) -> Value:
        """Left minus right, with values put in."""
        left, right = alike(self.world.value(link.left), self.world.value(link.right))
        if isinstance(left, Plane) != isinstance(right, Plane):
            raise NotComparableError("a vector beside a number")
        if isinstance(left, Plane) and isinstance(right, Plane):
            value: Value = Plane(left.x - right.x, left.y - right.y)
        else:
            assert isinstance(left, Quotient)
            assert isinstance(right, Quotient)
            value = self.world.reduced(left - right)
        return value if rules is None else rules.put_into(value)

    def is_multiple(self, line: Value, expected: Value, sign: bool = False) -> int | None:
        """1 or −1 where a residual is k times the expected one, with k of that sign.

        Where ``sign`` is not asked for, it is enough that k is not zero, and 1 is the answer.
        """
        k = self.multiple(line, expected)
        if k is None:
            return None
        known = self.signs.of(k, sure=sign)
        if known is None or (sign and known == 0):
            return None
        return known or 1

    def multiple(self, line: Value, expected: Value) -> Quotient | None:
        """The factor by which a residual is the expected one, which may be zero."""
        if isinstance(line, Plane) and isinstance(expected, Plane):
            pairs = [(line.x, expected.x), (line.y, expected.y)]
            if any(a.vanishes != b.vanishes for a, b in pairs):
                return None
            pairs = [(a, b) for a, b in pairs if not b.vanishes]
            if not pairs:
                return None
            if len(pairs) == 2:
                (a, b), (c, d) = pairs
                if not self.world.reduced(a * d - c * b).vanishes:
                    return None
            return ratio(self.world, *pairs[0])
        if isinstance(line, Plane) or isinstance(expected, Plane):
            return None
        return ratio(self.world, line, expected)

    def under(self, **changes: Any) -> Step:
        """The same line in another world."""
        return replace(self, **changes)


def alike(left: Value, right: Value) -> tuple[Value, Value]:
    """Two values, of which a 0 beside a vector is the vector of no length."""
    nothing = Plane(CONSTANT(0), CONSTANT(0))
    if isinstance(left, Plane) and isinstance(right, Quotient) and right.vanishes:
        return left, nothing
    if isinstance(right, Plane) and isinstance(left, Quotient) and left.vanishes:
        return nothing, right
    return left, right


def _values(links: Sequence[Link]) -> Iterator[tuple[Expression, Expression]]:
    """The values that a relation gives: of a chain of equations, the last side of its first."""
    subject, last = None, None
    for link in links:
        if link.sign != "=":
            subject = None
            continue
        if subject is not None and link.left == last:
            last = link.right
            continue
        if subject is not None:
            assert last is not None
            yield subject, last
        subject, last = link.left, link.right
    if subject is not None:
        assert last is not None
        yield subject, last


def _plain_sign(step: Step, x: Quotient) -> int:
    """The sign of what is made of positive letters and numbers; 0 where that does not tell it."""
    return Signs(step.world, lambda: Oracle(step.setting.silent)).of(x) or 0


def _never_negative(quantity: Expression) -> bool:
    return isinstance(quantity, Quantity) and (
        quantity.kind in ("distance", "energy") or quantity == Quantity("impulse")
    )
