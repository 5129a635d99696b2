"""An inequality between two fractions, before it is solved: each side multiplied out by itself."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.explaining.lines.derivation import Link, Move, Relation, Sign
from restitution.planning.closing.square_roots import side_by_side
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import cancelled, expanded, factored, one_fraction

_MOVES = (Move("rearrange"), Move("cancel"), Move("compare"))
# With more terms a line is no help.
_MOST_TERMS = 8


def multiplied_out(
    worths: Worths, line: int, sign: Sign, values: Sequence[sp.Expr], solved: Link
) -> int:
    """A line without the sums below both sides: ``4(2k − 1) ≤ 3k``, as 1 + k > 0.

    The line itself where there is no such sum, of a certain sign, below both, or where nothing is
    left to be solved.
    """
    if any(not _sums_below(value) for value in values):
        return line
    one, other = side_by_side(*values)
    multiplier = cancelled(one / values[0]) if values[0] != 0 else sp.S.Zero
    if proved_sign(worths.scene.model.inside, multiplier) != 1:
        return line
    sides = [tree_of(sp.factor_terms(side)) for side in (one, other)]
    link = Link(sides[0], sign, sides[1])
    if link.left == solved.left:
        return line
    known = worths.known_in(sp.Add(*values))
    return worths.judge.write(_MOVES, [line, *known], Relation(((link,),))) or line


def sides_expanded(worths: Worths, line: int) -> int:
    """``5 − 10e > 2 − e − 3e²``: both sides without brackets, before like terms are collected.

    The line itself where no side has a product of sums, or a side is one term: then nothing is to
    be collected.
    """
    own = worths.scene.desk.last_link(line)
    values = [worths.value(side) for side in (own.left, own.right)]
    if any(value.atoms(sp.sin, sp.cos) or not value.free_symbols for value in values):
        return line
    factors = [sp.Mul.make_args(side) for side in map(factored, side_by_side(*values))]
    sides = [expanded(sp.Mul(*side)) for side in factors]
    multiplier = cancelled(sides[0] / values[0])
    if (
        not any(map(_has_product_of_sums, factors))
        or not all(side.is_Add for side in sides)
        or any(power.exp.q > 1 for side in sides for power in side.atoms(sp.Pow))
        or sum(len(side.args) for side in sides) > _MOST_TERMS
        or proved_sign(worths.scene.model.inside, multiplier) != 1
    ):
        return line
    one, other = (tree_of(side, as_it_is=True) for side in sides)
    known = worths.known_in(sp.Add(*values))
    relation = Relation(((Link(one, own.sign, other),),))
    return worths.judge.write(_MOVES, [line, *known], relation) or line


def _has_product_of_sums(factors: Sequence[sp.Expr]) -> bool:
    """Whether among the factors of a side two are sums, or one is the square of a sum."""
    sums = [factor.as_base_exp() for factor in factors]
    return sum(int(power) for base, power in sums if base.is_Add and power.is_Integer) > 1


def _sums_below(value: sp.Expr) -> bool:
    """Whether a sum with letters stands below the line of a fraction."""
    below = sp.fraction(one_fraction(value))[1]
    return any(
        node.as_base_exp()[0].is_Add and node.free_symbols for node in sp.Mul.make_args(below)
    )


__all__ = ["multiplied_out", "sides_expanded"]
