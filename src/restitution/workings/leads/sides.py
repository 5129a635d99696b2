"""Which of two sides of **i** is worked out: said before the first line that takes it."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Negate,
    Quantity,
    Unit,
    has_unit_vector,
)
from restitution.workings.naming.quantities import Naming


class Sides:
    """What is said of a line of centres, or a wall, of which the data leave the side open."""

    def __init__(self, derivation: Derivation, naming: Naming) -> None:
        self._derivation = derivation
        self._naming = naming
        self._done: set[int | None] = set()
        self._open = {
            line.move.event for line in derivation.lines if line.move.record == "either-side"
        }

    def before(self, line: Line) -> Iterator[Sentence]:
        """What stands above the first line of an impact whose line may be on either side."""
        number = line.move.event
        event = self._naming.events.get(number or 0)
        if number not in self._open or number in self._done or event is None:
            return
        if line.move.record not in ("component", "assemble"):
            return
        self._done.add(number)
        wall = {"wall": event.bodies[1]} if event.wall else {}
        angle = self._angle_given(line)
        if angle is not None:
            name: SentenceId = "sided.wall-at" if event.wall else "sided.spheres-at"
            yield say(name, angle=self._naming.layout(angle), **wall)
        else:
            yield say("sided.wall" if event.wall else "sided.spheres", **wall)
        units = self._units(number)
        if len(units) == 2:
            one, other = map(self._naming.layout, units)
            pair = "sided.wall-units" if event.wall else "sided.spheres-units"
            yield say(pair, along=one, across=other, **wall)
        if len(units) == 1 and not self._naming.bold.has_unit(event.number):
            (only,) = map(self._naming.layout, units)
            one_unit = "sided.wall-unit" if event.wall else "sided.spheres-unit"
            yield say(one_unit, along=only, **wall)

    def _angle_given(self, line: Line) -> Expression | None:
        """The angle in degrees between **i** and the line, as a fact that is cited gives it."""
        for fact in self._derivation.facts_in(line.premises):
            match fact.relation.options:
                case ((Link(Quantity("angle", sides), "=", Degrees() as angle),),) if (
                    Unit("i") in sides
                ):
                    return angle
        return None

    def _units(self, number: int | None) -> tuple[Expression, ...]:
        """The unit vectors, along the normal and perpendicular to it, of which a line is made.

        The first alone where a velocity changes along the normal only.
        """
        for line in self._derivation.lines:
            if line.move.event != number or not isinstance(line.relation, Relation):
                continue
            match line.move.record, line.relation.options[0][0].right:
                case "changed-velocity", Binary("+" | "-", _, change):
                    unit = _unit(change)
                    return () if unit is None else (unit,)
                case "assemble", Binary("+" | "-", left, right):
                    units = tuple(map(_unit, (left, right)))
                    if all(units):
                        return tuple(unit for unit in units if unit is not None)
        return ()


def _unit(term: Expression) -> Expression | None:
    """The vector in brackets of a term; None of a term without brackets."""
    match term:
        case Negate(operand):
            return _unit(operand)
        case Binary("*", _, Binary("+" | "-") as vector) if has_unit_vector(vector):
            return vector
    return None


__all__ = ["Sides"]
