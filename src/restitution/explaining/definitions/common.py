"""Parts of definitions: lines of centres, sums, squares, and what is cited as it stands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from restitution.explaining.lines.derivation import Event, Link, Relation, whole_of
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Binary,
    Expression,
    Number,
    Quantity,
    Unit,
)

ZERO = Number(Fraction(0))


def axis_of(event: Event) -> Quantity:
    """The line of centres of an event."""
    return Quantity("line_of_centres", (), event.number)


def total_of(terms: Sequence[Expression]) -> Expression:
    """The sum of one term or more."""
    total = terms[0]
    for term in terms[1:]:
        total = Binary("+", total, term)
    return total


def unit_vector(axis: str) -> Expression:
    """**i** or **j**."""
    return Unit(axis)  # type: ignore[arg-type]


def whole_links(step: Step) -> Iterator[Link]:
    """What is cited without alternatives, each chain from its first side to its last."""
    for premise in step.cited:
        if isinstance(premise.relation, Relation) and len(premise.relation.options) == 1:
            whole = whole_of(premise.relation.only)
            if whole is not None:
                yield whole
