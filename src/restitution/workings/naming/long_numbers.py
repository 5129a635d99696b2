"""Whether a working has numbers that nobody reads, where the data are decimals."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Fact, Line, Relation
from restitution.expression.tree import Expression, Letter, Number, has_root, is_function, walk
from restitution.workings.naming.plain_angles import plain_angles
from restitution.workings.naming.roots_of_roots import (
    has_unwieldy_root,
    is_of_nested_roots,
    is_short_sum_of_a_root,
)

_THREE_FIGURES = 100


def has_long_numbers(derivation: Derivation) -> bool:
    """Whether a working has roots that nobody reads, where velocities are decimals.

    Where other data are, those of numbers of three figures alone, if one is used again. Not where
    the question has roots itself. The cosine of a scalar product does not count, nor its angle:
    these are figures in any case, and the components above them need none.
    """
    own = [fact for fact in derivation.facts if _is_in_decimals(fact)]
    if not own:
        return False
    relations = [
        line.relation
        for line in derivation.lines
        if isinstance(line.relation, Relation) and not _is_of_a_scalar_product(derivation, line)
    ]
    if any(fact.id.startswith("velocity ") for fact in own):
        lines, has_one = 1, has_unwieldy_root
    else:
        lines, has_one = 2, _has_a_root_of_three_figures
    if sum(any(map(has_one, relation.trees)) for relation in relations) < lines:
        return False
    data = [fact.relation for fact in derivation.facts if fact.kind != "geometry"]
    shown = [end.answer for end in derivation.items if end.shown]
    return not any(has_root(tree) for relation in (*data, *shown) for tree in relation.trees)


def _is_of_a_scalar_product(derivation: Derivation, line: Line) -> bool:
    """Whether a line has the cosine of an angle by a scalar product, or the angle by it."""
    above = derivation.lines_in(line.premises) if line.move.id == "inverse" else ()
    return any(own.move.record == "scalar-angle" for own in (line, *above))


def _has_a_root_of_three_figures(tree: Expression) -> bool:
    return has_root(tree) and any(
        is_function(node, "sqrt")
        and isinstance(node.argument, Number)
        and node.argument.value >= _THREE_FIGURES
        for node in walk(tree)
    )


def keeps_short_sums(derivation: Derivation) -> bool:
    """Whether short sums with a root stay exact, though there is a calculator: 3 + 2√3.

    They do where no line has a ratio of an angle such as 15° or 37°, and no letter is worth a
    longer sum.
    """
    relations = [e.relation for e in derivation.lines if isinstance(e.relation, Relation)]
    if any(plain_angles(tree) for relation in relations for tree in relation.trees):
        return False
    links = [link for relation in relations for option in relation.options for link in option]
    worths = [link.right for link in links if isinstance(link.left, Letter)]
    return all(is_short_sum_of_a_root(e) for e in worths if is_of_nested_roots(e, True))


def _is_in_decimals(fact: Fact) -> bool:
    """Whether a datum has a number that is no whole one: 0.2 kg, 2.5 m s⁻¹, or e = 0.6."""
    return fact.kind != "geometry" and any(
        isinstance(node, Number) and node.value.denominator > 1
        for tree in fact.relation.trees
        for node in walk(tree)
    )


__all__ = ["has_long_numbers"]
