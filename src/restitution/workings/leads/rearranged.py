"""The words before a line that only rearranges the one above: by which step it does."""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Number,
    is_binary,
    letters,
    walk,
)
from restitution.planning.writing.forms import factors_above
from restitution.workings.naming.quantities import Naming

_TWO = Fraction(2)


def step_of(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """The difference of two squares, the factor of both sides that goes, or a ratio by another."""
    above = derivation.lines_in(line.premises)
    match line.move.id, above, line.relation:
        case "rearrange", [Line(relation=Relation((links,))) as own], Relation((after,)):
            pass
        case _:
            return None
    before, after_ = links[-1], after[0]
    if before.sign != "=" or after_.sign != "=" or len(after) > 1:
        return None
    if own.move.id == "fact" and _is_ratio_by_another(before, after_):
        return say("so")
    if _is_factorized(before, after_):
        return say("derived.two-squares")
    gone = _divided_out(links[0].left, before.right, line.relation)
    return None if gone is None else say("derived.divided-by", factor=naming.layout(gone))


def _is_ratio_by_another(before: Link, after: Link) -> bool:
    """Whether a ratio of an angle is said for another one of it."""
    match before.left, after.left:
        case Apply(one, angle), Apply(other, same):
            return one != other and angle == same
    return False


def _is_factorized(before: Link, after: Link) -> bool:
    """Whether the squares of two sums are subtracted, and then a product in their place."""
    match before.left, after.left:
        case Binary("-", Binary("^", one, power), Binary("^", other, same)), product:
            squares = power == same == Number(_TWO)
            return squares and all(map(_is_sum, (one, other))) and is_binary(product, "*")
    return False


def _divided_out(left: Expression, right: Expression, after: Relation) -> Expression | None:
    """The sum in letters that is a factor of both sides, and does not stand in what follows."""
    rest = {node for tree in trees_of(after) for node in walk(tree)}
    common = [own for own in _factors(left) if own in _factors(right)]
    return next((own for own in common if own not in rest), None)


def _factors(tree: Expression) -> list[Expression]:
    """The sums with letters among the factors of an expression, but for those below a line."""
    return [own for own in factors_above(tree) if _is_sum(own) and letters(own)]


def _is_sum(tree: Expression) -> bool:
    return is_binary(tree, "+", "-")


__all__ = ["step_of"]
