"""Every line of a worked solution is checked before it is printed: by numbers, then by proof."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

import sympy as sp

from restitution.components import Model
from restitution.explain.steps import Row
from restitution.expression.enclosed import UndefinedError
from restitution.oracle import Relation, holds_at

_TOLERANCE = Fraction(1, 10**18)
_ORDERED = {"<": operator.lt, "≤": operator.le, ">": operator.gt, "≥": operator.ge}


def holds(row: Row, number: Callable[[Any], Any]) -> bool:
    """Whether a line is true by the numbers of its operands.

    Operands without a value (rounded ones, words) are not asked. An operand that has no number
    makes the line fail.
    """
    try:
        return all(_related(*each, number) for each in related(row))
    except (UndefinedError, KeyError, TypeError, ValueError, ArithmeticError):
        return False


def refuted(row: Row, model: Model) -> bool:
    """Whether a line, true at the sample, fails for other letters that the solution admits."""
    return any(
        model.differ(left, right)
        if sign == "="
        else model.decide(left, sign, right).answer == "refuted"
        for one, sign, other in related(row)
        for left, right in _parts(one, other)
        if sp.sympify(left, strict=True) != sp.sympify(right, strict=True)
    )


def related(row: Row) -> Iterator[tuple[Any, str, Any]]:
    """The operands of a line that have values, in pairs, with the sign between them."""
    known = [(value, index) for index, value in enumerate(row.values) if value is not None]
    for (left, i), (right, k) in pairwise(known):
        if all(sign in ("=", *_ORDERED, "≠") for sign in row.signs[i:k]):
            yield left, next((s for s in row.signs[i:k] if s != "="), "="), right


def _parts(one: Any, other: Any) -> list[tuple[Any, Any]]:
    if isinstance(one, tuple):
        return list(zip(one, other, strict=True))
    return [(one, other)]


def _related(left: Any, sign: str, right: Any, number: Callable[[Any], Any]) -> bool:
    if isinstance(left, tuple) != isinstance(right, tuple):
        return False
    for one, other in _parts(left, right):
        a, b = number(one), number(other)
        close = abs(a - b) <= _TOLERANCE * (abs(a) + abs(b))
        if sign == "=" and not close:
            return False
        if sign == "≠" and close:
            return False
        if sign in _ORDERED:
            if close:
                if sign in "<>" and not _in_order(one, sign, other):
                    return False
            elif not _ORDERED[sign](a, b):
                return False
    return True


def _in_order(one: Any, sign: str, other: Any) -> bool:
    """Whether two constants too near for the digits of a sample stand in this order."""
    gap = sp.sympify(other, strict=True) - sp.sympify(one, strict=True)
    if gap.free_symbols:
        return False
    return holds_at(Relation(gap if sign == "<" else -gap, ">"), {}) is True
