"""A linear inequality with sums of roots: its terms are collected before it is divided."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Relation, Sign
from restitution.expression.tree import Apply, Binary, Letter
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import product, tree_of
from restitution.planning.writing.inequalities import linear_in
from restitution.planning.writing.polynomials import expanded

_MOVES = (Move("rearrange"), Move("cancel"))


def collected(worths: Worths, line: int, sign: Sign, x: sp.Expr, solved: Link) -> int:
    """``x sign 0`` as ``(3 + √3)e ≤ 3√3 − 3``, and then as a quotient.

    The line itself where the unknown is multiplied by no sum of roots.
    """
    match solved.left:
        case Letter(name):
            angle = False
        case Apply(_, Letter(name)):
            angle = True
        case _:
            return line
    symbols = [symbol for symbol in x.free_symbols if symbol.name == name]
    form = linear_in(x, symbols[0], angle) if len(x.free_symbols) == len(symbols) == 1 else None
    if form is None or form[0] != solved.left or not form[2].is_Add:
        return line
    factor, rest = expanded(form[2]), expanded(-form[3])
    if worths.scene.model.sign(factor) < 0:
        factor, rest, sign = -factor, -rest, FLIPPED[sign]
    above, below = tree_of(rest, as_it_is=True), tree_of(factor, as_it_is=True)
    known = worths.known_in(x)
    for link in (
        Link(product(below, solved.left), sign, above),
        Link(solved.left, sign, Binary("/", above, below)),
    ):
        after = worths.judge.write(_MOVES, [line, *known], Relation(((link,),)))
        line = line if after is None else after
    return line


__all__ = ["collected"]
