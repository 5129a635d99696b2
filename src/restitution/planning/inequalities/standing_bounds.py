"""Claims about letters that follow of an inequality on paper: of e > 1/k, that k > 1."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Apply, Quantity, has_quantity, letters, walk
from restitution.planning.inequalities.comparing import Comparing


def write_by_a_standing_bound(claims: Comparing, relation: Relation) -> int | None:
    """An inequality of letters by one that stands, and the ranges of the others in that."""
    trees = trees_of(relation)
    names = frozenset(name for tree in trees for name in letters(tree))
    if len(relation.only) != 1 or not names or any(map(has_quantity, trees)):
        return None
    for number, own in _standing(claims):
        others = own - names
        if names <= own and others:
            pool = (number, *claims.judge.known(others))
            line = claims.judge.write((Move("compare"),), pool, relation)
            if line is not None:
                return line
    return None


def _standing(claims: Comparing) -> Iterator[tuple[int, frozenset[str]]]:
    """The single inequalities of letters that stand, the last first, each with its letters.

    None of a sine, cosine or tangent: what its square bounds has a line of its own.
    """
    desk = claims.scene.desk
    for line in reversed(desk.lines):
        match line.relation:
            case Relation(((Link(left, sign, right),),)) if sign in FLIPPED:
                nodes = (node for side in (left, right) for node in walk(side))
                plain = not any(isinstance(node, Apply | Quantity) for node in nodes)
                if plain and desk.holds(line.number):
                    yield line.number, letters(left) | letters(right)


__all__ = ["write_by_a_standing_bound"]
