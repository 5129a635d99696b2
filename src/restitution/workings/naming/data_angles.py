"""Angles of the data that are told by a ratio: their sines and cosines, before they are used."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import groupby

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.data.paths_and_lines import (
    angle_between,
    angles_between,
    degrees_of,
    turn_of_line,
    turn_of_path,
)
from restitution.explaining.lines.derivation import Derivation, Fact, Line, Link, Ref, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import trees_of
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Unit,
    functions_in,
    is_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import tree_of
from restitution.render import layout as lay
from restitution.workings.naming.quantities import Naming

_ARCS = frozenset({"arctan", "arcsin", "arccos"})


class DataAngles:
    """What is said of the angles of the data; each once."""

    def __init__(self, derivation: Derivation, naming: Naming) -> None:
        self._derivation = derivation
        self._naming = naming
        self._seen: set[Expression] = set()
        self._turned: set[str] = set()
        self._of_velocities: dict[Ref, Fact] = {
            e.id: e for e in derivation.facts if _is_of_velocity(e)
        }
        self._at_events: dict[int | None, list[Ref]] = {}
        for line in derivation.lines:
            own = [ref for ref in line.premises if ref in self._of_velocities]
            self._at_events.setdefault(line.move.event, []).extend(own)

    def in_order(self, lines: Sequence[Line]) -> Iterator[Line]:
        """Lines with the ratios of angles that follow each other in the order of the statement."""
        order = {fact.id: n for n, fact in enumerate(self._derivation.facts)}
        for ratios, run in groupby(lines, lambda line: line.move.id == "triangle"):
            own = list(run)
            places = {e.number: [order[r] for r in e.premises if r in order] for e in own}
            if ratios and all(places.values()):
                own.sort(key=lambda line: min(places[line.number]))
            yield from own

    def before(self, line: Line) -> Iterator[Sentence]:
        """The ratios of an angle in a velocity of which a line takes components."""
        if line.move.id not in ("law", "define") or not self._of_velocities:
            return
        # The angles of all velocities before an impact are spoken of together.
        own = [ref for ref in line.premises if ref in self._of_velocities]
        for ref in dict.fromkeys((*own, *self._at_events.get(line.move.event, ()))):
            fact = self._of_velocities[ref]
            trees = [e for e in trees_of(fact.relation) if not _ARCS.isdisjoint(functions_in(e))]
            for node in (node for tree in trees for node in walk(tree)):
                if not isinstance(node, Apply) or node.function not in _ARCS:
                    continue
                if node not in self._seen and not letters(node.argument):
                    self._seen.add(node)
                    yield from self._ratios(node)
            yield from self._to_the_line(fact, line)

    def _to_the_line(self, fact: Fact, line: Line) -> Iterator[Sentence]:
        """The angle of a velocity with a wall or a line of centres, where both are told from **i**.

        It is said where components are taken by its sine or its cosine.
        """
        event = next((e for e in self._derivation.events if e.number == line.move.event), None)
        if event is None or fact.id in self._turned:
            return
        body = fact.id.partition(" ")[2]
        of_line = f"wall {event.bodies[1]}" if event.wall else f"axis {event.number}"
        line_fact = self._derivation.fact(of_line)
        right = None if line_fact is None else line_fact.relation.only[-1].right
        match fact.relation.only[-1].right:
            case Polar(_, Degrees(angle), None, Name(wall)) if not event.wall:
                yield from self._along(fact, wall, angle, right)
                return
        earlier = any(e.number < event.number and body in e.bodies for e in self._derivation.events)
        path, turn = turn_of_path(fact), turn_of_line(line_fact)
        if body not in event.bodies or earlier or path is None or turn is None:
            return
        own = self._angle(line, path, turn)
        if own is None:
            return
        self._turned.add(fact.id)
        if event.wall:
            yield say("given.turned-wall", body=body, wall=event.bodies[1], angle=own)
        else:
            yield say("given.turned-centres", body=body, angle=own)

    def _angle(self, line: Line, path: Expression, turn: Expression) -> lay.Layout | None:
        """The angle of a path with a line, as it is worked out; None where nobody needs it."""
        if turn == Degrees(Fraction(0)):
            return None
        whole = angle_between(path, turn)
        if whole is not None:
            value = degrees_of(whole)
            if value in (0, 90):
                return None
            if isinstance(whole, Degrees):
                return self._naming.layout(whole)
            link = Link(whole, "=", Degrees(value))
            return self._naming.relation(Relation(((link,),)))
        written = {
            node.argument
            for tree in trees_of(line.relation)
            for node in walk(tree)
            if isinstance(node, Apply)
        }
        if line.move.id != "law" or self._is_found(path) or self._is_found(turn):
            return None
        angles = [tree for tree in angles_between(path, turn) if tree in written]
        return self._naming.layout(angles[0]) if len(angles) == 1 else None

    def _is_found(self, angle: Expression) -> bool:
        """Whether lines, or a fact, tell a letter of an angle, or a ratio of it."""
        relations = [
            *(line.relation for line in self._derivation.lines),
            *(fact.relation for fact in self._derivation.facts),
        ]
        firsts = [own.options[0][0] for own in relations if isinstance(own, Relation)]
        sides = {link.left for link in firsts if link.sign == "="}
        names = letters(angle)
        return any(letters(side) & names for side in sides if isinstance(side, Apply | Letter))

    def _along(
        self, fact: Fact, wall: str, angle: Fraction, line: Expression | None
    ) -> Iterator[Sentence]:
        """That a velocity that makes an angle with a wall is along a line of centres."""
        own = self._derivation.fact(f"wall {wall}")
        match None if own is None else own.relation.only[-1].right:
            case Unit(axis):
                direction = (0 if axis == "i" else 90) - angle
            case _:
                return
        back = isinstance(line, Negate)
        match unsigned(line):
            case Degrees(turn) if (direction - (-turn if back else turn)) % 180 == 0:
                pass
            case _:
                return
        self._turned.add(fact.id)
        size = Degrees(abs(direction))
        yield say(
            "given.along-centres",
            body=fact.id.partition(" ")[2],
            wall=wall,
            angle=self._naming.layout(Degrees(angle)),
            direction=self._naming.layout(Negate(size) if direction < 0 else size),
            unit=self._naming.layout(Unit("i")),
        )

    def _ratios(self, arc: Apply) -> Iterator[Sentence]:
        try:
            value = in_letters(arc.argument)
        except RestitutionError:
            return
        angle = {"arctan": sp.atan, "arcsin": sp.asin, "arccos": sp.acos}[arc.function](value)
        written = self._naming.layout(arc.argument)
        sine, cosine = (self._naming.layout(tree_of(tidy(f(angle)))) for f in (sp.sin, sp.cos))
        own = _kind_of_angle(arc, value)
        if arc.function == "arctan":
            yield say("given.tangent", angle=own, value=written, sine=sine, cosine=cosine)
        elif arc.function == "arcsin":
            yield say("given.sine", angle=own, value=written, cosine=cosine)
        else:
            yield say("given.cosine", angle=own, value=written, sine=sine)


def _kind_of_angle(arc: Apply, value: sp.Expr) -> Sentence:
    """In which range an angle lies that is given by a ratio, so that the others follow."""
    if value.is_positive:
        return say("given.acute-angle")
    if arc.function == "arccos":
        return say("given.angle-of-an-arccosine")
    return say("given.angle-of-an-arcsine")


def _is_of_velocity(fact: Fact) -> bool:
    """Whether a fact says what a velocity is, at the start or after an event."""
    links = fact.relation.options[0]
    given = any(is_quantity(e.left, "velocity") for e in links)
    return fact.id.partition(" ")[0] == "velocity" or given


__all__ = ["DataAngles"]
