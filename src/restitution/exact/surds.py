"""Numbers made of rationals and square roots of rationals, as sums without roots below a bar.

Such a number is a sum of rational multiples of √d, with d whole, positive and free of squares:
``{1: a, 3: b}`` is a + b√3. Sums and products keep that form. A quotient is multiplied by
conjugates, which change the sign of the roots of one prime at a time, until its denominator is
rational. SymPy's ``radsimp`` does the same for any expression, at a hundred times the cost.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from math import gcd, isqrt, prod
from typing import Any

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, S

Surds = Mapping[int, Fraction]

_MOST_BELOW = 4  # terms below a bar, as for radsimp: the conjugates of more are too long to print
_MOST_POWER = 8
_LARGEST = 10**6  # what stands under a root, where its primes are seen at once


class _NotQuadraticError(ValueError):
    """A number has another form, or one that is better left alone."""


def rationalised(value: Expr) -> Expr | None:
    """A number as an expanded sum of surds without roots in denominators; None for other numbers.

    Those are numbers with roots under roots or of another kind than square, with functions, with
    more than four terms below a bar, or with roots of numbers above a million.
    """
    try:
        return _expression(_surds(value))
    except _NotQuadraticError:
        return None


def root_is_nested(value: Expr) -> bool:
    """Whether the root of a + b√d, a and b rational, has no form without a root under a root.

    It is ±(√p ± √q) with rational p and q if and only if a² − b²d is the square of a rational
    number. False is no proof of the contrary: numbers with other terms are not judged.
    """
    try:
        number = _surds(value)
    except _NotQuadraticError:
        return False
    if len(number) != 2 or 1 not in number:
        return False
    a, b, d = number[1], number[max(number)], max(number)
    square = a * a - b * b * d
    return square < 0 or any(isqrt(x) ** 2 != x for x in (square.numerator, square.denominator))


def worked_out(value: Expr, number: Callable[[Fraction], Any], root: Callable[[Any], Any]) -> Any:
    """A number made of rationals and square roots, in another arithmetic.

    ``number`` makes a rational there, and ``root`` a square root. Raises TypeError for any other
    number.
    """
    if value.is_Rational:
        return number(Fraction(int(value.p), int(value.q)))
    if value.is_Add or value.is_Mul:
        first, *others = (worked_out(part, number, root) for part in value.args)
        for other in others:
            first = first + other if value.is_Add else first * other
        return first
    if not (value.is_Pow and value.exp.is_Rational):
        raise TypeError(value)
    base, index = worked_out(value.base, number, root), int(value.exp.q)
    while index % 2 == 0:
        base, index = root(base), index // 2
    if index != 1:
        raise TypeError(value)
    power = prod([base] * abs(int(value.exp.p)), start=number(Fraction(1)))
    return power if value.exp.p > 0 else number(Fraction(1)) / power


def _surds(value: Expr) -> Surds:
    if isinstance(value, Rational):
        return {1: Fraction(int(value.p), int(value.q))} if value else {}
    if isinstance(value, Add):
        return _sum([_surds(term) for term in value.args])
    if isinstance(value, Mul):
        return _product([_surds(factor) for factor in value.args])
    if isinstance(value, Pow) and isinstance(value.exp, Rational):
        return _power(value.base, value.exp)
    raise _NotQuadraticError


def _sum(terms: list[Surds]) -> Surds:
    total: dict[int, Fraction] = {}
    for term in terms:
        for root, number in term.items():
            total[root] = total.get(root, Fraction(0)) + number
    return {root: number for root, number in total.items() if number}


def _product(factors: list[Surds]) -> Surds:
    result: Surds = {1: Fraction(1)}
    for factor in factors:
        result = _times(result, factor)
    return result


def _times(left: Surds, right: Surds) -> Surds:
    total: dict[int, Fraction] = {}
    for a, x in left.items():
        for b, y in right.items():
            common = gcd(a, b)
            root = a // common * (b // common)
            total[root] = total.get(root, Fraction(0)) + x * y * common
    return {root: number for root, number in total.items() if number}


def _power(base: Expr, exponent: Rational) -> Surds:
    if abs(exponent.p) > _MOST_POWER:
        raise _NotQuadraticError
    if exponent.q == 1:
        number = _surds(base)
        whole = _product([number] * abs(int(exponent.p)))
        return whole if exponent.p > 0 else _inverse(whole)
    if exponent.q != 2 or not isinstance(base, Rational) or not base.is_positive:
        raise _NotQuadraticError
    root = _root(base)
    return _product([root if exponent.p > 0 else _inverse(root)] * abs(int(exponent.p)))


def _root(number: Rational) -> Surds:
    """√(p/q) = √(pq)/q, with the squares in pq taken out."""
    inside = int(number.p * number.q)
    if inside > _LARGEST:
        raise _NotQuadraticError
    outside, free = 1, 1
    for prime, times in sympy.factorint(inside).items():
        outside *= int(prime) ** (times // 2)
        free *= int(prime) ** (times % 2)
    return {free: Fraction(outside, int(number.q))}


def _inverse(number: Surds) -> Surds:
    if not number or len(number) > _MOST_BELOW:
        raise _NotQuadraticError
    above: Surds = {1: Fraction(1)}
    while set(number) != {1}:
        # A prime that divides a root: its conjugate removes that prime from all roots.
        prime = min(sympy.primefactors(max(number)))
        conjugate = {root: -x if root % prime == 0 else x for root, x in number.items()}
        above, number = _times(above, conjugate), _times(number, conjugate)
    return {root: x / number[1] for root, x in above.items()}


def _expression(number: Surds) -> Expr:
    terms = [
        Rational(x.numerator, x.denominator) * (S.One if root == 1 else sympy.sqrt(Integer(root)))
        for root, x in number.items()
    ]
    return Add(*terms)
