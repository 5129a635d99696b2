"""Answers with four figures before their three, where lines below go on with the four."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Derivation, Line, Relation
from restitution.expression.tree import (
    Expression,
    has_quantity,
    is_function,
    letters,
    walk,
)
from restitution.render import layout as lay
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.figures import Figures
from restitution.workings.naming.measured import multiple_in_figures, worth
from restitution.workings.naming.plain_angles import has_plain_angles
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.sums_in_degrees import degrees_of, is_inverse


def one_figure_more(
    derivation: Derivation, ends: Ends, naming: Naming, figures: Figures, line: Line
) -> lay.Layout | None:
    """A value by its figures before it is rounded; None where it was not yet rounded above.

    An angle has them only where lines below go on with it.
    """
    (first, *_) = line.premises if line.move.id == "value" else (None,)
    above = derivation.line(first)
    relation = None if above is None else above.relation
    if above is None or not isinstance(relation, Relation) or len(relation.options) > 1:
        return None
    value = relation.only[-1].right
    if is_inverse(value) and goes_into_numbers(derivation, ends, line, value):
        degrees = degrees_of(value) if figures.with_calculator else None
        return None if degrees is None else naming.layout(degrees)
    end = ends.of(above)
    if end is None or end.shown:
        return None
    return multiple_in_figures(value, figures.count(value))


def goes_into_numbers(derivation: Derivation, ends: Ends, line: Line, value: Expression) -> bool:
    """Whether lines below have in them the value of an answer that only a calculator knows."""
    if not has_plain_angles(value) or letters(value) or ends.of(line) is None:
        return False
    above = (own for own in derivation.lines if own.number < line.number and own.shown != "silent")
    stands = any(e.relation.trees[-1] == value for e in above if isinstance(e.relation, Relation))
    if stands and not is_inverse(value):
        return False  # the figures stand there
    below = [
        own
        for own in derivation.lines
        if own.number > line.number
        if own.shown != "silent" and own.move.id not in ("value", "answer")
    ]
    later = (own for own in below if ends.part(own) != ends.part(line))
    if any(own.move.id == "put" and line.number in own.premises for own in later):
        return True  # it is said with which figures it comes from an earlier part
    nodes = {node for own in below for tree in own.relation.trees for node in walk(tree)}
    return value in nodes or any(_is_root_of(node, value) for node in nodes)


def _is_root_of(node: Expression, value: Expression) -> bool:
    """Whether a root, perhaps with a number, is a speed that is written by its components."""
    roots = any(is_function(own, "sqrt") for own in walk(node))
    if not (roots and is_function(value, "sqrt")):
        return False
    if letters(node) or has_quantity(node) or not has_plain_angles(node):
        return False
    return bool(abs(sp.N(worth(node) - worth(value))) < _SAME)


_SAME = 1e-9


__all__ = ["goes_into_numbers", "one_figure_more"]
