"""An inequality between two fractions, before it is solved: each side multiplied out by itself."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.explaining.lines.derivation import Link, Move, Relation, Sign
from restitution.planning.closing.square_roots import side_by_side
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import cancelled, one_fraction

_MOVES = (Move("rearrange"), Move("cancel"), Move("compare"))


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


def _sums_below(value: sp.Expr) -> bool:
    """Whether a sum with letters stands below the line of a fraction."""
    below = sp.fraction(one_fraction(value))[1]
    return any(
        node.as_base_exp()[0].is_Add and node.free_symbols for node in sp.Mul.make_args(below)
    )


__all__ = ["multiplied_out"]
