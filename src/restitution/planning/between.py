"""What stands between a definition with values put in and what that comes to.

A step multiplies squares out, or puts terms over one denominator, or puts them together in
factors: a line that did it all at once would not be followed by a reader. So where several squares
of sums are worked out, the terms come first, with what they have in common in front.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Negate,
    Number,
    has_quantity,
    letters,
    walk,
)
from restitution.planning.forms import factors, product, total, tree_of
from restitution.planning.scene import Scene

# So many squares of sums are worked out in one step.
_AT_ONCE = 1
# Longer brackets are no help to a reader.
_LONGEST = 48


def terms_between(scene: Scene, right: Expression, final: Expression) -> Expression | None:
    """The terms of a definition, their squares worked out or over one denominator.

    None where the way from the definition to its value is one step.
    """
    match right, final:
        case Apply("sqrt", inside), Apply("sqrt", value):
            own = terms_between(scene, inside, value)
            return None if own is None else Apply("sqrt", own)
    if _squares_of_sums(right) - _squares_of_sums(final) <= _AT_ONCE or has_quantity(right):
        return None
    try:
        tree = _in_terms(sp.sympify(scene.scalar(right), strict=True))
    except (RestitutionError, TypeError, ValueError, sp.PolynomialError):
        return None
    if tree is None or tree == final or sum(1 for _ in walk(tree)) > _LONGEST:
        return None
    return tree


def _squares_of_sums(tree: Expression) -> int:
    """How many squares there are of what has a sum with letters in it."""
    return sum(
        isinstance(node, Binary)
        and node.op == "^"
        and node.right == Number(Fraction(2))
        and any(_is_sum(each) for each in walk(node.left))
        for node in walk(tree)
    )


def _is_sum(tree: Expression) -> bool:
    return isinstance(tree, Binary) and tree.op in ("+", "-") and bool(letters(tree))


def _in_terms(value: sp.Expr) -> Expression | None:
    """The common factor of all terms, and in brackets what is left of them."""
    terms = sp.Add.make_args(sp.expand_mul(value))
    if len(terms) < 2:
        return None
    fractions = [sp.fraction(each) for each in terms]
    below = sp.factor(sp.lcm_list([sp.expand(each) for _, each in fractions]))
    above = [top * sp.factor(sp.cancel(below / bottom)) for top, bottom in fractions]
    above.sort(key=lambda each: bool(each.as_coeff_Mul()[0].is_negative))
    common = sp.factor(sp.gcd_list([sp.expand(each) for each in above]))
    factor = sp.Mul(*(each for each in sp.Mul.make_args(common) if not _has_sum(each)))
    rest = [each / factor for each in above]
    if not below.free_symbols:
        rest = [part for each in rest for part in _parts(each)]
    numbers = [sp.Rational(each.as_coeff_Mul()[0]).q for each in rest]
    shared = sp.ilcm(1, *numbers)
    below, inside = below * shared, total(_term(each * shared) for each in rest)
    number, letters_ = factor.as_coeff_Mul()
    front = list(factors(tree_of(letters_)))
    ratios = [each for each in front if any(isinstance(node, Apply) for node in walk(each))]
    outside = [each for each in front if each not in ratios]
    if not below.free_symbols and letters_ != 1:
        return product(tree_of(number / below), *outside, inside, *ratios)
    whole = product(tree_of(number), *outside, inside, *ratios)
    return whole if below == 1 else Binary("/", whole, tree_of(below))


def _has_sum(factor: sp.Expr) -> bool:
    return bool(factor.as_base_exp()[0].is_Add)


def _parts(value: sp.Expr) -> Iterable[sp.Expr]:
    """The terms of a product of sums, those of the lowest degree first."""

    def degree(term: sp.Expr) -> tuple[int, object]:
        powers = term.as_powers_dict()
        return sum(int(powers[s]) for s in term.free_symbols), sp.default_sort_key(term)

    return sorted(sp.Add.make_args(sp.expand(value)), key=degree)


def _term(value: sp.Expr) -> Expression:
    number, rest = value.as_coeff_Mul()
    tree = tree_of(abs(number) * rest, as_it_is=True)
    return Negate(tree) if number < 0 else tree


__all__ = ["terms_between"]
