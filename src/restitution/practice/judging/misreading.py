"""A misread datum: the question as the student read it, with one number for another."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction
from typing import Any

from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Number,
    Quantity,
    children,
    is_binary,
    walk,
)
from restitution.practice.judging.slips import with_child
from restitution.practice.script import Claim
from restitution.problem import Compare, Find, Given, Problem, Show


def misread_problems(problem: Problem, datum: Fraction, typed: Fraction) -> Iterator[Problem]:
    """The problem with ``typed`` in place of one number that is ``datum``, each in turn.

    Nobody misreads a coefficient of restitution as 1 or more: it is left out then, or inverted.
    """
    before = [_coefficient(event) for event in problem.events]
    for wanted in range(_count(problem, datum)):
        own = _Exchange(datum, typed, wanted).of(problem)
        after = [_coefficient(event) for event in own.events]
        if not any(new >= 1 > old for old, new in zip(before, after, strict=True)):
            yield own


def _coefficient(event: object) -> Fraction:
    """The number that the coefficient of an impact is; zero where it is none."""
    match getattr(event, "e", None):
        case Number(value):
            return value
        case Binary("/", Number(above), Number(below)) if below:
            return above / below
    return Fraction(0)


def left_for_lost(problem: Problem) -> Iterator[tuple[Fraction, Fraction]]:
    """Numbers with the data that they replace, where what is left of an energy is read as lost.

    Of a third it is two thirds: the numerator of 1/3 is 2 then.
    """
    for _, step in problem.steps():
        for relation in step.relations if isinstance(step, Given) else ():
            sides = relation.operands if isinstance(relation, Compare) else ()
            nodes = [node for side in sides for node in walk(side)]
            if not any(isinstance(node, Quantity) and "energy" in node.kind for node in nodes):
                continue
            for node in nodes:
                match node:
                    case Number(value) if 0 < value < 1:
                        yield 1 - value, value
                    case Binary("/", Number(above), Number(below)) if 0 < above < below:
                        yield below - above, above


def reread_once(claim: Claim, typed: Fraction, datum: Fraction) -> Iterator[Claim]:
    """A claim with ``datum`` in place of one number that is ``typed``, each in turn."""
    for left in _once(claim.left, typed, datum):
        yield replace(claim, left=left)
    for right in _once(claim.right, typed, datum):
        yield replace(claim, right=right)


def _once(tree: Expression, typed: Fraction, datum: Fraction) -> Iterator[Expression]:
    """A tree with another number in one place; exponents stay."""
    if isinstance(tree, Number | Degrees):
        if tree.value == typed:
            yield replace(tree, value=datum)
        return
    power = is_binary(tree, "^")
    for place, child in enumerate(children(tree)):
        for new in _once(child, typed, datum) if not (power and place) else ():
            yield with_child(tree, place, new)


def _count(problem: Problem, datum: Fraction) -> int:
    counting = _Exchange(datum, datum, -1)
    counting.of(problem)
    return counting.seen


class _Exchange:
    """Puts a number in the place of the ``wanted``-th number that is ``datum``.

    What is asked and printed stays.
    """

    def __init__(self, datum: Fraction, typed: Fraction, wanted: int) -> None:
        self.datum, self.typed, self.wanted = datum, typed, wanted
        self.seen = 0

    def of(self, value: Any) -> Any:
        """A value with its numbers exchanged."""
        if isinstance(value, Number | Degrees):
            return self._number(value)
        if self._is_fraction(value):
            self.seen += 1
            return Number(self.typed) if self.seen - 1 == self.wanted else value
        if isinstance(value, tuple):
            return tuple(self.of(part) for part in value)
        if not is_dataclass(value) or isinstance(value, type | Find | Show):
            return value
        put: dict[str, Any] = {}
        for field in fields(value):
            old = getattr(value, field.name)
            new = old if field.name == "place" else self.of(old)
            if new is not old and new != old:
                put[field.name] = new
        return replace(value, **put) if put else value

    def _is_fraction(self, value: Any) -> bool:
        """Whether a value is the datum written as a fraction of two numbers."""
        match value:
            case Binary("/", Number(above), Number(below)) if below:
                return above / below == self.datum
        return False

    def _number(self, node: Number | Degrees) -> Number | Degrees:
        if node.value != self.datum:
            return node
        self.seen += 1
        return replace(node, value=self.typed) if self.seen - 1 == self.wanted else node
