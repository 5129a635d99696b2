"""Two quotients that are equal, multiplied across: factors that both sides have are gone.

Where brackets are then multiplied out, what is common to both sides would not be seen to go.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.expression.tree import Apply, Binary, Expression, letters, walk
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import ONE, alike, factors, product, tree_of
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass


@dataclass(frozen=True)
class _Factor:
    """A factor of a side, and what it is worth."""

    tree: Expression
    value: sp.Expr


def multiplied_across(scene: Scene, line: int, symbol: sp.Symbol) -> int:
    """The line of two equal quotients without what is below, where brackets are left to multiply.

    The same line where no product of two sums would be left, of which one holds the unknown.
    """
    line = _above_one_root(scene, line)
    link = scene.desk.last_link(line)
    quotients = [_quotient(side) for side in (link.left, link.right)]
    if link.sign != "=" or not any(symbol.name in letters(below) for _, below in quotients):
        return line
    if any(map(_is_of_sines, (link.left, link.right))):
        return line
    (above, below), (over, under) = ([_factors(scene, tree) for tree in pair] for pair in quotients)
    above, over = _without_common(above, over)
    below, under = _without_common(below, under)
    left, right = [*above, *under], [*over, *below]
    if not any(_is_to_multiply(side, symbol) for side in (left, right)):
        return line
    numbers = _numbers(left, right)
    trees = [
        product(number, *(factor.tree for factor in side if factor.value.free_symbols))
        for number, side in zip(numbers, (left, right), strict=True)
    ]
    if alike(trees[0], link.left) and alike(trees[1], link.right):
        return line
    return in_another_form(scene, line, chain(trees[0], (trees[1], None))) or line


def _above_one_root(scene: Scene, line: int) -> int:
    """The line of two quotients over one root, without that; any other line as it is."""
    link = scene.desk.last_link(line)
    match link.left, link.right:
        case Binary("/", above, Apply("sqrt") as below), Binary("/", over, under) if (
            link.sign == "=" and under == below
        ):
            return in_another_form(scene, line, chain(above, (over, None))) or line
    return line


def _quotient(side: Expression) -> tuple[Expression, Expression]:
    """What stands above and below in a side."""
    match side:
        case Binary("/", above, below):
            return above, below
    return side, ONE


def _is_of_sines(tree: Expression) -> bool:
    """Whether sines, cosines or roots of letters stand in a side."""
    return any(
        isinstance(node, Apply) and node.function != "tan" and letters(node) for node in walk(tree)
    )


def _factors(scene: Scene, tree: Expression) -> list[_Factor]:
    return [
        _Factor(factor, sp.sympify(scene_value(scene, factor), strict=True))
        for factor in factors(tree)
    ]


def _without_common(
    one: Sequence[_Factor], other: Sequence[_Factor]
) -> tuple[list[_Factor], list[_Factor]]:
    """Two products without the factors that both have."""
    first, second = list(one), list(other)
    for factor in one:
        same = next((e for e in second if e.value.free_symbols and e.value == factor.value), None)
        if same is not None:
            first.remove(factor)
            second.remove(same)
    return first, second


def _is_to_multiply(side: Iterable[_Factor], symbol: sp.Symbol) -> bool:
    """Whether two sums are multiplied, of which one holds the unknown."""
    sums = [factor.value for factor in side if factor.value.is_Add]
    return len(sums) > 1 and any(symbol in addend.free_symbols for addend in sums)


def _numbers(left: Sequence[_Factor], right: Sequence[_Factor]) -> tuple[Expression, Expression]:
    """The numbers in front of both sides, without what they have in common."""
    values = [
        sp.Mul(*(factor.value for factor in side if not factor.value.free_symbols))
        for side in (left, right)
    ]
    ratio = tidy(values[0] / values[1])
    if not ratio.has(sp.Add):
        root, rest = sp.Mul(*(e for e in sp.Mul.make_args(ratio) if not e.is_Rational)), ratio
        rest = sp.sympify(tidy(ratio / root), strict=True)
        return tree_of(rest.p * root), tree_of(sp.Integer(rest.q))
    return tree_of(values[0], as_it_is=True), tree_of(values[1], as_it_is=True)


__all__ = ["multiplied_across"]
