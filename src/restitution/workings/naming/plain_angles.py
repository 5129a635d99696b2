"""Angles such as 37°, of whose ratios only a calculator knows, in the values of a working."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache

from restitution.explaining.lines.derivation import FLIPPED, Derivation, Relation
from restitution.expression.tree import (
    EXACT_ANGLE,
    Apply,
    Degrees,
    Expression,
    functions_in,
    has_root,
    has_standard_ratios,
    is_function,
    letters,
    walk,
)
from restitution.workings.naming.roots_of_roots import (
    is_nested_root,
    is_of_nested_roots,
    is_to_be_worked_out,
)
from restitution.workings.naming.sums_in_degrees import RATIOS, is_sum_with_inverse


def of_plain_angles(tree: Expression) -> bool:
    """Whether a number has ratios of angles such as 37°, of which only a calculator knows."""
    return has_plain_angles(tree) and not letters(tree)


def has_plain_angles(tree: Expression) -> bool:
    """Whether ratios of such angles stand in a value."""
    return bool(ratios_of_numbers(tree))


def is_by_calculator(trees: Iterable[Expression]) -> bool:
    """Whether a working has ratios of angles such as 37°, and is so one with a calculator."""
    return any(map(plain_angles, trees))


def is_with_calculator(derivation: Derivation) -> bool:
    """Whether a working is one with a calculator.

    At 15° it is, unless the question itself has roots; and so it is where roots stand below roots
    or a tangent is a sum of roots, and velocities are numbers.
    """
    relations = [e.relation for e in derivation.lines if isinstance(e.relation, Relation)]
    trees = [tree for relation in relations for tree in relation.trees if functions_in(tree)]
    angles = {angle for tree in trees for angle in plain_angles(tree)}
    if any(angle % EXACT_ANGLE for angle in angles) or any(map(_is_bound_by_a_sum, relations)):
        return True
    data = [fact.relation for fact in derivation.facts if fact.kind != "geometry"]
    shown = [end.answer for end in derivation.items if end.shown]
    if any(has_root(tree) for relation in (*data, *shown) for tree in relation.trees):
        return False
    velocities = (fact.relation for fact in derivation.facts if fact.id.startswith("velocity"))
    in_letters = any(letters(tree) for relation in velocities for tree in relation.trees)
    return bool(angles) or (not in_letters and any(map(_is_of_long_roots, relations)))


def _is_of_long_roots(relation: Relation) -> bool:
    """Whether a relation comes to a root of a sum of roots, or to a tangent that is such a sum."""
    for option in relation.options:
        for link in option:
            if not has_root(link.right):
                continue
            tangent = is_function(link.left, "tan")
            nodes = walk(link.right)
            if any(is_nested_root(node) and not is_to_be_worked_out(node) for node in nodes):
                return True
            if tangent and any(is_of_nested_roots(node, True) for node in nodes):
                return True
    return False


def _is_bound_by_a_sum(relation: Relation) -> bool:
    """Whether an inequality has the ratio of a sum of angles in it: tan(70° − arctan(4/3))."""
    return any(link.sign in FLIPPED for link in relation.options[0]) and any(
        map(has_ratio_of_a_sum, relation.trees)
    )


def has_ratio_of_a_sum(tree: Expression) -> bool:
    """Whether the ratio of a sum of angles in degrees stands in a value."""
    return any(is_sum_with_inverse(ratio.argument) for ratio in ratios_of_numbers(tree))


@lru_cache(maxsize=4096)
def plain_angles(tree: Expression) -> frozenset[Fraction]:
    """The numbers of degrees of which ratios, without roots, stand in a value."""
    return frozenset(
        ratio.argument.value
        for ratio in ratios_of_numbers(tree)
        if isinstance(ratio.argument, Degrees) and not has_standard_ratios(ratio.argument.value)
    )


@lru_cache(maxsize=4096)
def ratios_of_numbers(tree: Expression) -> tuple[Apply, ...]:
    """Sines, cosines and tangents of angles without letters in a value."""
    if RATIOS.isdisjoint(functions_in(tree)):
        return ()
    return tuple(
        node
        for node in walk(tree)
        if isinstance(node, Apply) and node.function in RATIOS and not letters(node)
    )
