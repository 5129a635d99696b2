"""Two quantities of which lines say the values, compared by the difference of these."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Move, Relation
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import Binary, Quantity
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.inequalities.comparing import Comparing
from restitution.planning.inequalities.gaps import has_root
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import swept, tree_of
from restitution.planning.writing.polynomials import cancelled, factored


def write_difference_of_two(
    claims: Comparing, lines: Sequence[int], relation: Relation
) -> int | None:
    """Which of two quantities is the greater, by their difference in factors: (1 − e)²u/4.

    None of another inequality, of values that are roots or multiples of each other, and where no
    sign is seen in the difference.
    """
    if len(lines) != 2 or len(relation.options) > 1 or len(relation.only) > 1:
        return None
    (link,) = relation.only
    if link.sign not in FLIPPED:
        return None
    subjects = [claims.scene.desk.last_link(line) for line in lines]
    if {link.left, link.right} != {own.left for own in subjects}:
        return None
    pair = subjects if subjects[0].left == link.left else subjects[::-1]
    if not all(isinstance(own.left, Quantity) and own.left.kind not in ANGLES for own in pair):
        return None
    if link.sign[0] == "<":
        pair = pair[::-1]
    greater, less = (scene_value(claims.scene, own.right) for own in pair)
    if has_root(greater) or has_root(less) or not (greater and less):
        return None
    if cancelled(greater / less).is_number:
        return None
    put = swept(Binary("-", tree_of(greater), tree_of(less)))
    value = tidy(factored(greater - less))
    if not all(_is_seen(claims, factor) for factor in sp.Mul.make_args(value)):
        return None
    end = tree_of(value)
    difference = chain(Binary("-", pair[0].left, pair[1].left), (put, None), (end, "rearrange"))
    mark = claims.worths.mark()
    line = claims.judge.write((Move("combine"),), lines, difference)
    line = line or claims.judge.write((Move("combine"),), lines[::-1], difference)
    last = None if line is None else claims.compared([line], relation)
    if last is None:
        claims.worths.back(mark)
    return last


def _is_seen(claims: Comparing, factor: sp.Expr) -> bool:
    """Whether the sign of a factor is seen: a square, no sum, 1 ± e, or a sum without a minus."""
    base, power = factor.as_base_exp()
    if not base.is_Add or (power.is_Integer and power % 2 == 0):
        return True
    names = [symbol.name for symbol in base.free_symbols]
    if len(names) == 1 and claims.coefficients(names) and base.is_polynomial():
        return bool(sp.degree(base) == 1)
    return not any(term.could_extract_minus_sign() for term in sp.Add.make_args(sp.expand(base)))


__all__ = ["write_difference_of_two"]
