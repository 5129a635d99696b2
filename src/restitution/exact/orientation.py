"""Signs of sums: (1 − e)² for (e − 1)², and (2 − k²)/(1 + k²) for (k² − 2)/(−1 − k²)."""

from __future__ import annotations

from typing import Any

import sympy
from sympy import Add, Expr, Mul, Pow, S

from restitution.exact.nodes import rebuilt
from restitution.exact.simplicity import TRIGONOMETRIC


def forward(total: Expr) -> Expr:
    """A sum or the same with the other sign: few minuses, and the term with the least e first."""
    minuses = sum(term.could_extract_minus_sign() for term in total.args)
    if 2 * minuses != len(total.args):
        return -total if 2 * minuses > len(total.args) else total
    coefficients = {x for x in total.free_symbols if x.is_nonnegative and not x.is_positive}
    if not coefficients and not total.has(*TRIGONOMETRIC):
        return total

    def order(term: Expr) -> tuple[Any, ...]:
        powers = term.as_powers_dict()
        return sum(powers[x] for x in coefficients if x in powers), sympy.default_sort_key(
            -term if term.could_extract_minus_sign() else term
        )

    return -total if min(total.args, key=order).could_extract_minus_sign() else total


def is_turned_square(value: Expr) -> bool:
    """Whether the sum of which an expression is an even power reads better turned round."""
    return (
        isinstance(value, Pow)
        and bool(value.exp.is_even)
        and isinstance(value.base, Add)
        and forward(value.base) != value.base
    )


def square_forward(value: Expr) -> Expr:
    """(1 − e)² for (e − 1)²."""
    return Pow(forward(value.base), value.exp)


def stands_over_its_root(value: Expr) -> bool:
    """Whether the root of a sum stands above its negative: √(k² − 1)/(1 − k²)."""
    return _root_and_below(value) is not None


def over_its_root(value: Expr) -> Expr:
    """−1/√(k² − 1) for √(k² − 1)/(1 − k²)."""
    pair = _root_and_below(value)
    if pair is None:
        return value
    return _put(value, {pair[0]: 1 / pair[0], pair[1]: S.NegativeOne})


def _root_and_below(value: Expr) -> tuple[Expr, Expr] | None:
    if not isinstance(value, Mul):
        return None
    below = {factor.base: factor for factor in value.args if factor.is_Pow and factor.exp == -1}
    for root in value.args:
        base, power = root.as_base_exp()
        if power == S.Half and base.is_Add and -base in below:
            return root, below[-base]
    return None


def has_minuses_below(value: Expr) -> bool:
    """Whether a sum of negative terms stands below a line and a sum above it."""
    return _sums_of_a_fraction(value) is not None


def without_minuses_below(value: Expr) -> Expr:
    """(2 − k²)/(1 + k²) for (k² − 2)/(−1 − k²)."""
    pair = _sums_of_a_fraction(value)
    if pair is None:
        return value
    above, below = pair
    return _put(value, {above: -above, below: 1 / -below.base})


def _sums_of_a_fraction(value: Expr) -> tuple[Expr, Expr] | None:
    if not isinstance(value, Mul):
        return None
    above = [factor for factor in value.args if isinstance(factor, Add)]
    for below in value.args if above else ():
        if (
            isinstance(below, Pow)
            and below.exp == -1
            and isinstance(below.base, Add)
            and all(term.could_extract_minus_sign() for term in below.base.args)
        ):
            return above[0], below
    return None


def _put(product: Expr, put: dict[Expr, Expr]) -> Expr:
    return rebuilt(product, [put.get(factor, factor) for factor in product.args])


__all__ = [
    "forward",
    "has_minuses_below",
    "is_turned_square",
    "over_its_root",
    "square_forward",
    "stands_over_its_root",
    "without_minuses_below",
]
