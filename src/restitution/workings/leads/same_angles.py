"""An angle to the line of centres that has a letter as the one to a wall: said before its use."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.derivation import Derivation, Line, Link, Meaning, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import Letter, Name, Quantity, Unit
from restitution.workings.naming.quantities import Naming


class SameAngles:
    """The walls that are parallel to a line of centres, where one letter serves for both."""

    def __init__(self, derivation: Derivation, naming: Naming) -> None:
        self._derivation = derivation
        self._naming = naming
        self._done: set[int] = set()

    def before(self, line: Line) -> Iterator[Sentence]:
        """What stands above the first line with such an angle, of which no line says that."""
        for own in self._derivation.lines_in(line.premises):
            if own.shown != "silent" or own.move.record != "difference":
                continue
            match own.relation:
                case Relation(((Link(Letter(left), "=", Letter(right) as angle),),)):
                    one, other = self._sides(left), self._sides(right)
                case _:
                    continue
            match one, other:
                case (
                    (Quantity("velocity") as velocity, Quantity("line_of_centres")),
                    (Quantity("velocity") as same, Name(wall)),
                ) if velocity == same and own.number not in self._done:
                    self._done.add(own.number)
                    moving = self._naming.layout(velocity)
                    letter = self._naming.layout(angle)
                    yield say("same.one-letter", wall=wall, velocity=moving, angle=letter)
                case (
                    (Quantity("velocity") as velocity, Name(wall)),
                    (Quantity("velocity") as same, Unit() as unit),
                ) if velocity == same and own.number not in self._done:
                    self._done.add(own.number)
                    moving, axis = self._naming.layout(velocity), self._naming.layout(unit)
                    letter = self._naming.layout(angle)
                    yield say(
                        "same.letter-of-axis", wall=wall, axis=axis, velocity=moving, angle=letter
                    )

    def _sides(self, letter: str) -> tuple[object, ...]:
        """Between what the angle lies for which a letter stands."""
        meaning: Meaning | None = self._derivation.meanings.get(letter)
        fact = self._derivation.fact(f"let {letter}")
        own = fact.relation.only[0].left if meaning is None and fact is not None else None
        match own if meaning is None else meaning.quantity:
            case Quantity("angle", sides):
                return sides
            case Quantity("direction", (Name() as body,), int(stage)):
                return Quantity("velocity", (body,), stage), Unit("i")
        return ()


__all__ = ["SameAngles"]
