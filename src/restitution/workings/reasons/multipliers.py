"""By what an inequality is multiplied, where it is not seen that it is positive: 4 − 3e > 0."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from restitution.explaining.lines.derivation import FLIPPED, Derivation, Line, Link, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Apply, Binary, Expression, Number, has_quantity, walk
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
    above = derivation.line(first) if isinstance(first, int) else None
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
    for each in dict.fromkeys(_differences_below(above.relation)):
        value = None if each in left else in_letters_alone(each)
        names = set() if value is None else {str(symbol) for symbol in value.free_symbols}
        if value is None or not names <= roles.keys():
            continue
        oracle = Oracle({name: roles[name] for name in names}, given)
        if oracle.proves(Claim(value, ">")):
            yield Relation(((Link(each, ">", _ZERO),),))


def _differences_below(relation: Relation) -> Iterator[Expression]:
    """The factors below a line from which something is taken, in letters alone."""
    for tree in trees_of(relation):
        for node in walk(tree):
            if isinstance(node, Binary) and node.op == "/" and not has_quantity(node.right):
                yield from (each for each in factors(node.right) if _is_difference(each))


def _is_difference(tree: Expression) -> bool:
    plain = not any(isinstance(node, Apply) for node in walk(tree))
    return plain and isinstance(tree, Binary) and tree.op in "+-" and "-" in _signs(tree)


def _signs(tree: Expression) -> set[str]:
    return {node.op for node in walk(tree) if isinstance(node, Binary)}


__all__ = ["multipliers_of"]
