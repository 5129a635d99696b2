"""What stands around a line of a working: lines it cites, and how bodies move there."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Fact,
    Line,
    Link,
    Meaning,
    Ref,
    Relation,
    equality,
    numbers_in,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
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
    is_rest,
    is_zero,
    letters,
    negated,
)
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.workings.leads.one_component import went_from_rest
from restitution.workings.leads.shapes_of_lines import says_something
from restitution.workings.naming.measured import are_parallel, are_perpendicular, vector_worth
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.sources import Sources
from restitution.workings.reasons.premises import Reasons


class LinesAround:
    """One derivation, of which the words before its rows are written from the top."""

    def __init__(
        self, derivation: Derivation, naming: Naming, sources: Sources, reasons: Reasons
    ) -> None:
        self._derivation = derivation
        self._reasons = reasons
        self._naming = naming
        self._sources = sources
        self._given: set[str] = set()
        self._behind: dict[int, Sentence] = {}
        self._off: dict[tuple[str, int], list[Event | Line]] = {}

    def tells_of_rest(self, body: str, stage: int, place: Event | Line) -> bool:
        """Whether it is here that a body is said to have been at rest before an impact.

        Lines of one kind that follow each other have one title.
        """
        if not went_from_rest(self._derivation, self._naming, body, stage):
            return False
        places = self._off.setdefault((body, stage), [place])
        above = places[-1]
        if isinstance(place, Line) and isinstance(above, Line):
            kinds = [
                (self._derivation.asked.get(own.item or ""), own.move.record, own.move.event)
                for own in (above, place)
            ]
            if above.number == place.number - 1 and kinds[0] == kinds[1]:
                places.append(place)
        return place in places

    def _is_direct(self, event: Event | None) -> bool:
        """Whether two spheres of the data move along their line of centres, which is given."""
        return event is not None and event.number == 1 and self._in_one_line(event)

    def _in_one_line(self, event: Event | None) -> bool:
        """Whether all that has met until an impact of two spheres moves along their line."""
        if event is None or event.wall:
            return False
        events = [e for e in self._derivation.events[: event.number] if e.kind != "arrival"]
        spheres = {body for e in events for body in (e.bodies[:1] if e.wall else e.bodies)}
        along = self._vector("axis", str(event.number))
        names = [("axis", str(event.number)) for event in events if not event.wall]
        names += [("velocity", body) for body in spheres]
        # A wall that is struck by what moves along a line is perpendicular to it, unless it slants.
        walls = [self._vector("axis", str(event.number)) for event in events if event.wall]
        return (
            along is not None
            and all(
                own is not None and sp.expand(own.cross(along)) == 0
                for own in (self._vector(*name) for name in names)
            )
            and all(
                own is not None and 0 in (sp.expand(own.cross(along)), sp.expand(own.dot(along)))
                for own in walls
            )
        )

    def _vector(self, kind: str, name: str) -> Vector | None:
        """The vector that a datum tells; None where there is no such datum."""
        fact = self._derivation.fact(f"{kind} {name}")
        return None if fact is None else vector_worth(fact.relation.only[-1].right)

    def _printed_above(self, line: Line) -> Line | None:
        """The nearest line above one that is printed by itself; a letter that is let is none."""
        above = (self._derivation.line(n) for n in range(line.number - 1, 0, -1))
        return next((e for e in above if e and e.shown == "line" and says_something(e)), None)

    def _is_below_its_coordinate(self, line: Line) -> bool:
        """Whether a coordinate of a position stands just above it, by that name."""
        above = self._printed_above(line)
        match above.relation if above is not None else None:
            case Relation(((Link(Quantity("along", (Quantity("position"), _))), *_),)):
                return self._is_just_below(line)
        return False

    def _by_its_component(self, line: Line) -> Sentence | None:
        """The component that a velocity or a speed along one line has, stated further above."""
        event, parts = self._naming.events.get(line.move.event or 0), self._derivation.asked
        if line.move.record not in ("assemble", "speed") or not self._in_one_line(event):
            return None
        if self._is_just_below(line):
            return None
        for ref in line.premises:
            own = self._derivation.line(ref)
            if own is not None and parts.get(own.item or "") != parts.get(line.item or ""):
                continue  # with its part it is named beside the line
            match own.relation if own is not None else None:
                case Relation(((Link(Letter() as letter, "="), *_) as links,)):
                    number = self._sources.numbers.get(ref) if isinstance(ref, int) else None
                    if number is not None:
                        equation = say("derived.number", number=str(number))
                        return say("derived.add", equations=(equation,))
                    value = equality(letter, links[-1].right)
                    return say("derived.since", facts=(self._naming.relation(value),))
        return None

    def _is_just_below(self, line: Line) -> bool:
        """Whether a line rests on the one that is printed just above it."""
        above = self._printed_above(line)
        return above is not None and above.number in line.premises

    def _goes_off(self, line: Line) -> bool:
        """Whether it is here that a sphere is said to have been at rest, not struck along its line.

        Its velocity is then along the line of centres.
        """
        event = self._naming.events.get(line.move.event or 0)
        if event is None or event.wall or self._in_one_line(event):
            return False
        (body, *_) = line.move.bodies
        events = self._naming.events.values()
        if any(e.number < event.number and body in e.bodies for e in events):
            return False
        across = self._standing(line).get("across") == body
        return across and self.tells_of_rest(body, event.number, line)

    def _is_out_of_it(self, body: str) -> bool:
        """Whether a body has no part in the impact under whose heading the next line stands."""
        now = self._naming.events.get(self._naming.now or 0)
        latest = (n for n, event in self._naming.events.items() if body in event.bodies)
        return now is not None and max(latest, default=now.number) < now.number

    @staticmethod
    def _is_read_off(line: Line, speed: Expression) -> bool:
        """Whether a speed is one of the statement, and no component is put in."""
        return isinstance(speed, Letter | Number) and not any(
            isinstance(ref, int) for ref in line.premises
        )

    def _cited(self, ref: Ref) -> Line | None:
        return self._derivation.line(ref)

    def _across_of(self, line: Line, body: str) -> lay.Layout | None:
        """The component of a body across the line of centres, as a line that is cited has it."""
        for cited in map(self._cited, line.premises):
            match None if cited is None else cited.relation:
                case Relation(
                    ((Link(Quantity("across", (Quantity(_, (Name(own),)), _)), "=", value),),)
                ) if own == body:
                    return self._naming.layout(value)
        return None

    def _along_the_line(self, line: Line) -> Sentence | None:
        """That a body moves along the line of centres, where an angle to it is one to that."""
        body = self._moving_along(line)
        if body is None:
            return None
        rested = self.tells_of_rest(body, line.move.event or 0, line)
        return say("derived.along-centres-from-rest" if rested else "between.line", body=body)

    def _on_the_line(self, line: Line) -> str | None:
        """The body of a line that moves along the line of centres: by a component, or from rest."""
        for body in line.move.bodies:
            fact = self._derivation.fact(f"velocity {body}")
            rest = fact is not None and fact.id in line.premises and is_at_rest(fact)
            if rest or self._standing(line).get("across") == body:
                return body
        return None

    def _square_to_the_line(self, line: Line) -> tuple[str, str] | None:
        """Who moves along the line of centres, and who across it, of two at right angles.

        The line is about the component of the other one alone.
        """
        mover = self._on_the_line(line)
        others = [body for body in line.move.bodies if body != mover]
        if mover is None or len(others) != 1:
            return None
        letters = {
            line.relation.letter: line.relation.quantity
            for line in self._derivation.lines
            if isinstance(line.relation, Meaning)
        }
        for premise in filter(None, map(self._cited, line.premises)):
            own = premise.relation
            match own.quantity if isinstance(own, Meaning) else own.options[0][0].left:
                case Letter(name) if name in letters:
                    quantity = letters[name]
                case quantity:
                    pass
            match quantity:
                case Quantity("along", (Quantity("velocity", (Name(body),)), _)) if body == mover:
                    return None
        return mover, others[0]

    def _moving_along(self, line: Line) -> str | None:
        """The body that moves along the line of centres, of two between which an angle is."""
        if line.move.record != "tan" or len(line.move.bodies) != 2:
            return None
        for premise in filter(None, map(self._cited, line.premises)):
            match premise.relation:
                case Relation(((Link(left, "="), *_) as links,)) if is_zero(links[-1].right):
                    match left:
                        case Quantity("along" | "across", (Quantity("velocity", (Name(body),)), _)):
                            return body
        return None

    def _ends_square(self, line: Line) -> bool:
        """Whether a line rests on one by which a component is zero after the impact."""
        relations = (premise.relation for premise in filter(None, map(self._cited, line.premises)))
        return any(
            isinstance(relation, Relation) and is_zero(relation.options[0][-1].right)
            for relation in relations
        )

    def _standing(self, line: Line) -> dict[str, str]:
        """The bodies of which a component is zero by the lines that are cited, by its kind."""
        refs = numbers_in(line.premises)
        cited = [premise for ref in refs if (premise := self._derivation.line(ref)) is not None]
        meanings = {e.relation.letter: e.relation for e in cited if isinstance(e.relation, Meaning)}
        still: dict[str, str] = {}
        for premise in cited:
            match premise.relation:
                case Relation(((Link(left, "=", right),),)) if is_zero(right):
                    if isinstance(left, Letter) and left.name in meanings:
                        left = meanings[left.name].quantity
                    match left:
                        case Quantity(kind, (Quantity("velocity", (Name(body),), _), axis)):
                            still[self._kind_at(line, kind, axis)] = body
        return still

    def _kind_at(self, line: Line, kind: str, axis: Expression) -> str:
        """Whether a component is along the line of centres of an event, or across it.

        One along **i** is across a line of centres along **j**, or at 90°.
        """
        fact = self._derivation.fact(f"axis {line.move.event}")
        if fact is None or not isinstance(axis, Unit):
            return kind
        own = fact.relation.only[-1].right
        if are_perpendicular(axis, own):
            return "across"
        return "along" if are_parallel(axis, own) else kind

    def _came_along(self, line: Line) -> Sentence | None:
        """That the angle of deflection is one to an axis, as the body came along that."""
        sense = self._sense_before(line)
        if sense is None:
            return None
        (body,) = line.move.bodies
        late = Quantity("velocity", (Name(body),), line.move.event)
        velocity, axis = map(self._naming.layout, (late, sense))
        return say("turned.from-axis", body=body, axis=axis, velocity=velocity)

    def _sense_before(self, line: Line) -> Expression | None:
        """The axis along which the data have a body come to its first impact, with its sense."""
        (body,) = line.move.bodies
        events = [n for n, event in self._naming.events.items() if body in event.bodies]
        if line.move.event != min(events):
            return None
        sense = None
        for ref in line.premises:
            fact = self._derivation.fact(ref)
            match None if fact is None else fact.relation.options[0][0]:
                case Link(Quantity("velocity", (Name(own),)), "=", right) if own == body:
                    if all(map(self._reasons.is_positive, letters(right))):
                        sense = _sense_of(right)
        return sense

    def _has_across(self, line: Line, axis: Expression) -> bool:
        """Whether a component across a line is resolved in the part of a line."""
        parts = self._derivation.asked
        for own in self._derivation.lines:
            match own.relation:
                case Relation(((Link(Quantity("across", (_, other))), *_),)) if other == axis:
                    together = parts.get(own.item or "") == parts.get(line.item or "")
                    if together and own.move.record == line.move.record:
                        return True
        return False

    def _is_turned(self, line: Line, number: int) -> bool:
        """Whether components are those of an earlier impact, at right angles to this one's line."""
        kinds: set[tuple[str, str]] = set()
        for own in self._derivation.lines:
            if own.move != line.move or not isinstance(own.relation, Relation):
                continue
            match own.relation.options:
                case ((Link(Quantity(kind, (Quantity(), _)), "="),),):
                    pass
                case _:
                    continue
            for premise in filter(None, map(self._cited, own.premises)):
                subject = premise.relation
                left = subject.only[0].left if isinstance(subject, Relation) else subject.quantity
                meaning = self._naming.meanings.get(left.name) if isinstance(left, Letter) else None
                left = left if meaning is None else meaning.quantity
                match left:
                    case Quantity(other, (Quantity(), Quantity("line_of_centres", _, stage))):
                        if stage != number:
                            kinds.add((kind, other))
        return bool(kinds) and all(kind != other for kind, other in kinds)


def is_at_rest(fact: Fact) -> bool:
    """Whether a velocity is given as that of a body at rest."""
    return is_rest(fact.relation.only[0].right)


def _sense_of(velocity: Expression) -> Expression | None:
    """**i** or **j**, or its opposite, along which a velocity is; None of any other."""
    match velocity:
        case Unit():
            return velocity
        case Negate(operand):
            sense = _sense_of(operand)
            return None if sense is None else negated(sense)
        case Binary("*", Number() | Letter() | Binary("*", Number(), Letter()), Unit() as unit):
            return unit  # numbers carry no sign
        case Polar(_, Degrees(angle), None | Unit("i"), None):
            return _AT_RIGHT_ANGLES.get(int(angle)) if angle.denominator == 1 else None
        case Polar(_, Negate(Degrees(angle)), None | Unit("i"), None):
            return Negate(Unit("j")) if angle == _QUARTER else None
    return None


_QUARTER = 90
_AT_RIGHT_ANGLES: Mapping[int, Expression] = {
    0: Unit("i"),
    90: Unit("j"),
    180: Negate(Unit("i")),
    270: Negate(Unit("j")),
}
