"""An end of an angle as an inverse of the ratio that equations have: ``arccos(√6/4)``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Apply, Expression, Letter, walk
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import Scene

_RATIOS = {"cos": sp.cos, "sin": sp.sin}


def inverse_by_lines(
    scene: Scene, lines: Iterable[int], angle: Letter, value: sp.Expr
) -> Expression | None:
    """A value of an angle by its cosine, or its sine, where lines have no other ratio of it.

    None for a number of degrees, which is plainer.
    """
    nodes = (
        node for line in lines for e in trees_of(scene.desk.relation(line)) for node in walk(e)
    )
    applied = (node for node in nodes if isinstance(node, Apply) and node.argument == angle)
    ratios = {node.function for node in applied}
    if len(ratios) != 1 or not ratios <= _RATIOS.keys() or sp.deg(value).is_Rational:
        return None
    (ratio,) = ratios
    return Apply(f"arc{ratio}", tree_of(tidy(_RATIOS[ratio](value))))


def bounds_of_the_ratio(link: Link, angle: Expression) -> Iterator[Relation]:
    """``sin δ ≤ 3/13`` of δ ≤ arcsin(3/13); nothing of another bound of an acute angle."""
    match link.right:
        case Apply("arcsin", ratio):
            yield Relation(((Link(Apply("sin", angle), link.sign, ratio),),))
        case Apply("arccos", ratio):
            yield Relation(((Link(Apply("cos", angle), FLIPPED[link.sign], ratio),),))


__all__ = ["bounds_of_the_ratio", "inverse_by_lines"]
