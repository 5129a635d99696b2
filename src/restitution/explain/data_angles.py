"""Angles of the data that are told by a ratio: their sines and cosines, before they are used."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explain.naming import Naming
from restitution.explaining.derivation import Derivation, Fact, Line
from restitution.explaining.saying import Sentence, say
from restitution.explaining.trees import trees_of
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Apply, Expression, Quantity, letters, walk
from restitution.planning.forms import tree_of

_ARCS = ("arctan", "arcsin", "arccos")


class DataAngles:
    """What is said of the angles of the data; each once."""

    def __init__(self, derivation: Derivation, naming: Naming) -> None:
        self._derivation = derivation
        self._naming = naming
        self._told: set[Expression] = set()

    def in_order(self, lines: Sequence[Line]) -> Iterator[Line]:
        """Lines with the ratios of angles that follow each other in the order of the statement."""
        order = {fact.id: n for n, fact in enumerate(self._derivation.facts)}
        for ratios, run in groupby(lines, lambda each: each.move.id == "triangle"):
            own = list(run)
            places = {e.number: [order[r] for r in e.premises if r in order] for e in own}
            if ratios and all(places.values()):
                own.sort(key=lambda each: min(places[each.number]))
            yield from own

    def before(self, line: Line) -> Iterator[Sentence]:
        """The ratios of an angle in a velocity of which a line takes components."""
        if line.move.id not in ("law", "define"):
            return
        # The angles of all velocities before an impact are spoken of together.
        alike = (e for e in self._derivation.lines if e.move.event == line.move.event)
        for ref in dict.fromkeys(ref for each in (line, *alike) for ref in each.premises):
            fact = self._derivation.fact(ref) if isinstance(ref, str) else None
            if fact is None or not _is_of_velocity(fact):
                continue
            for node in (each for tree in trees_of(fact.relation) for each in walk(tree)):
                if not isinstance(node, Apply) or node.function not in _ARCS:
                    continue
                if node not in self._told and not letters(node.argument):
                    self._told.add(node)
                    yield from self._ratios(node)

    def _ratios(self, arc: Apply) -> Iterator[Sentence]:
        try:
            value = sp.sympify(evaluate(arc.argument, sp.Symbol), strict=True)
        except RestitutionError:
            return
        angle = {"arctan": sp.atan, "arcsin": sp.asin, "arccos": sp.acos}[arc.function](value)
        laid = self._naming.laid(arc.argument)
        sine, cosine = (self._naming.laid(tree_of(tidy(f(angle)))) for f in (sp.sin, sp.cos))
        if arc.function == "arctan":
            yield say("given.tangent", value=laid, sine=sine, cosine=cosine)
        elif arc.function == "arcsin":
            yield say("given.sine", value=laid, cosine=cosine)
        else:
            yield say("given.cosine", value=laid, sine=sine)


def _is_of_velocity(fact: Fact) -> bool:
    """Whether a fact says what a velocity is, at the start or after an event."""
    links = fact.relation.options[0]
    given = any(isinstance(e.left, Quantity) and e.left.kind == "velocity" for e in links)
    return fact.id.partition(" ")[0] == "velocity" or given


__all__ = ["DataAngles"]
