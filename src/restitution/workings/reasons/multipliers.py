"""By what an inequality is multiplied, where it is not seen that it is positive: 4 − 3e > 0."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction

from restitution.explaining.lines.derivation import FLIPPED, Derivation, Line, Link, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    has_quantity,
    is_binary,
    letters,
    walk,
)
from restitution.oracle import Oracle, Role
from restitution.oracle import Relation as Claim
from restitution.planning.writing.forms import factors
from restitution.workings.naming.in_force import inequalities
from restitution.workings.reasons.right_angles import in_letters_alone

_ZERO = Number(Fraction(0))


def multipliers_of(
    derivation: Derivation, roles: Mapping[str, Role], line: Line
) -> Iterator[Relation]:
    """The signs of the differences below in an inequality that are gone in the one it becomes."""
    (first, *_) = line.premises or ("",)
    above = derivation.line(first)
    if line.move.id != "rearrange" or above is None:
        return
    match above.relation, line.relation:
        case Relation(((Link(_, sign, _),),)), Relation((links,)) if sign in FLIPPED:
            if any(link.sign not in FLIPPED for link in links):
                return
        case _:
            return
    left = set(_differences_below(line.relation))
    given = tuple(inequalities(derivation, derivation.asked.get(line.item or ""), in_letters))
    for tree in dict.fromkeys(_differences_below(above.relation)):
        value = None if tree in left else in_letters_alone(tree)
        names = set() if value is None else {str(symbol) for symbol in value.free_symbols}
        if value is None or not names <= roles.keys():
            continue
        oracle = Oracle({name: roles[name] for name in names}, given)
        # What stands below a line is not zero.
        if oracle.proves(Claim(value, ">=")):
            yield Relation(((Link(tree, ">", _ZERO),),))


def cleared_factors(
    derivation: Derivation, line: Line, is_positive: Callable[[str], bool]
) -> Iterator[Relation]:
    """That factors with the letter which is sought are positive, where they are gone.

    They are the letter itself, and sums of positive numbers and letters.
    """
    (first, *rest) = line.premises or ("",)
    above = derivation.line(first)
    if line.move.id not in ("compare", "rearrange") or above is None:
        return
    if any(isinstance(ref, int) or line.move.id == "compare" for ref in rest):
        return
    match above.relation, line.relation:
        case Relation((before,)), Relation((after,)):
            if any(link.sign not in FLIPPED for link in (*before, *after)):
                return
        case _:
            return
    left = set(_factors_below(line.relation))
    kept = {name for tree in trees_of(line.relation) for name in letters(tree)}
    sought = {
        tree.name
        for end in derivation.items
        if end.item == line.item
        for tree in trees_of(end.answer)
        if isinstance(tree, Letter)
    }
    kept = kept & sought or kept
    for tree in dict.fromkeys(_factors_below(above.relation)):
        names = letters(tree)
        if tree in left or not names & kept or not all(map(is_positive, names)):
            continue
        if isinstance(tree, Letter) or _is_plain_sum(tree):
            yield Relation(((Link(tree, ">", _ZERO),),))


def _is_plain_sum(tree: Expression) -> bool:
    """Whether nothing is taken away in a sum."""
    match tree:
        case Binary("+" | "*", left, right):
            return _is_plain_sum(left) and _is_plain_sum(right)
        case Number(value):
            return value > 0
    return isinstance(tree, Letter)


def _factors_below(relation: Relation) -> Iterator[Expression]:
    """The factors below a line, of powers their bases."""
    for tree in trees_of(relation):
        for node in walk(tree):
            if is_binary(node, "/") and not has_quantity(node.right):
                for factor in factors(node.right):
                    match factor:
                        case Binary("^", base, Number()):
                            yield base
                        case _:
                            yield factor


def _differences_below(relation: Relation) -> Iterator[Expression]:
    """The factors below a line from which something is taken, in letters alone."""
    for tree in trees_of(relation):
        for node in walk(tree):
            if is_binary(node, "/") and not has_quantity(node.right):
                yield from (factor for factor in factors(node.right) if _is_difference(factor))


def _is_difference(tree: Expression) -> bool:
    plain = not any(isinstance(node, Apply) for node in walk(tree))
    return plain and is_binary(tree, "+", "-") and "-" in _signs(tree)


def _signs(tree: Expression) -> set[str]:
    return {node.op for node in walk(tree) if isinstance(node, Binary)}


__all__ = ["cleared_factors", "multipliers_of"]
