"""The words before components of velocities, resolved at an impact."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from restitution.explaining.definitions.ties import tie_of
from restitution.explaining.lines.derivation import Event, Line, Link, Meaning, Relation, equality
from restitution.explaining.lines.saying import Sentence, say, slots_of
from restitution.explaining.lines.sentences import SentenceId
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Stage,
    Unit,
    is_quantity,
    is_zero,
    unsigned,
    walk,
)
from restitution.render import layout as lay
from restitution.workings.leads.lines_around import LinesAround
from restitution.workings.leads.one_component import (
    angle_by_degrees,
    in_degrees,
    only_component,
    struck_at_rest,
    vector_resolved,
)
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.measured import are_parallel, are_perpendicular

# Components before the impact, or after it: at a wall, and of spheres.
_RESOLVED = {
    (True, True): "resolved-wall.before-units",
    (True, False): "resolved-wall.after-units",
    (False, True): "resolved-spheres.before-units",
    (False, False): "resolved-spheres.after-units",
}

# A component by a wall that is named, of a time that is not one of an impact with it.
_AT_A_WALL: Mapping[str, SentenceId] = {
    "along": "resolved-axes.along-wall",
    "across": "resolved-axes.across-wall",
}

# At which angle a body comes that goes as it was left, that was at rest before the last impact, and
# that was left at right angles to the line of that: at a wall, and at another line of centres.
_AT = {True: "resolved.before-at-wall", False: "resolved.before-at-centres"}
_OFF_AT = {True: "resolved.before-off-at-wall", False: "resolved.before-off-at-centres"}
_ACROSS = {True: "resolved.before-across-at-wall", False: "resolved.before-across-at-centres"}


def _axis_of(vector: Expression) -> Unit | None:
    """**i** or **j**, where a vector is a multiple of it alone."""
    units = {node for node in walk(vector) if isinstance(node, Unit)}
    return units.pop() if len(units) == 1 else None


def _is_speed(line: Line | None) -> bool:
    """Whether a line says what a speed is."""
    match None if line is None else line.relation:
        case Relation(((Link(Quantity("speed"), "="), *_),)):
            return True
    return False


def _components(name: SentenceId, **slots: Any) -> Sentence:
    """What is said before components: that there are several, until it is known how many stand."""
    if "components" in slots_of(name):
        slots["components"] = say("resolved.several")
    return say(name, **slots)


class ComponentLeads(LinesAround):
    """The words before components of velocities."""

    def resolves(self, line: Line) -> bool:
        """Whether a line finds a component, perhaps as a scalar product with **i** or **j**."""
        if line.move.record != "product" or not isinstance(line.relation, Relation):
            return line.move.record == "component"
        match line.relation.options[0][0].left:
            case Quantity("dot", (Quantity("velocity"), Unit()) | (Unit(), Quantity("velocity"))):
                return not self._of_a_vector(line)
        return False

    def _of_a_vector(self, line: Line) -> bool:
        """Whether a line rests on a velocity that a fact or a line above gives as a vector."""
        above = (self._derivation.cited(ref) for ref in line.premises)
        return any(
            is_quantity(link.left, "velocity")
            for own in above
            if own is not None and isinstance(own.relation, Relation)
            for links in own.relation.options
            for link in links
        )

    def resolved(self, line: Line) -> Sentence | None:
        """What is said before components: of which time they are."""
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].left:
            case Quantity(
                "along" | "across" as side, (Quantity("velocity", _, int(stage)) as own, axis)
            ):
                event = self._naming.event_of_axis(axis)
                if event is None and stage < (line.move.event or 0):
                    event = self._naming.events.get(line.move.event or 0)
                sense = self._naming.at_the_wall(axis)
                if event is None and sense is not None:
                    return _components(_AT_A_WALL[side], wall=sense[1])
                if event is None and isinstance(axis, Unit):
                    return say("resolved-axes.title")
                if event is None and isinstance(axis, Name):
                    return _components(_AT_A_WALL[side], wall=axis.name)
            case Quantity("dot", (_, Unit()) | (Unit(), _)):
                return say("resolved-axes.title")
            case Quantity("dot", (Quantity("velocity", _, int(stage)), along)):
                return self._products(line, stage, along)
            case _:
                return None
        if event is None:
            return None
        if not set(line.move.bodies) & set(event.bodies):
            return _components("resolved.of-another", velocity=self._naming.layout(own))
        bold = self._naming.bold
        named = bold.has_unit(event.number) or bold.is_read_off(event.number)
        direction = None if named else bold.direction(event.number, "across")
        if stage < event.number and direction is not None and self._has_across(line, axis):
            if event.wall:
                return say("resolved-wall.before-sense", wall=event.bodies[1], axis=direction)
            return say("resolved-spheres.before-sense", axis=direction)
        if not event.wall and self._is_turned(line, event.number):
            return _components("resolved-spheres.before-turned")
        if stage < event.number and self._comes_straight(event):
            body, wall = event.bodies
            circular = wall in self._naming.circles
            # That it starts at the centre has its words already where a time rests on it.
            new = circular and not self._starts_at_the_centre(line, event)
            name: SentenceId = "resolved.direct-radius" if new else "resolved.direct"
            if any(_is_speed(other) for other in map(self._cited, line.premises)):
                name = "resolved.direct-speed"
            return _components(name, body=body, wall=wall)
        struck = struck_at_rest(self._derivation, self._naming, line)
        if struck is not None and not self.tells_of_rest(struck, stage, line):
            struck = None
        angle = angle_by_degrees(self._derivation, self._naming, line, event)
        if angle is not None:
            return self._resolved_at(line, event, angle, struck)
        vector = vector_resolved(self._derivation, self._naming, line, event)
        if vector is not None:
            if struck is not None:
                slots = {"body": struck, "vector": vector, "struck": self._that_struck(line)}
                return _components("resolved.before-moved-off", **slots)
            return _components("resolved.before-vector", vector=vector)
        if (
            not event.wall
            and stage < event.number
            and not bold.has_unit(event.number)
            and self._has_across(line, axis)
        ):
            first, second = event.bodies
            return say("resolved-spheres.before-left", first=first, second=second)
        rest = self._rest_of_the_wall(line, event) if stage < event.number else None
        if rest is not None:
            names = {"wall": event.bodies[1], "axis": self._naming.layout(Negate(Unit("i")))}
            return _components("resolved-wall.before-rest", angle=rest, **names)
        return _components(_RESOLVED[event.wall, stage < event.number])

    def _rest_of_the_wall(self, line: Line, event: Event) -> lay.Layout | None:
        """What is left to 180° of the angle of a wall, where components are resolved by that.

        So those at a wall at 110° have the sine and the cosine of 70°.
        """
        fact = self._derivation.fact(f"wall {event.bodies[-1]}")
        match None if fact is None or not event.wall else fact.relation.only[-1].right:
            case Degrees(turn) as angle if RIGHT_ANGLE.value < turn < STRAIGHT_ANGLE.value:
                rest = Degrees(STRAIGHT_ANGLE.value - turn)
            case _:
                return None
        assert isinstance(line.relation, Relation)
        if not any(rest in walk(link.right) for link in line.relation.only):
            return None
        return self._naming.relation(equality(Binary("-", STRAIGHT_ANGLE, angle), rest))

    def _products(self, line: Line, stage: int, along: Expression) -> Sentence:
        """What is said before scalar products with a vector along a line of centres, or a wall."""
        event = self._naming.events[line.move.event or 0]
        vector = self._naming.layout(along)
        slots: dict[str, Any] = {"products": say("resolved.several-products"), "vector": vector}
        if stage == event.number:
            return say("resolved.products-after", **slots)
        if event.wall:
            fact = self._derivation.fact(f"wall {event.bodies[1]}")
            parallel = fact is not None and are_parallel(along, fact.relation.only[-1].right)
            name: SentenceId = "resolved.products-along" if parallel else "resolved.products-wall"
            return say(name, wall=event.bodies[1], **slots)
        fact = self._derivation.fact(f"axis {event.number}")
        if fact is not None and are_perpendicular(along, fact.relation.only[-1].right):
            return say("resolved.products-across", **slots)
        return say("resolved.products-before", **slots)

    def _comes_straight(self, event: Event) -> bool:
        """Whether it is known that a body comes straight at a wall: no line has that component."""
        return event.wall and any(
            line.move.record in ("component", "perpendicular")
            and line.move.event == event.number
            and line.shown == "silent"
            and isinstance(line.relation, Relation)
            and is_quantity(line.relation.only[0].left, "across")
            and is_zero(line.relation.only[-1].right)
            for line in self._derivation.lines
        )

    def _starts_at_the_centre(self, line: Line, event: Event) -> bool:
        """Whether a line above says that a body starts at the centre of a circular wall."""
        for own in self._derivation.lines[: line.number - 1]:
            match own.relation:
                case Relation(((Link(Quantity("time"), "="), *_),)) if (
                    own.shown == "line"
                    and (own.move.record, own.move.event) == ("chord", event.number)
                    and f"position {event.bodies[0]}" in own.premises
                ):
                    return True
        return False

    def _resolved_at(
        self, line: Line, event: Event, angle: Expression, struck: str | None
    ) -> Sentence:
        """At which angle to the line of centres, or to the wall, a body comes."""
        body, layout = line.move.bodies[0], self._naming.layout(angle)
        if isinstance(angle, Binary):
            turn = in_degrees(angle)
            layout = self._naming.relation(equality(angle, turn))
        match only_component(self._derivation, self._naming, line, event):
            case (Quantity("across", (_, Quantity())), _):
                name = _ACROSS[event.wall]
            case _:
                name = _AT[event.wall] if struck is None else _OFF_AT[event.wall]
        slots: dict[str, Any] = {"wall": event.bodies[1]} if event.wall else {}
        if name in _OFF_AT.values():
            slots["struck"] = self._that_struck(line)
        return _components(name, body=body, angle=layout, **slots)

    def _that_struck(self, line: Line) -> Sentence:
        """What the impact is called after which a line has a component."""
        assert isinstance(line.relation, Relation)
        left = line.relation.options[0][0].left
        assert isinstance(left, Quantity)
        vector = left.arguments[0]
        assert isinstance(vector, Quantity)
        assert isinstance(vector.stage, int)
        return self._naming.called(self._naming.events[vector.stage])

    def _since_nothing(self, line: Line) -> Sentence | None:
        """That a component is zero, by which a direction is what it is."""
        assert isinstance(line.relation, Relation)
        above = self._derivation.lines_in(line.premises)
        equations = [e.relation.only for e in above if isinstance(e.relation, Relation)]
        zero = [links for links in equations if is_zero(links[-1].right)]
        if line.relation.only[0].sign not in ("parallel to", "perpendicular to") or len(zero) != 1:
            return None
        equation = Link(zero[0][0].left, "=", zero[0][-1].right)
        if not isinstance(equation.left, Letter):
            return say("so")
        return say("derived.since", facts=(self._naming.relation(Relation(((equation,),))),))

    def _none_in(self, line: Line) -> Sentence | None:
        """That a velocity at right angles to a direction has no component in it."""
        assert isinstance(line.relation, Relation)
        if line.move.record != "perpendicular" or not is_zero(line.relation.only[-1].right):
            return None
        meanings = [
            own.relation.quantity
            for own in map(self._cited, line.premises)
            if own is not None and isinstance(own.relation, Meaning)
        ]
        for meaning in meanings:
            match meaning:
                case Quantity("angle", (Quantity("velocity") as velocity, Unit() as axis)):
                    formula, direction = self._naming.layout(velocity), self._naming.layout(axis)
                    return say("given.none-in", velocity=formula, axis=direction)
                case Quantity("angle", (Quantity("velocity") as velocity, Quantity() as axis)) if (
                    axis.kind == "line_of_centres" and self._naming.side(axis) is not None
                ):
                    formula = self._naming.layout(velocity)
                    return say("given.none-along", velocity=formula, line=self._naming.side(axis))
        return None

    def _direction_again(self, line: Line) -> Sentence | None:
        """That a velocity of which the statement gives the direction, 90°, has no component."""
        assert isinstance(line.relation, Relation)
        if line.move.record != "parallel" or not is_zero(line.relation.only[-1].right):
            return None
        for ref in line.premises:
            fact = self._derivation.fact(ref)
            match fact.relation.options[0][0] if fact is not None else None:
                case Link(Quantity("direction", (Name() as body,), stage), "=", angle) if (
                    fact is not None and is_square(angle)
                ):
                    velocity = self._naming.layout(Quantity("velocity", (body,), stage))
                    axis = self._naming.layout(Unit("i"))
                    words = fact_in_words(self._naming, fact)
                    return say("given.none-as-given", fact=words, velocity=velocity, axis=axis)
        return None

    def _seen(self, line: Line) -> Sentence | None:
        """How a body moves whose angle to a line is seen: along it, or perpendicular to it."""
        assert isinstance(line.relation, Relation)
        match line.relation.only[0]:
            case Link(
                Quantity("angle", (Quantity("velocity", (Name(body),), stage), other)),
                "=",
                Degrees(angle),
            ):
                line_ = self._naming.layout(other)
            case _:
                return None
        square = angle == RIGHT_ANGLE.value
        match other:
            case Quantity("line_of_centres"):
                return say(
                    "derived.across-centres" if square else "derived.along-centres", body=body
                )
            case Quantity():
                return None
            case Unit() if angle not in (0, RIGHT_ANGLE.value, STRAIGHT_ANGLE.value):
                return None
            case Unit() if not square:
                axis = other if angle == 0 else Negate(other)
                return self._along_axis(line, body, stage, axis)
        return say("derived.across-line" if square else "derived.along-line", body=body, line=line_)

    def _along_axis(self, line: Line, body: str, stage: Stage, axis: Expression) -> Sentence:
        """Which way a body moves; of one that was at rest, why."""
        rested = isinstance(stage, int) and self.tells_of_rest(body, stage, line)
        name: SentenceId = "derived.off-along-axis" if rested else "derived.along-axis"
        return say(name, body=body, axis=self._naming.layout(axis))

    def _along_axes(self, line: Line) -> Sentence | None:
        """That one velocity is along **i** and another along **j**, which are at right angles."""
        assert isinstance(line.relation, Relation)
        tie = tie_of(line.relation.only[0])
        if tie is None:
            return None
        cited = [other.relation for other in map(self._cited, line.premises) if other is not None]
        cited += [fact.relation for fact in self._derivation.facts_in(line.premises)]
        vectors = {
            own.only[0].left: own.only[-1].right for own in cited if isinstance(own, Relation)
        }
        axes = [_axis_of(vectors[tree]) if tree in vectors else None for tree in tie[:2]]
        if None in axes or axes[0] == axes[1]:
            return None
        slots = {
            name: self._naming.layout(own)
            for name, own in zip(("first", "second"), axes, strict=True)
            if own is not None
        }
        match tie[0], tie[1]:
            case Quantity("velocity", (Name(one),)), Quantity("velocity", (Name(other),)):
                if one == other:
                    return say("derived.turned-square", body=one, **slots)
                return say("derived.axes-apart", one=one, other=other, **slots)
        return None

    def _apart(self, line: Line) -> Sentence | None:
        """Who moves across the line of centres, and who along it, where that is a right angle."""
        still = self._standing(line)
        if set(still) != set(COMPONENTS):
            return None
        one, other = still["along"], still["across"]
        rested = self.tells_of_rest(other, line.move.event or 0, line)
        return say("derived.apart-from-rest" if rested else "derived.apart", one=one, other=other)


def is_square(angle: Expression) -> bool:
    """Whether an angle is one of 90°, to either side."""
    own = unsigned(angle)
    return own == RIGHT_ANGLE
