"""Whether a working has numbers that nobody reads, where the data are decimals."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.expression.tree import has_root
from restitution.workings.naming.figures import is_with_calculator
from restitution.workings.naming.roots_of_roots import has_unwieldy_root


def has_long_numbers(derivation: Derivation) -> bool:
    """Whether a working has roots that nobody reads, where the question has none.

    One with a calculator anyway, for its angles, has figures for these.
    """
    if is_with_calculator(derivation):
        return False
    relations = (e.relation for e in derivation.lines if isinstance(e.relation, Relation))
    if not any(has_unwieldy_root(tree) for relation in relations for tree in relation.trees):
        return False
    data = [fact.relation for fact in derivation.facts if fact.kind != "geometry"]
    shown = [end.answer for end in derivation.items if end.shown]
    return not any(has_root(tree) for relation in (*data, *shown) for tree in relation.trees)


__all__ = ["has_long_numbers"]
