"""Where a body is that touches a wall or a point: said before a distance that is measured there."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from restitution.explaining.lines.derivation import Derivation, Fact, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Negate,
    Pair,
    Quantity,
    Unit,
    is_quantity,
    is_zero,
    unsigned,
)
from restitution.planning.writing.forms import tree_of
from restitution.workings.leads.particles import first_with_particles
from restitution.workings.naming.measured import vector_worth, with_its_unit
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.sources import says_a_time


class Touching:
    """The places that contacts tell, each said once."""

    def __init__(
        self, derivation: Derivation, naming: Naming, unprinted: Callable[[Line], bool]
    ) -> None:
        self._derivation = derivation
        self._naming = naming
        self._unprinted = unprinted
        self._done: set[tuple[str, int]] = set()
        self._first_with_particles = first_with_particles(derivation)

    def before(self, line: Line) -> Iterator[Sentence]:
        """What stands above a distance: the ends that no line gives, as a contact tells them.

        Above a way of another part, where that begins, as no line there has it.
        """
        if (first := self._first_with_particles) is not None and line.number == first.number:
            yield say("distance.particles")
        if line.move.record == "straight-line":
            yield from self._where_both_were(line)
            yield from self._level(line)
        if line.move.record != "distance" or line.move.event is not None:
            return
        assert isinstance(line.relation, Relation)
        left = line.relation.only[0].left
        if not isinstance(left, Quantity):
            return
        for argument in left.arguments:
            match argument:
                case Name(body) if isinstance(left.stage, int):
                    end = body, left.stage
                case Quantity("position", (Name(body),), int(number)):
                    end = body, number
                case _:
                    continue
            place = self._place(line, *end)
            if place is not None and end not in self._done:
                self._done.add(end)
                yield self._sentence(end, place)

    def _where_both_were(self, line: Line) -> Iterator[Sentence]:
        """Where a body begins its way: at one that it struck there, which was at rest."""
        for own in self._derivation.lines_in(line.premises):
            if not self._unprinted(own):
                continue
            match own.relation:
                case Relation(
                    ((Link(Quantity("position", (Name(body),), int(number)), "=", right),),)
                ) if (
                    f"contact {number}" in line.premises
                    and line.move.event not in (None, number)
                    and body not in line.move.bodies
                    and (body, number) not in self._done
                    and self._part(line) != self._part_of_event(number)
                    and (place := vector_worth(right)) is not None
                ):
                    self._done.add((body, number))
                    both = tuple(sorted((*line.move.bodies, body)))
                    where = self._naming.layout(Pair(tree_of(place.x), tree_of(place.y)))
                    event = self._naming.called(self._naming.events[number])
                    yield say("touch.both-at", bodies=both, event=event, place=where)

    def _level(self, line: Line) -> Iterator[Sentence]:
        """Why a body has a coordinate of another one as they collide, by which its time is."""
        number = line.move.event
        event = self._naming.events.get(number or 0)
        axis = self._naming.unit_of(event, "along")
        across = self._naming.unit_of(event, "across")
        if event is None or event.wall or axis is None or across is None or not says_a_time(line):
            return
        others = {body for body in event.bodies if body not in line.move.bodies}
        for own in self._derivation.lines_in(line.premises):
            left = own.relation.options[0][0].left if isinstance(own.relation, Relation) else None
            match left:
                case Quantity("along", (Quantity("position", (Name(body),), at), Unit(side))) if (
                    body in others and at == number and Unit(side) == unsigned(across)
                ):
                    coordinate = {"i": "x", "j": "y"}[side]
                    unit = self._naming.layout(unsigned(axis))
                    yield say("touch.level-then", axis=unit, coordinate=coordinate)
                    return

    def _part(self, line: Line) -> str | None:
        return self._derivation.asked.get(line.item or "")

    def _part_of_event(self, number: int) -> str | None:
        """The part in which the laws of an event stand first."""
        lines = (e for e in self._derivation.lines if e.move.event == number)
        return next((self._part(line) for line in lines if line.move.id == "law"), None)

    def _place(self, line: Line, body: str, number: int) -> Pair | None:
        """The coordinates of a body at a contact; None where a line has said them."""
        position = Quantity("position", (Name(body),), number)
        coordinates: dict[str, Expression] = {}
        for ref in line.premises:
            own = self._derivation.cited(ref)
            if own is None or not isinstance(own.relation, Relation):
                continue
            for link in own.relation.options[0]:
                match link:
                    case Link(Quantity("along", (at, Unit(axis))), "=", right) if at == position:
                        # A coordinate that is not zero has a row of its own.
                        if isinstance(ref, int) and not is_zero(right):
                            return None
                        coordinates[axis] = right
        return Pair(coordinates["i"], coordinates["j"]) if len(coordinates) == 2 else None

    def _sentence(self, end: tuple[str, int], place: Pair) -> Sentence:
        body, number = end
        position = self._naming.quantity(Quantity("position", (Name(body),), number))
        vector = vector_worth(place)
        if vector is not None and not any(vector):
            return say("touch.origin", position=position)
        layout = self._naming.layout(place if vector is None else tree_of(vector))
        unit = self._naming.unit(Quantity("distance", ()))
        return say("touch.at", position=position, place=with_its_unit(layout, unit))


def touching_beside(
    derivation: Derivation, naming: Naming, fact: Fact, line: Line
) -> Sentence | None:
    """In which coordinate two centres are apart, where the line of centres is along an axis.

    None of a contact that speaks of no radii, and where both coordinates are in a line.
    """
    match fact.relation.only:
        case (
            Link(
                Quantity("position", (Name(one),), int(number)),
                "=",
                Binary("+" | "-" as sign, Quantity("position", (Name(other),)), apart),
            ),
        ):
            pass
        case _:
            return None
    match apart:
        case (Unit() as axis) | Binary("*", _, Unit() as axis):
            pass
        case _:
            return None
    cited = derivation.lines_in(line.premises)
    lefts = [
        line.relation.only[0].left
        for line in cited
        if isinstance(line.relation, Relation) and len(line.relation.options) == 1
    ]
    axes = {
        left.arguments[1]
        for left in lefts
        if is_quantity(left, "along") and len(left.arguments) == 2
    }
    if len(axes) != 1:
        return None
    across = axes != {axis}
    coordinate = "x" if (axis == Unit("j")) is across else "y"
    if across:
        return say("touch.level", axis=naming.layout(axis), coordinate=coordinate)
    less, more = (one, other) if sign == "-" else (other, one)
    return say(
        "touch.along",
        coordinate=coordinate,
        less=less,
        more=more,
        approach=_approach(derivation, naming, less, more, axis, number),
    )


def _approach(
    derivation: Derivation, naming: Naming, less: str, more: str, axis: Unit, number: int
) -> Sentence:
    """How the sphere with the lesser coordinate and the other one approach along an axis."""
    forwards, back = naming.layout(axis), naming.layout(Negate(axis))
    # Of a later impact no datum tells which of the two moves along the axis.
    still = [
        body
        for body in (less, more)
        if number == 1
        and (own := derivation.fact(f"velocity {body}")) is not None
        and (velocity := vector_worth(own.relation.only[-1].right)) is not None
        and (velocity.x if axis == Unit("i") else velocity.y) == 0
    ]
    if still == [less]:
        return say("touch.comes", one=more, other=less, axis=back)
    if still == [more]:
        return say("touch.comes", one=less, other=more, axis=forwards)
    return say("touch.gains", one=less, other=more, axis=forwards)
