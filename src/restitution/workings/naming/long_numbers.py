"""Whether a working has numbers that nobody reads, where the data are decimals."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Fact, Relation
from restitution.expression.tree import Number, has_root, walk
from restitution.workings.naming.figures import is_with_calculator
from restitution.workings.naming.roots_of_roots import has_unwieldy_root


def has_long_numbers(derivation: Derivation) -> bool:
    """Whether a working has roots that nobody reads, where velocities are decimals.

    One with a calculator anyway, for its angles, has figures for these. Not where the question has
    roots itself.
    """
    if is_with_calculator(derivation) or not any(map(_is_in_decimals, derivation.facts)):
        return False
    relations = (e.relation for e in derivation.lines if isinstance(e.relation, Relation))
    if not any(has_unwieldy_root(tree) for relation in relations for tree in relation.trees):
        return False
    data = [fact.relation for fact in derivation.facts if fact.kind != "geometry"]
    shown = [end.answer for end in derivation.items if end.shown]
    return not any(has_root(tree) for relation in (*data, *shown) for tree in relation.trees)


def _is_in_decimals(fact: Fact) -> bool:
    """Whether a datum is a velocity with a number that is no whole one."""
    return fact.id.startswith("velocity ") and any(
        isinstance(node, Number) and node.value.denominator > 1
        for tree in fact.relation.trees
        for node in walk(tree)
    )


__all__ = ["has_long_numbers"]
