"""Where the centre of a ball is that touches a wall, or another: said before a line needs it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Fact,
    Line,
    Link,
    Relation,
    equality,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import Binary, Expression, Name, Quantity, Unit
from restitution.planning.writing.forms import ZERO, swept, total, tree_of
from restitution.problem import Arrival
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.workings.naming.measured import vector_worth, with_its_unit, worth
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.sources import says_a_time


class Radii:
    """What is said of the radii of balls at straight walls, and of two balls, each once."""

    def __init__(self, derivation: Derivation, naming: Naming) -> None:
        self._derivation = derivation
        self._naming = naming
        self._done: set[str] = set()
        radii = (sphere.radius for sphere in naming.problem.spheres)
        # All spheres have one radius, which may be given of one of them.
        self._radius = next((radius for radius in radii if isinstance(radius, Expression)), None)

    def before(self, line: Line) -> Iterator[Sentence]:
        """What stands above a line that uses where a centre is at a wall."""
        if line.move.record != "straight-line":
            return
        for ref in line.premises:
            if not isinstance(ref, str) or ref.partition(" ")[0] != "contact" or ref in self._done:
                continue
            sentence = self._sentence(line, ref)
            if sentence is not None:
                self._done.add(ref)
                yield sentence

    def _of_spheres(self, event: Event, fact: Fact) -> Sentence | None:
        """Where the second sphere is at an impact, from the place of the first."""
        one, other = event.bodies
        (link,) = fact.relation.only
        match link.left, link.right:
            case Quantity("position"), Binary("+" | "-" as op, Quantity("position"), gap):
                away = vector_worth(gap)
            case _:
                return None
        if away is None:
            return None
        place = Vector(-away.x, -away.y) if op == "+" else away
        size = tidy(sp.sqrt(away.dot(away)))
        return say(
            "touch.spheres",
            one=one,
            other=other,
            way=self._naming.layout(tree_of(Vector(tidy(place.x / size), tidy(place.y / size)))),
            distance=self._length(self._naming.layout(tree_of(size))),
            place=self._length(self._naming.layout(tree_of(place))),
        )

    def _of_a_gap(self, line: Line, event: Event, fact: Fact) -> Sentence | None:
        """How far apart the centres of two spheres are that touch, before the time of that.

        Where that brings one of them to 0, from the place of the other, it is said.
        """
        match fact.relation.only[0].right:
            case Binary("+" | "-" as op, Quantity("position"), gap):
                away = vector_worth(gap)
            case _:
                return None
        if away is None or not any(away):
            return None
        one, other = event.bodies
        size = self._naming.layout(tree_of(tidy(sp.sqrt(away.dot(away)))))
        slots: dict[str, Any] = {"one": one, "other": other, "distance": self._length(size)}
        body = line.move.bodies[0]
        alone = len(line.move.bodies) == 1  # of two that move, neither has the place of the other
        beside = self._place_of(line, one if body == other else other) if alone else None
        if beside is not None and 0 in away and (away.x == 0) == (beside.x == 0):
            axis, place, share = ("x", beside.x, away.x) if away.y == 0 else ("y", beside.y, away.y)
            gap_ = share if (op == "-") == (body == other) else -share
            if tidy(place + gap_) == 0:
                sum_ = swept(total((tree_of(place), tree_of(gap_))))
                zero = self._naming.relation(equality(sum_, ZERO))
                return say("touch.gap-to-zero", body=body, axis=axis, zero=zero, **slots)
        return say("touch.gap", **slots)

    def _place_of(self, line: Line, body: str) -> Vector | None:
        """The place of a body in a line on which another one rests."""
        for own in self._derivation.lines_in(line.premises):
            match own.relation:
                case Relation(((*_, Link() as last),)) if own.relation.only[0].left == Quantity(
                    "position", (Name(body),), line.move.event
                ):
                    return vector_worth(last.right)
        return None

    def _sentence(self, line: Line, ref: str) -> Sentence | None:
        fact = self._derivation.fact(ref)
        event = self._naming.events.get(int(ref.partition(" ")[2]))
        if fact is None or event is None:
            return None
        wall = self._wall_reached(event)
        if wall is None and says_a_time(line):
            return self._of_a_gap(line, event, fact)
        if wall is None:
            second = "origin" in line.premises and line.move.bodies == event.bodies[1:]
            return self._of_spheres(event, fact) if second else None
        radius = self._radius
        match fact.relation.only[0]:
            case Link(Quantity("along", (Quantity("position"), Unit(axis))), "=", right):
                pass
            case _:
                return None
        if radius is None or worth(radius) == 0:
            return None
        sides: list[lay.Layout] = [self._naming.layout(right)]
        value = self._naming.layout(tree_of(worth(right)))
        if value != sides[0]:
            sides.append(value)
        sides[-1] = self._length(sides[-1])
        return say(
            "touch.wall" if event.wall else "touch.reached",
            body=event.bodies[0],
            wall=wall,
            radius=self._length(self._naming.layout(radius)),
            axis="x" if axis == "i" else "y",
            value=sides[0] if len(sides) == 1 else lay.Relation(tuple(sides), ("=",)),
        )

    def _wall_reached(self, event: Event) -> str | None:
        """The wall that a body strikes in an event, or to which it comes; None of any other."""
        if event.wall:
            return event.bodies[1]
        match self._naming.problem.events[event.number - 1]:
            case Arrival(_, Name(name)) if name in {w.name for w in self._naming.problem.walls}:
                return name
        return None

    def _length(self, formula: lay.Layout) -> lay.Layout:
        """A length, with its unit where it is a number."""
        return with_its_unit(formula, self._naming.unit(Quantity("distance", ())))
