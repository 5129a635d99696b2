"""How far from a wall the centre of a ball is that touches it: said before a line needs it."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.derivation import Derivation, Line, Link
from restitution.explaining.saying import Sentence, say
from restitution.expression.tree import Expression, Quantity, Unit
from restitution.planning.forms import tree_of
from restitution.render import layout as lay
from restitution.workings.measured import with_its_unit, worth
from restitution.workings.naming import Naming


class Radii:
    """What is said of the radii of balls at straight walls, each once."""

    def __init__(self, derivation: Derivation, naming: Naming) -> None:
        self._derivation = derivation
        self._naming = naming
        self._done: set[str] = set()
        self._radii = {
            sphere.name: sphere.radius
            for sphere in naming.problem.spheres
            if isinstance(sphere.radius, Expression)
        }

    def before(self, line: Line) -> Iterator[Sentence]:
        """What stands above a line that uses where a centre is at a wall."""
        if line.move.record != "straight-line":
            return
        for ref in line.premises:
            if not isinstance(ref, str) or ref.partition(" ")[0] != "contact" or ref in self._done:
                continue
            sentence = self._sentence(ref)
            if sentence is not None:
                self._done.add(ref)
                yield sentence

    def _sentence(self, ref: str) -> Sentence | None:
        fact = self._derivation.fact(ref)
        event = self._naming.events.get(int(ref.partition(" ")[2]))
        if fact is None or event is None or not event.wall:
            return None
        radius = self._radii.get(event.bodies[0])
        match fact.relation.only[0]:
            case Link(Quantity("along", (Quantity("position"), Unit(axis))), "=", right):
                pass
            case _:
                return None
        if radius is None or worth(radius) == 0:
            return None
        sides: list[lay.Layout] = [self._naming.laid(right)]
        value = self._naming.laid(tree_of(worth(right)))
        if value != sides[0]:
            sides.append(value)
        sides[-1] = self._length(sides[-1])
        return say(
            "touch.wall",
            body=event.bodies[0],
            wall=event.bodies[1],
            radius=self._length(self._naming.laid(radius)),
            axis="x" if axis == "i" else "y",
            value=sides[0] if len(sides) == 1 else lay.Relation(tuple(sides), ("=",)),
        )

    def _length(self, laid: lay.Layout) -> lay.Layout:
        """A length, with its unit where it is a number."""
        return with_its_unit(laid, self._naming.unit(Quantity("distance", ())))
