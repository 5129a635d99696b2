"""Lines of energies as they are typed: their halves, their squares, and what is given of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import permutations

from restitution.expression.tree import (
    Binary,
    Expression,
    Negate,
    Number,
    Quantity,
    is_binary,
    is_quantity,
    letters,
    walk,
)
from restitution.practice.judging.claimed import meant_by
from restitution.practice.judging.entries import Entry
from restitution.practice.reading.relations import worked_out
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Given

_TWO = Number(Fraction(2))


def is_given_energy(tree: Expression, world: World) -> bool:
    """Whether a number is that of an energy, or of a loss of it, which the question gives."""
    return any(are_one_number(value, tree) for _, value in given_energies(world))


def are_one_number(one: Expression, other: Expression) -> bool:
    """Whether two trees are alike, or numbers of one value: 45/4 and 11.25."""
    return one == other or (worked_out(one) is not None and worked_out(one) == worked_out(other))


def given_energies(world: World) -> Iterator[tuple[Quantity, Expression]]:
    """The energies, and losses of it, that the question gives, with their values."""
    given = (
        pair
        for _, step in world.problem.steps()
        if isinstance(step, Given)
        for relation in step.relations
        if isinstance(relation, Compare)
        for pair in permutations(relation.operands, 2)
    )
    for one, other in given:
        if isinstance(one, Quantity) and "energy" in one.kind:
            yield one, other


def is_loss_of_known(entry: Entry, entries: Sequence[Entry]) -> bool:
    """Whether a number is given for a loss of which both energies stand above, rightly."""
    lost = meant_by(entry)
    match lost:
        case Quantity("energy_lost", (), int(number)) if isinstance(entry.claim.right, Number):
            wanted = {number - 1, number}
        case Quantity("total_energy_lost", (), int(number)) if isinstance(
            entry.claim.right, Number
        ):
            wanted = {0, number}
        case _:
            return False
    known = (meant_by(other) for other in entries if other.right and other.is_value)
    stages = {x.stage for x in known if is_quantity(x, "energy") and not x.arguments}
    return wanted <= stages


_HALVES = (Number(Fraction(1, 2)), Binary("/", Number(Fraction(1)), Number(Fraction(2))))


def is_halved(entry: Entry, world: World) -> bool:
    """Whether every term with a square, or a product, has its ½: none is left out there.

    It may be a mass of ½ instead.
    """
    if any(sphere.mass in _HALVES for sphere in world.problem.spheres):
        return False
    sides = entry.claim.left, entry.claim.right
    terms = [term for side in sides for term in _terms(side) if not isinstance(term, Number)]
    return bool(terms) and all(map(has_half, terms))


def _terms(tree: Expression) -> Iterator[Expression]:
    """The terms of a sum."""
    match tree:
        case Binary("+" | "-", left, right):
            yield from _terms(left)
            yield from _terms(right)
        case Negate(operand):
            yield from _terms(operand)
        case _:
            yield tree


def has_half(tree: Expression) -> bool:
    """Whether a factor ½ stands in a tree."""
    halves = (Number(Fraction(1, 2)), Binary("/", Number(Fraction(1)), _TWO))
    return any(node in halves for node in walk(tree))


def are_energies(entry: Entry) -> bool:
    """Whether either side of a claim has masses or halves, and squares, as energies have."""
    sides = entry.claim.left, entry.claim.right
    massive = all(has_half(side) or letters(side) & {"m", "M"} for side in sides)
    return massive and all(map(has_square, sides))


def has_square(tree: Expression) -> bool:
    """Whether something is squared in a tree."""
    return any(is_binary(node, "^") and node.right == _TWO for node in walk(tree))
