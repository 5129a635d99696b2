"""Sums that are put into other lines, without a denominator that only a number has.

A teacher puts *b = 2a − 13/3* into another equation, and *(b + 3/2)* **j** into a scalar product,
where one fraction would stand within another: *(2((6a − 13)/3) + 3)/2*.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line, Relation
from restitution.explaining.lines.trees import exchanged, of_relation, rebuilt, trees_of
from restitution.expression.tree import (
    Binary,
    Expression,
    Number,
    Unit,
    has_quantity,
    is_binary,
    letters,
    rational,
    unsigned,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.forms import negative, outer_terms, product, total

_SEVERAL = 2


def with_sums_apart(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which sums that are put in have a fraction in one term at most."""
    shown = {end.line for end in derivation.items if end.shown}
    if shown:
        return derivation
    relations = [e.relation for e in derivation.lines if isinstance(e.relation, Relation)]
    apart = {
        tree: own
        for relation in relations
        for side in trees_of(relation)
        for tree in _components(side)
        if is_binary(tree, "/") and letters(tree) and (own := _apart(tree)) is not None
    }
    for tree, own in apart.items():
        if sum(_stands_in(tree, relation) for relation in relations) >= _SEVERAL:
            derivation = _with(derivation, {tree: own}, oracle)
    return derivation


def _stands_in(tree: Expression, relation: Relation) -> bool:
    """Whether a tree stands somewhere in a relation."""
    return any(tree in walk(side) for side in trees_of(relation))


def _components(tree: Expression) -> Iterator[Expression]:
    """The terms of a side without their signs; of a component of a vector, its size."""
    for term in map(unsigned, outer_terms(tree)):
        match term:
            case Binary("*", size, Unit()):
                yield size
            case _:
                yield term


def _apart(tree: Expression) -> Expression | None:
    """A sum over a number as a sum, where its letters have whole numbers then; None of others.

    The number without letters keeps its denominator.
    """
    match tree:
        case Binary("/", Binary("+" | "-") as above, Number(below)) if below.denominator == 1:
            pass
        case _:
            return None
    if has_quantity(tree):
        return None
    plain: list[Expression] = []
    numbers: list[Expression] = []
    for term in outer_terms(above):
        own = unsigned(term)
        size, rest = _size_and_rest(own)
        share = size / below
        if (share.denominator == 1) == (rest is None):
            return None
        new = rational(share) if rest is None else product(rational(share), rest)
        (numbers if rest is None else plain).append(new if own is term else negative(new))
    return total([*plain, *numbers])


def _size_and_rest(term: Expression) -> tuple[Fraction, Expression | None]:
    """The number before a term, and what it is before; None of a number alone."""
    match term:
        case Number(size):
            return size, None
        case Binary("*", Number(size), rest):
            return size, rest
    return Fraction(1), term


def _with(derivation: Derivation, put: dict[Expression, Expression], oracle: Oracle) -> Derivation:
    """The working with other forms of values, where every line follows as it did.

    A line that puts a value into such a form has it in that form too.
    """

    def change(tree: Expression) -> Expression:
        return exchanged(tree, put)

    def with_values(tree: Expression) -> Expression:
        return rebuilt(tree, lambda node: _apart(node) or node)

    lines: list[Line] = []
    changed: set[int] = set()
    for line in derivation.lines:
        if isinstance(line.relation, Relation):
            own = of_relation(line.relation, change)
            if line.move.id == "put" and changed.intersection(line.premises):
                own = of_relation(own, with_values)
            if own != line.relation:
                changed.add(line.number)
                line = replace(line, relation=own)
        lines.append(line)
    items = tuple(replace(end, answer=of_relation(end.answer, change)) for end in derivation.items)
    whole = replace(derivation, lines=tuple(lines), items=items)
    read = reader_of(whole, oracle)
    return whole if all(read.accepts(read.lines[number]) for number in changed) else derivation


__all__ = ["with_sums_apart"]
