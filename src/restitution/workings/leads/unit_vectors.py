"""What a unit vector is of which a velocity is made, where no letter and no line has it."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.derivation import Derivation, Event, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Negate,
    Quantity,
    Unit,
    has_unit_vector,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import negative, product, total
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.workings.naming.quantities import Naming

_AXES = (Unit("i"), Unit("j"))
# The ratios of the angle of a line of centres, and of that of a wall, in a unit vector.
_RATIOS = {False: ("cos", "sin"), True: ("sin", "cos")}


class UnitVectors:
    """The unit vector along which a velocity changes, before the first line that has it."""

    def __init__(self, derivation: Derivation, naming: Naming) -> None:
        self._derivation = derivation
        self._naming = naming
        self._done: set[int] = set()
        # Where the data leave its side open, it is said with the side that is taken.
        self._chosen = {
            line.move.event for line in derivation.lines if line.move.record == "either-side"
        } & {line.move.event for line in derivation.lines if line.move.record == "component"}

    def before(self, line: Line) -> Iterator[Sentence]:
        """What the unit vector in a line is, and from which angle it comes."""
        event = self._naming.events.get(line.move.event or 0)
        if line.move.record != "changed-velocity" or event is None or event.number in self._done:
            return
        match line.relation:
            case Relation(((Link(_, "=", Binary("+" | "-", _, change)), *_),)):
                unit = _unit(change)
            case _:
                return
        self._done.add(event.number)
        if unit is None or self._is_known(event, line) or event.number in self._chosen:
            return
        sides = [self._naming.layout(unit)]
        if (by_angle := self._by_its_angle(event, unit)) is not None:
            sides.insert(0, self._naming.layout(by_angle))
        slots: dict[str, lay.Layout | str] = {
            "unit": sides[0] if len(sides) == 1 else lay.Relation(tuple(sides), ("=",))
        }
        if event.wall:
            towards = self._naming.bold.leads_into(event)
            name = "units.plain-wall" if towards else "units.plain-normal"
            yield say(name, wall=event.bodies[1], **slots)
        else:
            first, second = event.bodies
            yield say("units.plain-spheres", first=first, second=second, **slots)

    def _is_known(self, event: Event, line: Line) -> bool:
        """Whether the direction has a letter, or a line above."""
        if self._naming.bold.has_letter(event.number):
            return True
        axis = Quantity("line_of_centres", (), event.number)
        for other in self._derivation.lines:
            if other.number >= line.number:
                return False
            match other.relation:
                case Relation(((Link(left, "=" | "parallel to"), *_),)) if left == axis:
                    return True
        return False

    def _by_its_angle(self, event: Event, unit: Expression) -> Expression | None:
        """A unit vector by the sine and the cosine of the degrees that the data give of the line.

        None where the vector itself has them, and of a line that is given otherwise.
        """
        name = f"wall {event.bodies[1]}" if event.wall else f"axis {event.number}"
        fact = self._derivation.fact(name)
        vector = in_letters(unit)
        match None if fact is None else fact.relation.options:
            case ((Link(_, _, turn),),) if isinstance(unsigned(turn), Degrees):
                degrees = unsigned(turn)
            case _:
                return None
        if not isinstance(degrees, Degrees) or not isinstance(vector, Vector):
            return None
        if any(isinstance(node, Apply) and node.function != "sqrt" for node in walk(unit)):
            return None
        own = degrees.value % 180
        acute = Degrees(min(own, 180 - own))
        terms: list[Expression] = []
        for ratio, part, axis in zip(_RATIOS[event.wall], vector, _AXES, strict=True):
            term = product(Apply(ratio, acute), axis)
            terms.append(negative(term) if part.is_negative else term)
        return total(terms)


def _unit(change: Expression) -> Expression | None:
    """The unit vector in a change of velocity; None of one without."""
    match change:
        case Negate(operand):
            return _unit(operand)
        case Binary("*", _, Binary("+" | "-" | "/") as vector) if has_unit_vector(vector):
            return vector
    return None


__all__ = ["UnitVectors"]
