"""Squares of the sine and of the cosine of an angle, a term of each on a side of a line."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.exact.symbols import atoms_in, symbol_names
from restitution.explaining.lines.derivation import Link, Move, Relation, Sign
from restitution.expression.tree import letters
from restitution.planning.formulas.impacts import residual
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import cancelled, expanded, numerator
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene

_RATIOS = (sp.sin, sp.cos, sp.tan)
_SQUARED = 2


def with_squares_apart(scene: Scene, line: int, symbol: sp.Symbol) -> int:
    """The line ``e sin²α = cos²α``, where an unknown is a quotient of squares; or the line."""
    above = numerator(residual(scene, line))
    link = squares_apart(above, "=")
    if link is None or sum(term.has(symbol) for term in sp.Add.make_args(expanded(above))) != 1:
        return line
    if symbol.name in letters(link.right):
        link = Link(link.right, "=", link.left)
    relation = Relation(((link,),))
    if scene.desk.relation(line) == relation:
        return line
    known = background(scene, symbol_names(above))
    refs = scene.judge.enough(Move("rearrange"), (line,), relation, known)
    return line if refs is None else scene.desk.write(Move("rearrange"), refs, relation)


def squares_apart(above: sp.Expr, sign: Sign) -> Link | None:
    """What is compared with zero, with the square of each ratio on a side; None of another sum."""
    terms = sp.Add.make_args(expanded(above))
    if (
        len(terms) != 2
        or terms[0].could_extract_minus_sign() == terms[1].could_extract_minus_sign()
    ):
        return None
    more, less = terms[::-1] if terms[0].could_extract_minus_sign() else terms
    sides = sp.fraction(cancelled(-more / less))
    squares = [_single_square(side) for side in sides]
    if None in squares or squares[0] == squares[1]:
        return None
    return Link(tree_of(sides[0]), sign, tree_of(sides[1]))


def _single_square(side: sp.Expr) -> Any:
    """The kind of the one ratio of an angle in a product, where that is squared; or None."""
    ratios = atoms_in(side, *_RATIOS)
    if len(ratios) != 1 or side.is_Add:
        return None
    (own,) = ratios
    return own.func if sp.degree(side, own) == _SQUARED and own.args[0].is_Symbol else None


__all__ = ["squares_apart", "with_squares_apart"]
