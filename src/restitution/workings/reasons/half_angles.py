"""What it says of an angle that twice it is acute."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from restitution.explaining.lines.derivation import Link, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Apply, Binary, Expression, Number, is_zero, walk

_TWO = Number(Fraction(2))


def half_of_an_acute(
    bound: Relation, cited: Sequence[Relation]
) -> tuple[Relation, Expression] | None:
    """That a tangent is less than 1, where the cosine of twice its angle is positive; that angle.

    None where the double angle stands in what is cited beside that, or the tangent does not.
    """
    match bound.options:
        case ((Link(Apply("cos", Binary("*", two, angle) as double), ">", zero),),) if (
            two == _TWO and is_zero(zero)
        ):
            tangent = Apply("tan", angle)
        case _:
            return None
    others = [own for own in cited if own != bound]
    nodes = {node for own in others for tree in trees_of(own) for node in walk(tree)}
    if tangent not in nodes or double in nodes:
        return None
    return Relation(((Link(tangent, "<", Number(Fraction(1))),),)), double


__all__ = ["half_of_an_acute"]
